// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points alive, ordered so that neighbours in the list are neighbours in space: then a warp's
/// points lie in few cones, and gather few triangles and vertices.
///
///   KeyLive           each point's code along a Morton curve  (and a sort by it)
///   GatherLive        coordinates and ids in that order, and the list
///   GatherUnlocated   behind them, those of the points that were left open
///
/// No result depends on the order of that list, so this is for speed alone.
#ifndef flipflop_OrderKernels_h
#define flipflop_OrderKernels_h

#include "Points/CoordinateRange.h"
#include "Points/Vertex.h"
#include "Rounds/GrowthKernels.h"
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
    const double index = (x[axis] - this->low[axis]) * this->scale[axis];
    const double last = static_cast<double>((1 << this->bitsEach) - 1);
    return static_cast<std::uint32_t>(index > last ? last : index > 0 ? index : 0.0);
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

/// Over all items that the list may have; those past its end go last.
template <class Geometry>
struct KeyLive : Kernel
{
  static constexpr const char* Name = "key live";
  static constexpr int Bytes = 8 + 24 + 8 + 4;
  static constexpr int KeyBits = MortonGrid::CodeBits + 1;
  GrowthData<Geometry> data;
  std::uint32_t turn;
  MortonGrid grid;
  std::uint64_t* keys;
  std::uint32_t* items;

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    this->keys[i] = i < this->data.counters->live[this->turn]
      ? this->grid.codeOf(growth::pointAt(this->data, this->data.live[this->turn][i].index).x)
      : std::uint64_t(1) << MortonGrid::CodeBits;
    this->items[i] = i;
  }
};

/// Over the points alive: to indices in their order.
template <class Geometry>
struct GatherLive : Kernel
{
  static constexpr const char* Name = "gather live";
  static constexpr int Bytes = 4 + 8 + 24 + 24 + 4 + 8;
  GrowthData<Geometry> data;
  std::uint32_t turn; ///< of the list; its other one is written
  const std::uint32_t* items;
  OrderedPoints to;

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    const PointAlive from = this->data.live[this->turn][this->items[i]];
    putInto(this->to, i, growth::pointAt(this->data, from.index));
    this->data.live[this->turn ^ 1][i] = { i, from.triangle };
  }

  FF_HD static void putInto(const OrderedPoints& to, std::uint32_t index, const Vertex& p)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      to.x[3 * std::size_t(index) + static_cast<std::size_t>(axis)] = p.x[axis];
    }
    to.ids[index] = p.id;
  }
};

/// Over the points that were left open: to the indices behind.
template <class Geometry>
struct GatherUnlocated : Kernel
{
  static constexpr const char* Name = "gather unlocated";
  static constexpr int Bytes = 8 + 24 + 24 + 4 + 4;
  GrowthData<Geometry> data;
  std::uint32_t turn;
  OrderedPoints to;

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    PointAlive& point = this->data.unlocated[i];
    const std::uint32_t index = this->data.counters->live[this->turn] + i;
    GatherLive<Geometry>::putInto(this->to, index, growth::pointAt(this->data, point.index));
    point.index = index;
  }
};

}

#endif
