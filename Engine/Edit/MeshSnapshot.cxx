// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Edit/MeshSnapshot.h"

#include "Constraints/FixedEdge.h"
#include "Finish/Canonical.h"
#include "Finish/Redundant.h"
#include "FlipFlop/Tally.h"
#include "Mesh/Polyhedron.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

namespace
{

constexpr std::size_t ItemsPerTask = 1 << 14;

/// A copy, with the mesh's gaps.
template <bool Weighted>
Polyhedron polyhedronOf(const EditableMesh<Weighted>& mesh)
{
  Polyhedron result(mesh.slotCount(), mesh.triangleCount());
  eachChunk(mesh.slotCount(), ItemsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t slot = begin; slot < end; ++slot)
      {
        result.vertices[slot] = mesh.vertex(static_cast<std::uint32_t>(slot));
        result.vertices[slot].flags &= VertexAlive | VertexVirtual;
      }
    });
  eachChunk(mesh.triangleCount(), ItemsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t t = begin; t < end; ++t)
      {
        result.triangles[t] = mesh.triangle(static_cast<std::uint32_t>(t));
        result.triangles[t].flatEdges = 0;
      }
    });
  return result;
}

/// Edges of circles that a constraint parts.
void sharpenFixedEdges(Polyhedron& polyhedron)
{
  const Mesh mesh = polyhedron.mesh();
  polyhedron.eachTriangle([&](std::uint32_t t, std::size_t)
    { mesh.triangles[t].flatEdges &= ~(mesh.triangles[t].flags / EdgeFixed); });
}

}

template <bool Weighted>
void writeCells(const EditableMesh<Weighted>& mesh, std::uint32_t idLimit, const Options& options,
  Monitor& monitor, Triangulation& result)
{
  using Geometry = LiftedGeometry<Weighted>;
  Polyhedron polyhedron = polyhedronOf(mesh);
  bool anyFlat = false;
  Tally tally;
  if (Weighted || options.facets == FacetMode::Polygons)
  {
    const Geometry geometry = mesh.signs().unraised();
    tally.ties = 1; // whether there are any is not known
    anyFlat = RedundantVertices<Geometry>(geometry, polyhedron, tally, monitor).remove();
    sharpenFixedEdges(polyhedron);
  }
  result.dimension = 2;
  CanonicalForm<Polyhedron> form(
    polyhedron, anyFlat, tally.duplicates, idLimit, options.facets, monitor, result.pointIds);
  form.writeCells(monitor, result);
}

template void writeCells<false>(
  const EditableMesh<false>&, std::uint32_t, const Options&, Monitor&, Triangulation&);
template void writeCells<true>(
  const EditableMesh<true>&, std::uint32_t, const Options&, Monitor&, Triangulation&);

void writeConstraints(const EditableMesh<false>& mesh,
  const std::vector<MeshConstraint>& constraints, ConstrainedTriangulation& result)
{
  const auto rankOf = [&](std::uint32_t slot)
  {
    return static_cast<std::uint32_t>(std::lower_bound(result.pointIds.begin(),
                                        result.pointIds.end(), std::int64_t(mesh.vertex(slot).id)) -
      result.pointIds.begin());
  };
  std::vector<FixedEdge> edges;
  for (const MeshConstraint& constraint : constraints)
  {
    SidesAlong sides;
    if (constraint.isSide)
    {
      sides.balance = 1;
      sides.first[0] = constraint.number;
    }
    mesh.eachFixedEdge(constraint.from, constraint.to,
      [&](std::uint32_t from, std::uint32_t to)
      { edges.emplace_back(rankOf(from), rankOf(to), constraint.number, sides); });
  }
  writeFixedEdges(edges, result);
}

}
