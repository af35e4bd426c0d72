// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Conformance/Compare.h"
#include "Support/Threads.h"

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

std::string toText(std::int64_t id)
{
  return std::to_string(id);
}
std::string toText(const Cell& cell)
{
  return "(" + toString(cell) + ")";
}

/// Where two lists part first.
template <class T>
std::string firstDifference(
  const char* what, const std::vector<T>& found, const std::vector<T>& wanted)
{
  if (found == wanted)
  {
    return "";
  }
  const auto textOf = [](const std::vector<T>& list, std::size_t i)
  { return i < list.size() ? toText(list[i]) : "none"; };
  std::size_t i = 0;
  while (i < found.size() && i < wanted.size() && found[i] == wanted[i])
  {
    ++i;
  }
  return std::to_string(found.size()) + " " + what + " for " + std::to_string(wanted.size()) +
    "; number " + std::to_string(i) + ": " + textOf(found, i) + " for " + textOf(wanted, i);
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
  if (complex.dimension != reference.dimension)
  {
    return "dimension " + std::to_string(complex.dimension) + " for " +
      std::to_string(reference.dimension);
  }
  const Cell ids(complex.pointIds.begin(), complex.pointIds.end());
  std::string fault = firstDifference("points", ids, reference.ids);
  if (fault.empty())
  {
    fault = firstDifference("cells", cellsOf(complex),
      facets == FacetMode::Polygons ? reference.cells : triangulate(reference.cells));
  }
  const std::int64_t end = complex.cellCount() > 0 ? complex.cellBegin(complex.cellCount()) : 0;
  return !fault.empty() ? fault
    : end != static_cast<std::int64_t>(complex.connectivity.size())
    ? "connectivity goes on after the last cell"
    : !complex.offsets.empty() && complex.cellSize != 0 ? "both offsets and cellSize are set"
                                                        : "";
}

std::string bitDifference(const CellComplex& a, const CellComplex& b)
{
  return a.dimension != b.dimension                               ? "dimension"
    : !sameBits(a.pointIds, b.pointIds)                           ? "pointIds"
    : !sameBits(a.connectivity, b.connectivity)                   ? "connectivity"
    : !sameBits(a.offsets, b.offsets) || a.cellSize != b.cellSize ? "offsets or cellSize"
                                                                  : "";
}

std::string bitDifference(const Hull& a, const Hull& b)
{
  const std::string fault =
    bitDifference(static_cast<const CellComplex&>(a), static_cast<const CellComplex&>(b));
  return !fault.empty()                                      ? fault
    : std::memcmp(&a.volume, &b.volume, sizeof(double)) != 0 ? "volume"
    : std::memcmp(&a.area, &b.area, sizeof(double)) != 0     ? "area"
                                                             : "";
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

PointsPerThread::PointsPerThread(std::int64_t count)
{
  pointsPerThread() = count;
}

PointsPerThread::~PointsPerThread()
{
  pointsPerThread() = 1;
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

int randomCases(int count)
{
#if defined(FLIPFLOP_NIGHTLY)
  return effort(count);
#else
  return isSanitized() ? effort(count) : (count + 3) / 4;
#endif
}

std::vector<int> threadsTried()
{
  return isSanitized() ? std::vector<int>{ 1, 4 } : std::vector<int>{ 1, 2, 4 };
}

}
}
