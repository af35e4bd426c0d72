// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The worst point first, until all are within the tolerance.
///
/// Each cell has a conflict list: the points in it that are no vertices. Its worst point, by
/// rounded distances, is in a heap. What comes out of the heap is inserted if it is beyond the
/// tolerance, exactly. If not, all points of its cell are examined so, since a rounded distance may
/// be wrong: the worst that is beyond goes into the heap again, or the cell is settled. So in the
/// end each point was found within the tolerance, exactly.
#ifndef flipflop_GreedyInsertion_h
#define flipflop_GreedyInsertion_h

#include "Support/Monitor.h"
#include "Support/Parallel.h"
#include "Terrain/SurfacePlane.h"
#include "Terrain/TerrainPoints.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

/// Which points are vertices.
struct KeptPoints
{
  std::vector<std::uint8_t> isKept; ///< by number
  std::int64_t count = 0;

  void add(std::uint32_t i)
  {
    this->count += this->isKept[i] ? 0 : 1;
    this->isKept[i] = 1;
  }
};

/// When to stop.
struct InsertionLimits
{
  double tolerance;
  std::int64_t mostVertices;
};

/// @tparam Surface TerrainSurface, or TerrainChain
template <class Surface>
class GreedyInsertion
{
public:
  GreedyInsertion(const TerrainPoints& terrainPoints, Surface& toRefine, KeptPoints& vertices,
    const InsertionLimits& when, Monitor& toReport)
    : points(terrainPoints)
    , surface(toRefine)
    , kept(vertices)
    , limits(when)
    , monitor(toReport)
    , poll(toReport)
    , lists(toRefine.cellCount())
    , worst(toRefine.cellCount())
  {
  }

  /// Begin.
  /// @param cellOf of each point a cell that holds it; of points of one position the same
  void associate(const std::int64_t* cellOf)
  {
    this->points.eachWithSite(
      [&](std::uint32_t i, std::uint32_t site)
      {
        if (!this->kept.isKept[site])
        {
          ensure(cellOf[site] >= 0);
          this->lists[static_cast<std::size_t>(cellOf[site])].push_back(i);
        }
      });
    eachTask(this->lists.size(),
      [this](std::size_t cell)
      {
        this->monitor.poll();
        if (this->lists[cell].empty())
        {
          return;
        }
        this->findWorst(
          cell, RoundedPlane(this->surface.corners(static_cast<std::uint32_t>(cell))));
      });
    for (std::size_t cell = 0; cell < this->lists.size(); ++cell)
    {
      this->enqueue(cell);
    }
  }

  /// Insert points up to a limit.
  void run()
  {
    while (!this->heap.empty() && this->kept.count < this->limits.mostVertices)
    {
      this->poll.step();
      const Candidate next = this->heap.front();
      std::pop_heap(this->heap.begin(), this->heap.end(), Order{ this->points });
      this->heap.pop_back();
      const Worst& current = this->worst[next.cell];
      if (current.point != next.point || current.distance != next.distance)
      {
        continue; // the cell has changed
      }
      const SurfacePlane plane(this->surface.corners(next.cell));
      if (plane.isBeyond(this->points[next.point], this->limits.tolerance))
      {
        this->insert(this->points.siteOf(next.point), next.cell);
        this->reportProgress();
      }
      else
      {
        this->settle(next.cell, plane);
      }
    }
  }

  /// use(point, SurfacePlane) for each point that is at no vertex, in parallel.
  template <class Use>
  void eachRemaining(const Use& use) const
  {
    constexpr std::size_t CellsPerTask = 1 << 8;
    eachChunk(this->lists.size(), CellsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        this->monitor.poll();
        for (std::size_t cell = begin; cell < end; ++cell)
        {
          if (!this->lists[cell].empty())
          {
            const SurfacePlane plane(this->surface.corners(static_cast<std::uint32_t>(cell)));
            for (const std::uint32_t p : this->lists[cell])
            {
              use(p, plane);
            }
          }
        }
      });
  }

  std::int64_t insertionCount() const { return this->insertions; }
  std::int64_t moveCount() const { return this->moves; }

