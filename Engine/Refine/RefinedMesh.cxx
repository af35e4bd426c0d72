// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The steps of refinedMesh(): the constrained triangulation of the input, what is inside and its
/// regions, the refinement, the result.
#include <flipflop/RefinedMesh.h>

#include "Constraints/FixedEdge.h"
#include "Edit/EditableMesh.h"
#include "Edit/MeshSnapshot.h"
#include "Points/ConstraintInput.h"
#include "Refine/AreaField.h"
#include "Refine/InputShares.h"
#include "Refine/Refinement.h"
#include "Refine/SplitPoints.h"
#include "Run/Run.h"
#include "Support/EngineCall.h"
#include "Support/ProgressOfParts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace flipflop
{

namespace
{

using RefinedTriangles = EditableMesh<false>;

void requireUsable(const RefinementOptions& refinement)
{
  if (!(refinement.minAngle >= 0 && refinement.minAngle <= 34))
  {
    throw badArgument("the least angle must be from 0 to 34 degrees");
  }
  if (!(refinement.maxArea >= 0))
  {
    throw badArgument("the greatest area must be 0 (any) or more");
  }
  if (refinement.maxPoints < 0 || refinement.regionCount < 0 ||
    (refinement.regionCount > 0 && !refinement.regions))
  {
    throw badArgument("the numbers of points and of regions must be 0 or more");
  }
  for (std::int64_t i = 0; i < refinement.regionCount; ++i)
  {
    const MeshRegion& region = refinement.regions[i];
    if (!(std::isfinite(region.x) && std::isfinite(region.y)))
    {
      throw badArgument("the point of a region must be finite", i);
    }
    if (!(region.maxArea >= 0))
    {
      throw badArgument("the greatest area of a region must be 0 (as everywhere) or more", i);
    }
  }
}

class RefinementRun : public Run
{
public:
  RefinementRun(const PointView& points, const ConstraintView& given,
    const RefinementOptions& refinement, const Options& options)
    : Run(points, 2, PointSource(points, WeightView()), options)
    , view(points)
    , constraints(given)
    , wanted(refinement)
    , parts(options)
  {
    requireUsable(refinement);
    flipflop::requireValid(given, points.count);
  }

  void compute(RefinedMesh& result)
  {
    const bool anyPoint = this->scanPoints(result.statistics);
    requireFinite(this->constraints, this->source, this->checkFinite);
    const PointSource unscaled = this->source;
    if (anyPoint)
    {
      this->start = constrainedTriangulation(this->view, this->constraints, this->startOptions());
    }
    if (this->start.dimension < 2)
    {
      static_cast<ConstrainedTriangulation&>(result) = std::move(this->start);
      this->writePoints(unscaled, result);
      return;
    }
    this->chooseArithmetic();
    this->buildMesh();
    this->findRegions();
    const AreaField areas(this->wanted, this->view, this->start, this->options);
    const RefinementLimits limits = this->limits(areas);
    Refinement refinement(*this->mesh, std::move(this->regionOf), limits, *this->positions,
      this->source.count(), this->monitor);
    this->addSegments(refinement);
    this->monitor.stage(0.2, 0.8, 1, "refining");
    refinement.run();
    this->monitor.stage(0.8, 1.0, 1, "finishing");
    this->write(refinement, unscaled, result);
  }

private:
  Options startOptions()
  {
    Options result = this->parts.options(0.0, 0.2);
    result.nonFinite = this->options.nonFinite;
    result.polygons = this->options.polygons;
    return result;
  }

  /// The range of what there will be: new points are in the hull, on multiples of a unit.
  void chooseArithmetic()
  {
    const double unit =
      RoundedPositions(this->range, std::numeric_limits<double>::denorm_min()).step();
    for (double& smallest : this->range.smallest)
    {
      smallest = std::min(smallest, unit);
    }
    this->range.smallest[2] = HUGE_VAL;
    const Arithmetic chosen = chooseLiftedArithmetic(this->range);
    if (chosen.wide)
    {
      throw badArgument("coordinates of a mesh to be refined must be 0 where they are smaller than "
                        "the greatest by more than about 60 orders of magnitude");
    }
    this->setArithmetic(chosen);
    this->positions = std::make_unique<RoundedPositions>(
      this->range, std::ldexp(unit, this->source.scaleExponent(0)));
  }

  void buildMesh()
  {
    this->mesh =
      std::make_unique<RefinedTriangles>(RefinedTriangles::Geometry(this->range, this->arithmetic));
    this->slotOf.assign(this->source.count(), 0);
    for (const std::int64_t id : this->start.pointIds)
    {
      this->slotOf[static_cast<std::size_t>(id)] =
        this->mesh->addSlot(this->source.vertex(static_cast<std::uint32_t>(id)));
    }
    this->mesh->adopt(this->start, slotOfCorner);

    this->regionOf.assign(this->mesh->triangleCount(), 0);
    if (this->constraints.sides > 0)
    {
      std::vector<std::uint8_t> inside(static_cast<std::size_t>(this->start.cellCount()));
      const std::int64_t* const features = this->wanted.featureOf;
      features ? cellsInsideFeatures(this->start, this->view, this->constraints, features,
                   inside.data(), this->startOptions())
               : cellsInside(this->start, inside.data(), this->startOptions());
      std::copy(inside.begin(), inside.end(), this->regionOf.begin());
    }
    else if (!this->findEnclosed())
    {
      std::fill_n(this->regionOf.begin(), this->start.cellCount(), 1);
      this->eachHullEdge([this](std::uint32_t h) { this->mesh->setFixed(h, true); });
      this->coversHull = true;
    }
  }

  /// use (half-edge) for each edge of the convex hull, which is on its right.
  template <class Use>
  void eachHullEdge(const Use& use) const
  {
    for (auto t = static_cast<std::uint32_t>(this->start.cellCount());
         t < this->mesh->triangleCount(); ++t)
    {
      use(halfEdge(t, 0));
    }
  }

  /// Mark what constraints enclose: no way from outside leads there without crossing one.
  /// @return is there any?
  bool findEnclosed()
  {
    std::fill_n(this->regionOf.begin(), this->start.cellCount(), 1);
    const auto enter = [this](std::uint32_t h)
    {
      if (!this->mesh->isFixed(h))
      {
        this->flood(triangleOf(this->mesh->twin(h)), 0);
      }
    };
    this->eachHullEdge(enter);
    return std::count(this->regionOf.begin(), this->regionOf.end(), 1u) > 0;
  }

  /// From a triangle of region 1 up to fixed edges, make the region another.
  void flood(std::uint32_t t, std::uint32_t region)
  {
    std::vector<std::uint32_t> next;
    const auto enter = [&](std::uint32_t triangle)
    {
      if (this->regionOf[triangle] == 1)
      {
        this->regionOf[triangle] = region;
        next.push_back(triangle);
      }
    };
    for (enter(t); !next.empty();)
    {
      const std::uint32_t from = next.back();
      next.pop_back();
      for (int e = 0; e < 3; ++e)
      {
        if (!this->mesh->isFixed(halfEdge(from, e)))
        {
          enter(triangleOf(this->mesh->twin(halfEdge(from, e))));
        }
      }
    }
  }

  static std::uint32_t slotOfCorner(std::int64_t corner)
  {
    return static_cast<std::uint32_t>(corner) + 1;
  }

  /// From the point of each region up to fixed edges.
  void findRegions()
  {
    for (std::int64_t i = 0; i < this->wanted.regionCount; ++i)
    {
      const double given[2] = { this->wanted.regions[i].x, this->wanted.regions[i].y };
      Vertex seed = { {}, NoIndex, 0 };
      bool isInRange = true;
      for (int axis = 0; axis < 2; ++axis)
      {
        seed.x[axis] = std::ldexp(given[axis], this->source.scaleExponent(axis));
        isInRange = isInRange && seed.x[axis] >= this->range.low[axis] &&
          seed.x[axis] <= this->range.high[axis];
      }
      const std::uint32_t t = isInRange ? this->mesh->locate(seed) : 0;
      std::uint32_t blocked = NoIndex;
      if (!isInRange || this->regionOf[t] == 0 ||
        (this->mesh->walkWithin(seed, t, blocked) == t && blocked != NoIndex))
      {
        throw badArgument("the point of a region must be inside of the mesh, on no constraint", i);
      }
      if (this->regionOf[t] != 1)
      {
        throw badArgument("two regions must not be in one part of the mesh", i);
      }
      this->flood(t, static_cast<std::uint32_t>(i + 2));
    }
    for (std::uint32_t& region : this->regionOf)
    {
      region = region >= 2 && this->wanted.regions[region - 2].isHole ? 0 : region;
    }
  }

  RefinementLimits limits(const AreaField& areas) const
  {
    constexpr std::int64_t MostPoints = 10000000;
    const int exponent = this->source.scaleExponent(0);
    const auto scaled = [exponent](double area)
    { return area > 0 ? std::ldexp(area, 2 * exponent) : HUGE_VAL; };
    const std::int64_t remainingIds = std::int64_t(NoIndex) - 1 - this->source.count();
    const std::int64_t wantedPoints =
      this->wanted.maxPoints > 0 ? this->wanted.maxPoints : MostPoints;
    RefinementLimits result{ AngleBound(this->wanted.minAngle),
      { HUGE_VAL, scaled(this->wanted.maxArea) }, std::min(wantedPoints, remainingIds),
      areas.isAnywhereTheSame() ? nullptr : &areas, exponent };
    for (std::int64_t i = 0; i < this->wanted.regionCount; ++i)
    {
      const double own = this->wanted.regions[i].maxArea;
      result.mostArea.push_back(own > 0 ? scaled(own) : result.mostArea[1]);
    }
    return result;
  }

  /// The fixed edges of the start, and what else is of the hull.
  void addSegments(Refinement& refinement)
  {
    const std::size_t count = this->start.constraintOf.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      refinement.addSegment(slotOfCorner(this->start.fixedEdges[2 * i]),
        slotOfCorner(this->start.fixedEdges[2 * i + 1]));
    }
    if (this->coversHull)
    {
      this->eachHullEdge([&](std::uint32_t h)
        { refinement.addSegment(this->mesh->origin(h), this->mesh->origin(nextHalfEdge(h))); });
    }
  }

  std::uint32_t constraintOf(std::uint32_t segment) const
  {
    return segment < this->start.constraintOf.size()
      ? static_cast<std::uint32_t>(this->start.constraintOf[segment])
      : NoIndex;
  }

  void write(const Refinement& refinement, const PointSource& unscaled, RefinedMesh& result)
  {
    this->numberNewPoints();
    result.newPoints = static_cast<std::int64_t>(this->newSlots.size());
    result.keptSegments = refinement.keptSegments();
    result.keptTriangles = refinement.keptTriangles();
    result.isComplete = !refinement.reachedLimit();
    writeCells(*this->mesh, this->source.count() + static_cast<std::uint32_t>(result.newPoints),
      Options(), this->monitor, result);
    this->rankPoints(result);
    result.hiddenIds = std::move(this->start.hiddenIds);
    result.sides = this->constraints.sides;
    this->writeSegments(refinement, result);
    this->writeRegions(refinement, result);
    this->writePoints(unscaled, result);
    for (std::size_t i = 0; i < this->newSlots.size(); ++i)
    {
      const std::uint32_t segment = refinement.segmentOf(this->newSlots[i]);
      const std::uint32_t constraint = segment == NoIndex ? NoIndex : this->constraintOf(segment);
      result.constraintOfPoint[i] =
        constraint == NoIndex ? -1 : static_cast<std::int64_t>(constraint);
    }
    const auto& small = refinement.smallAngles();
    result.smallAngles.allocate(3 * small.size());
    for (std::size_t i = 0; i < 3 * small.size(); ++i)
    {
      result.smallAngles[i] = this->mesh->vertex(small[i / 3][i % 3]).id;
    }
    if (this->wanted.findsShares)
    {
      result.shares = sharesInInput(this->view, this->start, refinement, *this->mesh,
        this->newSlots, &result.points[2 * this->source.count()], this->options.threads);
    }
  }

  /// Some were removed again: the others have consecutive ids, in the same order.
  void numberNewPoints()
  {
    for (auto slot = static_cast<std::uint32_t>(this->start.pointIds.size() + 1);
         slot < this->mesh->slotCount(); ++slot)
    {
      if (this->mesh->isVisible(slot))
      {
        Vertex vertex = this->mesh->vertex(slot);
        vertex.id = this->source.count() + static_cast<std::uint32_t>(this->newSlots.size());
        this->mesh->setPoint(slot, vertex);
        this->newSlots.push_back(slot);
      }
    }
  }

  void rankPoints(const RefinedMesh& result)
  {
    const auto count = static_cast<std::int64_t>(this->source.count());
    this->rankOf.assign(this->mesh->slotCount(), NoIndex);
    for (std::uint32_t rank = 0; rank < result.pointIds.size(); ++rank)
    {
      const std::int64_t id = result.pointIds[rank];
      const std::uint32_t slot = id < count ? this->slotOf[static_cast<std::size_t>(id)]
                                            : this->newSlots[static_cast<std::size_t>(id - count)];
      this->rankOf[slot] = rank;
    }
  }

  void writeSegments(const Refinement& refinement, RefinedMesh& result)
  {
    std::vector<FixedEdge> edges;
    refinement.eachPart(
      [&](std::uint32_t from, std::uint32_t to, std::uint32_t segment)
      {
        SidesAlong sides;
        if (segment < this->start.constraintOf.size())
        {
          sides.balance = this->start.balance[segment];
          const std::int64_t side = this->start.sideOf[segment];
          sides.first[sides.balance < 0] = side < 0 ? NoIndex : static_cast<std::uint32_t>(side);
        }
        edges.emplace_back(
          this->rankOf[from], this->rankOf[to], this->constraintOf(segment), sides);
      });
    writeFixedEdges(edges, result);
    for (std::int64_t& constraint : result.constraintOf)
    {
      constraint = constraint == static_cast<std::int64_t>(NoIndex) ? -1 : constraint;
    }
  }

  /// Cells are in lexicographic order, each from its lowest corner on.
  void writeRegions(const Refinement& refinement, RefinedMesh& result)
  {
    const auto cells = static_cast<std::size_t>(result.cellCount());
    const auto corner = [&](std::size_t cell, std::size_t i)
    { return static_cast<std::uint32_t>(result.connectivity[3 * cell + i]); };
    std::vector<std::size_t> begin(result.pointIds.size() + 1, 0);
    for (std::size_t cell = 0; cell < cells; ++cell)
    {
      begin[corner(cell, 0) + 1] = cell + 1;
    }
    for (std::size_t i = 1; i < begin.size(); ++i)
    {
      begin[i] = std::max(begin[i], begin[i - 1]);
    }
    result.region.allocate(cells);
    std::fill(result.region.begin(), result.region.end(), -1);
    for (std::uint32_t t = 0; t < this->mesh->triangleCount(); ++t)
    {
      if (refinement.region(t) == 0)
      {
        continue;
      }
      const std::uint32_t* const v = this->mesh->triangle(t).v;
      const std::uint32_t rank[3] = { this->rankOf[v[0]], this->rankOf[v[1]], this->rankOf[v[2]] };
      const auto lowest = std::min_element(rank, rank + 3) - rank;
      std::size_t cell = begin[rank[lowest]];
      while (corner(cell, 1) != rank[(lowest + 1) % 3])
      {
        ++cell;
      }
      result.region[cell] = static_cast<std::int64_t>(refinement.region(t)) - 1;
    }
  }

  void writePoints(const PointSource& unscaled, RefinedMesh& result)
  {
    const std::size_t count = unscaled.count();
    result.points.allocate(2 * (count + static_cast<std::size_t>(result.newPoints)));
    result.constraintOfPoint.allocate(static_cast<std::size_t>(result.newPoints));
    for (std::size_t id = 0; id < count; ++id)
    {
      double x[3];
      unscaled.load(static_cast<std::uint32_t>(id), x);
      std::copy_n(x, 2, &result.points[2 * id]);
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(result.newPoints); ++i)
    {
      const double* const x = this->mesh->vertex(this->newSlots[i]).x;
      for (int axis = 0; axis < 2; ++axis)
      {
        result.points[2 * (count + i) + static_cast<std::size_t>(axis)] =
          std::ldexp(x[axis], -this->source.scaleExponent(axis));
      }
    }
  }

  const PointView view;
  const ConstraintView constraints;
  const RefinementOptions& wanted;
  ProgressOfParts parts; ///< of calls of other parts of the engine
  ConstrainedTriangulation start;
  std::unique_ptr<RoundedPositions> positions;
  std::unique_ptr<RefinedTriangles> mesh;
  std::vector<std::uint32_t> slotOf;   ///< by id of an input point; 0: it is not visible
  std::vector<std::uint32_t> newSlots; ///< of new points, by ascending ids
  std::vector<std::uint32_t> rankOf;   ///< by slot, among the visible points
  std::vector<std::uint32_t> regionOf; ///< by triangle; 0: outside, 1: in none of the regions
  bool coversHull = false;             ///< its edges are segments
};

}

RefinedMesh refinedMesh(const PointView& points, const ConstraintView& constraints,
  const RefinementOptions& refinement, const Options& options)
{
  return engineCall(
    [&]
    {
      RefinementRun run(points, constraints, refinement, options);
      return run.execute<RefinedMesh>([&run](RefinedMesh& result) { run.compute(result); });
    });
}

}
