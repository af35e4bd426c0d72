// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A batch gives each set what a call of its own gives, bit for bit; and one at fault loses no
/// other.
#include "Support/Threads.h"
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Conformance/ProgressWatch.h"
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include <flipflop/Batch.h>

#include <limits>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

/// Sets in one array, as a caller has them.
struct Sets
{
  Cloud cloud;
  std::vector<std::int64_t> offsets{ 0 };

  void add(const Cloud& set)
  {
    this->cloud = joined(this->cloud, set);
    this->offsets.push_back(static_cast<std::int64_t>(this->cloud.size()));
  }
  SetView view() const
  {
    SetView result;
    result.offsets = this->offsets.data();
    result.count = static_cast<std::int64_t>(this->offsets.size()) - 1;
    return result;
  }
  Cloud set(std::size_t i) const
  {
    return Cloud(
      this->cloud.begin() + this->offsets[i], this->cloud.begin() + this->offsets[i + 1]);
  }
};

/// Sets of all sizes: none, one, few, many; duplicates, flat ones, grids.
Sets mixedSets(Input (*family)(const std::string&, int, std::uint64_t), const char* name)
{
  Sets sets;
  Random random(7);
  sets.add({});
  for (const int count : { 1, 2, 3, 8, 0, 0, 5000, 8, 100, 20000, 1000, 4, 12 })
  {
    sets.add(family(name, count, static_cast<std::uint64_t>(count)).make());
  }
  sets.add(repeated(family(name, 20, 3).make(), 4, random));
  sets.add(Cloud(9, Point{ { 1, 2, 3 } }));
  sets.add(integerGrid(4));
  sets.add({});
  return sets;
}

void expectHulls(const Sets& sets, const Options& options)
{
  const Batch<Hull> batch = convexHulls(viewOf(sets.cloud), sets.view(), options);
  EXPECT_TRUE(batch.errors.empty());
  ASSERT_EQ(batch.results.size(), sets.offsets.size() - 1);
  for (std::size_t i = 0; i < batch.results.size(); ++i)
  {
    const Cloud set = sets.set(i);
    EXPECT_EQ(bitDifference(batch.results[i], convexHull(viewOf(set), options)), "") << i;
  }
}

void expectTriangulations(const Sets& sets, bool weighted, const Options& options)
{
  const Batch<Triangulation> batch = regularTriangulations(
    viewOf(sets.cloud), sets.view(), weighted ? weightsOf(sets.cloud) : WeightView(), options);
  EXPECT_TRUE(batch.errors.empty());
  ASSERT_EQ(batch.results.size(), sets.offsets.size() - 1);
  for (std::size_t i = 0; i < batch.results.size(); ++i)
  {
    const Cloud set = sets.set(i);
    EXPECT_EQ(
      bitDifference(batch.results[i],
        regularTriangulation(viewOf(set), weighted ? weightsOf(set) : WeightView(), options)),
      "")
      << i;
  }
}

/// What is thrown; no error: -1 and ADD_FAILURE.
template <class Call>
Error errorOf(Call&& call)
{
  try
  {
    call();
  }
  catch (const Error& error)
  {
    return error;
  }
  ADD_FAILURE() << "no error";
  return Error(ErrorCode::Internal);
}

TEST(Batch, HullsAreThoseOfSingleCalls)
{
  const Sets sets = mixedSets(fromFamily, "cube");
  for (const std::int64_t perThread : { std::int64_t(1), UsualPointsPerThread })
  {
    pointsPerThread() = perThread;
    for (int threads = 0; threads <= 4; ++threads)
    {
      Options options;
      options.threads = threads;
      options.facets = threads % 2 ? FacetMode::Triangles : FacetMode::Polygons;
      expectHulls(sets, options);
    }
  }
  pointsPerThread() = 1;
}

TEST(Batch, TriangulationsAreThoseOfSingleCalls)
{
  const Sets sets = mixedSets(fromWeightedFamily, "uniform");
  for (int threads = 1; threads <= 4; ++threads)
  {
    Options options;
    options.threads = threads;
    expectTriangulations(sets, false, options);
    expectTriangulations(sets, true, options);
  }
}

/// Floats, with a stride; and sets that leave points out at both ends.
TEST(Batch, TakesPointsAsTheyLie)
{
  Random random(5);
  std::vector<float> scalars;
  for (int i = 0; i < 5 * 300; ++i)
  {
    scalars.push_back(static_cast<float>(random.uniform()));
  }
  const std::vector<std::int64_t> offsets{ 10, 110, 110, 290 };
  SetView sets;
  sets.offsets = offsets.data();
  sets.count = 3;
  const Batch<Hull> hulls = convexHulls(PointView(scalars.data(), 300, 5), sets);
  const Batch<Triangulation> triangulations = regularTriangulations(
    PointView(scalars.data(), 300, 5), sets, WeightView(scalars.data() + 4, 300, 5));
  for (std::size_t i = 0; i < 3; ++i)
  {
    const float* first = scalars.data() + 5 * offsets[i];
    const PointView own(first, offsets[i + 1] - offsets[i], 5);
    EXPECT_EQ(bitDifference(hulls.results[i], convexHull(own)), "") << i;
    EXPECT_EQ(bitDifference(triangulations.results[i],
                regularTriangulation(own, WeightView(first + 4, own.count, 5))),
      "")
      << i;
  }
}

