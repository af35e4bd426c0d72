// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A polyhedron's triangles along a curve are the same triangles, linked as before, and the borders
/// of runs of them are short.
#include "FlipFlop/CpuBuilder.h"
#include "Geometry/HullStart.h"
#include "Geometry/TriangleOrder.h"
#include "Mesh/Compact.h"
#include "Points/Samples.h"
#include "Run/HullRun.h"
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/InputsInUse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

/// The polyhedron that a run ends with.
class Runner : public HullRun
{
public:
  using HullRun::HullRun;

  Polyhedron polyhedron()
  {
    Hull hull;
    this->inspect(hull);
    const Samples samples = nestedSamples(this->source.count());
    const Span span =
      findSpan(this->geometry, this->source, samples, 3, this->checkFinite, this->monitor);
    CpuBuilder<HullGeometry> builder;
    Tally tally;
    BuildResult built = builder.build(this->task(samples),
      startingTetrahedron(this->geometry, this->source, span.ids), tally, hull.statistics);
    return compact(std::get<Polyhedron>(std::move(built)));
  }

  void sort(Polyhedron& polyhedron)
  {
    sortAlongCurve(polyhedron, octahedralMapOf(this->geometry, polyhedron), this->monitor);
  }
};

/// The corners of each triangle and of its neighbours, in no order.
std::vector<std::array<std::uint32_t, 12>> linksOf(const Polyhedron& polyhedron)
{
  std::vector<std::array<std::uint32_t, 12>> all;
  for (const Triangle& triangle : polyhedron.triangles)
  {
    std::array<std::uint32_t, 12> links;
    std::copy_n(triangle.v, 3, links.begin());
    for (int e = 0; e < 3; ++e)
    {
      const Triangle& other = polyhedron.triangles[triangleOf(triangle.twin[e])];
      const auto corner = static_cast<int>(cornerOf(triangle.twin[e]));
      for (int i = 0; i < 3; ++i)
      {
        links[static_cast<std::size_t>(3 * e + 3 + i)] = other.v[(corner + i) % 3];
      }
    }
    all.push_back(links);
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Edges between the first triangles and the others.
int borderOf(const Polyhedron& polyhedron, std::uint32_t firstCount)
{
  int count = 0;
  for (std::uint32_t t = 0; t < firstCount; ++t)
  {
    for (const std::uint32_t twin : polyhedron.triangles[t].twin)
    {
      count += triangleOf(twin) >= firstCount;
    }
  }
  return count;
}

TEST(TriangleOrder, HasShortBorders)
{
  for (const char* name : { "shell0", "shell1e2", "ball", "cube" })
  {
    SCOPED_TRACE(name);
    const Cloud cloud = makeCloud(name, false, 200000, 1);
    Runner run(viewOf(cloud), Options());
    Polyhedron polyhedron = run.polyhedron();
    const auto links = linksOf(polyhedron);
    run.sort(polyhedron);
    EXPECT_TRUE(linksOf(polyhedron) == links);
    for (const int part : { 2, 3, 7 })
    {
      const std::uint32_t count = polyhedron.triangleCount();
      EXPECT_LT(
        borderOf(polyhedron, count / static_cast<std::uint32_t>(part)), 5 * std::sqrt(count));
    }
  }
}

}
}
}
