// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/Validate.h>

#include "Geometry/LiftedLocator.h"
#include "Geometry/LiftedStart.h"
#include "Run/TriangulationRun.h"
#include "Support/EngineCall.h"
#include "Validate/ValidateStructure.h"
#include "Validate/ValidateSurface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace flipflop
{

namespace
{

/// Below dimension 2 a triangulation is one corner, or a chain of them.
Validation checkTriangulationStructure(std::int64_t pointsGiven, const Triangulation& result)
{
  const Validation structure = checkStructure(pointsGiven, result, 2);
  const auto visible = static_cast<std::int64_t>(result.pointIds.size());
  if (structure && result.dimension < 2)
  {
    const std::int64_t cells = result.dimension == 1 ? visible - 1 : result.dimension + 1;
    if (result.cellCount() != cells || (result.dimension < 1 && visible != cells) ||
      (result.dimension == 1 && visible < 2))
    {
      return faultAt(Fault::Structure, -1);
    }
  }
  return structure;
}

template <bool Weighted>
class TriangulationChecker : private SurfaceChecker<LiftedGeometry<Weighted>>
{
public:
  using Geometry = LiftedGeometry<Weighted>;

  TriangulationChecker(TriangulationRun<Weighted>& run, const Triangulation& result)
    : SurfaceChecker<Geometry>(run, run.geometry, result)
    , run(run)
    , result(result)
  {
  }

  Validation check()
  {
    const Validation finite = this->checkFinite();
    if (!finite)
    {
      return finite;
    }
    const Validation hidden = this->checkHidden();
    if (!hidden)
    {
      return hidden;
    }
    switch (this->result.dimension)
    {
      case -1:
        return faultAt(Fault::WrongDimension, 0); // there is a finite point
      case 0:
        return this->checkPosition();
      case 1:
        return this->checkChain();
      default:
        return this->checkPlane();
    }
  }

private:
  /// The order along a line.
  static bool precedes(const Vertex& a, const Vertex& b)
  {
    return a.x[0] != b.x[0] ? a.x[0] < b.x[0] : a.x[1] < b.x[1];
  }

  /// The hidden ids must be all the others.
  Validation checkHidden() const
  {
    const Buffer<std::int64_t>& hidden = this->result.hiddenIds;
    const Buffer<std::int64_t>& visible = this->result.pointIds;
    std::size_t h = 0;
    std::size_t v = 0;
    for (std::uint32_t id = 0; id < this->run.source.count(); ++id)
    {
      const bool isVisible = v < visible.size() && visible[v] == id;
      const bool isHidden = h < hidden.size() && hidden[h] == id;
      v += isVisible ? 1 : 0;
      h += isHidden ? 1 : 0;
      double x[3];
      this->run.source.load(id, x);
      if ((isVisible ? 1 : 0) + (isHidden ? 1 : 0) != (isFinite(x) ? 1 : 0))
      {
        return faultAt(Fault::Structure, id);
      }
    }
    return h == hidden.size() ? Validation() : faultAt(Fault::Structure, -1);
  }

  /// A point at the position of a visible one may not outweigh it.
  static Fault compareWeights(const Vertex& visible, const Vertex& p)
  {
    return p.x[2] > visible.x[2] ? Fault::PointOutside : checkDuplicate(visible, p);
  }

  Validation checkPosition()
  {
    const Vertex& only = this->corner[0];
    return this->eachPoint(
      [&only](const Geometry&, const Vertex& p) {
        return Geometry::samePlanePosition(only, p) ? compareWeights(only, p)
                                                    : Fault::WrongDimension;
      });
  }

  /// The corners along their line, joined in turn, each above the chord of its neighbours.
  Validation checkChain()
  {
    std::vector<std::uint32_t> along(this->corner.size());
    for (std::size_t i = 0; i < along.size(); ++i)
    {
      along[i] = static_cast<std::uint32_t>(i);
    }
    std::sort(along.begin(), along.end(),
      [this](std::uint32_t a, std::uint32_t b)
      { return precedes(this->corner[a], this->corner[b]); });
    const auto at = [&](std::size_t i) -> const Vertex& { return this->corner[along[i]]; };
    const Geometry& geometry = this->run.geometry;
    for (std::size_t i = 1; i < along.size(); ++i)
    {
      if (Geometry::samePlanePosition(at(i - 1), at(i)))
      {
        return faultAt(Fault::NotExtreme, along[i]);
      }
      if (!this->hasCell(along[i - 1], along[i]))
      {
        return faultAt(Fault::NotClosed, along[i]);
      }
      if (i + 1 < along.size() && geometry.orient(at(i - 1), at(i), at(i + 1)) != 0)
      {
        return faultAt(Fault::WrongDimension, along[i]);
      }
      if (i + 1 < along.size() && !geometry.isAboveChord(at(i - 1), at(i), at(i + 1)))
      {
        return faultAt(Fault::NotExtreme, along[i]);
      }
    }
    return this->eachPoint(
      [&](const Geometry& local, const Vertex& p)
      {
        if (local.orient(at(0), at(along.size() - 1), p) != 0)
        {
          return Fault::WrongDimension;
        }
        const auto after = std::lower_bound(along.begin(), along.end(), p,
          [this](std::uint32_t a, const Vertex& q) { return precedes(this->corner[a], q); });
        if (after == along.end())
        {
          return Fault::PointOutside;
        }
        const Vertex& right = this->corner[*after];
        if (Geometry::samePlanePosition(right, p))
        {
          return compareWeights(right, p);
        }
        return after == along.begin() || local.isAboveChord(this->corner[*(after - 1)], p, right)
          ? Fault::PointOutside
          : Fault::None;
      });
  }

  /// Is there a cell of two corners? Cells are in lexicographic order.
  bool hasCell(std::int64_t a, std::int64_t b) const
  {
    using Cell = std::array<std::int64_t, 2>;
    const Cell wanted = { std::min(a, b), std::max(a, b) };
    const std::int64_t* corners = this->result.connectivity.data();
    std::int64_t begin = 0;
    for (std::int64_t end = this->result.cellCount(); begin < end;)
    {
      const std::int64_t middle = (begin + end) / 2;
      const bool before = Cell{ corners[2 * middle], corners[2 * middle + 1] } < wanted;
      begin = before ? middle + 1 : begin;
      end = before ? end : middle;
    }
    return begin < this->result.cellCount() &&
      Cell{ corners[2 * begin], corners[2 * begin + 1] } == wanted;
  }

  Validation checkPlane()
  {
    const Validation mesh = this->makeMesh(true);
    if (!mesh)
    {
      return mesh;
    }
    const std::vector<std::uint32_t> ids = this->cornerIds();
    const Span span = this->run.spanOf(ids.data(), static_cast<std::uint32_t>(ids.size()));
    if (span.dimension < 2)
    {
      return faultAt(Fault::WrongDimension, -1);
    }
    startingTetrahedron(this->run.geometry, this->run.source, span.ids); // sets the kernel point
    return this->checkSurface();
  }

  TriangulationRun<Weighted>& run;
  const Triangulation& result;
};

template <bool Weighted>
Validation validateAs(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, int threads)
{
  Options options;
  options.threads = threads;
  options.nonFinite = NonFinitePolicy::Ignore;
  // A result in polygons has true facets; one in triangles may have flat edges.
  options.facets = triangulation.cellSize == 3 ? FacetMode::Triangles : FacetMode::Polygons;
  TriangulationRun<Weighted> run(points, weights, options);
  Validation result = checkTriangulationStructure(points.count, triangulation);
  if (!result)
  {
    return result;
  }
  run.template execute<Triangulation>(
    [&](Triangulation& scratch)
    {
      if (!run.inspect(scratch.statistics))
      {
        result = triangulation.dimension != -1 ? faultAt(Fault::WrongDimension, -1)
          : triangulation.hiddenIds.empty()    ? Validation()
                                               : faultAt(Fault::Structure, -1);
        return;
      }
      result = TriangulationChecker<Weighted>(run, triangulation).check();
    });
  return result;
}

}

Validation validate(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, int threads)
{
  return engineCall(
    [&]
    {
      return withOrWithoutWeights(weights,
        [&](auto weighted)
        { return validateAs<weighted>(points, weights, triangulation, threads); });
    });
}

}
