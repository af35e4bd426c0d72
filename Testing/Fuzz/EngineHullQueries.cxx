// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EngineCalls.h"
#include "EngineQueries.h"

#include "Testing/Engine/Query/QueryCases.h"
#include "Testing/Engine/Query/ReferenceDistance.h"
#include <flipflop/Certificate.h>
#include <flipflop/HullQueries.h>
#include <flipflop/Neighbors.h>

#include <cmath>

namespace flipflop
{
namespace fuzz
{

namespace
{

/// Up to so many points, brute force in integers is quick.
constexpr std::size_t FewPoints = 20;

Cloud finiteOf(const Cloud& cloud)
{
  Cloud finite;
  for (const Point& p : cloud)
  {
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]))
    {
      finite.push_back(p);
    }
  }
  return finite;
}

/// The ids of the hull's points, or -1.
void demandIds(const std::vector<std::int64_t>& ids, const Hull& hull)
{
  for (const std::int64_t id : ids)
  {
    demand(id == -1 || std::binary_search(hull.pointIds.begin(), hull.pointIds.end(), id),
      "an id that the hull has not");
  }
}

void demandBox(const OrientedBox& box, int dimension)
{
  demand(box.lowerBound <= box.volume, "the box is less than a box can be");
  demand((box.lengths[0] > 0) == (dimension > 0), "a box without a length, or a length of nothing");
  for (int i = 0; i < 3; ++i)
  {
    const double* const a = box.axes[i];
    const double* const b = box.axes[(i + 1) % 3];
    const double* const c = box.axes[(i + 2) % 3];
    double square = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double third = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
      demand(std::fabs(third - c[k]) < 1e-14, "axes that are not right-handed");
      square += a[k] * a[k];
    }
    demand(std::fabs(square - 1) < 1e-14, "an axis whose length is not one");
    demand(i == 0 || box.lengths[i] <= box.lengths[i - 1], "a longer side after a shorter one");
  }
}

/// By every cell.
void demandDistances(const Hull& polygons, const Cloud& cloud, const Cloud& queries,
  const std::vector<double>& distances)
{
  constexpr std::size_t Most = 60; // the last ones: the first are any points
  const auto cells = test::cornersOf(polygons, cloud);
  for (std::size_t i = queries.size() - std::min(Most, queries.size()); i < queries.size(); ++i)
  {
    test::Real least, farthest;
    test::squaresFromCells(cells, test::exactly(queries[i]), least, farthest);
    demand((polygons.dimension == 3 && distances[i] == 0) ||
        test::isDistance(distances[i], least, farthest),
      "a distance is off by more than is promised");
  }
}

/// The questions about the plane: of the points as places.
void judgePlane(const Cloud& cloud, const Cloud& queries, const Options& options)
{
  Cloud flat = cloud;
  Cloud places = queries;
  for (Cloud* points : { &flat, &places })
  {
    for (Point& p : *points)
    {
      p[2] = 0;
    }
  }
  const Options plain = unwatched(options);
  const Hull polygon = test::hullOf(flat, FacetMode::Polygons);
  const HullQueries plane(test::viewOf(cloud), polygon, plain, PointSpace::Plane);
  demandBox(plane.minimalBox(plain), polygon.dimension);
  std::vector<std::int8_t> sides(queries.size());
  std::vector<double> distances(queries.size());
  const auto asked = attempt(
    [&]
    {
      plane.contains(test::viewOf(queries), sides.data(), plain);
      plane.distance(test::viewOf(queries), distances.data(), plain);
      return 0;
    });
  if (!asked.result || cloud.empty() || cloud.size() > FewPoints ||
    queries.size() > 10 * FewPoints || findNonFinite(places).count > 0)
  {
    return;
  }
  const std::vector<std::int8_t> inHull = test::sidesByBruteForce(flat, polygon, places);
  std::vector<std::vector<test::Vector>> edges;
  const std::vector<test::Vector> ring = test::cornersOf(polygon, flat)[0];
  for (std::size_t k = 0; k < ring.size(); ++k)
  {
    edges.push_back({ ring[k], ring[(k + 1) % ring.size()] });
  }
  for (std::size_t i = 0; i < queries.size(); ++i)
  {
    test::Real least, farthest;
    const test::Vector x = test::exactly(places[i]);
    test::squaresFromCells(edges, x, least, farthest);
    const int side = inHull[i] < 0 ? -1 : test::isOnBorder(edges, x) ? 0 : 1;
    demand(sides[i] == side, "on another side in the plane");
    demand((side == 0) == (distances[i] == 0) && (side > 0) == (distances[i] < 0),
      "the distance is not on the side of the place");
    demand(test::isDistance(distances[i], least, farthest),
      "a distance in the plane is off by more than is promised");
  }
}

