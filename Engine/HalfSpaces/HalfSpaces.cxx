// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Half-spaces of the plane are intersected as those of a prism: each is one of space, and two more
/// bound it above and below. Its vertices above are the polygon's.
#include <flipflop/HalfSpaces.h>

#include "Finish/Canonical.h"
#include "Finish/Redundant.h"
#include "FlipFlop/CurveInsertion.h"
#include "Geometry/GeometryConcept.h"
#include "Geometry/HullStart.h"
#include "HalfSpaces/HalfSpaceGeometry.h"
#include "HalfSpaces/HalfSpacePositions.h"
#include "HalfSpaces/InteriorPoint.h"
#include "HalfSpaces/SurelyRedundant.h"
#include "Run/GeometryRun.h"
#include "Support/EngineCall.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace flipflop
{

namespace
{

static_assert(hasSigns<HalfSpaceGeometry>());

/// Positions of dual points are cut here: they are for orders.
constexpr double MostPosition = 0x1p1000;

/// The largest number of a normal.
double sizeOf(const double* row)
{
  return std::max({ std::fabs(row[0]), std::fabs(row[1]), std::fabs(row[2]) });
}

/// The half-spaces as rows of four numbers, normal . x <= bound. A row is scaled by a power of two
/// where that is exact.
/// @throw Error NonFinite
HalfSpaceRows rowsOf(const HalfSpaceView& view)
{
  HalfSpaceRows rows(static_cast<std::size_t>(4 * view.count));
  std::int64_t firstNonFinite = -1;
  std::int64_t nonFinite = 0;
  for (std::int64_t id = 0; id < view.count; ++id)
  {
    const double* const given = view.rows + (view.dimension + 1) * id;
    double* const row = rows.data() + 4 * id;
    std::copy_n(given, view.dimension, row);
    row[3] = 0.0 - given[view.dimension];
    if (!std::all_of(row, row + 4, [](double x) { return std::isfinite(x); }))
    {
      firstNonFinite = nonFinite++ ? firstNonFinite : id;
      continue;
    }
    const double most = sizeOf(row);
    const int shift = most > 0 ? -std::ilogb(most) : 0;
    const auto isExact = [shift](double x)
    { return std::ldexp(std::ldexp(x, shift), -shift) == x; };
    if (std::all_of(row, row + 4, isExact))
    {
      std::transform(row, row + 4, row, [shift](double x) { return std::ldexp(x, shift); });
    }
  }
  if (nonFinite)
  {
    throw Error(ErrorCode::NonFinite, firstNonFinite, nonFinite);
  }
  return rows;
}

class HalfSpaceRun : public GeometryRun<HalfSpaceGeometry>
{
public:
  HalfSpaceRun(const HalfSpaceView& given, HalfSpaceRows&& read, std::vector<double>& memory,
    const Options& options)
    : GeometryRun(PointView(memory.data(), static_cast<std::int64_t>(memory.size() / 3)), 3,
        PointSource(PointView(memory.data(), static_cast<std::int64_t>(memory.size() / 3))),
        options)
    , view(given)
    , rows(std::move(read))
    , positions(memory)
  {
  }

  void intersect(const double* interior, HalfSpaceIntersection& result)
  {
    result.dimension = this->view.dimension;
    result.statistics.points = this->view.count;
    result.statistics.threads = this->threads;
    this->monitor.stage(0.0, 0.1, this->view.count, "scanning");
    if (!this->findInside(interior, result))
    {
      return;
    }
    this->makeTable(result);
    const std::vector<std::uint32_t> excluded = this->excludedIds();
    this->monitor.poll();
    Tally tally;
    Polyhedron polyhedron;
    if (!this->insertAll(excluded, polyhedron, tally, result.statistics))
    {
      result.kind = Intersection::Unbounded;
      return;
    }
    this->monitor.stage(0.9, 1.0, 1, "finishing");
    const bool anyFlat =
      RedundantVertices<HalfSpaceGeometry>(this->geometry, polyhedron, tally, this->monitor)
        .remove();
    CanonicalForm<Polyhedron> form(polyhedron, anyFlat, tally.duplicates, this->source.count(),
      FacetMode::Polygons, this->monitor, result.pointIds);
    form.writeCells(this->monitor, result);
    if (this->view.dimension == 2)
    {
      this->keepPolygon(result);
    }
    this->writePositions(result);
    this->addStatistics(tally, result.statistics);
  }

private:
  /// The ids behind the half-spaces: two of a prism, and four of a tetrahedron around all.
  std::uint32_t above() const { return static_cast<std::uint32_t>(this->view.count); }
  std::uint32_t farId(int i) const { return static_cast<std::uint32_t>(this->ownCount() + i); }
  std::int64_t ownCount() const { return this->view.count + (this->view.dimension == 2 ? 2 : 0); }

  /// Whether there is an inside; if so, the interior is set.
  bool findInside(const double* given, HalfSpaceIntersection& result)
  {
    result.kind = Intersection::Bounded;
    if (given)
    {
      std::copy_n(given, this->view.dimension, result.interior);
      const std::int64_t first = firstNotHolding(this->rows, result.interior, this->monitor);
      if (first >= 0)
      {
        throw badArgument("the interior point must be strictly inside all half-spaces", first);
      }
    }
    else
    {
      result.kind = findInterior(this->rows, this->view.dimension, result.interior, this->monitor);
    }
    if (result.kind != Intersection::Bounded)
    {
      std::fill_n(result.interior, 3, std::numeric_limits<double>::quiet_NaN());
      return false;
    }
    if (this->view.dimension == 2)
    {
      this->rows.insert(this->rows.end(), { 0, 0, 1, 1, 0, 0, -1, 1 });
    }
    return true;
  }

  /// The rows with their depths, and the dual points, no two alike.
  void makeTable(HalfSpaceIntersection& result)
  {
    const double* const interior = result.interior;
    const auto dimension = static_cast<std::size_t>(this->view.dimension);
    result.dualPoints = Buffer<double>(static_cast<std::size_t>(this->view.count) * dimension);
    this->table.resize(static_cast<std::size_t>(this->ownCount()) + 4);
    constexpr std::size_t RowsPerTask = 1 << 12;
    eachChunk(this->table.size() - 4, RowsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        for (std::size_t id = begin; id < end; ++id)
        {
          this->setRow(id, this->rows.data() + 4 * id, interior);
          double* const position = this->positions.data() + 3 * id;
          if (!hasNoNormal(this->rows.data() + 4 * id))
          {
            dualPointOf(this->rows.data() + 4 * id, interior, position);
          }
          if (id < static_cast<std::size_t>(this->view.count))
          {
            std::copy_n(position, dimension, result.dualPoints.data() + id * dimension);
          }
          // Orders take finite positions.
          std::transform(position, position + 3, position,
            [](double x) { return std::min(std::max(x, -MostPosition), MostPosition); });
        }
        this->monitor.poll();
      });
    this->geometry = HalfSpaceGeometry(this->table.data());
    std::copy_n(interior, 3, this->center);
  }

  void setRow(std::size_t id, const double* row, const double* c)
  {
    HalfSpaceRow& entry = this->table[id];
    std::copy_n(row, 4, entry.number);
    const double size = sizeOf(row);
    entry.size = size >= FilterFloor && size <= FilterCeiling ? size : HUGE_VAL;
    entry.farDepth = depthAt(BoundedArithmetic<>(), row, c);
    entry.depth = { entry.farDepth.value.high,
      entry.farDepth.error + NearUnit * std::fabs(entry.farDepth.value.high) };
  }

  /// Those that are surely redundant, those without a border, and all but the first of several that
  /// are the same. Others that have one dual point, rounded, are moved a little apart: positions
  /// distinguish vertices.
  std::vector<std::uint32_t> excludedIds()
  {
    std::vector<std::uint32_t> excluded = this->view.dimension == 3
      ? surelyRedundant(this->positions, this->threads, this->monitor)
      : std::vector<std::uint32_t>();
    std::vector<ByFirst> order;
    order.reserve(static_cast<std::size_t>(this->ownCount()) - excluded.size());
    std::vector<std::uint32_t> trivial;
    PointSubset::eachRemaining(
      0, static_cast<std::uint32_t>(this->ownCount()), [](std::uint32_t id) { return id; },
      excluded.data(), excluded.data() + excluded.size(), nullptr,
      [&](std::uint32_t id)
      {
        if (hasNoNormal(this->rows.data() + 4 * std::size_t(id)))
        {
          trivial.push_back(id);
        }
        else
        {
          order.emplace_back(this->positions[3 * std::size_t(id)], id);
        }
      });
    excluded.insert(excluded.end(), trivial.begin(), trivial.end());
    this->sortByDuals(order);
    this->moveApart(order, excluded);
    std::sort(excluded.begin(), excluded.end());
    return excluded;
  }

  using ByFirst = std::pair<double, std::uint32_t>; ///< most differ in the first coordinate

  /// By position, then exactly, then by id.
  void sortByDuals(std::vector<ByFirst>& order)
  {
    StepPoll poll(this->monitor);
    std::sort(order.begin(), order.end(),
      [&](const ByFirst& a, const ByFirst& b)
      {
        const double* const x = this->positions.data() + 3 * std::size_t(a.second);
        const double* const y = this->positions.data() + 3 * std::size_t(b.second);
        if (a.first != b.first)
        {
          return a.first < b.first;
        }
        if (x[1] != y[1] || x[2] != y[2])
        {
          return x[1] != y[1] ? x[1] < y[1] : x[2] < y[2];
        }
        poll.step();
        const int sign = this->compareExactly(a.second, b.second);
        return sign != 0 ? sign < 0 : a.second < b.second;
      });
  }

  int compareExactly(std::uint32_t a, std::uint32_t b) const
  {
    return compareDuals(
      this->rows.data() + 4 * std::size_t(a), this->rows.data() + 4 * std::size_t(b), this->center);
  }

  /// Move those with one position a little apart, but exclude all but the first of the same.
  void moveApart(const std::vector<ByFirst>& order, std::vector<std::uint32_t>& excluded)
  {
    const double* last = nullptr; // the position before
    double given[3] = { 0, 0, 0 };
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      const std::uint32_t id = order[i].second;
      double* const x = this->positions.data() + 3 * std::size_t(id);
      const bool isHere = i > 0 && std::equal(x, x + 3, given);
      if (isHere && this->compareExactly(order[i - 1].second, id) == 0)
      {
        excluded.push_back(id);
        continue;
      }
      std::copy_n(x, 3, given);
      if (last && last[0] == x[0] && last[1] == x[1] && last[2] >= x[2])
      {
        x[2] = std::nextafter(last[2], HUGE_VAL);
      }
      last = x;
    }
  }

  /// The perturbed hull of the dual points. It grows from a small tetrahedron around the origin: of
  /// half-spaces so far away that they hold a bounded intersection.
  /// @return false: it is unbounded
  /// @throw Error BadArgument
  bool insertAll(const std::vector<std::uint32_t>& excluded, Polyhedron& polyhedron, Tally& tally,
    Statistics& statistics)
  {
    PointSubset subset;
    subset.count = static_cast<std::uint32_t>(this->ownCount());
    subset.exclude(excluded);
    const OctahedralMap map = this->directions(subset);
    // Signs of less extreme numbers are quicker, and nearly always enough.
    for (const int exponent : { 64, 512, 1023 })
    {
      const std::array<FarRow, 4> far = this->farRows(exponent);
      if (std::all_of(far.begin(), far.end(),
            [this](const FarRow& row) { return depthSign(row.data(), this->center) > 0; }))
      {
        tally = Tally();
        polyhedron = insertAlongCurve(
          this->task({}), this->tetrahedronOf(far), subset, map, 0.1, 0.9, tally, statistics);
        const Vertex* const v = polyhedron.vertices.data();
        if (std::none_of(v, v + 4, [](const Vertex& one) { return one.flags & VertexAlive; }))
        {
          return true;
        }
      }
      if (exponent == 64 && !areNormalsAllAround(this->rows, this->threads))
      {
        return false;
      }
    }
    throw badArgument(
      "the intersection's vertices and the interior point must be in the range of doubles");
  }

  using FarRow = std::array<double, 4>;

  std::array<FarRow, 4> farRows(int exponent) const
  {
    const double bound = std::min(std::ldexp(this->greatestSize(), exponent), 0x1p1023);
    return { FarRow{ 1, 1, 1, bound }, FarRow{ -1, -1, 1, bound }, FarRow{ -1, 1, -1, bound },
      FarRow{ 1, -1, -1, bound } };
  }

  /// From the origin, in the axes of some dual points.
  OctahedralMap directions(const PointSubset& subset) const
  {
    constexpr std::uint32_t Some = 1 << 10;
    const std::uint32_t step = subset.count / Some + 1;
    std::vector<Vertex> vertices;
    double unit[3] = { 0, 0, 0 };
    subset.eachWanted(this->source, 0, subset.count,
      [&](std::uint32_t id)
      {
        if (id % step == 0 || id >= this->view.count) // what bounds a prism
        {
          vertices.push_back(this->source.vertex(id));
          for (int i = 0; i < 3; ++i)
          {
            unit[i] = std::max(unit[i], std::fabs(vertices.back().x[i]));
          }
        }
      });
    const bool isInRange =
      std::all_of(unit, unit + 3, [](double x) { return x > 0x1p-500 && x < 0x1p500; });
    constexpr double origin[3] = { 0, 0, 0 };
    return octahedralMapOf(origin, isInRange ? unit : nullptr, vertices.data(),
      std::max<std::size_t>(vertices.size(), 1));
  }

  Polyhedron tetrahedronOf(const std::array<FarRow, 4>& far)
  {
    Vertex corner[4];
    for (int i = 0; i < 4; ++i)
    {
      const FarRow& row = far[static_cast<std::size_t>(i)];
      this->setRow(this->farId(i), row.data(), this->center);
      corner[i].id = this->farId(i);
      corner[i].flags = VertexAlive;
      std::transform(
        row.begin(), row.begin() + 3, corner[i].x, [&](double x) { return x / row[3]; });
    }
    if (this->geometry.above(corner[0], corner[1], corner[2], corner[3]) > 0)
    {
      std::swap(corner[1], corner[2]);
    }
    return makeTetrahedron(corner);
  }

  /// Of bounds and of the interior, a power of two.
  double greatestSize() const
  {
    double most = std::max({ std::fabs(this->center[0]), std::fabs(this->center[1]),
      std::fabs(this->center[2]), std::numeric_limits<double>::min() });
    for (std::size_t i = 3; i < this->rows.size(); i += 4)
    {
      most = std::max(most, std::fabs(this->rows[i]));
    }
    return std::ldexp(1.0, std::ilogb(most));
  }

  /// The vertices above, in order around the polygon; and their sides.
  void keepPolygon(HalfSpaceIntersection& result) const
  {
    const std::vector<std::int64_t> ids(result.pointIds.begin(), result.pointIds.end());
    const auto count = static_cast<std::int64_t>(ids.size()) - 2; // above and below are the last
    std::vector<std::int64_t> next(static_cast<std::size_t>(count), -1);
    for (std::int64_t cell = 0; cell < result.cellCount(); ++cell)
    {
      const std::int64_t* const corner = result.connectivity.data() + result.cellBegin(cell);
      for (int i = 0; i < 3; ++i)
      {
        if (corner[i] == count)
        {
          next[static_cast<std::size_t>(corner[(i + 1) % 3])] = corner[(i + 2) % 3];
        }
      }
    }
    result.offsets = Buffer<std::int64_t>();
    result.cellSize = 2;
    result.connectivity = Buffer<std::int64_t>(static_cast<std::size_t>(2 * count));
    std::int64_t side = 0;
    for (std::size_t i = 0; i < result.connectivity.size(); i += 2)
    {
      ensure(side >= 0);
      result.connectivity[i] = side;
      side = next[static_cast<std::size_t>(side)];
      result.connectivity[i + 1] = side;
    }
    ensure(side == 0);
    result.pointIds = Buffer<std::int64_t>(static_cast<std::size_t>(count));
    std::copy_n(ids.begin(), count, result.pointIds.begin());
  }

  /// Of cells and of half-spaces.
  void writePositions(HalfSpaceIntersection& result) const
  {
    const auto dimension = static_cast<std::size_t>(this->view.dimension);
    const auto cells = static_cast<std::size_t>(result.cellCount());
    result.vertices = Buffer<double>(cells * dimension);
    const auto rowOf = [&](std::int64_t corner)
    { return &this->table[static_cast<std::size_t>(result.pointIds[corner])]; };
    for (std::size_t cell = 0; cell < cells; ++cell)
    {
      const std::int64_t begin = result.cellBegin(static_cast<std::int64_t>(cell));
      const std::int64_t* const corner = result.connectivity.data() + begin;
      const HalfSpaceRow* const three[3] = { rowOf(corner[0]), rowOf(corner[1]),
        dimension == 2 ? &this->table[this->above()] : rowOf(corner[2]) };
      for (std::size_t i = 0; i < dimension; ++i)
      {
        const double x = meetingPoint(three, static_cast<int>(i));
        if (!std::isfinite(x))
        {
          throw badArgument("the intersection's vertices must be in the range of doubles");
        }
        result.vertices[cell * dimension + i] = x;
      }
    }
  }

  const HalfSpaceView view;
  HalfSpaceRows rows;
  std::vector<double>& positions; ///< dual points as the run reads them
  std::vector<HalfSpaceRow> table;
  double center[3] = { 0, 0, 0 };
};

