// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Refined meshes: each is the constrained triangulation of its own points, keeps the area that it
/// covers, and has no small angles or large triangles but where the input has a small angle.
#include "Testing/Engine/Calls/Bits.h"
#include "Testing/Engine/Conformance/RandomCases.h"
#include "Testing/Engine/Constraints/ConstrainedCases.h"

#include <flipflop/ConstraintCrossings.h>
#include <flipflop/RefinedMesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

using Position = std::array<long double, 2>;

/// A straight-line graph, and what is wanted.
struct Graph
{
  std::vector<double> points; ///< x and y
  std::vector<std::int64_t> ends;
  std::int64_t sides = 0; ///< the last so many are sides of polygons
  std::vector<MeshRegion> regions;
  RefinementOptions refinement;

  PointView view() const
  {
    return { this->points.data(), static_cast<std::int64_t>(this->points.size() / 2), 2 };
  }
  ConstraintView constraints() const
  {
    return { this->ends.data(), static_cast<std::int64_t>(this->ends.size() / 2), this->sides };
  }
};

RefinedMesh meshOf(const Graph& graph, int threads = 1)
{
  Options options;
  options.threads = threads;
  RefinementOptions refinement = graph.refinement;
  refinement.regions = graph.regions.data();
  refinement.regionCount = static_cast<std::int64_t>(graph.regions.size());
  return refinedMesh(graph.view(), graph.constraints(), refinement, options);
}

Position positionOf(const RefinedMesh& mesh, std::int64_t id)
{
  return { mesh.points[static_cast<std::size_t>(2 * id)],
    mesh.points[static_cast<std::size_t>(2 * id + 1)] };
}

std::array<std::int64_t, 3> cornersOf(const RefinedMesh& mesh, std::size_t cell)
{
  std::array<std::int64_t, 3> corner{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    corner[i] = mesh.pointIds[static_cast<std::size_t>(mesh.connectivity[3 * cell + i])];
  }
  return corner;
}

long double areaOf(const Position& a, const Position& b, const Position& c)
{
  return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
}

/// In degrees, at @p a.
long double angleOf(const Position& a, const Position& b, const Position& c)
{
  const long double dot = (b[0] - a[0]) * (c[0] - a[0]) + (b[1] - a[1]) * (c[1] - a[1]);
  return std::atan2(std::fabs(2 * areaOf(a, b, c)), dot) * 57.295779513082320876798L;
}

