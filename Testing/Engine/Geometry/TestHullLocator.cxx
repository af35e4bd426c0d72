// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the locator dismisses is inside: points as far out as it still dismisses them are held to
/// the polyhedron's planes in rationals.
#include "Geometry/HullCones.h"
#include "Geometry/HullLocator.h"
#include "Surface/StarShape.h"
#include "Testing/Engine/Geometry/Solid.h"
#include "Testing/Engine/Inputs/Inputs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gmpxx.h>

namespace flipflop
{
namespace test
{

namespace
{

/// The gauge about a point: below one inside.
class Gauge
{
public:
  Gauge(const Polyhedron& polyhedron, const Point& kernel)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->s[i] = kernel[static_cast<std::size_t>(i)];
    }
    for (const Triangle& t : polyhedron.triangles)
    {
      std::array<std::array<mpq_class, 3>, 3> x;
      for (std::size_t k = 0; k < 3; ++k)
      {
        for (std::size_t i = 0; i < 3; ++i)
        {
          x[k][i] = mpq_class(polyhedron.vertices[t.v[k]].x[i]) - this->s[i];
        }
      }
      Plane plane;
      mpq_class depth = 0;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const std::size_t p = (i + 1) % 3;
        const std::size_t q = (i + 2) % 3;
        plane.slope[i] =
          (x[1][p] - x[0][p]) * (x[2][q] - x[0][q]) - (x[1][q] - x[0][q]) * (x[2][p] - x[0][p]);
        depth += plane.slope[i] * x[0][i];
      }
      for (std::size_t i = 0; i < 3; ++i)
      {
        plane.slope[i] /= depth;
        plane.rounded[i] = plane.slope[i].get_d();
      }
      this->planes.push_back(plane);
    }
  }

  /// Of p - s, exactly where it is above @p least.
  double of(const double* p, double least) const
  {
    double most = 0;
    std::array<mpq_class, 3> x;
    std::array<double, 3> rounded;
    for (std::size_t i = 0; i < 3; ++i)
    {
      x[i] = mpq_class(p[i]) - this->s[i];
      rounded[i] = x[i].get_d();
    }
    for (const Plane& plane : this->planes)
    {
      double value = 0;
      double terms = 0;
      for (std::size_t i = 0; i < 3; ++i)
      {
        value += plane.rounded[i] * rounded[i];
        terms += std::fabs(plane.rounded[i] * rounded[i]);
      }
      if (value + 1e-14 * terms > least)
      {
        const mpq_class exact =
          plane.slope[0] * x[0] + plane.slope[1] * x[1] + plane.slope[2] * x[2];
        value = exact >= 1 ? std::max(1.0, exact.get_d()) : exact.get_d();
      }
      most = std::max(most, value);
    }
    return most;
  }

private:
  struct Plane
  {
    std::array<mpq_class, 3> slope; ///< of the gauge
    std::array<double, 3> rounded;
  };
  mpq_class s[3];
  std::vector<Plane> planes;
};

/// How near the limits came to the border.
struct Seen
{
  int kernels = 0;
  int dismissed = 0;    ///< directions in which something is
  double nearest = 0.0; ///< the greatest gauge of what was dismissed
};

/// In each direction, the farthest point that is dismissed is inside.
/// @param axisOnly along the diagonal alone
void expectInside(
  const Solid& solid, const Point& kernel, Random& random, Seen& seen, bool axisOnly = false)
{
  HullGeometry geometry(solid.range, Arithmetic());
  geometry.setKernel(kernel.data());
  if (findStarFault(geometry, solid.polyhedron).count)
  {
    return; // rounded onto the border
  }
  ++seen.kernels;
  const Polyhedron& p = solid.polyhedron;
  const Options options;
  Monitor monitor(options);
  const HullLocator locator(
    geometry, p.triangles.data(), p.triangleCount(), p.vertices.data(), monitor);
  const Gauge gauge(p, kernel);

  double size[3]; // half the cube's side, whose grid has its corners at multiples of an eighth
  for (int i = 0; i < 3; ++i)
  {
    size[i] = std::ldexp(1.0, std::ilogb(solid.range.high[i] - solid.range.low[i]));
  }
  std::vector<Point> directions;
  if (axisOnly)
  {
    directions = { { size[0], size[1], size[2] }, { -size[0], -size[1], -size[2] } };
  }
  for (int face = 0; face < 6 && !axisOnly; ++face)
  {
    for (int i = 0; i <= 8; ++i)
    {
      for (int j = 0; j <= 8; ++j)
      {
        const auto axis = static_cast<std::size_t>(face / 2);
        Point d;
        d[axis] = face % 2 ? -1.0 : 1.0;
        // On the corners of cells, and a little to their sides.
        const double aside = (i + j) % 2 ? 0.0 : random.uniform(-4e-7, 4e-7);
        d[(axis + 1) % 3] = 0.25 * i - 1 + aside;
        d[(axis + 2) % 3] = 0.25 * j - 1 - aside;
        directions.push_back({ d[0] * size[0], d[1] * size[1], d[2] * size[2] });
      }
    }
  }
  for (std::size_t i = 0; i < p.vertices.size() && !axisOnly; ++i)
  {
    const Vertex& v = p.vertices[i];
    directions.push_back({ v.x[0] - kernel[0], v.x[1] - kernel[1], v.x[2] - kernel[2] });
  }

  HullLocator::Block block;
  const auto at = [&](const Point& d, double t, double* x)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      x[i] = kernel[i] + t * d[i];
    }
  };
  const auto dismissed = [&](const Point& d, double t)
  {
    double x[3];
    at(d, t, x);
    for (int i = 0; i < 3; ++i)
    {
      block.x[i][0] = x[i];
    }
    locator.classify(block, 1);
    return block.inside[0] != 0;
  };
  for (const Point& d : directions)
  {
    double in = 0;
    double out = 2;
    // Down to a limit that may be many powers of two away.
    for (double t = 1; t > 1e-40 && in == 0; t *= 0.5)
    {
      in = dismissed(d, t) ? t : 0;
      out = in == 0 ? t : out;
    }
    for (int step = 0; step < 30 && in > 0; ++step)
    {
      const double t = 0.5 * (in + out);
      (dismissed(d, t) ? in : out) = t;
    }
    if (in > 0)
    {
      double x[3];
      at(d, in, x);
      const double value = gauge.of(x, 0.9);
      ASSERT_LT(value, 1) << "dismissed, but not inside";
      seen.nearest = std::max(seen.nearest, value);
      ++seen.dismissed;
    }
  }
}

