// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Run/Run.h"

#include "Support/PowersOfTwo.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

Run::Run(const PointView& points, std::int64_t least, const PointSource& read,
  const Options& chosen, double pointCost)
  : options(chosen)
  , threads(threadCount(
      chosen.threads, static_cast<std::int64_t>(pointCost * static_cast<double>(points.count))))
  , monitor(chosen)
  , source(read)
{
  requireValid(points, least);
}

bool Run::scanPoints(Statistics& statistics, PointScanner* scanner)
{
  statistics.points = this->source.count();
  statistics.threads = this->threads;
  this->monitor.stage(0.0, 0.1, statistics.points, "scanning");
  PointScanner own;
  const ScanResult found = (scanner ? scanner : &own)->scan(this->source, this->monitor);
  statistics.nonFinite = found.nonFinite;
  if (found.nonFinite && this->options.nonFinite == NonFinitePolicy::Error)
  {
    throw Error(ErrorCode::NonFinite, found.firstNonFinite, found.nonFinite);
  }
  this->checkFinite = found.nonFinite != 0;
  this->range = found.range;
  return found.firstFinite >= 0;
}

void Run::setArithmetic(const Arithmetic& chosen)
{
  this->arithmetic = chosen;
  this->source.setArithmetic(chosen);
  if (chosen.scaleExponent == 0)
  {
    return;
  }
  for (int i = 0; i < 3; ++i)
  {
    const int exponent = this->source.scaleExponent(i);
    this->range.low[i] = std::ldexp(this->range.low[i], exponent);
    this->range.high[i] = std::ldexp(this->range.high[i], exponent);
    this->range.smallest[i] = std::ldexp(this->range.smallest[i], exponent);
  }
}

Lattice Run::findLattice(int axes, int bits)
{
  double extent = 0;
  for (int i = 0; i < axes; ++i)
  {
    extent = std::max(extent, this->range.high[i] - this->range.low[i]);
  }
  Lattice lattice;
  if (!this->arithmetic.wide && extent > 1e-60 && extent < 1e60)
  {
    // With smaller units, exact differences are so small that few neighbours are that near.
    constexpr double small = 0x1p-10;
    const double most = powerOfTwo(exponentOf(extent) + 1 - bits);
    lattice.unit = commonUnit(this->source, small * most, most, this->checkFinite, this->monitor);
    lattice.everywhere = lattice.unit == most;
  }
  return lattice;
}

}
