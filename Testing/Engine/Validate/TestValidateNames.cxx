// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What is wrong has its name: points tied, outside by one unit of the last place, or of a higher
/// id; flat edges between polygons, bent polygons; and what winds twice.
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include "Testing/Engine/Validate/ValidateClaims.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{
namespace test
{

namespace
{

using Faults = std::vector<Fault>;

/// Any of these names is right.
void expectName(const Kind& kind, const Faults& names, const Cloud& cloud, int dimension,
  const std::vector<Cell>& cells, FacetMode facets)
{
  const Fault fault = validationOf(cloud, claimOf(kind, cloud, dimension, cells, facets)).fault;
  EXPECT_EQ(std::count(names.begin(), names.end(), fault), 1) << describe(fault);
}

void expectHull(const Faults& names, const Cloud& cloud, int dimension,
  const std::vector<Cell>& cells, FacetMode facets = FacetMode::Polygons)
{
  expectName(convexHulls, names, cloud, dimension, cells, facets);
}

void expectPlane(const Faults& names, const Cloud& cloud, int dimension,
  const std::vector<Cell>& cells, FacetMode facets = FacetMode::Polygons)
{
  expectName(regularTriangulations, names, cloud, dimension, cells, facets);
}

const FacetMode triangles = FacetMode::Triangles;
const Faults none = { Fault::None };

TEST(ValidateNames, WrongId)
{
  const Faults wrong = { Fault::WrongId };
  const Cloud cubes = joined(integerGrid(2), integerGrid(2));
  std::vector<Cell> cells = bruteForceHull(cubes).cells;
  for (Cell& cell : cells)
  {
    std::replace(cell.begin(), cell.end(), std::int64_t(7), std::int64_t(15));
  }
  expectHull(wrong, cubes, 3, cells);
  expectHull(wrong, cubes, 3, triangulate(cells), triangles);
  expectHull(wrong, Cloud(3, Point{ 1, 1, 1 }), 0, { { 1 } });
  expectHull({ Fault::NotExtreme }, Cloud(2, Point{ 1, 1, 1 }), 1, { { 0, 1 } });
  const Cloud squares = joined(squareGrid(2), squareGrid(2));
  expectPlane(wrong, squares, 2, { { 0, 1, 7, 2 } });
  expectPlane(wrong, squares, 2, { { 0, 1, 7 }, { 0, 7, 2 } }, triangles);
  const Cloud line = { { 0, 0, 1 }, { 1, 0, 1 }, { 1, 0, 1 }, { 0, 0, 0 } };
  expectPlane(none, line, 1, { { 0, 1 } });
  expectPlane(wrong, line, 1, { { 0, 2 } });
  expectPlane(wrong, Cloud(3, Point{ 1, 1, 1 }), 0, { { 1 } });
  // A lighter one at the same place.
  const Faults lighter = { Fault::WrongId, Fault::PointOutside, Fault::NotExtreme };
  expectPlane(lighter, line, 1, { { 1, 3 } });
  expectPlane(lighter, { { 5, 5, 0 }, { 5, 5, 1 } }, 0, { { 0 } });
}

TEST(ValidateNames, NotExtremeOfAHull)
{
  // A square's middle as a corner: all edges flat or convex.
  Cloud cloud = integerGrid(2);
  cloud.insert(cloud.begin(), Point{ 0.5, 0.5, 1 });
  std::vector<Cell> cells = bruteForceHull(cloud).cells;
  cells.erase(std::find(cells.begin(), cells.end(), Cell{ 5, 6, 8, 7 }));
  cells = triangulate(cells);
  cells.insert(cells.end(), { { 0, 5, 6 }, { 0, 6, 8 }, { 0, 8, 7 }, { 0, 7, 5 } });
  expectHull({ Fault::NotExtreme }, cloud, 3, cells, triangles);
  const Cloud flat = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 1, 1, 0 } };
  expectHull({ Fault::NotExtreme }, flat, 2, { { 0, 1, 3, 2 } });
}

