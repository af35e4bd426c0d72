// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The canonical form (see CellComplex.h) of a polyhedron without flat edges, each of whose facets
/// is one triangle.
///
///   MarkIds      the ids of its points, as a set of bits
///   CountIds     how many are in each word of it  (a prefix sum counts how many are below one)
///   RankPoints   the number of each vertex in the result, and the ids in ascending order
///   MakeCells    each triangle's cell, lowest corner first; its share of volume and area
///   WriteCells   the cells, once they are sorted
///
/// The shares are added as integers (Measure.h), so their order does not matter.
#ifndef flipflop_FinishKernels_h
#define flipflop_FinishKernels_h

#include "Finish/Measure.h"
#include "Mesh/Mesh.h"
#include "Rounds/Atomics.h"
#include "Rounds/Counters.h"
#include "Rounds/Kernel.h"
#include "Support/BitCount.h"

#include <cstdint>

namespace flipflop
{

/// What the kernels work on, in the executor's memory.
struct FinishData
{
  static constexpr std::uint32_t WordSize = 64;
  /// As many sums side by side: threads that add to one and the same wait for each other.
  static constexpr std::uint32_t SumCount = 64;

  Mesh mesh;
  const std::uint32_t* lowest; ///< by vertex: the lowest id at its position
  const std::uint32_t* sameAs; ///< three by vertex, see FlipData
  std::uint64_t* words;        ///< the set of ids
  std::uint32_t* below;        ///< by word: ids in it, then those in all before
  std::uint32_t* rank;         ///< by vertex; NoIndex: no point of the result
  std::uint32_t* ids;          ///< by rank
  std::uint64_t* keys;         ///< by cell: its two lower corners
  std::uint32_t* thirds;       ///< by cell: the third one
  int cornerBits;              ///< of a key that hold the second corner
  MeasureSums* sums;
  Counters* counters;
};

/// Over the vertices.
struct MarkIds : Kernel
{
  static constexpr const char* Name = "mark ids";
  static constexpr int Bytes = 4 + 4 + 12 + 8;
  FinishData data;

  FF_HD void operator()(std::uint32_t v, Local&) const
  {
    const FinishData& d = this->data;
    const std::uint32_t* const same = d.sameAs + 3 * std::size_t(v);
    if ((same[0] & same[1] & same[2]) != NoIndex)
    {
      atomics::store(&d.counters->duplicatesGone, 1u);
    }
    const std::uint32_t flags = d.mesh.vertices[v].flags;
    d.rank[v] = NoIndex;
    if ((flags & (VertexAlive | VertexVirtual)) != VertexAlive)
    {
      return;
    }
    if (flags & VertexLabelled)
    {
      atomics::store(&d.counters->labelledAlive, 1u);
    }
    const std::uint32_t id = d.lowest[v];
    d.rank[v] = id; // until RankPoints
    atomics::setBits(
      &d.words[id / FinishData::WordSize], std::uint64_t(1) << (id % FinishData::WordSize));
  }
};

/// Over the words.
struct CountIds : Kernel
{
  static constexpr const char* Name = "count ids";
  static constexpr int Bytes = 8 + 4;
  FinishData data;

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    this->data.below[i] = bitCount(this->data.words[i]);
  }
};

/// Over the vertices.
struct RankPoints : Kernel
{
  static constexpr const char* Name = "rank points";
  static constexpr int Bytes = 4 + 8 + 4 + 4 + 4;
  FinishData data;
  std::uint32_t lastWord;

  FF_HD void operator()(std::uint32_t v, Local&) const
  {
    const FinishData& d = this->data;
    const std::uint32_t id = d.rank[v];
    if (id == NoIndex)
    {
      return;
    }
    const std::uint32_t word = id / FinishData::WordSize;
    const std::uint32_t rank =
      d.below[word] + bitCountBelow(d.words[word], id % FinishData::WordSize);
    d.rank[v] = rank;
    d.ids[rank] = id;
    if (rank == 0)
    {
      d.counters->firstPoint = v;
    }
  }
  FF_HD void once() const
  {
    this->data.counters->points =
      this->data.below[this->lastWord] + bitCount(this->data.words[this->lastWord]);
  }
};

