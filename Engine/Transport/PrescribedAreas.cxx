// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Areas as a function of weights: where two cells meet, a greater weight moves their common edge
/// by half of the increase over the sites' distance. So the derivative is the Laplacian of a graph,
/// in which a link counts as the edge's length over twice the distance.
#include <flipflop/PrescribedAreas.h>

#include "PowerDiagram/DomainCorners.h"
#include "Support/BufferCopy.h"
#include "Support/EngineCall.h"
#include "Support/ProgressOfParts.h"
#include "Support/Stopwatch.h"
#include "Transport/CellMoments.h"
#include "Transport/Iterations.h"
#include "Transport/LaplaceSolver.h"
#include "Transport/SiteArrays.h"
#include <flipflop/RegularTriangulation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace flipflop
{

namespace
{

/// Halving a step further leaves nothing of it.
constexpr int MostHalvings = 50;

using Position = std::array<double, 2>;

/// Weights with which the power cells of the sites are the Voronoi cells of their image in the
/// domain. |x - z|^2 for z = a + s y is s times |x - y|^2 less the weight |y|^2 - |z|^2 / s, but
/// for what is the same for all y. Positions are taken relative to the domain's centroid.
std::vector<double> weightsOfImage(const std::vector<double>& sites, const MeasuredDomain& domain)
{
  const std::vector<double>& polygon = domain.polygon;
  const Position& center = domain.centroid;
  std::array<double, 4> box = boundingBox(sites);
  const Position middle{ { 0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]) } };
  // As large as the domain allows, with some margin at its border.
  constexpr double Filled = 0.9;
  double scale = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < polygon.size(); i += 2)
  {
    const std::size_t j = (i + 2) % polygon.size();
    const Position outward{ { polygon[j + 1] - polygon[i + 1], polygon[i] - polygon[j] } };
    const double reserve =
      outward[0] * (polygon[i] - center[0]) + outward[1] * (polygon[i + 1] - center[1]);
    double reach = 0;
    for (std::size_t v = 0; v < sites.size(); v += 2)
    {
      reach = std::max(
        reach, outward[0] * (sites[v] - middle[0]) + outward[1] * (sites[v + 1] - middle[1]));
    }
    scale = reach > 0 ? std::min(scale, Filled * reserve / reach) : scale;
  }
  std::vector<double> weights(sites.size() / 2);
  for (std::size_t v = 0; v < sites.size(); v += 2)
  {
    double weight = 0;
    for (std::size_t k = 0; k < 2; ++k)
    {
      const double y = sites[v + k] - center[k];
      const double z = scale * (sites[v + k] - middle[k]);
      weight += y * y - z * z / scale;
    }
    weights[v / 2] = weight;
  }
  return weights;
}

/// Weights count but for a constant.
void makeLeastZero(std::vector<double>& weights)
{
  const double least = *std::min_element(weights.begin(), weights.end());
  for (double& weight : weights)
  {
    weight -= least;
  }
}

bool areFinite(const std::vector<double>& weights)
{
  return std::all_of(
    weights.begin(), weights.end(), [](double weight) { return std::isfinite(weight); });
}

class NewtonRun
{
public:
  NewtonRun(const PointView& points, const WeightView& areas, const ConvexDomain& given,
    double relativeError, std::int64_t mostIterations, const Options& options)
    : sites(points, areas)
    , domain(given)
    , tolerance(relativeError)
    , most(mostIterations)
    , progress(options)
  {
    requireLimits(this->most, this->tolerance);
    this->prescribe();
  }

  PrescribedAreas run()
  {
    if (this->prescribed.empty())
    {
      this->result.converged = true;
      return std::move(this->result);
    }
    this->progress.name("fitting areas");
    this->start();
    while (!this->result.converged && this->result.iterations < this->most && this->step())
    {
      ++this->result.iterations;
    }
    this->result.weights = bufferOf(this->now.weights);
    this->result.areas = bufferOf(this->now.moments.areas);
    this->result.centroids = bufferOf(this->now.moments.centroids);
    return std::move(this->result);
  }

private:
  /// Weights, and what they give.
  struct State
  {
    std::vector<double> weights;
    CellMoments moments;
    double least = 0; ///< area
    double norm = 0;  ///< of the errors, as shares of the whole
    double error = 0; ///< the greatest, relative to what is prescribed
  };

