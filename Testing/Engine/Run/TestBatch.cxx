// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A batch gives each set what a call of its own gives, bit for bit; and one at fault loses no
/// other.
#include "Support/Threads.h"
#include "Testing/Engine/Conformance/Kind.h"
#include "Testing/Engine/Conformance/ProgressWatch.h"
#include <flipflop/Batch.h>

#include <limits>

namespace flipflop
{
namespace test
{

namespace
{

/// Sets in one array, as a caller has them, and what lies before and behind them: floats, six to a
/// point, the weight last.
struct Sets
{
  std::vector<float> scalars;
  std::vector<std::int64_t> offsets;

  void append(const Cloud& cloud)
  {
    for (const Point& p : cloud)
    {
      const auto x = static_cast<float>(p[0]), y = static_cast<float>(p[1]);
      const auto z = static_cast<float>(p[2]);
      this->scalars.insert(this->scalars.end(), { x, y, z, -1, -1, z });
    }
  }
  void add(const Cloud& set)
  {
    if (this->offsets.empty())
    {
      this->offsets.push_back(this->count());
    }
    this->append(set);
    this->offsets.push_back(this->count());
  }

  std::int64_t count() const { return static_cast<std::int64_t>(this->scalars.size() / 6); }
  SetView view() const
  {
    SetView result;
    result.offsets = this->offsets.data();
    result.count = static_cast<std::int64_t>(this->offsets.size()) - 1;
    return result;
  }
  Views points(std::int64_t begin, std::int64_t end, bool weighted) const
  {
    const float* const first = this->scalars.data() + 6 * begin;
    return { PointView(first, end - begin, 6),
      weighted ? WeightView(first + 5, end - begin, 6) : WeightView() };
  }
};

/// Sets of all sizes: none, one, few, many; duplicates, flat ones, grids.
Sets mixedSets(const Kind& kind, const char* name)
{
  Sets sets;
  Random random(7);
  sets.append(integerGrid(2));
  sets.add({});
  for (const int count : { 1, 2, 3, 8, 0, 0, 5000, 8, 100, 20000, 1000, 4, 12 })
  {
    sets.add(kind.family(name, count, static_cast<std::uint64_t>(count)).make());
  }
  sets.add(repeated(kind.family(name, 20, 3).make(), 4, random));
  sets.add(Cloud(9, Point{ { 1, 2, 3 } }));
  sets.add(integerGrid(4));
  sets.add({});
  sets.append(integerGrid(2));
  return sets;
}

struct Results
{
  std::vector<Result> results;
  std::vector<SetError> errors;
};

Results batchOf(const Kind& kind, const Views& views, const SetView& sets, const Options& options)
{
  const auto moved = [](auto&& batch)
  {
    Results all;
    all.errors = batch.errors;
    for (auto& result : batch.results)
    {
      all.results.emplace_back(std::move(result));
    }
    return all;
  };
  return kind.dimension == 3
    ? moved(flipflop::convexHulls(views.points, sets, options))
    : moved(flipflop::regularTriangulations(views.points, sets, views.weights, options));
}

/// Each set has the result, or the error, of a call of its own. @return how many errors
std::size_t expectSingleCalls(
  const Kind& kind, const Sets& sets, bool weighted, const Options& options)
{
  const Results batch = batchOf(kind, sets.points(0, sets.count(), weighted), sets.view(), options);
  EXPECT_EQ(batch.results.size(), sets.offsets.size() - 1);
  std::size_t errors = 0;
  for (std::size_t i = 0; i + 1 < sets.offsets.size(); ++i)
  {
    try
    {
      const Result own =
        kind.runOn(sets.points(sets.offsets[i], sets.offsets[i + 1], weighted), options);
      EXPECT_EQ(bitDifference(batch.results[i], own), "") << "set " << i;
    }
    catch (const Error& error)
    {
      if (errors == batch.errors.size())
      {
        ADD_FAILURE() << "no error of set " << i;
        return errors;
      }
      const SetError& found = batch.errors[errors++];
      EXPECT_EQ(found.set, i);
      EXPECT_EQ(found.error.code(), error.code());
      EXPECT_EQ(found.error.index(), error.index());
      EXPECT_EQ(found.error.count(), error.count());
      EXPECT_EQ(complexOf(batch.results[i]).dimension, -1);
      EXPECT_TRUE(complexOf(batch.results[i]).pointIds.empty());
    }
  }
  EXPECT_EQ(errors, batch.errors.size());
  return errors;
}

class Batches : public ::testing::TestWithParam<const Kind*>
{
protected:
  const Kind& kind() const { return *GetParam(); }
  Sets mixed() const
  {
    return mixedSets(this->kind(), this->kind().dimension == 3 ? "cube" : "uniformHeavy");
  }
};

TEST_P(Batches, AreThoseOfSingleCalls)
{
  const Sets sets = this->mixed();
  for (const std::int64_t enough : { std::int64_t(1), UsualPointsPerThread })
  {
    const PointsPerThread perThread(enough);
    for (int threads = 0; threads <= 4; ++threads)
    {
      Options options;
      options.threads = threads;
      options.facets = threads % 2 ? FacetMode::Triangles : FacetMode::Polygons;
      EXPECT_EQ(expectSingleCalls(this->kind(), sets, threads > 1, options), 0u);
    }
  }
}

TEST_P(Batches, BadSetsLoseNoOthers)
{
  Sets sets = this->mixed();
  for (const std::size_t set : { 4, 10 })
  {
    sets.scalars[static_cast<std::size_t>(6 * (sets.offsets[set] + 2) + 1)] =
      std::numeric_limits<float>::quiet_NaN();
  }
  for (int threads = 1; threads <= 4; ++threads)
  {
    Options options;
    options.threads = threads;
    EXPECT_EQ(expectSingleCalls(this->kind(), sets, true, options), 2u);
    options.nonFinite = NonFinitePolicy::Ignore;
    EXPECT_EQ(expectSingleCalls(this->kind(), sets, true, options), 0u);
  }
}

TEST_P(Batches, NoSets)
{
  EXPECT_TRUE(batchOf(this->kind(), {}, SetView(), Options()).results.empty());
  const std::int64_t zeros[] = { 0, 0, 0 };
  SetView sets;
  sets.offsets = zeros;
  sets.count = 2;
  const Results batch = batchOf(this->kind(), {}, sets, Options());
  ASSERT_EQ(batch.results.size(), 2u);
  EXPECT_EQ(complexOf(batch.results[1]).dimension, -1);
}

TEST_P(Batches, BadArguments)
{
  const Cloud cloud = fromFamily("cube", 100, 1).make();
  const auto expectBad = [&](const std::int64_t* offsets, std::int64_t count, std::int64_t index)
  {
    SetView sets;
    sets.offsets = offsets;
    sets.count = count;
    expectError([&] { batchOf(this->kind(), viewsOf(cloud), sets, Options()); },
      ErrorCode::BadArgument, index);
  };
  using Limits = std::numeric_limits<std::int64_t>;
  struct Bad
  {
    std::vector<std::int64_t> offsets;
    std::int64_t index;
  };
  for (const Bad& bad :
    { Bad{ { 0, 10, 9, 20 }, 1 }, Bad{ { -1, 10, 20 }, 0 }, Bad{ { 0, 10, 100, 101 }, 2 },
      Bad{ { 101, 101 }, 0 }, Bad{ { 0, Limits::max() }, 0 }, Bad{ { Limits::min(), 0 }, 0 } })
  {
    expectBad(bad.offsets.data(), static_cast<std::int64_t>(bad.offsets.size()) - 1, bad.index);
  }
  const std::int64_t offsets[] = { 0, 100 };
  expectBad(offsets, -1, -1);
  expectBad(nullptr, 1, -1);
}

TEST_P(Batches, ReportProgressAndStop)
{
  Sets sets;
  sets.add(fromFamily("cube", effort(100000), 1).make());
  for (int i = 0; i < 500; ++i)
  {
    sets.add(fromFamily("cube", 200, static_cast<std::uint64_t>(i)).make());
  }
  for (int threads = 1; threads <= 4; ++threads)
  {
    expectProgress(
      [&](const Options& options)
      {
        EXPECT_TRUE(batchOf(this->kind(), sets.points(0, sets.count(), true), sets.view(), options)
                      .errors.empty());
      },
      threads, 2);
  }
}

INSTANTIATE_TEST_SUITE_P(ConvexHull, Batches, ::testing::Values(&convexHulls));
INSTANTIATE_TEST_SUITE_P(RegularTriangulation, Batches, ::testing::Values(&regularTriangulations));

}
}
}