long double lengthOf(const Position& a, const Position& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// Is an edge between two segments at a small angle of the input, as far from its apex at both
/// ends?
bool isAcross(const Graph& graph, const Position& a, const Position& b)
{
  for (std::size_t i = 0; i < graph.points.size(); i += 2)
  {
    const Position apex = { graph.points[i], graph.points[i + 1] };
    const long double far = lengthOf(apex, a);
    if (far > 0 && std::fabs(far - lengthOf(apex, b)) <= 1e-9L * far &&
      angleOf(apex, a, b) < 60.0L + 1e-6L)
    {
      return true;
    }
  }
  return false;
}

std::string shapeFault(const Graph& graph, const RefinedMesh& mesh)
{
  std::set<std::int64_t> onSegments;
  for (const std::int64_t at : mesh.fixedEdges)
  {
    onSegments.insert(mesh.pointIds[static_cast<std::size_t>(at)]);
  }
  for (std::size_t cell = 0; cell < mesh.region.size(); ++cell)
  {
    if (mesh.region[cell] < 0)
    {
      continue;
    }
    const std::array<std::int64_t, 3> corner = cornersOf(mesh, cell);
    Position p[3];
    std::transform(
      corner.begin(), corner.end(), p, [&](std::int64_t id) { return positionOf(mesh, id); });
    const std::string where = " of triangle " + std::to_string(cell);
    const double own = mesh.region[cell] > 0
      ? graph.regions[static_cast<std::size_t>(mesh.region[cell] - 1)].maxArea
      : 0;
    const double most = own > 0 ? own : graph.refinement.maxArea;
    if (most > 0 && areaOf(p[0], p[1], p[2]) > most)
    {
      return "the area" + where;
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t next[2] = { (i + 1) % 3, (i + 2) % 3 };
      const Position& b = p[next[0]];
      const Position& c = p[next[1]];
      const bool mayBeThin = onSegments.count(corner[next[0]]) &&
        onSegments.count(corner[next[1]]) && isAcross(graph, b, c);
      if (angleOf(p[i], b, c) < graph.refinement.minAngle && !mayBeThin)
      {
        return "an angle of " + std::to_string(double(angleOf(p[i], b, c))) + where + ": " +
          std::to_string(double(p[i][0])) + " " + std::to_string(double(p[i][1])) + ", " +
          std::to_string(double(b[0])) + " " + std::to_string(double(b[1])) + ", " +
          std::to_string(double(c[0])) + " " + std::to_string(double(c[1]));
      }
    }
  }
  return "";
}

/// Is it the constrained triangulation of its points, from nothing?
std::string triangulationFault(const RefinedMesh& mesh)
{
  std::vector<std::int64_t> ends;
  for (const std::int64_t corner : mesh.fixedEdges)
  {
    ends.push_back(mesh.pointIds[static_cast<std::size_t>(corner)]);
  }
  const PointView points(mesh.points.data(), static_cast<std::int64_t>(mesh.points.size() / 2), 2);
  const ConstrainedTriangulation wanted = constrainedTriangulation(
    points, ConstraintView(ends.data(), static_cast<std::int64_t>(ends.size() / 2)));
  return bitsOf(static_cast<const Triangulation&>(wanted)) !=
        bitsOf(static_cast<const Triangulation&>(mesh)) ||
      bitsOf(wanted.fixedEdges) != bitsOf(mesh.fixedEdges)
    ? "another triangulation"
    : "";
}

/// Are new points on their constraints, but for what rounding can do?
std::string positionFault(const Graph& graph, const RefinedMesh& mesh)
{
  double most = 0;
  for (const double x : graph.points)
  {
    most = std::max(most, std::fabs(x));
  }
  const long double unit = std::ldexp(1.0, std::ilogb(most) - 52);
  const auto count = static_cast<std::int64_t>(graph.points.size() / 2);
  for (std::size_t i = 0; i < mesh.constraintOfPoint.size(); ++i)
  {
    const std::int64_t constraint = mesh.constraintOfPoint[i];
    if (constraint < 0)
    {
      continue;
    }
    const Position a = positionOf(mesh, graph.ends[static_cast<std::size_t>(2 * constraint)]);
    const Position b = positionOf(mesh, graph.ends[static_cast<std::size_t>(2 * constraint + 1)]);
    const Position p = positionOf(mesh, count + static_cast<std::int64_t>(i));
    if (std::fabs(2 * areaOf(a, b, p)) > 30 * unit * lengthOf(a, b))
    {
      return "new point " + std::to_string(i) + " is off its constraint";
    }
  }
  return "";
}

long double coveredArea(const RefinedMesh& mesh)
{
  long double area = 0;
  for (std::size_t cell = 0; cell < mesh.region.size(); ++cell)
  {
    const std::array<std::int64_t, 3> c = cornersOf(mesh, cell);
    area += mesh.region[cell] < 0
      ? 0
      : areaOf(positionOf(mesh, c[0]), positionOf(mesh, c[1]), positionOf(mesh, c[2]));
  }
  return area;
}

/// The lines in another order and direction, and the sides in another order.
Graph shuffled(const Graph& graph)
{
  Graph other = graph;
  const auto lines = static_cast<std::ptrdiff_t>(graph.ends.size()) - 2 * graph.sides;
  std::reverse(other.ends.begin(), other.ends.begin() + lines);
  std::reverse(other.ends.begin() + lines, other.ends.end());
  for (std::size_t i = static_cast<std::size_t>(lines); i < other.ends.size(); i += 2)
  {
    std::swap(other.ends[i], other.ends[i + 1]);
  }
  return other;
}

std::string faultOf(const Graph& graph)
{
  const RefinedMesh mesh = meshOf(graph);
  Graph coarse = graph;
  coarse.refinement.minAngle = 0;
  coarse.refinement.maxArea = 0;
  coarse.regions.clear();
  const long double area = coveredArea(meshOf(coarse));
  const bool isWhole =
    graph.regions.empty() && std::fabs(coveredArea(mesh) - area) > 1e-12L * std::fabs(area);
  const bool isTheSame =
    bitsOf(mesh) == bitsOf(meshOf(graph, 2)) && bitsOf(mesh) == bitsOf(meshOf(graph, 4));
  const RefinedMesh turned = meshOf(shuffled(graph));
  const bool isOfAnyOrder = bitsOf(mesh.points) == bitsOf(turned.points) &&
    bitsOf(mesh.connectivity) == bitsOf(turned.connectivity) &&
    bitsOf(mesh.fixedEdges) == bitsOf(turned.fixedEdges);
  const std::string kept = "kept " + std::to_string(mesh.keptSegments) + " segments, " +
    std::to_string(mesh.keptTriangles) + " triangles";
  for (const std::string& fault : { mesh.isComplete ? std::string() : "it did not end",
         mesh.keptSegments + mesh.keptTriangles > 0 ? kept : "",
         isWhole ? std::string("the area that it covers") : "", shapeFault(graph, mesh),
         triangulationFault(mesh), positionFault(graph, mesh),
         isTheSame ? std::string() : "other bits on two or four threads",
         isOfAnyOrder ? std::string() : "other bits from constraints in another order" })
  {
    if (!fault.empty())
    {
      return fault;
    }
  }
  return "";
}

/// Points on grids and off them, some very near to others, and segments between them, cut where
/// they cross.
Graph drawGraph(Random& random)
{
  Graph graph;
  const std::size_t count = 3 + random.pick(20);
  const std::size_t grid = 3 + random.pick(20);
  const bool isOnGrid = random.pick(2) == 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    double x[2];
    for (double& at : x)
    {
      at = static_cast<double>(random.pick(grid));
      at += isOnGrid ? 0 : static_cast<double>(random.pick(1000)) / 997;
    }
    if (i > 0 && random.pick(8) == 0)
    {
      const double near = std::ldexp(1.0, -static_cast<int>(random.pick(7)));
      x[0] = graph.points[2 * i - 2] + near;
      x[1] = graph.points[2 * i - 1];
    }
    graph.points.insert(graph.points.end(), x, x + 2);
  }
  std::vector<std::int64_t> given;
  for (std::size_t i = random.pick(2 * count); i > 0; --i)
  {
    given.push_back(static_cast<std::int64_t>(random.pick(count)));
    given.push_back(static_cast<std::int64_t>(random.pick(count)));
  }
  if (random.pick(2) == 0)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      given.push_back(static_cast<std::int64_t>(i));
      given.push_back(static_cast<std::int64_t>(i + 1 < count ? i + 1 : 0));
    }
    graph.sides = static_cast<std::int64_t>(count);
  }
  const SplitConstraints split = splitCrossings(graph.view(),
    ConstraintView(given.data(), static_cast<std::int64_t>(given.size() / 2), graph.sides));
  graph.points.insert(graph.points.end(), split.positions.begin(), split.positions.end());
  graph.ends.assign(split.ends.begin(), split.ends.end());
  graph.sides = split.sides;
  static const double angles[] = { 0, 15, 20, 25, 28, 30 };
  graph.refinement.minAngle = angles[random.pick(6)];
  graph.refinement.maxArea = random.pick(2) == 0 ? 0 : 0.1 + static_cast<double>(random.pick(50));
  graph.refinement.maxPoints = 1000000;
  return graph;
}

