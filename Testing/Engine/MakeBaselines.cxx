// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// MakeBaselines <directory>: write CGAL's hull of every baseline input to <directory>/<name>.txt.
///
/// Exact constructions where bearable, rationals for extreme ranges: never the engine, which the
/// files are there to judge.
#include "BaselineFile.h"

#include <cstdio>
#include <exception>

int main(int argc, char* argv[])
{
  using namespace flipflop::test;
  if (argc != 2)
  {
    std::fprintf(stderr, "usage: %s <directory>\n", argv[0]);
    return 2;
  }
  try
  {
    for (const Input& input : baselineInputs())
    {
      const Cloud cloud = input.make();
      const Scale scale = commonScale(cloud);
      const CgalKernel kernel = scale.bits > 500 ? CgalKernel::Rational : CgalKernel::Lazy;
      const ReferenceHull hull = cgalHull(cloud, kernel);
      writeBaseline(std::string(argv[1]) + "/" + input.name + ".txt", input, hull);
      std::printf("%-28s %7zu points, dimension %d, %6zu on the hull, %6zu facets\n",
        input.name.c_str(), cloud.size(), hull.dimension, hull.ids.size(), hull.cells.size());
    }
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
