// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/References/BaselineFile.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace flipflop
{
namespace test
{

namespace
{

/// Raw little-endian coordinates, three to a point.
template <class T>
Cloud readRaw(const std::string& name)
{
  const std::string path = std::string(FLIPFLOP_TEST_DATA) + "/" + name;
  std::ifstream file(path, std::ios::binary);
  Cloud cloud;
  T xyz[3];
  while (file.read(reinterpret_cast<char*>(xyz), sizeof(xyz)))
  {
    cloud.push_back({ xyz[0], xyz[1], xyz[2] });
  }
  if (cloud.empty())
  {
    throw std::runtime_error("cannot read " + path);
  }
  return cloud;
}

/// A real cloud with the weight factor * z^power; z^0 is 1.
template <class T>
Input realInput(std::string name, const std::string& file, double factor, int power)
{
  return { std::move(name), 0,
    [=]()
    {
      Cloud cloud = readRaw<T>(file);
      for (Point& p : cloud)
      {
        p[2] = power == 2 ? factor * (p[2] * p[2]) : power == 1 ? factor * p[2] : factor;
      }
      return cloud;
    } };
}

/// The next line's rest, after the word that it must begin with.
std::istringstream expectLine(std::istream& file, const std::string& word)
{
  std::string line;
  std::getline(file, line);
  if (line.compare(0, word.size() + 1, word + " ") != 0)
  {
    throw std::runtime_error("a baseline lacks its line '" + word + "'");
  }
  return std::istringstream(line.substr(word.size() + 1));
}

}

std::vector<Input> baselineInputs()
{
  std::vector<Input> inputs = {
    { "spot", 0, []() { return readRaw<float>("spot.f32"); } },
    { "sainthelens_step3", 0, []() { return readRaw<float>("sainthelens_step3.f32"); } },
    { "autzen_thin_las", 0, []() { return readRaw<double>("autzen_thin_las.f64"); } },
    { "grid12", 0, []() { return integerGrid(12); } },
    { "cubeSurfaceGrid20rotated", 0, []() { return rotated(cubeSurfaceGrid(20)); } },
    { "cubeSurfaceGrid20float", 0, []() { return roundedToFloat(rotated(cubeSurfaceGrid(20))); } },
    { "cospherical5201", 0, []() { return cosphericalIntegers(5201); } },
    { "latticeTetrahedron20rotated", 0, []() { return rotated(latticeTetrahedron(20)); } },
  };
  for (const char* name : { "cube", "boxFaces", "clustered", "far15", "coplanarAndOutlier",
         "collinearAlmost", "planeXyz0", "smallIntegers" })
  {
    inputs.push_back(fromFamily(name, 20000, 500));
  }
  for (const char* name : { "ball", "shell1e2", "thin200", "skewNeedle", "skewPlane", "doubled" })
  {
    inputs.push_back(fromFamily(name, 3000, 501));
  }
  for (const char* name : { "shell0", "paraboloid", "momentCurve" })
  {
    inputs.push_back(fromFamily(name, 600, 502));
  }
  return inputs;
}

std::vector<Input> realWeightedInputs()
{
  const std::string autzen = "autzen_thin_las.f64";
  const std::string helens = "sainthelens_step3.f32";
  return {
    realInput<double>("autzenPlain", autzen, 0, 0),
    realInput<double>("autzenHeights", autzen, 20, 1),
    realInput<double>("autzenSquares", autzen, 1, 2),
    realInput<float>("helensPlain", helens, 0, 0),
    realInput<float>("helensHeights", helens, 1, 1),
    realInput<float>("helensSquares", helens, 8, 2),
    // Three points were taken for hidden: the kernel point's place was on the line of a border's
    // edge.
    { "nearCollinear2200", 0, []() { return readRaw<double>("near_collinear_2200.f64"); } },
  };
}

std::vector<Input> weightedBaselineInputs()
{
  std::vector<Input> inputs;
  for (const Input& input : realWeightedInputs())
  {
    if (input.name == "autzenSquares" || input.name == "helensSquares")
    {
      inputs.push_back(input);
    }
  }
  inputs.push_back({ "circle160225", 0, []() { return cocircularIntegers(160225); } });
  inputs.push_back(
    { "squareGrid30rounded", 0, []() { return scaled(squareGrid(30), 0.1, 0.1, 1); } });
  for (const char* name : { "uniformHiding", "smallIntegers", "coplanarLiftsAlmost" })
  {
    inputs.push_back(fromWeightedFamily(name, 20000, 600));
  }
  for (const char* name :
    { "uniformHeavy", "gridOfManyWeights", "clusters", "far15", "lineAlongX" })
  {
    inputs.push_back(fromWeightedFamily(name, 2500, 601));
  }
  for (Input& input : inputs)
  {
    // Some families have the name of one of hulls.
    input.name = "weighted_" + input.name;
  }
  return inputs;
}

std::string hashOf(const Cloud& cloud)
{
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const Point& p : cloud)
  {
    for (double x : p)
    {
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof(bits));
      for (int shift = 0; shift < 64; shift += 8)
      {
        hash = (hash ^ (bits >> shift & 0xff)) * 0x100000001b3u;
      }
    }
  }
  char text[17];
  std::snprintf(text, sizeof(text), "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

void writeBaseline(
  const std::string& path, const std::string& kind, const Input& input, const ReferenceHull& hull)
{
  const Cloud cloud = input.make();
  std::ofstream file(path, std::ios::binary);
  file << kind << " " << input.name << "\npoints " << cloud.size() << "\nhash " << hashOf(cloud)
       << "\ndimension " << hull.dimension << "\ncells " << hull.cells.size() << "\n";
  for (const Cell& cell : hull.cells)
  {
    file << toString(cell) << "\n";
  }
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + path);
  }
}

Baseline readBaseline(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    throw std::runtime_error("cannot read " + path);
  }
  Baseline result;
  std::size_t cells = 0;
  file >> result.kind >> std::ws;
  if (result.kind != "hull" && result.kind != "triangulation")
  {
    throw std::runtime_error(path + " is no baseline");
  }
  std::string name;
  std::getline(file, name);
  expectLine(file, "points") >> result.points;
  expectLine(file, "hash") >> result.hash;
  expectLine(file, "dimension") >> result.hull.dimension;
  expectLine(file, "cells") >> cells;
  std::string line;
  while (std::getline(file, line))
  {
    std::istringstream words(line);
    Cell cell;
    for (std::int64_t id; words >> id;)
    {
      cell.push_back(id);
    }
    result.hull.cells.push_back(std::move(cell));
  }
  result.hull.ids = idsIn(result.hull.cells);
  if (result.hull.cells.size() != cells)
  {
    throw std::runtime_error(path + " is cut short");
  }
  return result;
}

}
}
