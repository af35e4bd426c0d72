// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DrawSurface.h"
#include "Clouds.h"

#include "Testing/Engine/Conformance/Compare.h"

#include <algorithm>

namespace flipflop
{
namespace fuzz
{

namespace
{

using test::Surface;

/// A surface whose vertices were drawn towards the mean: star-shaped, unless that went too far.
Surface drawStar(Bytes& bytes, int most)
{
  Surface surface;
  surface.points = drawCloud(bytes, most);
  Options options;
  options.threads = 1;
  options.nonFinite = NonFinitePolicy::Ignore;
  const Hull hull = convexHull(test::viewOf(surface.points), options);
  if (hull.dimension != 3)
  {
    return surface;
  }
  Point mean{ 0, 0, 0 };
  for (const std::int64_t id : hull.pointIds)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      mean[k] +=
        surface.points[static_cast<std::size_t>(id)][k] / static_cast<double>(hull.pointIds.size());
    }
  }
  for (std::size_t i = 0; i < hull.connectivity.size(); i += 3)
  {
    test::Corners corners;
    for (std::size_t k = 0; k < 3; ++k)
    {
      corners[k] = hull.pointIds[static_cast<std::size_t>(hull.connectivity[i + k])];
    }
    surface.triangles.push_back(corners);
  }
  test::Random random(bytes.byte());
  const double depth = bytes.below(4) * 0.3;
  for (Point& p : surface.points)
  {
    const double share = 1 - depth * random.uniform();
    for (std::size_t k = 0; k < 3; ++k)
    {
      p[k] = mean[k] + share * (p[k] - mean[k]);
    }
  }
  return surface;
}

/// Triangles as the bytes have it.
Surface drawTriangles(Bytes& bytes, int most)
{
  Surface surface;
  surface.points = drawCloud(bytes, std::min(most, 300));
  const int modulus = std::max(1, std::min(255, static_cast<int>(surface.points.size()) + 1));
  for (int n = bytes.below(64); n > 0; --n)
  {
    surface.triangles.push_back(
      { bytes.below(modulus), bytes.below(modulus), bytes.below(modulus) });
  }
  return surface;
}

void change(Bytes& bytes, Surface& surface)
{
  for (int times = bytes.below(4); times > 0 && !surface.triangles.empty(); --times)
  {
    const std::size_t at = bytes.raw<std::uint16_t>() % surface.triangles.size();
    test::Corners& triangle = surface.triangles[at];
    switch (bytes.below(6))
    {
      case 1:
        std::swap(triangle[0], triangle[1]);
        break;
      case 2:
        surface.triangles.push_back(triangle);
        break;
      case 3:
        surface.triangles.erase(surface.triangles.begin() + static_cast<std::ptrdiff_t>(at));
        break;
      case 4:
        triangle[static_cast<std::size_t>(bytes.below(3))] = bytes.integer();
        break;
      case 5:
        surface = test::reversed(surface);
        break;
      default:
        std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
        break;
    }
  }
}

}

test::Surface drawSurface(Bytes& bytes, int most)
{
  Surface surface = bytes.oneOf(3) ? drawTriangles(bytes, most) : drawStar(bytes, most);
  change(bytes, surface);
  return surface;
}

}
}
