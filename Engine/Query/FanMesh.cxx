// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/FanMesh.h"

#include "PowerDiagram/TriangulationInput.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <utility>

namespace flipflop
{

namespace
{

using Geometry = LiftedGeometry<true>;

class FanMeshMaker
{
public:
  FanMeshMaker(FanMesh& result, const Vertex* points, const Geometry& signs,
    const Triangulation& triangulation, const Buffer<std::int64_t>* fixedEdges,
    Monitor& monitorToUse)
    : mesh(result)
    , vertices(points)
    , geometry(signs)
    , given(triangulation)
    , fixed(fixedEdges)
    , monitor(monitorToUse)
    , next(triangulation.pointIds.size())
  {
  }

  void make()
  {
    this->makeTriangles();
    this->link();
    this->checkBorder();
    this->checkEdges();
  }

private:
  void makeTriangles()
  {
    // A cell of k corners makes k - 2 triangles.
    const std::int64_t cells = this->given.cellCount();
    const std::int64_t count = this->given.cellBegin(cells) - 2 * cells;
    if (count >= NoIndex / 4)
    {
      throw Error(ErrorCode::TooManyPoints, -1, count);
    }
    this->mesh.triangles.allocate(static_cast<std::size_t>(count));
    this->mesh.cells.allocate(static_cast<std::size_t>(count));
    eachCheckedChunk(static_cast<std::size_t>(cells), FacetsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        this->monitor.poll();
        const Geometry local = this->geometry; // it counts
        for (std::size_t c = begin; c < end; ++c)
        {
          this->addFan(static_cast<std::int64_t>(c), local);
        }
      });
  }

  void addFan(std::int64_t cell, const Geometry& local)
  {
    const std::int64_t begin = this->given.cellBegin(cell);
    const std::int64_t end = this->given.cellBegin(cell + 1);
    const auto corner = [&](std::int64_t i)
    { return static_cast<std::uint32_t>(this->given.connectivity[static_cast<std::size_t>(i)]); };
    auto t = static_cast<std::size_t>(begin - 2 * cell);
    for (std::int64_t i = begin + 1; i + 1 < end; ++i, ++t)
    {
      this->mesh.cells[t] = static_cast<std::uint32_t>(cell);
      Triangle& triangle = this->mesh.triangles[t];
      triangle = { { corner(begin), corner(i), corner(i + 1) }, 0, { NoIndex, NoIndex, NoIndex },
        0 };
      const std::uint32_t* v = triangle.v;
      if (local.orient(this->vertices[v[0]], this->vertices[v[1]], this->vertices[v[2]]) <= 0)
      {
        refuse(this->given.pointIds[v[0]]);
      }
    }
  }

  /// A vertex of the border knows the next one.
  void link()
  {
    const std::size_t count = this->given.pointIds.size();
    const VertexStars<TriangleSides> stars(
      TriangleSides(this->mesh.triangles.data(), this->mesh.triangles.size(), count));
    const auto setTwins = [this](std::uint32_t h, std::uint32_t twin)
    { setTwin(this->mesh.triangles.data(), h, twin); };
    this->mesh.lowestAt.allocate(count);
    eachCheckedChunk(count, SitesPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        this->monitor.poll();
        const Geometry local = this->geometry;
        Star star;
        for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v)
        {
          linkFacets(stars, this->given, v, star);
          this->mesh.lowestAt[v] = triangleOf(star.leaving.front());
          stars.eachTwin(star, setTwins);
          this->next[v] = NoIndex;
          if (!star.isClosed)
          {
            const std::uint32_t last = stars.source(star.ring.back());
            this->next[v] = stars.destination(star.ring.front());
            if (local.orient(
                  this->vertices[last], this->vertices[v], this->vertices[this->next[v]]) < 0)
            {
              refuse(this->given.pointIds[v]);
            }
          }
        }
      });
  }

  /// One loop.
  void checkBorder() const
  {
    const auto first = std::find_if(
      this->next.begin(), this->next.end(), [](std::uint32_t v) { return v != NoIndex; });
    if (first == this->next.end())
    {
      refuse();
    }
    const auto start = static_cast<std::uint32_t>(first - this->next.begin());
    std::ptrdiff_t length = 0;
    std::uint32_t v = start;
    do
    {
      v = this->next[v];
      ++length;
    } while (v != start);
    if (std::count(first, this->next.end(), NoIndex) + length != this->next.end() - first)
    {
      refuse();
    }
  }

  /// No point opposite an edge is above the triangle, but where the edge is fixed.
  void checkEdges()
  {
    const Triangle* const triangles = this->mesh.triangles.data();
    std::atomic<bool> regular{ true };
    eachCheckedChunk(this->mesh.triangles.size(), FacetsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        this->monitor.poll();
        const Geometry local = this->geometry;
        for (std::size_t t = begin; t < end; ++t)
        {
          const std::uint32_t* v = triangles[t].v;
          for (const std::uint32_t twin : triangles[t].twin)
          {
            if (twin == NoIndex || triangleOf(twin) <= t ||
              local.above(this->vertices[v[0]], this->vertices[v[1]], this->vertices[v[2]],
                this->vertices[this->mesh.origin(previousHalfEdge(twin))]) <= 0)
            {
              continue;
            }
            if (!this->isFixed(this->mesh.origin(twin), this->mesh.origin(nextHalfEdge(twin))))
            {
              refuse(this->given.pointIds[v[0]]);
            }
            regular.store(false, std::memory_order_relaxed);
          }
        }
      });
    this->mesh.isRegular = regular.load(std::memory_order_relaxed);
  }

  /// Is the edge of two vertices in the list? It is in lexicographic order.
  bool isFixed(std::uint32_t a, std::uint32_t b) const
  {
    const std::pair<std::int64_t, std::int64_t> edge = std::minmax<std::int64_t>(a, b);
    std::size_t low = 0;
    std::size_t high = this->fixed ? this->fixed->size() / 2 : 0;
    while (low < high)
    {
      const std::size_t middle = low + (high - low) / 2;
      const std::int64_t* ends = this->fixed->data() + 2 * middle;
      const std::pair<std::int64_t, std::int64_t> there(ends[0], ends[1]);
      if (there == edge)
      {
        return true;
      }
      low = there < edge ? middle + 1 : low;
      high = there < edge ? high : middle;
    }
    return false;
  }

  FanMesh& mesh;
  const Vertex* vertices;
  const Geometry& geometry;
  const Triangulation& given;
  const Buffer<std::int64_t>* fixed; ///< edges; may be null
  Monitor& monitor;
  Buffer<std::uint32_t> next; ///< along the border; NoIndex inside
};

}

