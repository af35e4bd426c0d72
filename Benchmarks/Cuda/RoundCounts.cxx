// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// round-counts: what a run of the CUDA engine would ask of a device, counted on the host.
///
///   round-counts [n...]    default: 1000000 10000000
///
/// A line a point set, in Markdown.
#include "CountingExecutor.h"
#include "Distributions.h"
#include "RunnerOf.h"
#include <flipflop/Error.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

namespace
{

using namespace flipflop;

struct Case
{
  const char* label;
  Family family;
};

constexpr Case Cases[] = { { "cube", Family::Space }, { "shell:0.0001", Family::Space },
  { "shell:0", Family::Space }, { "uniform:0", Family::Plane }, { "uniform:27", Family::Plane } };

void countRun(const Case& which, std::int64_t n)
{
  const Distribution distribution = Distribution::parse(which.label, which.family);
  const Coordinates xyz = makePoints(distribution, n, 2013);
  RunInput input;
  input.plane = which.family == Family::Plane;
  input.points = PointView(xyz.data(), static_cast<std::int64_t>(xyz.size() / 3));
  if (distribution.isWeighted())
  {
    input.weights = WeightView(xyz.data() + 2, input.points.count, 3);
  }
  CountingExecutor executor;
  RunSeen seen;
  const RunResult result = runRounds(executor, input, Options(), false, seen);
  std::int64_t declared = 0;
  std::int64_t exact = 0;
  for (const auto& kernel : executor.tallies())
  {
    declared += kernel.second.bytes;
    exact += kernel.first.find(", exact") != std::string::npos ? kernel.second.launches : 0;
  }
  const auto points = static_cast<double>(input.points.count);
  std::printf("| %s | %.0e | %lld | %u + %u | %lld | %lld | %lld | %.0f | %.0f | %.0f | %.0f | "
              "%.0f | %.1f |\n",
    distribution.label().c_str(), points, static_cast<long long>(result.cells().pointIds.size()),
    seen.growthRounds, seen.flipRounds, static_cast<long long>(executor.launches),
    static_cast<long long>(exact), static_cast<long long>(executor.waits),
    static_cast<double>(declared) / points, executor.relocate.bytesPerItem(),
    executor.check.bytesPerItem(), static_cast<double>(executor.bytesFetched) / points,
    static_cast<double>(executor.bytesSent) / points, static_cast<double>(seen.mostBytes) / points);
  std::fflush(stdout);
}

}

int main(int argumentCount, char** arguments)
{
  try
  {
    std::vector<std::int64_t> sizes;
    for (int i = 1; i < argumentCount; ++i)
    {
      sizes.push_back(static_cast<std::int64_t>(std::atof(arguments[i])));
    }
    if (sizes.empty())
    {
      sizes = { 1000000, 10000000 };
    }
    std::printf("| points | n | vertices | rounds | launches | of exact kernels | waits | "
                "declared, B a point | "
                "relocate gathers, B an item | check, B an item | fetched, B a point | sent | "
                "memory, B a point |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const std::int64_t n : sizes)
    {
      for (const Case& which : Cases)
      {
        countRun(which, n);
      }
    }
    return 0;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "round-counts: %s\n", error.what());
    return 1;
  }
}
