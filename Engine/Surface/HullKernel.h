// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A kernel point for a hull that was not built here but given.
#ifndef flipflop_HullKernel_h
#define flipflop_HullKernel_h

#include "Geometry/HullGeometry.h"
#include "Mesh/Polyhedron.h"
#include "Points/PointSource.h"
#include "Run/Span.h"
#include "Support/Monitor.h"
#include "Surface/StarShape.h"

#include <cstdint>

namespace flipflop
{

/// Set the geometry's kernel point strictly inside @p polyhedron, if that is a hull: the exact
/// centroid of four independent corners is. It is rounded where that sees all triangles, too.
/// @param ids, count of the corners, in the source
/// @return           the four corners; of lower dimension where there are none
inline Span placeKernel(HullGeometry& geometry, const PointSource& source, const std::uint32_t* ids,
  std::uint32_t count, const Polyhedron& polyhedron, Monitor& monitor)
{
  const Span span = findSpan(geometry, source, ids, count, 3, false, monitor);
  if (span.dimension < 3)
  {
    return span;
  }
  Vertex four[4];
  double s[3] = { 0, 0, 0 };
  for (int k = 0; k < 4; ++k)
  {
    four[k] = source.vertex(span.ids[k]);
    for (int i = 0; i < 3; ++i)
    {
      s[i] += 0.25 * four[k].x[i];
    }
  }
  geometry.setKernel(s);
  if (findStarFault(geometry, polyhedron).count)
  {
    geometry.setSymbolicKernel(four);
  }
  return span;
}

}

#endif
