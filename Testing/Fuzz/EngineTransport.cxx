// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cells in a domain: their measures are numbers, and sum to its area where doubles can tell.
#include "EngineCalls.h"
#include "EngineQueries.h"

#include "PowerDiagram/PlanarRings.h"
#include "Testing/Engine/PowerDiagram/ExactPolygons.h"
#include "Testing/Engine/PowerDiagram/PowerPolygons.h"
#include "Testing/Engine/Query/PlaneQueries.h"
#include <flipflop/CellBoundary.h>
#include <flipflop/CentroidalCells.h>
#include <flipflop/Measures.h>
#include <flipflop/PowerDiagram.h>
#include <flipflop/PrescribedAreas.h>

#include <array>
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

/// Sites and numbers beside them, as the calls take them.
struct Sites
{
  Cloud cloud;
  bool isWeighted;
  std::size_t count;
  NonFinite faults;

  explicit Sites(Bytes& bytes, int most)
    : cloud(drawCloud(bytes, most))
    , isWeighted(bytes.flag())
  {
    if (this->isWeighted)
    {
      drawWeights(bytes, this->cloud);
    }
    this->isWeighted = this->isWeighted && !this->cloud.empty();
    this->count = this->cloud.size();
    this->faults = findNonFinite(this->cloud, this->isWeighted ? 3 : 2);
  }

  /// @param areWeights the numbers, which go with the square of lengths
  void stretch(double factor, bool areWeights)
  {
    for (Point& p : this->cloud)
    {
      p = { p[0] * factor, p[1] * factor, areWeights ? p[2] * factor * factor : p[2] };
    }
    this->faults = findNonFinite(this->cloud, this->isWeighted ? 3 : 2);
  }

  PointView points() const { return test::viewOf(this->cloud); }
  WeightView numbers() const
  {
    return this->isWeighted ? test::weightsOf(this->cloud) : WeightView();
  }

  /// Are places and weights such that doubles tell the cells in a domain?
  bool areNear(const Domain& domain) const
  {
    const double far = 1e4 * domain.perimeter;
    return std::all_of(this->cloud.begin(), this->cloud.end(),
      [&](const Point& p) { return std::fabs(p[0]) <= far && std::fabs(p[1]) <= far; });
  }
};

/// Sites and their domain in any unit, mostly one in which nothing stays a small integer.
/// @param areWeights the sites' numbers
void stretch(Bytes& bytes, Sites& sites, Domain& domain, bool areWeights = true)
{
  if (bytes.flag())
  {
    const int exponent = bytes.flag() ? 8 * bytes.raw<std::int8_t>() : 0;
    const double factor = std::ldexp(1 + bytes.byte() / 177.0, exponent);
    sites.stretch(factor, areWeights);
    domain.stretch(factor);
  }
}

/// Up to so many sites, brute force in rationals is quick.
constexpr std::size_t FewSites = 12;

/// Sites at different places, all finite, and few?
bool isForBruteForce(const Sites& sites)
{
  std::set<std::pair<double, double>> places;
  for (const Point& p : sites.cloud)
  {
    places.emplace(p[0], p[1]);
  }
  return sites.count <= FewSites && sites.faults.count == 0 && places.size() == sites.count;
}

/// The cells are those of brute force, unless rounding has broken one.
void demandCells(const PowerDiagram& diagram, const Sites& sites, const Domain& domain)
{
  Numbers places;
  Numbers weights;
  for (const Point& p : sites.cloud)
  {
    places.insert(places.end(), { p[0], p[1] });
    weights.push_back(sites.isWeighted ? p[2] : 0);
  }
  std::map<std::int64_t, test::Polygon> expected;
  for (std::size_t i = 0; i < sites.count; ++i)
  {
    const test::Polygon cell =
      test::roundingOf(test::exactCell(places, weights, domain.bends(), i));
    if (cell.size() < 3)
    {
      continue;
    }
    Numbers positions;
    Ring ring;
    for (const auto& corner : cell)
    {
      ring.push_back(static_cast<std::uint32_t>(ring.size()));
      positions.insert(positions.end(), corner.begin(), corner.end());
    }
    if (!PlanarRings(positions).isConvex(ring.data(), ring.size()))
    {
      return;
    }
    expected[static_cast<std::int64_t>(i)] = cell;
  }
  demand(test::polygonsOf(diagram) == expected, "not the cells of brute force");
}

bool isCode(const std::optional<Error>& error, ErrorCode code)
{
  return error && error->code() == code;
}

