// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Support/Threads.h"
#include "Testing/Cuda/Rounds/RoundsOnHost.h"
#include "Testing/Engine/Inputs/Inputs.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace flipflop
{
namespace test
{

namespace
{

Buffer<std::int64_t> bufferOf(const Cell& values)
{
  Buffer<std::int64_t> buffer(values.size());
  std::copy(values.begin(), values.end(), buffer.begin());
  return buffer;
}

/// The same points and weights as a caller may have them: by type, and with or without z.
struct Layout
{
  bool floatPoints = false;
  bool floatWeights = false;
  bool weightless = false; ///< no weights at all

  bool isNative() const { return !this->floatPoints && !this->floatWeights && !this->weightless; }

  std::string toString() const
  {
    return std::string(this->floatPoints ? "float points, " : "double points, ") +
      (this->weightless        ? "no weights"
          : this->floatWeights ? "float weights"
                               : "double weights");
  }
};

/// A weighted cloud in every layout.
class Layouts
{
public:
  explicit Layouts(const Cloud& weighted)
    : Weighted(weighted)
    , Count(static_cast<std::int64_t>(weighted.size()))
  {
    Cloud flat = weighted;
    Cloud heights = weighted;
    bool zero = true;
    for (std::size_t i = 0; i < weighted.size(); ++i)
    {
      flat[i][2] = 0;
      heights[i][0] = heights[i][1] = 0;
      zero = zero && weighted[i][2] == 0;
    }
    const bool floatPoints = isFloat(flat);
    const bool floatWeights = isFloat(heights);
    for (const Point& p : weighted)
    {
      // Nobody may look at z: there is none.
      this->Points.push_back(floatPoints ? static_cast<float>(p[0]) : 0);
      this->Points.push_back(floatPoints ? static_cast<float>(p[1]) : 0);
      this->Weights.push_back(floatWeights ? static_cast<float>(p[2]) : 0);
    }
    this->All.push_back({});
    if (floatPoints)
    {
      this->All.push_back({ true, false, false });
    }
    if (floatWeights)
    {
      this->All.push_back({ false, true, false });
    }
    if (floatPoints && floatWeights)
    {
      this->All.push_back({ true, true, false });
    }
    if (zero)
    {
      this->All.push_back({ false, false, true });
      if (floatPoints)
      {
        this->All.push_back({ true, false, true });
      }
    }
  }

  const std::vector<Layout>& all() const { return this->All; }
  PointView points(const Layout& layout) const
  {
    return layout.floatPoints ? PointView(this->Points.data(), this->Count, 2)
                              : viewOf(this->Weighted);
  }
  WeightView weights(const Layout& layout) const
  {
    return layout.weightless ? WeightView()
      : layout.floatWeights  ? WeightView(this->Weights.data(), this->Count)
                             : weightsOf(this->Weighted);
  }

private:
  const Cloud& Weighted;
  std::int64_t Count;
  std::vector<float> Points;
  std::vector<float> Weights;
  std::vector<Layout> All;
};

}

WeightView weightsOf(const Cloud& weighted)
{
  // Without points a place all the same: no data means no weights.
  static const double none = 0;
  return WeightView(
    weighted.empty() ? &none : &weighted[0][2], static_cast<std::int64_t>(weighted.size()), 3);
}

Triangulation clone(const Triangulation& triangulation)
{
  Triangulation copy;
  copyCells(triangulation, copy);
  copy.hiddenIds = bufferOf(Cell(triangulation.hiddenIds.begin(), triangulation.hiddenIds.end()));
  return copy;
}

Triangulation makeTriangulation(
  const ReferenceTriangulation& reference, std::int64_t points, FacetMode facets)
{
  Triangulation result;
  result.dimension = reference.dimension;
  result.pointIds = bufferOf(reference.ids);
  result.hiddenIds = bufferOf(hiddenIds(points, reference.ids));
  const bool fans = facets == FacetMode::Triangles && reference.dimension >= 2;
  Cell corners;
  Cell starts = { 0 };
  for (const Cell& cell : fans ? triangulate(reference.cells) : reference.cells)
  {
    for (std::int64_t id : cell)
    {
      corners.push_back(
        std::lower_bound(reference.ids.begin(), reference.ids.end(), id) - reference.ids.begin());
    }
    starts.push_back(static_cast<std::int64_t>(corners.size()));
  }
  result.connectivity = bufferOf(corners);
  if (fans)
  {
    result.cellSize = 3;
  }
  else if (reference.dimension == 0 || reference.dimension == 1)
  {
    result.cellSize = reference.dimension + 1;
  }
  else
  {
    result.offsets = bufferOf(starts);
  }
  return result;
}

std::string difference(const Triangulation& triangulation, const ReferenceTriangulation& reference,
  FacetMode facets, std::int64_t points)
{
  const CellComplex& cells = triangulation;
  const std::string fault = difference(cells, reference, facets);
  const Cell hidden(triangulation.hiddenIds.begin(), triangulation.hiddenIds.end());
  return !fault.empty() || hidden == hiddenIds(points, reference.ids) ? fault : "hiddenIds";
}

std::string bitDifference(const Triangulation& a, const Triangulation& b)
{
  const std::string fault =
    bitDifference(static_cast<const CellComplex&>(a), static_cast<const CellComplex&>(b));
  const bool same =
    std::equal(a.hiddenIds.begin(), a.hiddenIds.end(), b.hiddenIds.begin(), b.hiddenIds.end());
  return !fault.empty() || same ? fault : "hiddenIds";
}

std::string statisticsFault(const Triangulation& triangulation, std::int64_t points)
{
  const std::size_t left = triangulation.pointIds.size() + triangulation.hiddenIds.size();
  return static_cast<std::int64_t>(left) + triangulation.statistics.nonFinite != points
    ? "visible, hidden and non-finite points are not all"
    : statisticsFault(static_cast<const CellComplex&>(triangulation), points);
}

void expectTriangulation(const Cloud& weighted, const ReferenceTriangulation& reference)
{
  const std::int64_t count = static_cast<std::int64_t>(weighted.size());
  const Layouts layouts(weighted);
  for (FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    Triangulation first;
    bool isFirst = true;
    for (int threads : threadsTried())
    {
      for (bool vBiased : { false, true })
      {
        for (const Layout& layout : layouts.all())
        {
          // All types in one plain run each, V-biased with one thread and with four; all together
          // for small clouds.
          const bool isPlain = threads == 1 && !vBiased;
          const bool isOdd = !layout.isNative() || (threads != 1 && vBiased != (threads == 4));
          if (!isPlain && isOdd && count > 40)
          {
            continue;
          }
          Options options;
          options.threads = threads;
          options.facets = facets;
          options.vBiased = vBiased;
          SCOPED_TRACE(std::to_string(threads) + " threads, " + (vBiased ? "V-biased, " : "") +
            layout.toString() + (facets == FacetMode::Polygons ? ", polygons" : ", triangles"));
          const PointView points = layouts.points(layout);
          const WeightView weights = layouts.weights(layout);
          Triangulation found;
          ASSERT_NO_THROW(found = regularTriangulation(points, weights, options));
          ASSERT_EQ(difference(found, reference, facets, count), "");
          ASSERT_EQ(statisticsFault(found, count), "");
          EXPECT_EQ(found.statistics.threads,
            threadCount(threads, static_cast<std::int64_t>(weighted.size())));
          if (isFirst)
          {
            isFirst = false;
            first = std::move(found);
          }
          else
          {
            ASSERT_EQ(bitDifference(found, first), "");
          }
          if (isPlain)
          {
            const int checkers = layout.isNative() ? 2 : 1;
            const Validation valid = validate(points, weights, first, checkers);
            ASSERT_TRUE(valid) << describe(valid.fault) << ", index " << valid.index;
          }
        }
      }
    }
    for (const RoundsVariant& variant : roundsVariants(count, facets))
    {
      Options options;
      options.threads = 1;
      options.facets = facets;
      options.vBiased = variant.vBiased;
      const Layout& layout = variant.vBiased ? layouts.all().back() : layouts.all().front();
      SCOPED_TRACE("rounds " + variant.how.toString() + (variant.vBiased ? ", V-biased, " : ", ") +
        layout.toString() + (facets == FacetMode::Polygons ? ", polygons" : ", triangles"));
      Triangulation found;
      ASSERT_NO_THROW(found = triangulationByRounds(
                        layouts.points(layout), layouts.weights(layout), options, variant.how));
      ASSERT_EQ(bitDifference(found, first), "");
      ASSERT_EQ(statisticsFault(found, count), "");
    }
  }
}

}
}
