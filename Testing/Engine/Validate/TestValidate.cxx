// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The oracle is put to the test: right hulls pass, and each way to break one is found and named.
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/Inputs.h"

#include <functional>
#include <limits>
#include <numeric>

namespace flipflop
{
namespace test
{

namespace
{

/// A Hull from plain values: triangles by cellSize, polygons (also if all have three corners) by
/// offsets.
Hull makeHull(int dimension, const Cell& ids, const std::vector<Cell>& cells,
  FacetMode facets = FacetMode::Polygons)
{
  Hull hull;
  hull.dimension = dimension;
  hull.pointIds.allocate(ids.size());
  std::copy(ids.begin(), ids.end(), hull.pointIds.begin());
  std::vector<std::int64_t> corners;
  std::vector<std::int64_t> starts = { 0 };
  for (const Cell& cell : cells)
  {
    for (std::int64_t id : cell)
    {
      corners.push_back(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
    }
    starts.push_back(static_cast<std::int64_t>(corners.size()));
  }
  hull.connectivity.allocate(corners.size());
  std::copy(corners.begin(), corners.end(), hull.connectivity.begin());
  if (facets == FacetMode::Triangles && dimension >= 2)
  {
    hull.cellSize = 3;
    return hull;
  }
  hull.offsets.allocate(starts.size());
  std::copy(starts.begin(), starts.end(), hull.offsets.begin());
  return hull;
}

Hull makeHull(const ReferenceHull& reference, FacetMode facets)
{
  return makeHull(reference.dimension, reference.ids,
    facets == FacetMode::Polygons ? reference.cells : triangulate(reference.cells), facets);
}

/// The reference's cells as they are, taken for triangles.
Hull makeTriangles(const ReferenceHull& reference)
{
  return makeHull(reference.dimension, reference.ids, reference.cells, FacetMode::Triangles);
}

Fault faultOf(const Cloud& cloud, const Hull& hull)
{
  const Validation one = validate(viewOf(cloud), hull, 1);
  const Validation two = validate(viewOf(cloud), hull, 2);
  EXPECT_EQ(one.fault, two.fault);
  EXPECT_EQ(one.index, two.index);
  EXPECT_STRNE(describe(one.fault), "");
  return one.fault;
}

/// Break a copy of the hull.
Hull broken(const Hull& hull, const std::function<void(Hull&)>& change)
{
  Hull copy = clone(hull);
  change(copy);
  return copy;
}

TEST(Validate, TakesHullsMadeByHand)
{
  for (const Input& input : smallSpecialInputs())
  {
    SCOPED_TRACE(input.name);
    const Cloud cloud = input.make();
    const ReferenceHull reference = bruteForceHull(cloud);
    EXPECT_EQ(faultOf(cloud, makeHull(reference, FacetMode::Triangles)), Fault::None);
    EXPECT_EQ(faultOf(cloud, makeHull(reference, FacetMode::Polygons)), Fault::None);
  }
  for (const char* name : { "ball", "shell0", "boxFaces", "far15", "planeXyz0", "collinearAlmost" })
  {
    for (int count : { 0, 1, 2, 3, 10, 5000 })
    {
      SCOPED_TRACE(std::string(name) + "_" + std::to_string(count));
      const Cloud cloud = fromFamily(name, count, 3).make();
      const ReferenceHull reference = cgalHull(cloud);
      EXPECT_EQ(faultOf(cloud, makeHull(reference, FacetMode::Triangles)), Fault::None);
      EXPECT_EQ(faultOf(cloud, makeHull(reference, FacetMode::Polygons)), Fault::None);
    }
  }
}

TEST(Validate, LeavesOutNonFinitePoints)
{
  Cloud cloud = integerGrid(3);
  cloud.push_back({ std::numeric_limits<double>::infinity(), 0, 0 });
  cloud.push_back({ 0, std::numeric_limits<double>::quiet_NaN(), 9 });
  const ReferenceHull reference = bruteForceHull(integerGrid(3));
  EXPECT_EQ(faultOf(cloud, makeHull(reference, FacetMode::Polygons)), Fault::None);
}

TEST(Validate, Structure)
{
  const Cloud cloud = fromFamily("ball", 200, 5).make();
  const Hull hull = convexHull(viewOf(cloud));
  ASSERT_EQ(faultOf(cloud, hull), Fault::None);
  const std::int64_t points = static_cast<std::int64_t>(hull.pointIds.size());
  const std::int64_t input = static_cast<std::int64_t>(cloud.size());
  const auto expectStructure = [&](const char* what, const std::function<void(Hull&)>& change)
  { EXPECT_EQ(faultOf(cloud, broken(hull, change)), Fault::Structure) << what; };
  for (std::int64_t bad :
    { std::int64_t(-1), points, std::int64_t(1) << 40, std::numeric_limits<std::int64_t>::min() })
  {
    expectStructure("a corner out of range", [=](Hull& h) { h.connectivity[4] = bad; });
  }
  for (std::int64_t bad : { std::int64_t(-1), input, std::int64_t(1) << 40 })
  {
    expectStructure("an id out of range", [=](Hull& h) { h.pointIds[points - 1] = bad; });
  }
  expectStructure("ids out of order", [](Hull& h) { std::swap(h.pointIds[1], h.pointIds[2]); });
  expectStructure("an id twice", [](Hull& h) { h.pointIds[3] = h.pointIds[2]; });
  expectStructure("a cell turned",
    [](Hull& h) { std::rotate(&h.connectivity[6], &h.connectivity[7], &h.connectivity[9]); });
  expectStructure("two cells exchanged",
    [](Hull& h) { std::swap_ranges(&h.connectivity[3], &h.connectivity[6], &h.connectivity[6]); });
  expectStructure(
    "connectivity cut short", [](Hull& h) { h.connectivity.truncate(h.connectivity.size() - 1); });
}

TEST(Validate, StructureOfOffsets)
{
  const Cloud cloud = integerGrid(3);
  const Hull hull = makeHull(bruteForceHull(cloud), FacetMode::Polygons);
  ASSERT_EQ(faultOf(cloud, hull), Fault::None);
  const auto expectStructure = [&](const char* what, const std::function<void(Hull&)>& change)
  { EXPECT_EQ(faultOf(cloud, broken(hull, change)), Fault::Structure) << what; };
  expectStructure("offsets do not begin at 0", [](Hull& h) { h.offsets[0] = 1; });
  expectStructure("offsets fall", [](Hull& h) { h.offsets[2] = 20; });
  expectStructure("offsets below 0", [](Hull& h) { h.offsets[1] = -4; });
  expectStructure("offsets go too far", [](Hull& h) { h.offsets[6] = 28; });
  expectStructure("offsets stop early", [](Hull& h) { h.offsets[6] = 23; });
  expectStructure("a cell of no corner", [](Hull& h) { h.offsets[1] = 0; });
  expectStructure("a cell of two corners", [](Hull& h) { h.offsets[1] = 2; });
  expectStructure("a negative cell size", [](Hull& h) { h.cellSize = -3; });
}

TEST(Validate, NotClosed)
{
  const Cloud cloud = fromFamily("shell0", 60, 6).make();
  const ReferenceHull reference = bruteForceHull(cloud);
  for (std::size_t missing : { std::size_t(0), std::size_t(50), reference.cells.size() - 1 })
  {
    ReferenceHull open = reference;
    open.cells.erase(open.cells.begin() + static_cast<std::ptrdiff_t>(missing));
    EXPECT_EQ(faultOf(cloud, makeHull(open, FacetMode::Polygons)), Fault::NotClosed) << missing;
  }
  // A facet turned over uses its edges the wrong way: three are there twice.
  ReferenceHull turned = reference;
  std::swap(turned.cells[7][1], turned.cells[7][2]);
  canonicalise(turned.cells);
  EXPECT_EQ(faultOf(cloud, makeHull(turned, FacetMode::Polygons)), Fault::NotClosed);
  ReferenceHull empty = reference;
  empty.cells.clear();
  EXPECT_NE(faultOf(cloud, makeHull(empty, FacetMode::Polygons)), Fault::None);
}

TEST(Validate, ACellTwice)
{
  const Cloud cloud = fromFamily("shell0", 30, 6).make();
  ReferenceHull twice = bruteForceHull(cloud);
  twice.cells.insert(twice.cells.begin() + 5, twice.cells[5]);
  const Fault fault = faultOf(cloud, makeHull(twice, FacetMode::Polygons));
  EXPECT_TRUE(fault == Fault::Structure || fault == Fault::NotClosed) << describe(fault);
}

TEST(Validate, NotConvexInsideOut)
{
  const Cloud cloud = fromFamily("shell0", 60, 7).make();
  ReferenceHull inside = bruteForceHull(cloud);
  for (Cell& cell : inside.cells)
  {
    std::reverse(cell.begin(), cell.end());
  }
  canonicalise(inside.cells);
  EXPECT_EQ(faultOf(cloud, makeHull(inside, FacetMode::Polygons)), Fault::NotConvex);
}

TEST(Validate, NotConvexAtATurnedEdge)
{
  // Turn each edge of a simplicial hull in turn: a reflex edge where all was convex.
  const Cloud cloud = fromFamily("shell0", 24, 8).make();
  const ReferenceHull reference = bruteForceHull(cloud);
  int turned = 0;
  for (std::size_t i = 0; i < reference.cells.size(); ++i)
  {
    for (std::size_t j = i + 1; j < reference.cells.size(); ++j)
    {
      for (int e = 0; e < 3; ++e)
      {
        const Cell& t = reference.cells[i];
        const std::int64_t a = t[e];
        const std::int64_t b = t[(e + 1) % 3];
        const std::int64_t c = t[(e + 2) % 3];
        const Cell& u = reference.cells[j];
        for (int f = 0; f < 3; ++f)
        {
          const std::int64_t d = u[(f + 2) % 3];
          bool joins = u[f] == b && u[(f + 1) % 3] == a;
          for (const Cell& other : reference.cells)
          {
            // c and d may be neighbours already: then the edge would be there twice.
            joins = joins &&
              (std::count(other.begin(), other.end(), c) == 0 ||
                std::count(other.begin(), other.end(), d) == 0);
          }
          if (joins)
          {
            ReferenceHull dented = reference;
            dented.cells[i] = { c, a, d };
            dented.cells[j] = { d, b, c };
            canonicalise(dented.cells);
            EXPECT_EQ(faultOf(cloud, makeHull(dented, FacetMode::Polygons)), Fault::NotConvex);
            ++turned;
          }
        }
      }
    }
  }
  EXPECT_GT(turned, 20);
}

TEST(Validate, NotConvexWherePolygonsAreFlat)
{
  // A cube with one square cut in two among squares: a flat edge where polygons meet.
  const Cloud cloud = integerGrid(2);
  const ReferenceHull reference = bruteForceHull(cloud);
  for (std::size_t i = 0; i < 6; ++i)
  {
    ReferenceHull cut = reference;
    const Cell square = cut.cells[i];
    cut.cells[i] = { square[0], square[1], square[2] };
    cut.cells.push_back({ square[0], square[2], square[3] });
    canonicalise(cut.cells);
    EXPECT_EQ(faultOf(cloud, makeHull(cut, FacetMode::Polygons)), Fault::NotConvex) << i;
  }
}

TEST(Validate, NotConvexWhereAPolygonIsNotPlanar)
{
  // Two facets joined into one polygon that bends by very little.
  Cloud cloud = integerGrid(2);
  cloud[7] = { 1, 1, 1 + 0x1p-52 };
  const ReferenceHull reference = bruteForceHull(cloud);
  ASSERT_GT(reference.cells.size(), 6u);
  ReferenceHull joined = bruteForceHull(integerGrid(2));
  EXPECT_EQ(faultOf(cloud, makeHull(joined, FacetMode::Polygons)), Fault::NotConvex);
}

TEST(Validate, TrianglesMustBeTheCanonicalFan)
{
  // The other diagonal of a square is as convex, but it is not the canonical form.
  const Cloud cloud = integerGrid(2);
  const ReferenceHull reference = bruteForceHull(cloud);
  ReferenceHull other = reference;
  other.cells = triangulate(reference.cells);
  const Cell square = reference.cells[0];
  other.cells.erase(
    std::find(other.cells.begin(), other.cells.end(), Cell{ square[0], square[1], square[2] }));
  other.cells.erase(
    std::find(other.cells.begin(), other.cells.end(), Cell{ square[0], square[2], square[3] }));
  other.cells.push_back({ square[0], square[1], square[3] });
  other.cells.push_back({ square[1], square[2], square[3] });
  canonicalise(other.cells);
  EXPECT_NE(faultOf(cloud, makeTriangles(other)), Fault::None);
}

TEST(Validate, NotExtreme)
{
  // A square's middle as a corner: all edges flat or convex, but the point is not extreme.
  Cloud cloud = integerGrid(2);
  cloud.insert(cloud.begin(), Point{ 0.5, 0.5, 1 });
  ReferenceHull reference = bruteForceHull(cloud);
  ReferenceHull starred = reference;
  const auto top = std::find(starred.cells.begin(), starred.cells.end(), Cell{ 5, 6, 8, 7 });
  ASSERT_NE(top, starred.cells.end());
  starred.cells.erase(top);
  starred.cells = triangulate(starred.cells);
  for (const Cell& t : { Cell{ 0, 5, 6 }, { 0, 6, 8 }, { 0, 8, 7 }, { 0, 7, 5 } })
  {
    starred.cells.push_back(t);
  }
  starred.ids.insert(starred.ids.begin(), 0);
  canonicalise(starred.cells);
  EXPECT_EQ(faultOf(cloud, makeTriangles(starred)), Fault::NotExtreme);
}

TEST(Validate, NotExtremeInAnEdge)
{
  // An edge's middle as a corner of both its polygons.
  Cloud cloud = integerGrid(2);
  cloud.push_back({ 0.5, 0, 0 });
  ReferenceHull reference = bruteForceHull(cloud);
  for (Cell& cell : reference.cells)
  {
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      const std::int64_t a = cell[i];
      const std::int64_t b = cell[(i + 1) % cell.size()];
      if (a + b == 1)
      {
        cell.insert(cell.begin() + static_cast<std::ptrdiff_t>(i) + 1, 8);
        break;
      }
    }
  }
  reference.ids.push_back(8);
  canonicalise(reference.cells);
  const Fault solid = faultOf(cloud, makeHull(reference, FacetMode::Polygons));
  EXPECT_TRUE(solid == Fault::NotExtreme || solid == Fault::NotClosed) << describe(solid);
  // The same in a plane and on a line.
  const Cloud flat = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 1, 1, 0 } };
  EXPECT_EQ(faultOf(flat, makeHull(2, { 0, 1, 2, 3 }, { { 0, 1, 3, 2 } })), Fault::NotExtreme);
  const Cloud line = { { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 } };
  EXPECT_EQ(faultOf(line, makeHull(1, { 0, 2 }, { { 0, 2 } })), Fault::None);
  EXPECT_NE(faultOf(line, makeHull(1, { 0, 1, 2 }, { { 0, 1 }, { 1, 2 } })), Fault::None);
}

TEST(Validate, NotExtremeInTwoPlanesAlone)
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
    int edges = 0;
    for (const Cell& facet : plain.cells)
    {
      for (std::size_t i = 0; i < facet.size(); ++i)
      {
        const std::int64_t a = facet[i];
        const std::int64_t b = facet[(i + 1) % facet.size()];
        const Point& p = solid[static_cast<std::size_t>(a)];
        const Point& q = solid[static_cast<std::size_t>(b)];
        const Point middle = { 0.5 * p[0] + 0.5 * q[0], 0.5 * p[1] + 0.5 * q[1],
          0.5 * p[2] + 0.5 * q[2] };
        if (a > b)
        {
          continue;
        }
        Cloud cloud = solid;
        cloud.insert(cloud.begin(), middle);
        ReferenceHull split = plain;
        for (Cell& cell : split.cells)
        {
          for (std::int64_t& id : cell)
          {
            ++id;
          }
          for (std::size_t k = 0; k < cell.size(); ++k)
          {
            const std::int64_t from = cell[k] - 1;
            const std::int64_t to = cell[(k + 1) % cell.size()] - 1;
            if ((from == a && to == b) || (from == b && to == a))
            {
              cell.insert(cell.begin() + static_cast<std::ptrdiff_t>(k) + 1, 0);
              break;
            }
          }
        }
        for (std::int64_t& id : split.ids)
        {
          ++id;
        }
        split.ids.insert(split.ids.begin(), 0);
        canonicalise(split.cells);
        for (FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
        {
          const Validation valid = validate(viewOf(cloud), makeHull(split, facets));
          EXPECT_EQ(valid.fault, Fault::NotExtreme) << describe(valid.fault);
          EXPECT_EQ(valid.index, 0);
          EXPECT_EQ(faultOf(cloud, makeHull(bruteForceHull(cloud), facets)), Fault::None);
        }
        ++edges;
      }
    }
    EXPECT_GE(edges, 6);
  }
}