/// An error about the domain has its reason there.
/// @param isBad another argument is
template <class Result>
void expectDomainError(const Outcome<Result>& outcome, const Domain& domain, bool isBad)
{
  demand(!isCode(outcome.error, ErrorCode::NotConvex) || (!domain.isBox && !domain.isRight),
    "a convex domain is refused");
  demand(!isCode(outcome.error, ErrorCode::BadArgument) || isBad || !domain.isRight,
    "a domain that is right is refused");
}

void demandSum(const Numbers& areas, const Domain& domain)
{
  const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
  demand(std::fabs(sum - domain.area) <= 1e-9 * domain.area,
    "areas sum to " + std::to_string(sum) + ", not to the domain's " + std::to_string(domain.area));
}

Numbers numbersOf(const Buffer<double>& values)
{
  return Numbers(values.begin(), values.end());
}

void demandNumbers(const Buffer<double>& values, std::size_t count, const char* what)
{
  demand(values.size() == count, std::string("not one for each site: ") + what);
  demand(areFinite(values.begin(), values.end()), std::string("not a number: ") + what);
}

}

void fuzzDomains(Bytes& bytes)
{
  Watch watch;
  const Options options = drawOptions(bytes, watch);
  Sites sites(bytes, 400);
  Domain domain(bytes, sites.cloud);
  stretch(bytes, sites, domain);
  Options making = unwatched(options);
  making.facets = options.facets;
  const auto made =
    attempt([&] { return regularTriangulation(sites.points(), sites.numbers(), making); });
  if (!made.result)
  {
    return;
  }
  const auto diagramOn = [&](const Options& chosen)
  {
    return attempt(
      [&] {
        return powerDiagram(sites.points(), sites.numbers(), *made.result, domain.view(), chosen);
      });
  };
  const auto outcome = diagramOn(options);
  expectOutcome(outcome, watch, { ErrorCode::BadArgument, ErrorCode::NotConvex });
  if (!watch.stopped)
  {
    expectDomainError(outcome, domain, false);
  }
  if (!outcome.result)
  {
    return;
  }
  const PowerDiagram& diagram = *outcome.result;
  demand(test::bitDifference(diagram, *diagramOn(making).result).empty(),
    "cells depend on the number of threads");
  Numbers areas(diagram.siteIds.size());
  Numbers centroids(2 * areas.size());
  cellMeasures(diagram, areas.data(), centroids.data(), making);
  demand(areFinite(diagram.corners.begin(), diagram.corners.end()), "a corner is not finite");
  demand(
    areFinite(centroids.data(), centroids.data() + centroids.size()), "a centroid is not finite");
  // In a box, a corner that rounds to a side is taken to be on it.
  if (domain.isRight && !domain.isBox && isForBruteForce(sites))
  {
    demandCells(diagram, sites, domain);
  }
  if (domain.isRight && domain.isThick() && !made.result->pointIds.empty())
  {
    // That of a small cell may be less than any double.
    demand(std::all_of(areas.begin(), areas.end(), [](double area) { return area >= 0; }),
      "a cell has a negative area");
    demandSum(areas, domain);
  }
}

void fuzzCentroidal(Bytes& bytes)
{
  Watch watch;
  const Options options = drawOptions(bytes, watch);
  Sites sites(bytes, 150);
  Domain domain(bytes, sites.cloud);
  const std::int64_t iterations = bytes.oneOf(16) ? -1 : bytes.below(5);
  const double tolerance = bytes.flag() ? 0.0 : bytes.number();
  stretch(bytes, sites, domain);
  const auto cellsOn = [&](const Options& chosen)
  {
    return attempt(
      [&]
      {
        return centroidalCells(
          sites.points(), sites.numbers(), domain.view(), iterations, tolerance, chosen);
      });
  };
  const auto outcome = cellsOn(options);
  expectOutcome(
    outcome, watch, { ErrorCode::BadArgument, ErrorCode::NotConvex, ErrorCode::NonFinite });
  if (!watch.stopped)
  {
    expectDomainError(
      outcome, domain, iterations < 0 || !(tolerance >= 0) || !domain.isMeasurable());
    demand(!isCode(outcome.error, ErrorCode::NonFinite) ||
        (outcome.error->index() == sites.faults.first &&
          outcome.error->count() == sites.faults.count),
      "NonFinite where all are finite, or of another site");
  }
  if (!outcome.result)
  {
    return;
  }
  const CentroidalCells& found = *outcome.result;
  demand(sites.faults.count == 0, "a site that is not finite has a cell");
  demandNumbers(found.sites, 2 * sites.count, "a site");
  demandNumbers(found.centroids, 2 * sites.count, "a centroid");
  demandNumbers(found.areas, sites.count, "an area");
  demand(std::isfinite(found.lastMove) && found.lastMove >= 0, "a move is no length");
  demand(found.iterations <= iterations, "too many iterations");
  demand(found.withoutCell == static_cast<std::int64_t>(sites.count - found.cells.siteIds.size()),
    "the count of sites without a cell is wrong");
  const auto other = cellsOn(unwatched(options));
  demand(sameBits(numbersOf(other.result->sites), numbersOf(found.sites)) &&
      test::bitDifference(other.result->cells, found.cells).empty(),
    "sites depend on the number of threads");
  if (domain.isRight && domain.isThick() && sites.count > 0)
  {
    demandSum(numbersOf(found.areas), domain);
  }
}

