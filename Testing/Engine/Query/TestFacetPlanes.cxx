// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Planes of facets: unit normals, outward, all corners behind them; each component right.
#include "Testing/Engine/Query/QueryCases.h"
#include <flipflop/HullQueries.h>

#include <array>

namespace flipflop
{
namespace test
{

namespace
{

double largestOf(const Cloud& cloud)
{
  double largest = 0;
  for (const Point& p : cloud)
  {
    largest = std::max({ largest, std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2]) });
  }
  return largest;
}

TEST(FacetPlanes, AllCornersAreBehind)
{
  for (const auto& [name, cloud] : queryClouds())
  {
    for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
    {
      const Hull hull = hullOf(cloud, facets);
      const Buffer<double> planes = facetPlanes(viewOf(cloud), hull);
      ASSERT_EQ(
        planes.size(), hull.dimension < 2 ? 0 : 4 * static_cast<std::size_t>(hull.cellCount()));
      const double slack = std::max(2e-15 * largestOf(cloud), 5e-324);
      for (std::size_t cell = 0; cell < planes.size() / 4; ++cell)
      {
        const double* const n = planes.data() + 4 * cell;
        EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-15) << name;
        for (const std::int64_t id : hull.pointIds)
        {
          const Point& p = cloud[static_cast<std::size_t>(id)];
          // Halves: sums of the largest numbers overflow.
          const double height =
            0.25 * n[0] * p[0] + 0.25 * n[1] * p[1] + 0.25 * n[2] * p[2] + 0.25 * n[3];
          EXPECT_LE(height, slack) << name;
          EXPECT_TRUE(hull.dimension == 3 || height >= -slack) << name;
        }
      }
    }
  }
}

TEST(FacetPlanes, EachComponentIsRight)
{
  for (const auto& [name, cloud] : queryClouds())
  {
    const Hull hull = hullOf(cloud, FacetMode::Triangles);
    if (hull.dimension < 2)
    {
      continue;
    }
    const Buffer<double> planes = facetPlanes(viewOf(cloud), hull);
    const auto points = integersOf(cloud);
    const std::vector<Cell> cells = cellsOf(hull);
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
    {
      const auto& a = points[static_cast<std::size_t>(cells[cell][0])];
      const auto& b = points[static_cast<std::size_t>(cells[cell][1])];
      const auto& c = points[static_cast<std::size_t>(cells[cell][2])];
      mpz_class exact[3];
      mpf_class square(0, 256);
      for (std::size_t i = 0; i < 3; ++i)
      {
        const std::size_t p = (i + 1) % 3;
        const std::size_t q = (i + 2) % 3;
        exact[i] = (b[p] - a[p]) * (c[q] - a[q]) - (b[q] - a[q]) * (c[p] - a[p]);
        square += mpf_class(exact[i], 256) * mpf_class(exact[i], 256);
      }
      const mpf_class length(sqrt(square), 256);
      for (std::size_t i = 0; i < 3; ++i)
      {
        const double wanted = mpf_class(mpf_class(exact[i], 256) / length).get_d();
        EXPECT_NEAR(planes[4 * cell + i], wanted, 1e-15 * std::fabs(wanted) + 1e-280) << name;
      }
    }
  }
}

TEST(FacetPlanes, OfACube)
{
  const Cloud cloud = integerGrid(2);
  const Buffer<double> planes = facetPlanes(viewOf(cloud), hullOf(cloud, FacetMode::Polygons));
  ASSERT_EQ(planes.size(), 24u);
  std::vector<std::array<double, 4>> found;
  for (std::size_t cell = 0; cell < 6; ++cell)
  {
    found.push_back(
      { planes[4 * cell], planes[4 * cell + 1], planes[4 * cell + 2], planes[4 * cell + 3] });
  }
  std::sort(found.begin(), found.end());
  const std::vector<std::array<double, 4>> wanted = { { -1, 0, 0, 0 }, { 0, -1, 0, 0 },
    { 0, 0, -1, 0 }, { 0, 0, 1, -1 }, { 0, 1, 0, -1 }, { 1, 0, 0, -1 } };
  EXPECT_EQ(found, wanted);
}

}
}
}
