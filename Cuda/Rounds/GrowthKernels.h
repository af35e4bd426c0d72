// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Algorithm 2 (paper, sections 3.1 and 3.2) as rounds of kernels.
///
///   Associate    each input point finds its cone of the starting polyhedron
/// then, in each round,
///   Mark         which triangles have points?  (a prefix sum gives each of them its new slots)
///   Insert       the furthest point splits its triangle in three
///   LinkSplits   the new triangles find their neighbours, which may have been split too
///   Relocate     each point that remains goes to its child, or is dropped
/// and, where points were left open,
///   LocateExact  each of them walks to its cone, which may have been split meanwhile
///   MakeAllCandidates      any triangle may have points again
///
/// A point alive is an index, where its coordinates are, and its triangle. The furthest point of a
/// triangle is the greatest of the keys (height, lowest id), so any order of execution inserts the
/// same points; new slots come from the prefix sum, never from a counter. Points that the
/// floating-point filter leaves open in Associate and Relocate wait in a list until the host knows
/// of them: then nothing with exact arithmetic is launched where no point needs it.
///
/// How two neighbours are split at once: a triangle that is split in this round carries the round
/// in its index. A child's outer neighbour is known by its old number; if that triangle was split
/// too, the half of the edge is now edge 0 of the child of the same number.
#ifndef flipflop_GrowthKernels_h
#define flipflop_GrowthKernels_h

#include "FlipFlop/GrowthRule.h"
#include "Geometry/VisibilityWalk.h"
#include "Mesh/Mesh.h"
#include "Points/PointSource.h"
#include "Rounds/Atomics.h"
#include "Rounds/Counters.h"
#include "Rounds/ExactKernel.h"
#include "Rounds/FilteredGeometry.h"
#include "Rounds/Kernel.h"
#include "Rounds/WideLoad.h"

#include <cstdint>
#include <cstring>

