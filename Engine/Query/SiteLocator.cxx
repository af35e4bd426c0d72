// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/SiteLocator.h"

#include <cmath>

namespace flipflop
{

SiteLocator::SiteLocator(const Sites& points, const FanMesh& fans, Monitor& monitor)
  : sites(&points)
  , mesh(&fans)
{
  StepPoll poll(monitor);
  std::vector<ValuedPosition> positions;
  positions.reserve(points.count());
  for (std::uint32_t v = 0; v < points.count(); ++v)
  {
    poll.step();
    positions.push_back({ { points[v].x[0], points[v].x[1] }, fans.lowestAt[v] });
  }
  this->grid.build(
    std::move(positions), [](double, double, std::uint32_t t) { return t; },
    [&poll] { poll.step(); });
  double side = 1;
  for (int i = 0; i < 2; ++i)
  {
    side *= std::sqrt(points.scaled(points.highest(i)) - points.scaled(points.lowest(i)));
  }
  this->nearDistance = 2 * side / std::sqrt(static_cast<double>(points.count()));
}

MeshLocation SiteLocator::lowest(std::uint32_t t, int onSides) const
{
  if (onSides == 0)
  {
    return { MeshLocation::Inside, t, 0 };
  }
  int side = onSides & 1 ? 0 : (onSides & 2 ? 1 : 2);
  if (onSides == 1 << side)
  {
    const std::uint32_t twin = this->mesh->triangles[t].twin[side];
    return twin < halfEdge(t, side)
      ? MeshLocation{ MeshLocation::OnEdge, triangleOf(twin), cornerOf(twin) }
      : MeshLocation{ MeshLocation::OnEdge, t, side };
  }
  // On two sides: at the corner between them.
  const int corner = onSides == 3 ? 1 : (onSides == 6 ? 2 : 0);
  const std::uint32_t h = this->mesh->leaving(this->mesh->triangles[t].v[corner]);
  return { MeshLocation::AtCorner, triangleOf(h), cornerOf(h) };
}

}
