// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Points/Scan.h"

#include "Support/Parallel.h"
#include "Support/VectorClones.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipflop
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t PointsPerTask = std::size_t(1) << 16;

/// The lower of two ids, if there are any.
std::int64_t firstOf(std::int64_t a, std::int64_t b)
{
  return a < 0 ? b : b < 0 ? a : std::min(a, b);
}

void merge(ScanResult& into, const ScanResult& from)
{
  into.range.add(from.range);
  into.nonFinite += from.nonFinite;
  into.firstNonFinite = firstOf(into.firstNonFinite, from.firstNonFinite);
  into.firstFinite = firstOf(into.firstFinite, from.firstFinite);
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
    result.range.add(x);
  }
}

/// As the points lie in memory.
/// @return how many were examined; 0 also when one of them is not finite
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
  ScanResult quick;
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

void ScanSum::add(const PointSource& source, std::uint32_t begin, std::uint32_t end)
{
  // A result of its own, so that the accumulators stay in registers.
  ScanResult part;
  scanRange(source, begin, end, part);
  const std::lock_guard<std::mutex> lock(this->mutex);
  merge(this->sum, part);
}

ScanResult ScanSum::result() const
{
  ScanResult result = this->sum;
  for (int i = 0; i < 3; ++i)
  {
    // Of two zeros, whichever thread came first: only one of them is reported.
    result.range.low[i] += 0.0;
    result.range.high[i] += 0.0;
  }
  if (result.firstFinite < 0)
  {
    result.range = CoordinateRange{};
  }
  return result;
}

ScanResult PointScanner::scan(const PointSource& source, Monitor& monitor)
{
  ScanSum sum;
  eachChunk(source.count(), PointsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      sum.add(source, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end));
      monitor.advance(static_cast<std::int64_t>(end - begin));
    });
  return sum.result();
}

namespace
{

constexpr int UnitBlock = 256;

/// Are all of a block's values multiples of a unit? False also where one is so large that it needs
/// another pass.
template <class Scalar>
inline bool areMultiplesOf(const Scalar* x, int count, double unit)
{
  const double round = 0x1.8p52 * unit;
  const double limit = 0x1p50 * unit;
  double off = 0;
  for (int i = 0; i < count; ++i)
  {
    const double value = static_cast<double>(x[i]);
    // The sum has the unit in its last place, so it loses what is less.
    const double rounded = (value + round) - round;
    off = rounded != value || !(std::fabs(value) < limit) ? 1.0 : off;
  }
  return off == 0.0;
}

FF_VECTOR_CLONES
bool areMultiples(const double* x, int count, double unit)
{
  return areMultiplesOf(x, count, unit);
}

FF_VECTOR_CLONES
bool areMultiples(const float* x, int count, double unit)
{
  return areMultiplesOf(x, count, unit);
}

/// The largest unit of which more and more coordinates are multiples.
class CommonUnit
{
public:
  CommonUnit(const PointSource& source, double least, double most, bool checkFinite)
    : source(source)
    , least(least)
    , checkFinite(checkFinite)
  {
    this->set(most);
  }

  double unit() const { return this->units[0]; }

  /// False: the unit would be less than the least.
  bool add(std::uint32_t id)
  {
    double x[3];
    this->source.load(id, x);
    if (this->checkFinite && !isFinite(x))
    {
      return true;
    }
    while (!isMultiple(x[0], this->units[0]) || !isMultiple(x[1], this->units[1]) ||
      !isMultiple(x[2], this->units[2]))
    {
      if (this->unit() / 2 < this->least)
      {
        return false;
      }
      this->set(this->unit() / 2);
    }
    return true;
  }

  /// Does a block of points need no smaller unit? False also where that needs another pass.
  bool holdsBlock(std::uint32_t first) const
  {
    const void* const packed = this->source.scaleExponent(0) == 0 ? this->source.packed() : nullptr;
    const std::size_t at = std::size_t(3) * first;
    if (packed && this->source.scalarType() == ScalarType::Float64)
    {
      return areMultiples(static_cast<const double*>(packed) + at, 3 * UnitBlock, this->unit());
    }
    if (packed)
    {
      return areMultiples(static_cast<const float*>(packed) + at, 3 * UnitBlock, this->unit());
    }
    double x[3][UnitBlock];
    this->source.load(first, UnitBlock, x[0], x[1], x[2]);
    return areMultiples(x[0], UnitBlock, this->units[0]) &&
      areMultiples(x[1], UnitBlock, this->units[1]) &&
      areMultiples(x[2], UnitBlock, this->units[2]);
  }

private:
  static bool isMultiple(double x, double unit)
  {
    const double units = x / unit;
    // No larger double has a fraction.
    const bool whole =
      std::fabs(units) >= 0x1p53 || static_cast<double>(static_cast<std::int64_t>(units)) == units;
    return whole && (units != 0 || x == 0);
  }

  void set(double unit)
  {
    this->units[0] = this->units[1] = unit;
    this->units[2] = this->source.isWeighted() ? unit * unit : unit;
  }

  const PointSource& source;
  double least;
  bool checkFinite;
  double units[3];
};

}

double commonUnit(
  const PointSource& source, double least, double most, bool checkFinite, Monitor& monitor)
{
  const std::uint32_t count = source.count();
  CommonUnit common(source, least, most, checkFinite);
  // A few points spread over the input suffice nearly always.
  const std::uint32_t step = std::max(1u, count / 64);
  for (std::uint64_t id = 0; id < count; id += step)
  {
    if (!common.add(static_cast<std::uint32_t>(id)))
    {
      return 0;
    }
  }
  for (std::uint64_t first = 0; first < count; first += UnitBlock)
  {
    monitor.poll();
    const std::uint64_t end = std::min<std::uint64_t>(count, first + UnitBlock);
    const bool holds =
      end - first == UnitBlock && common.holdsBlock(static_cast<std::uint32_t>(first));
    for (std::uint64_t id = holds ? end : first; id < end; ++id)
    {
      if (!common.add(static_cast<std::uint32_t>(id)))
      {
        return 0;
      }
    }
  }
  return common.unit();
}

}
