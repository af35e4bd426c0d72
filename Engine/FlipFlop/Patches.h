// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One round of growing and flipping on a convex polyhedron, by patches.
///
/// The polyhedron's triangles, in their order, are the leaves of a binary tree. A leaf node (a few
/// thousand points) grows its cones and flips inside while all of it is in cache; an inner node
/// joins its children: it links the triangles along their common seam and flips what that brings
/// up. Nodes at the same height share no triangle, so they are tasks; what they do does not depend
/// on the number of threads.
#ifndef flipflop_Patches_h
#define flipflop_Patches_h

#include "FlipFlop/ConflictLists.h"
#include "FlipFlop/Flipper.h"
#include "FlipFlop/Growth.h"
#include "FlipFlop/Tally.h"
#include "Mesh/Polyhedron.h"
#include "Support/Monitor.h"
#include "Support/Parallel.h"
#include "Support/Stopwatch.h"

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <utility>
#include <vector>

namespace flipflop
{

template <class Geometry>
class Patches
{
public:
  Patches(const Geometry& geometry, Polyhedron&& base, ConflictLists&& points, bool vBiased,
    Monitor& monitor)
    : geometry(geometry)
    , vBiased(vBiased)
    , monitor(monitor)
    , baseTriangles(base.triangleCount())
    , baseVertices(base.vertexCount())
    , points(std::move(points))
  {
    const std::size_t grown = this->points.vertices.size() - this->baseVertices;
    const std::size_t triangleCount = this->baseTriangles + 2 * grown;
    // Half-edges, then border slots, then NoIndex.
    if (4 * triangleCount + 4 * std::size_t(this->baseTriangles) >= NoIndex)
    {
      throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(grown));
    }
    this->triangles.allocate(triangleCount);
    this->baseTwins.allocate(4 * std::size_t(this->baseTriangles));
    this->border.allocate(4 * std::size_t(this->baseTriangles));
    this->reach.allocate(this->baseVertices);
    this->mesh.triangles = this->triangles.data();
    this->mesh.vertices = this->points.vertices.data();
    this->mesh.border = this->border.data();
    this->mesh.borderBegin = NoIndex - 4 * this->baseTriangles;

    for (Reach& r : this->reach)
    {
      r = { NoIndex, 0 };
    }
    for (std::uint32_t t = 0; t < this->baseTriangles; ++t)
    {
      const Triangle& triangle = base.triangles[t];
      this->triangles[t] = triangle;
      this->triangles[t].flags = 0;
      this->triangles[t].flatEdges = 0;
      for (int e = 0; e < 3; ++e)
      {
        this->baseTwins[halfEdge(t, e)] = triangle.twin[e];
        Reach& r = this->reach[triangle.v[e]];
        r.first = std::min(r.first, t);
        r.last = std::max(r.last, t);
      }
    }
  }

  /// Grow and flip everything.
  Tally run()
  {
    Node root = this->visit(0, this->baseTriangles);
    ensure(root.border.empty() && root.deferred.empty());
    return std::move(root.tally);
  }

  /// The polyhedron that came of it, in the patches' order; nothing else remains here.
  Polyhedron release()
  {
    std::sort(this->leaves.begin(), this->leaves.end(),
      [](const Leaf& a, const Leaf& b) { return a.base.begin < b.base.begin; });
    Polyhedron result;
    for (const Leaf& leaf : this->leaves)
    {
      result.pieces.push_back(leaf.base);
      result.pieces.push_back(leaf.grown);
    }
    result.vertices = std::move(this->points.vertices);
    result.triangles = std::move(this->triangles);
    return result;
  }

private:
  struct Reach
  {
    std::uint32_t first; ///< lowest and highest base triangle at a base vertex
    std::uint32_t last;
  };

  /// A leaf's triangles: of the base, and grown.
  struct Leaf
  {
    Piece base;
    Piece grown;
  };

  struct Node
  {
    bool done = false;                   ///< false: its task was cancelled
    std::vector<std::uint32_t> border;   ///< base half-edges on the patch's border
    std::vector<std::uint32_t> deferred; ///< edges that this patch may not finish
    Tally tally;
  };

  /// A vertex of the base that triangles outside the patch share.
  struct SharedOutside
  {
    const Reach* reach;
    std::uint32_t count, first, last;
    bool operator()(std::uint32_t v) const
    {
      return v < this->count &&
        (this->reach[v].first < this->first || this->reach[v].last >= this->last);
    }
  };

  using PatchFlipper = Flipper<Geometry, SharedOutside>;

  SharedOutside sharedOutside(std::uint32_t first, std::uint32_t last) const
  {
    return { this->reach.data(), this->baseVertices, first, last };
  }

  static constexpr std::uint32_t LeafPoints = 4096;

  Node visit(std::uint32_t first, std::uint32_t last)
  {
    const Buffer<std::uint32_t>& begin = this->points.begin;
    if (last - first == 1 || begin[last] - begin[first] + 2 * (last - first) <= LeafPoints)
    {
      return this->visitLeaf(first, last);
    }
    // Halve the work: points and triangles.
    const auto weight = [&begin](std::uint32_t t)
    { return static_cast<std::uint64_t>(begin[t]) + 2 * static_cast<std::uint64_t>(t); };
    const std::uint64_t half = (weight(first) + weight(last)) / 2;
    std::uint32_t low = first + 1;
    std::uint32_t high = last - 1;
    while (low < high)
    {
      const std::uint32_t middle = low + (high - low) / 2;
      weight(middle) < half ? low = middle + 1 : high = middle;
    }
    Node left, right;
    threads::invoke(
      [&] { left = this->visit(first, low); }, [&] { right = this->visit(low, last); });
    // Another task threw, and this one's context was cancelled with all below it: then the call
    // above returns though not all is done. What was thrown there is what the caller will see.
    if (!left.done || !right.done)
    {
      throw Error(ErrorCode::Aborted);
    }
    return this->join(std::move(left), std::move(right), first, last);
  }

