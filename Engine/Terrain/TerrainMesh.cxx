// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The steps of terrainMesh(): the points along a curve, a first triangulation, the points in its
/// cells, insertions, the triangulation of what was kept.
#include <flipflop/TerrainMesh.h>

#include "Edit/MeshSnapshot.h"
#include "Geometry/LiftedGeometry.h"
#include "Points/ConstraintInput.h"
#include "Run/Run.h"
#include "Support/EngineCall.h"
#include "Support/ProgressOfParts.h"
#include "Terrain/GreedyInsertion.h"
#include "Terrain/GridCells.h"
#include "Terrain/ListedCells.h"
#include "Terrain/TerrainChain.h"
#include "Terrain/TerrainPoints.h"
#include "Terrain/TerrainSurface.h"
#include <flipflop/ConvexHull.h>
#include <flipflop/TriangulationQueries.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace flipflop
{

namespace
{

constexpr std::size_t PointsPerTask = 1 << 14;

void requireValid(const TerrainMeshOptions& terrain)
{
  if (!(terrain.tolerance >= 0)) // or NaN
  {
    throw badArgument("the tolerance must be 0 or more");
  }
  if (terrain.maxVertices < 0)
  {
    throw badArgument("the greatest number of vertices must be 0 (no limit) or more");
  }
}

/// @return the heights as PointSource has them
PointSource withHeights(const PointView& points, const WeightView& heights)
{
  if (!heights.data && heights.count == 0)
  {
    return PointSource(points);
  }
  if (!heights.data || heights.stride < 1)
  {
    throw badArgument("heights must be in memory, with a stride of 1 or more");
  }
  if (heights.count != points.count)
  {
    throw badArgument("there must be as many heights as points", -1, heights.count);
  }
  return PointSource(points, heights);
}

/// Some of the points, to be triangulated alone.
class Subset
{
public:
  /// @param isKept by number
  Subset(const TerrainPoints& points, const std::vector<std::uint8_t>& isKept)
  {
    for (std::uint32_t i = 0; i < points.size(); ++i)
    {
      if (isKept[i])
      {
        this->numbers.push_back(i);
      }
    }
    std::sort(this->numbers.begin(), this->numbers.end(),
      [&points](std::uint32_t i, std::uint32_t j) { return points[i].id < points[j].id; });
    this->positions.reserve(2 * this->numbers.size());
    for (const std::uint32_t i : this->numbers)
    {
      this->positions.insert(this->positions.end(), points[i].x, points[i].x + 2);
    }
  }

  PointView view() const
  {
    return { this->positions.data(), static_cast<std::int64_t>(this->numbers.size()), 2 };
  }

  /// The same constraints between these points.
  /// @param siteOf of each end the number of its point
  std::vector<std::int64_t> constraints(
    const TerrainPoints& points, const std::vector<std::uint32_t>& siteOf) const
  {
    std::vector<std::uint32_t> rank(siteOf.empty() ? 0 : points.size());
    for (std::size_t i = 0; !rank.empty() && i < this->numbers.size(); ++i)
    {
      rank[this->numbers[i]] = static_cast<std::uint32_t>(i);
    }
    std::vector<std::int64_t> ends;
    ends.reserve(siteOf.size());
    std::transform(siteOf.begin(), siteOf.end(), std::back_inserter(ends),
      [&rank](std::uint32_t site) { return rank[site]; });
    return ends;
  }

  std::vector<std::uint32_t> numbers; ///< ascending by their ids

private:
  std::vector<double> positions;
};

class TerrainRun : public Run
{
public:
  TerrainRun(const PointView& points, const WeightView& heights, const ConstraintView& given,
    const TerrainMeshOptions& terrain, const Options& options)
    : Run(points, heights.data || heights.count != 0 ? 2 : 3, withHeights(points, heights), options)
    , view(points)
    , heightSource(this->source)
    , constraints(given)
    , toleranceIsFraction(terrain.isFraction)
    , limits{ terrain.tolerance,
      terrain.maxVertices > 0 ? terrain.maxVertices : std::numeric_limits<std::int64_t>::max() }
    , parts(options)
  {
    requireValid(terrain);
    flipflop::requireValid(given, points.count);
  }

  void compute(TerrainMesh& result)
  {
    result.errors.allocate(this->source.count());
    if (!this->scanPoints(result.statistics))
    {
      this->refuseConstraints();
      this->fillErrors(result);
      result.sides = this->constraints.sides;
      return;
    }
    this->refuseConstraints();
    this->chooseTolerance();
    result.tolerance = this->limits.tolerance;
    this->choosePositions();
    this->monitor.stage(0.05, 0.15, 1, "sorting");
    const TerrainPoints points(this->source, this->heightSource, this->checkFinite, this->monitor);
    this->findEnds(points);
    result.statistics.secondsScan = this->watch.lap();

    const ConstrainedTriangulation start = this->start(points);
    if (start.dimension < 2)
    {
      TerrainChain surface(points.data(), start, this->first);
      this->refineListed(points, surface, start, result);
      return;
    }
    TerrainSurface surface(this->geometry, points, start, this->first);
    if (points.grid().columns == 0)
    {
      this->refineListed(points, surface, start, result);
      return;
    }
    GridCells cells(points, surface);
    this->refine(points, surface, cells, result);
  }

private:
  void refuseConstraints()
  {
    requireFinite(this->constraints, this->heightSource, this->checkFinite);
  }

  void fillErrors(TerrainMesh& result)
  {
    std::fill(result.errors.begin(), result.errors.end(), std::numeric_limits<double>::quiet_NaN());
  }

  /// While the range still has the heights.
  void chooseTolerance()
  {
    if (this->toleranceIsFraction && std::isfinite(this->limits.tolerance))
    {
      const double low = this->range.low[2];
      const double high = this->range.high[2];
      double& tolerance = this->limits.tolerance;
      tolerance =
        std::isfinite(high - low) ? tolerance * (high - low) : tolerance * high - tolerance * low;
    }
  }

  /// From here on, points are positions, scaled.
  void choosePositions()
  {
    this->source = PointSource(this->view, WeightView());
    this->range.low[2] = this->range.high[2] = 0.0;
    this->range.smallest[2] = std::numeric_limits<double>::infinity();
    this->setArithmetic(chooseLiftedArithmetic(this->range));
    const Lattice lattice = this->findLattice(2, TerrainSurface::Geometry::LatticeBits);
    this->geometry = TerrainSurface::Geometry(this->range, this->arithmetic, lattice);
  }

  /// Of each constraint's ends, the points that stand for their positions.
  void findEnds(const TerrainPoints& points)
  {
    this->kept.isKept.assign(points.size(), 0);
    if (this->constraints.count == 0)
    {
      return;
    }
    std::vector<std::uint32_t> siteOf(this->source.count());
    points.eachWithSite([&](std::uint32_t i, std::uint32_t site) { siteOf[points[i].id] = site; });
    this->ends.reserve(static_cast<std::size_t>(2 * this->constraints.count));
    eachEnd(this->constraints,
      [&](std::int64_t, std::int64_t id)
      {
        this->ends.push_back(siteOf[static_cast<std::size_t>(id)]);
        this->kept.add(this->ends.back());
      });
  }

  /// The triangulation that all begins with.
  ConstrainedTriangulation start(const TerrainPoints& points)
  {
    this->keepHull(points);
    try
    {
      return this->triangulate(
        points, this->kept.isKept, this->parts.options(0.2, 0.25), this->first);
    }
    catch (const Error& error)
    {
      if (error.code() != ErrorCode::ConstraintsCross)
      {
        throw;
      }
    }
    this->keepCrossings(points);
    return this->triangulate(
      points, this->kept.isKept, this->parts.options(0.27, 0.28), this->first);
  }

  void keepHull(const TerrainPoints& points)
  {
    if (points.grid().columns > 0)
    {
      const std::uint32_t columns = points.grid().columns;
      for (const std::uint32_t corner :
        { 0u, columns - 1, points.size() - columns, points.size() - 1 })
      {
        this->kept.add(corner);
      }
      return;
    }
    std::vector<double> flat;
    flat.reserve(3 * std::size_t(points.size()));
    for (std::uint32_t i = 0; i < points.size(); ++i)
    {
      flat.insert(flat.end(), { points[i].x[0], points[i].x[1], 0.0 });
    }
    this->monitor.stage(0.15, 0.2, 1, "starting");
    Options options = this->parts.options(0.15, 0.2);
    options.facets = FacetMode::Polygons;
    const Hull hull =
      convexHull(PointView(flat.data(), static_cast<std::int64_t>(points.size())), options);
    for (const std::int64_t i : hull.pointIds)
    {
      this->kept.add(static_cast<std::uint32_t>(i)); // the first of its position
    }
  }

  /// Constraints cross. In the triangulation of all points they may do so at vertices, which are to
  /// be kept. If not, it has the error.
  void keepCrossings(const TerrainPoints& points)
  {
    std::vector<std::uint32_t> numberOf;
    const ConstrainedTriangulation all = this->triangulate(points,
      std::vector<std::uint8_t>(points.size(), 1), this->parts.options(0.25, 0.27), numberOf);
    std::vector<std::uint32_t> degree(all.pointIds.size());
    for (const std::int64_t end : all.fixedEdges)
    {
      ++degree[static_cast<std::size_t>(end)];
    }
    for (std::size_t i = 0; i < degree.size(); ++i)
    {
      if (degree[i] > 2)
      {
        this->kept.add(numberOf[static_cast<std::size_t>(all.pointIds[i])]);
      }
    }
  }

  /// The constrained triangulation of some of the points.
  /// @param numberOf receives the number of each of them; the result has their indices as ids
  ConstrainedTriangulation triangulate(const TerrainPoints& points,
    const std::vector<std::uint8_t>& isIn, const Options& options,
    std::vector<std::uint32_t>& numberOf)
  {
    Subset subset(points, isIn);
    const std::vector<std::int64_t> mapped = subset.constraints(points, this->ends);
    ConstrainedTriangulation result = constrainedTriangulation(subset.view(),
      ConstraintView(mapped.data(), this->constraints.count, this->constraints.sides), options);
    numberOf = std::move(subset.numbers);
    return result;
  }

  /// A cell of each point.
  std::vector<std::int64_t> locate(
    const TerrainPoints& points, const ConstrainedTriangulation& start)
  {
    std::vector<double> positions;
    for (const std::uint32_t i : this->first)
    {
      positions.insert(positions.end(), points[i].x, points[i].x + 2);
    }
    std::vector<std::int64_t> cellOf(points.size());
    this->monitor.stage(0.28, 0.4, 1, "locating");
    const Options options = this->parts.options(0.28, 0.4);
    const TriangulationQueries queries(
      PointView(positions.data(), static_cast<std::int64_t>(this->first.size()), 2), start, nullptr,
      options);
    queries.locate(PointView(points.data()->x, points.size(), sizeof(Vertex) / sizeof(double)),
      cellOf.data(), options);
    return cellOf;
  }

  template <class Surface>
  void refineListed(const TerrainPoints& points, Surface& surface,
    const ConstrainedTriangulation& start, TerrainMesh& result)
  {
    const std::vector<std::int64_t> cellOf = this->locate(points, start);
    ListedCells<Surface> cells(points, surface, this->kept.isKept, cellOf.data());
    result.statistics.secondsLocate = this->watch.lap();
    this->refine(points, surface, cells, result);
  }

  template <class Surface, class Cells>
  void refine(const TerrainPoints& points, Surface& surface, Cells& cells, TerrainMesh& result)
  {
    GreedyInsertion<Surface, Cells> insertion(
      points, surface, cells, this->kept, this->limits, this->monitor);
    this->monitor.stage(0.4, 0.9, static_cast<std::int64_t>(insertion.ProgressUnits), "inserting");
    insertion.start();
    insertion.run();
    const double secondsGrow = this->watch.lap();

    this->monitor.stage(0.9, 0.95, 1, "finishing");
    this->write(points, surface, result);
    result.statistics.insertions = insertion.insertionCount();
    result.statistics.moves = insertion.moveCount();
    result.statistics.edgeChecks = surface.checkCount();
    result.statistics.exactCalls = surface.exactCalls();
    result.statistics.secondsGrow = secondsGrow;
    this->monitor.stage(0.95, 1.0, 1, "finishing");
    this->measure(points, insertion, result);
    this->listHidden(result);
    result.statistics.secondsFinish = this->watch.lap();
  }

  void write(const TerrainPoints& points, const TerrainSurface& surface, TerrainMesh& result)
  {
    writeCells(surface.triangulation(), this->source.count(), Options(), this->monitor, result);
    result.sides = this->constraints.sides;
    std::vector<std::uint32_t> slotOf(this->ends.empty() ? 0 : points.size());
    for (std::uint32_t slot = 1; !slotOf.empty() && slot < surface.triangulation().slotCount();
         ++slot)
    {
      slotOf[surface.numberOf(slot)] = slot;
    }
    std::vector<MeshConstraint> all;
    for (std::size_t i = 0; i < this->ends.size(); i += 2)
    {
      const auto number = static_cast<std::uint32_t>(i / 2);
      all.push_back({ slotOf[this->ends[i]], slotOf[this->ends[i + 1]], number,
        number >= this->constraints.count - this->constraints.sides });
    }
    writeConstraints(surface.triangulation(), all, result);
  }

  void write(const TerrainPoints& points, const TerrainChain& surface, TerrainMesh& result)
  {
    std::vector<std::uint32_t> vertexOf;
    ConstrainedTriangulation final =
      this->triangulate(points, this->kept.isKept, this->parts.options(0.9, 0.95), vertexOf);
    ensure(final.pointIds.size() == vertexOf.size() &&
      (final.dimension == 0 || static_cast<std::size_t>(final.cellCount()) == surface.cellCount()));
    final.statistics = result.statistics;
    static_cast<ConstrainedTriangulation&>(result) = std::move(final);
    for (std::int64_t& id : result.pointIds)
    {
      id = points[vertexOf[static_cast<std::size_t>(id)]].id;
    }
  }

  /// The errors, and what follows from them.
  template <class Insertion>
  void measure(const TerrainPoints& points, const Insertion& insertion, TerrainMesh& result)
  {
    this->fillErrors(result);
    std::atomic<std::int64_t> beyond{ 0 };
    insertion.eachRemaining(
      [&](const SurfacePoints& some, const SurfacePlane& plane)
      {
        double heights[SurfacePoints::Capacity];
        plane.heights(some, heights);
        for (int i = 0; i < some.size; ++i)
        {
          const Vertex& point = points[some.number[i]];
          result.errors[point.id] = heights[i];
          if (plane.isBeyond(point.x, heights[i], this->limits.tolerance))
          {
            beyond.fetch_add(1, std::memory_order_relaxed);
          }
        }
      });
    points.eachWithSite(
      [&](std::uint32_t i, std::uint32_t site)
      {
        if (this->kept.isKept[site])
        {
          // A line of one level.
          Vertex other = points[site];
          other.x[0] = other.x[0] == 0.0 ? 1.0 : 0.0;
          const SurfacePlane level({ &points[site], &other, nullptr });
          const double height = points[i].x[2] - points[site].x[2];
          result.errors[points[i].id] = height;
          result.unreachable +=
            i != site && level.isBeyond(points[i].x, height, this->limits.tolerance) ? 1 : 0;
        }
      });
    result.beyond = beyond.load() + result.unreachable;
    for (const double error : result.errors)
    {
      result.greatestError =
        std::fabs(error) > result.greatestError ? std::fabs(error) : result.greatestError;
    }
  }

  /// All finite points that are no vertices.
  void listHidden(TerrainMesh& result)
  {
    parallelCompact(
      this->source.count(), PointsPerTask,
      [&](std::size_t begin, std::size_t end, const auto& emit)
      {
        const std::int64_t* next =
          std::lower_bound(result.pointIds.begin(), result.pointIds.end(), std::int64_t(begin));
        for (std::size_t id = begin; id < end; ++id)
        {
          const bool isVertex = next != result.pointIds.end() && *next == std::int64_t(id);
          next += isVertex ? 1 : 0;
          if (!isVertex && !std::isnan(result.errors[id]))
          {
            emit(static_cast<std::int64_t>(id));
          }
        }
      },
      [&](std::size_t hidden) { result.hiddenIds.allocate(hidden); },
      [&](std::size_t at, std::int64_t id) { result.hiddenIds[at] = id; });
  }

  const PointView view;
  const PointSource heightSource;
  const ConstraintView constraints;
  const bool toleranceIsFraction;
  InsertionLimits limits;
  ProgressOfParts parts; ///< of calls of other parts of the engine
  TerrainSurface::Geometry geometry;
  KeptPoints kept;
  std::vector<std::uint32_t> ends;  ///< of the constraints: points, by number
  std::vector<std::uint32_t> first; ///< of each point of the first triangulation its number
};

}

TerrainMesh terrainMesh(const PointView& points, const WeightView& heights,
  const ConstraintView& constraints, const TerrainMeshOptions& terrain, const Options& options)
{
  return engineCall(
    [&]
    {
      TerrainRun run(points, heights, constraints, terrain, options);
      return run.execute<TerrainMesh>([&run](TerrainMesh& result) { run.compute(result); });
    });
}

}
