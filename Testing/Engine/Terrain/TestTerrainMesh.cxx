// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Terrain meshes: every error is that of rationals, no insertion is one too many, and the mesh
/// is the constrained triangulation of the points that were kept.
#include "Testing/Engine/Calls/Bits.h"
#include "Testing/Engine/Conformance/RandomCases.h"
#include "Testing/Engine/Constraints/ConstrainedCases.h"
#include "Testing/Engine/Query/PlaneQueries.h"
#include "Testing/Engine/References/BaselineFile.h"

#include <flipflop/TerrainMesh.h>
#include <flipflop/TriangulationQueries.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

// Nightly more.
#ifndef FLIPFLOP_TERRAINS
#define FLIPFLOP_TERRAINS 1000
#endif

namespace flipflop
{
namespace test
{

namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();
const double nan = std::numeric_limits<double>::quiet_NaN();

struct Terrain
{
  Cloud cloud;
  std::vector<Segment> breaklines;
  double tolerance;
};

TerrainMesh meshOf(const Terrain& given, std::int64_t maxVertices = 0, int threads = 1)
{
  Options options;
  options.threads = threads;
  return terrainMesh(viewOf(given.cloud), WeightView(), viewOf(given.breaklines),
    { given.tolerance, maxVertices }, options);
}

const Point& cornerOf(const Terrain& given, const TerrainMesh& mesh, std::int64_t at)
{
  const auto index = static_cast<std::size_t>(mesh.connectivity[static_cast<std::size_t>(at)]);
  return given.cloud[static_cast<std::size_t>(mesh.pointIds[index])];
}

/// How far along the segment from a to b, both ends included, p is. False: it is not there.
bool shareOnSegment(const Point& a, const Point& b, const Point& p, Rational& share)
{
  const int axis = a[0] != b[0] ? 0 : 1;
  if (orientation(a, b, p) != 0)
  {
    return false;
  }
  share = (Rational(p[axis]) - a[axis]) / (Rational(b[axis]) - a[axis]);
  return share >= 0 && share <= 1;
}

/// The surface's height at p in a cell. False: p is not in it.
bool heightIn(const Terrain& given, const TerrainMesh& mesh, std::int64_t cell, const Point& p,
  Rational& height)
{
  const std::int64_t begin = mesh.cellBegin(cell);
  const auto corner = [&](int i) -> const Point& { return cornerOf(given, mesh, begin + i); };
  height = corner(0)[2];
  if (mesh.dimension == 0)
  {
    return true;
  }
  if (mesh.dimension == 1)
  {
    Rational share;
    if (!shareOnSegment(corner(0), corner(1), p, share))
    {
      return false;
    }
    height += share * (Rational(corner(1)[2]) - corner(0)[2]);
    return true;
  }
  const Rational area = orientation(corner(0), corner(1), corner(2));
  const Rational second = orientation(corner(2), corner(0), p) / area;
  const Rational third = orientation(corner(0), corner(1), p) / area;
  height += second * (Rational(corner(1)[2]) - corner(0)[2]) +
    third * (Rational(corner(2)[2]) - corner(0)[2]);
  return second >= 0 && third >= 0 && second + third <= 1;
}

bool isNearest(double rounded, const Rational& value)
{
  if (!std::isfinite(rounded))
  {
    return abs(value) > Rational(std::numeric_limits<double>::max());
  }
  const Rational off = abs(Rational(value - rounded));
  const auto isNearerThan = [&](double next)
  { return !std::isfinite(next) || off <= abs(Rational(value - next)); };
  return isNearerThan(std::nextafter(rounded, infinite)) &&
    isNearerThan(std::nextafter(rounded, -infinite));
}

std::string faultOfErrors(const Terrain& given, const TerrainMesh& mesh)
{
  std::map<std::pair<double, double>, int> vertices;
  for (const std::int64_t id : mesh.pointIds)
  {
    const Point& p = given.cloud[static_cast<std::size_t>(id)];
    ++vertices[{ p[0] + 0.0, p[1] + 0.0 }];
  }
  std::int64_t beyond = 0;
  std::int64_t unreachable = 0;
  double greatest = 0;
  for (std::size_t i = 0; i < given.cloud.size(); ++i)
  {
    const Point& p = given.cloud[i];
    Rational height;
    std::int64_t cell = 0;
    while (cell < mesh.cellCount() && !heightIn(given, mesh, cell, p, height))
    {
      ++cell;
    }
    if (cell == mesh.cellCount())
    {
      return "no cell holds point " + std::to_string(i);
    }
    const Rational error = p[2] - height;
    if (!isNearest(mesh.errors[i], error))
    {
      return "the error of point " + std::to_string(i) + " is not rounded to nearest";
    }
    const bool isBeyond = abs(error) > Rational(given.tolerance);
    beyond += isBeyond;
    unreachable += isBeyond && vertices.count({ p[0] + 0.0, p[1] + 0.0 }) > 0;
    greatest = std::max(greatest, std::fabs(mesh.errors[i]));
  }
  return mesh.beyond != beyond        ? "beyond"
    : mesh.unreachable != unreachable ? "unreachable"
    : mesh.greatestError != greatest  ? "greatestError"
                                      : "";
}

/// It is the triangulation of what is kept, with all that it has.
std::string faultOfTriangulation(const Terrain& given, const TerrainMesh& mesh)
{
  Cloud kept;
  std::map<std::pair<double, double>, std::int64_t> at;
  for (const std::int64_t id : mesh.pointIds)
  {
    const Point& p = given.cloud[static_cast<std::size_t>(id)];
    at[{ p[0] + 0.0, p[1] + 0.0 }] = static_cast<std::int64_t>(kept.size());
    kept.push_back(p);
  }
  std::vector<Segment> breaklines;
  for (const Segment& line : given.breaklines)
  {
    Segment mapped;
    for (std::size_t i = 0; i < 2; ++i)
    {
      const Point& p = given.cloud[static_cast<std::size_t>(line[i])];
      const auto found = at.find({ p[0] + 0.0, p[1] + 0.0 });
      if (found == at.end())
      {
        return "an end of a constraint is missing";
      }
      mapped[i] = found->second;
    }
    breaklines.push_back(mapped);
  }
  const ConstrainedTriangulation wanted =
    constrainedTriangulation(viewOf(kept), viewOf(breaklines));
  const auto bits = [](const ConstrainedTriangulation& t)
  {
    return std::to_string(t.dimension) + bitsOf(t.connectivity) + bitsOf(t.fixedEdges) +
      bitsOf(t.constraintOf) + bitsOf(t.balance) + bitsOf(t.sideOf);
  };
  return bits(mesh) == bits(wanted) ? "" : "it is not the triangulation of the points kept";
}

std::string faultOf(const Terrain& given)
{
  const TerrainMesh mesh = meshOf(given);
  std::string fault = faultOfTriangulation(given, mesh);
  fault = fault.empty() ? faultOfErrors(given, mesh) : fault;
  if (!fault.empty())
  {
    return fault;
  }
  if (mesh.beyond != mesh.unreachable)
  {
    return "points that could be reached are beyond";
  }
  for (const int threads : { 2, 4 })
  {
    if (bitsOf(meshOf(given, 0, threads)) != bitsOf(mesh))
    {
      return "threads change it";
    }
  }
  const auto size = static_cast<std::int64_t>(mesh.pointIds.size());
  const auto least = static_cast<std::int64_t>(meshOf(given, 1).pointIds.size());
  if (size > least)
  {
    const TerrainMesh before = meshOf(given, size - 1);
    fault = faultOfErrors(given, before);
    if (!fault.empty() || static_cast<std::int64_t>(before.pointIds.size()) != size - 1 ||
      before.beyond <= before.unreachable)
    {
      return "before the last insertion: " + fault;
    }
  }
  return "";
}

// ---- Random terrains ---------------------------------------------------------------------------

/// Without those that cross earlier ones between points.
std::vector<Segment> withoutCrossings(const Cloud& cloud, std::vector<Segment> lines)
{
  for (;;)
  {
    try
    {
      constrainedTriangulation(viewOf(cloud), viewOf(lines));
      return lines;
    }
    catch (const Error& error)
    {
      lines.erase(lines.begin() + error.index());
    }
  }
}

Point drawPosition(Random& random, int kind, std::size_t i)
{
  switch (kind)
  {
    case 0: // a raster, shuffled
      return { double(i % 6), double(i / 6), 0 };
    case 1: // a few integers: ties, duplicates, points on constraints
      return { double(random.integer(0, 4)), double(random.integer(0, 4)), 0 };
    case 2: // on one line
      return { double(random.integer(-9, 9)), 0, 0 };
    case 3: // on one circle, and inside
    {
      static const double corner[12][2] = { { 5, 0 }, { 4, 3 }, { 3, 4 }, { 0, 5 }, { -3, 4 },
        { -4, 3 }, { -5, 0 }, { -4, -3 }, { -3, -4 }, { 0, -5 }, { 3, -4 }, { 4, -3 } };
      const std::size_t at = random.pick(16);
      return at < 12 ? Point{ corner[at][0], corner[at][1], 0 }
                     : Point{ double(random.integer(-2, 2)), double(random.integer(-2, 2)), 0 };
    }
    default:
      return { random.uniform(-1, 1), random.uniform(-1, 1), 0 };
  }
}

/// Row by row or column by column. Axes ascend or descend, in steps of one or of any length.
Cloud drawImage(Random& random)
{
  const auto drawAxis = [&random](int most)
  {
    const bool isUneven = random.integer(0, 1) == 1;
    std::vector<double> axis = { random.integer(0, 1) ? 0.0 : random.uniform(-5, 5) };
    for (int i = random.integer(1, most); i > 0; --i)
    {
      axis.push_back(axis.back() + (isUneven ? std::ldexp(1, random.integer(-9, 0)) : 1.0));
    }
    if (random.integer(0, 1))
    {
      std::reverse(axis.begin(), axis.end());
    }
    return axis;
  };
  const bool isLong = random.integer(0, 7) == 0;
  const std::vector<double> fast = drawAxis(isLong ? 2 : 7);
  const std::vector<double> slow = drawAxis(isLong ? 80 : 7);
  const int axis = random.integer(0, 1);
  Cloud image;
  for (const double row : slow)
  {
    for (const double column : fast)
    {
      Point p = {};
      p[axis] = column;
      p[1 - axis] = row;
      image.push_back(p);
    }
  }
  return image;
}

Cloud drawPositions(Random& random, int kind)
{
  if (kind == 6)
  {
    return drawImage(random);
  }
  Cloud cloud(static_cast<std::size_t>(random.integer(0, 36)));
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    cloud[i] = drawPosition(random, kind, i);
  }
  if (kind == 0 || random.integer(0, 1))
  {
    random.shuffle(cloud);
  }
  return cloud;
}

double drawHeight(Random& random, int kind, const Point& p)
{
  switch (kind)
  {
    case 0:
      return random.integer(0, 3);
    case 1:
      return random.uniform(-1, 1);
    case 2: // nearly a plane
      return p[0] / 3 + p[1] / 7 + random.integer(-1, 1) * 0x1p-52;
    default: // a plane, and a peak here and there
      return p[0] - 2 * p[1] + (random.integer(0, 5) ? 0 : random.integer(-3, 3));
  }
}

Terrain drawTerrain(Random& random)
{
  Terrain terrain;
  const int positions = random.integer(0, 6);
  const int heights = random.integer(0, 3);
  static const int exponents[] = { 0, 0, 0, -500, 480, -1040, 990 };
  const int unit = exponents[random.pick(5)];
  const int heightUnit = exponents[random.pick(7)];
  terrain.cloud = drawPositions(random, positions);
  for (Point& p : terrain.cloud)
  {
    p[2] = std::ldexp(drawHeight(random, heights, p), heightUnit);
    p[0] = std::ldexp(p[0], unit);
    p[1] = std::ldexp(p[1], unit);
  }
  const std::size_t count = terrain.cloud.size();
  for (int i = random.integer(0, 6); count > 0 && i > 0; --i)
  {
    terrain.breaklines.push_back({ static_cast<std::int64_t>(random.pick(count)),
      static_cast<std::int64_t>(random.pick(count)) });
  }
  terrain.breaklines = withoutCrossings(terrain.cloud, terrain.breaklines);
  static const double tolerances[] = { 0, 0.5, 1, 0x1p-52, 0.3, 2 };
  terrain.tolerance = std::ldexp(tolerances[random.pick(6)], heightUnit);
  return terrain;
}

TEST(TerrainMeshes, AreThoseOfRationals)
{
  runSeeds(FLIPFLOP_TERRAINS, drawTerrain, faultOf,
    [](const Terrain& terrain)
    {
      return "tolerance " + std::to_string(terrain.tolerance) + ", constraints " +
        textOf(terrain.breaklines) + "\n" + toString(terrain.cloud);
    });
}

// ---- Terrains that users have ------------------------------------------------------------------

TEST(TerrainMesh, OfSurveys)
{
  const std::map<std::string, double> tolerances = { { "autzen_thin_las", 10.0 },
    { "sainthelens_step3", 25.0 } };
  for (const Input& input : baselineInputs())
  {
    const auto found = tolerances.find(input.name);
    if (found == tolerances.end())
    {
      continue;
    }
    SCOPED_TRACE(input.name);
    const Terrain given = { input.make(), {}, found->second };
    const TerrainMesh mesh = meshOf(given);
    EXPECT_EQ(faultOfTriangulation(given, mesh), "");
    EXPECT_LT(mesh.pointIds.size(), given.cloud.size() / 2);
    EXPECT_EQ(mesh.beyond, mesh.unreachable);
    std::vector<std::int64_t> cells(given.cloud.size());
    TriangulationQueries(viewOf(given.cloud), mesh).locate(viewOf(given.cloud), cells.data());
    std::int64_t beyond = 0;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      Rational height;
      ASSERT_TRUE(cells[i] >= 0 && heightIn(given, mesh, cells[i], given.cloud[i], height)) << i;
      beyond += abs(Rational(given.cloud[i][2] - height)) > Rational(given.tolerance);
    }
    EXPECT_EQ(beyond, mesh.beyond);
    EXPECT_EQ(bitsOf(meshOf(given, 0, 4)), bitsOf(mesh));
    const auto size = static_cast<std::int64_t>(mesh.pointIds.size());
    EXPECT_GT(meshOf(given, size - 1).beyond, mesh.beyond);
  }
}

