// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InsertionOrder.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace flipflop
{

namespace
{

struct Keyed
{
  std::uint32_t key; ///< place along the curve
  std::uint32_t id;
};

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
      for (int place = 0; place < Side * Side; ++place)
      {
        int turned = state;
        int key = 0;
        for (int bit = Bits - 1; bit >= 0; --bit)
        {
          const int mirrored = turned >> 1;
          const int u = (place >> (Bits + bit) & 1) ^ mirrored;
          const int v = (place >> bit & 1) ^ mirrored;
          const int right = turned & 1 ? v : u;
          const int upper = turned & 1 ? u : v;
          key = key << 2 | ((3 * right) ^ upper);
          turned ^= upper ? 0 : (right ? 3 : 1);
        }
        this->step[state][place] = { static_cast<std::uint8_t>(key),
          static_cast<std::uint8_t>(turned) };
      }
    }
  }

  Step step[4][Side * Side] = {};
};

constexpr HilbertTable Hilbert;

/// The curve through a box: Hilbert's, of 2^16 steps a side.
class Curve
{
public:
  Curve()
  {
    std::fill(this->low, this->low + 2, std::numeric_limits<double>::infinity());
    std::fill(this->high, this->high + 2, -std::numeric_limits<double>::infinity());
  }

  /// Let the box hold a point.
  void add(double x, double y)
  {
    this->low[0] = std::min(this->low[0], x);
    this->low[1] = std::min(this->low[1], y);
    this->high[0] = std::max(this->high[0], x);
    this->high[1] = std::max(this->high[1], y);
  }

  /// The box is known.
  void prepare()
  {
    for (int i = 0; i < 2; ++i)
    {
      // Halved: the whole may overflow.
      const double half = 0.5 * this->high[i] - 0.5 * this->low[i];
      this->scale[i] = half > 0 ? 0.5 * Steps / half : 0;
    }
  }

  std::uint32_t at(double px, double py) const
  {
    const std::uint32_t x = this->step(0, px);
    const std::uint32_t y = this->step(1, py);
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
    const double s = (p - this->low[axis]) * this->scale[axis];
    return static_cast<std::uint32_t>(s > 0 ? (s < Steps ? s : Steps) : 0);
  }

  double low[2];
  double high[2];
  double scale[2] = { 0, 0 };
};

/// Sort by key. The order of equal keys stays.
void sortByKey(Keyed* keyed, std::size_t count, Buffer<Keyed>& aside)
{
  const auto before = [](const Keyed& a, const Keyed& b) { return a.key < b.key; };
  if (count < 1024)
  {
    std::stable_sort(keyed, keyed + count, before);
    return;
  }
  // By digits, from the least: a comparison sort costs three times as much.
  constexpr int Bits = 11;
  constexpr std::uint32_t Mask = (1u << Bits) - 1;
  if (aside.size() < count)
  {
    aside.allocate(count);
  }
  Keyed* from = keyed;
  Keyed* to = aside.data();
  for (int shift = 0; shift < 32; shift += Bits)
  {
    std::uint32_t begin[Mask + 2] = {};
    for (std::size_t i = 0; i < count; ++i)
    {
      ++begin[(from[i].key >> shift & Mask) + 1];
    }
    for (std::uint32_t digit = 0; digit < Mask; ++digit)
    {
      begin[digit + 1] += begin[digit];
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      to[begin[from[i].key >> shift & Mask]++] = from[i];
    }
    std::swap(from, to);
  }
  std::memcpy(keyed, from, count * sizeof(Keyed)); // an odd number of digits
}

class Sorter
{
public:
  Sorter(const PointSource& points, Monitor& monitor)
    : source(points)
    , poll(monitor)
  {
  }

  /// Sort points along the curve through their own box. Where many share a step of it (clusters, a
  /// far outlier), these are sorted along their own.
  void sort(Keyed* keyed, std::size_t count)
  {
    constexpr std::size_t Many = 32;
    Curve curve;
    double x[3];
    for (std::size_t i = 0; i < count; ++i)
    {
      this->poll.step();
      this->source.load(keyed[i].id, x);
      curve.add(x[0], x[1]);
    }
    curve.prepare();
    std::uint32_t lowest = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t highest = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      this->source.load(keyed[i].id, x);
      keyed[i].key = curve.at(x[0], x[1]);
      lowest = std::min(lowest, keyed[i].key);
      highest = std::max(highest, keyed[i].key);
    }
    if (lowest >= highest)
    {
      return; // one place, or too near each other for differences
    }
    sortByKey(keyed, count, this->aside);
    for (std::size_t begin = 0, end = 0; begin < count; begin = end)
    {
      this->poll.step();
      while (end < count && keyed[end].key == keyed[begin].key)
      {
        ++end;
      }
      if (end - begin > Many)
      {
        this->sort(keyed + begin, end - begin);
      }
    }
  }

private:
  const PointSource& source;
  StepPoll poll;
  Buffer<Keyed> aside;
};

constexpr int Levels = 9;

/// Of 8 points 7 are in level 0, of the others as many in level 1, and so on.
int levelOf(std::uint32_t id)
{
  std::uint64_t hash = (id + std::uint64_t(1)) * 0x9E3779B97F4A7C15ull;
  hash = (hash ^ (hash >> 29)) * 0xBF58476D1CE4E5B9ull;
  int level = 0;
  for (hash >>= 40; level < Levels - 1 && (hash & 7) == 0; hash >>= 3)
  {
    ++level;
  }
  return level;
}

}

InsertionOrder insertionOrder(const PointSource& source, bool skipNonFinite,
  const std::vector<std::uint32_t>& without, Monitor& monitor)
{
  Buffer<Keyed> keyed(source.count());
  std::size_t count = 0;
  std::size_t levelBegin[Levels + 1] = {}; ///< from the highest level on
  for (std::uint32_t id = 0; id < source.count(); ++id)
  {
    if (std::find(without.begin(), without.end(), id) != without.end())
    {
      continue;
    }
    if (skipNonFinite)
    {
      double x[3];
      source.load(id, x);
      if (!isFinite(x))
      {
        continue;
      }
    }
    keyed[count++].id = id;
    ++levelBegin[Levels - levelOf(id)];
  }
  Sorter(source, monitor).sort(keyed.data(), count);
  for (int i = 0; i < Levels; ++i)
  {
    levelBegin[i + 1] += levelBegin[i];
  }
  InsertionOrder order;
  order.ids.allocate(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    order.ids[levelBegin[Levels - 1 - levelOf(keyed[i].id)]++] = keyed[i].id;
  }
  // Where a level began, it ends now.
  for (int i = 0; i < Levels; ++i)
  {
    order.levelEnds.push_back(static_cast<std::uint32_t>(levelBegin[i]));
  }
  return order;
}

}
