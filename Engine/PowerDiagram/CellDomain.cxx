// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PowerDiagram/CellDomain.h"

#include "Geometry/ConvexPolygon.h"
#include "Predicates/PlaneOrientation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipflop
{

std::uint8_t CellDomain::whereIs(
  const Position& x, const std::array<const PowerSite*, 3>& triangle) const
{
  if (this->isInBox(x))
  {
    return Inside;
  }
  const std::array<double, 4>& b = this->bounds;
  int sides =
    (x[0] < b[0] ? 1 : 0) | (x[0] > b[1] ? 2 : 0) | (x[1] < b[2] ? 4 : 0) | (x[1] > b[3] ? 8 : 0);
  if (sides != 0 || !this->isBox)
  {
    return static_cast<std::uint8_t>(sides == 0 && this->surelyHolds(x) ? Inside : sides);
  }
  constexpr std::size_t numbers[] = { 3, 1, 0, 2 };
  bool isInside = true;
  for (std::size_t k = 0; k < 4; ++k)
  {
    if (x[k / 2] == b[k])
    {
      const int sign = sideOfMeeting(
        *triangle[0], lineTo(*triangle[1]), lineTo(*triangle[2]), this->side(numbers[k]));
      sides |= (sign <= 0 ? 1 : 0) << k;
      isInside = isInside && sign >= 0;
    }
  }
  return static_cast<std::uint8_t>(sides | (isInside ? Inside : 0));
}

bool CellDomain::isSpike(const CellRing& ring, CellRing::Index i) const
{
  const RingCorner& corner = ring[i];
  const std::int64_t before = ring[corner.before].line;
  if (!this->isBox || (before < 0) == (corner.line < 0))
  {
    return false;
  }
  constexpr std::size_t bound[] = { 2, 1, 3, 0 }; // of bottom, right, top, left
  const std::size_t k = bound[-1 - std::min(before, corner.line)];
  const std::size_t along = 1 - k / 2;
  const double x = corner.x[along];
  return x != this->bounds[2 * along] && x != this->bounds[2 * along + 1] &&
    ring[before < 0 ? corner.after : corner.before].x[k / 2] == this->bounds[k];
}

/// Is every position that rounds to @p x within? False where that is not certain.
bool CellDomain::surelyHolds(const Position& x) const
{
  constexpr double Infinite = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 4; ++k)
  {
    const double around[2] = { std::nextafter(x[0], k % 2 ? Infinite : -Infinite),
      std::nextafter(x[1], k / 2 ? Infinite : -Infinite) };
    if (!std::isfinite(around[0]) || !std::isfinite(around[1]) ||
      fanTriangleOf(this->corners.size() / 2,
        [&](std::size_t i, std::size_t j)
        { return planeOrientation(this->corner(i), this->corner(j), around); }) == 0)
    {
      return false;
    }
  }
  return true;
}

}
