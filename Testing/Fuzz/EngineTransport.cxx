// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cells in a domain: power diagrams, sites that move to centroids, prescribed areas.
#include "EngineCall.h"
#include "EngineCalls.h"

#include "PowerDiagram/PlanarRings.h"
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/PowerDiagram/DiagramFault.h"
#include "Testing/Engine/PowerDiagram/ExactPolygons.h"
#include "Testing/Engine/PowerDiagram/PowerPolygons.h"
#include "Testing/Engine/Query/PlaneQueries.h"
#include <flipflop/CellBoundary.h>
#include <flipflop/Measures.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace flipflop
{
namespace fuzz
{

namespace
{

using Numbers = std::vector<double>;

bool areFinite(const double* begin, const double* end)
{
  return std::all_of(begin, end, [](double x) { return std::isfinite(x); });
}

/// A box or a polygon, right or not.
struct Domain
{
  Numbers numbers;
  bool isBox = true;
  bool isRight = false; ///< it is convex for certain
  double area = 0;      ///< of one that is right
  double magnitude = 0; ///< of its greatest coordinate
  double perimeter = 0;

  /// @param cloud what it may be around
  Domain(Bytes& bytes, const Cloud& cloud)
  {
    const int kind = bytes.below(4);
    if (kind < 2)
    {
      this->drawBox(bytes, kind == 0 ? cloud : Cloud());
    }
    else if (kind == 2)
    {
      this->drawHull(bytes);
    }
    else
    {
      this->isBox = false;
      this->numbers.resize(2 * static_cast<std::size_t>(bytes.below(8)));
      std::generate(this->numbers.begin(), this->numbers.end(), [&] { return bytes.number(); });
    }
    this->measure();
  }

  ConvexDomain view() const
  {
    return this->isBox
      ? ConvexDomain(this->numbers.data())
      : ConvexDomain(this->numbers.data(), static_cast<std::int64_t>(this->numbers.size() / 2));
  }

  /// In a unit of any size, rounded. Rounding may make a polygon's corner turn right.
  void stretch(double factor)
  {
    for (double& x : this->numbers)
    {
      x *= factor;
    }
    const Numbers& x = this->numbers;
    this->isRight = this->isRight && areFinite(x.data(), x.data() + x.size()) &&
      (this->isBox ? x[0] < x[1] && x[2] < x[3] : this->turnsLeft());
    this->measure();
  }

  /// Counter-clockwise from any corner; some may be no bend.
  Numbers corners() const
  {
    const Numbers& x = this->numbers;
    return this->isBox ? Numbers{ x[0], x[2], x[1], x[2], x[1], x[3], x[0], x[3] } : x;
  }

  /// The corners that are a bend.
  Numbers bends() const
  {
    const Numbers all = this->corners();
    Numbers found;
    for (std::size_t i = 0; i < all.size(); i += 2)
    {
      if (turnAt(all, i) > 0)
      {
        found.insert(found.end(), { all[i], all[i + 1] });
      }
    }
    return found;
  }

  /// Is its area a normal double, of more than rounding, and each side as long as a double can be?
  bool isMeasurable() const
  {
    return std::isnormal(this->area) && std::isfinite(this->perimeter) &&
      this->magnitude * this->perimeter <= 1e12 * this->area;
  }

  /// Are areas in it sums of normal doubles, and not of rounding alone?
  bool isThick() const
  {
    return this->area >= 1e-250 && this->area <= 1e250 &&
      this->magnitude * this->perimeter <= 1e4 * this->area;
  }

private:
  void drawBox(Bytes& bytes, const Cloud& around)
  {
    const bool isAny = bytes.flag();
    for (int i = 0; i < 4; ++i)
    {
      this->numbers.push_back(isAny ? bytes.number() : bytes.raw<std::int8_t>());
    }
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      double* const range = this->numbers.data() + 2 * axis;
      for (const Point& p : around)
      {
        range[0] = std::min(range[0], p[axis]);
        range[1] = std::max(range[1], p[axis]);
      }
    }
    this->isRight = areFinite(this->numbers.data(), this->numbers.data() + 4) &&
      this->numbers[0] < this->numbers[1] && this->numbers[2] < this->numbers[3];
  }

  /// The border of a triangulation is a polygon; some of its corners are no bend.
  void drawHull(Bytes& bytes)
  {
    this->isBox = false;
    const Cloud cloud = drawCloud(bytes, 40);
    Options options;
    options.threads = 1;
    options.nonFinite = NonFinitePolicy::Ignore;
    const Triangulation hull = regularTriangulation(test::viewOf(cloud), WeightView(), options);
    const CellBoundary border = cellBoundary(hull, options);
    for (const std::int64_t corner : border.connectivity)
    {
      const auto id = static_cast<std::size_t>(hull.pointIds[static_cast<std::size_t>(corner)]);
      this->numbers.insert(this->numbers.end(), { cloud[id][0], cloud[id][1] });
    }
    this->isRight = hull.dimension == 2;
  }

  /// The turn from a corner to the next but one; negative also for one that goes back.
  static test::Rational turnAt(const Numbers& x, std::size_t i)
  {
    const std::size_t size = x.size();
    const double* const a = &x[(i + size - 2) % size];
    const double* const b = &x[i];
    const double* const c = &x[(i + 2) % size];
    const test::Rational u[2] = { test::Rational(b[0]) - a[0], test::Rational(b[1]) - a[1] };
    const test::Rational v[2] = { test::Rational(c[0]) - b[0], test::Rational(c[1]) - b[1] };
    const test::Rational turn = u[0] * v[1] - u[1] * v[0];
    return turn == 0 && u[0] * v[0] + u[1] * v[1] <= 0 ? test::Rational(-1) : turn;
  }

  /// As all of the true corners do, or are no bend.
  bool turnsLeft() const
  {
    bool isLeft = true;
    for (std::size_t i = 0; i < this->numbers.size(); i += 2)
    {
      isLeft = isLeft && turnAt(this->numbers, i) >= 0;
    }
    return isLeft;
  }

  void measure()
  {
    this->area = this->magnitude = this->perimeter = 0;
    if (!this->isRight)
    {
      return;
    }
    const Numbers corners = this->corners();
    test::Rational twice = 0;
    for (std::size_t i = 0; i < corners.size(); i += 2)
    {
      const std::size_t j = (i + 2) % corners.size();
      twice +=
        test::Rational(corners[i]) * corners[j + 1] - test::Rational(corners[i + 1]) * corners[j];
      this->magnitude =
        std::max({ this->magnitude, std::fabs(corners[i]), std::fabs(corners[i + 1]) });
      this->perimeter += std::hypot(corners[j] - corners[i], corners[j + 1] - corners[i + 1]);
    }
    this->area = test::Rational(twice / 2).get_d();
  }
};

/// Sites and numbers for them, in any unit, mostly one in which nothing stays a small integer; and
/// where their cells are to be.
struct Case
{
  bool isWeighted;
  Cloud sites;
  Domain domain;

  /// @param areWeights the numbers, which go with the square of lengths; else areas, mostly right
  Case(Bytes& bytes, int most, bool areWeights)
    : isWeighted(bytes.flag())
    , sites(drawCloud(bytes, most))
    , domain(drawDomain(bytes, areWeights))
  {
    if (bytes.flag())
    {
      const int exponent = bytes.flag() ? 8 * bytes.raw<std::int8_t>() : 0;
      const double factor = std::ldexp(1 + bytes.byte() / 177.0, exponent);
      for (Point& p : this->sites)
      {
        p = { p[0] * factor, p[1] * factor, areWeights ? p[2] * factor * factor : p[2] };
      }
      this->domain.stretch(factor);
    }
    this->isWeighted = this->isWeighted && !this->sites.empty();
  }

  PointView points() const { return test::viewOf(this->sites); }
  WeightView numbers() const
  {
    return this->isWeighted ? test::weightsOf(this->sites) : WeightView();
  }
  NonFinite faults(int axes) const { return findNonFinite(this->sites, axes); }

  std::size_t positionCount() const
  {
    std::set<std::pair<double, double>> positions;
    for (const Point& p : this->sites)
    {
      positions.emplace(p[0], p[1]);
    }
    return positions.size();
  }

  /// Are positions such that doubles distinguish the cells in the domain?
  bool areNear() const
  {
    const double far = 1e4 * this->domain.perimeter;
    return std::all_of(this->sites.begin(), this->sites.end(),
      [&](const Point& p) { return std::fabs(p[0]) <= far && std::fabs(p[1]) <= far; });
  }

private:
  Domain drawDomain(Bytes& bytes, bool areWeights)
  {
    if (areWeights)
    {
      drawWeights(bytes, this->sites);
    }
    else if (!bytes.oneOf(8))
    {
      for (Point& p : this->sites)
      {
        p[2] = std::isfinite(p[2]) && p[2] != 0 ? std::fabs(p[2]) : 1.0;
      }
    }
    return Domain(bytes, this->sites);
  }
};

/// The cells are those of brute force, unless rounding has broken one.
void demandCells(const PowerDiagram& diagram, const Case& given)
{
  Numbers positions;
  Numbers weights;
  for (const Point& p : given.sites)
  {
    positions.insert(positions.end(), { p[0], p[1] });
    weights.push_back(given.isWeighted ? p[2] : 0);
  }
  std::map<std::int64_t, test::Polygon> expected;
  for (std::size_t i = 0; i < given.sites.size(); ++i)
  {
    const test::Polygon cell =
      test::roundingOf(test::exactCell(positions, weights, given.domain.bends(), i));
    Numbers corners;
    Ring ring;
    for (const auto& corner : cell)
    {
      ring.push_back(static_cast<std::uint32_t>(ring.size()));
      corners.insert(corners.end(), corner.begin(), corner.end());
    }
    if (cell.size() >= 3 && !PlanarRings(corners).isConvex(ring.data(), ring.size()))
    {
      return;
    }
    if (cell.size() >= 3)
    {
      expected[static_cast<std::int64_t>(i)] = cell;
    }
  }
  demand(test::polygonsOf(diagram) == expected, "not the cells of brute force");
}

/// An error about the domain has its reason there.
/// @param isBad another argument is
template <class Result>
void expectDomainError(const Outcome<Result>& outcome, const Domain& domain, bool isBad)
{
  demand(!outcome.is(ErrorCode::NotConvex) || (!domain.isBox && !domain.isRight),
    "a convex domain is refused");
  demand(!outcome.is(ErrorCode::BadArgument) || isBad || !domain.isRight,
    "a domain that is right is refused");
}

/// Areas are not negative, though that of a small cell may be less than any double, and sum to the
/// domain's.
template <class Values>
void demandAreas(const Values& areas, const Domain& domain)
{
  demand(std::all_of(areas.begin(), areas.end(), [](double area) { return area >= 0; }),
    "a cell has a negative area");
  const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
  demand(std::fabs(sum - domain.area) <= 1e-9 * domain.area,
    "areas sum to " + std::to_string(sum) + ", not to the domain's " + std::to_string(domain.area));
}

template <class Values>
void demandNumbers(const Values& values, std::size_t count, const char* what)
{
  demand(values.size() == count, std::string("not one for each: ") + what);
  demand(areFinite(values.data(), values.data() + count), std::string("not a number: ") + what);
}

}

void fuzzDiagram(Bytes& bytes)
{
  constexpr std::size_t FewSites = 12; // brute force in rationals is quick
  Trial trial(bytes);
  const bool isBroken = bytes.oneOf(3);
  const Case given(bytes, 400, true);
  const Domain& domain = given.domain;
  auto made =
    attempt([&] { return regularTriangulation(given.points(), given.numbers(), trial.plain()); });
  if (!made.result)
  {
    return;
  }
  Triangulation& triangulation = *made.result;
  if (isBroken)
  {
    corrupt(bytes, triangulation, &triangulation.hiddenIds);
  }
  const auto outcome = trial.run(0, { ErrorCode::BadArgument, ErrorCode::NotConvex },
    [&](const Options& options) {
      return powerDiagram(given.points(), given.numbers(), triangulation, domain.view(), options);
    });
  if (isBroken)
  {
    return;
  }
  expectDomainError(outcome, domain, false);
  demand(!domain.isBox || domain.isRight == outcome.result.has_value(),
    "a good box is refused, or a bad one is not");
  if (!outcome.result)
  {
    return;
  }
  const PowerDiagram& diagram = *outcome.result;
  demandNumbers(diagram.corners, diagram.corners.size(), "a corner");
  Cloud sites = given.sites;
  for (Point& p : sites)
  {
    p[2] = given.isWeighted ? p[2] : 0;
  }
  const bool isFinite = given.faults(given.isWeighted ? 3 : 2).count == 0;
  if (domain.isBox && isFinite)
  {
    const Numbers& x = domain.numbers;
    demandNone(test::diagramFault(diagram, sites, triangulation, { x[0], x[1], x[2], x[3] }));
  }
  if (domain.isRight && !domain.isBox && isFinite && sites.size() <= FewSites &&
    given.positionCount() == sites.size())
  {
    demandCells(diagram, given);
  }
  Numbers measures(3 * diagram.siteIds.size());
  cellMeasures(diagram, measures.data(), measures.data() + diagram.siteIds.size(), trial.plain());
  measures.resize(diagram.siteIds.size());
  if (domain.isRight && domain.isThick() && !triangulation.pointIds.empty())
  {
    demandAreas(measures, domain);
  }
}

void fuzzCentroidal(Bytes& bytes)
{
  Trial trial(bytes);
  const Case given(bytes, 150, true);
  const std::int64_t iterations = bytes.oneOf(16) ? -1 : bytes.below(5);
  const double tolerance = bytes.flag() ? 0.0 : bytes.number();
  const std::size_t count = given.sites.size();
  const auto outcome =
    trial.run(0, { ErrorCode::BadArgument, ErrorCode::NotConvex, ErrorCode::NonFinite },
      [&](const Options& options)
      {
        return centroidalCells(
          given.points(), given.numbers(), given.domain.view(), iterations, tolerance, options);
      });
  expectDomainError(
    outcome, given.domain, iterations < 0 || !(tolerance >= 0) || !given.domain.isMeasurable());
  const NonFinite faults = given.faults(given.isWeighted ? 3 : 2);
  demand(!outcome.is(ErrorCode::NonFinite) ||
      (outcome.error->index() == faults.first && outcome.error->count() == faults.count),
    "NonFinite where all are finite, or of another site");
  if (!outcome.result)
  {
    return;
  }
  const CentroidalCells& found = *outcome.result;
  demand(faults.count == 0, "a site that is not finite has a cell");
  demandNumbers(found.sites, 2 * count, "a site");
  demandNumbers(found.centroids, 2 * count, "a centroid");
  demandNumbers(found.areas, count, "an area");
  demand(std::isfinite(found.lastMove) && found.lastMove >= 0, "a move is no length");
  demand(found.iterations <= iterations, "too many iterations");
  demand(found.withoutCell == static_cast<std::int64_t>(count - found.cells.siteIds.size()),
    "the count of sites without a cell is wrong");
  if (given.domain.isRight && given.domain.isThick() && count > 0)
  {
    demandAreas(found.areas, given.domain);
  }
}

void fuzzPrescribed(Bytes& bytes)
{
  Trial trial(bytes);
  const Case given(bytes, 100, false);
  const std::int64_t iterations = bytes.oneOf(16) ? -1 : bytes.below(5);
  const double tolerance = bytes.flag() ? 1e-6 : bytes.number();
  const std::size_t count = given.sites.size();
  const NonFinite faults = given.faults(2);
  const bool isApart = given.positionCount() == count;
  bool areShares = true;
  double greatest = 0;
  double least = std::numeric_limits<double>::max();
  for (const Point& p : given.sites)
  {
    const double share = given.isWeighted ? p[2] : 1.0;
    areShares = areShares && share > 0 && std::isfinite(share);
    greatest = std::max(greatest, share);
    least = std::min(least, share);
  }
  // A share may become no normal double.
  const bool isSmall = !(least / greatest * given.domain.area > 1e-300);
  const auto outcome = trial.run(0,
    { ErrorCode::BadArgument, ErrorCode::NotConvex, ErrorCode::NonFinite, ErrorCode::DuplicateSites,
      ErrorCode::BadArea },
    [&](const Options& options)
    {
      return prescribedAreas(
        given.points(), given.numbers(), given.domain.view(), tolerance, iterations, options);
    });
  expectDomainError(
    outcome, given.domain, iterations < 0 || !(tolerance >= 0) || !given.domain.isMeasurable());
  demand(!outcome.is(ErrorCode::NonFinite) ||
      (outcome.error->index() == faults.first && outcome.error->count() == faults.count),
    "NonFinite where all are finite, or of another site");
  demand(!outcome.is(ErrorCode::DuplicateSites) || !isApart, "no two sites are at one position");
  demand(!outcome.is(ErrorCode::BadArea) || !areShares || isSmall, "all areas are right");
  if (!outcome.result)
  {
    return;
  }
  const PrescribedAreas& found = *outcome.result;
  demand(faults.count == 0 && areShares && isApart, "a site or an area that is none has a result");
  demandNumbers(found.weights, count, "a weight");
  demandNumbers(found.areas, count, "an area");
  demandNumbers(found.centroids, 2 * count, "a centroid");
  demand(found.error >= 0, "the error is no number");
  demand(found.converged == (count == 0 || found.error <= tolerance),
    "converged, and the error is beyond the tolerance; or the reverse");
  demand(found.iterations <= iterations, "too many iterations");
  if (given.domain.isRight && given.domain.isThick() && count > 0 && given.areNear())
  {
    demandAreas(found.areas, given.domain);
  }
}

}
}