TEST(Validate, PointOutside)
{
  // The hull without one of its points leaves that point outside.
  for (const char* name : { "shell0", "ball", "far15", "thin200" })
  {
    const Cloud cloud = fromFamily(name, 500, 9).make();
    const ReferenceHull whole = cgalHull(cloud, CgalKernel::Rational);
    for (std::size_t k : { std::size_t(0), whole.ids.size() / 2, whole.ids.size() - 1 })
    {
      const std::int64_t gone = whole.ids[k];
      // In its place another point's position: it has no say of its own then.
      Cloud less = cloud;
      less[gone] = cloud[whole.ids[k == 0 ? 1 : 0]];
      const ReferenceHull part = cgalHull(less, CgalKernel::Rational);
      if (std::count(part.ids.begin(), part.ids.end(), gone) > 0)
      {
        continue;
      }
      for (FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
      {
        const Validation valid = validate(viewOf(cloud), makeHull(part, facets), 2);
        EXPECT_EQ(valid.fault, Fault::PointOutside) << name;
        EXPECT_EQ(valid.index, gone) << name;
      }
    }
  }
}

TEST(Validate, PointOutsideByOneUlp)
{
  Cloud cloud = integerGrid(3);
  const ReferenceHull reference = bruteForceHull(cloud);
  cloud.push_back({ 1, 1, 2 });
  EXPECT_EQ(faultOf(cloud, makeHull(reference, FacetMode::Polygons)), Fault::None);
  cloud.back()[2] = 2 + 0x1p-51;
  EXPECT_EQ(faultOf(cloud, makeHull(reference, FacetMode::Polygons)), Fault::PointOutside);
  const Validation valid = validate(viewOf(cloud), makeHull(reference, FacetMode::Polygons));
  EXPECT_EQ(valid.index, 27);
}

TEST(Validate, PointOutsideAPolygonAndASegment)
{
  Cloud flat = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 1, 1, 0 } };
  const Hull triangle = makeHull(2, { 0, 1, 2 }, { { 0, 1, 2 } });
  EXPECT_EQ(faultOf(flat, triangle), Fault::None);
  flat[3][1] = 1 + 0x1p-52;
  EXPECT_EQ(faultOf(flat, triangle), Fault::PointOutside);
  Cloud line = { { 0, 0, 0 }, { 2, 2, 2 }, { 1, 1, 1 } };
  const Hull segment = makeHull(1, { 0, 1 }, { { 0, 1 } });
  EXPECT_EQ(faultOf(line, segment), Fault::None);
  line[2] = { 3, 3, 3 };
  EXPECT_EQ(faultOf(line, segment), Fault::PointOutside);
}