/// Every answer about the hull of some finite points, beside brute force where points are few.
/// @param options with somebody who watches one kind of question
void judgeQueries(const HullQueries& asked, const Hull& hull, const Cloud& cloud,
  const Cloud& queries, const Options& options, const Watch& watch, int watchedKind)
{
  const auto of = [&](int kind) { return kind == watchedKind ? options : unwatched(options); };
  const Watch none;
  const auto watchOf = [&](int kind) -> const Watch& { return kind == watchedKind ? watch : none; };
  const PointView places = test::viewOf(queries);
  const auto sides = answersTo<std::int8_t>(queries, 3, 1, of(0), watchOf(0),
    [&](std::int8_t* to, const Options& chosen) { asked.contains(places, to, chosen); });
  const auto distances = answersTo<double>(queries, 3, 1, of(1), watchOf(1),
    [&](double* to, const Options& chosen) { asked.distance(places, to, chosen); });
  const auto farthest = answersTo<std::int64_t>(queries, 3, 1, of(2), watchOf(2),
    [&](std::int64_t* to, const Options& chosen) { asked.support(places, to, chosen); });
  demandIds(farthest, hull);

  const auto diameter = attempt([&] { return asked.diameter(of(3)); });
  expectOutcome(diameter, watchOf(3), {});
  const auto box = attempt([&] { return asked.minimalBox(of(4)); });
  expectOutcome(box, watchOf(4), {});
  const Diameter longest = asked.diameter(unwatched(options));
  const OrientedBox least = asked.minimalBox(unwatched(options));
  demand(!diameter.result || std::memcmp(&*diameter.result, &longest, sizeof longest) == 0,
    "the diameter depends on the number of threads");
  demand(!box.result || std::memcmp(&*box.result, &least, sizeof least) == 0,
    "the box depends on the number of threads");
  demandBox(least, hull.dimension);

  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const Point& p = queries[i];
    const bool finite = std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
    const double d = distances[i];
    demand(!finite     ? std::isnan(d)
        : sides[i] > 0 ? d < 0
        : sides[i] < 0 ? d > 0
                       : d == 0,
      "the distance is not on the side of the point");
  }
  if (sides.empty() || cloud.empty() || cloud.size() > FewPoints ||
    queries.size() > 10 * FewPoints || findNonFinite(queries).count > 0)
  {
    return;
  }
  const Hull polygons = test::hullOf(cloud, FacetMode::Polygons);
  demand(sides == test::sidesByBruteForce(cloud, polygons, queries), "on another side");
  demand(farthest == test::farthestByBruteForce(cloud, hull, queries), "not the farthest");
  demandDistances(polygons, cloud, queries, distances);
  const test::FarthestIds pair = test::farthestPairByBruteForce(cloud, hull);
  demand(longest.first == pair.first && longest.second == pair.second, "not the diameter");
}

/// Neighbours are so of each other.
void demandNeighbors(const CellComplex& complex, const Buffer<std::int64_t>& neighbors)
{
  demand(neighbors.size() == complex.connectivity.size(), "not a neighbour for each corner");
  for (std::int64_t cell = 0; cell < complex.cellCount(); ++cell)
  {
    for (std::int64_t k = complex.cellBegin(cell); k < complex.cellBegin(cell + 1); ++k)
    {
      const std::int64_t other = neighbors[static_cast<std::size_t>(k)];
      demand(other >= -1 && other < complex.cellCount(), "a neighbour out of range");
      if (other >= 0)
      {
        const std::int64_t* begin = neighbors.data() + complex.cellBegin(other);
        const std::int64_t* end = neighbors.data() + complex.cellBegin(other + 1);
        demand(std::find(begin, end, cell) != end, "a neighbour that does not return it");
      }
    }
  }
}

}

void fuzzHullQueries(Bytes& bytes)
{
  Watch watch;
  const Options options = drawOptions(bytes, watch);
  const int kind = bytes.below(6); // of the question that is watched; 5: none but the making
  const bool corrupted = bytes.oneOf(3);
  const Cloud cloud = finiteOf(drawCloud(bytes, 200));
  const PointView points = test::viewOf(cloud);
  Hull hull = convexHull(points, unwatched(options));
  if (corrupted)
  {
    corrupt(bytes, hull, nullptr);
  }
  const Cloud queries = drawQueries(bytes, cloud);

  const Options making = kind == 5 ? options : unwatched(options);
  const Watch none;
  const auto asked = attempt([&] { return HullQueries(points, hull, making); });
  expectOutcome(asked, kind == 5 ? watch : none, { ErrorCode::BadArgument });
  const auto planes = attempt([&] { return facetPlanes(points, hull, unwatched(options)); });
  expectOutcome(planes, none, { ErrorCode::BadArgument });
  const auto neighbors = attempt([&] { return cellNeighbors(hull, unwatched(options)); });
  expectOutcome(neighbors, none, { ErrorCode::BadArgument });
  const auto named = attempt([&] { return certificate(points, hull, unwatched(options)); });
  if (corrupted)
  {
    // Of what looks like a hull and is none, any answer will do. But one must come.
    if (asked.result)
    {
      const Options plain = unwatched(options);
      const std::size_t count = queries.size();
      const PointView places = test::viewOf(queries);
      attempt(
        [&]
        {
          std::vector<std::int8_t> sides(count);
          std::vector<double> distances(count);
          std::vector<std::int64_t> ids(count);
          asked.result->contains(places, sides.data(), plain);
          asked.result->distance(places, distances.data(), plain);
          asked.result->support(places, ids.data(), plain);
          asked.result->diameter(plain);
          return asked.result->minimalBox(plain);
        });
    }
    return;
  }
  demand(planes.result && neighbors.result && named.result, "a hull is refused");
  judgePlane(cloud, queries, options);
  demandNeighbors(hull, *neighbors.result);
  if (asked.result)
  {
    judgeQueries(*asked.result, hull, cloud, queries, options, watch, kind);
  }
}

}
}
