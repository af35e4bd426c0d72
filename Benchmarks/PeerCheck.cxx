// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PeerCheck.h"

#include "Run/HullRun.h"
#include "Run/TriangulationRun.h"
#include <flipflop/ConvexHull.h>
#include <flipflop/RegularTriangulation.h>
#include <flipflop/Validate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <stdexcept>
#include <unordered_map>

namespace flipflop
{
namespace
{

using Position = std::array<double, 3>;

struct PositionHash
{
  std::size_t operator()(const Position& position) const
  {
    std::size_t result = 0;
    for (const double x : position)
    {
      result = result * 0x9e3779b97f4a7c15ull + std::hash<double>()(x);
      result ^= result >> 29;
    }
    return result;
  }
};

/// The positions as they are compared, rounded if the output is.
Position positionOf(const double* x, bool rounded)
{
  Position position;
  for (std::size_t i = 0; i < 3; ++i)
  {
    // Zero has one sign.
    position[i] = 0.0 + (rounded ? static_cast<double>(static_cast<float>(x[i])) : x[i]);
  }
  return position;
}

/// The input ids of the output's points, NoIndex where there is none: of those at a position the
/// extreme one, else the lowest.
std::vector<std::uint32_t> identify(
  const PointSource& source, const CellComplex& truth, const PeerOutput& output)
{
  std::unordered_map<Position, std::uint32_t, PositionHash> ids;
  for (std::size_t i = 0; i < output.points.size(); i += 3)
  {
    ids.emplace(positionOf(&output.points[i], output.rounded), NoIndex);
  }
  const auto note = [&](std::uint32_t id)
  {
    double x[3];
    source.load(id, x);
    const auto found = ids.find(positionOf(x, output.rounded));
    if (found != ids.end() && found->second == NoIndex)
    {
      found->second = id;
    }
  };
  for (const std::int64_t id : truth.pointIds)
  {
    note(static_cast<std::uint32_t>(id));
  }
  for (std::uint32_t id = 0; id < source.count(); ++id)
  {
    note(id);
  }
  std::vector<std::uint32_t> result;
  for (std::size_t i = 0; i < output.points.size(); i += 3)
  {
    result.push_back(ids[positionOf(&output.points[i], output.rounded)]);
  }
  return result;
}

/// The cells as fans; those with unknownCorners are counted and left out.
std::vector<SurfaceTriangle> fansOf(
  const PeerOutput& output, const std::vector<std::uint32_t>& ids, std::int64_t& unknownCorners)
{
  std::vector<SurfaceTriangle> fans;
  for (std::size_t cell = 0; cell + 1 < output.offsets.size(); ++cell)
  {
    const auto corner = [&](std::int64_t i) {
      return ids.at(static_cast<std::size_t>(output.connectivity.at(static_cast<std::size_t>(i))));
    };
    const std::int64_t begin = output.offsets[cell];
    bool known = true;
    for (std::int64_t i = begin; i < output.offsets[cell + 1]; ++i)
    {
      known = known && corner(i) != NoIndex;
    }
    unknownCorners += known ? 0 : 1;
    for (std::int64_t i = begin + 2; known && i < output.offsets[cell + 1]; ++i)
    {
      fans.push_back({ corner(begin), corner(i - 1), corner(i) });
    }
  }
  return fans;
}

/// The check compares only with what validate() has passed.
void requireSound(const Validation& validation)
{
  if (!validation)
  {
    throw std::logic_error(std::string("the check's own result: ") + describe(validation.fault));
  }
}

Options inPolygons()
{
  Options options;
  options.facets = FacetMode::Polygons;
  return options;
}

Hull exactHull(const PointView& points)
{
  Hull truth = convexHull(points, inPolygons());
  requireSound(validate(points, truth));
  return truth;
}

/// The points with one more, off the plane in which they all lie.
std::vector<double> withApex(const PointView& points, const Hull& polygon)
{
  PointSource source(points);
  std::vector<double> result(3 * static_cast<std::size_t>(points.count));
  double extent = 0;
  for (std::uint32_t id = 0; id < source.count(); ++id)
  {
    source.load(id, &result[3 * id]);
    for (std::size_t i = 0; i < 3; ++i)
    {
      extent = std::max(extent, std::fabs(result[3 * id + i] - result[i]));
    }
  }
  const double* corner[3];
  for (std::size_t k = 0; k < 3; ++k)
  {
    corner[k] = &result[3 * static_cast<std::size_t>(polygon.pointIds[polygon.connectivity[k]])];
  }
  // Along an axis that the plane does not contain, any step leaves it.
  Position normal;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    normal[i] = std::fabs((corner[1][j] - corner[0][j]) * (corner[2][k] - corner[0][k]) -
      (corner[1][k] - corner[0][k]) * (corner[2][j] - corner[0][j]));
  }
  const auto axis =
    static_cast<std::size_t>(std::max_element(normal.begin(), normal.end()) - normal.begin());
  Position apex = { corner[0][0], corner[0][1], corner[0][2] };
  apex[axis] += extent;
  result.insert(result.end(), apex.begin(), apex.end());
  return result;
}

using HullCheck = SurfaceCheck<HullGeometry>;

/// How far p is from the plane of abc at least, whatever rounding does: 0 for all slivers.
double leastDistance(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p)
{
  double offset[3] = { 0, 0, 0 };
  const Vertex* const to[3] = { &b, &c, &p };
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      offset[k] = std::max(offset[k], std::fabs(to[k]->x[i] - a.x[i]));
    }
  }
  const double sides = offset[0] * offset[1];
  double normal[3];
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    normal[i] =
      std::fabs((b.x[j] - a.x[j]) * (c.x[k] - a.x[k]) - (b.x[k] - a.x[k]) * (c.x[j] - a.x[j])) +
      DeterminantError * sides;
  }
  const double height = std::fabs(HullGeometry::heightAbove(a, b, c, p));
  return std::max(0.0, height - DeterminantError * sides * offset[2]) /
    std::hypot(normal[0], normal[1], normal[2]);
}

