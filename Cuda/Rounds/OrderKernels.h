// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points alive, ordered so that neighbours in the list are neighbours in space: then a warp's
/// points lie in few cones, and gather few triangles and vertices.
///
///   KeyLive      each point's place along a Morton curve  (and a sort by it)
///   GatherLive   the list in that order
///
/// No result depends on the order of that list, so this is for speed alone.
#ifndef flipflop_OrderKernels_h
#define flipflop_OrderKernels_h

#include "Points/CoordinateRange.h"
#include "Points/Vertex.h"
#include "Rounds/Kernel.h"

#include <cstdint>

namespace flipflop
{

/// A grid over the range of all points.
struct MortonGrid
{
  static constexpr int CodeBits = 30;

  /// @param axisCount 2 or 3
  MortonGrid(const CoordinateRange& range, int axisCount)
    : axes(axisCount)
    , bitsEach(CodeBits / axisCount)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double extent = range.high[axis] - range.low[axis];
      const double perUnit = static_cast<double>(1 << this->bitsEach) / extent;
      this->low[axis] = range.low[axis];
      // Where there is no such number, all are in one cell.
      this->scale[axis] = extent > 0 && perUnit < 1e300 ? perUnit : 0.0;
    }
  }

  FF_HD std::uint32_t codeOf(const double* x) const
  {
    const std::uint32_t a = this->cellOf(x, 0);
    const std::uint32_t b = this->cellOf(x, 1);
    return this->axes == 2
      ? everySecond(a) | everySecond(b) << 1
      : everyThird(a) | everyThird(b) << 1 | everyThird(this->cellOf(x, 2)) << 2;
  }

private:
  FF_HD std::uint32_t cellOf(const double* x, int axis) const
  {
    const double place = (x[axis] - this->low[axis]) * this->scale[axis];
    const double last = static_cast<double>((1 << this->bitsEach) - 1);
    return static_cast<std::uint32_t>(place > last ? last : place > 0 ? place : 0.0);
  }

  /// The lowest 16 bits, each with a gap behind it.
  FF_HD static std::uint32_t everySecond(std::uint32_t bits)
  {
    bits = (bits | bits << 8) & 0x00FF00FFu;
    bits = (bits | bits << 4) & 0x0F0F0F0Fu;
    bits = (bits | bits << 2) & 0x33333333u;
    return (bits | bits << 1) & 0x55555555u;
  }

  /// The lowest 10 bits, each with two gaps behind it.
  FF_HD static std::uint32_t everyThird(std::uint32_t bits)
  {
    bits = (bits | bits << 16) & 0x030000FFu;
    bits = (bits | bits << 8) & 0x0300F00Fu;
    bits = (bits | bits << 4) & 0x030C30C3u;
    return (bits | bits << 2) & 0x09249249u;
  }

  int axes;
  int bitsEach;
  double low[3];
  double scale[3];
};

/// Over all places that the list may have; those past its end go last.
struct KeyLive : Kernel
{
  static constexpr const char* Name = "key live";
  static constexpr int Bytes = 24 + 8 + 4;
  static constexpr int KeyBits = MortonGrid::CodeBits + 1;
  MortonGrid grid;
  const Vertex* live;
  const std::uint32_t* count;
  std::uint64_t* keys;
  std::uint32_t* places;

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    this->keys[i] = i < *this->count ? this->grid.codeOf(this->live[i].x)
                                     : std::uint64_t(1) << MortonGrid::CodeBits;
    this->places[i] = i;
  }
};

/// Over the points alive.
struct GatherLive : Kernel
{
  static constexpr const char* Name = "gather live";
  static constexpr int Bytes = 4 + 32 + 32;
  const Vertex* from;
  const std::uint32_t* places;
  Vertex* to;

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    this->to[i] = this->from[this->places[i]];
  }
};

}

#endif
