// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The kernel points that are found for a surface: the arithmetic that its points were given
/// carries them too.
#include "Geometry/HullGeometry.h"
#include "Surface/StarShape.h"
#include "Testing/Engine/Geometry/Solid.h"
#include "Testing/Engine/References/Exact.h"

namespace flipflop
{
namespace test
{

namespace
{

/// The place of the lowest bit of a double that is not zero.
int lowestBit(double x)
{
  int place = std::ilogb(x) - 52;
  while (std::fmod(x, std::ldexp(1.0, place + 1)) == 0)
  {
    ++place;
  }
  return place;
}

/// Both kernel points are found, are carried, and the signs taken with them are the true ones.
void expectCarried(const Surface& surface)
{
  const Solid solid = solidOf(surface);
  const Arithmetic arithmetic = chooseArithmetic(solid.range);
  ASSERT_FALSE(arithmetic.wide) << "any kernel point is carried";
  ASSERT_EQ(arithmetic.scaleExponent, 0);
  double coarse[3];
  double fine[3];
  ASSERT_TRUE(seekKernel(solid.polyhedron, coarse, fine));
  for (const double* kernel : { coarse, fine })
  {
    for (int i = 0; i < 3; ++i)
    {
      const double half = 0.5 * solid.range.high[i] - 0.5 * solid.range.low[i];
      EXPECT_TRUE(kernel[i] == 0 || lowestBit(kernel[i]) >= std::ilogb(half) - 105)
        << lowestBit(kernel[i]);
    }
    HullGeometry geometry(solid.range, arithmetic);
    geometry.setKernel(kernel);
    EXPECT_EQ(findStarFault(geometry, solid.polyhedron).count, 0);
    Cloud all = surface.points;
    all.push_back({ kernel[0], kernel[1], kernel[2] });
    const FilteredSpace space(all);
    const int count = std::min<int>(static_cast<int>(surface.points.size()), 12);
    const Buffer<Vertex>& v = solid.polyhedron.vertices;
    for (int a = 0; a < count; ++a)
    {
      for (int b = 0; b < a; ++b)
      {
        for (int c = 0; c < b; ++c)
        {
          ASSERT_EQ(geometry.kernelBeneath(v[static_cast<std::size_t>(a)],
                      v[static_cast<std::size_t>(b)], v[static_cast<std::size_t>(c)]),
            -space.orient(a, b, c, static_cast<int>(surface.points.size())));
        }
      }
    }
  }
}

Surface sized(Surface surface, double x, double y, double z)
{
  surface.points = scaled(surface.points, x, y, z);
  return surface;
}

TEST(StarShape, FoundKernelsHaveNoTails)
{
  // The optimum's rounding errors multiply here: unrounded, z is 2^-159 of the extent, with 53
  // bits.
  constexpr double e = 0x1p-52;
  Surface surface;
  surface.points = { { 1, 0, e }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, e }, { 0, e, 1 },
    { e, 0, -1 } };
  surface.triangles = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 },
    { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 } };
  for (double s : { 1.0, 0x1p-190, 0x1p290 })
  {
    SCOPED_TRACE(std::ilogb(s));
    expectCarried(sized(surface, s, s, s));
  }
}

TEST(StarShape, FoundKernelsAreCarriedAtAnyScale)
{
  for (double s : { 0x1p-230, 0x1p-100, 1.0, 0x1p200 })
  {
    SCOPED_TRACE(std::ilogb(s));
    expectCarried(sized(icosphere(0), s, s, s));
    expectCarried(sized(perturbedIcosphere(2, 0.3, 5), s, s, s));
    expectCarried(sized(griddedCube(5), s, s, s));
    expectCarried(sized(stuckIcosahedron(), s, s, s));
  }
  expectCarried(sized(perturbedIcosphere(2, 0.3, 6), 1, 0x1p-200, 0x1p200));
}

}
}
}
