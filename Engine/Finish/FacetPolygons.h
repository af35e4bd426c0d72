// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// True facets, found by walking around the triangles that flat edges join. Vertices that the
/// finish has removed, inside facets and true edges, are passed over.
///
/// Every half-edge of a facet's border could start the walk; the lowest does. So threads look for
/// facets piece by piece, and each walk ends where it meets a lower half-edge. Few facets are long,
/// and of these every half-edge may walk far: one thread walks around them at last, once each.
///
/// Grids are full of facets of two triangles. Where triangles are requested, these need no walk:
/// the diagonal from the corner of lowest rank parts them, and they are two facets from then on.
#ifndef flipflop_FacetPolygons_h
#define flipflop_FacetPolygons_h

#include "Finish/VertexRanks.h"
#include "Mesh/Polyhedron.h"
#include "Support/Monitor.h"
#include "Support/Parallel.h"
#include <flipflop/Buffer.h>
#include <flipflop/Error.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace flipflop
{

/// The true facets of two and more triangles, as polygons of vertices, the one of lowest rank
/// first. One whose other vertices are removed is a triangle.
/// @tparam Surface Polyhedron, or PlanePolyhedron; flatEdges() holds the flat edges
template <class Surface>
class FacetPolygons
{
public:
  /// @param partPairs those of two triangles are no polygons, but parted in the surface
  /// @throw Error Aborted
  FacetPolygons(Surface& surfaceToWalk, const VertexRanks& ranks, bool partPairs, Monitor& monitor)
    : surface(surfaceToWalk)
    , rank(ranks)
  {
    std::vector<Found> parts(this->surface.pieceCount());
    this->surface.eachFlatTriangle(
      [&](std::uint32_t t, std::size_t piece)
      {
        if ((t & 0xFFF) == 0)
        {
          monitor.poll();
        }
        const std::uint32_t other = partPairs ? this->otherOfPair(t) : NoIndex;
        if (other != NoIndex && triangleOf(other) < t)
        {
          return; // the lowest half-edge of its border is the other's
        }
        if (other != NoIndex && this->isOfPoints(t) && this->isOfPoints(triangleOf(other)))
        {
          // What is in another piece, waits: its thread may examine it now.
          if (triangleOf(other) < this->surface.pieceEnd(piece))
          {
            this->partPair(t, other);
          }
          else
          {
            parts[piece].pairs.push_back(t);
          }
          return;
        }
        for (int e = 0; e < 3; ++e)
        {
          if ((this->surface.flatEdges(t) >> e & 1) == 0)
          {
            this->walkIfShort(halfEdge(t, e), parts[piece]);
          }
        }
      });
    eachTask(parts.size(),
      [&](std::size_t piece)
      {
        for (const std::uint32_t t : parts[piece].pairs)
        {
          this->partPair(t, this->otherOfPair(t));
        }
      });
    parts.push_back(this->walkLong(parts, monitor));
    this->gather(parts);
  }

  std::size_t count() const { return this->end.size(); }
  bool areTriangles() const { return this->corners.size() == 3 * this->count(); }
  const std::uint32_t* first(std::size_t p) const
  {
    return this->corners.data() + (p == 0 ? 0 : this->end[p - 1]);
  }
  std::size_t size(std::size_t p) const { return this->end[p] - (p == 0 ? 0 : this->end[p - 1]); }

  /// use(number, run) for every polygon, in parallel by runs: no more than the surface has pieces.
  template <class Use>
  void each(Use&& use) const
  {
    eachChunk(this->count(), 1 + this->count() / this->surface.pieceCount(),
      [&](std::size_t begin, std::size_t last, std::size_t run)
      {
        for (std::size_t p = begin; p < last; ++p)
        {
          use(p, run);
        }
      });
  }

private:
  struct Found
  {
    std::vector<std::uint32_t> corners; ///< of the polygons, one after another
    std::vector<std::size_t> ends;      ///< of each polygon, among these
    std::vector<std::uint32_t> starts;  ///< half-edges of long ones, maybe several of one
    std::vector<std::uint32_t> pairs;   ///< the lower triangles of those that are in two pieces
  };

  /// The flat edge of a triangle that has just one; 3: it has none, or more.
  int onlyFlatEdge(std::uint32_t t) const
  {
    static constexpr std::int8_t Edge[8] = { 3, 0, 1, 3, 2, 3, 3, 3 };
    return Edge[this->surface.flatEdges(t)];
  }

  /// Of a facet that is just two triangles: the half-edge of the other one on the edge between
  /// them; else NoIndex.
  std::uint32_t otherOfPair(std::uint32_t t) const
  {
    const int e = this->onlyFlatEdge(t);
    if (e == 3)
    {
      return NoIndex;
    }
    const std::uint32_t twin = this->surface.triangles[t].twin[e];
    return this->onlyFlatEdge(triangleOf(twin)) == cornerOf(twin) ? twin : NoIndex;
  }

  bool isOfPoints(std::uint32_t t) const
  {
    const std::uint32_t* const v = this->surface.triangles[t].v;
    return std::all_of(v, v + 3, [this](std::uint32_t i) { return this->rank[i] != NoIndex; });
  }

  /// Part the facet of abc, of triangle t, and bad, of @p ba, by the diagonal from its corner of
  /// lowest rank: they stay, or become cad and dbc.
  void partPair(std::uint32_t t, std::uint32_t ba)
  {
    const std::uint32_t u = triangleOf(ba);
    std::uint32_t* const near = this->surface.triangles[t].v;
    std::uint32_t* const far = this->surface.triangles[u].v;
    const int e = this->onlyFlatEdge(t);
    const std::uint32_t a = near[e];
    const std::uint32_t b = near[nextCorner(e)];
    const std::uint32_t c = near[previousCorner(e)];
    const std::uint32_t d = far[previousCorner(cornerOf(ba))];
    const std::uint32_t ab = std::min(this->rank[a], this->rank[b]);
    const std::uint32_t cd = std::min(this->rank[c], this->rank[d]);
    const bool turns = cd < ab;
    near[0] = turns ? c : a;
    near[1] = turns ? a : b;
    near[2] = turns ? d : c;
    far[0] = turns ? d : b;
    far[1] = turns ? b : a;
    far[2] = turns ? c : d;
    this->surface.clearFlatEdges(t);
    this->surface.clearFlatEdges(u);
  }

  /// Put the polygons of all parts one after another.
  void gather(const std::vector<Found>& parts)
  {
    std::vector<std::size_t> polygonBegin{ 0 };
    std::vector<std::size_t> cornerBegin{ 0 };
    for (const Found& part : parts)
    {
      polygonBegin.push_back(polygonBegin.back() + part.ends.size());
      cornerBegin.push_back(cornerBegin.back() + part.corners.size());
    }
    this->end.allocate(polygonBegin.back());
    this->corners.allocate(cornerBegin.back());
    eachTask(parts.size(),
      [&](std::size_t i)
      {
        const Found& part = parts[i];
        std::copy(part.corners.begin(), part.corners.end(), this->corners.begin() + cornerBegin[i]);
        std::transform(part.ends.begin(), part.ends.end(), this->end.begin() + polygonBegin[i],
          [&](std::size_t last) { return cornerBegin[i] + last; });
      });
  }

  /// The half-edge after h along its facet's border.
  template <class Step>
  std::uint32_t following(std::uint32_t h, const Step& step) const
  {
    h = nextHalfEdge(h);
    while ((this->surface.flatEdges(triangleOf(h)) >> cornerOf(h) & 1) != 0)
    {
      step();
      h = nextHalfEdge(this->surface.triangles[triangleOf(h)].twin[cornerOf(h)]);
    }
    return h;
  }

  void walkIfShort(std::uint32_t start, Found& found) const
  {
    constexpr int Long = 32;
    const std::size_t first = found.corners.size();
    int steps = 0;
    std::uint32_t h = start;
    do
    {
      found.corners.push_back(this->origin(h));
      h = this->following(h, [&steps] { ++steps; });
    } while (h > start && ++steps < Long);
    if (h == start)
    {
      this->close(first, found);
      return;
    }
    found.corners.resize(first);
    if (h > start)
    {
      found.starts.push_back(start);
    }
  }

  Found walkLong(const std::vector<Found>& parts, Monitor& monitor) const
  {
    Found found;
    StepPoll poll(monitor);
    std::vector<std::uint8_t> visited; // bit e: half-edge e of a triangle
    for (const Found& part : parts)
    {
      for (const std::uint32_t start : part.starts)
      {
        visited.resize(this->surface.triangleCount());
        if (visited[triangleOf(start)] >> cornerOf(start) & 1)
        {
          continue;
        }
        const std::size_t first = found.corners.size();
        std::uint32_t h = start;
        do
        {
          poll.step();
          visited[triangleOf(h)] |= static_cast<std::uint8_t>(1 << cornerOf(h));
          found.corners.push_back(this->origin(h));
          h = this->following(h, [&poll] { poll.step(); });
        } while (h != start);
        this->close(first, found);
      }
    }
    return found;
  }

  /// The vertices from @p first on are around a polygon, unless one is virtual, or all are at one
  /// position. In a plane's triangulation by parts none is removed.
  void close(std::size_t first, Found& found) const
  {
    const auto front = found.corners.begin() + static_cast<std::ptrdiff_t>(first);
    auto back = found.corners.end();
    const auto rankOf = [this](std::uint32_t v) { return this->rank[v]; };
    if constexpr (std::is_same_v<Surface, Polyhedron>)
    {
      const auto isNoPoint = [&](std::uint32_t v) { return rankOf(v) == NoIndex; };
      const bool touchesVirtual = std::any_of(front, back,
        [&](std::uint32_t v)
        { return isNoPoint(v) && (this->surface.vertices[v].flags & VertexVirtual) != 0; });
      back = touchesVirtual ? front : std::unique(front, std::remove_if(front, back, isNoPoint));
      back -= back - front > 1 && *front == *(back - 1) ? 1 : 0;
    }
    const auto size = back - front;
    ensure(size != 2);
    found.corners.erase(size > 2 ? back : front, found.corners.end());
    if (size > 2)
    {
      const auto lowest = std::min_element(
        front, back, [&](std::uint32_t a, std::uint32_t b) { return rankOf(a) < rankOf(b); });
      std::rotate(front, lowest, back);
      found.ends.push_back(found.corners.size());
    }
  }

  std::uint32_t origin(std::uint32_t h) const
  {
    return this->surface.triangles[triangleOf(h)].v[cornerOf(h)];
  }

  Surface& surface;
  const VertexRanks& rank;
  Buffer<std::uint32_t> corners; ///< of the polygons, one after another
  Buffer<std::size_t> end;       ///< of each polygon, among these
};

}

#endif
