// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/PlaneShares.h"

#include "Query/PlaneValues.h"
#include "Query/Sites.h"

#include <cmath>
#include <cstdint>
#include <utility>

namespace flipflop
{

namespace
{

/// Along the edge of two sites, which the query lies on. The lower index comes first.
template <class Space>
void sharesOnEdge(const Space& space, std::uint32_t a, std::uint32_t b, PlaneShares& shares)
{
  if (a > b)
  {
    std::swap(a, b);
  }
  const Vertex from = space.site(a);
  const Vertex to = space.site(b);
  const int axis = std::fabs(to.x[0] - from.x[0]) >= std::fabs(to.x[1] - from.x[1]) ? 0 : 1;
  withValues(
    [&](auto& values)
    {
      const auto length = values.difference(to.x[axis], from.x[axis]);
      shares.clear();
      shares.push_back(
        { a, toDouble(values.difference(to.x[axis], space.query.x[axis]) / length) });
      shares.push_back(
        { b, toDouble(values.difference(space.query.x[axis], from.x[axis]) / length) });
      return true;
    });
}

}

template <class Space>
void sharesOfCorners(const Space& space, const std::uint32_t* corners, PlaneShares& shares)
{
  const Vertex a = space.site(corners[0]);
  const Vertex b = space.site(corners[1]);
  const Vertex c = space.site(corners[2]);
  const double* const q = space.query.x;
  withValues(
    [&](auto& values)
    {
      const auto ofA = values.area(b.x, c.x, q);
      const auto ofB = values.area(c.x, a.x, q);
      const auto ofC = values.area(a.x, b.x, q);
      const auto all = ofA + ofB + ofC;
      shares.clear();
      shares.push_back({ corners[0], toDouble(ofA / all) });
      shares.push_back({ corners[1], toDouble(ofB / all) });
      shares.push_back({ corners[2], toDouble(ofC / all) });
      return true;
    });
}

template <class Space>
void linearShares(
  const Space& space, const FanMesh& mesh, const MeshLocation& location, PlaneShares& shares)
{
  shares.clear();
  if (location.kind == MeshLocation::Outside)
  {
    return;
  }
  const std::uint32_t* const v = mesh.triangles[location.triangle].v;
  switch (location.kind)
  {
    case MeshLocation::AtCorner:
      shares.push_back({ v[location.corner], 1.0 });
      return;
    case MeshLocation::OnEdge:
      sharesOnEdge(space, v[location.corner], v[nextCorner(location.corner)], shares);
      return;
    default:
      sharesOfCorners(space, v, shares);
  }
}

template <class Space>
void linearShares(const Space& space, const ChainLocation& location, PlaneShares& shares)
{
  shares.clear();
  if (location.from == NoIndex)
  {
    return;
  }
  if (location.from == location.to)
  {
    shares.push_back({ location.from, 1.0 });
    return;
  }
  sharesOnEdge(space, location.from, location.to, shares);
}

template void sharesOfCorners(
  const SiteSigns::Narrow& space, const std::uint32_t* corners, PlaneShares& shares);
template void linearShares(const SiteSigns::Narrow& space, const FanMesh& mesh,
  const MeshLocation& location, PlaneShares& shares);
template void linearShares(
  const SiteSigns::Narrow& space, const ChainLocation& location, PlaneShares& shares);
template void sharesOfCorners(
  const SiteSigns::Wide& space, const std::uint32_t* corners, PlaneShares& shares);
template void linearShares(const SiteSigns::Wide& space, const FanMesh& mesh,
  const MeshLocation& location, PlaneShares& shares);
template void linearShares(
  const SiteSigns::Wide& space, const ChainLocation& location, PlaneShares& shares);

}