  void prescribe()
  {
    this->prescribed = std::move(this->sites.numbers);
    this->sites.numbers.clear();
    if (this->prescribed.empty())
    {
      this->prescribed.assign(this->sites.positions.size() / 2, 1.0);
    }
    this->refuseAreas([](double area) { return !(area > 0) || !std::isfinite(area); });
    // The greatest first becomes 1, so that the sum is finite.
    const double greatest = this->prescribed.empty()
      ? 1.0
      : *std::max_element(this->prescribed.begin(), this->prescribed.end());
    double sum = 0;
    for (double& area : this->prescribed)
    {
      area /= greatest;
      sum += area;
    }
    for (double& area : this->prescribed)
    {
      area *= this->domain.area / sum;
    }
    this->refuseAreas([](double area) { return !std::isnormal(area); },
      "an area that is prescribed must be a normal double, 2.3e-308 or more, as its share of the "
      "domain's area");
  }

  /// @param isBad bool (double area)
  template <class IsBad>
  void refuseAreas(const IsBad& isBad, const char* text = nullptr) const
  {
    const auto first = std::find_if(this->prescribed.begin(), this->prescribed.end(), isBad);
    if (first != this->prescribed.end())
    {
      throw Error(ErrorCode::BadArea, first - this->prescribed.begin(),
        std::count_if(first, this->prescribed.end(), isBad), text);
    }
  }

  /// @param weights of no point: none
  Triangulation triangulated(const std::vector<double>& weights)
  {
    Stopwatch stopwatch;
    Triangulation found = regularTriangulation(
      this->sites.points(), weightsOf(weights), this->progress.options(this->next));
    this->result.statistics += found.statistics;
    this->result.secondsTriangulating += stopwatch.lap();
    return found;
  }

  void measure(const Triangulation& triangulation, State& state)
  {
    Stopwatch stopwatch;
    measureCells(this->sites.positions, state.weights.data(), triangulation, this->domain.polygon,
      state.moments, this->progress.options(this->next));
    const std::vector<double>& areas = state.moments.areas;
    double sum = 0;
    state.error = 0;
    for (std::size_t i = 0; i < areas.size(); ++i)
    {
      const double off = areas[i] - this->prescribed[i];
      sum += off / this->domain.area * (off / this->domain.area);
      state.error = std::max(state.error, std::fabs(off) / this->prescribed[i]);
    }
    state.norm = std::sqrt(sum);
    state.least = *std::min_element(areas.begin(), areas.end());
    this->result.secondsMeasuring += stopwatch.lap();
  }

  void start()
  {
    this->now.weights.assign(this->prescribed.size(), 0.0);
    const Triangulation delaunay = this->triangulated({});
    if (!delaunay.hiddenIds.empty())
    {
      this->refuseDuplicate(delaunay.hiddenIds[0]);
    }
    this->measure(delaunay, this->now);
    if (!this->areAllInside() || !(this->now.least > 0))
    {
      std::vector<double> weights = weightsOfImage(this->sites.positions, this->domain);
      makeLeastZero(weights);
      // Of sites too far for squares in doubles, the Voronoi cells stay.
      if (areFinite(weights))
      {
        this->now.weights.swap(weights);
        this->measure(this->triangulated(this->now.weights), this->now);
      }
    }
    this->least = 0.5 *
      std::min(
        this->now.least, *std::min_element(this->prescribed.begin(), this->prescribed.end()));
    this->firstError = this->now.error;
    this->report();
  }

