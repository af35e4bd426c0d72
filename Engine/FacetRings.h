// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The facets around each vertex of a planar complex, counter-clockwise.
#ifndef flipflop_FacetRings_h
#define flipflop_FacetRings_h

#include "Triangulation.h"
#include "Vertex.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// A half-edge is a place in the connectivity: it leaves the corner there. All indices must be in
/// range, and below NoIndex; whatever else is wrong with a complex, walk() finds.
class FacetRings
{
public:
  explicit FacetRings(const Triangulation& triangulation)
    : t(triangulation)
    , facets(t.connectivity.size())
    , starts(t.pointIds.size() + 1)
    , leaving(t.connectivity.size())
    , towards(t.pointIds.size())
  {
    for (std::int64_t c = 0; c < t.cellCount(); ++c)
    {
      std::fill(this->facets.begin() + t.cellBegin(c), this->facets.begin() + t.cellBegin(c + 1),
        static_cast<std::uint32_t>(c));
    }
    std::fill(this->starts.begin(), this->starts.end(), 0);
    std::fill(this->towards.begin(), this->towards.end(), NoIndex);
    for (const std::int64_t site : t.connectivity)
    {
      ++this->starts[static_cast<std::size_t>(site)];
    }
    std::uint32_t end = 0;
    for (std::uint32_t& start : this->starts)
    {
      end += start;
      start = end;
    }
    for (std::size_t h = t.connectivity.size(); h-- > 0;)
    {
      this->leaving[--this->starts[static_cast<std::size_t>(t.connectivity[h])]] =
        static_cast<std::uint32_t>(h);
    }
  }

  /// The half-edges that leave @p site, in the order of their facets around it: from the lowest
  /// facet on, or, at the border, from the first on. Returns whether the ring is closed.
  bool walk(std::uint32_t site, std::vector<std::uint32_t>& ring)
  {
    const std::uint32_t begin = this->starts[site];
    const std::uint32_t end = this->starts[site + 1];
    for (std::uint32_t i = begin; i < end; ++i)
    {
      this->towards[this->destination(this->leaving[i])] = i;
    }
    this->follows.assign(end - begin, 0);
    for (std::uint32_t i = begin; i < end; ++i)
    {
      const std::uint32_t next = this->following(site, i);
      if (next != NoIndex && this->follows[next - begin]++ != 0)
      {
        throw Error(ErrorCode::BadArgument, this->t.pointIds[site]);
      }
    }
    // At the border one facet follows no other.
    const auto border = std::find(this->follows.begin(), this->follows.end(), 0);
    const bool closed = border == this->follows.end();
    const std::uint32_t first =
      closed ? begin : begin + static_cast<std::uint32_t>(border - this->follows.begin());
    ring.clear();
    std::uint32_t i = begin < end ? first : NoIndex;
    while (i != NoIndex && (ring.empty() || i != first))
    {
      ring.push_back(this->leaving[i]);
      i = this->following(site, i);
    }
    // None, or several rings around one site: no triangulation.
    if (ring.empty() || ring.size() != end - begin)
    {
      throw Error(ErrorCode::BadArgument, this->t.pointIds[site]);
    }
    return closed;
  }

  std::uint32_t facet(std::uint32_t h) const { return this->facets[h]; }

  std::uint32_t destination(std::uint32_t h) const
  {
    const std::int64_t c = this->facets[h];
    const std::int64_t next = h + std::int64_t(1);
    return this->site(next == t.cellBegin(c + 1) ? t.cellBegin(c) : next);
  }

  /// Where the half-edge before @p h comes from.
  std::uint32_t source(std::uint32_t h) const
  {
    const std::int64_t c = this->facets[h];
    return this->site((h == t.cellBegin(c) ? t.cellBegin(c + 1) : h) - 1);
  }

private:
  std::uint32_t site(std::int64_t h) const
  {
    return static_cast<std::uint32_t>(this->t.connectivity[static_cast<std::size_t>(h)]);
  }

  /// The place in leaving of the half-edge after the one at @p i.
  std::uint32_t following(std::uint32_t site, std::uint32_t i) const
  {
    const std::uint32_t found = this->towards[this->source(this->leaving[i])];
    // What another site left in the table does not count.
    return found >= this->starts[site] && found < this->starts[site + 1] ? found : NoIndex;
  }

  const Triangulation& t;
  Buffer<std::uint32_t> facets;  ///< of each half-edge
  Buffer<std::uint32_t> starts;  ///< of each site, in leaving
  Buffer<std::uint32_t> leaving; ///< half-edges by site, ascending
  Buffer<std::uint32_t> towards; ///< for each site: where in leaving, from the last that saw it
  std::vector<unsigned char> follows;
};

}

#endif
