// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A triangulation of dimension 1 as queries search it: the sites along their line, and the
/// segments between them. Power cells are strips in the same order.
#ifndef flipflop_SiteChain_h
#define flipflop_SiteChain_h

#include "Query/Sites.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>
#include <flipflop/Triangulation.h>
#include <flipflop/Validate.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace flipflop
{

/// The sites that a position is at, or between: two of one index, where it is at a site.
struct ChainLocation
{
  std::uint32_t from = NoIndex; ///< index of a site; NoIndex: off the chain
  std::uint32_t to = NoIndex;
  std::uint32_t cell = NoIndex; ///< of several the lowest; NoIndex: off the chain
};

class SiteChain
{
public:
  /// Order the sites, and check by exact signs that the triangulation is theirs.
  /// @param vertices      of the triangulation's points, by index, which must outlive the chain
  /// @param geometry      of them
  /// @param triangulation of dimension 1, after requireCells
  /// @return NotExtreme, WrongDimension: a point that is not above its neighbours' chord, or not on
  ///         their line; NotClosed: a cell that does not join neighbours; or -1: one is missing
  /// @throw Error OutOfMemory, Aborted
  Validation make(const Vertex* vertices, const LiftedGeometry<true>& geometry,
    const Triangulation& triangulation, Monitor& monitor);

  /// @param numbers of the cells from now on; NoIndex: a position that only this cell holds is off
  ///                the chain
  void renumberCells(const Buffer<std::uint32_t>& numbers);

  /// @param space of the query
  template <class Space>
  ChainLocation locate(const Space& space) const
  {
    const Vertex& p = space.query;
    const auto begin = this->along.begin();
    const auto end = this->along.end();
    const auto after = std::lower_bound(
      begin, end, p, [&](std::uint32_t i, const Vertex& q) { return precedes(space.site(i), q); });
    if (after == end ||
      space.geometry.orient(space.site(*begin), space.site(*(end - 1)), space.query) != 0)
    {
      return ChainLocation();
    }
    const std::size_t at = static_cast<std::size_t>(after - begin);
    const std::uint32_t before = at > 0 ? this->cells[at - 1] : NoIndex;
    ChainLocation found;
    if (Sites::Geometry::samePlanePosition(space.site(*after), p))
    {
      const std::uint32_t next = at < this->cells.size() ? this->cells[at] : NoIndex;
      found = { *after, *after, std::min(before, next) };
    }
    else if (at > 0)
    {
      found = { *(after - 1), *after, before };
    }
    return found.cell == NoIndex ? ChainLocation() : found;
  }

  /// The index of the nearest site.
  template <class Space>
  std::uint32_t nearest(const Space& space) const
  {
    const auto order = [&space](std::uint32_t a, std::uint32_t b)
    { return space.geometry.comparePowers(space.query, space.site(a), space.site(b)); };
    // As long as the next one is nearer, the next one's strip is further on.
    std::size_t low = 0;
    for (std::size_t high = this->along.size() - 1; low < high;)
    {
      const std::size_t middle = low + (high - low) / 2;
      const bool further = order(this->along[middle + 1], this->along[middle]) < 0;
      low = further ? middle + 1 : low;
      high = further ? high : middle;
    }
    const std::uint32_t found = this->along[low];
    const bool level = low + 1 < this->along.size() && order(found, this->along[low + 1]) == 0;
    return level ? std::min(found, this->along[low + 1]) : found;
  }

private:
  /// The order along a line.
  static bool precedes(const Vertex& a, const Vertex& b)
  {
    return a.x[0] != b.x[0] ? a.x[0] < b.x[0] : a.x[1] < b.x[1];
  }

  Buffer<std::uint32_t> along; ///< indices of sites
  Buffer<std::uint32_t> cells; ///< from each site to the next; NoIndex: none
};

}

#endif
