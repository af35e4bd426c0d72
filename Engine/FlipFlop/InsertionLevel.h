// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Insert one level of points by many threads, which need no locks.
///
/// The points, in the curve's order, are cut into chunks. Each point finds its triangle in the mesh
/// as it is; a triangle with all of its points goes to the first chunk that has one there. So the
/// mesh falls into patches, each near one piece of the curve, and a task inserts a patch's points
/// in it alone. A star-shaped polyhedron may wait with its flips: edges at the border of a patch
/// are tested when both sides are done. So wait the few points whose walk would leave their patch,
/// and labels of vertices that several patches share.
///
/// Patches are joined in pairs, and so on up a tree: height h joins 2^h that follow each other on
/// the curve. A task joins two neighbours, tests the edges between them, and does what waited for
/// that. What still has to wait goes up.
///
/// A triangle at the border names no neighbour but a slot, see Mesh.h.
#ifndef flipflop_InsertionLevel_h
#define flipflop_InsertionLevel_h

#include "FlipFlop/Insertion.h"
#include "FlipFlop/Tally.h"
#include "Mesh/Polyhedron.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

template <class Geometry>
class InsertionLevel
{
public:
  /// @param trianglesInUse of the polyhedron, the first; they are a convex one
  InsertionLevel(const Geometry& geometryToUse, Polyhedron& polyhedron,
    std::uint32_t trianglesInUse, bool vBiasedFlips, Monitor& monitorToUse)
    : geometry(geometryToUse)
    , mesh(polyhedron.mesh())
    , inUse(trianglesInUse)
    , vBiased(vBiasedFlips)
    , monitor(monitorToUse)
  {
  }

  /// Divide the triangles among patches, for the vertices from @p begin to @p end of the mesh's
  /// array; nothing is inserted yet.
  /// @param parts at least two; of some thousand points each
  /// @param tally counts the way to the points' triangles
  /// @return how many half-edges are between patches: where they are many, so are the flips that
  ///         will wait for the whole
  std::size_t divide(std::uint32_t begin, std::uint32_t end, std::uint32_t parts, Tally& tally)
  {
    this->firstSlot = begin;
    this->vertexCount = begin;
    this->count = end - begin;
    this->found.allocate(this->count);
    this->patches.resize(parts);
    const auto chunkBegin = [this, begin, parts](std::uint32_t k)
    { return begin + partBegin(this->count, parts, k); };
    eachPart([&](std::uint32_t k) { this->locate(chunkBegin(k), chunkBegin(k + 1), k); });
    for (Patch& patch : this->patches)
    {
      tally.add(std::exchange(patch.tally, Tally()));
    }
    this->takeTriangles(chunkBegin);
    this->distribute(chunkBegin);
    this->findBorder();
    return this->border.size();
  }

  /// Insert the vertices, after divide().
  /// @return how many flips waited for a join
  std::int64_t insert(Tally& tally)
  {
    this->separate();
    eachPart([&](std::uint32_t k) { this->insertPart(k); });
    for (std::uint32_t height = 1; height <= this->top(); ++height)
    {
      eachTask(this->joints[height].size(),
        [&](std::size_t k) { this->join(height, static_cast<std::uint32_t>(k)); });
    }
    return this->end(tally);
  }

  /// How many triangles are in use after insert(), some of them dead.
  std::uint32_t trianglesInUse() const { return this->inUse + 2 * this->count; }

private:
  static constexpr std::uint32_t TrianglesPerTask = 1 << 13;

  /// Bit of an owner that took its triangle from a neighbour.
  static constexpr std::uint32_t Adopted = 0x80000000u;

  /// Does a vertex have triangles outside of what is joined at this height?
  struct SharedOutside
  {
    const std::uint8_t* innerAt; ///< by vertex of the base: the height from which on it has none
    std::uint32_t count;
    std::uint32_t height;
    bool operator()(std::uint32_t v) const
    {
      return v < this->count && this->height < this->innerAt[v];
    }
  };
  using PatchFlipper = Flipper<Geometry, SharedOutside>;

  struct BorderEdge
  {
    std::uint32_t halfEdge;
    std::uint32_t twin;
  };