/// @throw Error BadArgument, TooManyPoints
void requireValid(const HalfSpaceView& view, const double* interior)
{
  if (view.dimension != 2 && view.dimension != 3)
  {
    throw badArgument("half-spaces must be of 2 or 3 dimensions", -1, view.dimension);
  }
  if (view.count < 0)
  {
    throw badArgument("a count of half-spaces must be 0 or more", -1, view.count);
  }
  if (view.count > 0 && !view.rows)
  {
    throw badArgument("half-spaces must be in memory: a null pointer was given");
  }
  if (view.count > static_cast<std::int64_t>(NoIndex) - 16)
  {
    throw Error(ErrorCode::TooManyPoints, -1, view.count);
  }
  if (interior &&
    !std::all_of(interior, interior + view.dimension, [](double x) { return std::isfinite(x); }))
  {
    throw badArgument("the interior point must be finite");
  }
}

}

HalfSpaceIntersection halfSpaceIntersection(
  const HalfSpaceView& halfSpaces, const double* interior, const Options& options)
{
  return engineCall(
    [&]
    {
      requireValid(halfSpaces, interior);
      std::vector<double> positions(
        static_cast<std::size_t>(3 * (halfSpaces.count + (halfSpaces.dimension == 2 ? 2 : 0))));
      HalfSpaceRun run(halfSpaces, rowsOf(halfSpaces), positions, options);
      return run.execute<HalfSpaceIntersection>(
        [&](HalfSpaceIntersection& result) { run.intersect(interior, result); });
    });
}

}
