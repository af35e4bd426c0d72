// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A caller's triangulation, looked over before it is used: ids and indices are in range, and cells
/// have as many corners as the dimension says. What else is wrong with it, the use must find.
#ifndef flipflop_TriangulationInput_h
#define flipflop_TriangulationInput_h

#include "Mesh/CellStructure.h"
#include "Mesh/VertexStars.h"
#include "Points/PointSource.h"
#include "PowerDiagram/PowerSite.h"
#include <flipflop/Buffer.h>
#include <flipflop/Triangulation.h>

#include <cmath>
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
  const Validation found = firstFault(sites.size(), SitesPerTask, source,
    [&](const PointSource& local, std::size_t i)
    {
      double x[3] = { HUGE_VAL, HUGE_VAL, HUGE_VAL };
      if (isInOrder(triangulation, i, points.count))
      {
        local.load(static_cast<std::uint32_t>(triangulation.pointIds[i]), x);
      }
      sites[i] = { { x[0], x[1] }, x[2] };
      return isFinite(x) ? Validation() : faultAt(Fault::Structure, static_cast<std::int64_t>(i));
    });
  requireSound(found, triangulation, NotATriangulation);
  return sites;
}

/// The cells' corners are in range, and each cell has as many as the dimension requires.
/// @throw Error BadArgument
inline void requireCells(const CellComplex& triangulation)
{
  if (!checkCells(triangulation, 2, CellForm::InRange))
  {
    refuse();
  }
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
