// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Associate points to the cones of a convex polyhedron (paper, Algorithm 2, line 3), and drop
/// those inside.
///
/// Runs over the points block by block: the locator dismisses what is certainly inside, and where
/// that is little, as of flat bodies, so do a few planes. The others walk to their cone and stay if
/// they are strictly above its triangle. Each chunk of points keeps its own list; a counting sort
/// by triangle then lays all points out as the growing wants them.
#ifndef flipflop_Associate_h
#define flipflop_Associate_h

#include "FlipFlop/ConflictLists.h"
#include "FlipFlop/GrowthRule.h"
#include "FlipFlop/Tally.h"
#include "Geometry/HullPlanes.h"
#include "Mesh/Polyhedron.h"
#include "Points/PointSource.h"
#include "Points/PointSubset.h"
#include "Points/Samples.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace flipflop
{

template <class Geometry>
class Association
{
public:
  using Locator = typename Geometry::Locator;

  Association(const Geometry& geometry, const PointSource& source, const Polyhedron& base,
    int threads, Monitor& monitor)
    : geometry(geometry)
    , source(source)
    , base(base)
    , threads(threads)
    , monitor(monitor)
    , locator(geometry, base.triangles.data(), base.triangleCount(), base.vertices.data(), monitor)
  {
  }

  /// The polyhedron's vertices and, by triangle, the points outside it.
  /// @param fewPlanes HullPlanes (): of a polyhedron inside the base
  template <class FewPlanes>
  ConflictLists run(const PointSubset& subset, const FewPlanes& fewPlanes, Tally& tally)
  {
    const std::uint32_t wanted =
      this->threads == 1 ? 1 : 4 * static_cast<std::uint32_t>(this->threads);
    // Chunks worth a task, whose cursors take no more memory than their points.
    const std::uint32_t least = std::max(4 * PointsPerRow, this->base.triangleCount());
    this->chunks.resize(std::max(1u, std::min(wanted, subset.count / least)));
    this->tryPlanes(subset, fewPlanes);
    eachTask(this->chunks.size(), [&](std::size_t i) { this->associate(subset, i); });
    for (Chunk& chunk : this->chunks)
    {
      tally.add(std::move(chunk.tally));
    }
    return this->sort();
  }

private:
  struct Located
  {
    std::uint32_t id;
    std::uint32_t triangle;
  };

  struct Chunk
  {
    Buffer<Located> located; ///< space for all; memory is taken as it is written
    std::size_t locatedCount = 0;
    std::vector<std::uint32_t> cursor; ///< by triangle: how many, then where the next goes
    Tally tally;
  };

  /// Where the last walk ended.
  struct Walked
  {
    std::int64_t cell = -1; ///< of the point; -1: there was none
    std::uint32_t triangle = 0;
  };

  /// So many points are walked to from one to the next, however many chunks there are: the walks do
  /// not depend on the threads.
  static constexpr std::uint32_t PointsPerRow = 1 << 12;

  void associate(const PointSubset& subset, std::size_t index)
  {
    Chunk& chunk = this->chunks[index];
    chunk.cursor.assign(this->base.triangleCount(), 0);
    const Geometry local = this->geometry;
    const auto rows = static_cast<std::uint32_t>(chunkCount(subset.count, PointsPerRow));
    const std::uint32_t firstRow = partBegin(rows, this->chunks.size(), index);
    const std::uint32_t lastRow = partBegin(rows, this->chunks.size(), index + 1);
    chunk.located.allocate(std::size_t(PointsPerRow) * (lastRow - firstRow));
    for (std::uint32_t row = firstRow; row < lastRow; ++row)
    {
      this->associateRow(subset, local, row, chunk);
    }
    chunk.tally.addPredicates(local, this->geometry);
  }

  void associateRow(
    const PointSubset& subset, const Geometry& local, std::uint32_t row, Chunk& chunk)
  {
    const std::uint32_t begin = row * PointsPerRow;
    const std::uint32_t end = begin + std::min(PointsPerRow, subset.count - begin);
    const std::uint32_t* const excludedEnd = subset.excluded + subset.excludedCount;
    const std::uint32_t* next = std::lower_bound(subset.excluded, excludedEnd, subset.idAt(begin));

    Walked last;
    typename Locator::Block block;
    std::uint32_t ids[Locator::BlockSize];
    for (std::uint32_t i = begin; i < end;)
    {
      const std::uint32_t blockBegin = i;
      int n = 0;
      if (subset.ids || subset.checkFinite)
      {
        n = this->gather(subset, i, end, next, excludedEnd, block, ids);
      }
      else
      {
        // All points as they lie, up to the next that is taken.
        const std::uint32_t stop = next != excludedEnd ? std::min(*next, end) : end;
        n = static_cast<int>(
          std::min<std::uint32_t>(stop - i, static_cast<std::uint32_t>(Locator::BlockSize)));
        this->source.load(i, n, block.x[0], block.x[1], block.x[2]);
        for (int k = 0; k < n; ++k)
        {
          ids[k] = i + static_cast<std::uint32_t>(k);
        }
        i += static_cast<std::uint32_t>(n);
        if (i < end && next != excludedEnd && *next == i)
        {
          ++next;
          ++i;
        }
      }
      this->locator.classify(block, n);
      if (this->few)
      {
        this->compareWithPlanes(block, n);
      }
      for (int k = 0; k < n; ++k)
      {
        if (block.inside[k])
        {
          ++chunk.tally.statistics.culled;
        }
        else
        {
          this->locate(local, block, k, ids[k], last, chunk);
        }
      }
      this->monitor.advance(i - blockBegin);
    }
  }

  /// Take few planes to help where the locator leaves many points, and they dismiss a good part of
  /// these, as far as a sample shows.
  template <class FewPlanes>
  void tryPlanes(const PointSubset& subset, const FewPlanes& fewPlanes)
  {
    constexpr std::uint32_t Blocks = 4;
    constexpr std::uint32_t Sampled = Blocks * Locator::BlockSize;
    if (subset.count < LeastSampled)
    {
      return;
    }
    std::vector<typename Locator::Block> blocks(Blocks);
    const std::vector<std::uint32_t> sampled = sample(subset.count, Sampled);
    std::ptrdiff_t remaining = 0;
    for (std::uint32_t i = 0; i < Sampled; ++i)
    {
      double x[3];
      this->source.load(subset.idAt(sampled[i]), x);
      typename Locator::Block& block = blocks[i / Locator::BlockSize];
      for (int k = 0; k < 3; ++k)
      {
        block.x[k][i % Locator::BlockSize] = isFinite(x) ? x[k] : this->base.vertices[0].x[k];
      }
    }
    for (typename Locator::Block& block : blocks)
    {
      this->locator.classify(block, Locator::BlockSize);
      remaining += std::count(block.inside, block.inside + Locator::BlockSize, 0);
    }
    if (remaining > Locator::BlockSize)
    {
      this->few.emplace(fewPlanes());
      std::ptrdiff_t dismissed = 0;
      for (typename Locator::Block& block : blocks)
      {
        dismissed +=
          this->few->isReliable() ? this->compareWithPlanes(block, Locator::BlockSize) : 0;
      }
      if (3 * dismissed < remaining)
      {
        this->few.reset();
      }
    }
  }

  /// Dismiss what is below the few planes.
  /// @return how many
  int compareWithPlanes(typename Locator::Block& block, int n) const
  {
    static_assert(Locator::BlockSize <= HullPlanes::BlockSize);
    double x[3][HullPlanes::BlockSize];
    int at[HullPlanes::BlockSize];
    int remaining = 0;
    for (int k = 0; k < n; ++k)
    {
      at[remaining] = k;
      for (int i = 0; i < 3; ++i)
      {
        x[i][remaining] = block.x[i][k];
      }
      remaining += block.inside[k] ? 0 : 1;
    }
    for (int k = remaining; k % HullPlanes::Lanes != 0; ++k)
    {
      x[0][k] = x[1][k] = x[2][k] = 0;
    }
    double height[HullPlanes::BlockSize];
    double plane[HullPlanes::BlockSize];
    this->few->highest(x[0], x[1], x[2], remaining, height, plane);
    int dismissed = 0;
    for (int k = 0; k < remaining; ++k)
    {
      const double p[3] = { x[0][k], x[1][k], x[2][k] };
      const bool inside = height[k] < 0 && !this->few->mayBeVertex(height[k], p);
      block.inside[at[k]] = inside ? 1 : 0;
      dismissed += inside ? 1 : 0;
    }
    return dismissed;
  }

  /// Fill a block with the finite, not yet taken points of the subset from slot @p i on.
  int gather(const PointSubset& subset, std::uint32_t& i, std::uint32_t end,
    const std::uint32_t*& next, const std::uint32_t* excludedEnd, typename Locator::Block& block,
    std::uint32_t* ids) const
  {
    int n = 0;
    for (; i < end && n < Locator::BlockSize; ++i)
    {
      const std::uint32_t id = subset.idAt(i);
      while (next != excludedEnd && *next < id)
      {
        ++next; // not in the subset
      }
      if (next != excludedEnd && *next == id)
      {
        continue;
      }
      double x[3];
      this->source.load(id, x);
      if (subset.checkFinite && !isFinite(x))
      {
        continue;
      }
      for (int k = 0; k < 3; ++k)
      {
        block.x[k][n] = x[k];
      }
      ids[n++] = id;
    }
    return n;
  }

  void locate(const Geometry& local, const typename Locator::Block& block, int k, std::uint32_t id,
    Walked& last, Chunk& chunk)
  {
    Vertex p;
    p.x[0] = block.x[0][k];
    p.x[1] = block.x[1][k];
    p.x[2] = block.x[2][k];
    p.id = id;
    p.flags = 0;
    // Points that follow each other often lie near each other, too.
    const std::uint32_t start =
      block.cell[k] == last.cell ? last.triangle : this->locator.near(p, block.cell[k]);
    const std::uint32_t t = this->locator.locate(local, p, start);
    last = { block.cell[k], t };
    const auto& plane = this->locator.plane(t);
    const double height = plane.height(p.x);
    if (!(height > plane.error()))
    {
      if (height < -plane.error())
      {
        return;
      }
      const std::uint32_t* v = this->base.triangles[t].v;
      const Buffer<Vertex>& vertices = this->base.vertices;
      if (!isAbove(
            local, vertices[v[0]], vertices[v[1]], vertices[v[2]], p, chunk.tally.duplicates))
      {
        return;
      }
    }
    chunk.located[chunk.locatedCount++] = { id, t };
    ++chunk.cursor[t];
  }

  ConflictLists sort()
  {
    const std::uint32_t triangleCount = this->base.triangleCount();
    const std::uint32_t vertexCount = this->base.vertexCount();
    ConflictLists result;
    result.begin.allocate(std::size_t(triangleCount) + 1);
    std::uint64_t at = vertexCount;
    for (std::uint32_t t = 0; t < triangleCount; ++t)
    {
      result.begin[t] = static_cast<std::uint32_t>(at);
      for (Chunk& chunk : this->chunks)
      {
        const std::uint32_t n = chunk.cursor[t];
        chunk.cursor[t] = static_cast<std::uint32_t>(at);
        at += n;
      }
    }
    if (at >= NoIndex)
    {
      throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(at));
    }
    result.begin[triangleCount] = static_cast<std::uint32_t>(at);
    result.vertices.allocate(at);
    std::copy(this->base.vertices.begin(), this->base.vertices.end(), result.vertices.begin());
    eachTask(this->chunks.size(),
      [&](std::size_t i)
      {
        Chunk& chunk = this->chunks[i];
        for (std::size_t k = 0; k < chunk.locatedCount; ++k)
        {
          const Located& located = chunk.located[k];
          result.vertices[chunk.cursor[located.triangle]++] = this->source.vertex(located.id);
        }
        chunk.located.allocate(0);
      });
    return result;
  }

  const Geometry& geometry;
  const PointSource& source;
  const Polyhedron& base;
  int threads;
  Monitor& monitor;
  Locator locator;
  std::optional<HullPlanes> few;
  std::vector<Chunk> chunks;
};

}

#endif
