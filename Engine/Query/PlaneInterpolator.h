// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Values at positions between the sites, written to a caller's array: what one task computes.
///
/// A value depends on its position alone, not on what others are computed with it. Linear ones
/// inside triangles wait until there are many.
#ifndef flipflop_PlaneInterpolator_h
#define flipflop_PlaneInterpolator_h

#include "Query/NaturalShares.h"
#include "Query/PlaneShares.h"
#include "Query/PreparedTriangulation.h"
#include "Query/TriangleShares.h"
#include <flipflop/TriangulationQueries.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace flipflop
{

/// What is interpolated, by which method, and what there is outside.
struct InterpolationTask
{
  Interpolation method;
  const double* values; ///< values[id * components + c]
  std::int64_t components;
  double fill;
};

/// @tparam T of the results: float or double
template <class T>
class PlaneInterpolator
{
public:
  /// @param result receives the values: result[index * components + c]. All are there after
  ///               finish().
  PlaneInterpolator(
    const PreparedTriangulation& triangulation, const InterpolationTask& toDo, T* result)
    : prepared(triangulation)
    , task(toDo)
    , results(result)
    , signs(triangulation.sites)
    , natural(triangulation.mesh)
  {
  }

  /// @param position null: outside
  void operator()(std::int64_t index, const double* position)
  {
    this->shares.clear();
    if (!position || this->prepared.dimension < 0 || !this->prepared.sites.inBox(position))
    {
      this->put(index);
      return;
    }
    if (this->prepared.dimension == 0)
    {
      this->shares.push_back({ 0, 1.0 });
      this->put(index);
      return;
    }
    this->signs.withSpace(position,
      [&](const auto& space)
      {
        if (this->prepared.dimension == 1)
        {
          linearShares(space, this->prepared.chain.locate(space), this->shares);
          this->put(index);
          return;
        }
        this->addAt(
          index, position, space, this->prepared.locator.locate(space, position, this->start));
      });
  }

  /// The same of a position in the plane that has been located.
  /// @param position as given, of @p space
  template <class Space>
  void addAt(
    std::int64_t index, const double* position, const Space& space, const MeshLocation& location)
  {
    this->shares.clear();
    if (!this->prepared.isInside(location))
    {
      this->put(index);
      return;
    }
    if (this->task.method == Interpolation::Linear && location.kind == MeshLocation::Inside &&
      std::is_same<Space, SiteSigns::Narrow>::value)
    {
      this->addInside(index, space, this->prepared.mesh.triangles[location.triangle].v);
      return;
    }
    linearShares(space, this->prepared.mesh, location, this->shares);
    if (this->task.method == Interpolation::Natural && !this->makeNatural(space, location))
    {
      this->signs.withWideSpace(
        position, [&](const auto& wide) { this->makeNatural(wide, location); });
    }
    this->put(index);
  }

  void finish()
  {
    this->inside.compute();
    for (int i = 0; i < this->inside.size(); ++i)
    {
      const std::uint32_t* const v = this->waiting[i].corners;
      this->shares.clear();
      if (this->inside.isDone(i))
      {
        for (int corner = 0; corner < 3; ++corner)
        {
          this->shares.push_back({ v[corner], this->inside.share(i, corner) });
        }
      }
      else
      {
        const Vertex query{ { this->inside.coordinate(i, 0), this->inside.coordinate(i, 1), 0.0 },
          NoIndex, 0 };
        sharesOfCorners(this->signs.narrow(query), v, this->shares);
      }
      this->put(this->waiting[i].index);
    }
    this->inside.clear();
  }

private:
  struct Waiting
  {
    std::int64_t index;
    const std::uint32_t* corners;
  };

  template <class Space>
  void addInside(std::int64_t index, const Space& space, const std::uint32_t* corners)
  {
    this->waiting[this->inside.size()] = { index, corners };
    const Sites& sites = this->prepared.sites;
    this->inside.add(sites[corners[0]].x, sites[corners[1]].x, sites[corners[2]].x, space.query.x);
    if (this->inside.isFull())
    {
      this->finish();
    }
  }

  /// From the linear shares to the natural ones, where these are others.
  /// @return false where the space does not carry the query's weight
  template <class Space>
  bool makeNatural(const Space& space, const MeshLocation& location)
  {
    const bool onEdge = location.kind == MeshLocation::OnEdge;
    if ((location.kind != MeshLocation::Inside && !onEdge) ||
      (onEdge && this->prepared.mesh.twin(halfEdge(location.triangle, location.corner)) == NoIndex))
    {
      return true;
    }
    double weight = 0.0;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const PlaneShare& share : this->shares)
    {
      const double ofSite = space.site(share.site).x[2];
      weight += share.share * ofSite;
      least = std::min(least, ofSite);
      most = std::max(most, ofSite);
    }
    weight = std::max(least, std::min(most, weight));
    if (!space.carries(weight))
    {
      return false;
    }
    Space lifted = space;
    lifted.query.x[2] = weight;
    this->natural.share(lifted, location.triangle, this->shares);
    return true;
  }

  /// What the shares make of the values. Without shares it is outside.
  void put(std::int64_t index)
  {
    T* const to = this->results + index * this->task.components;
    for (std::int64_t c = 0; c < this->task.components; ++c)
    {
      to[c] = static_cast<T>(this->shares.empty() ? this->task.fill : this->blended(c));
    }
  }

  /// Of shares that only nearly sum to 1; but never beyond the values, and of one value that value.
  /// @param c of the components
  double blended(std::int64_t c) const
  {
    double sum = 0.0;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const PlaneShare& share : this->shares)
    {
      const auto id = static_cast<std::int64_t>(this->prepared.sites[share.site].id);
      const double value = this->task.values[id * this->task.components + c];
      sum += share.share * value;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    return sum < low ? low : sum > high ? high : sum; // NaN stays
  }

  const PreparedTriangulation& prepared;
  const InterpolationTask& task;
  T* const results;
  const SiteSigns signs;
  WalkStart start;
  NaturalNeighbours natural;
  PlaneShares shares;
  TriangleShares inside;
  Waiting waiting[TriangleShares::Capacity];
};

}

#endif