/// The points outside the hull of those that the output uses: how many, unless it takes too long,
/// and how far.
void findOutside(const HullCheck& check, const HullGeometry& geometry, const PointSource& source,
  const std::vector<SurfaceTriangle>& fans, PeerReport& result)
{
  constexpr double MostTests = 1e10;
  std::vector<bool> used(source.count());
  for (const SurfaceTriangle& t : fans)
  {
    for (const std::uint32_t id : t)
    {
      used[id] = true;
    }
  }
  std::vector<std::uint32_t> ids;
  std::vector<double> chosen;
  for (std::uint32_t id = 0; id < source.count(); ++id)
  {
    if (used[id])
    {
      ids.push_back(id);
      chosen.resize(chosen.size() + 3);
      source.load(id, chosen.data() + chosen.size() - 3);
    }
  }
  const auto chosenCount = static_cast<std::int64_t>(ids.size());
  const Hull hull = convexHull(PointView(chosen.data(), chosenCount), inPolygons());
  if (hull.dimension < 3)
  {
    return; // no output of interest
  }
  // What is outside is beyond a facet that is none of all points' hull.
  std::vector<std::array<Vertex, 3>> facets;
  for (std::int64_t cell = 0; cell < hull.cellCount(); ++cell)
  {
    SurfaceTriangle t;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::int64_t corner =
        hull.connectivity[static_cast<std::size_t>(hull.cellBegin(cell)) + k];
      t[k] = ids[static_cast<std::size_t>(hull.pointIds[static_cast<std::size_t>(corner)])];
    }
    if (!check.supports(t))
    {
      facets.push_back({ source.vertex(t[0]), source.vertex(t[1]), source.vertex(t[2]) });
    }
  }
  if (static_cast<double>(facets.size()) * source.count() > MostTests)
  {
    return;
  }
  for (std::uint32_t id = 0; id < source.count(); ++id)
  {
    const Vertex p = source.vertex(id);
    double farthest = -1;
    for (const std::array<Vertex, 3>& t : facets)
    {
      if (!used[id] && geometry.above(t[0], t[1], t[2], p) > 0)
      {
        farthest = std::max(farthest, leastDistance(t[0], t[1], t[2], p));
      }
    }
    result.outside += farthest < 0 ? 0 : 1;
    result.farthest = std::max(result.farthest, farthest);
  }
}

PeerReport impossible()
{
  PeerReport report;
  report.possible = false;
  return report;
}

/// @param apex as SurfaceCheck's; a point of the truth that the output cannot have
PeerReport checkSolid(const PointView& points, const PeerOutput& output, const std::uint32_t* apex)
{
  PeerReport result;
  const Hull truth = exactHull(points);
  HullRun run(points, Options());
  run.execute<Hull>(
    [&](Hull& scratch)
    {
      run.inspect(scratch);
      const HullCheck check(run.geometry, run.source, truth, apex);
      const std::vector<SurfaceTriangle> fans =
        fansOf(output, identify(run.source, truth, output), result.unknownCorners);
      result.faults = check.check(fans);
      if (result.faults.missing && !apex)
      {
        findOutside(check, run.geometry, run.source, fans, result);
        result.farthest /= std::max({ run.range.high[0] - run.range.low[0],
          run.range.high[1] - run.range.low[1], run.range.high[2] - run.range.low[2] });
      }
    });
  return result;
}