namespace flipflop
{

/// A point, and the triangle in whose cone it is; or near it, where a filter has left that open.
struct alignas(8) PointAlive
{
  std::uint32_t index; ///< in the order of the ids, or in that of OrderKernels.h
  std::uint32_t triangle;
};

/// The points in an order of their own; none: they are in that of their ids.
struct OrderedPoints
{
  double* x;          ///< three for each index
  std::uint32_t* ids; ///< null: there is no such order
};

/// What the kernels work on, in the executor's memory.
template <class Geometry>
struct GrowthData
{
  Geometry geometry;
  PointSource points;
  bool checkFinite; ///< there are points to ignore
  Mesh mesh;
  std::uint64_t* furthest; ///< by triangle: furthestKey of its points, 0: it has none
  std::uint32_t* lowest;   ///< by vertex: the lowest id at its position
  OrderedPoints ordered;
  PointAlive* live[2]; ///< points still above the polyhedron, by turns
  std::uint32_t* candidates[2];
  std::uint32_t* offsets; ///< by candidate: 1 if it has points, then the number of those before
  PointAlive* unlocated;
  Counters* counters;
};

/// Orders points by height, then the lower id. Never 0.
FF_HD inline std::uint64_t furthestKey(double height, std::uint32_t id)
{
  const double positive = height > 0 ? height : 0.0; // which goes first is no matter of exactness
  std::uint64_t bits;
  memcpy(&bits, &positive, sizeof(bits));
  return (bits & 0xFFFFFFFF00000000u) | (NoIndex - id);
}
FF_HD inline std::uint32_t idOfKey(std::uint64_t key)
{
  return NoIndex - static_cast<std::uint32_t>(key);
}

namespace growth
{

/// The point at an index.
template <class Geometry>
FF_HD Vertex pointAt(const GrowthData<Geometry>& data, std::uint32_t index)
{
  if (!data.ordered.ids)
  {
    return data.points.vertex(index);
  }
  const double* const x = data.ordered.x + 3 * std::size_t(index);
  return { { x[0], x[1], x[2] }, data.ordered.ids[index], 0 };
}

/// Let the point of that index and id, in the cone of t and above it, live on.
template <class Geometry>
FF_HD void keep(const GrowthData<Geometry>& data, int turn, std::uint32_t index, std::uint32_t id,
  std::uint32_t t, double height)
{
  data.live[turn][atomics::add(&data.counters->live[turn], 1u)] = { index, t };
  atomics::raise(&data.furthest[t], furthestKey(height, id));
}

/// The rule's isAbove for the triangle of the corners v[0], v[1], v[2] in whose cone p is.
template <class Geometry>
FF_HD bool staysAbove(const GrowthData<Geometry>& data, const Geometry& geometry,
  const std::uint32_t* v, const Vertex& p)
{
  const Vertex* const vertices = data.mesh.vertices;
  return isAbove(geometry, vertices[v[0]], vertices[v[1]], vertices[v[2]], p,
    [&](int i) {
      atomics::lower(&data.lowest[i == 0 ? v[0] : i == 1 ? v[1] : v[2]], p.id);
    });
}
template <class Geometry>
FF_HD bool staysAbove(const GrowthData<Geometry>& data, const FilteredGeometry<Geometry>& geometry,
  const std::uint32_t* v, const Vertex& p)
{
  const Vertex* const vertices = data.mesh.vertices;
  return geometry.perturbedAbove(vertices[v[0]], vertices[v[1]], vertices[v[2]], p) > 0;
}

/// Leave a point to the exact kernel.
template <class Geometry>
FF_HD void keepOpen(const GrowthData<Geometry>& data, const PointAlive& point)
{
  data.unlocated[atomics::add(&data.counters->unlocated, 1u)] = point;
}

/// Walk to the cone that p is in, from triangle @p t on; to any, where the oracle is not enough.
/// Splits alone make no circle of triangles that hide each other: no walk meets one twice.
template <class Oracle>
FF_HD std::uint32_t coneOf(const Oracle& geometry, const Mesh& mesh, std::uint32_t t,
  std::uint32_t mostSteps, const Vertex& p)
{
  return visibilityWalk(mesh.triangles, NoIndex, t, mostSteps,
    [&](std::uint32_t at, int entry)
    {
      const std::uint32_t* const v = mesh.triangles[at].v;
      const int out = firstExit(entry,
        [&](int i)
        {
          return geometry.perturbedKernelBeneath(
                   mesh.vertices[v[i]], mesh.vertices[v[nextCorner(i)]], p) < 0
            ? -1
            : 1;
        });
      return isUndecided(geometry) ? NoSide : out;
    });
}

/// Point @p id of the input goes to its cone.
template <class Geometry>
FF_HD void associate(const GrowthData<Geometry>& data, std::uint32_t id)
{
  const FilteredGeometry<Geometry> geometry(data.geometry);
  const Vertex p = data.points.vertex(id);
  const Vertex* const start = data.mesh.vertices;
  if ((data.checkFinite && !isFinite(p.x)) || id == start[0].id || id == start[1].id ||
    id == start[2].id || id == start[3].id)
  {
    return;
  }
  constexpr std::uint32_t MostSteps = 4;
  const std::uint32_t t = coneOf(geometry, data.mesh, 0, MostSteps, p);
  const std::uint32_t* const v = data.mesh.triangles[t].v;
  const bool above = staysAbove(data, geometry, v, p);
  if (isUndecided(geometry))
  {
    keepOpen(data, { id, t });
  }
  else if (above)
  {
    keep(data, 0, id, id, t, Geometry::heightAbove(start[v[0]], start[v[1]], start[v[2]], p));
  }
}

/// Point @p i alive, whose triangle has just been split, goes on.
template <class Geometry>
FF_HD void relocate(const GrowthData<Geometry>& data, int turn, std::uint32_t i)
{
  const FilteredGeometry<Geometry> geometry(data.geometry);
  const PointAlive point = data.live[turn][i];
  const std::uint32_t t = point.triangle;
  const Vertex p = pointAt(data, point.index);
  const Triangle first = whole(data.mesh.triangles[t]);
  const Vertex* const vertices = data.mesh.vertices;
  const Vertex v = whole(vertices[first.v[2]]);
  if (v.id == p.id)
  {
    return; // it is the one
  }
  const std::uint32_t child[3] = { t, triangleOf(first.twin[1]), triangleOf(first.twin[2]) };
  const std::uint32_t corner[3] = { first.v[0], first.v[1], data.mesh.triangles[child[1]].v[1] };
  const int k =
    childOf(geometry, v, vertices[corner[0]], vertices[corner[1]], vertices[corner[2]], p);
  // Read again, for all three would take registers of a quarter of the threads.
  const Vertex a = whole(vertices[k == 0 ? corner[0] : k == 1 ? corner[1] : corner[2]]);
  const Vertex b = whole(vertices[k == 0 ? corner[1] : k == 1 ? corner[2] : corner[0]]);
  const bool above = geometry.perturbedAbove(a, b, v, p) > 0;
  if (isUndecided(geometry))
  {
    keepOpen(data, point);
  }
  else if (above)
  {
    keep(data, turn ^ 1, point.index, p.id,
      k == 0     ? child[0]
        : k == 1 ? child[1]
                 : child[2],
      Geometry::heightAbove(a, b, v, p));
  }
}

/// A point that was left open goes to its cone.
template <class Geometry>
FF_HD void locate(const GrowthData<Geometry>& data, const Geometry& geometry, int turn,
  const PointAlive& open, std::uint32_t mostSteps)
{
  const Vertex p = pointAt(data, open.index);
  const Vertex* const vertices = data.mesh.vertices;
  const std::uint32_t t = coneOf(geometry, data.mesh, open.triangle, mostSteps, p);
  if (t == NoIndex)
  {
    atomics::store(&data.counters->strayed, 1u);
    return;
  }
  const std::uint32_t* const v = data.mesh.triangles[t].v;
  if (staysAbove(data, geometry, v, p))
  {
    keep(data, turn, open.index, p.id, t,
      Geometry::heightAbove(vertices[v[0]], vertices[v[1]], vertices[v[2]], p));
  }
}

}

/// Over the points of the input.
template <class Geometry>
struct Associate : Kernel
{
  static constexpr const char* Name = "associate";
  static constexpr int Bytes = 24 + 8 + 8;
  GrowthData<Geometry> data;

