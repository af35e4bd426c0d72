// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What power cells are cut by: a convex polygon, or a box, which is one of four corners.
#ifndef flipflop_CellDomain_h
#define flipflop_CellDomain_h

#include "PowerDiagram/CellLines.h"
#include "PowerDiagram/CellRing.h"
#include "PowerDiagram/CornerNumbers.h"
#include "PowerDiagram/DomainCorners.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

class CellDomain
{
public:
  /// Where the center of a facet is: a bit for each side of the bounding box that it is not within,
  /// and one more if it is in the polygon. None: that is not known.
  static constexpr std::uint8_t Inside = 16;

  /// @param polygon  from domainCorners(); it must live on
  /// @param boxGiven is it given as a box?
  CellDomain(const std::vector<double>& polygon, bool boxGiven)
    : corners(polygon)
    , bounds(boundingBox(polygon))
    , isBox(boxGiven)
  {
  }

  /// Rounding keeps the order along each axis, but may take a position to a side.
  bool isInBox(const Position& x) const
  {
    const std::array<double, 4>& b = this->bounds;
    return this->isBox && x[0] > b[0] && x[0] < b[1] && x[1] > b[2] && x[1] < b[3];
  }

  /// @param x        the center, each coordinate rounded to nearest
  /// @param triangle of the facet
  std::uint8_t whereIs(const Position& x, const std::array<const PowerSite*, 3>& triangle) const;

  /// From one corner of the polygon to the next.
  CellLine side(std::size_t number) const
  {
    return { nullptr, this->corner(number), this->corner(number + 1) };
  }

  /// In a box: does an edge to a neighbour meet a side here, after rounding took its other end to
  /// that side? The other end stands for both: their order along the side may be wrong.
  bool isSpike(const CellRing& ring, CellRing::Index i) const;

  const std::vector<double>& corners;
  const std::array<double, 4> bounds; ///< x least, x greatest, y least, y greatest
  const bool isBox;

private:
  const double* corner(std::size_t i) const
  {
    return this->corners.data() + 2 * i % this->corners.size();
  }

  bool surelyHolds(const Position& x) const;
};

}

#endif