std::string counted(std::int64_t number)
{
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3)
  {
    digits.insert(i - 3, ",");
  }
  return digits;
}

/// Numbers that are not zero, by name.
class Findings
{
public:
  void add(const char* name, std::int64_t number, std::int64_t of = 0)
  {
    if (number > 0)
    {
      this->text += std::string(this->text.empty() ? "" : "; ") + name + ": " + counted(number);
      this->text += of ? " of " + counted(of) : "";
    }
  }
  std::string text;
};

std::string describe(const PeerReport& report, Findings& faults, const Findings& remarks)
{
  if (!report.possible)
  {
    return "not checked: the points span too little";
  }
  if (!report.faults.triangles && !report.unknownCorners)
  {
    return "empty";
  }
  if (report.isValid())
  {
    return "valid" + (remarks.text.empty() ? "" : " (" + remarks.text + ")");
  }
  faults.add("cells with a corner that is no input point", report.unknownCorners);
  if (faults.text.empty())
  {
    faults.text = "times that the whole is covered: " + counted(report.faults.sheets);
  }
  return faults.text;
}

}

std::int64_t PeerOutput::vertexCount() const
{
  std::vector<bool> used(this->points.size() / 3);
  for (const std::int64_t corner : this->connectivity)
  {
    used.at(static_cast<std::size_t>(corner)) = true;
  }
  return std::count(used.begin(), used.end(), true);
}

PeerReport checkHull(const PointView& points, const PeerOutput& output)
{
  const Hull truth = exactHull(points);
  if (truth.dimension < 2)
  {
    return impossible();
  }
  if (truth.dimension == 3)
  {
    return checkSolid(points, output, nullptr);
  }
  const auto apex = static_cast<std::uint32_t>(points.count);
  const std::vector<double> solid = withApex(points, truth);
  return checkSolid(PointView(solid.data(), points.count + 1), output, &apex);
}

PeerReport checkDelaunay(const PointView& points, const PeerOutput& output)
{
  PeerReport result;
  const Triangulation truth = regularTriangulation(points, WeightView(), inPolygons());
  requireSound(validate(points, WeightView(), truth));
  if (truth.dimension < 2)
  {
    return impossible();
  }
  TriangulationRun<false> run(points, WeightView(), Options());
  run.execute<Triangulation>(
    [&](Triangulation& scratch)
    {
      run.inspect(scratch.statistics);
      const std::uint32_t apex = NoIndex;
      const SurfaceCheck<LiftedGeometry<false>> check(run.geometry, run.source, truth, &apex);
      result.faults =
        check.check(fansOf(output, identify(run.source, truth, output), result.unknownCorners));
    });
  return result;
}

std::string describeHull(const PeerReport& report)
{
  const SurfaceFaults& found = report.faults;
  Findings faults;
  faults.add("extreme points missing", found.missing, found.extreme);
  faults.add("points outside", report.outside);
  if (report.farthest > 1e-15)
  {
    char extent[64];
    std::snprintf(extent, sizeof(extent), " (by up to %.1e of the extent)", report.farthest);
    faults.text += extent;
  }
  else if (report.outside)
  {
    faults.text += " (by rounding errors)";
  }
  faults.add("facets with points beyond", found.beyond, found.triangles);
  faults.add("border edges with points beyond", found.borderBeyond);
  faults.add("open edges", found.openEdges);
  faults.add("folded edges", found.beyond ? 0 : found.foldedEdges);
  Findings remarks;
  remarks.add("vertices not extreme", found.notExtreme);
  remarks.add("facets without area", found.withoutArea);
  remarks.add("facets turned inwards", found.turnedInwards);
  return describe(report, faults, remarks);
}

std::string describeDelaunay(const PeerReport& report)
{
  const SurfaceFaults& found = report.faults;
  const std::int64_t right = found.triangles - found.withoutArea - found.beyond;
  Findings faults;
  faults.add("points missing", found.missing, found.extreme);
  faults.add("circles not empty", found.beyond, found.triangles);
  const bool onlyGaps = faults.text.empty() && !report.unknownCorners && right < found.needed;
  faults.add("triangles missing", found.needed - right, found.needed);
  faults.add("border edges inside", found.borderBeyond);
  faults.text = (onlyGaps ? "only gaps: " : "") + faults.text;
  Findings remarks;
  remarks.add("triangles without area", found.withoutArea);
  return describe(report, faults, remarks);
}

}
