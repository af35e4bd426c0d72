// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/SiteLocator.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

SiteLocator::SiteLocator(
  const Vertex* vertices, const FanMesh& fans, bool regular, Monitor& monitor)
  : mesh(&fans)
  , isRegular(regular)
{
  StepPoll poll(monitor);
  const std::size_t count = fans.lowestAt.size();
  std::vector<ValuedPosition> positions;
  positions.reserve(count);
  double low[2] = { HUGE_VAL, HUGE_VAL };
  double high[2] = { -HUGE_VAL, -HUGE_VAL };
  for (std::size_t v = 0; v < count; ++v)
  {
    poll.step();
    const double* const x = vertices[v].x;
    positions.push_back({ { x[0], x[1] }, fans.lowestAt[v] });
    for (int i = 0; i < 2; ++i)
    {
      low[i] = std::min(low[i], x[i]);
      high[i] = std::max(high[i], x[i]);
    }
  }
  this->grid.build(
    std::move(positions), [](double, double, std::uint32_t t) { return t; },
    [&poll] { poll.step(); });
  const double side = std::sqrt(high[0] - low[0]) * std::sqrt(high[1] - low[1]);
  this->nearDistance = 2 * side / std::sqrt(static_cast<double>(count));
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