TEST(TerrainMesh, OfFewPoints)
{
  const Terrain none = { {}, {}, 0 };
  EXPECT_EQ(meshOf(none).dimension, -1);
  EXPECT_EQ(meshOf(none).greatestError, 0);
  const Terrain one = { { { 1, 2, 3 } }, { { 0, 0 } }, 0 };
  EXPECT_EQ(meshOf(one).dimension, 0);
  EXPECT_EQ(cellsOf(meshOf({ { { 0, 0, 1 }, { 2, 2, 1 }, { 1, 1, 1 }, { 1, 1, 1 } }, {}, 0 })),
    (std::vector<Cell>{ { 0, 1 } }));
  EXPECT_EQ(cellsOf(meshOf({ { { 0, 0, 1 }, { 2, 2, 1 }, { 1, 1, 3 } }, {}, 1.75 })),
    (std::vector<Cell>{ { 0, 2 }, { 1, 2 } }));
}

/// The tolerance is met by what is exactly as far, and by no more.
TEST(TerrainMesh, ToleranceIsExact)
{
  Terrain given = { { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 3, 0 }, { 1, 1, 1 } }, {}, 1 };
  EXPECT_EQ(meshOf(given).pointIds.size(), 3);
  given.tolerance = std::nextafter(1, 0);
  EXPECT_EQ(meshOf(given).pointIds.size(), 4);
  // A third is no double.
  given = { { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 3, 1 }, { 1, 1, 0 } }, {}, 1.0 / 3 };
  EXPECT_EQ(meshOf(given).pointIds.size(), 4); // 1.0 / 3 is less
  EXPECT_EQ(meshOf(given).beyond, 0);
  given.tolerance = std::nextafter(1.0 / 3, 1);
  EXPECT_EQ(meshOf(given).pointIds.size(), 3);
  EXPECT_EQ(meshOf(given).errors[3], -1.0 / 3);
  // Nothing is beyond an infinite one, whatever the error's magnitude.
  for (const double height : { 1.0, std::numeric_limits<double>::max() })
  {
    given = { { { 0, 0, -height }, { 3, 0, -height }, { 0, 3, 0 }, { 1, 1, height } }, {},
      infinite };
    EXPECT_EQ(meshOf(given).pointIds.size(), 3);
    EXPECT_EQ(meshOf(given).beyond, 0);
  }

  // As a fraction of the range of heights, which may exceed the doubles.
  for (const double unit : { 1.0, 0x1p1023 })
  {
    const Cloud cloud = { { 0, 0, -unit }, { 3, 0, unit }, { 0, 3, 0 }, { 1, 1, unit } };
    for (const double fraction : { 0.5, 0.25 })
    {
      const TerrainMesh mesh =
        terrainMesh(viewOf(cloud), WeightView(), ConstraintView(), { fraction, 0, true });
      EXPECT_EQ(mesh.tolerance, 2 * fraction * unit);
      EXPECT_EQ(mesh.pointIds.size(), fraction < 0.5 ? 4 : 3);
    }
  }
}

