// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Points/LineEnds.h"

#include "Points/Samples.h"
#include "Support/PowersOfTwo.h"

#include <algorithm>

namespace flipflop
{

namespace
{

/// Lines along an axis, by their position in the other two.
class Lines
{
public:
  /// @param bits of the number of slots, of which half are for lines
  Lines(int along, int bits)
    : axis{ along, (along + 1) % 3, (along + 2) % 3 }
    , shift(64 - bits)
    , lines(std::size_t(1) << bits)
  {
  }

  std::uint32_t count() const { return this->used; }

  /// Lines of one point.
  std::uint32_t singles() const
  {
    return static_cast<std::uint32_t>(std::count_if(
      this->lines.begin(), this->lines.end(), [](const Line& line) { return line.points == 1; }));
  }

  void add(const double* x, std::uint32_t id)
  {
    // Zeros of both signs are one position.
    const double u = x[this->axis[1]] + 0.0;
    const double v = x[this->axis[2]] + 0.0;
    const double along = x[this->axis[0]];
    std::uint64_t hash = (bitsOf(u) * 0x9E3779B97F4A7C15ull) ^ bitsOf(v);
    hash = (hash ^ (hash >> 32)) * 0xBF58476D1CE4E5B9ull;
    for (std::size_t slot = hash >> this->shift;; slot = (slot + 1) % this->lines.size())
    {
      Line& line = this->lines[slot];
      if (line.lowId == NoIndex)
      {
        line = { u, v, along, along, id, id, 1 };
        ++this->used;
        return;
      }
      if (line.u == u && line.v == v)
      {
        ++line.points;
        if (along < line.low || (along == line.low && id < line.lowId))
        {
          line.low = along;
          line.lowId = id;
        }
        if (along > line.high || (along == line.high && id < line.highId))
        {
          line.high = along;
          line.highId = id;
        }
        return;
      }
    }
  }

  std::vector<std::uint32_t> ends() const
  {
    std::vector<std::uint32_t> ids;
    for (const Line& line : this->lines)
    {
      if (line.lowId != NoIndex)
      {
        ids.push_back(line.lowId);
        ids.push_back(line.highId);
      }
    }
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
  }

private:
  struct Line
  {
    double u = 0, v = 0;      ///< where it is
    double low = 0, high = 0; ///< its ends
    std::uint32_t lowId = NoIndex, highId = NoIndex;
    std::uint32_t points = 0;
  };

  int axis[3];
  int shift;
  std::vector<Line> lines;
  std::uint32_t used = 0;
};

constexpr int SlotBits = 12; // twice as many slots as lines

/// Are the points of a sample on so few lines along an axis, and few of them alone on one?
/// @param bits of the number of slots, more than @p most
bool hasFewLines(const PointSource& source, int axis, bool checkFinite, std::uint32_t sampled,
  std::uint32_t most, std::uint32_t mostSingles, int bits)
{
  Lines lines(axis, bits);
  for (std::uint32_t i = 0; i < sampled; ++i)
  {
    const std::uint32_t id = sampledIndex(source.count(), sampled, i);
    double x[3];
    source.load(id, x);
    if (!checkFinite || isFinite(x))
    {
      lines.add(x, id);
    }
    if (lines.count() > most)
    {
      return false;
    }
  }
  return lines.singles() <= mostSingles;
}

/// Most inputs show at a look that no two of 64 points are on one. In the last look, the share of
/// single points is the share of lines that the sample has not met.
bool hasFewLines(const PointSource& source, int axis, bool checkFinite, std::uint32_t most)
{
  const std::uint32_t many = std::min(4096u, source.count() / 4);
  return hasFewLines(source, axis, checkFinite, 64, 63, 64, 7) &&
    hasFewLines(source, axis, checkFinite, 1024, std::min(683u, most), 1024, 10) &&
    hasFewLines(source, axis, checkFinite, many, most, many / 24, SlotBits);
}

}

std::vector<std::uint32_t> lineEnds(
  const PointSource& source, std::uint32_t most, bool checkFinite, Monitor& monitor)
{
  constexpr std::uint32_t Least = 4096; // points
  StepPoll poll(monitor);
  for (int axis = 2; axis >= 0 && source.count() >= Least; --axis)
  {
    if (!hasFewLines(source, axis, checkFinite, most))
    {
      continue;
    }
    Lines lines(axis, SlotBits);
    for (std::uint32_t id = 0; id < source.count() && lines.count() <= most; ++id)
    {
      poll.step();
      double x[3];
      source.load(id, x);
      if (!checkFinite || isFinite(x))
      {
        lines.add(x, id);
      }
    }
    if (lines.count() <= most)
    {
      return lines.ends();
    }
  }
  return {};
}

}
