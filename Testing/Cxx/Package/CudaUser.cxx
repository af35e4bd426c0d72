// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The installed choice between the engines, without VTK.
#include <flipflop/Engines.h>

#include <cstdlib>
#include <iostream>

int main()
{
  const double xyz[] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.25, 0.25, 0.25 };
  flipflop::EngineOptions engine;
  engine.cudaFrom = 0;
  flipflop::EngineReport report;
  const flipflop::Hull hull =
    flipflop::convexHull(flipflop::PointView(xyz, 5), flipflop::Options(), engine, report);
  const bool cuda = report.used == flipflop::EngineChoice::CUDA;
  std::cout << (cuda ? "CUDA: " : "CPU: ") << report.reason << "\n";
  const bool right = hull.dimension == 3 && hull.pointIds.size() == 4 &&
    cuda == flipflop::cudaStatus().present && report.reason[0] != '\0';
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