/// Of one position the lowest id is the vertex. Another height there may be out of reach.
TEST(TerrainMesh, ManyHeightsAtOnePosition)
{
  const Terrain given = { { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, 1, 5 }, { 1, 1, 7 },
                            { 1, 1, 4 }, { 4, 0, 9 } },
    {}, 1.5 };
  const TerrainMesh mesh = meshOf(given);
  EXPECT_EQ(mesh.pointIds.size(), 4);
  EXPECT_EQ(mesh.unreachable, 2);
  EXPECT_EQ(mesh.beyond, 2);
  EXPECT_FALSE(mesh.isWithinTolerance());
  EXPECT_EQ(mesh.greatestError, 9);
  EXPECT_EQ(faultOf(given), "");
}

TEST(TerrainMesh, HeightsThatAreNotFinite)
{
  const Cloud cloud = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, 1, 5 }, { 1, 2, 7 } };
  const double heights[] = { 0, nan, 0, infinite, 0 };
  const auto run = [&](NonFinitePolicy policy, const std::vector<Segment>& lines)
  {
    Options options;
    options.nonFinite = policy;
    return terrainMesh(viewOf(cloud), WeightView(heights, 5), viewOf(lines), { 1, 0 }, options);
  };
  expectError([&] { run(NonFinitePolicy::Error, {}); }, ErrorCode::NonFinite, 1, 2);
  const TerrainMesh mesh = run(NonFinitePolicy::Ignore, { { 0, 4 } });
  EXPECT_EQ(mesh.statistics.nonFinite, 2);
  EXPECT_EQ(cellsOf(mesh), (std::vector<Cell>{ { 0, 4, 2 } }));
  EXPECT_TRUE(std::isnan(mesh.errors[1]) && std::isnan(mesh.errors[3]));
  EXPECT_EQ(mesh.greatestError, 0);
  expectError(
    [&] {
      run(NonFinitePolicy::Ignore, { { 0, 2 }, { 2, 3 } });
    },
    ErrorCode::ConstraintPoint, 1, 3);
}