private:
  /// The farthest point of a cell.
  struct Worst
  {
    double distance = -1.0;
    std::uint32_t point = NoIndex; ///< NoIndex: none is left that may be beyond the tolerance
  };

  struct Candidate
  {
    double distance;
    std::uint32_t point;
    std::uint32_t cell;
  };

  /// Of the heap: the farthest first, of several the lowest id.
  struct Order
  {
    const TerrainPoints& points;

    bool operator()(const Candidate& a, const Candidate& b) const
    {
      return a.distance != b.distance ? a.distance < b.distance
                                      : this->points[a.point].id > this->points[b.point].id;
    }
  };

  void consider(std::size_t cell, std::uint32_t p, double distance)
  {
    Worst& so = this->worst[cell];
    if (distance > so.distance ||
      (distance == so.distance && this->points[p].id < this->points[so.point].id))
    {
      so = { distance, p };
    }
  }

  void enqueue(std::size_t cell)
  {
    const Worst& found = this->worst[cell];
    if (found.point != NoIndex)
    {
      this->heap.push_back({ found.distance, found.point, static_cast<std::uint32_t>(cell) });
      std::push_heap(this->heap.begin(), this->heap.end(), Order{ this->points });
    }
  }

  void insert(std::uint32_t v, std::uint32_t cell)
  {
    this->kept.add(v);
    ++this->insertions;
    this->surface.insert(v, cell);
    const std::vector<std::uint32_t>& old = this->surface.replaced();
    const std::vector<std::uint32_t>& parts = this->surface.parts();
    this->taken.resize(std::max(this->taken.size(), old.size()));
    for (std::size_t i = 0; i < old.size(); ++i)
    {
      std::swap(this->taken[i], this->lists[old[i]]);
    }
    this->lists.resize(this->surface.cellCount());
    this->worst.resize(this->surface.cellCount());
    for (const std::uint32_t part : parts)
    {
      this->worst[part] = Worst();
    }
    const std::uint32_t groupEnd = this->points.groupEnd(v);
    for (std::size_t i = 0; i < old.size(); ++i)
    {
      this->distribute(this->taken[i], v, groupEnd);
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      if (!this->lists[parts[i]].empty())
      {
        this->findWorst(parts[i], RoundedPlane(this->surface.corners(parts[i])));
        this->enqueue(parts[i]);
      }
    }
  }

  /// Put points into the lists of their new cells, but for those at the new vertex.
  void distribute(std::vector<std::uint32_t>& moved, std::uint32_t v, std::uint32_t groupEnd)
  {
    moved.erase(std::remove_if(moved.begin(), moved.end(),
                  [this, v, groupEnd](std::uint32_t p)
                  {
                    this->points.prefetch(p);
                    return p >= v && p < groupEnd;
                  }),
      moved.end());
    this->moves += static_cast<std::int64_t>(moved.size());
    this->surface.findParts(moved, this->partOf);
    const std::vector<std::uint32_t>& parts = this->surface.parts();
    for (std::size_t i = 0; i < moved.size(); ++i)
    {
      this->poll.step();
      this->lists[parts[this->partOf[i]]].push_back(moved[i]);
    }
    moved.clear();
  }

  /// The farthest point of a cell, of several the lowest id.
  void findWorst(std::size_t cell, const RoundedPlane& plane)
  {
    Worst found;
    std::uint32_t id = NoIndex;
    for (const std::uint32_t i : this->lists[cell])
    {
      const Vertex& p = this->points[i];
      const double distance = plane.distance(p);
      if (distance >= found.distance && (distance > found.distance || p.id < id))
      {
        found = { distance, i };
        id = p.id;
      }
    }
    this->worst[cell] = found;
  }

  /// Of a cell whose worst point is within the tolerance.
  void settle(std::uint32_t cell, const SurfacePlane& plane)
  {
    this->worst[cell] = Worst();
    for (const std::uint32_t p : this->lists[cell])
    {
      this->poll.step();
      const Vertex& point = this->points[p];
      if (plane.isBeyond(point, this->limits.tolerance))
      {
        this->consider(cell, p, std::fabs(plane.height(point)));
      }
    }
    this->enqueue(cell);
  }

  /// The share of the work: points move about as often as vertices double.
  void reportProgress()
  {
    const double most =
      static_cast<double>(std::min<std::int64_t>(this->limits.mostVertices, this->points.size()));
    const auto done = static_cast<std::int64_t>(ProgressUnits *
      std::log(static_cast<double>(this->kept.count)) / std::log(std::max(most, 2.0)));
    if (done > this->reported)
    {
      this->monitor.advance(done - this->reported);
      this->reported = done;
    }
  }

public:
  static constexpr double ProgressUnits = 1000; ///< of the monitor's stage

private:
  const TerrainPoints& points;
  Surface& surface;
  KeptPoints& kept;
  const InsertionLimits limits;
  Monitor& monitor;
  StepPoll poll;
  std::vector<std::vector<std::uint32_t>> lists; ///< by cell
  std::vector<Worst> worst;                      ///< by cell
  std::vector<Candidate> heap;                   ///< some of cells that have changed since
  std::vector<std::vector<std::uint32_t>> taken;
  std::vector<std::uint32_t> partOf;
  std::int64_t insertions = 0;
  std::int64_t moves = 0;
  std::int64_t reported = 0;
};

}

#endif
