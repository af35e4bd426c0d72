// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The neighbours of each site in a triangulation of any dimension.
#ifndef flipflop_SiteNeighbours_h
#define flipflop_SiteNeighbours_h

#include "Mesh/VertexStars.h"
#include "PowerDiagram/TriangulationInput.h"
#include <flipflop/Buffer.h>
#include <flipflop/CellComplex.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <vector>

namespace flipflop
{

/// The one or two neighbours of each site on a line; NoIndex for none.
using LineNeighbours = std::vector<std::array<std::uint32_t, 2>>;

/// @param t of dimension 1, with indices in range
/// @throw Error BadArgument for a site with three
inline LineNeighbours lineNeighbours(const CellComplex& t)
{
  LineNeighbours neighbours(t.pointIds.size(), { { NoIndex, NoIndex } });
  for (std::size_t h = 0; h < t.connectivity.size(); ++h)
  {
    const auto site = static_cast<std::size_t>(t.connectivity[h]);
    auto& mine = neighbours[site];
    if (mine[1] != NoIndex)
    {
      refuse(t.pointIds[site]);
    }
    mine[mine[0] == NoIndex ? 0 : 1] = static_cast<std::uint32_t>(t.connectivity[h ^ 1]);
  }
  return neighbours;
}

/// The neighbours of each site, as indices of the triangulation's points.
class SiteNeighbours
{
public:
  /// @param triangulation checked by requireCells(); it must live on
  explicit SiteNeighbours(const CellComplex& triangulation)
    : t(triangulation)
  {
    if (triangulation.dimension == 2)
    {
      this->stars.emplace(CellSides(triangulation));
    }
    else if (triangulation.dimension == 1)
    {
      this->onLine = lineNeighbours(triangulation);
    }
  }

  /// Below dimension 2 @p star stays as it is.
  /// @throw Error BadArgument for facets that are not one fan
  void link(std::uint32_t site, Star& star) const
  {
    if (this->stars)
    {
      linkFacets(*this->stars, this->t, site, star);
    }
  }

  /// Counter-clockwise; a ring of facets starts at the first and, at the border, ends at the last.
  /// @param star as linked
  void list(std::uint32_t site, const Star& star, std::vector<std::uint32_t>& found) const
  {
    found.clear();
    if (this->stars)
    {
      for (const std::uint32_t h : star.ring)
      {
        found.push_back(this->stars->destination(h));
      }
      if (!star.isClosed)
      {
        found.push_back(this->stars->source(star.ring.back()));
      }
    }
    else if (!this->onLine.empty())
    {
      std::copy_if(this->onLine[site].begin(), this->onLine[site].end(), std::back_inserter(found),
        [](std::uint32_t other) { return other != NoIndex; });
    }
  }

  /// Null below dimension 2.
  const VertexStars<CellSides>* facets() const { return this->stars ? &*this->stars : nullptr; }

private:
  const CellComplex& t;
  std::optional<VertexStars<CellSides>> stars;
  LineNeighbours onLine;
};

}

#endif
