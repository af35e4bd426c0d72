// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What polygons of rounded corners are: convex, simple, or neither. Exact for any finite doubles.
#ifndef flipflop_PlanarRings_h
#define flipflop_PlanarRings_h

#include "Predicates/PlaneOrientation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// The corners of a polygon in order, the last joined to the first: indices of positions.
using Ring = std::vector<std::uint32_t>;

class PlanarRings
{
public:
  using Index = std::uint32_t;

  /// @param positions two for each corner: its x and y
  explicit PlanarRings(const std::vector<double>& positions)
    : positions(positions)
  {
  }

  const double* position(Index v) const { return this->positions.data() + 2 * std::size_t(v); }

  /// Positive when a, b, c turn left.
  int orientation(Index a, Index b, Index c) const
  {
    return planeOrientation(this->position(a), this->position(b), this->position(c));
  }

  /// The order of positions: by x, then y.
  bool before(Index a, Index b) const
  {
    const double* p = this->position(a);
    const double* q = this->position(b);
    return p[0] < q[0] || (p[0] == q[0] && p[1] < q[1]);
  }

  /// Does the way from a to c turn right at b, or go back on itself?
  bool isReflex(Index a, Index b, Index c) const
  {
    const int sign = this->orientation(a, b, c);
    return sign < 0 || (sign == 0 && this->switches(a, b, c));
  }

  /// Once around to the left, without a reflex corner.
  bool isConvex(const Index* ring, std::size_t count) const
  {
    int turns = 0;
    Index a = count > 2 ? ring[count - 2] : 0;
    Index b = count > 2 ? ring[count - 1] : 0;
    for (std::size_t i = 0; count > 2 && i < count; ++i)
    {
      const Index c = ring[i];
      if (this->isReflex(a, b, c))
      {
        return false;
      }
      turns += this->switches(a, b, c) ? 1 : 0;
      a = b;
      b = c;
    }
    return turns == 2;
  }

  /// How often a ring of different corners touches or crosses itself: pairs of edges.
  std::size_t crossings(const Ring& ring) const
  {
    const std::size_t count = ring.size();
    std::vector<Edge> edges(count);
    std::size_t found = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      const Index a = ring[i];
      const Index b = ring[(i + 1) % count];
      const Index c = ring[(i + 2) % count];
      edges[i] = { i, a, b, std::min(this->position(a)[0], this->position(b)[0]),
        std::max(this->position(a)[0], this->position(b)[0]) };
      found += this->switches(a, b, c) && this->orientation(a, b, c) == 0 ? 1 : 0;
    }
    std::sort(
      edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.least < b.least; });
    std::vector<Edge> open; // may meet what comes
    for (const Edge& e : edges)
    {
      open.erase(std::remove_if(open.begin(), open.end(),
                   [&e](const Edge& other) { return other.most < e.least; }),
        open.end());
      for (const Edge& other : open)
      {
        const bool joined =
          (e.index + 1) % count == other.index || (other.index + 1) % count == e.index;
        found += !joined && this->meet(e.a, e.b, other.a, other.b) ? 1 : 0;
      }
      open.push_back(e);
    }
    return found;
  }

  /// Has a ring of different corners its inside on the left at its first position? The orientation,
  /// if it is simple.
  bool isCounterClockwise(const Ring& ring) const
  {
    const std::size_t count = ring.size();
    const std::size_t i =
      static_cast<std::size_t>(std::min_element(ring.begin(), ring.end(),
                                 [this](Index a, Index b) { return this->before(a, b); }) -
        ring.begin());
    return count > 2 &&
      this->orientation(ring[(i + count - 1) % count], ring[i], ring[(i + 1) % count]) > 0;
  }

  bool isSimple(const Ring& ring) const
  {
    return this->isCounterClockwise(ring) && this->crossings(ring) == 0;
  }

private:
  struct Edge
  {
    std::size_t index;
    Index a, b;
    double least, most; ///< x
  };

  /// Does the way go on in the other order of positions?
  bool switches(Index a, Index b, Index c) const
  {
    return this->before(a, b) != this->before(b, c);
  }

  /// Have the edges ab and cd, which share no corner, a point in common?
  bool meet(Index a, Index b, Index c, Index d) const
  {
    for (int k = 0; k < 2; ++k)
    {
      const auto first = std::minmax(this->position(a)[k], this->position(b)[k]);
      const auto second = std::minmax(this->position(c)[k], this->position(d)[k]);
      if (first.second < second.first || second.second < first.first)
      {
        return false;
      }
    }
    return this->orientation(a, b, c) * this->orientation(a, b, d) <= 0 &&
      this->orientation(c, d, a) * this->orientation(c, d, b) <= 0;
  }

  const std::vector<double>& positions;
};

}

#endif
