// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Star-shaped polyhedra, and surfaces that only look like ones.
#ifndef flipflop_test_Surfaces_h
#define flipflop_test_Surfaces_h

#include "Testing/Engine/Inputs/Inputs.h"
#include <flipflop/Convexify.h>

#include <array>
#include <cstdint>
#include <vector>

namespace flipflop
{
namespace test
{

using Corners = std::array<std::int64_t, 3>;

/// Points and outward triangles.
struct Surface
{
  Cloud points;
  std::vector<Corners> triangles;

  TriangleView view() const
  {
    TriangleView result;
    result.corners = this->triangles.empty() ? nullptr : this->triangles[0].data();
    result.count = static_cast<std::int64_t>(this->triangles.size());
    return result;
  }
};

/// An icosahedron about the origin, its triangles split in four @p levels times, on the sphere.
Surface icosphere(int levels);
/// The same, every vertex at a random distance 1 - depth to 1 from the origin.
Surface perturbedIcosphere(int levels, double depth, std::uint64_t seed);
/// Points, joined as the convex hull joins others, of the same directions.
Surface joinedAs(const Cloud& points, const Cloud& shape);
/// Random directions, joined as their convex hull joins them, at random distances low to 1.
Surface randomStar(int count, double low, std::uint64_t seed);
/// On the sphere, but joined as a rough sphere would be: the way to the hull is by 2-2 flips alone.
Surface scrambledSphere(int count, std::uint64_t seed);
/// A cube about the origin whose faces are grids of @p side squares, each cut in two.
Surface griddedCube(int side);
/// The same points, joined as a rough sphere would be.
Surface scrambledCube(int side, std::uint64_t seed);

/// The stuck configuration: a tetrahedron with base points A, B, C and apex D below, whose top ABC
/// is replaced by the twisted pattern of Edelsbrunner and Shah: a little triangle abc, sunk, and
/// turned so far that every reflex edge has a reflex quadrilateral, seen from the kernel.
Surface stuckTetrahedron();
/// The same on every facet of an icosahedron blown up to integers.
Surface stuckIcosahedron();
/// The tetrahedron, whose little triangle has a pattern of its own, sunk deeper and rounded.
Surface stuckTwice();

/// A ring of triangles from every side, wound @p windings times around the z axis.
Surface wound(int sides, int windings);
/// A torus: closed, oriented, a manifold, star-shaped from nowhere.
Surface torus(int around, int across);

/// Every triangle turned round.
Surface reversed(Surface surface);
/// b beside a, ids shifted.
Surface together(Surface a, const Surface& b);
/// Ids shuffled, triangles shuffled, first corners shuffled; with unused points strewn in.
Surface shuffled(const Surface& surface, int unused, std::uint64_t seed);

}
}

#endif
