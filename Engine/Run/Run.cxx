// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Run/Run.h"

#include "Points/ScaledRange.h"

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
  this->range =
    scaledRange(this->range, [this](int axis) { return this->source.scaleExponent(axis); });
}

Lattice Run::findLattice(int axes, int bits)
{
  return latticeWithin(this->range, axes, this->arithmetic, bits,
    [this](double least, double most)
    { return commonUnit(this->source, least, most, this->checkFinite, this->monitor); });
}

}