TEST(Validate, WrongId)
{
  // Each corner is there twice; the later one must not stand for it.
  const Cloud cloud = joined(integerGrid(2), integerGrid(2));
  const ReferenceHull reference = bruteForceHull(cloud);
  for (FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    ReferenceHull late = reference;
    late.ids.back() = 15;
    for (Cell& cell : late.cells)
    {
      std::replace(cell.begin(), cell.end(), std::int64_t(7), std::int64_t(15));
    }
    EXPECT_EQ(faultOf(cloud, makeHull(late, facets)), Fault::WrongId);
  }
  EXPECT_EQ(faultOf(Cloud(3, Point{ 1, 1, 1 }), makeHull(0, { 1 }, { { 1 } })), Fault::WrongId);
}

TEST(Validate, WrongDimension)
{
  const Cloud cube = integerGrid(2);
  const Cloud square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  const Cloud segment = { { 0, 0, 0 }, { 1, 0, 0 } };
  const Cloud one = { { 0, 0, 0 } };
  const Hull none = makeHull(-1, {}, {});
  const Hull vertex = makeHull(0, { 0 }, { { 0 } });
  const Hull line = makeHull(1, { 0, 1 }, { { 0, 1 } });
  const Hull polygon = makeHull(2, { 0, 1, 2, 3 }, { { 0, 1, 2, 3 } });
  EXPECT_EQ(faultOf({}, Hull()), Fault::None);
  EXPECT_EQ(faultOf(one, vertex), Fault::None);
  EXPECT_EQ(faultOf(segment, line), Fault::None);
  EXPECT_EQ(faultOf(square, polygon), Fault::None);
  for (const Cloud& cloud : { one, segment, square, cube })
  {
    EXPECT_EQ(faultOf(cloud, Hull()), Fault::WrongDimension);
  }
  // Too low a dimension leaves points outside: either name is right.
  const Fault tooLow[] = { faultOf(segment, vertex), faultOf(square, line),
    faultOf(cube, makeHull(2, { 0, 1, 2, 3 }, { { 0, 1, 3, 2 } })) };
  for (Fault fault : tooLow)
  {
    EXPECT_TRUE(fault == Fault::WrongDimension || fault == Fault::PointOutside) << describe(fault);
  }
  // A flat solid: a triangle and its back.
  const Cloud three = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 } };
  const Fault flat = faultOf(three, makeHull(3, { 0, 1, 2 }, { { 0, 1, 2 }, { 0, 2, 1 } }));
  EXPECT_TRUE(flat == Fault::WrongDimension || flat == Fault::NotConvex) << describe(flat);
  EXPECT_NE(faultOf({}, vertex), Fault::None);
}

