// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Bad weighted input gets an Error that says what is wrong, where, and how often; and what does
/// not count is not looked at.
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <cstring>
#include <limits>

#include <sys/mman.h>
#include <unistd.h>

namespace flipflop
{
namespace test
{

namespace
{

const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

void expectError(const PointView& points, const WeightView& weights, const Options& options,
  ErrorCode code, std::int64_t index = -2, std::int64_t count = -2)
{
  test::expectError([&] { regularTriangulation(points, weights, options); }, code, index, count);
}

void expectNonFinite(const Cloud& weighted, int threads, std::int64_t index, std::int64_t count)
{
  Options options;
  options.threads = threads;
  expectError(viewOf(weighted), weightsOf(weighted), options, ErrorCode::NonFinite, index, count);
}

/// An array that ends where memory does: reading past it crashes.
template <class T>
class AtTheEnd
{
public:
  explicit AtTheEnd(const std::vector<T>& values)
    : Page(static_cast<std::size_t>(sysconf(_SC_PAGESIZE)))
    , Size((values.size() * sizeof(T) + this->Page - 1) / this->Page * this->Page + this->Page)
    , Memory(static_cast<char*>(
        mmap(nullptr, this->Size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)))
  {
    EXPECT_EQ(mprotect(this->Memory + this->Size - this->Page, this->Page, PROT_NONE), 0);
    this->First = this->Memory + this->Size - this->Page - values.size() * sizeof(T);
    std::memcpy(this->First, values.data(), values.size() * sizeof(T));
  }
  AtTheEnd(const AtTheEnd&) = delete;
  AtTheEnd& operator=(const AtTheEnd&) = delete;
  ~AtTheEnd() { munmap(this->Memory, this->Size); }

