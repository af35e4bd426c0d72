// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The visible points of a triangulation as vertices, and the arithmetic that a query next to them
/// takes.
///
/// Sites are scaled as their own range requires. Nearly all queries fit that range, and are scaled
/// alike. One that does not (1e-200 among sites about 1) is decided in wide integers, with the
/// sites as they were given: so each query takes the arithmetic that it needs, whatever others come
/// with it.
#ifndef flipflop_Sites_h
#define flipflop_Sites_h

#include "Geometry/LiftedGeometry.h"
#include "Points/CoordinateRange.h"
#include "Points/Vertex.h"
#include "PowerDiagram/PowerSite.h"
#include <flipflop/Buffer.h>
#include <flipflop/Triangulation.h>

#include <cmath>
#include <cstdint>

namespace flipflop
{

class Sites
{
public:
  using Geometry = LiftedGeometry<true>;

  Sites() = default;

  /// @param sites as they were given; there is one at least
  Sites(const Buffer<PowerSite>& sites, const Triangulation& triangulation);

  /// How many.
  std::uint32_t count() const { return static_cast<std::uint32_t>(this->vertices.size()); }

  /// Of a site, by index: its id is that of the input.
  const Vertex& operator[](std::size_t i) const { return this->vertices[i]; }
  const Vertex* data() const { return this->vertices.data(); }

  /// @param order the sites' indices until now
  void renumber(const Buffer<std::uint32_t>& order);

  /// Of an axis, as given.
  double lowest(int axis) const { return this->low[axis]; }
  double highest(int axis) const { return this->high[axis]; }

  /// Is a weight not zero?
  bool areWeighted() const { return this->weighted; }

  const Geometry& scaledGeometry() const { return this->geometry; }

  /// Is a position, as given, in the box of the sites? (Outside it is outside of their hull.)
  bool inBox(const double* position) const
  {
    return position[0] >= this->low[0] && position[0] <= this->high[0] &&
      position[1] >= this->low[1] && position[1] <= this->high[1];
  }

  /// The nearest position in the box.
  void intoBox(double* position) const
  {
    for (int i = 0; i < 2; ++i)
    {
      position[i] = position[i] < this->low[i] ? this->low[i]
        : position[i] > this->high[i]          ? this->high[i]
                                               : position[i];
    }
  }

  /// A position scaled as the sites are; rounded where it does not fit.
  Vertex scaled(const double* position) const
  {
    return { { this->scaled(position[0]), this->scaled(position[1]), 0.0 }, NoIndex, 0 };
  }
  double scaled(double coordinate) const
  {
    return this->exponent == 0 ? coordinate : std::ldexp(coordinate, this->exponent);
  }

  /// Coordinates are scaled by 2^ this.
  int scaleExponent() const { return this->exponent; }

  /// Do the expansions that suit the sites carry a coordinate, too?
  bool fits(double coordinate) const
  {
    const double size = std::fabs(coordinate);
    return !this->geometry.isWide() && (size == 0 || (size >= this->least && size <= this->most));
  }

private:
  friend class SiteSigns;

  bool fitsWeight(double weight) const
  {
    return weight == 0 || std::fabs(weight) >= this->leastWeight;
  }

  Buffer<Vertex> vertices; ///< scaled
  Geometry geometry;       ///< of the scaled ones
  Geometry wideGeometry;   ///< of what is given
  int exponent = 0;        ///< scaled by 2^ this, weights by its square
  double least = 0;        ///< magnitudes of coordinates that fit
  double most = 0;
  bool weighted = false;
  double leastWeight = 0;   ///< of scaled weights that fit
  double low[2] = { 0, 0 }; ///< the box, not scaled
  double high[2] = { 0, 0 };
};

/// The exact signs of positions next to sites: for one task, as it counts.
class SiteSigns
{
public:
  explicit SiteSigns(const Sites& points)
    : sites(points)
    , geometry(points.geometry)
    , wideGeometry(points.wideGeometry)
  {
  }

  /// Where the sites and a query are scaled.
  struct Narrow
  {
    const Sites& sites;
    const Sites::Geometry& geometry;
    Vertex query;

    const Vertex& site(std::uint32_t i) const { return this->sites[i]; }

    /// May the query have a weight, which is between those of sites?
    bool carries(double weight) const { return this->sites.fitsWeight(weight); }
  };

  /// Where they are as given.
  struct Wide
  {
    const Sites& sites;
    const Sites::Geometry& geometry;
    Vertex query;

    static constexpr bool carries(double) { return true; }

    Vertex site(std::uint32_t i) const
    {
      Vertex result = this->sites[i];
      for (int k = 0; k < 3; ++k)
      {
        result.x[k] = std::ldexp(result.x[k], -(k < 2 ? 1 : 2) * this->sites.exponent);
      }
      return result;
    }
  };

  /// use(space): in the space that carries @p position, which is its query.
  template <class Use>
  auto withSpace(const double* position, Use&& use) const
  {
    if (this->sites.fits(position[0]) && this->sites.fits(position[1]))
    {
      return use(this->narrow(this->sites.scaled(position)));
    }
    return this->withWideSpace(position, use);
  }

  /// Where sites are scaled, with a query that is and that fits.
  Narrow narrow(const Vertex& query) const { return { this->sites, this->geometry, query }; }

  /// The same in the space that carries all positions and weights.
  template <class Use>
  auto withWideSpace(const double* position, Use&& use) const
  {
    return use(Wide{
      this->sites, this->wideGeometry, Vertex{ { position[0], position[1], 0.0 }, NoIndex, 0 } });
  }

private:
  const Sites& sites;
  const Sites::Geometry geometry;
  const Sites::Geometry wideGeometry;
};

}

#endif
