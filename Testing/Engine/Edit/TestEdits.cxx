// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Edits that random ones rarely are: each is what a run from nothing gives, too.
#include "Testing/Engine/Calls/Bits.h"
#include "Testing/Engine/Edit/MirroredEdits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

const Cloud square = { { 0, 0, 0 }, { 8, 0, 0 }, { 8, 8, 0 }, { 0, 8, 0 } };

Cloud with(Cloud cloud, const Cloud& more)
{
  cloud.insert(cloud.end(), more.begin(), more.end());
  return cloud;
}

/// Of points at one position the lowest id is the vertex, or the highest weight; all others hang
/// there, in one list.
TEST(Edits, PointsAtOnePositionGoInAnyOrder)
{
  for (const bool isWeighted : { false, true })
  {
    for (std::size_t removed = 1; removed <= 5; ++removed)
    {
      std::vector<std::int64_t> order = { 4, 5, 6, 7, 8 };
      do
      {
        SCOPED_TRACE(bitsOf(order));
        MirroredEdits edits(isWeighted);
        edits.begin(with(square,
          { { 3, 2, 1 }, { 3, 2, 1 }, { 3, 2, 1 }, { 3, 2, isWeighted ? 2.0 : 1.0 },
            { 3, 2, 1 } }));
        for (std::size_t i = 0; i < removed; ++i)
        {
          edits.remove({ order[i] });
        }
        // At the end of the list; each appears in its turn.
        edits.insert({ { 3, 2, 1 }, { 3, 2, 1 } });
        edits.check();
        while (edits.present.size() > square.size())
        {
          edits.remove({ edits.present[square.size()] });
          edits.check();
        }
        if (testing::Test::HasFailure())
        {
          return;
        }
      } while (std::next_permutation(order.begin(), order.end()));
    }
  }
}

/// They may only lose the point that they meet at if another comes there.
TEST(Edits, PointWhereConstraintsMeet)
{
  MirroredEdits edits;
  edits.begin(with(square, { { 4, 4, 0 }, { 1, 3, 0 }, { 6, 3, 0 } }));
  edits.insertConstraints({ 0, 2, 1, 3 });
  edits.check();
  const auto expectRefused = [&](const auto& edit)
  {
    const auto before = bitsOf(edits.edited.snapshot());
    try
    {
      edit();
      ADD_FAILURE();
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.code(), ErrorCode::ConstraintsCross);
      EXPECT_EQ(error.index(), -1);
      EXPECT_TRUE(error.count() == 0 || error.count() == 1);
    }
    EXPECT_EQ(bitsOf(edits.edited.snapshot()), before);
  };
  expectRefused([&] { edits.edited.remove(4); });
  expectRefused([&] { edits.edited.move(4, 1, 1.5); });
  edits.move({ 4, 5 }, { { 1, 1.5, 0 }, { 4, 4, 0 } });
  edits.check();
  edits.insert({ { 4, 4, 0 } });
  edits.remove({ 5 });
  edits.check();
}

/// Edges have the count of the constraints along them, also when they are joined.
TEST(Edits, ConstraintsAlongEachOther)
{
  MirroredEdits edits;
  edits.begin(with(square, { { 2, 4, 0 }, { 4, 4, 0 }, { 6, 4, 0 }, { 4, 5, 0 }, { 4, 3, 0 } }));
  edits.insertConstraints({ 4, 6, 6, 4, 4, 6, 4, 5 });
  edits.removeConstraint(3);
  edits.remove({ 5 });
  edits.check();
  for (const std::int64_t number : { 1, 0, 2 })
  {
    edits.removeConstraint(number);
    edits.check();
  }
}

/// One by one, and so many that all is made again.
TEST(Edits, PointsThatDivideConstraints)
{
  for (const int count : { 1, 5, 200 })
  {
    SCOPED_TRACE(count);
    MirroredEdits edits;
    edits.begin(square);
    edits.insertConstraints({ 0, 2 });
    Cloud cloud;
    for (int i = 0; i < count; ++i)
    {
      const double x = i % 2 ? i * 0.03125 : 8 * (i + 1) / double(count + 1);
      cloud.push_back({ x, i % 3 ? x : 8 - x, 0 });
    }
    cloud.push_back({ 1.5, 1.5, 0 });
    cloud.push_back({ 1.5, 1.5, 0 });
    edits.insert(cloud);
    EXPECT_GE(edits.edited.dividedEdges(), 1);
    edits.check();
    edits.move({ 5 }, { { 0, 0, 0 } });
    EXPECT_EQ(edits.edited.dividedEdges(), 0);
    edits.check();
    edits.move({ 1 }, { { 8, 8, 0 } });
    EXPECT_EQ(edits.edited.dividedEdges(), 0);
    edits.check();
    edits.move({ 1, 5 }, { { 8, 0, 0 }, { 7.75, 7.75, 0 } });
    EXPECT_EQ(edits.edited.dividedEdges(), 1);
    edits.check();
    std::vector<std::int64_t> all(edits.points.size() - 4);
    std::iota(all.begin(), all.end(), 4);
    Cloud to;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      to.push_back({ 0.25 + 0.03125 * double(i), 0.25 + 0.03125 * double(i % 4 ? i : 2 * i), 0 });
    }
    edits.move(all, to);
    edits.check();
    EXPECT_GE(edits.edited.dividedEdges(), 1);
    edits.remove({ 6 });
    EXPECT_EQ(edits.edited.dividedEdges(), 0);
  }
}

/// While there are no triangles, all that is known is the line.
TEST(Edits, PointsOnOneLine)
{
  std::vector<std::int64_t> order = { 0, 1, 2, 3 };
  do
  {
    for (const Point& next : Cloud{ { 9, 9, 0 }, { 3, 0, 0 }, { 4, 4, 0 } })
    {
      MirroredEdits edits;
      edits.begin({ { 3, 3, 0 }, { 1, 1, 0 } });
      edits.insert({ { 1, 1, 0 }, { -2, -2, 0 } });
      for (const std::int64_t id : order)
      {
        edits.remove({ id });
        edits.check();
      }
      edits.insert({ { 5, 5, 0 } });
      edits.insert({ next });
      edits.check();
      edits.insert({ { 5, 4, 0 } });
      edits.insert({ { 5, 7, 0 } });
      edits.check();
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Edits, NumbersThatNoConstraintHas)
{
  EditableTriangulation edited;
  edited.skipConstraintNumbers(3);
  EXPECT_EQ(edited.constraintNumberCount(), 3);
  EXPECT_EQ(edited.constraintCount(), 0);
  EXPECT_FALSE(edited.containsConstraint(2));
  const double x[] = { 0, 0, 1, 0, 0, 1 };
  edited.insert(PointView(x, 3, 2));
  const std::int64_t ends[] = { 0, 1 };
  EXPECT_EQ(edited.insertConstraints({ ends, 1 }), 3);
  EXPECT_THROW(edited.skipConstraintNumbers(-1), Error);
  EXPECT_THROW(edited.skipConstraintNumbers(std::int64_t(1) << 40), Error);
  edited.remove(2);
  EXPECT_THROW(edited.remove(0), Error);
  EXPECT_EQ(edited.constraintNumberCount(), 4);
}

}

}
}