FanMesh::FanMesh(const Vertex* vertices, const LiftedGeometry<true>& geometry,
  const Triangulation& triangulation, const Buffer<std::int64_t>* fixedEdges, Monitor& monitor)
{
  FanMeshMaker(*this, vertices, geometry, triangulation, fixedEdges, monitor).make();
}

void FanMesh::renumber(const Buffer<std::uint32_t>& order, Monitor& monitor)
{
  const std::size_t vertexCount = order.size();
  const std::size_t count = this->triangles.size();
  Buffer<std::uint32_t> rank(vertexCount);
  eachChunk(vertexCount, SitesPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t k = begin; k < end; ++k)
      {
        rank[order[k]] = static_cast<std::uint32_t>(k);
      }
    });
  // Triangles go by their first vertex.
  const auto firstOf = [&](std::size_t t)
  {
    const std::uint32_t* v = this->triangles[t].v;
    return std::min(std::min(rank[v[0]], rank[v[1]]), rank[v[2]]);
  };
  Buffer<std::uint32_t> next(vertexCount + 1);
  std::fill(next.begin(), next.end(), 0);
  monitor.poll();
  for (std::size_t t = 0; t < count; ++t)
  {
    ++next[firstOf(t) + 1];
  }
  for (std::size_t k = 0; k < vertexCount; ++k)
  {
    next[k + 1] += next[k];
  }
  Buffer<std::uint32_t> numberOf(count);
  monitor.poll();
  for (std::size_t t = 0; t < count; ++t)
  {
    numberOf[t] = next[firstOf(t)]++;
  }
  Buffer<Triangle> moved(count);
  Buffer<std::uint32_t> movedCells(count);
  eachChunk(count, FacetsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      monitor.poll();
      for (std::size_t t = begin; t < end; ++t)
      {
        Triangle& triangle = moved[numberOf[t]];
        triangle = this->triangles[t];
        for (int i = 0; i < 3; ++i)
        {
          const std::uint32_t twin = triangle.twin[i];
          triangle.v[i] = rank[triangle.v[i]];
          triangle.twin[i] =
            twin == NoIndex ? NoIndex : halfEdge(numberOf[triangleOf(twin)], cornerOf(twin));
        }
        movedCells[numberOf[t]] = this->cells[t];
      }
    });
  this->lowestCellAt.allocate(vertexCount);
  eachChunk(vertexCount, SitesPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t k = begin; k < end; ++k)
      {
        this->lowestCellAt[k] = this->cells[this->lowestAt[order[k]]];
      }
    });
  this->triangles = std::move(moved);
  this->cells = std::move(movedCells);
  for (std::size_t t = count; t-- > 0;)
  {
    for (const std::uint32_t v : this->triangles[t].v)
    {
      this->lowestAt[v] = static_cast<std::uint32_t>(t);
    }
  }
}

}
