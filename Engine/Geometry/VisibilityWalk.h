// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The visibility walk: from triangle to triangle, each time through a side that the point lies
/// beyond, seen from the kernel point, to the cone that holds it.
///
/// Seen from inside a convex polyhedron, the triangles hide each other in no circle, so a walk by
/// exact signs meets none twice and ends.
#ifndef flipflop_VisibilityWalk_h
#define flipflop_VisibilityWalk_h

#include "Mesh/Mesh.h"
#include "Points/Vertex.h"
#include "Support/HostDevice.h"

#include <cstdint>

namespace flipflop
{

/// No side of a triangle.
constexpr int NoSide = 3;

/// Walk from triangle @p t on.
/// @param borderBegin twins from here on are the border of a patch (see Mesh); NoIndex: none is
/// @param mostSteps   after which the walk gives up
/// @param exitOf      int (triangle, entry): the side to leave it through, or NoSide to stay. Entry
///                    is the side that the walk came in by, which need not be tested again; NoSide
///                    at the start
/// @return the triangle where the walk stays; NoIndex where it gives up, or reaches the border of a
///         patch
template <class ExitOf>
FF_HD std::uint32_t visibilityWalk(const Triangle* triangles, std::uint32_t borderBegin,
  std::uint32_t t, std::uint32_t mostSteps, ExitOf&& exitOf)
{
  int entry = NoSide;
  for (std::uint32_t step = 0; step <= mostSteps; ++step)
  {
    const int out = exitOf(t, entry);
    if (out == NoSide)
    {
      return t;
    }
    const std::uint32_t twin = triangles[t].twin[out];
    if (twin >= borderBegin)
    {
      break;
    }
    t = triangleOf(twin);
    entry = cornerOf(twin);
  }
  return NoIndex;
}

/// The first side but the entry that the point lies beyond.
/// @param sideOf int (side): negative beyond it; zero: the point is at a corner of the
///               triangle, where the walk stays, for the way around the corner would show no more
template <class SideOf>
FF_HD int firstExit(int entry, SideOf&& sideOf)
{
  for (int i = 0; i < 3; ++i)
  {
    const auto side = i == entry ? 1 : sideOf(i);
    if (!(side > 0))
    {
      return side < 0 ? i : NoSide;
    }
  }
  return NoSide;
}

/// The exact result of sideOf, for where a rounded one leaves the side from a to b open.
template <class Geometry>
int exactSide(const Geometry& geometry, const Vertex& a, const Vertex& b, const Vertex& p)
{
  return samePosition(a, p) || samePosition(b, p) ? 0 : geometry.perturbedKernelBeneath(a, b, p);
}

/// Where a point was found.
struct Located
{
  /// The triangle in whose cone it lies, exactly (by perturbation, at a border); for a point at the
  /// position of a vertex, one of that vertex. NoIndex: the way there is not inside the patch.
  std::uint32_t triangle;
  bool strictly; ///< inside without the perturbation
};

/// Walk to the cone of @p p from triangle @p t on, by exact signs alone.
/// @param mostSteps of a walk: where edges wait for their flips, a walk may go round
/// @param steps     is increased by those taken
template <class Geometry>
Located locateFrom(const Geometry& geometry, const Mesh& mesh, std::uint32_t t, const Vertex& p,
  std::uint32_t mostSteps, std::int64_t& steps)
{
  bool onEntry = false; // p lies on the side we came in by, and the perturbation moved it across
  bool strictly = false;
  const auto exitOf = [&](std::uint32_t at, int entry)
  {
    const Triangle& triangle = mesh.triangles[at];
    const Vertex* const corner[3] = { mesh.vertices + triangle.v[0], mesh.vertices + triangle.v[1],
      mesh.vertices + triangle.v[2] };
    // By turns to the left and to the right: of a fan of slivers, each leads to the next one on the
    // same side, and out of the fan on the other.
    int i = entry == NoSide ? 0 : steps % 2 == 0 ? nextCorner(entry) : previousCorner(entry);
    // From outside first back in: around the border the way is long.
    for (int k = 0; k < 3; ++k)
    {
      i = corner[k]->flags & VertexVirtual ? nextCorner(k) : i;
    }
    int zeros = 0;
    for (int n = 0; n < 3; ++n, i = nextCorner(i))
    {
      if (i == entry)
      {
        continue;
      }
      const int sign = geometry.kernelBeneath(*corner[i], *corner[nextCorner(i)], p);
      if (sign < 0)
      {
        onEntry = false;
        ++steps;
        return i;
      }
      zeros |= static_cast<int>(sign == 0) << i;
    }
    strictly = zeros == 0 && !onEntry;
    if (zeros == 0)
    {
      return NoSide;
    }
    for (const Vertex* v : corner)
    {
      if (samePosition(*v, p))
      {
        return NoSide;
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      if ((zeros >> k & 1) && geometry.tieKernelBeneath(*corner[k], *corner[nextCorner(k)], p) < 0)
      {
        onEntry = true;
        ++steps;
        return k;
      }
    }
    return NoSide;
  };
  const std::uint32_t found =
    visibilityWalk(mesh.triangles, mesh.borderBegin, t, mostSteps, exitOf);
  return { found, found != NoIndex && strictly };
}

}

#endif