  FF_HD void operator()(std::uint32_t i, Local&) const { growth::associate(this->data, i); }
};

/// Over the space for the sums: all indices of a list of at most so many candidates, and one more.
struct Mark : Kernel
{
  static constexpr const char* Name = "mark";
  static constexpr int Bytes = 4 + 8 + 4;
  const std::uint32_t* candidates;
  const std::uint64_t* furthest;
  std::uint32_t* offsets;
  const Counters* counters;
  std::uint32_t turn;  ///< of the points alive
  RoundRecord* record; ///< of the round before

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    this->offsets[i] =
      i < this->counters->candidates && this->furthest[this->candidates[i]] != 0 ? 1 : 0;
  }

  FF_HD void once() const
  {
    const Counters& c = *this->counters;
    *this->record = { c.triangles, c.vertices, c.live[this->turn], c.candidates, 0, c.unlocated };
  }
};

/// Over the candidates.
template <class Geometry>
struct Insert : Kernel
{
  static constexpr const char* Name = "insert";
  static constexpr int Bytes = 4 + 8 + 4 + 24 + 32 + 3 * 32 + 3 * 8 + 3 * 4 + 32;
  GrowthData<Geometry> data;
  std::uint32_t round;

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    const GrowthData<Geometry>& d = this->data;
    const std::uint32_t offset = d.offsets[i];
    if (d.offsets[i + 1] == offset)
    {
      return;
    }
    const std::uint32_t t = d.candidates[this->round & 1][i];
    const std::uint32_t id = idOfKey(d.furthest[t]);
    const std::uint32_t vertex = d.counters->vertices + offset;
    Vertex& v = d.mesh.vertices[vertex];
    v = d.points.vertex(id);
    v.flags = VertexAlive;
    d.lowest[vertex] = id;