/// The cells with vertex 0, in the middle of the edge from a to b, as a corner of both facets; all
/// other ids are one more than before.
std::vector<Cell> withMiddle(std::vector<Cell> cells, std::int64_t a, std::int64_t b)
{
  for (Cell& cell : cells)
  {
    for (std::size_t k = 0; k < cell.size(); ++k)
    {
      const std::int64_t from = cell[k];
      const std::int64_t to = cell[(k + 1) % cell.size()];
      if ((from == a && to == b) || (from == b && to == a))
      {
        cell.insert(cell.begin() + static_cast<std::ptrdiff_t>(k) + 1, -1);
        break;
      }
    }
    std::for_each(cell.begin(), cell.end(), [](std::int64_t& id) { ++id; });
  }
  canonicalise(cells);
  return cells;
}

TEST(ValidateNames, NotExtremeInTwoPlanesAlone)
{
  // The middle of each edge in turn, as the lowest corner of both its facets: their fans start
  // there, every edge is convex, and nothing else is wrong with it.
  const Cloud cube = scaled(integerGrid(2), 2, 2, 2);
  const Cloud octahedron = { { 2, 0, 0 }, { -2, 0, 0 }, { 0, 4, 0 }, { 0, -2, 0 }, { 0, 0, 6 },
    { 0, 0, -2 } };
  for (const Cloud& solid : { cube, scaled(cube, 1, 0x1p-300, 0x1p200),
         moved(cube, 0x1p50, -0x1p50, 0x1p40), scaled(latticeTetrahedron(3), 2, 2, 2), octahedron })
  {
    const ReferenceHull plain = bruteForceHull(solid);
    for (const Cell& facet : plain.cells)
    {
      for (std::size_t i = 0; i < facet.size(); ++i)
      {
        const std::int64_t a = facet[i];
        const std::int64_t b = facet[(i + 1) % facet.size()];
        const Point& p = solid[static_cast<std::size_t>(a)];
        const Point& q = solid[static_cast<std::size_t>(b)];
        Cloud cloud = solid;
        cloud.insert(cloud.begin(),
          Point{ 0.5 * p[0] + 0.5 * q[0], 0.5 * p[1] + 0.5 * q[1], 0.5 * p[2] + 0.5 * q[2] });
        for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
        {
          ReferenceHull split = plain;
          split.cells = withMiddle(plain.cells, a, b);
          split.ids = idsIn(split.cells);
          const Validation valid =
            validationOf(cloud, makeResult(convexHulls, split, cloud.size(), facets));
          EXPECT_EQ(valid.fault, Fault::NotExtreme);
          EXPECT_EQ(valid.index, 0);
        }
      }
    }
  }
}

TEST(ValidateNames, NotExtremeInThePlane)
{
  const Faults tied = { Fault::NotExtreme, Fault::NotConvex, Fault::NotClosed, Fault::Structure };
  // In a facet, in an edge, on the border; a sliver without area.
  const Cloud square = joined(squareGrid(2), { { 0.5, 0.5, -0.5 } });
  const std::vector<Cell> starred = { { 0, 1, 4 }, { 0, 4, 2 }, { 1, 3, 4 }, { 2, 4, 3 } };
  expectPlane(tied, square, 2, starred, triangles);
  expectPlane(tied, square, 2, starred);
  const Cloud kite = { { 0, 0, 0 }, { 4, 0, 0 }, { 2, 3, -9 }, { 2, -3, -9 }, { 2, 0, -4 } };
  expectPlane(none, kite, 2, { { 0, 1, 2 }, { 0, 3, 1 } });
  expectPlane(tied, kite, 2, { { 0, 4, 1, 2 }, { 0, 3, 1, 4 } });
  expectPlane(tied, kite, 2, { { 0, 4, 2 }, { 1, 2, 4 }, { 0, 3, 4 }, { 1, 4, 3 } }, triangles);
  const Cloud border = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 2, 0, -4 } };
  expectPlane(tied, border, 2, { { 0, 3, 1, 2 } });
  expectPlane(tied, border, 2, { { 0, 1, 2 }, { 0, 3, 1 } }, triangles);
}

