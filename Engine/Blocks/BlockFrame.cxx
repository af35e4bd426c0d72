// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/BlockFrame.h"

#include "Blocks/BlockSummary.h"
#include "Points/PointSource.h"
#include <flipflop/ConvexHull.h>
#include <flipflop/RegularTriangulation.h>

#include <algorithm>
#include <cmath>

namespace flipflop
{

CellComplex cellsOf(BlockShape shape, const std::vector<BlockSite>& sites, const Options& chosen)
{
  Options options = chosen;
  options.facets = FacetMode::Polygons;
  if (shape == BlockShape::Hull)
  {
    return convexHull(viewOf(sites), options);
  }
  return regularTriangulation(viewOf(sites), weightsOf(shape, sites), options);
}

Options quiet(const Options& chosen)
{
  Options result = chosen;
  result.step = nullptr;
  if (chosen.progress)
  {
    result.progress = [](double, void* context)
    {
      const auto& options = *static_cast<const Options*>(context);
      return options.progress(1.0, options.progressContext);
    };
    result.progressContext = const_cast<Options*>(&chosen);
  }
  return result;
}

BlockFrame::BlockFrame(
  BlockShape ofShape, const std::vector<BlockMessage>& summaries, const Options& options)
  : shape(ofShape)
  , blocks(static_cast<int>(summaries.size()))
  , range(CoordinateRange::empty())
{
  for (std::size_t block = 0; block < summaries.size(); ++block)
  {
    const BlockSummary summary(summaries[block]);
    for (BlockSite site : summary.sample)
    {
      site.block = static_cast<std::int32_t>(block);
      this->sample.push_back(site);
    }
    for (BlockPatch patch : summary.patches)
    {
      patch.block = static_cast<std::int64_t>(block);
      this->patches.push_back(patch);
    }
    this->range.add(summary.range);
  }
  if (this->sample.empty())
  {
    return;
  }
  std::sort(this->sample.begin(), this->sample.end(), hasLowerId);
  this->arithmetic =
    this->isLifted() ? chooseLiftedArithmetic(this->range) : chooseArithmetic(this->range);
  for (double* const ends : { this->range.low, this->range.high, this->range.smallest })
  {
    this->scale(ends);
  }
  for (BlockSite& site : this->sample)
  {
    this->scale(site.x);
    ensure(this->holds(site.x));
  }
  for (BlockPatch& patch : this->patches)
  {
    for (double* const x : { patch.box.low, patch.box.high, patch.origin })
    {
      this->scale(x);
      ensure(isFinite(x));
    }
    for (double* const x : { &patch.low, &patch.high, &patch.radius })
    {
      *x = std::ldexp(*x, this->arithmetic.scaleExponent);
    }
  }
  this->dimension = cellsOf(this->shape, this->sample, quiet(options)).dimension;
}

void BlockFrame::scale(double* x, int sign) const
{
  const int exponent = sign * this->arithmetic.scaleExponent;
  for (int i = 0; exponent != 0 && i < 3; ++i)
  {
    x[i] = std::ldexp(x[i], this->isLifted() && i == 2 ? 2 * exponent : exponent);
  }
}

bool BlockFrame::holds(const double* x) const
{
  bool isHeld = true;
  for (int i = 0; i < 3; ++i)
  {
    // The two axes of the plane have one scale, and a point off a line has the other's numbers.
    const int other = this->isLifted() && i < 2 ? 1 - i : i;
    const double low = std::min(this->range.low[i], this->range.low[other]);
    const double high = std::max(this->range.high[i], this->range.high[other]);
    const double smallest = std::min(this->range.smallest[i], this->range.smallest[other]);
    isHeld = isHeld && x[i] >= low && x[i] <= high && (x[i] == 0 || std::fabs(x[i]) >= smallest);
  }
  return isHeld;
}

ConflictBound BlockFrame::boundOf(const double* a, const double* b, const double* c) const
{
  if (this->arithmetic.wide)
  {
    return ConflictBound(); // its arithmetic would overflow
  }
  return !c            ? ConflictBound::ofEdge(a, b)
    : this->isLifted() ? ConflictBound::ofCircle(a, b, c)
                       : ConflictBound::ofPlane(a, b, c);
}

BlockSite BlockFrame::pointOffLine() const
{
  const double* const u = this->sample.front().x;
  const auto other = std::find_if(this->sample.begin(), this->sample.end(),
    [u](const BlockSite& site) { return site.x[0] != u[0] || site.x[1] != u[1]; });
  ensure(other != this->sample.end());
  const double* const v = other->x;
  BlockSite result{ { u[0], u[1], u[2] }, NoBlockId, NoBlock, 0 };
  // The line has no other point with the x of u; or, if it is upright, none with the y of u. Its
  // new coordinate is one that a point has, so the arithmetic stays what it is.
  const int axis = u[0] != v[0] ? 1 : 0;
  const double values[3] = { v[axis], u[1 - axis], v[1 - axis] };
  result.x[axis] = *std::find_if(values, values + 3, [&](double x) { return x != u[axis]; });
  return result;
}

}
