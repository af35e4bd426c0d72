// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where rounding moves corners past each other, cells are simple polygons all the same, and fill
/// the box edge to edge. In exact arithmetic, on sites that lie as badly as rounded data do.
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/Inputs/InputsRounded.h"
#include "Testing/Engine/PowerDiagram/PowerPolygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include <gmpxx.h>

namespace flipflop
{
namespace test
{

namespace
{

/// How far beyond its true border a cell may reach: units in the last place of a corner's greater
/// coordinate.
constexpr double MostUnits = 16;

/// Some sites, and where to clip.
struct Case
{
  Cloud sites;
  std::array<double, 4> box;
};

std::array<double, 4> boundsOf(const Cloud& sites)
{
  std::array<double, 4> box = { HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL };
  for (const Point& p : sites)
  {
    for (int k = 0; k < 2; ++k)
    {
      box[2 * k] = std::min(box[2 * k], p[k]);
      box[2 * k + 1] = std::max(box[2 * k + 1], p[k]);
    }
  }
  return box;
}

/// The bounds of the sites, wider or narrower by chance.
std::array<double, 4> boxFor(const Cloud& sites, Random& random)
{
  std::array<double, 4> box = boundsOf(sites);
  const int kind = random.integer(0, 2);
  for (int k = 0; k < 4; k += 2)
  {
    const double size = box[k + 1] - box[k];
    const double inwards = kind == 0 ? 0 : kind == 1 ? -1 : random.uniform(0, 0.45);
    box[k] += inwards * size;
    box[k + 1] -= inwards * size;
    if (!(box[k] < box[k + 1]))
    {
      const double more = 1 + std::fabs(box[k]);
      box[k] -= more;
      box[k + 1] += more;
    }
  }
  return box;
}

/// A diagram against what it promises; the first fault in words, or nothing.
class Judge
{
public:
  Judge(const PowerDiagram& diagram, const Case& input)
    : diagram(diagram)
    , input(input)
    , corners(pointsOf(diagram, input.box))
    , space(corners)
  {
  }

  std::string fault() const
  {
    std::set<std::pair<double, double>> positions;
    for (std::size_t i = 0; i + 4 < this->corners.size(); ++i)
    {
      if (!positions.insert({ this->corners[i][0], this->corners[i][1] }).second)
      {
        return "a position has two numbers";
      }
    }
    for (std::size_t c = 0; c < this->diagram.siteIds.size(); ++c)
    {
      const std::string which = ", cell of site " + std::to_string(this->diagram.siteIds[c]);
      const std::vector<int> ring = this->ringOf(c);
      if (std::set<int>(ring.begin(), ring.end()).size() != ring.size() || ring.size() < 3)
      {
        return "a corner twice, or fewer than three" + which;
      }
      if (!this->isSimple(ring))
      {
        return "not simple" + which;
      }
      if (this->twiceArea(ring) <= 0)
      {
        return "not counter-clockwise" + which;
      }
      if (this->reachesTooFar(c))
      {
        return "beyond its border" + which;
      }
    }
    return this->edgesFault();
  }

private:
  /// And the corners of the box, last.
  static Cloud pointsOf(const PowerDiagram& diagram, const std::array<double, 4>& box)
  {
    Cloud points;
    for (std::size_t i = 0; i < diagram.corners.size(); i += 2)
    {
      points.push_back({ diagram.corners[i], diagram.corners[i + 1], 0 });
    }
    for (const auto& k : { std::array<int, 2>{ 0, 2 }, { 1, 2 }, { 1, 3 }, { 0, 3 } })
    {
      points.push_back({ box[k[0]], box[k[1]], 0 });
    }
    return points;
  }

  std::vector<int> ringOf(std::size_t cell) const
  {
    return std::vector<int>(this->diagram.connectivity.begin() + this->diagram.offsets[cell],
      this->diagram.connectivity.begin() + this->diagram.offsets[cell + 1]);
  }

  int orientation(int a, int b, int c) const { return this->space.normal(2, a, b, c); }

  /// Is @p p, on the line of a and b, between them or one of them?
  bool isBetween(int a, int b, int p) const
  {
    const Cloud& x = this->corners;
    return std::min(x[a], x[b]) <= x[p] && x[p] <= std::max(x[a], x[b]);
  }

