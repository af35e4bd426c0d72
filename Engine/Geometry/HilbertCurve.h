// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What orders of insertion are made of: Hilbert's curve through a box, and random levels.
#ifndef flipflop_HilbertCurve_h
#define flipflop_HilbertCurve_h

#include "Predicates/ErrorBounds.h"
#include "Support/Monitor.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace flipflop
{

/// Steps of Hilbert's curve, four bits of x and of y at once. A quadrant's curve is the whole one
/// with x and y exchanged (bit 0 of the state), or mirrored as well (bit 1).
struct HilbertTable
{
  static constexpr int Bits = 4;
  static constexpr int Side = 1 << Bits;

  struct Step
  {
    std::uint8_t key;
    std::uint8_t state;
  };

  constexpr HilbertTable()
  {
    for (int state = 0; state < 4; ++state)
    {
      for (int index = 0; index < Side * Side; ++index)
      {
        int turned = state;
        int key = 0;
        for (int bit = Bits - 1; bit >= 0; --bit)
        {
          const int mirrored = turned >> 1;
          const int u = (index >> (Bits + bit) & 1) ^ mirrored;
          const int v = (index >> bit & 1) ^ mirrored;
          const int right = turned & 1 ? v : u;
          const int upper = turned & 1 ? u : v;
          key = key << 2 | ((3 * right) ^ upper);
          turned ^= upper ? 0 : (right ? 3 : 1);
        }
        this->step[state][index] = { static_cast<std::uint8_t>(key),
          static_cast<std::uint8_t>(turned) };
      }
    }
  }

  Step step[4][Side * Side] = {};
};

inline constexpr HilbertTable Hilbert;

/// The curve through a box: Hilbert's, of 2^16 steps along the longer side.
class HilbertCurve
{
public:
  HilbertCurve()
  {
    std::fill(this->low, this->low + 2, std::numeric_limits<double>::infinity());
    std::fill(this->high, this->high + 2, -std::numeric_limits<double>::infinity());
  }

  /// Let the box hold a position.
  void add(const double* uv)
  {
    for (int i = 0; i < 2; ++i)
    {
      this->low[i] = std::min(this->low[i], uv[i]);
      this->high[i] = std::max(this->high[i], uv[i]);
    }
  }

  /// Let the box hold another's.
  void add(const HilbertCurve& other)
  {
    this->add(other.low);
    this->add(other.high);
  }

  /// The box is known.
  void prepare()
  {
    // Halved: the whole may overflow. One scale for both axes: in a thin box the points' order
    // along it shows which are near.
    const double half =
      std::max(0.5 * this->high[0] - 0.5 * this->low[0], 0.5 * this->high[1] - 0.5 * this->low[1]);
    this->scale = half > 0 ? 0.5 * Steps / half : 0;
  }

  /// The curve through the squares of a grid with @p side of them along each axis, a power of two,
  /// from the origin on; they are cells.
  static HilbertCurve ofCells(int side)
  {
    HilbertCurve curve;
    const double end = side * (Steps / (Steps + 1));
    const double box[2][2] = { { 0, 0 }, { end, end } };
    curve.add(box[0]);
    curve.add(box[1]);
    curve.prepare();
    return curve;
  }

  /// May a position be in another cell, of so many first bits, if it is off by @p error?
  bool isNearBorder(const double* uv, double error, int bits) const
  {
    const double width = 1 << (16 - (bits + 1) / 2);
    for (int i = 0; i < 2; ++i)
    {
      const double cells = (uv[i] - this->low[i]) * this->scale / width;
      if (!(std::fabs(cells - std::nearbyint(cells)) * width > error * this->scale + StepError))
      {
        return true;
      }
    }
    return false;
  }

  /// Do all positions coincide, or nearly so: their differences halved are zero?
  bool isPoint() const { return !(this->scale > 0); }

  /// How far along the curve a position is. Positions with the same first bits are in one cell of a
  /// quadtree, or in one half of a cell; a cell's steps along each axis are consecutive.
  std::uint32_t at(const double* uv) const
  {
    const std::uint32_t x = this->step(0, uv[0]);
    const std::uint32_t y = this->step(1, uv[1]);
    std::uint32_t key = 0;
    std::uint32_t state = 0;
    for (int bit = 16 - HilbertTable::Bits; bit >= 0; bit -= HilbertTable::Bits)
    {
      constexpr std::uint32_t Mask = HilbertTable::Side - 1;
      const HilbertTable::Step& step =
        Hilbert.step[state][(x >> bit & Mask) << HilbertTable::Bits | (y >> bit & Mask)];
      key = key << 2 * HilbertTable::Bits | step.key;
      state = step.state;
    }
    return key;
  }

private:
  static constexpr double Steps = 65535;

  std::uint32_t step(int axis, double p) const
  {
    const double s = (p - this->low[axis]) * this->scale;
    return static_cast<std::uint32_t>(s > 0 ? (s < Steps ? s : Steps) : 0);
  }

  double low[2];
  double high[2];
  double scale = 0;
};

/// The curve through the box of @p count points.
/// @param load void (i, uv): the position of the i-th
/// @throw Error Aborted
template <class Load>
HilbertCurve curveThrough(std::size_t count, Monitor& monitor, const Load& load)
{
  constexpr std::size_t PointsPerTask = 1 << 14;
  std::vector<HilbertCurve> parts(chunkCount(count, PointsPerTask));
  eachChunk(count, PointsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t number)
    {
      monitor.poll();
      for (std::size_t i = begin; i < end; ++i)
      {
        double uv[2];
        load(i, uv);
        parts[number].add(uv);
      }
    });
  HilbertCurve whole;
  for (const HilbertCurve& part : parts)
  {
    whole.add(part);
  }
  whole.prepare();
  return whole;
}

constexpr std::uint32_t InsertionLevels = 9;

/// Of 8 points 7 are in the last level, of the others as many in the one before, and so on.
inline std::uint32_t insertionLevelOf(std::uint32_t id)
{
  std::uint64_t hash = (id + std::uint64_t(1)) * 0x9E3779B97F4A7C15ull;
  hash = (hash ^ (hash >> 29)) * 0xBF58476D1CE4E5B9ull;
  std::uint32_t level = InsertionLevels - 1;
  for (hash >>= 40; level > 0 && (hash & 7) == 0; hash >>= 3)
  {
    --level;
  }
  return level;
}

}

#endif