/// A square, and what is asked of its mesh.
Graph square(double minAngle, double maxArea)
{
  Graph graph;
  graph.points = { 0, 0, 4, 0, 4, 4, 0, 4 };
  graph.ends = { 0, 1, 1, 2, 2, 3, 3, 0 };
  graph.refinement.minAngle = minAngle;
  graph.refinement.maxArea = maxArea;
  return graph;
}

std::int64_t cellsOf(const RefinedMesh& mesh, std::int64_t region)
{
  return std::count(mesh.region.begin(), mesh.region.end(), region);
}

/// What an error says, and of which item.
std::string refusal(const Graph& graph)
{
  try
  {
    meshOf(graph);
  }
  catch (const Error& error)
  {
    return error.what() + std::string(" ") + std::to_string(error.index());
  }
  return "none";
}

}

TEST(RefinedMeshes, OfRandomGraphs)
{
  runSeeds(300, drawGraph, faultOf,
    [](const Graph& graph)
    {
      return "angle " + std::to_string(graph.refinement.minAngle) + ", area " +
        std::to_string(graph.refinement.maxArea);
    });
}

TEST(RefinedMesh, HasRegionsAndHoles)
{
  Graph graph = square(20, 2);
  graph.points.insert(graph.points.end(), { 2, 0, 2, 4, 3, 1, 3, 3 });
  graph.points.insert(graph.points.end(), { 2.5, 2, 1, 1, 1.5, 1, 1, 1.5 });
  graph.ends.insert(graph.ends.end(), { 4, 5, 9, 10, 10, 11, 11, 9 });
  graph.regions = { { 0.25, 0.25, 0.01, false }, { 1.1, 1.1, 0, true } };
  EXPECT_EQ(faultOf(graph), "");
  const RefinedMesh mesh = meshOf(graph);
  EXPECT_GT(cellsOf(mesh, 1), 790); // of an area of 7.875
  EXPECT_LT(cellsOf(mesh, 0), cellsOf(mesh, 1) / 2);
  EXPECT_EQ(cellsOf(mesh, 2), 0);
  EXPECT_NEAR(static_cast<double>(coveredArea(mesh)), 16 - 0.125, 1e-12);
}

