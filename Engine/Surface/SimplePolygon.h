// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Whether a polygon in the plane is simple: it does not cross or touch itself. Exact.
///
/// A line sweeps over the corners, in lexicographic order, and keeps the sides that it meets in
/// their order along it. Two sides are tested when they become neighbours there. The first position
/// that two sides share has such a pair (M. I. Shamos, D. Hoey, "Geometric intersection problems",
/// 1976).
#ifndef flipflop_SimplePolygon_h
#define flipflop_SimplePolygon_h

#include "Predicates/PlaneOrientation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace flipflop
{

class SimplePolygon
{
public:
  using Position = std::array<double, 2>;

  /// @param positions of the corners, three or more, all finite
  explicit SimplePolygon(const std::vector<Position>& positions)
    : positions(positions)
    , count(positions.size())
  {
  }

  /// Are all corners at different positions, and do two sides share none but a common corner?
  /// @param step called at least once for each corner
  template <class Step>
  bool isSimple(const Step& step) const
  {
    constexpr std::size_t FewSides = 16;
    if (this->count > FewSides)
    {
      return this->sweep(step);
    }
    for (std::size_t a = 0; a < this->count; ++a)
    {
      step();
      for (std::size_t b = 0; b < a; ++b)
      {
        if (this->meet(a, b))
        {
          return false;
        }
      }
    }
    return true;
  }

private:
  std::size_t next(std::size_t corner) const { return corner + 1 < this->count ? corner + 1 : 0; }

  int turn(std::size_t a, std::size_t b, std::size_t c) const
  {
    return planeOrientation(
      this->positions[a].data(), this->positions[b].data(), this->positions[c].data());
  }

  bool isBefore(std::size_t a, std::size_t b) const
  {
    return this->positions[a] < this->positions[b];
  }

  /// The corners of a side, a corner and its next one, in lexicographic order.
  std::pair<std::size_t, std::size_t> ends(std::size_t side) const
  {
    const std::size_t other = this->next(side);
    return this->isBefore(other, side) ? std::make_pair(other, side) : std::make_pair(side, other);
  }

  /// Do two sides share a position that is no common corner?
  bool meet(std::size_t a, std::size_t b) const
  {
    if (this->next(b) == a)
    {
      std::swap(a, b);
    }
    if (this->next(a) == b)
    {
      // They share the corner b: does the second go back over the first?
      const std::size_t end = this->next(b);
      const bool isStraight = this->positions[a] != this->positions[b] &&
        this->positions[b] != this->positions[end] &&
        this->isBefore(a, b) == this->isBefore(b, end);
      return !isStraight && this->turn(a, b, end) == 0;
    }
    const std::size_t c = this->next(a), d = this->next(b);
    const int sides[4] = { this->turn(a, c, b), this->turn(a, c, d), this->turn(b, d, a),
      this->turn(b, d, c) };
    if (std::all_of(sides, sides + 4, [](int side) { return side == 0; }))
    {
      const auto one = this->ends(a), other = this->ends(b);
      return !this->isBefore(one.second, other.first) && !this->isBefore(other.second, one.first);
    }
    return sides[0] * sides[1] <= 0 && sides[2] * sides[3] <= 0;
  }

  /// The order of two sides along the sweeping line; neither is below the other where the one that
  /// begins later begins on the other.
  struct IsBelow
  {
    const SimplePolygon* polygon;

    bool operator()(std::size_t a, std::size_t b) const
    {
      const auto one = this->polygon->ends(a), other = this->polygon->ends(b);
      if (one.first == other.first)
      {
        return this->polygon->turn(one.first, one.second, other.second) > 0;
      }
      return this->polygon->isBefore(one.first, other.first)
        ? this->polygon->turn(one.first, one.second, other.first) > 0
        : this->polygon->turn(other.first, other.second, one.first) < 0;
    }
  };
  using Status = std::set<std::size_t, IsBelow>;

  template <class Step>
  bool sweep(const Step& step) const
  {
    std::vector<std::size_t> corners(this->count);
    std::iota(corners.begin(), corners.end(), std::size_t(0));
    std::sort(corners.begin(), corners.end(),
      [this](std::size_t a, std::size_t b) { return this->isBefore(a, b); });
    const auto areSame = [this](std::size_t a, std::size_t b)
    { return this->positions[a] == this->positions[b]; };
    if (std::adjacent_find(corners.begin(), corners.end(), areSame) != corners.end())
    {
      return false;
    }
    Status status(IsBelow{ this });
    std::vector<typename Status::iterator> at(this->count, status.end()); // by side
    for (const std::size_t corner : corners)
    {
      step();
      const std::size_t sides[2] = { corner > 0 ? corner - 1 : this->count - 1, corner };
      for (const std::size_t side : sides)
      {
        if (this->ends(side).second == corner && !this->remove(status, at[side]))
        {
          return false;
        }
      }
      for (const std::size_t side : sides)
      {
        if (this->ends(side).first == corner && !this->insert(status, side, at[side]))
        {
          return false;
        }
      }
    }
    return true;
  }

  /// @return false: its neighbours meet
  bool remove(Status& status, typename Status::iterator at) const
  {
    const auto after = status.erase(at);
    return after == status.begin() || after == status.end() ||
      !this->meet(*std::prev(after), *after);
  }

  /// @return false: it meets a neighbour
  bool insert(Status& status, std::size_t side, typename Status::iterator& at) const
  {
    const auto inserted = status.insert(side);
    at = inserted.first;
    return inserted.second && (at == status.begin() || !this->meet(*std::prev(at), side)) &&
      (std::next(at) == status.end() || !this->meet(side, *std::next(at)));
  }

  const std::vector<Position>& positions;
  const std::size_t count;
};

}

#endif
