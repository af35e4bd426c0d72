// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The worst point first, until all are within the tolerance.
///
/// Of the points in each cell that are no vertices, the worst, by rounded distances, is in a heap.
/// What comes out of the heap is inserted if it is beyond the tolerance, exactly. If not, all
/// points of its cell are examined so, since a rounded distance may be wrong: the worst that is
/// beyond goes into the heap again, or the cell is settled. So in the end each point was found
/// within the tolerance, exactly.
#ifndef flipflop_GreedyInsertion_h
#define flipflop_GreedyInsertion_h

#include "Support/Monitor.h"
#include "Support/Parallel.h"
#include "Terrain/CandidateQueue.h"
#include "Terrain/SurfacePlane.h"
#include "Terrain/TerrainPoints.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
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
/// @tparam Cells   which points are in its cells: ListedCells, or GridCells
template <class Surface, class Cells>
class GreedyInsertion
{
public:
  GreedyInsertion(const TerrainPoints& terrainPoints, Surface& toRefine, Cells& cellsOfSurface,
    KeptPoints& vertices, const InsertionLimits& when, Monitor& toReport)
    : points(terrainPoints)
    , surface(toRefine)
    , cells(cellsOfSurface)
    , kept(vertices)
    , limits(when)
    , monitor(toReport)
    , poll(toReport)
    , worst(toRefine.cellCount())
    , queue(Order{ terrainPoints }, terrainPoints.size())
  {
  }

  /// Begin.
  void start()
  {
    eachTask(this->worst.size(),
      [this](std::size_t cell)
      {
        this->monitor.poll();
        if (this->surface.isCell(static_cast<std::uint32_t>(cell)))
        {
          this->findWorst(static_cast<std::uint32_t>(cell));
        }
      });
    for (std::size_t cell = 0; cell < this->worst.size(); ++cell)
    {
      this->enqueue(static_cast<std::uint32_t>(cell));
    }
  }

  /// Insert points up to a limit.
  void run()
  {
    Candidate next;
    const auto isCurrent = [this](const Candidate& candidate)
    {
      const FarthestPoint& now = this->worst[candidate.cell];
      return now.point == candidate.point && now.distance == candidate.distance;
    };
    const auto prepare = [this](const std::vector<Candidate>& some) { this->prepare(some); };
    while (
      this->kept.count < this->limits.mostVertices && this->queue.pop(isCurrent, prepare, next))
    {
      this->poll.step();
      if (!isCurrent(next))
      {
        continue; // the cell has changed
      }
      const SurfacePlane plane(this->surface.corners(next.cell));
      if (plane.isBeyond(this->points[next.point].x, this->limits.tolerance))
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

  /// use(SurfacePoints, SurfacePlane) of all points that are at no vertex, in parallel.
  template <class Use>
  void eachRemaining(const Use& use) const
  {
    constexpr std::size_t CellsPerTask = 1 << 8;
    eachChunk(this->worst.size(), CellsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        this->monitor.poll();
        for (auto cell = static_cast<std::uint32_t>(begin); cell < end; ++cell)
        {
          if (this->surface.isCell(cell))
          {
            std::optional<SurfacePlane> plane;
            eachSome([&](const auto& add) { this->cells.eachOnceIn(cell, add); },
              [&](const SurfacePoints& some)
              {
                if (!plane)
                {
                  plane.emplace(this->surface.corners(cell));
                }
                use(some, *plane);
              });
          }
        }
      });
  }

  std::int64_t insertionCount() const { return this->insertions; }
  std::int64_t moveCount() const { return this->cells.moveCount(); }

private:
  /// The farthest first, of several the lowest id.
  struct Order
  {
    const TerrainPoints& points;

    bool operator()(const Candidate& a, const Candidate& b) const
    {
      return a.distance != b.distance ? a.distance < b.distance
                                      : this->points[a.point].id > this->points[b.point].id;
    }
  };

  void enqueue(std::uint32_t cell)
  {
    const FarthestPoint& found = this->worst[cell];
    if (found.point != NoIndex)
    {
      this->queue.push({ found.distance, found.point, cell });
    }
  }

  /// What insertions will read comes from all places: request it for many of them at once.
  void prepare(const std::vector<Candidate>& some)
  {
    this->near.clear();
    for (const Candidate& candidate : some)
    {
      this->points.prefetch(candidate.point);
      prefetch(&this->kept.isKept[candidate.point]);
      this->cells.bringNear(candidate.point);
      this->near.push_back(candidate.cell);
    }
    this->surface.bringNear(
      this->near, [this](std::uint32_t cell) { prefetch(&this->worst[cell]); });
  }

  void insert(std::uint32_t v, std::uint32_t cell)
  {
    this->kept.add(v);
    ++this->insertions;
    this->surface.insert(v, cell);
    this->cells.update(v);
    this->worst.resize(this->surface.cellCount());
    for (const std::uint32_t part : this->surface.parts())
    {
      this->worst[part] = FarthestPoint();
      if (this->surface.isCell(part))
      {
        this->findWorst(part);
        this->enqueue(part);
      }
    }
  }

  /// The farthest point of a cell.
  void findWorst(std::uint32_t cell)
  {
    this->worst[cell] = this->cells.farthest(cell, RoundedPlane(this->surface.corners(cell)));
  }

  /// Of a cell whose worst point is within the tolerance.
  void settle(std::uint32_t cell, const SurfacePlane& plane)
  {
    FarthestPoint found;
    eachSome([&](const auto& add) { this->cells.eachIn(cell, add); },
      [&](const SurfacePoints& some)
      {
        this->poll.step();
        if (!plane.areWithin(some, this->limits.tolerance))
        {
          this->findBeyond(some, plane, found);
        }
      });
    this->worst[cell] = found;
    this->enqueue(cell);
  }

  void findBeyond(const SurfacePoints& some, const SurfacePlane& plane, FarthestPoint& found) const
  {
    for (int i = 0; i < some.size; ++i)
    {
      const double* const x = this->points[some.number[i]].x;
      if (plane.isBeyond(x, this->limits.tolerance))
      {
        found.add(this->points, some.number[i], std::fabs(plane.height(x)));
      }
    }
  }

  /// use(SurfacePoints) of all points that each() gives.
  template <class Each, class Use>
  static void eachSome(const Each& each, const Use& use)
  {
    SurfacePoints some;
    each(
      [&](std::uint32_t p, double x, double y, double height)
      {
        if (some.size == SurfacePoints::Capacity)
        {
          use(some);
          some.size = 0;
        }
        some.add(p, x, y, height);
      });
    if (some.size > 0)
    {
      use(some);
    }
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
  Cells& cells;
  KeptPoints& kept;
  const InsertionLimits limits;
  Monitor& monitor;
  StepPoll poll;
  std::vector<FarthestPoint> worst; ///< by cell; of a settled one there is none
  CandidateQueue<Order> queue;      ///< some of cells that have changed since
  std::vector<std::uint32_t> near;  ///< for prepare()
  std::int64_t insertions = 0;
  std::int64_t reported = 0;
};

}

#endif
