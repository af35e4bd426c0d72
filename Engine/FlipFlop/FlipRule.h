// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The decision of Algorithm 1 (paper, section 2.3) for one edge, as a pure function.
///
/// The edge ab has the link c, d: its triangles are abc and bad. The D-criterion goes before the
/// V-criterion, and among labelled vertices the lowest id goes first, so no edge is flipped back
/// and forth.
#ifndef flipflop_FlipRule_h
#define flipflop_FlipRule_h

#include "Mesh/Mesh.h"
#include "Points/Vertex.h"
#include "Support/HostDevice.h"

#include <cstdint>

namespace flipflop
{

enum class FlipAction : std::uint8_t
{
  None,
  Flip22,  ///< ab to cd
  RemoveA, ///< 3-1 flip of a
  RemoveB, ///< 3-1 flip of b
  LabelA,  ///< a is non-extreme: it lies inside the tetrahedron of s, b, c, d
  LabelB   ///< b is non-extreme
};

struct FlipDecision
{
  FlipAction action = FlipAction::None;
  bool byDegree = false; ///< D-criterion, else V-criterion
};

/// use(vertex, k) for each of the three other vertices around the edge of @p h that is at the
/// position of its origin; k: 0 the other end, 1 and 2 the link.
///
/// Where the rule removes or labels the origin, that lies in the tetrahedron of s and these three.
/// A point at an extreme position can only lie there as a duplicate of one of them, which then
/// stands for its id.
template <class Use>
FF_HD void eachDuplicateOfOrigin(const Mesh& mesh, std::uint32_t h, Use&& use)
{
  const std::uint32_t twin = mesh.twin(h);
  const std::uint32_t others[3] = { mesh.origin(twin), mesh.origin(previousHalfEdge(h)),
    mesh.origin(previousHalfEdge(twin)) };
  for (int k = 0; k < 3; ++k)
  {
    if (samePosition(mesh.vertices[mesh.origin(h)], mesh.vertices[others[k]]))
    {
      use(mesh.vertices[others[k]], k);
    }
  }
}

FF_HD inline std::uint32_t leastOf(std::uint32_t x, std::uint32_t y)
{
  return x < y ? x : y;
}

/// Can the rule want anything at all? Only where the edge is reflex, or one of the four vertices
/// is labelled. One sign, against up to three of decideFlip: most edges are quiet.
template <class Geometry>
FF_HD bool mayNeedFlip(
  const Geometry& geometry, const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d)
{
  return ((a.flags | b.flags | c.flags | d.flags) & VertexLabelled) != 0 ||
    geometry.perturbedAbove(a, b, c, d) > 0;
}

/// @param threeAtA, threeAtB three triangles in all are around that end
template <class Geometry>
FF_HD FF_INLINE FlipDecision decideFlip(const Geometry& geometry, const Vertex& a, const Vertex& b,
  const Vertex& c, const Vertex& d, bool threeAtA, bool threeAtB)
{
  FlipDecision decision;
  const bool reflex = geometry.perturbedAbove(a, b, c, d) > 0;
  const std::uint32_t labels = (a.flags | b.flags | c.flags | d.flags) & VertexLabelled;
  if (!reflex && !labels)
  {
    return decision;
  }

  if (threeAtA && threeAtB)
  {
    return decision; // a tetrahedron
  }
  if (threeAtA || threeAtB)
  {
    const bool labelled = ((threeAtA ? a.flags : b.flags) & VertexLabelled) != 0;
    if (labelled || reflex)
    {
      decision.action = threeAtA ? FlipAction::RemoveA : FlipAction::RemoveB;
      decision.byDegree = labelled;
    }
    return decision;
  }

  // Is the labelled vertex of lowest id an end of the edge? No id is NoIndex but the virtual
  // vertex's, which is never labelled.
  bool reducesDegree = false;
  if (labels)
  {
    const auto idIfLabelled = [](const Vertex& v)
    { return v.flags & VertexLabelled ? v.id : NoIndex; };
    reducesDegree =
      leastOf(idIfLabelled(a), idIfLabelled(b)) < leastOf(idIfLabelled(c), idIfLabelled(d));
  }
  if (!reducesDegree && !reflex)
  {
    return decision;
  }

  // The triangles after a 2-2 flip are adc and dbc. Where s is not beneath one of them, the end it
  // touches lies inside the cone of the other three; where it is beneath neither, s is inside the
  // tetrahedron.
  const bool cutsA = geometry.perturbedKernelBeneath(a, d, c) < 0;
  const bool cutsB = geometry.perturbedKernelBeneath(d, b, c) < 0;
  if (!cutsA && !cutsB)
  {
    if (reducesDegree || !labels)
    {
      decision.action = FlipAction::Flip22;
      decision.byDegree = reducesDegree;
    }
  }
  else if (cutsA != cutsB && reflex)
  {
    if (!((cutsA ? a.flags : b.flags) & VertexLabelled))
    {
      decision.action = cutsA ? FlipAction::LabelA : FlipAction::LabelB;
    }
  }
  return decision;
}

/// @param vertices the mesh's
template <class Geometry>
FF_HD FF_INLINE FlipDecision decideFlip(
  const Geometry& geometry, const Vertex* vertices, const EdgeSurroundings& edge)
{
  return decideFlip(geometry, vertices[edge.a], vertices[edge.b], vertices[edge.c],
    vertices[edge.d], edge.threeAtA, edge.threeAtB);
}

}

#endif
