// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The arrays of an editable triangulation at a moment: the finish of a run, on a copy of its mesh.
#include "Constraints/FixedEdge.h"
#include "Edit/EditableState.h"
#include "Finish/Canonical.h"
#include "Finish/Redundant.h"
#include "FlipFlop/Tally.h"
#include "Mesh/Polyhedron.h"
#include "Support/Parallel.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

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

template <bool Weighted>
void writeCells(const EditableMesh<Weighted>& mesh, const Options& options, Monitor& monitor,
  ConstrainedTriangulation& result)
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
  CanonicalForm<Polyhedron> form(polyhedron, anyFlat, tally.duplicates, mesh.slotCount() - 1,
    options.facets, monitor, result.pointIds);
  form.writeCells(monitor, result);
}

}

ConstrainedTriangulation EditableState::snapshot(const Options& options) const
{
  ConstrainedTriangulation result;
  const std::vector<std::uint32_t> slots = this->presentSlots();
  if (!this->hasTriangles())
  {
    result = this->triangulationOf(slots, options);
    for (Buffer<std::int64_t>* ids : { &result.pointIds, &result.hiddenIds })
    {
      for (std::int64_t& id : *ids)
      {
        id = std::int64_t(slots[static_cast<std::size_t>(id)]) - 1;
      }
    }
    return result;
  }
  Monitor monitor(options);
  ArenaLoan arena(threadCount(options.threads, this->known.present));
  arena.execute(
    [&]
    {
      monitor.stage(0.0, 1.0, 1);
      this->inMesh([&](const auto& m) { writeCells(m, options, monitor, result); });
    });
  result.hiddenIds.allocate(slots.size() - result.pointIds.size());
  const std::int64_t* visible = result.pointIds.begin();
  std::int64_t* hidden = result.hiddenIds.begin();
  for (const std::uint32_t slot : slots)
  {
    const std::int64_t id = std::int64_t(slot) - 1;
    if (visible != result.pointIds.end() && *visible == id)
    {
      ++visible;
    }
    else
    {
      *hidden++ = id;
    }
  }
  this->writeFixedEdges(result);
  result.statistics.points = this->known.present;
  return result;
}

void EditableState::writeFixedEdges(ConstrainedTriangulation& result) const
{
  const auto* const mesh = std::get_if<EditableMesh<false>>(&this->now.mesh);
  if (this->list.count() == 0 || !mesh)
  {
    return;
  }
  const std::vector<std::uint32_t> visible = mesh->visibleOfAll();
  const auto rankOf = [&result](std::uint32_t slot)
  {
    return static_cast<std::uint32_t>(
      std::lower_bound(result.pointIds.begin(), result.pointIds.end(), std::int64_t(slot) - 1) -
      result.pointIds.begin());
  };
  std::vector<FixedEdge> edges;
  for (const std::uint32_t number : this->presentConstraints())
  {
    mesh->eachFixedEdge(visible[this->list.end(number, 0)], visible[this->list.end(number, 1)],
      [&](std::uint32_t from, std::uint32_t to)
      { edges.emplace_back(rankOf(from), rankOf(to), number); });
  }
  flipflop::writeFixedEdges(edges, result);
}

}
