// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where memory runs out in an edit, at whichever request, all is as it was, and the edit can be
/// made again.
#include "Testing/Engine/Edit/EditHistory.h"

#include <cstdlib>
#include <new>

// The C library's own, which tests under sanitizers do without: these have theirs.
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define FLIPFLOP_FAILING_MEMORY

extern "C" void* __libc_malloc(std::size_t bytes);
extern "C" void* __libc_memalign(std::size_t alignment, std::size_t bytes);

namespace
{

thread_local long requestsLeft = -1; ///< until one fails; below 0: none does

bool fails()
{
  return requestsLeft >= 0 && requestsLeft-- == 0;
}

}

extern "C" void* malloc(std::size_t bytes)
{
  return fails() ? nullptr : __libc_malloc(bytes);
}

extern "C" int posix_memalign(void** memory, std::size_t alignment, std::size_t bytes)
{
  *memory = fails() ? nullptr : __libc_memalign(alignment, bytes);
  return *memory ? 0 : 12; // ENOMEM
}
#endif

namespace flipflop
{
namespace test
{

#if defined(FLIPFLOP_FAILING_MEMORY)
namespace
{

Bits bitsOfAll(const EditableTriangulation& edited)
{
  Bits bits = bitsOf(edited.snapshot()) + std::to_string(edited.idCount()) + " " +
    std::to_string(edited.pointCount()) + " " + std::to_string(edited.constraintCount()) + " " +
    std::to_string(edited.constraintNumberCount());
  for (std::int64_t id = 0; id < edited.idCount(); ++id)
  {
    double x[3] = { 0, 0, 0 };
    if (edited.contains(id))
    {
      edited.point(id, x);
    }
    bits += bitsOf(x, 3);
  }
  return bits;
}

/// Let each request for memory of an edit fail in turn, until it needs no more.
/// @return how many failed
template <class Edit>
int failAtEach(EditableTriangulation& edited, const Edit& edit)
{
  const Bits before = bitsOfAll(edited);
  for (int failed = 0;; ++failed)
  {
    requestsLeft = failed;
    try
    {
      edit();
      requestsLeft = -1;
      return failed;
    }
    catch (const Error& error)
    {
      requestsLeft = -1;
      EXPECT_EQ(error.code(), ErrorCode::OutOfMemory) << error.what();
    }
    EXPECT_TRUE(bitsOfAll(edited) == before);
    if (testing::Test::HasFailure())
    {
      return failed;
    }
  }
}

TEST(EditMemory, AnEditThatFailsChangesNothing)
{
  int failed = 0;
  Options one;
  one.threads = 1;
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    PointMaker make(seed);
    EditableTriangulation edited;
    for (int step = 0; step < 25 && !HasFailure(); ++step)
    {
      SCOPED_TRACE("step " + std::to_string(step));
      Random& random = make.random;
      Cloud fresh;
      for (int i = random.integer(0, 3) ? 1 : 70; i > 0; --i)
      {
        fresh.push_back(make());
      }
      const PointView points(fresh[0].data(), std::int64_t(fresh.size()));
      const WeightView weights =
        make.isWeighted() ? WeightView(fresh[0].data() + 2, points.count, 3) : WeightView();
      failed += failAtEach(edited, [&] { edited.insert(points, weights, one); });
      std::vector<std::int64_t> ids;
      for (std::int64_t id = 0; id < edited.idCount(); ++id)
      {
        if (edited.contains(id))
        {
          ids.push_back(id);
        }
      }
      random.shuffle(ids);
      const std::int64_t ends[] = { ids.front(), ids.back() };
      if (make.isConstrained() && edited.constraintCount() == 0)
      {
        failed += failAtEach(edited, [&] { edited.insertConstraints({ ends, 1 }, one); });
      }
      const Point to = make();
      failed += failAtEach(edited, [&] { edited.move(ids.front(), to[0], to[1]); });
      if (edited.constraintCount() > 0 && random.integer(0, 2) == 0)
      {
        const std::int64_t last = edited.constraintNumberCount() - 1;
        failed += failAtEach(edited, [&] { edited.removeConstraints(&last, 1, one); });
      }
      if (edited.constraintCount() == 0)
      {
        const auto some = static_cast<std::int64_t>(random.pick(ids.size()));
        failed += failAtEach(edited, [&] { edited.remove(ids.data(), some, one); });
      }
    }
  }
  EXPECT_GT(failed, 1000);
}

}
#endif

}
}