  struct Patch
  {
    std::vector<std::uint32_t> pointSlots; ///< of its points, in their order
    std::uint32_t firstFree;               ///< triangle
    std::uint32_t lastFree;
    std::vector<std::uint32_t> blocked;  ///< slots: of points that wait
    std::vector<std::uint32_t> deferred; ///< half-edges that wait; of what is joined, the first's
    std::int64_t waited = 0;             ///< flips, likewise
    Tally tally;
  };

  template <class Use>
  void eachPart(Use&& use)
  {
    eachTask(this->patches.size(), [&](std::size_t k) { use(static_cast<std::uint32_t>(k)); });
  }

  /// use(t) for every triangle of the base, in parallel.
  template <class Use>
  void eachTriangle(Use&& use)
  {
    eachChunk(this->inUse, TrianglesPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t)
        {
          if (!(this->mesh.triangles[t].flags & TriangleDead))
          {
            use(t);
          }
        }
      });
  }

  /// Find the triangles of a chunk's points, in the mesh as it is.
  void locate(std::uint32_t begin, std::uint32_t end, std::uint32_t part)
  {
    const Geometry local = this->geometry;
    Tally& tally = this->patches[part].tally;
    std::uint32_t last = this->anyTriangle();
    for (std::uint32_t slot = begin; slot < end; ++slot)
    {
      const Located at = locateFrom(
        local, this->mesh, last, this->mesh.vertices[slot], this->inUse, tally.statistics.moves);
      ensure(at.triangle != NoIndex);
      this->found[slot - this->firstSlot] = last = at.triangle;
      if (slot % StepPoll::Every == 0)
      {
        this->monitor.poll();
      }
    }
    tally.addPredicates(local, this->geometry);
  }

  std::uint32_t anyTriangle() const
  {
    std::uint32_t t = 0;
    while (this->mesh.triangles[t].flags & TriangleDead)
    {
      ++t;
    }
    return t;
  }

  std::uint32_t foundAt(std::uint32_t slot) const { return this->found[slot - this->firstSlot]; }

  /// Give each triangle to the first chunk with a point in it; one without points goes to a
  /// neighbour's, or to none.
  template <class ChunkBegin>
  void takeTriangles(ChunkBegin&& chunkBegin)
  {
    this->owner = std::vector<std::atomic<std::uint32_t>>(this->inUse);
    eachTriangle(
      [&](std::uint32_t t) { this->owner[t].store(NoIndex, std::memory_order_relaxed); });
    eachPart(
      [&](std::uint32_t k)
      {
        for (std::uint32_t slot = chunkBegin(k); slot < chunkBegin(k + 1); ++slot)
        {
          std::atomic<std::uint32_t>& of = this->owner[this->foundAt(slot)];
          std::uint32_t was = of.load(std::memory_order_relaxed);
          while (k < was && !of.compare_exchange_weak(was, k, std::memory_order_relaxed))
          {
          }
        }
      });
    eachTriangle(
      [&](std::uint32_t t)
      {
        if (this->owner[t].load(std::memory_order_relaxed) != NoIndex)
        {
          return;
        }
        std::uint32_t least = NoIndex;
        for (const std::uint32_t twin : this->mesh.triangles[t].twin)
        {
          const std::uint32_t of = this->owner[triangleOf(twin)].load(std::memory_order_relaxed);
          // What adopts at this moment is none yet.
          least = of & Adopted ? least : std::min(least, of);
        }
        this->owner[t].store(
          least == NoIndex ? NoIndex : least | Adopted, std::memory_order_relaxed);
      });
  }

  std::uint32_t ownerOf(std::uint32_t t) const
  {
    const std::uint32_t of = this->owner[t].load(std::memory_order_relaxed);
    return of == NoIndex ? NoIndex : of & ~Adopted;
  }

  /// Hand the points to the patches, each in the points' order; and space for triangles.
  template <class ChunkBegin>
  void distribute(ChunkBegin&& chunkBegin)
  {
    const std::size_t parts = this->patches.size();
    // From each chunk, to each patch.
    std::vector<std::vector<std::vector<std::uint32_t>>> sent(parts);
    eachPart(
      [&](std::uint32_t k)
      {
        sent[k].resize(parts);
        for (std::uint32_t slot = chunkBegin(k); slot < chunkBegin(k + 1); ++slot)
        {
          sent[k][this->ownerOf(this->foundAt(slot))].push_back(slot);
        }
      });
    eachPart(
      [&](std::uint32_t k)
      {
        for (std::vector<std::vector<std::uint32_t>>& from : sent)
        {
          std::vector<std::uint32_t>& pointSlots = this->patches[k].pointSlots;
          pointSlots.insert(pointSlots.end(), from[k].begin(), from[k].end());
        }
      });
    std::uint32_t free = this->inUse;
    for (Patch& patch : this->patches)
    {
      patch.firstFree = free;
      free += 2 * static_cast<std::uint32_t>(patch.pointSlots.size());
      patch.lastFree = free;
    }
  }

  /// Find the half-edges between patches.
  void findBorder()
  {
    std::vector<std::vector<BorderEdge>> ofRun(chunkCount(this->inUse, TrianglesPerTask));
    eachTriangle(
      [&](std::uint32_t t)
      {
        const Triangle& triangle = this->mesh.triangles[t];
        const std::uint32_t own = this->ownerOf(t);
        for (int e = 0; e < 3; ++e)
        {
          if (this->ownerOf(triangleOf(triangle.twin[e])) != own)
          {
            ofRun[t / TrianglesPerTask].push_back({ halfEdge(t, e), triangle.twin[e] });
          }
        }
      });
    for (const std::vector<BorderEdge>& edges : ofRun)
    {
      this->border.insert(this->border.end(), edges.begin(), edges.end());
    }
  }

  /// The height at which all patches are joined.
  std::uint32_t top() const
  {
    return heightOf(0, static_cast<std::uint32_t>(this->patches.size()) - 1);
  }

  /// The height at which two patches are joined.
  static std::uint32_t heightOf(std::uint32_t a, std::uint32_t b)
  {
    std::uint32_t height = 0;
    while (a >> height != b >> height)
    {
      ++height;
    }
    return height;
  }

  /// Let the patches' borders name slots, and note where each is joined.
  void separate()
  {
    this->slots.allocate(4 * std::size_t(this->inUse));
    this->mesh.border = this->slots.data();
    this->mesh.borderBegin = NoIndex - 4 * this->inUse;
    this->innerAt.assign(this->vertexCount, 0);
    const std::uint32_t root = this->top();
    this->joints.resize(root + 1);
    for (std::uint32_t height = 1; height <= root; ++height)
    {
      this->joints[height].resize(chunkCount(this->patches.size(), std::size_t(1) << height));
    }
    for (const BorderEdge& edge : this->border)
    {
      const std::uint32_t own = this->ownerOf(triangleOf(edge.halfEdge));
      const std::uint32_t other = this->ownerOf(triangleOf(edge.twin));
      const bool toNone = own == NoIndex || other == NoIndex;
      const std::uint32_t height = toNone ? root : heightOf(own, other);
      this->joints[height][toNone ? 0 : own >> height].push_back(edge);
      std::uint8_t& inner = this->innerAt[this->mesh.origin(edge.halfEdge)];
      inner = std::max(inner, static_cast<std::uint8_t>(height));
      this->mesh.link(edge.halfEdge, this->mesh.borderBegin + edge.halfEdge);
    }
  }

  void insertPart(std::uint32_t part)
  {
    Patch& patch = this->patches[part];
    if (patch.pointSlots.empty())
    {
      return;
    }
    const Geometry local = this->geometry;
    PatchFlipper flipper(local, this->mesh, this->sharedOutside(0), this->vBiased, this->monitor);
    const std::uint32_t first = this->foundAt(patch.pointSlots[0]);
    Insertion<Geometry, SharedOutside> insertion(
      local, this->mesh, flipper, first, patch.firstFree, patch.lastFree);
    std::int64_t done = 0;
    for (const std::uint32_t slot : patch.pointSlots)
    {
      if (!insertion.insert(slot) && !insertion.insertFrom(this->foundAt(slot), slot))
      {
        patch.blocked.push_back(slot);
      }
      if (++done % StepPoll::Every == 0)
      {
        this->monitor.advance(StepPoll::Every);
      }
    }
    patch.firstFree = insertion.firstFree();
    patch.deferred = std::move(flipper.deferred);
    insertion.addTo(patch.tally);
    flipper.addTo(patch.tally);
    patch.tally.addPredicates(local, this->geometry);
  }

  SharedOutside sharedOutside(std::uint32_t height) const
  {
    return { this->innerAt.data(), this->vertexCount, height };
  }

  /// Join the two halves of the 2^height patches from k * 2^height on, and do what waited for that.
  void join(std::uint32_t height, std::uint32_t k)
  {
    const auto parts = static_cast<std::uint32_t>(this->patches.size());
    const std::uint32_t first = k << height;
    const std::uint32_t middle = first + (1u << (height - 1));
    if (middle >= parts)
    {
      return; // the first half is all there is
    }
    const std::uint32_t last = std::min(parts, (k + 1) << height);
    const std::vector<BorderEdge>& edges = this->joints[height][k];
    Patch& head = this->patches[first];
    for (const BorderEdge& edge : edges)
    {
      this->mesh.link(this->slots[edge.halfEdge], this->slots[edge.twin]);
    }
    const Geometry local = this->geometry;
    PatchFlipper flipper(
      local, this->mesh, this->sharedOutside(height), this->vBiased, this->monitor);
    for (Patch* half : { &head, &this->patches[middle] })
    {
      for (const std::uint32_t h : std::exchange(half->deferred, {}))
      {
        flipper.push(h);
      }
    }
    for (const BorderEdge& edge : edges)
    {
      flipper.push(this->slots[edge.halfEdge]);
    }
    const std::int64_t flips = head.tally.statistics.flips22;
    flipper.run();
    for (std::uint32_t p = first; p < last; ++p)
    {
      this->insertBlocked(this->patches[p], local, flipper, height == this->top(), head.tally);
    }
    ensure(height < this->top() || flipper.deferred.empty());
    head.deferred = std::move(flipper.deferred);
    flipper.addTo(head.tally);
    head.tally.addPredicates(local, this->geometry);
    head.waited += head.tally.statistics.flips22 - flips;
  }

  /// Insert a patch's points that waited for a join.
  /// @param all of them must be; else those whose way is still too far wait on
  void insertBlocked(
    Patch& patch, const Geometry& local, PatchFlipper& flipper, bool all, Tally& tally)
  {
    if (patch.blocked.empty())
    {
      return;
    }
    const std::uint32_t start = all ? this->anyTriangle() : this->foundAt(patch.blocked[0]);
    Insertion<Geometry, SharedOutside> insertion(
      local, this->mesh, flipper, start, patch.firstFree, this->patches.back().lastFree);
    for (const std::uint32_t slot : std::exchange(patch.blocked, {}))
    {
      if (!insertion.insertFrom(this->foundAt(slot), slot) && !insertion.insert(slot))
      {
        ensure(!all);
        patch.blocked.push_back(slot);
      }
    }
    patch.firstFree = insertion.firstFree();
    insertion.addTo(tally);
  }

  /// @return how many flips waited for a join
  std::int64_t end(Tally& tally)
  {
    std::int64_t waited = 0;
    for (Patch& patch : this->patches)
    {
      for (std::uint32_t t = patch.firstFree; t < patch.lastFree; ++t)
      {
        this->mesh.triangles[t].flags = TriangleDead;
      }
      waited += patch.waited;
      tally.add(std::move(patch.tally));
    }
    return waited;
  }

  const Geometry& geometry;
  Mesh mesh;
  std::uint32_t inUse;
  std::uint32_t vertexCount = 0; ///< of the base
  bool vBiased;
  Monitor& monitor;
  std::uint32_t firstSlot = 0;
  std::uint32_t count = 0;                       ///< of the points
  Buffer<std::uint32_t> found;                   ///< triangle, by point
  std::vector<std::atomic<std::uint32_t>> owner; ///< patch, by triangle
  std::vector<Patch> patches;
  std::vector<BorderEdge> border;
  Buffer<std::uint32_t> slots;
  std::vector<std::uint8_t> innerAt;                        ///< see SharedOutside
  std::vector<std::vector<std::vector<BorderEdge>>> joints; ///< by height, and which there
};

}

#endif
