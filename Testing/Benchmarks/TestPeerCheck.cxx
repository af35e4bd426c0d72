// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The check of other libraries' results: right ones pass in whatever form they come, and each way
/// to break one is found and named.
#include "PeerCheck.h"
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include "Testing/Engine/References/ReferenceTriangulation.h"

#include <algorithm>
#include <functional>

namespace flipflop
{
namespace test
{

namespace
{

/// Cells of input ids as a library would return them, over all points or those in use alone.
PeerOutput outputOf(const Cloud& cloud, const std::vector<Cell>& cells, bool all = true)
{
  PeerOutput output;
  std::vector<std::int64_t> position(cloud.size(), -1);
  const auto positionOf = [&](std::size_t id)
  {
    if (position[id] < 0)
    {
      position[id] = static_cast<std::int64_t>(output.points.size() / 3);
      output.points.insert(output.points.end(), cloud[id].begin(), cloud[id].end());
    }
    return position[id];
  };
  for (std::size_t id = 0; all && id < cloud.size(); ++id)
  {
    positionOf(id);
  }
  for (const Cell& cell : cells)
  {
    for (const std::int64_t id : cell)
    {
      output.connectivity.push_back(positionOf(static_cast<std::size_t>(id)));
    }
    output.offsets.push_back(static_cast<std::int64_t>(output.connectivity.size()));
  }
  return output;
}

/// All points of a square grid, each square cut along one diagonal or, by turns, the other.
std::vector<Cell> cutSquares(std::int64_t side, bool byTurns)
{
  std::vector<Cell> cells;
  for (std::int64_t y = 0; y + 1 < side; ++y)
  {
    for (std::int64_t x = 0; x + 1 < side; ++x)
    {
      const std::int64_t a = y * side + x;
      const std::int64_t b = a + 1;
      const std::int64_t c = a + side + 1;
      const std::int64_t d = a + side;
      if (byTurns && (x + y) % 2)
      {
        cells.insert(cells.end(), { { a, b, d }, { b, c, d } });
      }
      else
      {
        cells.insert(cells.end(), { { a, b, c }, { a, c, d } });
      }
    }
  }
  return cells;
}

/// x + y * side in the plane, without weights.
Cloud flatGrid(int side)
{
  Cloud cloud;
  for (int i = 0; i < side * side; ++i)
  {
    cloud.push_back({ static_cast<double>(i % side), static_cast<double>(i / side), 0 });
  }
  return cloud;
}

const Cloud cube = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
  { 1, 1, 1 }, { 0, 1, 1 }, { 0.5, 0.5, 0 }, { 0.25, 0.5, 0.75 } };

/// Of the cube: 8 in the middle of its floor is used, 9 is inside.
const std::vector<Cell> cubeCells = { { 1, 0, 8 }, { 2, 1, 8 }, { 3, 2, 8 }, { 0, 3, 8 },
  { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6 }, { 1, 6, 5 }, { 2, 3, 7, 6 }, { 7, 3, 4 },
  { 3, 0, 4 } };

PeerReport ofCube(const std::vector<Cell>& cells)
{
  return checkHull(viewOf(cube), outputOf(cube, cells));
}

std::vector<Cell> changed(
  std::vector<Cell> cells, const std::function<void(std::vector<Cell>&)>& change)
{
  change(cells);
  return cells;
}

/// The output with the first two triangles that share an edge joined the other way.
std::vector<Cell> withEdgeFlipped(std::vector<Cell> triangles)
{
  for (std::size_t j = 1; j < triangles.size(); ++j)
  {
    for (std::size_t e = 0; e < 3; ++e)
    {
      for (std::size_t f = 0; f < 3; ++f)
      {
        Cell& s = triangles[0];
        Cell& t = triangles[j];
        if (s[e] == t[(f + 1) % 3] && s[(e + 1) % 3] == t[f])
        {
          const std::int64_t a = s[e];
          const std::int64_t b = s[(e + 1) % 3];
          const std::int64_t c = s[(e + 2) % 3];
          const std::int64_t d = t[(f + 2) % 3];
          s = { a, d, c };
          t = { d, b, c };
          return triangles;
        }
      }
    }
  }
  return triangles;
}

TEST(PeerCheck, TakesHullsInAnyForm)
{
  for (const char* family : { "ball", "shell0", "doubled", "smallIntegers", "far8", "skewPlane" })
  {
    SCOPED_TRACE(family);
    const Cloud cloud = fromFamily(family, 500, 3).make();
    const std::vector<Cell> polygons = cgalHull(cloud).cells;
    for (const bool all : { true, false })
    {
      for (const std::vector<Cell>& cells : { polygons, triangulate(polygons) })
      {
        const PeerReport found = checkHull(viewOf(cloud), outputOf(cloud, cells, all));
        EXPECT_TRUE(found.isValid());
        EXPECT_EQ(describeHull(found), "valid");
      }
    }
  }
}

TEST(PeerCheck, TakesVerticesWithinFacetsAndRemarksThem)
{
  EXPECT_TRUE(ofCube(cubeCells).isValid());
  EXPECT_EQ(describeHull(ofCube(cubeCells)), "valid (vertices not extreme: 1)");
}

TEST(PeerCheck, TakesTurnedAndFlatFacetsAndRemarksThem)
{
  const std::vector<Cell> turned = changed(cubeCells,
    [](std::vector<Cell>& cells)
    {
      std::reverse(cells[6].begin(), cells[6].end());
      std::reverse(cells[9].begin(), cells[9].end());
    });
  EXPECT_EQ(
    describeHull(ofCube(turned)), "valid (vertices not extreme: 1; facets turned inwards: 2)");
  // Between a diagonal and the two halves of it.
  const std::vector<Cell> flat = changed(cubeCells,
    [](std::vector<Cell>& cells)
    {
      cells.erase(cells.begin(), cells.begin() + 2);
      cells.insert(cells.end(), { { 1, 0, 2 }, { 2, 0, 8 } });
    });
  EXPECT_EQ(describeHull(ofCube(flat)), "valid (vertices not extreme: 1; facets without area: 1)");
}

TEST(PeerCheck, NoticesAnEmptyHull)
{
  EXPECT_FALSE(ofCube({}).isValid());
  EXPECT_EQ(describeHull(ofCube({})), "empty");
}

TEST(PeerCheck, NoticesAHullThatIsNotClosed)
{
  const PeerReport found =
    ofCube(changed(cubeCells, [](std::vector<Cell>& cells) { cells.erase(cells.begin() + 6); }));
  EXPECT_FALSE(found.isValid());
  EXPECT_EQ(describeHull(found), "open edges: 3");
}

TEST(PeerCheck, NoticesMissingVerticesAndPointsOutside)
{
  // Without 6 = (1, 1, 1), which two further points near it need.
  Cloud cloud = cube;
  cloud.push_back({ 0.9, 0.9, 0.9 });
  cloud.push_back({ 0.8, 0.9, 0.9 });
  const std::vector<Cell> cells = { { 3, 2, 1, 0 }, { 4, 5, 7 }, { 0, 1, 5, 4 }, { 1, 2, 5 },
    { 2, 3, 7 }, { 7, 3, 0, 4 }, { 2, 7, 5 } };
  const PeerReport found = checkHull(viewOf(cloud), outputOf(cloud, cells));
  EXPECT_FALSE(found.isValid());
  EXPECT_EQ(describeHull(found),
    "extreme points missing: 1 of 8; points outside: 3 (by up to 5.8e-01 of the extent); facets "
    "with points beyond: 1 of 10");
}

TEST(PeerCheck, SeparatesRoundingErrorsFromDistances)
{
  // The cube turned, with a point beyond its facet by as little as doubles have.
  Cloud cloud = rotated({ cube.begin(), cube.begin() + 9 });
  cloud[8][0] *= 1 - 0x1p-50;
  cloud[8][1] *= 1 - 0x1p-50;
  cloud[8][2] -= 0x1p-50;
  const std::vector<Cell> cells = { { 3, 2, 1 }, { 3, 1, 0 }, { 4, 5, 6 }, { 4, 6, 7 }, { 0, 1, 5 },
    { 0, 5, 4 }, { 1, 2, 6 }, { 1, 6, 5 }, { 2, 3, 7 }, { 2, 7, 6 }, { 3, 0, 4 }, { 3, 4, 7 } };
  const PeerReport found = checkHull(viewOf(cloud), outputOf(cloud, cells));
  EXPECT_FALSE(found.isValid());
  EXPECT_NE(describeHull(found).find("points outside: 1 (by rounding errors)"), std::string::npos);
}

TEST(PeerCheck, NoticesAHullThatIsNotConvex)
{
  // A dent to 9, which is inside.
  const std::vector<Cell> dented = changed(cubeCells,
    [](std::vector<Cell>& cells)
    {
      cells.resize(9);
      cells.insert(cells.end(), { { 7, 3, 9 }, { 3, 0, 9 }, { 0, 4, 9 }, { 4, 7, 9 } });
    });
  EXPECT_FALSE(ofCube(dented).isValid());
  EXPECT_EQ(describeHull(ofCube(dented)), "facets with points beyond: 4 of 16");

  const Cloud cloud = fromFamily("shell0", 100, 5).make();
  const std::vector<Cell> flipped = withEdgeFlipped(triangulate(cgalHull(cloud).cells));
  const PeerReport found = checkHull(viewOf(cloud), outputOf(cloud, flipped));
  EXPECT_EQ(describeHull(found), "facets with points beyond: 2 of 196");
}

TEST(PeerCheck, NoticesFacetsUponEachOther)
{
  const PeerReport folded = ofCube(changed(cubeCells,
    [](std::vector<Cell>& cells) {
      cells.insert(cells.end(), { cells[6], cells[6] });
    }));
  EXPECT_FALSE(folded.isValid());
  EXPECT_EQ(describeHull(folded), "folded edges: 3");

  std::vector<Cell> twice = cubeCells;
  twice.insert(twice.end(), cubeCells.begin(), cubeCells.end());
  EXPECT_FALSE(ofCube(twice).isValid());
  EXPECT_EQ(describeHull(ofCube(twice)), "times that the whole is covered: 2");
}

TEST(PeerCheck, NoticesCornersThatAreNoInputPoints)
{
  PeerOutput output = outputOf(cube, cubeCells);
  output.points[3 * 8 + 2] = 0x1p-60;
  const PeerReport found = checkHull(viewOf(cube), output);
  EXPECT_FALSE(found.isValid());
  EXPECT_EQ(found.unknownCorners, 4);
}

TEST(PeerCheck, MatchesRoundedPoints)
{
  Cloud cloud = fromFamily("shell0", 300, 7).make();
  const std::vector<Cell> cells = cgalHull(cloud).cells;
  // Inside, and first, but rounding as an extreme point does.
  Point inside = cloud[0];
  for (double& x : inside)
  {
    x -= 0x1p-40 * x;
  }
  Cloud both = joined({ inside }, cloud);
  PeerOutput output = outputOf(cloud, cells);
  for (double& x : output.points)
  {
    x = static_cast<double>(static_cast<float>(x));
  }
  EXPECT_GT(checkHull(viewOf(both), output).unknownCorners, 0);
  output.rounded = true;
  EXPECT_EQ(describeHull(checkHull(viewOf(both), output)), "valid");
}

TEST(PeerCheck, ChecksPolygonsOfCoplanarPoints)
{
  Cloud cloud = flatGrid(4);
  for (Point& p : cloud)
  {
    p[2] = p[0] + 2 * p[1];
  }
  const auto checked = [&](const std::vector<Cell>& cells)
  { return describeHull(checkHull(viewOf(cloud), outputOf(cloud, cells))); };
  EXPECT_EQ(checked({ { 0, 3, 15, 12 } }), "valid");
  EXPECT_EQ(checked({ { 0, 12, 15, 3 } }), checked({ { 0, 3, 15 }, { 15, 12, 0 } }));
  EXPECT_NE(
    checked(cutSquares(4, true)).find("valid (vertices not extreme: 12"), std::string::npos);
  EXPECT_EQ(checked({}), "empty");
  EXPECT_EQ(checked({ { 0, 3, 15 } }),
    "extreme points missing: 1 of 4; border edges with points beyond: 1");
  EXPECT_EQ(checked({ { 0, 3, 15, 12 }, { 0, 3, 15, 12 } }), "times that the whole is covered: 2");
}

TEST(PeerCheck, DoesNotCheckWhatSpansNoPlane)
{
  const Cloud line = { { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 } };
  EXPECT_FALSE(checkHull(viewOf(line), outputOf(line, {})).possible);
  EXPECT_FALSE(checkDelaunay(viewOf(line), outputOf(line, {})).possible);
}

std::string checkedInPlane(const Cloud& cloud, const std::vector<Cell>& cells)
{
  const PeerReport found = checkDelaunay(viewOf(cloud), outputOf(cloud, cells));
  const std::string text = describeDelaunay(found);
  EXPECT_EQ(found.isValid(), text.compare(0, 5, "valid") == 0) << text;
  return text;
}

/// A cloud in the plane, without weights.
Cloud unweighted(const char* family, int count)
{
  Cloud cloud = fromWeightedFamily(family, count, 3).make();
  for (Point& p : cloud)
  {
    p[2] = 0;
  }
  return cloud;
}

TEST(PeerCheck, AcceptsAnyDelaunayTriangulation)
{
  for (const char* family : { "uniform", "smallIntegers", "doubled", "wheel", "far8", "clusters" })
  {
    SCOPED_TRACE(family);
    const Cloud cloud = unweighted(family, 500);
    const std::vector<Cell> polygons = cgalTriangulation(cloud, kernelForWeighted(cloud)).cells;
    EXPECT_EQ(checkedInPlane(cloud, polygons), "valid");
    EXPECT_EQ(checkedInPlane(cloud, triangulate(polygons)), "valid");
  }
  for (const bool byTurns : { true, false })
  {
    std::vector<Cell> cells = cutSquares(9, byTurns);
    EXPECT_EQ(checkedInPlane(flatGrid(9), cells), "valid");
    std::reverse(cells[5].begin(), cells[5].end());
    EXPECT_EQ(checkedInPlane(flatGrid(9), cells), "valid");
  }
}

TEST(PeerCheck, NoticesWhatIsNotDelaunay)
{
  const Cloud cloud = unweighted("uniform", 100);
  const std::vector<Cell> right =
    triangulate(cgalTriangulation(cloud, kernelForWeighted(cloud)).cells);
  const PeerReport found = checkDelaunay(viewOf(cloud), outputOf(cloud, withEdgeFlipped(right)));
  EXPECT_EQ(found.faults.beyond, 2);
  EXPECT_FALSE(found.isValid());
}

TEST(PeerCheck, NoticesMissingPointsAndGapsInThePlane)
{
  const Cloud grid = flatGrid(5);
  const std::vector<Cell> right = cutSquares(5, false);
  // The corner at 24 and its triangles; one triangle amid the others; one at the border.
  EXPECT_EQ(checkedInPlane(grid, changed(right, [](std::vector<Cell>& c) { c.resize(30); })),
    "points missing: 1 of 25; triangles missing: 2 of 32; border edges inside: 2");
  EXPECT_EQ(
    checkedInPlane(grid, changed(right, [](std::vector<Cell>& c) { c.erase(c.begin() + 12); })),
    "only gaps: triangles missing: 1 of 32; border edges inside: 3");
  EXPECT_EQ(
    checkedInPlane(grid, changed(right, [](std::vector<Cell>& c) { c.erase(c.begin() + 2); })),
    "only gaps: triangles missing: 1 of 32; border edges inside: 2");
  EXPECT_EQ(checkedInPlane(grid, {}), "empty");
}

TEST(PeerCheck, NoticesWhatLiesUponEachOtherInThePlane)
{
  const std::vector<Cell> right = cutSquares(5, false);
  std::vector<Cell> twice = right;
  twice.insert(twice.end(), right.begin(), right.end());
  EXPECT_EQ(checkedInPlane(flatGrid(5), twice), "times that the whole is covered: 2");
  twice.resize(right.size() + 13);
  EXPECT_NE(checkedInPlane(flatGrid(5), twice), "valid");
}

}
}
}
