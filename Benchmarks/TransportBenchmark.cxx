// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Prescribed areas and centroidal cells in the unit square: steps, seconds, and what takes them.
///
///     transport-benchmark [sites = 100000] [threads,... = 1,2]
///
/// Each time is the least of three runs. Sites are uniform, or normal about 30 centers; areas are
/// equal, or uniform between 0.5 and 1.5 times their mean. Prints a table for Benchmarks.md.
#include <flipflop/CentroidalCells.h>
#include <flipflop/PrescribedAreas.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using namespace flipflop;

constexpr int Rounds = 3;
constexpr std::int64_t LloydSteps = 10;
const double unitSquare[] = { 0, 1, 0, 1 };

/// The same numbers with any standard library.
class Draws
{
public:
  double uniform() { return 0x1p-53 * static_cast<double>(this->random() >> 11); }

  double normal()
  {
    const double radius = std::sqrt(-2 * std::log(1 - this->uniform()));
    return radius * std::cos(6.283185307179586 * this->uniform());
  }

private:
  std::mt19937_64 random{ 1 };
};

std::vector<double> uniformSites(std::int64_t count)
{
  Draws draws;
  std::vector<double> sites(2 * static_cast<std::size_t>(count));
  for (double& x : sites)
  {
    x = draws.uniform();
  }
  return sites;
}

std::vector<double> clusteredSites(std::int64_t count)
{
  Draws draws;
  std::vector<double> centers(60);
  for (double& x : centers)
  {
    x = 0.1 + 0.8 * draws.uniform();
  }
  std::vector<double> sites;
  while (sites.size() < 2 * static_cast<std::size_t>(count))
  {
    const std::size_t center = 2 * static_cast<std::size_t>(30 * draws.uniform());
    const double x = centers[center] + 0.02 * draws.normal();
    const double y = centers[center + 1] + 0.02 * draws.normal();
    if (x > 0 && x < 1 && y > 0 && y < 1)
    {
      sites.insert(sites.end(), { x, y });
    }
  }
  return sites;
}

std::vector<double> variedAreas(std::int64_t count)
{
  Draws draws;
  std::vector<double> areas(static_cast<std::size_t>(count));
  for (double& area : areas)
  {
    area = 0.5 + draws.uniform();
  }
  return areas;
}

void benchAreas(const char* name, const std::vector<double>& sites,
  const std::vector<double>& areas, const std::vector<int>& threads)
{
  const auto count = static_cast<std::int64_t>(sites.size() / 2);
  for (const int number : threads)
  {
    Options options;
    options.threads = number;
    PrescribedAreas best;
    for (int round = 0; round < Rounds; ++round)
    {
      PrescribedAreas found = prescribedAreas(PointView(sites.data(), count, 2),
        areas.empty() ? WeightView() : WeightView(areas.data(), count), unitSquare, 1e-6, 100,
        options);
      if (round == 0 || found.statistics.secondsTotal < best.statistics.secondsTotal)
      {
        best = std::move(found);
      }
    }
    const double whole = best.statistics.secondsTotal;
    std::printf("| %s | %d | %d | %.2f s | %.0f%% | %.0f%% | %.0f%% | %.0e%s |\n", name, number,
      static_cast<int>(best.iterations), whole, 100 * best.secondsTriangulating / whole,
      100 * best.secondsMeasuring / whole, 100 * best.secondsSolving / whole, best.error,
      best.converged ? "" : ", not converged");
    std::fflush(stdout);
  }
}

void benchLloyd(const std::vector<double>& sites, const std::vector<int>& threads)
{
  for (const int number : threads)
  {
    Options options;
    options.threads = number;
    double least = 0;
    for (int round = 0; round < Rounds; ++round)
    {
      const CentroidalCells found =
        centroidalCells(PointView(sites.data(), static_cast<std::int64_t>(sites.size() / 2), 2),
          WeightView(), unitSquare, LloydSteps, 0, options);
      const double seconds = found.statistics.secondsTotal;
      least = round == 0 || seconds < least ? seconds : least;
    }
    std::printf("centroidal cells, %d steps, threads %d: %.2f s\n", static_cast<int>(LloydSteps),
      number, least);
  }
}

}

int main(int argc, char** argv)
{
  const auto count = argc > 1 ? static_cast<std::int64_t>(std::atof(argv[1])) : 100000;
  std::vector<int> threads;
  std::istringstream given(argc > 2 ? argv[2] : "1,2");
  for (std::string number; std::getline(given, number, ',');)
  {
    threads.push_back(std::atoi(number.c_str()));
  }
  if (count < 1 || threads.empty() || threads[0] < 1)
  {
    std::fprintf(stderr, "usage: %s [sites, 1 or more] [threads,...]\n", argv[0]);
    return EXIT_FAILURE;
  }
  std::printf("%lld sites\n", static_cast<long long>(count));
  std::printf(
    "| sites, areas | threads | steps | time | triangulating | measuring | solving | error "
    "|\n|---|---|---|---|---|---|---|---|\n");
  const std::vector<double> uniform = uniformSites(count);
  benchAreas("uniform, equal", uniform, {}, threads);
  benchAreas("uniform, 0.5 to 1.5", uniform, variedAreas(count), threads);
  benchAreas("clustered, equal", clusteredSites(count), {}, threads);
  benchLloyd(uniform, threads);
  return EXIT_SUCCESS;
}
