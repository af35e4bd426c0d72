// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which point of the result each vertex is.
#ifndef flipflop_VertexRanks_h
#define flipflop_VertexRanks_h

#include "Points/Duplicate.h"
#include "Points/Vertex.h"
#include "Support/Monitor.h"
#include "Support/Parallel.h"
#include <flipflop/Buffer.h>
#include <flipflop/Error.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace flipflop
{

/// The points of a result are the vertices, in the order of their ids; of several at one position,
/// the lowest counts.
class VertexRanks
{
public:
  /// @param vertices   Vertex or PlaneVertex; what is not alive is no point
  /// @param duplicates pairs of ids at one position
  /// @param limit      ids are below this
  /// @param pointIds   is filled in
  /// @throw Error Aborted
  template <class AnyVertex>
  VertexRanks(const Buffer<AnyVertex>& vertices, const std::vector<Duplicate>& duplicates,
    std::uint32_t limit, Monitor& monitor, Buffer<std::int64_t>& pointIds)
    : rank(vertices.size()) // until they are numbered the lowest id
  {
    std::vector<std::size_t> counts(chunkCount(vertices.size(), SlotsPerTask));
    eachChunk(vertices.size(), SlotsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t run)
      {
        monitor.poll();
        for (std::size_t v = begin; v < end; ++v)
        {
          const std::uint32_t flags = vertices[v].flags;
          const bool isPoint = (flags & (VertexAlive | VertexVirtual)) == VertexAlive;
          ensure(!isPoint || !(flags & VertexLabelled)); // or a flip is missing
          this->rank[v] = isPoint ? vertices[v].id : NoIndex;
          counts[run] += isPoint ? 1 : 0;
        }
      });
    if (!duplicates.empty())
    {
      this->join(duplicates, monitor);
    }
    pointIds.allocate(std::accumulate(counts.begin(), counts.end(), std::size_t(0)));
    this->number(limit, monitor, pointIds);
  }

  /// NoIndex: the vertex is no point of the result.
  std::uint32_t operator[](std::uint32_t vertex) const { return this->rank[vertex]; }

private:
  static constexpr std::size_t SlotsPerTask = 1 << 14;

  void join(const std::vector<Duplicate>& duplicates, Monitor& monitor);
  void number(std::uint32_t limit, Monitor& monitor, Buffer<std::int64_t>& pointIds);

  Buffer<std::uint32_t> rank; ///< by vertex
};

}

#endif
