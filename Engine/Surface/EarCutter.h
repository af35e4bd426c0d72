// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A polygon in the plane, cut into triangles: ear by ear, by exact signs.
///
/// An ear is a corner that turns to the inside, if no other corner is in its closed triangle. Each
/// simple polygon has one, also with corners on straight stretches of its border: the triangulation
/// uses these, too, and no triangle is without area. So cutting ears of a simple polygon ends with
/// all corners used. Of others it may, too: SimplePolygon.h shows which are simple.
#ifndef flipflop_EarCutter_h
#define flipflop_EarCutter_h

#include "Predicates/PlaneOrientation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace flipflop
{

class EarCutter
{
public:
  using Position = std::array<double, 2>;
  using Triangle = std::array<std::size_t, 3>;

  /// Cut a polygon of three or more corners, in either order, all finite.
  /// @param positions    of the corners
  /// @param triangles receives two fewer than there are corners, each with its corners in the
  ///                  polygon's order
  /// @param step      called some times, at least once for each corner that is examined
  /// @return          false: it is not simple, or has no area; true implies neither
  template <class Step>
  bool cut(
    const std::vector<Position>& positions, std::vector<Triangle>& triangles, const Step& step)
  {
    this->positions = &positions;
    const std::size_t count = positions.size();
    this->before.resize(count);
    this->after.resize(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->before[i] = i > 0 ? i - 1 : count - 1;
      this->after[i] = i + 1 < count ? i + 1 : 0;
    }
    // The first of all positions turns to the inside: there a simple polygon has no straight
    // corner.
    const auto first = static_cast<std::size_t>(
      std::min_element(positions.begin(), positions.end()) - positions.begin());
    this->inward = this->turn(this->before[first], first, this->after[first]);
    triangles.clear();
    if (this->inward == 0)
    {
      return false;
    }
    this->blunt.clear();
    for (std::size_t i = 0; i < count; ++i)
    {
      if (!this->turnsInward(i))
      {
        this->blunt.push_back(i);
      }
    }

    std::size_t remaining = count;
    std::size_t missed = 0;
    for (std::size_t i = 0; remaining > 3 && missed < remaining; i = this->after[i])
    {
      if (!this->isEar(i, step))
      {
        ++missed;
        continue;
      }
      this->cutOff(i, triangles);
      --remaining;
      missed = 0;
    }
    const std::size_t last = triangles.empty() ? 0 : triangles.back()[2];
    if (remaining > 3 || !this->turnsInward(last))
    {
      return false;
    }
    triangles.push_back({ this->before[last], last, this->after[last] });
    return true;
  }

private:
  /// Positive: to the left.
  int turn(std::size_t a, std::size_t b, std::size_t c) const
  {
    const std::vector<Position>& p = *this->positions;
    return planeOrientation(p[a].data(), p[b].data(), p[c].data());
  }

  bool turnsInward(std::size_t i) const
  {
    return this->turn(this->before[i], i, this->after[i]) == this->inward;
  }

  template <class Step>
  bool isEar(std::size_t i, const Step& step) const
  {
    step();
    const std::size_t a = this->before[i];
    const std::size_t c = this->after[i];
    if (!this->turnsInward(i))
    {
      return false;
    }
    // If any corner is in the triangle, so is one that does not turn inward.
    return std::none_of(this->blunt.begin(), this->blunt.end(),
      [&](std::size_t k)
      {
        step();
        return k != a && k != i && k != c && this->turn(a, i, k) != -this->inward &&
          this->turn(i, c, k) != -this->inward && this->turn(c, a, k) != -this->inward;
      });
  }

  void cutOff(std::size_t i, std::vector<Triangle>& triangles)
  {
    const std::size_t a = this->before[i];
    const std::size_t c = this->after[i];
    triangles.push_back({ a, i, c });
    this->after[a] = c;
    this->before[c] = a;
    // A corner next to the ear may turn inward now, or run straight.
    for (const std::size_t k : { a, c })
    {
      const auto found = std::find(this->blunt.begin(), this->blunt.end(), k);
      const bool isBlunt = !this->turnsInward(k);
      if (isBlunt && found == this->blunt.end())
      {
        this->blunt.push_back(k);
      }
      else if (!isBlunt && found != this->blunt.end())
      {
        *found = this->blunt.back();
        this->blunt.pop_back();
      }
    }
  }

  const std::vector<Position>* positions = nullptr;
  std::vector<std::size_t> before, after; ///< of the corners that remain
  std::vector<std::size_t> blunt;         ///< corners that do not turn inward
  int inward = 0;                         ///< the turn of a convex corner
};

}

#endif
