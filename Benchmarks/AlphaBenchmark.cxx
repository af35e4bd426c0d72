// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Alpha complexes beside CGAL's alpha shapes, in turns; the fastest of several runs counts. Both
/// triangulate, find the least alpha of each triangle, and the triangles and edges of one alpha.
///
///     alpha-benchmark [runs [points]]
///
/// The points are uniform in the unit square, or a grid's of step 1 (all triangles have one
/// circle), alpha is 0.7 of the step that so many points have.
#include "AlphaContenders.h"
#include "RandomPoints.h"

#include <flipflop/AlphaComplex.h>
#include <flipflop/RegularTriangulation.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace
{

using namespace flipflop;

AlphaOutcome runFlipFlop(const std::vector<double>& places, double alpha, int threads)
{
  Options options;
  options.threads = threads;
  const PointView points(places.data(), static_cast<std::int64_t>(places.size() / 2), 2);
  AlphaOutcome outcome;
  const auto begin = std::chrono::steady_clock::now();
  const Triangulation triangulation = regularTriangulation(points, WeightView(), options);
  std::vector<double> alphas(static_cast<std::size_t>(triangulation.cellCount()));
  cellAlphas(points, WeightView(), triangulation, alphas.data(), options);
  const AlphaComplex complex =
    alphaComplex(points, WeightView(), triangulation, alpha, true, options);
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  outcome.triangles = complex.cellCount;
  outcome.edges = static_cast<std::int64_t>(complex.edgeAlphas.size());
  return outcome;
}

void keepFastest(AlphaOutcome& best, const AlphaOutcome& run)
{
  best = best.seconds == 0 || run.seconds < best.seconds ? run : best;
}

}

int main(int argc, char** argv)
{
  const int runs = argc > 1 ? std::max(1, std::atoi(argv[1])) : 3;
  const int side =
    static_cast<int>(std::sqrt(argc > 2 ? std::max(1, std::atoi(argv[2])) : 1000000));
  bool isRight = true;
  std::printf("input,points,alpha,triangles,edges,flipflop_1_thread,flipflop_2_threads,cgal,"
              "ratio_1_thread,ratio_2_threads\n");
  for (const bool isGrid : { false, true })
  {
    RandomPoints random(4);
    std::vector<double> places;
    for (int i = 0; i < side * side; ++i)
    {
      const double x = isGrid ? i % side : random.uniform();
      const double y = isGrid ? i / side : random.uniform();
      places.insert(places.end(), { x, y });
    }
    const double alpha = isGrid ? 0.7 : 0.7 / side;
    AlphaOutcome one, two, cgal;
    for (int run = 0; run < runs; ++run)
    {
      keepFastest(one, runFlipFlop(places, alpha, 1));
      keepFastest(two, runFlipFlop(places, alpha, 2));
      keepFastest(cgal, runCgalAlpha(places, alpha));
    }
    const bool same = one.triangles == cgal.triangles && one.edges == cgal.edges &&
      two.triangles == cgal.triangles && two.edges == cgal.edges;
    std::printf("%s,%zu,%g,%lld,%lld,%.3f,%.3f,%.3f,%.2f,%.2f%s\n", isGrid ? "grid" : "uniform",
      places.size() / 2, alpha, static_cast<long long>(one.triangles),
      static_cast<long long>(one.edges), one.seconds, two.seconds, cgal.seconds,
      cgal.seconds / one.seconds, cgal.seconds / two.seconds, same ? "" : ",WRONG");
    std::fflush(stdout);
    isRight = isRight && same;
  }
  return isRight ? EXIT_SUCCESS : EXIT_FAILURE;
}
