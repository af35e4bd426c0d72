// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The validator for regular triangulations: the cells are regular by themselves, as queries check
/// it; and each hidden point lies beneath the cell that holds it.
#include <flipflop/Validate.h>

#include "Query/SiteLocator.h"
#include "Support/EngineCall.h"
#include "Validate/GivenTriangulation.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace flipflop
{

namespace
{

class TriangulationChecker : private GivenTriangulation
{
public:
  using GivenTriangulation::GivenTriangulation;

  Validation check()
  {
    for (const auto& step : { &TriangulationChecker::checkFinite, &TriangulationChecker::checkIds,
           &TriangulationChecker::checkCells, &TriangulationChecker::checkHidden })
    {
      const Validation found = (this->*step)();
      if (!found)
      {
        return found;
      }
    }
    return Validation();
  }

private:
  /// A point among the corners, as locators want it.
  struct Space
  {
    const Vertex* corners;
    const Geometry& geometry;
    Vertex query;

    const Vertex& site(std::uint32_t i) const { return this->corners[i]; }
  };

  Validation checkFinite() { return flipflop::checkFinite(this->corners); }

  /// The hidden ids must be all the others.
  Validation checkIds()
  {
    const Buffer<std::int64_t>& hidden = this->cells.hiddenIds;
    const Buffer<std::int64_t>& visible = this->cells.pointIds;
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

  Validation checkCells()
  {
    return this->cells.dimension > 0 ? this->checkMesh(nullptr) : Validation();
  }

  Validation checkHidden()
  {
    if (this->cells.hiddenIds.empty())
    {
      return Validation();
    }
    if (this->cells.dimension == 2)
    {
      const SiteLocator locator(this->corners.data(), this->mesh, true, this->run.monitor);
      return this->eachHidden([&](const Space& space, WalkStart& start)
        { return this->faultInPlane(space, locator, start); });
    }
    return this->eachHidden(
      [&](const Space& space, WalkStart&)
      {
        return this->cells.dimension == 1 ? this->faultOnLine(space)
          : Geometry::samePlanePosition(space.site(0), space.query)
          ? compareWeights(space.site(0), space.query)
          : Fault::WrongDimension;
      });
  }

  /// @param test Fault (space, start)
  template <class Test>
  Validation eachHidden(const Test& test) const
  {
    constexpr std::size_t PointsPerTask = 1 << 14;
    return firstFault(this->cells.hiddenIds.size(), PointsPerTask,
      std::make_pair(this->run.geometry, WalkStart()),
      [&](auto& local, std::size_t i)
      {
        const std::int64_t id = this->cells.hiddenIds[i];
        const Vertex p = this->run.source.vertex(static_cast<std::uint32_t>(id));
        const Fault fault = test(Space{ this->corners.data(), local.first, p }, local.second);
        return fault == Fault::None ? Validation() : faultAt(fault, id);
      });
  }

  /// A point at a corner's position must not have a lower id, nor outweigh it.
  static Fault compareWeights(const Vertex& visible, const Vertex& p)
  {
    return p.x[2] > visible.x[2]                    ? Fault::PointOutside
      : p.x[2] == visible.x[2] && p.id < visible.id ? Fault::WrongId
                                                    : Fault::None;
  }

  Fault faultInPlane(const Space& space, const SiteLocator& locator, WalkStart& start) const
  {
    const Vertex& p = space.query;
    const MeshLocation found = locator.locate(space, p, start);
    if (found.kind == MeshLocation::Outside)
    {
      return Fault::PointOutside;
    }
    const std::uint32_t* const v = this->mesh.triangles[found.triangle].v;
    if (found.kind == MeshLocation::AtCorner)
    {
      return compareWeights(space.site(v[found.corner]), p);
    }
    return space.geometry.above(space.site(v[0]), space.site(v[1]), space.site(v[2]), p) > 0
      ? Fault::PointOutside
      : Fault::None;
  }

  Fault faultOnLine(const Space& space) const
  {
    const ChainLocation found = this->chain.locate(space);
    if (found.from == NoIndex)
    {
      const Vertex& first = space.site(0);
      const Vertex& second = space.site(1);
      return space.geometry.orient(first, second, space.query) != 0 ? Fault::WrongDimension
                                                                    : Fault::PointOutside;
    }
    if (found.from == found.to)
    {
      return compareWeights(space.site(found.from), space.query);
    }
    return space.geometry.isAboveChord(space.site(found.from), space.query, space.site(found.to))
      ? Fault::PointOutside
      : Fault::None;
  }
};

}

Validation validate(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, int threads)
{
  return engineCall(
    [&]
    {
      return validateTriangulation(points, weights, triangulation, threads,
        [&](TriangulationRun<true>& run)
        { return TriangulationChecker(run, triangulation).check(); });
    });
}

}