/// Over the triangles.
struct MakeCells : Kernel
{
  static constexpr const char* Name = "make cells";
  static constexpr int Bytes = 32 + 3 * 4 + 8 + 4;
  FinishData data;

  FF_HD void operator()(std::uint32_t t, Local&) const { this->makeCell(t); }

protected:
  /// @return the corner of lowest rank; -1: it is no cell
  FF_HD int makeCell(std::uint32_t t) const
  {
    const FinishData& d = this->data;
    const Triangle& triangle = d.mesh.triangles[t];
    if (triangle.flags & TriangleDead)
    {
      return -1;
    }
    const std::uint32_t rank[3] = { d.rank[triangle.v[0]], d.rank[triangle.v[1]],
      d.rank[triangle.v[2]] };
    if (rank[0] == NoIndex || rank[1] == NoIndex || rank[2] == NoIndex)
    {
      return -1; // at the virtual vertex
    }
    const bool second = rank[1] < rank[0] && rank[1] < rank[2];
    const bool third = rank[2] < rank[0] && rank[2] < rank[1];
    const std::uint32_t slot = atomics::add(&d.counters->cells, 1u);
    const std::uint64_t lowest = second ? rank[1] : third ? rank[2] : rank[0];
    d.keys[slot] = lowest << d.cornerBits | (second ? rank[2] : third ? rank[0] : rank[1]);
    d.thirds[slot] = second ? rank[0] : third ? rank[1] : rank[2];
    return second ? 1 : third ? 2 : 0;
  }
};

/// Over the triangles.
struct MakeMeasuredCells : MakeCells
{
  static constexpr const char* Name = "make measured cells";
  static constexpr int Bytes = MakeCells::Bytes + 3 * 24;
  struct Local
  {
    MeasureSums sums;
    std::uint32_t slot = 0;
  };
  Measure measure;

  FF_HD Local begin() const { return Local(); }
  FF_HD void operator()(std::uint32_t t, Local& local) const
  {
    const int first = this->makeCell(t);
    if (first < 0)
    {
      return;
    }
    const Mesh& mesh = this->data.mesh;
    const Triangle& triangle = mesh.triangles[t];
    const std::uint32_t a = triangle.v[first];
    const std::uint32_t b = triangle.v[nextCorner(first)];
    const std::uint32_t c = triangle.v[previousCorner(first)];
    this->measure.addTriangle(mesh.vertices[this->data.counters->firstPoint].x, mesh.vertices[a].x,
      mesh.vertices[b].x, mesh.vertices[c].x, local.sums);
    local.slot = t % FinishData::SumCount;
  }
  FF_HD void end(const Local& local) const
  {
    MeasureSums& sums = this->data.sums[local.slot];
    atomics::add(&sums.volume.high, local.sums.volume.high);
    atomics::add(&sums.volume.low, local.sums.volume.low);
    atomics::add(&sums.area.high, local.sums.area.high);
    atomics::add(&sums.area.low, local.sums.area.low);
  }
};

/// Over the cells, in their order.
struct WriteCells : Kernel
{
  static constexpr const char* Name = "write cells";
  static constexpr int Bytes = 8 + 4 + 12;
  const std::uint64_t* keys;
  const std::uint32_t* thirds;
  int cornerBits;
  std::uint32_t* corners; ///< three by cell

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    const std::uint64_t key = this->keys[i];
    std::uint32_t* const cell = this->corners + 3 * std::size_t(i);
    cell[0] = static_cast<std::uint32_t>(key >> this->cornerBits);
    cell[1] = static_cast<std::uint32_t>(key & ((std::uint64_t(1) << this->cornerBits) - 1));
    cell[2] = this->thirds[i];
  }
};

}

#endif
