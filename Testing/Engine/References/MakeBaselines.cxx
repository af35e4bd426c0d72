// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// MakeBaselines <directory>: write CGAL's hull, or regular triangulation, of every baseline input
/// to <directory>/<name>.txt. MakeBaselines --points <directory>: write the inputs alone, to
/// <directory>/<name>.f64: x, y and z, or the weight, of each point as doubles.
///
/// Exact constructions where bearable, rationals for extreme ranges: never the engine, which the
/// files are there to judge.
#include "Testing/Engine/References/BaselineFile.h"
#include "Testing/Engine/References/ReferenceTriangulation.h"

#include <cstdio>
#include <exception>
#include <fstream>
#include <string>
#include <vector>

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

void writePoints(const std::string& directory, const std::vector<Input>& inputs)
{
  for (const Input& input : inputs)
  {
    const Cloud cloud = input.make();
    std::ofstream file(directory + "/" + input.name + ".f64", std::ios::binary);
    file.write(reinterpret_cast<const char*>(cloud.data()),
      static_cast<std::streamsize>(cloud.size() * sizeof(cloud[0])));
  }
}

}

int main(int argc, char* argv[])
{
  const bool isOfPoints = argc == 3 && std::string(argv[1]) == "--points";
  if (argc != 2 && !isOfPoints)
  {
    std::fprintf(stderr, "usage: %s [--points] <directory>\n", argv[0]);
    return 2;
  }
  try
  {
    if (isOfPoints)
    {
      writePoints(argv[2], baselineInputs());
      writePoints(argv[2], weightedBaselineInputs());
      return 0;
    }
    for (const Input& input : baselineInputs())
    {
      const Cloud cloud = input.make();
      write(argv[1], "hull", input, cgalHull(cloud));
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