  /// Without weights a point is hidden by one at its position.
  [[noreturn]] void refuseDuplicate(std::int64_t hidden) const
  {
    const double* const x = this->sites.positions.data() + 2 * hidden;
    std::int64_t first = 0;
    while (!std::equal(x, x + 2, this->sites.positions.data() + 2 * first))
    {
      ++first;
    }
    throw Error(ErrorCode::DuplicateSites, first, hidden);
  }

  bool areAllInside() const
  {
    for (std::size_t i = 0; i < this->domain.polygon.size(); i += 2)
    {
      const double* const p = this->domain.polygon.data() + i;
      const double* const q = this->domain.polygon.data() + (i + 2) % this->domain.polygon.size();
      for (std::size_t v = 0; v < this->sites.positions.size(); v += 2)
      {
        const double* const x = this->sites.positions.data() + v;
        if (!((q[0] - p[0]) * (x[1] - p[1]) - (q[1] - p[1]) * (x[0] - p[0]) > 0))
        {
          return false;
        }
      }
    }
    return true;
  }

  void report()
  {
    this->result.error = this->now.error;
    this->result.converged = this->now.error <= this->tolerance;
    // Each factor of the error counts alike, until the tolerance.
    const double goal = std::max(this->tolerance, 1e-15);
    this->next = this->firstError > goal && this->now.error > 0
      ? std::log(this->firstError / this->now.error) / std::log(this->firstError / goal)
      : 1.0;
    this->next = std::min(std::max(this->next, 0.0), 1.0);
  }

  /// @return false: no step leads on
  bool step()
  {
    std::vector<double> direction;
    if (!this->solve(direction))
    {
      return false;
    }
    double length = 1;
    for (int halvings = 0; halvings < MostHalvings; ++halvings, length *= 0.5)
    {
      this->trial.weights = this->now.weights;
      for (std::size_t i = 0; i < direction.size(); ++i)
      {
        this->trial.weights[i] += length * direction[i];
      }
      makeLeastZero(this->trial.weights);
      if (!areFinite(this->trial.weights))
      {
        continue;
      }
      const Triangulation triangulation = this->triangulated(this->trial.weights);
      if (!triangulation.hiddenIds.empty())
      {
        continue;
      }
      this->measure(triangulation, this->trial);
      if (this->trial.least >= this->least &&
        this->trial.norm <= (1 - 0.5 * length) * this->now.norm)
      {
        std::swap(this->now, this->trial);
        this->report();
        return true;
      }
    }
    return false;
  }

  /// Newton's direction: weights change as the linear areas would have it.
  bool solve(std::vector<double>& direction)
  {
    Stopwatch stopwatch;
    std::vector<WeightedLink> links;
    for (const std::vector<CellLink>& part : this->now.moments.links)
    {
      for (const CellLink& link : part)
      {
        links.push_back({ link.low, link.high, 0.5 * link.length / link.distance });
      }
    }
    std::sort(links.begin(), links.end(),
      [](const WeightedLink& a, const WeightedLink& b)
      { return std::make_pair(a.low, a.high) < std::make_pair(b.low, b.high); });
    std::vector<double> wanted(this->prescribed.size());
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
      wanted[i] = this->prescribed[i] - this->now.moments.areas[i];
    }
    const bool isSolved = solveLaplace(wanted.size(), links, wanted, direction);
    this->result.secondsSolving += stopwatch.lap();
    return isSolved;
  }

  SiteArrays sites;
  const MeasuredDomain domain;
  const double tolerance;
  const std::int64_t most;
  ProgressOfParts progress;
  std::vector<double> prescribed;
  double next = 0;       ///< the share of the whole that the work under way leads to
  double firstError = 0; ///< the start's
  double least = 0;      ///< no area may be less
  State now;
  State trial;
  PrescribedAreas result;
};

}

PrescribedAreas prescribedAreas(const PointView& points, const WeightView& areas,
  const ConvexDomain& domain, double tolerance, std::int64_t iterations, const Options& options)
{
  return engineCall(
    [&]
    {
      return withSeconds(
        [&] { return NewtonRun(points, areas, domain, tolerance, iterations, options).run(); });
    });
}

}