/// The vertex at which constraints cross is kept; where there is none, it is an error.
TEST(TerrainMesh, ConstraintsThatCross)
{
  Terrain given = { squareGrid(5), { { 0, 24 }, { 4, 20 }, { 2, 22 } }, 10 };
  EXPECT_EQ(meshOf(given).pointIds.size(), 7);
  EXPECT_EQ(faultOf(given), "");
  given.breaklines.push_back({ 5, 1 });
  expectError([&] { meshOf(given); }, ErrorCode::ConstraintsCross, 3, 0);
}

TEST(TerrainMesh, AnyMagnitude)
{
  const double most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  for (const double z : { most, least, 1e300, 1e-300, 1.0 })
  {
    for (const double unit : { 1.0, 1e300, 1e-300, least })
    {
      Cloud cloud;
      for (int i = 0; i < 25; ++i)
      {
        cloud.push_back({ unit * (i % 5), unit * (i / 5), i % 3 == 0 ? z : (i % 7 == 0 ? -z : 0) });
      }
      for (const double tolerance : { 0.0, least, z / 2, z })
      {
        EXPECT_EQ(faultOf({ cloud, { { 3, 17 } }, tolerance }), "")
          << z << " " << unit << " " << tolerance;
      }
    }
  }
}

// Where exponents span more than expansions carry, the signs of points without weights read zeros.
TEST(TerrainMesh, MixedMagnitudes)
{
  const double all[] = { -1e300, -1e-300, 0, 1e-300, 1e300 };
  for (const int skipped : { 0, 1, 2 })
  {
    Cloud cloud;
    for (int i = 0; i < 25; ++i)
    {
      if (skipped == 0 || i % 7 != skipped) // a grid, or none
      {
        cloud.push_back({ all[i % 5], all[i / 5], double((i * 7) % 11) });
      }
    }
    for (const double tolerance : { 0.0, 1.0, 3.0 })
    {
      EXPECT_EQ(faultOf({ cloud, {}, tolerance }), "") << skipped << " " << tolerance;
    }
  }
}

TEST(TerrainMesh, RefusesWhatIsNoTolerance)
{
  const Cloud cloud = squareGrid(3);
  const auto expectBad = [&](const TerrainMeshOptions& terrain, const WeightView& heights)
  {
    expectError([&] { terrainMesh(viewOf(cloud), heights, ConstraintView(), terrain); },
      ErrorCode::BadArgument);
  };
  const double heights[10] = {};
  expectBad({ -1, 0 }, WeightView());
  expectBad({ nan, 0 }, WeightView());
  expectBad({ 0, -1 }, WeightView());
  expectBad({ 0, 0 }, WeightView(heights, 8));
  expectBad({ 0, 0 }, WeightView(heights, 10));
  expectBad({ 0, 0 }, WeightView(heights, -1));
  expectBad({ 0, 0 }, WeightView(heights, 9, 0));
  expectBad({ 0, 0 }, WeightView(static_cast<const double*>(nullptr), 9));
  const Terrain outside = { cloud, { { 0, 9 } }, 0 };
  expectError([&] { meshOf(outside); }, ErrorCode::ConstraintPoint, 0, 9);
  EXPECT_EQ(meshOf({ cloud, {}, infinite }).pointIds.size(), 4);
}

}
}
}