    const std::uint32_t added = d.counters->triangles + 2 * offset;
    const std::uint32_t child[3] = { t, added, added + 1 };
    const Triangle parent = d.mesh.triangles[t];
    for (int k = 0; k < 3; ++k)
    {
      Triangle& triangle = d.mesh.triangles[child[k]];
      triangle.v[0] = parent.v[k];
      triangle.v[1] = parent.v[nextCorner(k)];
      triangle.v[2] = vertex;
      // No edge waits while cones grow: flags is the last round in which the triangle was split.
      triangle.flags = k == 0 ? this->round : 0;
      triangle.twin[0] = parent.twin[k]; // by its old number
      triangle.twin[1] = halfEdge(child[nextCorner(k)], 2);
      triangle.twin[2] = halfEdge(child[previousCorner(k)], 1);
      triangle.flatEdges = 0;
      d.furthest[child[k]] = 0;
      d.candidates[(this->round & 1) ^ 1][3 * offset + static_cast<std::uint32_t>(k)] = child[k];
    }
  }
};

/// Over the candidates.
template <class Geometry>
struct LinkSplits : Kernel
{
  static constexpr const char* Name = "link splits";
  static constexpr int Bytes = 8 + 4 + 3 * (8 + 4 + 12 + 4);
  GrowthData<Geometry> data;
  std::uint32_t round;
  bool allLocated; ///< LocateExact ran in the round before

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    const GrowthData<Geometry>& d = this->data;
    if (d.offsets[i + 1] == d.offsets[i])
    {
      return;
    }
    const std::uint32_t t = d.candidates[this->round & 1][i];
    for (int k = 0; k < 3; ++k)
    {
      const std::uint32_t h = halfEdge(this->childOf(t, k), 0);
      std::uint32_t& twin = d.mesh.triangles[triangleOf(h)].twin[0];
      const std::uint32_t other = triangleOf(twin);
      if (d.mesh.triangles[other].flags == this->round)
      {
        twin = halfEdge(this->childOf(other, cornerOf(twin)), 0);
      }
      else
      {
        d.mesh.triangles[other].twin[cornerOf(twin)] = h;
      }
    }
  }

  FF_HD void once() const
  {
    Counters& counters = *this->data.counters;
    counters.live[this->round & 1] = 0;
    if (this->allLocated)
    {
      counters.unlocated = 0;
    }
  }

private:
  FF_HD std::uint32_t childOf(std::uint32_t t, int k) const
  {
    return k == 0 ? t : triangleOf(this->data.mesh.triangles[t].twin[k]);
  }
};

/// Over the points alive. Round r reads turn (r + 1) & 1 and fills the other.
template <class Geometry>
struct Relocate : Kernel
{
  static constexpr const char* Name = "relocate";
  static constexpr int Bytes = 8 + 24 + 4 + 64 + 4 * 32 + 8 + 8;
  GrowthData<Geometry> data;
  std::uint32_t round;
  std::uint32_t* total; ///< of the candidates' indices

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    growth::relocate(this->data, static_cast<int>((this->round & 1) ^ 1), i);
  }

  /// The round's vertices are all there: count them.
  FF_HD void once() const
  {
    Counters& counters = *this->data.counters;
    const std::uint32_t inserted = *this->total;
    counters.vertices += inserted;
    counters.triangles += 2 * inserted;
    counters.candidates = 3 * inserted;
    counters.inserted = inserted;
    counters.insertions += inserted;
  }
};

/// Over the points left open.
template <class Geometry>
struct LocateExact : ExactKernel<Geometry, GrowthData<Geometry>>
{
  static constexpr const char* Name = "locate, exact";
  static constexpr int Bytes = 8 + 24 + 4 + 2 * (32 + 3 * 32) + 8 + 8; // a walk of two triangles
  std::uint32_t turn;                                                  ///< of those that live on

  FF_HD void operator()(std::uint32_t i, const Geometry& local) const
  {
    growth::locate(this->data, local, static_cast<int>(this->turn), this->data.unlocated[i],
      this->data.counters->triangles);
  }
};

/// Over all triangles: each is a candidate. A point that was left open may be in the cone of one
/// that was none.
template <class Geometry>
struct MakeAllCandidates : Kernel
{
  static constexpr const char* Name = "all again";
  static constexpr int Bytes = 4;
  GrowthData<Geometry> data;
  std::uint32_t turn; ///< of the candidates

  FF_HD void operator()(std::uint32_t i, Local&) const { this->data.candidates[this->turn][i] = i; }
  FF_HD void once() const { this->data.counters->candidates = this->data.counters->triangles; }
};

}

#endif