  const T* data() const { return reinterpret_cast<const T*>(this->First); }

private:
  std::size_t Page;
  std::size_t Size;
  char* Memory;
  char* First;
};

TEST(TriangulationErrors, NonFiniteNamesTheFirstAndCountsAll)
{
  for (int count : { 1, 2, 5, 100, 3000, 30000 })
  {
    const Cloud good = fromWeightedFamily("uniformHeavy", count, 17).make();
    for (int threads : { 1, 2, 4 })
    {
      for (double bad : { nan, -nan, infinity, -infinity })
      {
        for (int c = 0; c < 3; ++c)
        {
          Cloud cloud = good;
          const int first = count / 3;
          cloud[first][c] = bad;
          expectNonFinite(cloud, threads, first, 1);
          // A point that is bad in all ways is one bad point.
          cloud[count - 1] = { bad, bad, bad };
          expectNonFinite(cloud, threads, first, first == count - 1 ? 1 : 2);
        }
      }
    }
  }
}

TEST(TriangulationErrors, NonFiniteInFloats)
{
  const Cloud cloud = roundedToFloat(fromWeightedFamily("uniformHeavy", 4000, 18).make());
  std::vector<float> floats = floatsOf(cloud);
  floats[3 * 2640 + 2] = std::numeric_limits<float>::infinity(); // a weight
  floats[3 * 3900 + 1] = std::numeric_limits<float>::quiet_NaN();
  for (int threads : { 1, 2 })
  {
    Options options;
    options.threads = threads;
    expectError(PointView(floats.data(), 4000), WeightView(&floats[2], 4000, 3), options,
      ErrorCode::NonFinite, 2640, 2);
    // Without weights only the point counts.
    expectError(
      PointView(floats.data(), 4000), WeightView(), options, ErrorCode::NonFinite, 3900, 1);
  }
}

TEST(TriangulationErrors, NonFiniteWhereAllPointsAreBad)
{
  for (int count : { 1, 4, 7000 })
  {
    const Cloud cloud(static_cast<std::size_t>(count), Point{ 1, 2, nan });
    expectNonFinite(cloud, 2, 0, count);
    Options options;
    options.nonFinite = NonFinitePolicy::Ignore;
    const Triangulation none = regularTriangulation(viewOf(cloud), weightsOf(cloud), options);
    EXPECT_EQ(none.dimension, -1);
    EXPECT_EQ(none.cellCount(), 0);
    EXPECT_TRUE(none.pointIds.empty());
    EXPECT_TRUE(none.hiddenIds.empty());
    EXPECT_EQ(statisticsFault(none, count), "");
    EXPECT_EQ(none.statistics.nonFinite, count);
    EXPECT_TRUE(validate(viewOf(cloud), weightsOf(cloud), none));
  }
}

TEST(TriangulationErrors, IgnoredNonFinitePointsChangeNothingElse)
{
  for (const char* name : { "uniformHeavy", "smallIntegers", "lineAlongX" })
  {
    for (int count : { 1, 2, 8, 60, 800, 12000 })
    {
      SCOPED_TRACE(std::string(name) + "_" + std::to_string(count) + ", seeds 19 and 20");
      const Cloud clean = fromWeightedFamily(name, count, 19).make();
      Random random(20);
      std::vector<std::int64_t> names;
      const Cloud dirty = withNonFinite(clean, random, names);
      const auto bad = static_cast<std::int64_t>(dirty.size() - clean.size());
      const ReferenceTriangulation reference = cgalTriangulation(clean);
      const auto renamed = [&](Cell cell)
      {
        for (std::int64_t& id : cell)
        {
          id = names[id];
        }
        return cell;
      };
      std::vector<Cell> wanted;
      for (const Cell& cell : reference.cells)
      {
        wanted.push_back(renamed(cell));
      }
      for (int threads : { 1, 2, 4 })
      {
        Options options;
        options.threads = threads;
        options.nonFinite = NonFinitePolicy::Ignore;
        options.facets = FacetMode::Polygons;
        const Triangulation found = regularTriangulation(viewOf(dirty), weightsOf(dirty), options);
        EXPECT_EQ(cellsOf(found), wanted);
        EXPECT_EQ(Cell(found.hiddenIds.begin(), found.hiddenIds.end()),
          renamed(hiddenIds(count, reference.ids)));
        EXPECT_EQ(found.statistics.nonFinite, bad);
        EXPECT_EQ(statisticsFault(found, static_cast<std::int64_t>(dirty.size())), "");
        EXPECT_TRUE(validate(viewOf(dirty), weightsOf(dirty), found));
      }
    }
  }
}

TEST(TriangulationErrors, ABadWeightIgnoredTakesThePointAlong)
{
  // The heaviest of three at one place is not finite: the next one stands for them.
  const Cloud cloud = joined(squareGrid(2), { { 0, 0, 3 }, { 0, 0, infinity }, { nan, 0, 9 } });
  Options options;
  options.nonFinite = NonFinitePolicy::Ignore;
  const Triangulation found = regularTriangulation(viewOf(cloud), weightsOf(cloud), options);
  EXPECT_EQ(Cell(found.pointIds.begin(), found.pointIds.end()), (Cell{ 1, 2, 3, 4 }));
  EXPECT_EQ(Cell(found.hiddenIds.begin(), found.hiddenIds.end()), (Cell{ 0 }));
  EXPECT_EQ(found.statistics.nonFinite, 2);
}

TEST(TriangulationErrors, WeightCount)
{
  const Cloud cloud = squareGrid(3);
  const std::vector<double> weights(20, 0.0);
  const std::vector<float> floats(20, 0.0f);
  for (std::int64_t count : { 0, 1, 8, 10, 20 })
  {
    expectError(viewOf(cloud), WeightView(weights.data(), count), Options(), ErrorCode::WeightCount,
      -2, count);
    expectError(viewOf(cloud), WeightView(floats.data(), count), Options(), ErrorCode::WeightCount,
      -2, count);
  }
  expectError(PointView(cloud[0].data(), 0), WeightView(weights.data(), 4), Options(),
    ErrorCode::WeightCount, -2, 4);
  EXPECT_EQ(regularTriangulation(viewOf(cloud), WeightView(weights.data(), 9)).cellCount(), 8);
  EXPECT_THROW(regularTriangulation(viewOf(cloud), WeightView(weights.data(), -9)), Error);
}

TEST(TriangulationErrors, BadArguments)
{
  const double data[] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  const Options options;
  const WeightView none;
  expectError(
    PointView(static_cast<const double*>(nullptr), 4), none, options, ErrorCode::BadArgument);
  expectError(
    PointView(static_cast<const float*>(nullptr), 1), none, options, ErrorCode::BadArgument);
  expectError(PointView(data, -1), none, options, ErrorCode::BadArgument);
  expectError(PointView(data, std::numeric_limits<std::int64_t>::min()), none, options,
    ErrorCode::BadArgument);
  for (std::int64_t stride : { 1, 0, -2, -3 })
  {
    expectError(PointView(data, 4, stride), none, options, ErrorCode::BadArgument);
  }
  for (std::int64_t stride : { 0, -1, -3 })
  {
    expectError(PointView(data, 4), WeightView(data, 4, stride), options, ErrorCode::BadArgument);
  }
  // No point is no error, with data or without.
  EXPECT_EQ(regularTriangulation(PointView(data, 0)).dimension, -1);
  EXPECT_EQ(regularTriangulation(PointView(data, 0), WeightView(data, 0)).dimension, -1);
  EXPECT_EQ(regularTriangulation(PointView(static_cast<const double*>(nullptr), 0)).dimension, -1);
}

TEST(TriangulationErrors, TooManyPointsBeforeAnythingIsRead)
{
  // Nobody may follow this pointer.
  const double* dummy = reinterpret_cast<const double*>(static_cast<std::uintptr_t>(8));
  const std::int64_t limit = (std::int64_t(1) << 32) - 2;
  for (std::int64_t count : { limit + 1, 2 * limit, std::numeric_limits<std::int64_t>::max() })
  {
    expectError(PointView(dummy, count), WeightView(dummy, count), Options(),
      ErrorCode::TooManyPoints, -2, count);
    expectError(
      PointView(dummy, count), WeightView(), Options(), ErrorCode::TooManyPoints, -2, count);
  }
}

TEST(TriangulationErrors, ZIsNeverRead)
{
  // It may be what it likes, or not be there at all.
  for (int count : { 3, 7, 500, 2047, 2048, 2049, 9000 })
  {
    for (int threads : { 1, 2 })
    {
      const Cloud cloud = roundedToFloat(fromWeightedFamily("uniformHeavy", count, 23).make());
      Options options;
      options.threads = threads;
      const Triangulation wanted = regularTriangulation(viewOf(cloud), weightsOf(cloud), options);
      std::vector<double> pairs;
      std::vector<double> weights;
      Cloud wild = cloud;
      for (std::size_t i = 0; i < cloud.size(); ++i)
      {
        pairs.push_back(cloud[i][0]);
        pairs.push_back(cloud[i][1]);
        weights.push_back(cloud[i][2]);
        wild[i][2] = i % 2 ? nan : infinity;
      }
      const AtTheEnd<double> lastPairs(pairs);
      const AtTheEnd<double> lastWeights(weights);
      const AtTheEnd<float> floatPairs(std::vector<float>(pairs.begin(), pairs.end()));
      const AtTheEnd<float> floatWeights(std::vector<float>(weights.begin(), weights.end()));
      // With a stride of 3 the last z need not exist.
      std::vector<double> triples = std::vector<double>(wild[0].data(), wild.back().data() + 2);
      const AtTheEnd<double> lastTriples(triples);
      const std::pair<PointView, WeightView> views[] = {
        { PointView(lastPairs.data(), count, 2), WeightView(lastWeights.data(), count) },
        { PointView(floatPairs.data(), count, 2), WeightView(floatWeights.data(), count) },
        { PointView(lastTriples.data(), count), WeightView(lastWeights.data(), count) },
        { viewOf(wild), WeightView(lastWeights.data(), count) },
      };
      for (const auto& view : views)
      {
        const Triangulation found = regularTriangulation(view.first, view.second, options);
        EXPECT_EQ(bitDifference(found, wanted), "") << count << " points, seed 23";
        const Validation valid = validate(view.first, view.second, found, threads);
        EXPECT_TRUE(valid) << describe(valid.fault);
      }
    }
  }
}

TEST(TriangulationErrors, NothingBetweenIsLookedAt)
{
  const double points[] = { 0, 0, nan, infinity, 1, 0, nan, nan, 0, 1, infinity, nan };
  const double weights[] = { 0, nan, 0, infinity, 0 };
  const Triangulation found =
    regularTriangulation(PointView(points, 3, 4), WeightView(weights, 3, 2));
  EXPECT_EQ(found.cellCount(), 1);
  EXPECT_EQ(found.pointIds.size(), 3u);
}

TEST(TriangulationErrors, ARunAfterAnErrorIsRight)
{
  Cloud cloud = squareGrid(4);
  cloud[10][1] = nan;
  EXPECT_THROW(regularTriangulation(viewOf(cloud)), Error);
  cloud[10][1] = 2;
  EXPECT_EQ(regularTriangulation(viewOf(cloud)).cellCount(), 18);
}

}
}
}
