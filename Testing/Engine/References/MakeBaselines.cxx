// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// MakeBaselines <directory>: write CGAL's hull, or regular triangulation, of every baseline input
/// to <directory>/<name>.txt.
///
/// Exact constructions where bearable, rationals for extreme ranges: never the engine, which the
/// files are there to judge.
#include "Testing/Engine/References/BaselineFile.h"
#include "Testing/Engine/References/ReferenceTriangulation.h"

#include <cstdio>
#include <exception>

namespace
{

using namespace flipflop::test;

void write(const std::string& directory, const std::string& kind, const Input& input,
  const ReferenceHull& result)
{
  writeBaseline(directory + "/" + input.name + ".txt", kind, input, result);
  std::printf("%-28s %7zu points, dimension %d, %6zu in the %s, %6zu facets\n", input.name.c_str(),
    input.make().size(), result.dimension, result.ids.size(), kind.c_str(), result.cells.size());
}

}

int main(int argc, char* argv[])
{
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
      write(argv[1], "hull", input, cgalHull(cloud, kernel));
    }
    for (const Input& input : weightedBaselineInputs())
    {
      const Cloud cloud = input.make();
      write(argv[1], "triangulation", input, cgalTriangulation(cloud, kernelForWeighted(cloud)));
    }
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