TEST(ValidateNames, PointOutsideByTheLeast)
{
  const Faults outside = { Fault::PointOutside };
  Cloud cube = joined(integerGrid(3), { { 1, 1, 2 } });
  const std::vector<Cell> cells = bruteForceHull(integerGrid(3)).cells;
  expectHull(none, cube, 3, cells);
  cube.back()[2] = 2 + 0x1p-51;
  expectHull(outside, cube, 3, cells);
  Cloud flat = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 1, 1, 0 } };
  expectHull(none, flat, 2, { { 0, 1, 2 } });
  flat[3][1] = 1 + 0x1p-52;
  expectHull(outside, flat, 2, { { 0, 1, 2 } });
  expectHull(outside, { { 0, 0, 0 }, { 2, 2, 2 }, { 3, 3, 3 } }, 1, { { 0, 1 } });

  const std::vector<Cell> square = { { 0, 1, 3, 2 } };
  // In the middle, on the border and at a corner: tied, and heavier by the least.
  for (const Point& p : { Point{ 0.5, 0.5, -0.5 }, Point{ 0.5, 0, -0.25 }, Point{ 1, 1, 0 } })
  {
    expectPlane(none, joined(squareGrid(2), { p }), 2, square);
    expectPlane(
      outside, joined(squareGrid(2), { { p[0], p[1], std::nextafter(p[2], 1.0) } }), 2, square);
  }
  // Outside in the plane.
  for (const Point& p : { Point{ 2, 0, -100 }, Point{ 1 + 0x1p-52, 0.5, -1e300 },
         Point{ 0.5, -0x1p-1074, 0 }, Point{ -1e300, 1e300, -1e300 } })
  {
    expectPlane(outside, joined(squareGrid(2), { p }), 2, square);
  }
}

TEST(ValidateNames, NotConvexWherePolygonsAreFlatOrBent)
{
  const Faults notConvex = { Fault::NotConvex };
  // A cube with one square cut in two among squares; and one that bends by very little.
  const std::vector<Cell> squares = bruteForceHull(integerGrid(2)).cells;
  for (std::size_t i = 0; i < 6; ++i)
  {
    std::vector<Cell> cut = squares;
    const Cell square = cut[i];
    cut[i] = { square[0], square[1], square[2] };
    cut.push_back({ square[0], square[2], square[3] });
    expectHull(notConvex, integerGrid(2), 3, cut);
  }
  Cloud cube = integerGrid(2);
  cube[7] = { 1, 1, 1 + 0x1p-52 };
  expectHull(notConvex, cube, 3, squares);
  const Cloud square = squareGrid(2);
  expectPlane(notConvex, square, 2, { { 0, 1, 2 }, { 1, 3, 2 } });
  expectPlane(notConvex, square, 2, { { 0, 1, 3 }, { 0, 3, 2 } });
  for (const double weight : { 0x1p-1000, -0x1p-1000 })
  {
    Cloud bent = square;
    bent[3][2] = weight;
    expectPlane(notConvex, bent, 2, { { 0, 1, 3, 2 } });
    expectPlane(weight > 0 ? none : notConvex, bent, 2, { { 0, 1, 3 }, { 0, 3, 2 } }, triangles);
    expectPlane(weight > 0 ? notConvex : none, bent, 2, { { 0, 1, 2 }, { 1, 3, 2 } }, triangles);
  }
}

TEST(ValidateNames, NotConvexWhereAPolygonCrossesItself)
{
  const Cloud circle = cocircularIntegers(25);
  const Cell polygon = bruteForceTriangulation(circle).cells.at(0);
  ASSERT_EQ(polygon.size(), 12u);
  Cell crossed = polygon;
  std::swap(crossed[4], crossed[5]);
  // Round by round of five corners: all left turns, but five rounds.
  Cell star;
  for (std::size_t i = 0; i < 12; ++i)
  {
    star.push_back(polygon[5 * i % 12]);
  }
  for (const Cell& wrong : { crossed, star, Cell(polygon.rbegin(), polygon.rend()) })
  {
    expectPlane({ Fault::NotConvex }, circle, 2, { wrong });
  }
  // A circle's other triangulations.
  for (std::size_t apex = 1; apex < polygon.size(); ++apex)
  {
    std::vector<Cell> fan;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    {
      fan.push_back({ polygon[apex], polygon[(apex + i) % 12], polygon[(apex + i + 1) % 12] });
    }
    expectPlane({ Fault::Structure }, circle, 2, fan, triangles);
  }
}

