// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Surface/FlipFlopChecks.h"

#include <set>

namespace flipflop
{
namespace test
{

ReferenceHull hullOfUsed(const Surface& surface)
{
  std::set<std::int64_t> used;
  for (const Corners& t : surface.triangles)
  {
    used.insert(t.begin(), t.end());
  }
  const Cell names(used.begin(), used.end());
  Cloud cloud;
  for (const std::int64_t id : names)
  {
    cloud.push_back(surface.points[static_cast<std::size_t>(id)]);
  }
  ReferenceHull hull = cloud.size() <= 25 ? convexHulls.bruteForce(cloud) : convexHulls.cgal(cloud);
  // Names ascend, so the canonical order stays.
  for (Cell& cell : hull.cells)
  {
    for (std::int64_t& id : cell)
    {
      id = names[static_cast<std::size_t>(id)];
    }
  }
  hull.ids = idsIn(hull.cells);
  return hull;
}

Hull expectFlipFlop(const Surface& surface, const Point& kernel)
{
  const ReferenceHull wanted = hullOfUsed(surface);
  EXPECT_EQ(wanted.dimension, 3);
  const Surface inward = reversed(surface);
  const std::vector<float> floats =
    isFloat(surface.points) ? floatsOf(surface.points) : std::vector<float>();
  const auto count = static_cast<std::int64_t>(surface.points.size());
  Hull first[2];
  for (const FacetMode facets : { FacetMode::Polygons, FacetMode::Triangles })
  {
    Hull& one = first[facets == FacetMode::Triangles];
    for (const int threads : threadsTried())
    {
      // The bits of a number name the other choices.
      for (int choice = 0; choice < (floats.empty() ? 8 : 16); ++choice)
      {
        SCOPED_TRACE(std::to_string(threads) + " threads, " +
          (facets == FacetMode::Polygons ? "polygons" : "triangles") +
          (choice & 1 ? ", V-biased" : "") + (choice & 2 ? ", turned inward" : "") +
          (choice & 4 ? ", kernel to be found" : "") + (choice & 8 ? ", float" : ""));
        Options options;
        options.threads = threads;
        options.facets = facets;
        options.vBiased = choice & 1;
        Hull hull;
        EXPECT_NO_THROW(
          hull = convexify(choice & 8 ? PointView(floats.data(), count) : viewOf(surface.points),
            choice & 2 ? inward.view() : surface.view(), choice & 4 ? nullptr : kernel.data(),
            options));
        EXPECT_EQ(difference(hull, wanted, facets), "");
        EXPECT_EQ(hull.statistics.flips22 + hull.statistics.flips31,
          hull.statistics.flipsV + hull.statistics.flipsD);
        if (threads == 1 && choice == 0)
        {
          one = std::move(hull);
        }
        else
        {
          EXPECT_EQ(bitDifference(hull, one), "");
        }
        if (::testing::Test::HasFailure())
        {
          return std::move(first[1]);
        }
      }
    }
  }
  return std::move(first[1]);
}

std::vector<std::int64_t> unseen(const Surface& surface, const Point& kernel)
{
  const Cloud points = joined(surface.points, { kernel });
  const FilteredSpace space(points);
  std::vector<std::int64_t> result;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Corners& c = surface.triangles[t];
    if (space.orient(static_cast<int>(c[0]), static_cast<int>(c[1]), static_cast<int>(c[2]),
          space.size() - 1) >= 0)
    {
      result.push_back(static_cast<std::int64_t>(t));
    }
  }
  return result;
}

}
}
