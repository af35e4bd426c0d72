// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Values at positions between the sites, written to a caller's array: what one task computes.
///
/// A value depends on its position alone, not on what others are computed with it. Linear ones
/// inside triangles wait until there are many.
#ifndef flipflop_PlaneInterpolator_h
#define flipflop_PlaneInterpolator_h

#include "Query/CloughTocher.h"
#include "Query/InterpolationTask.h"
#include "Query/NaturalShares.h"
#include "Query/PlaneShares.h"
#include "Query/PreparedTriangulation.h"
#include "Query/SiteGradients.h"
#include "Query/TriangleShares.h"
#include <flipflop/TriangulationQueries.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace flipflop
{

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
      if (this->prepared.numberOf(0) != NoIndex)
      {
        this->shares.push_back({ 0, 1.0 });
      }
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
        const Vertex near = this->prepared.sites.scaled(position);
        this->addAt(
          index, position, space, this->prepared.locator.locate(space, near, this->start));
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
    if (!this->task.isNatural() && location.kind == MeshLocation::Inside &&
      std::is_same<Space, SiteSigns::Narrow>::value)
    {
      this->addInside(index, space, this->prepared.mesh.triangles[location.triangle].v);
      return;
    }
    if (!this->task.isNatural() || this->isBetweenTwo(location))
    {
      linearShares(space, this->prepared.mesh, location, this->shares);
    }
    else if (!this->makeNatural(space, location))
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
      if (this->inside.isDone(i))
      {
        const PlaneShare found[] = { { v[0], this->inside.share(i, 0) },
          { v[1], this->inside.share(i, 1) }, { v[2], this->inside.share(i, 2) } };
        this->put(this->waiting[i].index, found, 3);
      }
      else
      {
        const Vertex query{ { this->inside.coordinate(i, 0), this->inside.coordinate(i, 1), 0.0 },
          NoIndex, 0 };
        sharesOfCorners(this->signs.narrow(query), v, this->shares);
        this->put(this->waiting[i].index);
      }
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

  /// Is a position at a site, or on the border?
  bool isBetweenTwo(const MeshLocation& location) const
  {
    return location.kind == MeshLocation::AtCorner ||
      (location.kind == MeshLocation::OnEdge &&
        this->prepared.mesh.twin(halfEdge(location.triangle, location.corner)) == NoIndex);
  }

  /// Natural shares; where rounding has put the position beneath the sites' surface, linear ones.
  /// @return false where the space does not carry the query's weight
  template <class Space>
  bool makeNatural(const Space& space, const MeshLocation& location)
  {
    Space lifted = space;
    if (this->prepared.sites.areWeighted())
    {
      linearShares(space, this->prepared.mesh, location, this->shares);
      lifted.query.x[2] = this->weightThere(space);
      this->shares.clear();
    }
    if (!space.carries(lifted.query.x[2]))
    {
      return false;
    }
    this->natural.share(lifted, location.triangle,
      this->task.method == Interpolation::Laplace ? NaturalMeasure::SideLength
                                                  : NaturalMeasure::Area,
      this->shares);
    if (this->shares.empty())
    {
      linearShares(space, this->prepared.mesh, location, this->shares);
    }
    return true;
  }

  /// From the linear shares.
  template <class Space>
  double weightThere(const Space& space) const
  {
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
    return std::max(least, std::min(most, weight));
  }

  void put(std::int64_t index) { this->put(index, this->shares.data(), this->shares.size()); }

  /// What shares make of the values. Without shares it is outside.
  void put(std::int64_t index, const PlaneShare* found, std::size_t count)
  {
    if (this->task.shares)
    {
      this->task.shares[index].assign(found, found + count);
      return;
    }
    T* const to = this->results + index * this->task.components;
    if (this->task.gradients && this->prepared.dimension == 2 && count > 1)
    {
      this->putSmooth(to, found, count);
      return;
    }
    for (std::int64_t c = 0; c < this->task.components; ++c)
    {
      to[c] = static_cast<T>(count == 0 ? this->task.fill : this->blended(found, count, c));
    }
  }

  void putSmooth(T* to, const PlaneShare* found, std::size_t count)
  {
    this->takeGradients(found, count);
    for (std::int64_t c = 0; c < this->task.components; ++c)
    {
      const double value = this->smooth(found, count, c);
      to[c] = static_cast<T>(std::isfinite(value) ? value : this->blended(found, count, c));
    }
  }

  /// At the sites that have shares.
  void takeGradients(const PlaneShare* found, std::size_t count)
  {
    const auto size = static_cast<std::size_t>(2 * this->task.components);
    this->slopes.resize(size * count);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->task.gradients->at(found[i].site, this->slopes.data() + i * size);
    }
  }

  /// @param c of the components
  double smooth(const PlaneShare* found, std::size_t count, std::int64_t c) const
  {
    const double unit = this->task.gradients->unit();
    ElementCorner corners[3];
    double parts[3];
    for (std::size_t i = 0; i < count; ++i)
    {
      const Vertex& site = this->prepared.sites[found[i].site];
      const double* const slope =
        this->slopes.data() + 2 * (static_cast<std::int64_t>(i) * this->task.components + c);
      corners[i] = { { site.x[0] * unit, site.x[1] * unit },
        this->task.valuesOf(this->prepared.sites, found[i].site)[c], { slope[0], slope[1] } };
      parts[i] = found[i].share;
    }
    return count == 2 ? cubicOnEdge(corners, parts) : cloughTocher(corners, parts);
  }

  /// Of shares that only nearly sum to 1; but never beyond the values, and of one value that value.
  /// @param c of the components
  double blended(const PlaneShare* found, std::size_t count, std::int64_t c) const
  {
    double sum = 0.0;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double value = this->task.valuesOf(this->prepared.sites, found[i].site)[c];
      sum += found[i].share * value;
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
  std::vector<double> slopes; ///< of each share's site, two a component
  TriangleShares inside;
  Waiting waiting[TriangleShares::Capacity];
};

}

#endif
