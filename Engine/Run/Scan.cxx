// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Run/Scan.h"

#include "Geometry/HullGeometry.h"
#include "Support/Parallel.h"
#include "Support/VectorClones.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace flipflop
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t PollEvery = 1 << 16;

ScanResult emptyScan()
{
  ScanResult result;
  for (int i = 0; i < 3; ++i)
  {
    result.range.low[i] = Infinity;
    result.range.high[i] = -Infinity;
    result.range.smallest[i] = Infinity;
  }
  return result;
}

void merge(ScanResult& into, const ScanResult& from)
{
  for (int i = 0; i < 3; ++i)
  {
    into.range.low[i] = std::min(into.range.low[i], from.range.low[i]);
    into.range.high[i] = std::max(into.range.high[i], from.range.high[i]);
    into.range.smallest[i] = std::min(into.range.smallest[i], from.range.smallest[i]);
  }
  into.nonFinite += from.nonFinite;
  if (into.firstNonFinite < 0)
  {
    into.firstNonFinite = from.firstNonFinite;
  }
  if (into.firstFinite < 0)
  {
    into.firstFinite = from.firstFinite;
  }
}

/// Slots are accumulators of their own, so that a loop over them fills vector registers; slot k
/// sees axis k % Axes.
constexpr int Slots = 24;

/// Ranges over values that lie axis by axis in turn: x y z x y z ..., or one axis alone.
/// @return false when one of them is not finite: then the results are worthless
template <int Axes, class Scalar>
inline bool scanSlots(const Scalar* p, std::size_t groups, int firstAxis, CoordinateRange& range)
{
  double low[Slots], high[Slots], smallest[Slots], notFinite[Slots];
  for (int k = 0; k < Slots; ++k)
  {
    low[k] = Infinity;
    high[k] = -Infinity;
    smallest[k] = Infinity;
    notFinite[k] = 0;
  }
  for (std::size_t g = 0; g < groups; ++g, p += Slots)
  {
    for (int k = 0; k < Slots; ++k)
    {
      const double x = static_cast<double>(p[k]);
      const double magnitude = std::fabs(x);
      const double nonZero = magnitude > 0 ? magnitude : Infinity;
      low[k] = x < low[k] ? x : low[k];
      high[k] = x > high[k] ? x : high[k];
      smallest[k] = nonZero < smallest[k] ? nonZero : smallest[k];
      notFinite[k] += x * 0.0; // NaN from NaN or infinity on
    }
  }
  double sum = 0;
  for (int k = 0; k < Slots; ++k)
  {
    const int axis = firstAxis + k % Axes;
    range.low[axis] = std::min(range.low[axis], low[k]);
    range.high[axis] = std::max(range.high[axis], high[k]);
    range.smallest[axis] = std::min(range.smallest[axis], smallest[k]);
    sum += notFinite[k];
  }
  return sum == 0.0;
}

FF_VECTOR_CLONES
bool scanDoubles(const double* p, std::size_t groups, CoordinateRange& range)
{
  return scanSlots<3>(p, groups, 0, range);
}

FF_VECTOR_CLONES
bool scanFloats(const float* p, std::size_t groups, CoordinateRange& range)
{
  return scanSlots<3>(p, groups, 0, range);
}

FF_VECTOR_CLONES
bool scanAxis(const double* p, std::size_t groups, int axis, CoordinateRange& range)
{
  return scanSlots<1>(p, groups, axis, range);
}

/// Point by point, for any stride and whatever is not finite.
void scanOneByOne(
  const PointSource& source, std::uint32_t begin, std::uint32_t end, ScanResult& result)
{
  for (std::uint32_t id = begin; id < end; ++id)
  {
    double x[3];
    source.load(id, x);
    if (!isFinite(x))
    {
      ++result.nonFinite;
      result.firstNonFinite = result.firstNonFinite < 0 ? id : result.firstNonFinite;
      continue;
    }
    result.firstFinite = result.firstFinite < 0 ? id : result.firstFinite;
    for (int i = 0; i < 3; ++i)
    {
      const double magnitude = std::fabs(x[i]);
      result.range.low[i] = std::min(result.range.low[i], x[i]);
      result.range.high[i] = std::max(result.range.high[i], x[i]);
      result.range.smallest[i] =
        magnitude > 0 ? std::min(result.range.smallest[i], magnitude) : result.range.smallest[i];
    }
  }
}