TEST(RefinedMesh, OfAnyMagnitude)
{
  const Graph graph = square(30, 0.01);
  const RefinedMesh mesh = meshOf(graph);
  for (const int exponent : { -900, -500, 300, 900 })
  {
    Graph other = graph;
    for (double& x : other.points)
    {
      x = std::ldexp(x, exponent);
    }
    const bool hasArea = std::abs(exponent) <= 500;
    other.refinement.maxArea = hasArea ? std::ldexp(0.01, 2 * exponent) : 0;
    const RefinedMesh found = meshOf(other);
    if (hasArea)
    {
      EXPECT_EQ(bitsOf(static_cast<const ConstrainedTriangulation&>(found)),
        bitsOf(static_cast<const ConstrainedTriangulation&>(mesh)))
        << exponent;
    }
    EXPECT_EQ(triangulationFault(found), "") << exponent;
  }
}

TEST(RefinedMesh, EndsAtTheLimit)
{
  Graph graph = square(30, 1e-3);
  graph.refinement.maxPoints = 100;
  const RefinedMesh mesh = meshOf(graph);
  EXPECT_FALSE(mesh.isComplete);
  EXPECT_EQ(mesh.newPoints, 100);
  EXPECT_EQ(triangulationFault(mesh), "");
}

TEST(RefinedMesh, KeepsSmallAnglesOfTheInput)
{
  for (const double height : { 1.0, 0.1, 1e-3, 1e-6, 1e-12 })
  {
    Graph graph;
    graph.points = { 0, 0, 4, 0, 4, height };
    graph.ends = { 0, 1, 1, 2, 2, 0 };
    graph.sides = 3;
    graph.refinement.minAngle = 28;
    const RefinedMesh mesh = meshOf(graph);
    EXPECT_TRUE(mesh.isComplete);
    EXPECT_EQ(triangulationFault(mesh), "") << height;
    EXPECT_EQ(height < 1e-9 ? "" : shapeFault(graph, mesh), "") << height;
    EXPECT_EQ(std::vector<std::int64_t>(mesh.smallAngles.begin(), mesh.smallAngles.end()),
      (std::vector<std::int64_t>{ 0, 1, 2 }))
      << height;
  }
}

TEST(RefinedMesh, WithoutConstraintsIsOfTheHull)
{
  Graph graph = square(25, 0.5);
  graph.ends.clear();
  EXPECT_EQ(faultOf(graph), "");
  EXPECT_EQ(cellsOf(meshOf(graph), -1), 0);
  graph.points = { 0, 0, 1, 1, 2, 2 };
  EXPECT_EQ(meshOf(graph).dimension, 1);
  graph.points = {};
  EXPECT_EQ(meshOf(graph).dimension, -1);
}

TEST(RefinedMesh, RefusesWhatIsNoLimit)
{
  const auto changed = [](const auto& change)
  {
    Graph graph = square(20, 1);
    change(graph);
    return refusal(graph);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string angle = "the least angle must be from 0 to 34 degrees -1";
  EXPECT_EQ(changed([](Graph& graph) { graph.refinement.minAngle = 35; }), angle);
  EXPECT_EQ(changed([&](Graph& graph) { graph.refinement.minAngle = nan; }), angle);
  const std::string area = "the greatest area must be 0 (any) or more -1";
  EXPECT_EQ(changed([](Graph& graph) { graph.refinement.maxArea = -1; }), area);
  EXPECT_EQ(changed([&](Graph& graph) { graph.refinement.maxArea = nan; }), area);
  EXPECT_EQ(changed([](Graph& graph) { graph.refinement.maxPoints = -1; }),
    "the numbers of points and of regions must be 0 or more -1");
  EXPECT_EQ(changed([](Graph& graph) { graph.points[0] = 1e-300; }),
    "coordinates of a mesh to be refined must be 0 where they are smaller than the greatest by "
    "more "
    "than about 60 orders of magnitude -1");
  const auto withRegions = [&](const std::vector<MeshRegion>& regions)
  { return changed([&](Graph& graph) { graph.regions = regions; }); };
  const std::string inside = "the point of a region must be inside of the mesh, on no constraint ";
  EXPECT_EQ(withRegions({ { 1, 1, 0, false }, { 5, 5, 0, false } }), inside + "1");
  EXPECT_EQ(withRegions({ { 4, 1, 0, false } }), inside + "0");
  EXPECT_EQ(withRegions({ { 1, 1, 0, false }, { 2, 3, 0, false } }),
    "two regions must not be in one part of the mesh 1");
  EXPECT_EQ(withRegions({ { nan, 1, 0, false } }), "the point of a region must be finite 0");
  EXPECT_EQ(withRegions({ { 1, 1, nan, false } }),
    "the greatest area of a region must be 0 (as everywhere) or more 0");
}

}
}
