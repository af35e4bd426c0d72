// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a triangulation does not read, and a weight that is ignored.
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

TEST(TriangulationErrors, ABadWeightIgnoredTakesThePointAlong)
{
  // The heaviest of three at one position is not finite: the next one stands for them.
  const Cloud cloud = joined(squareGrid(2), { { 0, 0, 3 }, { 0, 0, infinity }, { nan, 0, 9 } });
  Options options;
  options.nonFinite = NonFinitePolicy::Ignore;
  const Triangulation found = regularTriangulation(viewOf(cloud), weightsOf(cloud), options);
  EXPECT_EQ(Cell(found.pointIds.begin(), found.pointIds.end()), (Cell{ 1, 2, 3, 4 }));
  EXPECT_EQ(Cell(found.hiddenIds.begin(), found.hiddenIds.end()), (Cell{ 0 }));
  EXPECT_EQ(found.statistics.nonFinite, 2);
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

}
}
}