/// As the points lie in memory.
/// @return how many were looked at; 0 also when one of them is not finite
std::uint32_t scanPacked(
  const PointSource& source, std::uint32_t begin, std::uint32_t end, CoordinateRange& range)
{
  const void* packed = source.packed();
  const std::size_t groups = packed ? std::size_t(3) * (end - begin) / Slots : 0;
  const std::size_t at = std::size_t(3) * begin;
  const bool finite = groups > 0 &&
    (source.scalarType() == ScalarType::Float64
        ? scanDoubles(static_cast<const double*>(packed) + at, groups, range)
        : scanFloats(static_cast<const float*>(packed) + at, groups, range));
  return finite ? static_cast<std::uint32_t>(groups * Slots / 3) : 0;
}

/// Axis by axis, copied out in blocks that stay in the cache.
/// @return as scanPacked
std::uint32_t scanAxes(
  const PointSource& source, std::uint32_t begin, std::uint32_t end, CoordinateRange& range)
{
  constexpr int Block = 16 * Slots;
  double x[3][Block];
  std::uint32_t done = 0;
  for (; end - begin - done >= Block; done += Block)
  {
    source.load(begin + done, Block, x[0], x[1], x[2]);
    for (int axis = 0; axis < 3; ++axis)
    {
      if (!scanAxis(x[axis], Block / Slots, axis, range))
      {
        return 0;
      }
    }
  }
  return done;
}

void scanRange(
  const PointSource& source, std::uint32_t begin, std::uint32_t end, ScanResult& result)
{
  ScanResult quick = emptyScan();
  const std::uint32_t done = source.packed() ? scanPacked(source, begin, end, quick.range)
                                             : scanAxes(source, begin, end, quick.range);
  if (done > 0)
  {
    quick.firstFinite = begin;
    merge(result, quick);
  }
  scanOneByOne(source, begin + done, end, result);
}

}

ScanResult scan(const PointSource& source, int threads, Monitor& monitor)
{
  const std::uint32_t count = source.count();
  const std::uint32_t chunkCount =
    std::max(1u, std::min(4 * static_cast<std::uint32_t>(threads), count / PollEvery));
  std::vector<ScanResult> results(chunkCount, emptyScan());
  eachTask(chunkCount,
    [&](std::size_t chunk)
    {
      const std::uint32_t chunkEnd = partBegin(count, chunkCount, chunk + 1);
      // In pieces, each a result of its own, so that the accumulators stay in registers.
      for (std::uint32_t begin = partBegin(count, chunkCount, chunk); begin < chunkEnd;)
      {
        const std::uint32_t end = begin + std::min(PollEvery, chunkEnd - begin);
        ScanResult piece = emptyScan();
        scanRange(source, begin, end, piece);
        merge(results[chunk], piece);
        monitor.advance(end - begin);
        begin = end;
      }
    });
  ScanResult result = emptyScan();
  for (const ScanResult& chunk : results)
  {
    merge(result, chunk);
  }
  if (result.firstFinite < 0)
  {
    result.range = CoordinateRange{};
  }
  return result;
}

double commonUnit(
  const PointSource& source, double least, double most, bool checkFinite, Monitor& monitor)
{
  const auto isMultiple = [](double x, double unit)
  {
    const double units = x / unit;
    // No larger double has a fraction.
    const bool whole =
      std::fabs(units) >= 0x1p53 || static_cast<double>(static_cast<std::int64_t>(units)) == units;
    return whole && (units != 0 || x == 0);
  };
  StepPoll poll(monitor);
  const std::uint32_t count = source.count();
  double unit = most;
  double units[3] = { unit, unit, source.isWeighted() ? unit * unit : unit };
  // A few points spread over the input tell nearly always.
  for (int pass = 0; pass < 2; ++pass)
  {
    const std::uint32_t step = pass ? 1 : std::max(1u, count / 64);
    for (std::uint64_t id = 0; id < count; id += step)
    {
      poll.step();
      double x[3];
      source.load(static_cast<std::uint32_t>(id), x);
      if (checkFinite && !isFinite(x))
      {
        continue;
      }
      while (
        !isMultiple(x[0], units[0]) || !isMultiple(x[1], units[1]) || !isMultiple(x[2], units[2]))
      {
        unit /= 2;
        if (unit < least)
        {
          return 0;
        }
        units[0] = units[1] = unit;
        units[2] = source.isWeighted() ? unit * unit : unit;
      }
    }
  }
  return unit;
}