TEST(ValidateNames, WrongDimension)
{
  const Faults wrong = { Fault::WrongDimension };
  const Faults low = { Fault::WrongDimension, Fault::PointOutside };
  const Cloud one = { { 0, 0, 0 } };
  const Cloud segment = { { 0, 0, 0 }, { 1, 0, 0 } };
  const Cloud square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  for (const Cloud& cloud : { one, segment, square, integerGrid(2) })
  {
    expectHull(wrong, cloud, -1, {});
  }
  for (const Cloud& cloud : { one, segment, squareGrid(2) })
  {
    expectPlane(wrong, cloud, -1, {});
  }
  expectHull(low, segment, 0, { { 0 } });
  expectHull(low, square, 1, { { 0, 1 } });
  expectHull(low, integerGrid(2), 2, { { 0, 1, 3, 2 } });
  expectPlane(low, segment, 0, { { 0 } });
  expectPlane(low, squareGrid(2), 1, { { 0, 1 } });
  // A flat solid: a triangle and its back.
  expectHull({ Fault::WrongDimension, Fault::NotConvex }, Cloud(square.begin(), square.end() - 1),
    3, { { 0, 1, 2 }, { 0, 2, 1 } });
}

TEST(ValidateNames, NoneWindsTwice)
{
  const Faults any = { Fault::NotConvex, Fault::NotClosed, Fault::WrongId, Fault::PointOutside,
    Fault::NotExtreme, Fault::Structure };
  // Closed, oriented and convex at every edge; around the centre of a fan, and as a bipyramid. The
  // second round is a little further out, or at the same positions.
  for (const double further : { 0x1p-30, 0.0 })
  {
    Cloud solid = { { 0, 0, 1 }, { 0, 0, -1 } };
    Cloud plane = { { 0, 0, 10 } };
    std::vector<Cell> facets;
    std::vector<Cell> fan;
    for (int i = 0; i < 10; ++i)
    {
      const double angle = 6.283185307179586 * (i % 5) / 5;
      const double r = i < 5 ? 1 : 1 + further;
      solid.push_back({ r * std::cos(angle), r * std::sin(angle), 0 });
      plane.push_back({ r * std::cos(angle), r * std::sin(angle), 0 });
      facets.push_back({ 0, 2 + i, 2 + (i + 1) % 10 });
      facets.push_back({ 1, 2 + (i + 1) % 10, 2 + i });
      fan.push_back({ 0, 1 + i, 1 + (i + 1) % 10 });
    }
    expectHull(any, solid, 3, facets, triangles);
    expectPlane(any, plane, 2, fan, triangles);
    expectPlane(any, plane, 2, fan);
  }
  // Two pieces, each whole for itself: apart, one over the other, touching in a corner.
  const Cloud corner = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 } };
  expectPlane(any, joined(corner, { { 5, 5, 0 }, { 6, 5, 0 }, { 5, 6, 0 } }), 2,
    { { 0, 1, 2 }, { 3, 4, 5 } }, triangles);
  expectPlane(any, joined(corner, { { 1, 1, 0 }, { 2, 1, 0 }, { 1, 2, 0 } }), 2,
    { { 0, 1, 2 }, { 3, 4, 5 } }, triangles);
  expectPlane(any, joined(corner, { { -1, 0, 0 }, { 0, -1, 0 } }), 2, { { 0, 1, 2 }, { 0, 3, 4 } },
    triangles);
}

TEST(ValidateNames, Lines)
{
  const Cloud cloud = { { 2, 2, 0 }, { 0, 0, 0 }, { 1, 1, 0 }, { 4, 4, 0 }, { 3, 3, -2 } };
  const std::vector<Cell> chain = { { 0, 2 }, { 0, 3 }, { 1, 2 } };
  expectPlane(none, cloud, 1, chain);
  // The tied one as a corner, a visible one hidden, an end too few.
  expectPlane({ Fault::NotExtreme }, cloud, 1, { { 0, 2 }, { 0, 4 }, { 3, 4 }, { 1, 2 } });
  expectPlane({ Fault::PointOutside }, cloud, 1, { { 0, 1 }, { 0, 3 } });
  expectPlane({ Fault::PointOutside }, cloud, 1, { { 0, 2 }, { 1, 2 } });
  const Cloud line = { { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 } };
  expectHull(none, line, 1, { { 0, 2 } });
  // Not on the line at all, if by the least.
  Cloud off = cloud;
  off[4] = { 3, 3 + 0x1p-51, -1e9 };
  expectPlane({ Fault::WrongDimension, Fault::PointOutside }, off, 1, chain);
}

}
}
}