/// Kernel points in the middle, and nearer and nearer to a corner, an edge and a facet.
std::vector<Point> kernelsOf(const Solid& solid)
{
  const Polyhedron& p = solid.polyhedron;
  Point middle = { 0, 0, 0 };
  for (const Vertex& v : p.vertices)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      middle[i] += v.x[i] / p.vertexCount();
    }
  }
  std::vector<Point> kernels = { middle };
  const std::uint32_t* v = p.triangles[p.triangleCount() / 2].v;
  for (const double near : { 1e-2, 1e-5, 1e-8, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15 })
  {
    for (std::size_t corners = 1; corners <= 3; ++corners)
    {
      Point kernel;
      for (std::size_t i = 0; i < 3; ++i)
      {
        double border = 0;
        for (std::size_t k = 0; k < corners; ++k)
        {
          border += p.vertices[v[k]].x[i] / static_cast<double>(corners);
        }
        kernel[i] = border + near * (middle[i] - border);
      }
      kernels.push_back(kernel);
    }
  }
  return kernels;
}

TEST(HullLocator, DismissesOnlyWhatIsInside)
{
  constexpr std::uint64_t Seed = 93;
  Random random(Seed);
  Seen all;
  const auto check = [&](const char* name, const Cloud& cloud)
  {
    SCOPED_TRACE(name + (", seed " + std::to_string(Seed)));
    const Solid solid = solidOf(cloud);
    Seen seen;
    for (const Point& kernel : kernelsOf(solid))
    {
      expectInside(solid, kernel, random, seen);
    }
    EXPECT_GT(seen.kernels, 5);
    EXPECT_GT(seen.dismissed, 0);
    all.nearest = std::max(all.nearest, seen.nearest);
  };
  const Cloud ball = fromFamily("shell0", 24, 94).make();
  const Cloud simplex = fromFamily("shell0", 4, 95).make();
  check("tetrahedron", simplex);
  check("ball", ball);
  check("many", fromFamily("shell0", 120, 96).make());
  check("thin", scaled(ball, 1, 1e-7, 1));
  check("thinner", scaled(ball, 1, 1e-14, 1e-5));
  check("far", moved(ball, 1e6, -3e5, 1e7));
  Cloud plate = ball;
  for (std::size_t i = 0; i < ball.size(); ++i)
  {
    const Point& p = ball[i];
    for (std::size_t k = 0; k < 3; ++k)
    {
      plate[i][k] = p[k] - (1 - 1e-6) * (p[0] + p[1] + p[2]) / 3;
    }
  }
  check("plate", plate);
  // Needles along a diagonal: the depths are near what rounding leaves, and walks to a cone err.
  for (const double width : { 1e-3, 1e-5, 1e-6 })
  {
    Cloud needle = ball;
    for (std::size_t i = 0; i < ball.size(); ++i)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        needle[i][k] = ball[i][0] + width * ball[i][k];
      }
    }
    check("needle", needle);
  }
  // The limits are near the border: nothing but what rounding to float takes lies between.
  EXPECT_GT(all.nearest, 1 - 1e-4);
}

TEST(HullLocator, DismissesOnlyWhatIsInsideWhereWalksErr)
{
  // Needles so thin that the cones around their tip are hardly told apart: what counts for the
  // negative coefficients decides.
  constexpr std::uint64_t Seed = 97;
  Random random(Seed);
  Seen seen;
  for (int needle = 0; needle < 400; ++needle)
  {
    const double width = std::pow(10, random.uniform(-6.8, -5));
    Cloud cloud;
    for (int i = 0; i < 8; ++i)
    {
      const double along = i < 4 ? random.uniform(-1, 1) : (i % 2 ? 1 : -1);
      cloud.push_back({ along + width * random.uniform(-1, 1),
        along + width * random.uniform(-1, 1), along + width * random.uniform(-1, 1) });
    }
    const Solid solid = solidOf(cloud);
    for (int i = 0; i < 10; ++i)
    {
      Point kernel = { 0, 0, 0 };
      double total = 0;
      for (const Vertex& v : solid.polyhedron.vertices)
      {
        const double share = std::pow(random.uniform(0, 1), 3);
        total += share;
        for (std::size_t k = 0; k < 3; ++k)
        {
          kernel[k] += share * v.x[k];
        }
      }
      for (double& x : kernel)
      {
        x /= total;
      }
      SCOPED_TRACE("needle " + std::to_string(needle) + ", kernel " + std::to_string(i));
      expectInside(solid, kernel, random, seen, true);
    }
  }
  std::printf(
    "%d kernels, %d directions, nearest %.9f\n", seen.kernels, seen.dismissed, seen.nearest);
}

}
}
}