  bool isSimple(const std::vector<int>& ring) const
  {
    const std::size_t count = ring.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      const int a = ring[i];
      const int b = ring[(i + 1) % count];
      const int next = ring[(i + 2) % count];
      if (this->orientation(a, b, next) == 0 && !this->isBetween(a, next, b))
      {
        return false;
      }
      for (std::size_t j = i + 2; j < count; ++j)
      {
        const int c = ring[j];
        const int d = ring[(j + 1) % count];
        if (d == a)
        {
          continue;
        }
        const int side[] = { this->orientation(a, b, c), this->orientation(a, b, d),
          this->orientation(c, d, a), this->orientation(c, d, b) };
        if ((side[0] == 0 && this->isBetween(a, b, c)) ||
          (side[1] == 0 && this->isBetween(a, b, d)) ||
          (side[2] == 0 && this->isBetween(c, d, a)) ||
          (side[3] == 0 && this->isBetween(c, d, b)) ||
          (side[0] * side[1] < 0 && side[2] * side[3] < 0))
        {
          return false;
        }
      }
    }
    return true;
  }

  mpq_class twiceArea(const std::vector<int>& ring) const
  {
    mpq_class area = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const Point& a = this->corners[ring[i]];
      const Point& b = this->corners[ring[(i + 1) % ring.size()]];
      area += mpq_class(a[0]) * mpq_class(b[1]) - mpq_class(a[1]) * mpq_class(b[0]);
    }
    return area;
  }

  /// Inside, every edge is there once in either direction; on the box, end to end.
  std::string edgesFault() const
  {
    std::set<std::pair<int, int>> edges;
    mpq_class area = 0;
    for (std::size_t c = 0; c < this->diagram.siteIds.size(); ++c)
    {
      const std::vector<int> ring = this->ringOf(c);
      area += this->twiceArea(ring);
      for (std::size_t i = 0; i < ring.size(); ++i)
      {
        if (!edges.insert({ ring[i], ring[(i + 1) % ring.size()] }).second)
        {
          return "an edge twice in one direction";
        }
      }
    }
    std::map<Point, Point> border;
    for (const auto& edge : edges)
    {
      if (edges.count({ edge.second, edge.first }) == 0 &&
        !border.emplace(this->corners[edge.first], this->corners[edge.second]).second)
      {
        return "two edges of the border leave one place";
      }
    }
    const int box = static_cast<int>(this->corners.size()) - 4;
    Point at = this->corners[box];
    for (int side = 0; side < 4; ++side)
    {
      const Point& end = this->corners[box + (side + 1) % 4];
      const int axis = side % 2;
      const double sign = side < 2 ? 1 : -1;
      while (at != end)
      {
        const auto next = border.find(at);
        if (next == border.end() || next->second[1 - axis] != at[1 - axis] ||
          !(sign * at[axis] < sign * next->second[axis]))
        {
          return "the border has a gap, or an edge has no other side";
        }
        at = next->second;
        border.erase(next);
      }
    }
    if (!border.empty())
    {
      return "an edge has no other side";
    }
    return area == this->twiceArea({ box, box + 1, box + 2, box + 3 }) ? ""
                                                                       : "not the area of the box";
  }

  /// Is a corner too far on the wrong side of the line of equal power to some site?
  bool reachesTooFar(std::size_t cell) const
  {
    const Point& mine = this->input.sites[static_cast<std::size_t>(this->diagram.siteIds[cell])];
    for (const int corner : this->ringOf(cell))
    {
      const Point& x = this->corners[corner];
      const double size = std::max(std::fabs(x[0]), std::fabs(x[1]));
      const double limit = MostUnits * (size - std::nextafter(size, 0));
      for (const Point& other : this->input.sites)
      {
        const long double u = static_cast<long double>(x[0]) - mine[0];
        const long double v = static_cast<long double>(x[1]) - mine[1];
        const long double s = static_cast<long double>(x[0]) - other[0];
        const long double t = static_cast<long double>(x[1]) - other[1];
        const double length = 2 * std::hypot(other[0] - mine[0], other[1] - mine[1]);
        const long double beyond = u * u + v * v - mine[2] - (s * s + t * t - other[2]);
        const long double error =
          0x1p-60L * (u * u + v * v + s * s + t * t + std::fabs(mine[2]) + std::fabs(other[2]));
        if (beyond + error > limit * length && length > 0 &&
          exactlyBeyond(x, mine, other) > mpq_class(limit * length))
        {
          return true;
        }
      }
    }
    return false;
  }

  /// How much greater the power to @p mine is.
  static mpq_class exactlyBeyond(const Point& x, const Point& mine, const Point& other)
  {
    const auto power = [&x](const Point& site) -> mpq_class
    {
      const mpq_class u = mpq_class(x[0]) - mpq_class(site[0]);
      const mpq_class v = mpq_class(x[1]) - mpq_class(site[1]);
      return u * u + v * v - mpq_class(site[2]);
    };
    return power(mine) - power(other);
  }

