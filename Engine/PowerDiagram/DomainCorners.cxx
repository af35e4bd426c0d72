// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PowerDiagram/DomainCorners.h"

#include "Points/Vertex.h"
#include "PowerDiagram/PlanarRings.h"
#include <flipflop/Error.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace flipflop
{

namespace
{

[[noreturn]] void refuseCorner(std::size_t corner)
{
  throw Error(ErrorCode::NotConvex, static_cast<std::int64_t>(corner));
}

/// @throw Error BadArgument for one that is null, empty or not finite
void requireBox(const double* box)
{
  if (!box)
  {
    throw badArgument("the box must have four numbers: a null pointer was given");
  }
  if (!std::all_of(box, box + 4, [](double x) { return std::isfinite(x); }))
  {
    throw badArgument("the box's bounds must be finite");
  }
  if (!(box[0] < box[1] && box[2] < box[3]))
  {
    throw badArgument("the box must have an inside: the least x below the greatest x, the least y "
                      "below the greatest y");
  }
}

}

std::vector<double> boxCorners(const double* box)
{
  return { box[0], box[2], box[1], box[2], box[1], box[3], box[0], box[3] };
}

std::vector<double> domainCorners(const ConvexDomain& domain)
{
  if (domain.corners == 0)
  {
    requireBox(domain.data);
    return boxCorners(domain.data);
  }
  if (!domain.data || domain.corners < 0 || domain.corners >= NoIndex)
  {
    throw badArgument("a domain must have the x and y of each corner, and a count of corners from "
                      "3 to 4294967294; or the four bounds of a box, and the count 0");
  }
  const auto count = static_cast<std::size_t>(domain.corners);
  const std::vector<double> given(domain.data, domain.data + 2 * count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double* const x = given.data() + 2 * i;
    const double* const before = given.data() + 2 * ((i + count - 1) % count);
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || std::equal(x, x + 2, before))
    {
      refuseCorner(i);
    }
  }
  Ring ring(count);
  std::iota(ring.begin(), ring.end(), 0u);
  const PlanarRings plane(given);
  std::vector<double> bends;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Ring::value_type before = ring[(i + count - 1) % count];
    const Ring::value_type after = ring[(i + 1) % count];
    const double* const x = plane.position(ring[i]);
    if (plane.isReflex(before, ring[i], after))
    {
      refuseCorner(i);
    }
    if (plane.orientation(before, ring[i], after) > 0)
    {
      bends.insert(bends.end(), x, x + 2);
    }
  }
  if (!plane.isConvex(ring.data(), count))
  {
    throw Error(ErrorCode::NotConvex);
  }
  return bends;
}

std::array<double, 4> boundingBox(const std::vector<double>& corners)
{
  std::array<double, 4> box{ corners[0], corners[0], corners[1], corners[1] };
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    box[2 * (i % 2)] = std::min(box[2 * (i % 2)], corners[i]);
    box[2 * (i % 2) + 1] = std::max(box[2 * (i % 2) + 1], corners[i]);
  }
  return box;
}

}