TEST(Validate, PolygonTheWrongWayRound)
{
  const Cloud square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  EXPECT_NE(faultOf(square, makeHull(2, { 0, 1, 2, 3 }, { { 0, 3, 2, 1 } })), Fault::None);
  EXPECT_NE(faultOf(square, makeHull(2, { 0, 1, 2, 3 }, { { 0, 2, 1, 3 } })), Fault::None);
}

TEST(Validate, HullsOfOtherClouds)
{
  // Any two different clouds of one size: the hull of one is not the hull of the other.
  for (const Family& family : families())
  {
    Cloud a = fromFamily(family.name, 300, 1).make();
    Cloud b = a;
    const ReferenceHull hull = cgalHull(a, CgalKernel::Rational);
    const std::int64_t moved = hull.ids[hull.ids.size() / 3];
    // A hull point goes to the place of another one.
    b[moved] = b[hull.ids[hull.ids.size() / 3 + 1]];
    EXPECT_NE(faultOf(b, makeHull(hull, FacetMode::Triangles)), Fault::None) << family.name;
    EXPECT_EQ(faultOf(a, makeHull(hull, FacetMode::Triangles)), Fault::None) << family.name;
  }
}

TEST(Validate, WindsOnce)
{
  // A bipyramid wound twice is closed, oriented, convex at every edge, and no hull.
  Cloud cloud = bipyramid(5);
  for (std::size_t i = 2; i < 7; ++i)
  {
    cloud.push_back(cloud[i]);
  }
  std::vector<Cell> cells;
  for (int i = 0; i < 10; ++i)
  {
    const std::int64_t a = 2 + i;
    const std::int64_t b = 2 + (i + 1) % 10;
    cells.push_back({ 0, a, b });
    cells.push_back({ 1, b, a });
  }
  canonicalise(cells);
  Cell ids(12);
  std::iota(ids.begin(), ids.end(), 0);
  EXPECT_NE(faultOf(cloud, makeHull(3, ids, cells, FacetMode::Triangles)), Fault::None);
  // The same with the second round a little further out, so that no position is there twice.
  for (std::size_t i = 7; i < 12; ++i)
  {
    cloud[i] = { cloud[i][0] * (1 + 0x1p-30), cloud[i][1] * (1 + 0x1p-30), 0 };
  }
  EXPECT_NE(faultOf(cloud, makeHull(3, ids, cells, FacetMode::Triangles)), Fault::None);
}

}
}
}
