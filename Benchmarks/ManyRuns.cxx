// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Very many small runs, one after another: what a run costs; neither its time nor memory may grow.
///
///     many-runs [runs = 50000] [points = 200] [hull | triangulation]
#include <flipflop/ConvexHull.h>
#include <flipflop/RegularTriangulation.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <vector>

namespace
{

/// Resident memory in MB; 0 where the system does not tell.
double residentMegabytes()
{
  long long size = 0, resident = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r"))
  {
    if (std::fscanf(file, "%lld %lld", &size, &resident) != 2)
    {
      resident = 0;
    }
    std::fclose(file);
  }
  return static_cast<double>(resident) * 4096 / 1e6;
}

}

int main(int argc, char** argv)
{
  const int runs = argc > 1 ? std::atoi(argv[1]) : 50000;
  const int count = argc > 2 ? std::atoi(argv[2]) : 200;
  const char* const kind = argc > 3 ? argv[3] : "hull";
  const bool isHull = std::strcmp(kind, "hull") == 0;
  if (runs < 10 || count < 1 || (!isHull && std::strcmp(kind, "triangulation") != 0))
  {
    std::fprintf(
      stderr, "usage: %s [runs, 10 or more] [points, 1 or more] [hull | triangulation]\n", argv[0]);
    return EXIT_FAILURE;
  }
  std::mt19937_64 random(1);
  std::vector<double> points(3 * static_cast<std::size_t>(count));
  for (double& x : points)
  {
    x = 0x1p-53 * static_cast<double>(random() >> 11);
  }

  const flipflop::PointView view(points.data(), count);
  std::printf("%d runs of one %s each on %d points in the unit cube\n", runs, kind, count);
  for (const int threads : { 1, 2 })
  {
    flipflop::Options options;
    options.threads = threads;
    std::string times, memory;
    for (int slice = 0; slice < 10; ++slice)
    {
      const auto begin = std::chrono::steady_clock::now();
      for (int i = 0; i < runs / 10; ++i)
      {
        isHull ? static_cast<void>(flipflop::convexHull(view, options))
               : static_cast<void>(
                   flipflop::regularTriangulation(view, flipflop::WeightView(), options));
      }
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
      char text[64];
      std::snprintf(text, sizeof(text), " %8.2f", passed.count() / (runs / 10) * 1e6);
      times += text;
      std::snprintf(text, sizeof(text), " %8.1f", residentMegabytes());
      memory += text;
    }
    std::printf("%d thread(s), by tenths: us a run%s\n", threads, times.c_str());
    std::printf("                    MB resident%s\n", memory.c_str());
  }
  return EXIT_SUCCESS;
}
