// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Conformance/Compare.h"
#include "Support/Threads.h"
#include "Testing/Cuda/Rounds/RoundsOnHost.h"
#include "Testing/Engine/Inputs/Inputs.h"

#include <algorithm>
#include <cstring>
#include <sstream>

namespace flipflop
{
namespace test
{

namespace
{

/// Tests ask for up to four threads, on few points and on machines of fewer cores.
const struct ThreadsOnRequest
{
  ThreadsOnRequest() { pointsPerThread() = 1; }
  const threads::Allowance allowed{ 4 };
} threadsOnRequest;

template <class T>
Buffer<T> copyOf(const Buffer<T>& buffer)
{
  Buffer<T> copy(buffer.size());
  for (std::size_t i = 0; i < buffer.size(); ++i)
  {
    copy[i] = buffer[i];
  }
  return copy;
}

double largestExtent(const Cloud& cloud)
{
  double extent = 0;
  for (int c = 0; c < 3 && !cloud.empty(); ++c)
  {
    double low = cloud[0][c];
    double high = low;
    for (const Point& p : cloud)
    {
      low = std::min(low, p[c]);
      high = std::max(high, p[c]);
    }
    extent = std::max(extent, high - low);
  }
  return extent;
}

std::string firstDifference(const std::vector<Cell>& found, const std::vector<Cell>& wanted)
{
  std::ostringstream out;
  out << found.size() << " cells for " << wanted.size();
  for (std::size_t i = 0; i < std::max(found.size(), wanted.size()); ++i)
  {
    if (i >= found.size() || i >= wanted.size() || found[i] != wanted[i])
    {
      out << "; cell " << i << ": (" << (i < found.size() ? toString(found[i]) : "none")
          << ") for (" << (i < wanted.size() ? toString(wanted[i]) : "none") << ")";
      break;
    }
  }
  return out.str();
}

}

PointView viewOf(const Cloud& cloud)
{
  static_assert(sizeof(Point) == 3 * sizeof(double), "points lie densely");
  return PointView(
    cloud.empty() ? nullptr : cloud[0].data(), static_cast<std::int64_t>(cloud.size()));
}

std::vector<float> floatsOf(const Cloud& cloud)
{
  std::vector<float> floats;
  floats.reserve(3 * cloud.size());
  for (const Point& p : cloud)
  {
    for (double x : p)
    {
      floats.push_back(static_cast<float>(x));
    }
  }
  return floats;
}

void copyCells(const CellComplex& from, CellComplex& to)
{
  to.dimension = from.dimension;
  to.pointIds = copyOf(from.pointIds);
  to.connectivity = copyOf(from.connectivity);
  to.offsets = copyOf(from.offsets);
  to.cellSize = from.cellSize;
  to.statistics = from.statistics;
}

Hull clone(const Hull& hull)
{
  Hull copy;
  copyCells(hull, copy);
  copy.volume = hull.volume;
  copy.area = hull.area;
  return copy;
}

std::vector<Cell> cellsOf(const CellComplex& complex)
{
  const std::int64_t points = static_cast<std::int64_t>(complex.pointIds.size());
  std::vector<Cell> cells;
  for (std::int64_t c = 0; c < complex.cellCount(); ++c)
  {
    Cell cell;
    for (std::int64_t i = complex.cellBegin(c); i < complex.cellBegin(c + 1); ++i)
    {
      const std::int64_t corner = complex.connectivity[static_cast<std::size_t>(i)];
      cell.push_back(
        corner >= 0 && corner < points ? complex.pointIds[static_cast<std::size_t>(corner)] : -1);
    }
    cells.push_back(std::move(cell));
  }
  return cells;
}

std::string difference(const CellComplex& complex, const ReferenceHull& reference, FacetMode facets)
{
  std::ostringstream out;
  if (complex.dimension != reference.dimension)
  {
    out << "dimension " << complex.dimension << " for " << reference.dimension;
    return out.str();
  }
  const Cell ids(complex.pointIds.begin(), complex.pointIds.end());
  if (ids != reference.ids)
  {
    out << ids.size() << " points for " << reference.ids.size();
    for (std::size_t i = 0; i < std::max(ids.size(), reference.ids.size()); ++i)
    {
      if (i >= ids.size() || i >= reference.ids.size() || ids[i] != reference.ids[i])
      {
        out << "; the first at fault is number " << i << ": " << (i < ids.size() ? ids[i] : -1)
            << " for " << (i < reference.ids.size() ? reference.ids[i] : -1);
        break;
      }
    }
    return out.str();
  }
  const std::vector<Cell> wanted =
    facets == FacetMode::Polygons ? reference.cells : triangulate(reference.cells);
  const std::vector<Cell> found = cellsOf(complex);
  if (found != wanted)
  {
    return firstDifference(found, wanted);
  }
  const std::int64_t end = complex.cellCount() > 0 ? complex.cellBegin(complex.cellCount()) : 0;
  if (end != static_cast<std::int64_t>(complex.connectivity.size()))
  {
    return "connectivity goes on after the last cell";
  }
  if (!complex.offsets.empty() && complex.cellSize != 0)
  {
    return "both offsets and cellSize are set";
  }
  return "";
}

std::string bitDifference(const CellComplex& a, const CellComplex& b)
{
  if (a.dimension != b.dimension)
  {
    return "dimension";
  }
  if (!sameBits(a.pointIds, b.pointIds))
  {
    return "pointIds";
  }
  if (!sameBits(a.connectivity, b.connectivity))
  {
    return "connectivity";
  }
  return !sameBits(a.offsets, b.offsets) || a.cellSize != b.cellSize ? "offsets or cellSize" : "";
}

std::string bitDifference(const Hull& a, const Hull& b)
{
  const std::string fault =
    bitDifference(static_cast<const CellComplex&>(a), static_cast<const CellComplex&>(b));
  if (!fault.empty())
  {
    return fault;
  }
  if (std::memcmp(&a.volume, &b.volume, sizeof(double)) != 0)
  {
    return "volume";
  }
  return std::memcmp(&a.area, &b.area, sizeof(double)) != 0 ? "area" : "";
}

std::string statisticsFault(const CellComplex& complex, std::int64_t points)
{
  const Statistics& s = complex.statistics;
  if (s.points != points)
  {
    return "points";
  }
  if (s.flips22 + s.flips31 != s.flipsV + s.flipsD)
  {
    return "flips by kind and flips by criterion differ in sum";
  }
  std::string negative;
  Statistics::eachField(
    [&](const char* name, auto field) { negative = s.*field < 0 ? name : negative; });
  if (!negative.empty())
  {
    return negative + " is negative";
  }
  return s.culled > points ? "more culled points than there are" : "";
}

void expectHull(const Cloud& cloud, const ReferenceHull& reference)
{
  const std::vector<float> floats = isFloat(cloud) ? floatsOf(cloud) : std::vector<float>();
  const std::int64_t count = static_cast<std::int64_t>(cloud.size());
  const Measures measures = measure(cloud, reference);
  const double extent = largestExtent(cloud);
  for (FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    Hull first;
    bool isFirst = true;
    for (int threads : threadsTried())
    {
      for (bool vBiased : { false, true })
      {
        for (bool single : { false, true })
        {
          if (single && floats.empty())
          {
            continue;
          }
          Options options;
          options.threads = threads;
          options.facets = facets;
          options.vBiased = vBiased;
          std::ostringstream variant;
          variant << threads << " threads, " << (vBiased ? "V-biased, " : "")
                  << (single ? "float, " : "double, ")
                  << (facets == FacetMode::Polygons ? "polygons" : "triangles");
          SCOPED_TRACE(variant.str());
          const PointView view = single ? PointView(floats.data(), count) : viewOf(cloud);
          Hull hull;
          ASSERT_NO_THROW(hull = convexHull(view, options));
          ASSERT_EQ(difference(hull, reference, facets), "");
          ASSERT_EQ(statisticsFault(hull, count), "");
          if (isFirst)
          {
            isFirst = false;
            first = std::move(hull);
            for (int checkers : { 1, 2 })
            {
              const Validation valid = validate(view, first, checkers);
              ASSERT_TRUE(valid) << describe(valid.fault) << ", index " << valid.index;
            }
            // Sums of doubles: right to many digits of the extent in ordinary ranges.
            if (extent > 1e-90 && extent < 1e90)
            {
              EXPECT_NEAR(first.volume, measures.volume,
                1e-9 * measures.volume + 1e-14 * extent * extent * extent);
              EXPECT_NEAR(
                first.area, measures.area, 1e-9 * measures.area + 1e-14 * extent * extent);
            }
            EXPECT_GE(first.volume, 0);
            EXPECT_GE(first.area, 0);
          }
          else
          {
            ASSERT_EQ(bitDifference(hull, first), "");
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
      SCOPED_TRACE("rounds " + variant.how.toString() + (variant.vBiased ? ", V-biased" : "") +
        (facets == FacetMode::Polygons ? ", polygons" : ", triangles"));
      const bool single = variant.vBiased && !floats.empty();
      const PointView view = single ? PointView(floats.data(), count) : viewOf(cloud);
      Hull hull;
      ASSERT_NO_THROW(hull = hullByRounds(view, options, variant.how));
      ASSERT_EQ(bitDifference(hull, first), "");
      ASSERT_EQ(statisticsFault(hull, count), "");
    }
  }
}

void expectError(
  const std::function<void()>& run, ErrorCode code, std::int64_t index, std::int64_t count)
{
  try
  {
    run();
    ADD_FAILURE() << "no error; wanted: " << Error(code).what();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_STRNE(error.what(), "");
    EXPECT_STRNE(error.what(), Error(ErrorCode::BadArgument).what());
    EXPECT_TRUE(index == -2 || error.index() == index) << error.index() << " for " << index;
    EXPECT_TRUE(count == -2 || error.count() == count) << error.count() << " for " << count;
  }
}

bool isSanitized()
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return true;
#else
  return false;
#endif
}

int effort(int count)
{
  return isSanitized() ? (count + 19) / 20 : count;
}

std::vector<int> threadsTried()
{
  return isSanitized() ? std::vector<int>{ 1, 4 } : std::vector<int>{ 1, 2, 4 };
}

}
}