TEST(Batch, NoSets)
{
  EXPECT_TRUE(convexHulls(PointView(), SetView()).results.empty());
  EXPECT_TRUE(regularTriangulations(PointView(), SetView()).results.empty());
  const std::int64_t zeros[] = { 0, 0, 0 };
  SetView sets;
  sets.offsets = zeros;
  sets.count = 2;
  const Batch<Hull> batch = convexHulls(PointView(), sets);
  ASSERT_EQ(batch.results.size(), 2u);
  EXPECT_EQ(batch.results[1].dimension, -1);
}

TEST(Batch, BadSetsLoseNoOthers)
{
  Sets sets = mixedSets(fromFamily, "cube");
  const std::size_t bad[] = { 4, 10 };
  for (const std::size_t set : bad)
  {
    sets.cloud[static_cast<std::size_t>(sets.offsets[set]) + 2][1] =
      std::numeric_limits<double>::quiet_NaN();
  }
  for (int threads = 1; threads <= 4; ++threads)
  {
    Options options;
    options.threads = threads;
    const Batch<Hull> batch = convexHulls(viewOf(sets.cloud), sets.view(), options);
    ASSERT_EQ(batch.errors.size(), 2u);
    for (int k = 0; k < 2; ++k)
    {
      EXPECT_EQ(batch.errors[k].set, bad[k]);
      EXPECT_EQ(batch.errors[k].error.code(), ErrorCode::NonFinite);
      EXPECT_EQ(batch.errors[k].error.index(), 2);
      EXPECT_EQ(batch.errors[k].error.count(), 1);
      EXPECT_EQ(bitDifference(batch.results[bad[k]], Hull()), "");
    }
    for (const std::size_t good : { 3u, 7u, 9u, 11u })
    {
      const Cloud set = sets.set(good);
      EXPECT_EQ(bitDifference(batch.results[good], convexHull(viewOf(set), options)), "") << good;
    }
    options.nonFinite = NonFinitePolicy::Ignore;
    expectHulls(sets, options);
  }
}

TEST(Batch, BadArguments)
{
  const Cloud cloud = fromFamily("cube", 100, 1).make();
  const auto errorAt = [&](const std::vector<std::int64_t>& offsets)
  {
    SetView sets;
    sets.offsets = offsets.data();
    sets.count = static_cast<std::int64_t>(offsets.size()) - 1;
    const Error error = errorOf([&] { convexHulls(viewOf(cloud), sets); });
    EXPECT_EQ(error.code(), ErrorCode::BadArgument);
    EXPECT_EQ(errorOf([&] { regularTriangulations(viewOf(cloud), sets); }).index(), error.index());
    return error.index();
  };
  EXPECT_EQ(errorAt({ 0, 10, 9, 20 }), 1);
  EXPECT_EQ(errorAt({ -1, 10, 20 }), 0);
  EXPECT_EQ(errorAt({ 0, 10, 100, 101 }), 2);
  EXPECT_EQ(errorAt({ 101, 101 }), 0);
  EXPECT_EQ(errorAt({ 0, std::numeric_limits<std::int64_t>::max() }), 0);
  EXPECT_EQ(errorAt({ std::numeric_limits<std::int64_t>::min(), 0 }), 0);

  const std::int64_t offsets[] = { 0, 100 };
  SetView sets;
  sets.offsets = offsets;
  sets.count = 1;
  const auto codeOf = [&](const SetView& of)
  { return errorOf([&] { regularTriangulations(viewOf(cloud), of); }).code(); };
  sets.count = -1;
  EXPECT_EQ(codeOf(sets), ErrorCode::BadArgument);
  sets.count = 1;
  sets.offsets = nullptr;
  EXPECT_EQ(codeOf(sets), ErrorCode::BadArgument);
}

TEST(Batch, TellsProgressAndStops)
{
  Sets sets;
  sets.add(fromFamily("cube", effort(100000), 1).make());
  for (int i = 0; i < 500; ++i)
  {
    sets.add(fromFamily("cube", 200, static_cast<std::uint64_t>(i)).make());
  }
  for (int threads = 1; threads <= 4; ++threads)
  {
    Watch watch;
    const Batch<Hull> batch = convexHulls(viewOf(sets.cloud), sets.view(), watch.options(threads));
    watch.expectOrder();
    ASSERT_GE(watch.fractions.size(), 2u);
    EXPECT_EQ(watch.fractions.front(), 0);
    EXPECT_EQ(watch.fractions.back(), 1);
    EXPECT_TRUE(batch.errors.empty());
    for (const int stopAt : { 1, 2 })
    {
      Watch stopped;
      stopped.stopAt = stopAt;
      const Error error =
        errorOf([&] { convexHulls(viewOf(sets.cloud), sets.view(), stopped.options(threads)); });
      EXPECT_EQ(error.code(), ErrorCode::Aborted);
      EXPECT_EQ(static_cast<int>(stopped.fractions.size()), stopAt) << "called after it";
    }
  }
}

}

}
}
