// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Inputs/InputsInUse.h"
#include "Testing/Engine/Inputs/InputMaking.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace flipflop
{
namespace test
{
namespace
{

const std::string Shuffled = "-shuffled";

Cloud cubeGrid(int count, Random&)
{
  return integerGrid(std::max(2, static_cast<int>(std::lround(std::cbrt(count)))));
}

Cloud surfaceGrid(int count, Random&)
{
  // 6 (side - 1)^2 + 2 points
  const double edge = std::sqrt(std::max(count - 2, 6) / 6.0);
  return cubeSurfaceGrid(1 + static_cast<int>(std::lround(edge)));
}

/// So many at each position. @param make Point (Random&): one of the positions
template <class Make>
Family::Make spread(int times, const Make& make)
{
  return [=](int count, Random& random)
  {
    const Cloud positions = generate(std::max(4, count / times), [&](int) { return make(random); });
    Cloud cloud = generate(
      count, [&](int i) { return positions[static_cast<std::size_t>(i) % positions.size()]; });
    random.shuffle(cloud);
    return cloud;
  };
}

/// Sums of so few bits are not rounded.
Point inPlane(Random& random)
{
  const auto few = [](double x) { return std::floor(0x1p40 * x) * 0x1p-40; };
  const double x = few(random.uniform());
  const double y = few(random.uniform());
  return { x, y, x + y };
}

Cloud hundredNormals(int count, Random& random)
{
  const Cloud centers = generate(100, [&](int) { return inCube(random); });
  return generate(count,
    [&](int)
    {
      const Point& center = centers[random.pick(100)];
      // Box and Muller, 1958
      const double radius = 0.01 * std::sqrt(-2 * std::log(1 - random.uniform()));
      const Point p = onCircle(Turn * random.uniform(), radius);
      return Point{ center[0] + p[0], center[1] + p[1], 0 };
    });
}

/// Half a metre from point to point along a line, and from line to line. The scanner turns while
/// the plane flies: lines lie askew, every second the other way.
Point onScan(Random& random, int i, int count)
{
  const int side = std::max(2, static_cast<int>(std::lround(std::sqrt(count))));
  const int step = i / side % 2 ? side - 1 - i % side : i % side;
  const double along = 0.5 * (step + 0.4 * random.uniform());
  const double across = 0.5 * (double(i) / side) + 0.1 * random.uniform();
  return { 480000 + toStep(along, 100), 4420000 + toStep(across, 100), 0 };
}

const std::vector<Family>& otherFamilies(bool isPlane)
{
  static const std::vector<Family> space = { { "shell1e3", shell(0.001) },
    { "cube-grid", cubeGrid }, { "surface-grid", surfaceGrid },
    { "rotated-grid", changed(surfaceGrid, rotated) },
    { "duplicates", spread(100, [](Random& random) { return random.direction(); }) },
    { "coplanar", each(inPlane) } };
  static const std::vector<Family> plane = { { "hundred-normals", hundredNormals },
    { "scan", each(onScan) },
    { "repeats",
      spread(2,
        [](Random& random) {
          return Point{ random.uniform(), random.uniform(), 0 };
        }) } };
  return isPlane ? plane : space;
}

using Lists = std::vector<const std::vector<Family>*>;

Lists listsInUse(bool isPlane)
{
  return { isPlane ? &familiesInPlane() : &familiesInSpace() };
}

std::vector<std::string> namesOf(const Lists& lists)
{
  std::vector<std::string> names;
  for (const auto* list : lists)
  {
    for (const Family& family : *list)
    {
      names.emplace_back(family.name);
    }
  }
  return names;
}

}

std::vector<std::string> namesInUse(bool isPlane)
{
  return namesOf(listsInUse(isPlane));
}

std::vector<std::string> withShuffled(const std::vector<std::string>& names)
{
  std::vector<std::string> both;
  for (const std::string& name : names)
  {
    both.push_back(name);
    both.push_back(name + Shuffled);
  }
  return both;
}

Cloud makeCloud(const std::string& name, bool isPlane, int count, std::uint64_t seed)
{
  const bool isShuffled = name.size() > Shuffled.size() &&
    name.compare(name.size() - Shuffled.size(), Shuffled.size(), Shuffled) == 0;
  const std::string plain = isShuffled ? name.substr(0, name.size() - Shuffled.size()) : name;
  Lists lists = listsInUse(isPlane);
  lists.push_back(&otherFamilies(isPlane));
  lists.push_back(isPlane ? &weightedFamilies() : &families());
  for (const auto* list : lists)
  {
    for (const Family& family : *list)
    {
      if (family.name == plain)
      {
        Random random(seed);
        Cloud cloud = family.make(count, random);
        if (isShuffled)
        {
          random.shuffle(cloud);
        }
        return cloud;
      }
    }
  }
  std::string known;
  for (const std::string& other : namesOf(lists))
  {
    known += (known.empty() ? "" : ", ") + other;
  }
  throw std::invalid_argument(
    "unknown family: " + name + "; known, also with " + Shuffled + " behind the name: " + known);
}

}
}
