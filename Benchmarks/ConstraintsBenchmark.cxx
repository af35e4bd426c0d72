// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Constrained Delaunay triangulations beside CGAL's, in turns; the fastest of several runs counts.
///
///     constraints-benchmark [runs]
///
/// | input    | points    | constraints                                                        |
/// |----------|-----------|--------------------------------------------------------------------|
/// | streets  | 1,000,000 | 100,000 of a street map: a grid's points, a little off, joined to  |
/// |          |           | one or two places on, in every other row                           |
/// | crossing | 1,000,000 | 100,000 short ones between random points, a few long: to be split    |
/// | long     | 1,000,000 | 500 right across the same points                                   |
/// | contours | 1,035,549 | 35,485 of the contours of Mount St Helens, among uniform points    |
#include "ConstraintContenders.h"
#include "RandomPoints.h"

#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/ConstraintCrossings.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace
{

using namespace flipflop;

constexpr int Side = 1000;

ConstrainedPoints gridWithSteps(int step, std::size_t most)
{
  RandomPoints random(1);
  ConstrainedPoints result;
  for (int i = 0; i < Side * Side; ++i)
  {
    result.places.push_back(i % Side + 0.8 * random.uniform());
    result.places.push_back(i / Side + 0.8 * random.uniform());
  }
  for (std::int64_t y = 0; y < Side; y += 2)
  {
    for (std::int64_t x = 0; x + step < Side && result.ends.size() < 2 * most; x += step)
    {
      result.ends.push_back(y * Side + x);
      result.ends.push_back(y * Side + x + step);
    }
  }
  return result;
}

/// The ends of streets that cross, and other points.
ConstrainedPoints crossingStreets()
{
  constexpr std::int64_t streets = 100000;
  RandomPoints random(3);
  ConstrainedPoints result;
  result.cross = true;
  const auto offset = [&](double most) { return most * (2 * random.uniform() - 1); };
  for (std::int64_t i = 0; i < streets; ++i)
  {
    const double reach = i % 1000 == 0 ? 0.3 : 0.005;
    const double x = random.uniform(), y = random.uniform();
    result.places.insert(result.places.end(), { x, y, x + offset(reach), y + offset(reach) });
    result.ends.insert(result.ends.end(), { 2 * i, 2 * i + 1 });
  }
  while (result.places.size() < 2 * Side * Side)
  {
    result.places.push_back(random.uniform());
  }
  return result;
}

ConstrainedPoints contoursAmongPoints()
{
  RandomPoints random(2);
  ConstrainedPoints result;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
    std::fopen(FLIPFLOP_CONTOURS, "rb"), std::fclose);
  if (!file)
  {
    throw std::runtime_error(std::string("cannot read ") + FLIPFLOP_CONTOURS);
  }
  float xy[2];
  double high[2] = { 0, 0 };
  std::int64_t last = -1;
  std::map<std::pair<float, float>, std::int64_t> idAt; // closed lines end where they began
  while (std::fread(xy, sizeof(xy), 1, file.get()) == 1)
  {
    if (std::isnan(xy[0]))
    {
      last = -1;
      continue;
    }
    const auto next = static_cast<std::int64_t>(result.places.size() / 2);
    const auto found = idAt.emplace(std::make_pair(xy[0], xy[1]), next);
    for (int k = 0; k < 2 && found.second; ++k)
    {
      result.places.push_back(xy[k]);
      high[k] = std::max(high[k], double(xy[k]));
    }
    const std::int64_t id = found.first->second;
    if (last >= 0 && last != id)
    {
      result.ends.insert(result.ends.end(), { last, id });
    }
    last = id;
  }
  for (int i = 0; i < 1000000; ++i)
  {
    result.places.push_back(high[0] * random.uniform());
    result.places.push_back(high[1] * random.uniform());
  }
  return result;
}

ConstrainedOutcome runFlipFlop(const ConstrainedPoints& points, int threads)
{
  Options options;
  options.threads = threads;
  ConstrainedOutcome outcome;
  const auto begin = std::chrono::steady_clock::now();
  const auto viewOf = [](const std::vector<double>& places)
  { return PointView(places.data(), static_cast<std::int64_t>(places.size() / 2), 2); };
  const ConstraintView constraints(
    points.ends.data(), static_cast<std::int64_t>(points.ends.size() / 2));
  ConstrainedTriangulation result;
  if (points.cross)
  {
    const SplitConstraints split = splitCrossings(viewOf(points.places), constraints, options);
    std::vector<double> all = points.places;
    all.insert(all.end(), split.positions.begin(), split.positions.end());
    result = constrainedTriangulation(viewOf(all), split.view(), options);
  }
  else
  {
    result = constrainedTriangulation(viewOf(points.places), constraints, options);
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  outcome.triangles = result.cellCount();
  outcome.fixedEdges = static_cast<std::int64_t>(result.constraintOf.size());
  return outcome;
}

void keepFastest(ConstrainedOutcome& best, const ConstrainedOutcome& run)
{
  best = best.seconds == 0 || run.seconds < best.seconds ? run : best;
}

}

int main(int argc, char** argv)
{
  const int runs = argc > 1 ? std::max(1, std::atoi(argv[1])) : 3;
  bool isRight = true;
  std::printf("input,points,constraints,fixed_edges,triangles,flipflop_1_thread,flipflop_2_threads,"
              "cgal,ratio_1_thread,ratio_2_threads\n");
  const std::pair<const char*, std::function<ConstrainedPoints()>> inputs[] = {
    { "streets", [] { return gridWithSteps(3, 100000); } },
    { "crossing", crossingStreets },
    { "long", [] { return gridWithSteps(Side - 100, 500); } },
    { "contours", contoursAmongPoints },
  };
  for (const auto& input : inputs)
  {
    const ConstrainedPoints points = input.second();
    ConstrainedOutcome one, two, cgal;
    for (int run = 0; run < runs; ++run)
    {
      keepFastest(one, runFlipFlop(points, 1));
      keepFastest(two, runFlipFlop(points, 2));
      keepFastest(cgal, runCgalConstrained(points));
    }
    const bool same = one.triangles == cgal.triangles && one.fixedEdges == cgal.fixedEdges &&
      two.triangles == cgal.triangles && two.fixedEdges == cgal.fixedEdges;
    std::printf("%s,%zu,%zu,%lld,%lld,%.3f,%.3f,%.3f,%.2f,%.2f%s\n", input.first,
      points.places.size() / 2, points.ends.size() / 2, static_cast<long long>(one.fixedEdges),
      static_cast<long long>(one.triangles), one.seconds, two.seconds, cgal.seconds,
      cgal.seconds / one.seconds, cgal.seconds / two.seconds, same ? "" : ",WRONG");
    std::fflush(stdout);
    isRight = isRight && same;
  }
  return isRight ? EXIT_SUCCESS : EXIT_FAILURE;
}
