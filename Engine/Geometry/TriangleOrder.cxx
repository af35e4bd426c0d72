// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/TriangleOrder.h"

#include "Geometry/HilbertCurve.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

void sortAlongCurve(Polyhedron& polyhedron, const OctahedralMap& octahedral, Monitor& monitor)
{
  const std::uint32_t count = polyhedron.triangleCount();
  const auto middleOf = [&](std::size_t t, double* uv)
  {
    double middle[3] = { 0, 0, 0 };
    for (const std::uint32_t v : polyhedron.triangles[t].v)
    {
      for (int i = 0; i < 3; ++i)
      {
        middle[i] += polyhedron.vertices[v].x[i] / 3;
      }
    }
    octahedral.map(middle, uv);
  };
  const HilbertCurve curve = curveThrough(count, monitor, middleOf);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order(count);
  for (std::uint32_t t = 0; t < count; ++t)
  {
    double uv[2];
    middleOf(t, uv);
    order[t] = { curve.at(uv), t };
  }
  std::sort(order.begin(), order.end());

  std::vector<std::uint32_t> slotOf(count);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    slotOf[order[i].second] = i;
  }
  Buffer<Triangle> sorted(count);
  for (std::uint32_t t = 0; t < count; ++t)
  {
    Triangle& triangle = sorted[slotOf[t]];
    triangle = polyhedron.triangles[t];
    for (std::uint32_t& twin : triangle.twin)
    {
      twin = halfEdge(slotOf[triangleOf(twin)], cornerOf(twin));
    }
  }
  polyhedron.triangles = std::move(sorted);
}

}