  const PowerDiagram& diagram;
  const Case& input;
  const Cloud corners;
  const FilteredSpace space;
};

PowerDiagram diagramOf(const Case& input, FacetMode facets = FacetMode::Polygons)
{
  Options options;
  options.facets = facets;
  const Triangulation triangulation =
    regularTriangulation(viewOf(input.sites), weightsOf(input.sites), options);
  return powerDiagram(viewOf(input.sites), weightsOf(input.sites), triangulation, input.box.data());
}

/// Does any cell have a corner that turns right?
bool hasReflexCorner(const PowerDiagram& diagram)
{
  const auto polygons = polygonsOf(diagram);
  return std::any_of(polygons.begin(), polygons.end(),
    [](const std::pair<const std::int64_t, Polygon>& cell)
    {
      Cloud corners;
      for (const auto& x : cell.second)
      {
        corners.push_back({ x[0], x[1], 0 });
      }
      const FilteredSpace space(corners);
      const int count = space.size();
      for (int i = 0; i < count; ++i)
      {
        if (space.normal(2, i, (i + 1) % count, (i + 2) % count) < 0)
        {
          return true;
        }
      }
      return false;
    });
}

class PowerDiagramRounding : public testing::TestWithParam<const char*>
{
};

TEST_P(PowerDiagramRounding, CellsAreSimpleAndFillTheBox)
{
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
  {
    Random random(seed);
    const int count = seed % 30 == 0 ? 400 : random.integer(3, 60);
    Case input;
    input.sites = fromFamilies(roundedFamilies(), GetParam(), count, seed).make();
    input.box = boxFor(input.sites, random);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", sites " + std::to_string(count));
    const PowerDiagram diagram = diagramOf(input);
    ASSERT_EQ(Judge(diagram, input).fault(), "");
    // Fans of triangles in place of polygons change nothing.
    ASSERT_EQ(polygonsOf(diagramOf(input, FacetMode::Triangles)), polygonsOf(diagram));
  }
}

std::vector<const char*> namesOf(const std::vector<Family>& list)
{
  std::vector<const char*> names;
  for (const Family& family : list)
  {
    names.push_back(family.name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(Families, PowerDiagramRounding,
  testing::ValuesIn(namesOf(roundedFamilies())),
  [](const testing::TestParamInfo<const char*>& family) { return std::string(family.param); });

TEST(PowerDiagramRounding, NoCellOfACircleIsLost)
{
  // The tips of its cells cross near the center; further out they are wide.
  for (int count = 480; count <= 510; count += 10)
  {
    SCOPED_TRACE(count);
    const Case input = { circleAt(count, 1e3, 1e3), { 998, 1002, 998, 1002 } };
    const PowerDiagram diagram = diagramOf(input);
    EXPECT_EQ(Judge(diagram, input).fault(), "");
    EXPECT_EQ(diagram.siteIds.size(), input.sites.size());
  }
}

TEST(PowerDiagramRounding, ABoxAlongTheCells)
{
  // Sides of the box run along edges that are not quite straight, and corners just outside of it
  // are rounded to it.
  for (std::uint64_t seed = 1; seed <= 200; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double noise = std::ldexp(1.0, -random.integer(48, 56));
    Case input;
    const double origin = random.integer(0, 3);
    for (int i = 0; i < 36; ++i)
    {
      input.sites.push_back({ origin + i % 6 + random.uniform(-noise, noise),
        origin + i / 6 + random.uniform(-noise, noise), 0 });
    }
    const double low = origin + random.integer(-1, 2) + 0.5;
    const double high = origin + random.integer(3, 5) + 0.5;
    input.box = { low, high, low, high };
    const PowerDiagram diagram = diagramOf(input);
    EXPECT_EQ(Judge(diagram, input).fault(), "");
    const double side = std::min(high, origin + 5.5) - std::max(low, origin - 0.5);
    EXPECT_GE(diagram.siteIds.size(), static_cast<std::size_t>(side * side));
  }
}

TEST(PowerDiagramRounding, CellsOfARotatedGridAreConvex)
{
  // Each vertex of the grid is two corners or one; an edge of a unit or two has any direction.
  for (int step = 1; step <= 15; ++step)
  {
    SCOPED_TRACE(step);
    const double a = angleOf(0.053 * step);
    Case input;
    for (int i = 0; i < 15 * 15; ++i)
    {
      const double u = i % 15;
      const double v = i / 15;
      input.sites.push_back(
        { u * std::cos(a) - v * std::sin(a), u * std::sin(a) + v * std::cos(a), 0 });
    }
    input.box = boundsOf(input.sites);
    const PowerDiagram diagram = diagramOf(input);
    EXPECT_FALSE(hasReflexCorner(diagram));
    EXPECT_EQ(Judge(diagram, input).fault(), "");
  }
}

}
}
}