  Node visitLeaf(std::uint32_t first, std::uint32_t last)
  {
    Node node;
    const Geometry local = this->geometry; // counts its own exact calls
    for (std::uint32_t t = first; t < last; ++t)
    {
      for (int e = 0; e < 3; ++e)
      {
        const std::uint32_t h = halfEdge(t, e);
        const std::uint32_t other = triangleOf(this->baseTwins[h]);
        if (other < first || other >= last)
        {
          this->mesh.link(h, this->mesh.borderBegin + h);
          node.border.push_back(h);
        }
      }
    }

    Stopwatch watch;
    const std::uint32_t firstGrown =
      this->baseTriangles + 2 * (this->points.begin[first] - this->baseVertices);
    std::uint32_t next = firstGrown;
    {
      Growth<Geometry> growth(local, this->mesh, node.tally.duplicates, this->monitor);
      for (std::uint32_t t = first; t < last; ++t)
      {
        this->growTriangle(growth, local, t, next);
      }
      node.tally.statistics.insertions = growth.insertionCount();
      node.tally.statistics.moves = growth.moveCount();
    }
    node.tally.statistics.secondsGrow = watch.lap();

    PatchFlipper flipper(
      local, this->mesh, this->sharedOutside(first, last), this->vBiased, this->monitor);
    this->checkAll(flipper, first, last);
    this->checkAll(flipper, firstGrown, next);
    flipper.run();
    this->finishNode(node, flipper, local);
    node.tally.statistics.secondsFlip = watch.lap();
    this->addLeaf({ { first, last }, { firstGrown, next } });
    this->monitor.advance(this->points.begin[last] - this->points.begin[first]);
    return node;
  }

  void growTriangle(
    Growth<Geometry>& growth, const Geometry& local, std::uint32_t t, std::uint32_t& next)
  {
    const std::uint32_t begin = this->points.begin[t];
    const std::uint32_t end = this->points.begin[t + 1];
    if (begin == end)
    {
      return;
    }
    const Vertex* v = this->mesh.vertices;
    const Triangle& triangle = this->mesh.triangles[t];
    const typename Geometry::Plane plane(
      local, v[triangle.v[0]], v[triangle.v[1]], v[triangle.v[2]]);
    Furthest furthest;
    for (std::uint32_t i = begin; i < end; ++i)
    {
      furthest.offer(plane.height(v[i].x), v[i].id, i);
    }
    growth.grow(t, begin, end, furthest, next);
  }

  /// Check every edge once, and what its flips bring up, while it is near.
  void checkAll(PatchFlipper& flipper, std::uint32_t first, std::uint32_t last)
  {
    for (std::uint32_t t = first; t < last; ++t)
    {
      const Triangle& triangle = this->mesh.triangles[t];
      std::uint32_t edges[3];
      int count = 0;
      for (int e = 0; e < 3; ++e)
      {
        if (!(triangle.flags & TriangleDead) && triangle.twin[e] > halfEdge(t, e))
        {
          edges[count++] = halfEdge(t, e);
        }
      }
      flipper.pushConcerned(edges, count);
      flipper.checkWaiting();
    }
  }

  Node join(Node&& left, Node&& right, std::uint32_t first, std::uint32_t last)
  {
    Node node;
    const Geometry local = this->geometry;
    Stopwatch watch;
    PatchFlipper flipper(
      local, this->mesh, this->sharedOutside(first, last), this->vBiased, this->monitor);
    std::vector<std::uint32_t> seam;
    for (const Node* child : { &left, &right })
    {
      for (const std::uint32_t h : child->border)
      {
        const std::uint32_t twin = this->baseTwins[h];
        const std::uint32_t other = triangleOf(twin);
        if (other < first || other >= last)
        {
          node.border.push_back(h);
        }
        else if (child == &left)
        {
          seam.push_back(this->border[h]);
          this->mesh.link(this->border[h], this->border[twin]);
        }
      }
    }
    for (const Node* child : { &left, &right })
    {
      for (const std::uint32_t h : child->deferred)
      {
        flipper.push(h);
      }
    }
    for (const std::uint32_t h : seam)
    {
      flipper.push(h);
    }
    flipper.run();
    node.tally = std::move(left.tally);
    node.tally.add(std::move(right.tally));
    Node own;
    this->finishNode(own, flipper, local);
    own.tally.statistics.secondsFlip = watch.lap();
    node.deferred = std::move(own.deferred);
    node.done = true;
    node.tally.add(std::move(own.tally));
    return node;
  }

  void finishNode(Node& node, PatchFlipper& flipper, const Geometry& local)
  {
    flipper.addTo(node.tally);
    node.tally.addPredicates(local, this->geometry);
    node.deferred = std::move(flipper.deferred);
    node.done = true;
  }

  void addLeaf(const Leaf& leaf)
  {
    std::lock_guard<std::mutex> lock(this->leavesMutex);
    this->leaves.push_back(leaf);
  }

  const Geometry& geometry;
  bool vBiased;
  Monitor& monitor;
  std::uint32_t baseTriangles;
  std::uint32_t baseVertices;
  ConflictLists points;
  Buffer<Triangle> triangles;
  Buffer<std::uint32_t> baseTwins; ///< by half-edge of the base
  Buffer<std::uint32_t> border;    ///< slots, by half-edge of the base
  Buffer<Reach> reach;             ///< by vertex of the base
  Mesh mesh;
  std::mutex leavesMutex;
  std::vector<Leaf> leaves;
};

}

#endif