namespace
{

/// Looks for points ever farther from what is spanned so far. Distances are rounded and only choose
/// among candidates; independence is exact.
class SpanSearch
{
public:
  SpanSearch(const HullGeometry& geometry, const PointSource& source, int most, bool checkFinite,
    Monitor& monitor)
    : geometry(geometry)
    , source(source)
    , most(most)
    , checkFinite(checkFinite)
    , monitor(monitor)
  {
  }

  Span span;

  /// Extend the span by points among @p ids (null: all).
  void extend(const std::uint32_t* ids, std::uint32_t count)
  {
    while (this->span.dimension < this->most && this->extendOnce(ids, count))
    {
    }
  }

private:
  bool extendOnce(const std::uint32_t* ids, std::uint32_t count)
  {
    bool found = false;
    double best = -1;
    Vertex bestVertex{};
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const Vertex p = this->source.vertex(ids ? ids[i] : i);
      if ((i & (PollEvery - 1)) == 0)
      {
        this->monitor.poll();
      }
      if (this->checkFinite && !isFinite(p.x))
      {
        continue;
      }
      const double far = this->distance(p);
      if ((!found || far > best) && this->isIndependent(p))
      {
        found = true;
        best = far;
        bestVertex = p;
      }
    }
    if (found)
    {
      ++this->span.dimension;
      this->span.ids[this->span.dimension] = bestVertex.id;
      this->corner[this->span.dimension] = bestVertex;
      for (int i = 0; i < 3; ++i)
      {
        this->edge[this->span.dimension][i] = bestVertex.x[i] - this->corner[0].x[i];
      }
    }
    return found;
  }

  bool isIndependent(const Vertex& p) const
  {
    for (int k = 0; k <= this->span.dimension; ++k)
    {
      if (this->corner[k].id == p.id)
      {
        return false; // as exact arithmetic would find out
      }
    }
    switch (this->span.dimension)
    {
      case -1:
        return true;
      case 0:
        return !samePosition(this->corner[0], p);
      case 1:
        return !this->geometry.collinear(this->corner[0], this->corner[1], p);
      default:
        return this->geometry.above(this->corner[0], this->corner[1], this->corner[2], p) != 0;
    }
  }

  /// Some measure of how far p is from the span; overflow and underflow only make it a worse one.
  double distance(const Vertex& p) const
  {
    const double u[3] = { p.x[0] - this->corner[0].x[0], p.x[1] - this->corner[0].x[1],
      p.x[2] - this->corner[0].x[2] };
    const double* const v = this->edge[1];
    const double* const w = this->edge[2];
    switch (this->span.dimension)
    {
      case -1:
        return -p.x[0];
      case 0:
        return largestOf(u[0], u[1], u[2]);
      case 1:
        return largestOf(
          u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
      default:
        return std::fabs(u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
          u[2] * (v[0] * w[1] - v[1] * w[0]));
    }
  }

  const HullGeometry& geometry;
  const PointSource& source;
  int most;
  bool checkFinite;
  Monitor& monitor;
  Vertex corner[4] = {};
  double edge[4][3] = {}; ///< from the first corner
};

}

Span findSpan(const HullGeometry& geometry, const PointSource& source, const std::uint32_t* ids,
  std::uint32_t count, int most, bool checkFinite, Monitor& monitor)
{
  SpanSearch search(geometry, source, most, checkFinite, monitor);
  search.extend(ids, count);
  if (search.span.dimension < most && ids)
  {
    search.extend(nullptr, source.count());
  }
  return search.span;
}

}