void fuzzPrescribed(Bytes& bytes)
{
  Watch watch;
  const Options options = drawOptions(bytes, watch);
  Sites sites(bytes, 100);
  if (!bytes.oneOf(8))
  {
    for (Point& p : sites.cloud)
    {
      p[2] = std::isfinite(p[2]) && p[2] != 0 ? std::fabs(p[2]) : 1.0;
    }
  }
  Domain domain(bytes, sites.cloud);
  const std::int64_t iterations = bytes.oneOf(16) ? -1 : bytes.below(5);
  const double tolerance = bytes.flag() ? 1e-6 : bytes.number();
  stretch(bytes, sites, domain, false);
  const auto areasOn = [&](const Options& chosen)
  {
    return attempt(
      [&]
      {
        return prescribedAreas(
          sites.points(), sites.numbers(), domain.view(), tolerance, iterations, chosen);
      });
  };
  const NonFinite faults = findNonFinite(sites.cloud, 2);
  std::set<std::pair<double, double>> places;
  bool areShares = true;
  double greatest = 0;
  double least = std::numeric_limits<double>::max();
  for (const Point& p : sites.cloud)
  {
    places.emplace(p[0], p[1]);
    areShares = areShares && (!sites.isWeighted || (p[2] > 0 && std::isfinite(p[2])));
    greatest = sites.isWeighted ? std::max(greatest, p[2]) : 1.0;
    least = sites.isWeighted ? std::min(least, p[2]) : 1.0;
  }
  // A share may become no normal double.
  const bool isSmall = !(least / greatest * domain.area > 1e-300);
  const auto outcome = areasOn(options);
  expectOutcome(outcome, watch,
    { ErrorCode::BadArgument, ErrorCode::NotConvex, ErrorCode::NonFinite, ErrorCode::DuplicateSites,
      ErrorCode::BadArea });
  if (!watch.stopped)
  {
    expectDomainError(
      outcome, domain, iterations < 0 || !(tolerance >= 0) || !domain.isMeasurable());
    demand(!isCode(outcome.error, ErrorCode::NonFinite) ||
        (outcome.error->index() == faults.first && outcome.error->count() == faults.count),
      "NonFinite where all are finite, or of another site");
    demand(!isCode(outcome.error, ErrorCode::DuplicateSites) || places.size() < sites.count,
      "no two sites are at one position");
    demand(
      !isCode(outcome.error, ErrorCode::BadArea) || !areShares || isSmall, "all areas are right");
  }
  if (!outcome.result)
  {
    return;
  }
  const PrescribedAreas& found = *outcome.result;
  demand(faults.count == 0 && areShares && places.size() == sites.count,
    "a site or an area that is none has a result");
  demandNumbers(found.weights, sites.count, "a weight");
  demandNumbers(found.areas, sites.count, "an area");
  demandNumbers(found.centroids, 2 * sites.count, "a centroid");
  demand(found.error >= 0, "the error is no number");
  demand(found.converged == (sites.count == 0 || found.error <= tolerance),
    "converged, and the error is beyond the tolerance; or the reverse");
  demand(found.iterations <= iterations, "too many iterations");
  const auto other = areasOn(unwatched(options));
  demand(sameBits(numbersOf(other.result->weights), numbersOf(found.weights)) &&
      sameBits(numbersOf(other.result->areas), numbersOf(found.areas)),
    "weights depend on the number of threads");
  if (domain.isRight && domain.isThick() && sites.count > 0 && sites.areNear(domain))
  {
    demand(
      std::all_of(found.areas.begin(), found.areas.end(), [](double area) { return area >= 0; }),
      "an area is negative");
    demandSum(numbersOf(found.areas), domain);
  }
}

}
}
