// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A caller's triangulation, looked over before it is used: ids and indices are in range, and cells
/// have as many corners as the dimension says. What else is wrong with it, the use must find.
#ifndef flipflop_TriangulationInput_h
#define flipflop_TriangulationInput_h

#include "Mesh/VertexStars.h"
#include "Points/PointSource.h"
#include "PowerDiagram/PowerCorners.h"
#include "Support/Parallel.h"
#include <flipflop/Buffer.h>
#include <flipflop/Triangulation.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace flipflop
{

/// What a task examines.
constexpr std::size_t SitesPerTask = 1 << 12;
constexpr std::size_t FacetsPerTask = 1 << 13;

/// What must hold of a triangulation, its points and its weights.
constexpr const char* NotATriangulation =
  "the triangulation must be one of these points and weights";

[[noreturn]] inline void refuse(std::int64_t index = -1)
{
  throw badArgument(NotATriangulation, index);
}

/// The visible sites, by their index in the triangulation.
/// @throw Error BadArgument, WeightCount, TooManyPoints
inline Buffer<PowerSite> loadSites(
  const PointView& points, const WeightView& weights, const CellComplex& triangulation)
{
  requireValid(points, 2);
  requireValid(weights, points.count);
  const PointSource source(points, weights);
  Buffer<PowerSite> sites(triangulation.pointIds.size());
  eachCheckedChunk(sites.size(), SitesPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const std::int64_t id = triangulation.pointIds[i];
        if (id <= (i > 0 ? triangulation.pointIds[i - 1] : -1) || id >= points.count)
        {
          refuse(id);
        }
        double x[3];
        source.load(static_cast<std::uint32_t>(id), x);
        if (!isFinite(x))
        {
          refuse(id);
        }
        sites[i] = { { x[0], x[1] }, x[2] };
      }
    });
  return sites;
}

/// The cells' corners are in range, and each cell has as many as the dimension requires.
/// @throw Error BadArgument
inline void checkCells(const CellComplex& t)
{
  const int dimension = t.dimension;
  const std::size_t sites = t.pointIds.size();
  const std::int64_t size = static_cast<std::int64_t>(t.connectivity.size());
  if (dimension < -1 || dimension > 2 || (dimension == -1 && sites != 0) ||
    (dimension == 0 && sites != 1) || (dimension == 1 && sites < 2) || t.cellSize < 0 ||
    (t.cellSize > 0 && size % t.cellSize != 0) ||
    (t.cellSize == 0 && t.offsets.empty() && size > 0) || size >= NoIndex)
  {
    refuse();
  }
  const std::int64_t cells = t.cellCount();
  if (cells == 0 ? size != 0 : t.cellBegin(0) != 0 || t.cellBegin(cells) != size)
  {
    refuse();
  }
  const std::int64_t least = dimension + 1;
  const std::int64_t most = dimension < 2 ? least : NoIndex;
  eachCheckedChunk(static_cast<std::size_t>(cells), FacetsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (auto c = static_cast<std::int64_t>(begin); c < static_cast<std::int64_t>(end); ++c)
      {
        const std::int64_t first = t.cellBegin(c);
        const std::int64_t next = t.cellBegin(c + 1);
        if (first < 0 || next < first || next > size || next - first < least || next - first > most)
        {
          refuse();
        }
      }
    });
  eachCheckedChunk(t.connectivity.size(), FacetsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      if (std::any_of(t.connectivity.begin() + begin, t.connectivity.begin() + end,
            [&t](std::int64_t corner)
            { return corner < 0 || corner >= static_cast<std::int64_t>(t.pointIds.size()); }))
      {
        refuse();
      }
    });
}

/// The facets around a site.
/// @throw Error BadArgument for facets that are not one fan
template <class Sides>
void linkFacets(
  const VertexStars<Sides>& stars, const CellComplex& t, std::uint32_t site, Star& star)
{
  stars.link(site, star);
  if (!star.isFan())
  {
    throw badArgument(
      "the triangulation must be one: facets form one ring around a site", t.pointIds[site]);
  }
}

}

#endif
