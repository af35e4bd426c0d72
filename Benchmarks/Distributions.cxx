// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Distributions.h"

#include "RandomPoints.h"
#include "ShapesInUse.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <vector>

namespace flipflop
{
namespace
{

using Point = SpacePoint;
using Random = RandomPoints;

/// At distance @p radius from the centre of the unit cube.
Point onSphere(Random& random, double radius)
{
  const Point p = random.direction();
  return { 0.5 + radius * p[0], 0.5 + radius * p[1], 0.5 + radius * p[2] };
}

Point inShell(Random& random, double thickness)
{
  const double inner = 0.5 - thickness;
  const double a = inner * inner * inner;
  return onSphere(random, std::cbrt(a + random.uniform() * (0.125 - a)));
}

Point inBox(Random& random, double thickness)
{
  for (;;)
  {
    const Point p = random.inCube();
    for (const double x : p)
    {
      if (x <= thickness || x >= 1 - thickness)
      {
        return p;
      }
    }
  }
}

Coordinates grid(std::int64_t count)
{
  const auto side = std::max<std::int64_t>(2, std::llround(std::cbrt(static_cast<double>(count))));
  Coordinates points;
  points.reserve(static_cast<std::size_t>(side * side * side) * 3);
  for (std::int64_t z = 0; z < side; ++z)
  {
    for (std::int64_t y = 0; y < side; ++y)
    {
      for (std::int64_t x = 0; x < side; ++x)
      {
        points.insert(
          points.end(), { static_cast<double>(x), static_cast<double>(y), static_cast<double>(z) });
      }
    }
  }
  return points;
}

Coordinates surfaceGrid(std::int64_t count)
{
  // 6 (side - 1)^2 + 2 points
  const double edge = std::sqrt(static_cast<double>(std::max<std::int64_t>(count - 2, 6)) / 6.0);
  const std::int64_t last = std::max<std::int64_t>(1, std::llround(edge));
  Coordinates points;
  points.reserve(static_cast<std::size_t>(6 * last * last + 2) * 3);
  for (std::int64_t z = 0; z <= last; ++z)
  {
    for (std::int64_t y = 0; y <= last; ++y)
    {
      const bool whole = z == 0 || z == last || y == 0 || y == last;
      for (std::int64_t x = 0; x <= last; x += whole ? 1 : last)
      {
        points.insert(
          points.end(), { static_cast<double>(x), static_cast<double>(y), static_cast<double>(z) });
      }
    }
  }
  return points;
}

Coordinates squareGrid(std::int64_t count, double weight)
{
  const auto side = std::max<std::int64_t>(2, std::llround(std::sqrt(static_cast<double>(count))));
  std::int64_t i = 0;
  return samplePoints(side * side,
    [&]
    {
      const Point p = { static_cast<double>(i % side), static_cast<double>(i / side), weight };
      ++i;
      return p;
    });
}

Point onCircle(Random& random)
{
  for (;;)
  {
    const double x = 2 * random.uniform() - 1;
    const double y = 2 * random.uniform() - 1;
    const double square = x * x + y * y;
    if (square > 1e-2 && square <= 1)
    {
      const double length = 2 * std::sqrt(square);
      return { 0.5 + x / length, 0.5 + y / length, 0 };
    }
  }
}

Coordinates clusters(Random& random, std::int64_t count)
{
  const Coordinates centers = samplePoints(100, [&] { return random.inCube(); });
  return samplePoints(count,
    [&]
    {
      const std::size_t i = random.next() % 100 * 3;
      // Box and Muller, 1958
      const double radius = 0.01 * std::sqrt(-2 * std::log(1 - random.uniform()));
      const double angle = 2 * 3.14159265358979323846 * random.uniform();
      return Point{ centers[i] + radius * std::cos(angle),
        centers[i + 1] + radius * std::sin(angle), 0 };
    });
}

Coordinates scanLines(Random& random, std::int64_t count)
{
  // Half a metre from point to point along a line, and from line to line.
  const auto side = std::max<std::int64_t>(2, std::llround(std::sqrt(static_cast<double>(count))));
  std::int64_t i = 0;
  const auto centimetres = [](double x) { return 0.01 * std::round(100 * x); };
  return samplePoints(count,
    [&]
    {
      // The scanner turns on while the plane flies: lines lie askew, every second the other way.
      const std::int64_t line = i / side;
      const std::int64_t place = line % 2 ? side - 1 - i % side : i % side;
      const double along = 0.5 * (static_cast<double>(place) + 0.4 * random.uniform());
      const double across =
        0.5 * (static_cast<double>(i) / static_cast<double>(side)) + 0.1 * random.uniform();
      ++i;
      return Point{ 480000 + centimetres(along), 4420000 + centimetres(across), 0 };
    });
}

Coordinates duplicates(Random& random, std::int64_t count)
{
  const std::int64_t different = std::max<std::int64_t>(4, count / 100);
  const Coordinates pool = samplePoints(different, [&] { return onSphere(random, 0.5); });
  return samplePoints(count,
    [&]
    {
      const std::size_t i = random.next() % static_cast<std::uint64_t>(different) * 3;
      return Point{ pool[i], pool[i + 1], pool[i + 2] };
    });
}

/// Exactly in a plane: sums of so few bits are not rounded.
Point inPlane(Random& random)
{
  const auto few = [](double x) { return std::floor(0x1p40 * x) * 0x1p-40; };
  const double x = few(random.uniform());
  const double y = few(random.uniform());
  return { x, y, x + y };
}

/// Exactly on a line.
Point onLine(Random& random)
{
  const double x = random.uniform();
  return { x, 2 * x, 0 };
}

Coordinates repeats(Random& random, std::int64_t count)
{
  const std::int64_t different = std::max<std::int64_t>(4, count / 2);
  const Coordinates pool = samplePoints(different,
    [&] {
      return Point{ random.uniform(), random.uniform(), 0 };
    });
  return samplePoints(count,
    [&]
    {
      const std::size_t i = random.next() % static_cast<std::uint64_t>(different) * 3;
      return Point{ pool[i], pool[i + 1], 0 };
    });
}

template <class Scalar>
Coordinates readScalars(std::FILE* file)
{
  Coordinates points;
  Scalar xyz[3];
  while (std::fread(xyz, sizeof(xyz), 1, file) == 1)
  {
    points.insert(points.end(), xyz, xyz + 3);
  }
  return points;
}

Coordinates readPoints(const Distribution& distribution)
{
  const std::string& path = distribution.file;
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (!file)
  {
    throw std::invalid_argument("cannot read " + path);
  }
  Coordinates points =
    path.substr(path.size() - 4) == ".f32" ? readScalars<float>(file) : readScalars<double>(file);
  std::fclose(file);
  for (std::size_t i = 2; distribution.family == Family::Plane && i < points.size(); i += 3)
  {
    points[i] = 0;
  }
  return points;
}

/// The file's name without folders and ending.
std::string stem(const std::string& path)
{
  const std::size_t slash = path.rfind('/');
  const std::size_t begin = slash == std::string::npos ? 0 : slash + 1;
  return path.substr(begin, path.rfind('.') - begin);
}

bool isIn(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string list(const std::vector<std::string>& names)
{
  std::string all;
  for (const std::string& name : names)
  {
    all += (all.empty() ? "" : ", ") + name;
  }
  return all;
}

/// @throw std::invalid_argument
Distribution fromFile(const std::string& path, Family family)
{
  const std::string ending = path.size() > 4 ? path.substr(path.size() - 4) : "";
  if (ending != ".f32" && ending != ".f64")
  {
    throw std::invalid_argument("neither .f32 nor .f64: " + path);
  }
  Distribution result;
  result.name = stem(path);
  result.file = path;
  result.family = family;
  return result;
}

}

std::string Distribution::label() const
{
  if (!this->hasParameter())
  {
    return this->name;
  }
  char text[64];
  std::snprintf(text, sizeof(text), "%s:%g", this->name.c_str(), this->parameter);
  return text;
}

bool Distribution::isWeighted() const
{
  return this->file.empty() &&
    (this->name == "weighted-grid" || (this->name == "uniform" && this->parameter > 0) ||
      isWeightedShape(this->name));
}

Distribution Distribution::parse(const std::string& text, Family family)
{
  const std::vector<std::string> shapes = shapesInUse(family == Family::Space);
  static const std::vector<std::string> space = { "cube", "ball", "box", "shell", "grid",
    "surface-grid", "rotated-grid", "duplicates", "coplanar" };
  static const std::vector<std::string> plane = { "uniform", "square-grid", "weighted-grid",
    "circle", "clusters", "collinear", "scan", "repeats" };
  const std::vector<std::string>& others = family == Family::Space ? space : plane;
  Distribution result;
  result.family = family;
  const std::size_t colon = text.find(':');
  result.name = text.substr(0, colon);
  if (result.name == "file" && colon != std::string::npos)
  {
    return fromFile(text.substr(colon + 1), family);
  }
  if (!isIn(others, result.name) && !isIn(withShuffled(shapes), result.name))
  {
    throw std::invalid_argument("unknown distribution: " + text + "; there are " + list(others) +
      ", file:PATH; and in use, also as NAME-shuffled: " + list(shapes) +
      "; or all of the latter: in-use");
  }
  const bool thick = result.hasParameter() && family == Family::Space;
  result.parameter = thick ? 0.01 : 0;
  if (colon != std::string::npos)
  {
    std::size_t used = 0;
    const std::string value = text.substr(colon + 1);
    result.parameter = value.empty() ? -1 : std::stod(value, &used);
    if (!result.hasParameter() || used != value.size() || !(result.parameter >= 0) ||
      result.parameter > (thick ? 0.5 : 1e6) || (result.name == "box" && result.parameter == 0))
    {
      throw std::invalid_argument("not a parameter: " + text);
    }
  }
  return result;
}

std::vector<Distribution> distributionsInUse(Family family)
{
  std::vector<Distribution> all;
  for (const std::string& name : withShuffled(shapesInUse(family == Family::Space)))
  {
    all.push_back(Distribution::parse(name, family));
  }
  return all;
}

Coordinates makePoints(const Distribution& distribution, std::int64_t count, std::uint64_t seed)
{
  if (!distribution.file.empty())
  {
    return readPoints(distribution);
  }
  if (isIn(withShuffled(shapesInUse(distribution.family == Family::Space)), distribution.name))
  {
    return makeShapeInUse(distribution.name, count, seed);
  }
  Random random(seed);
  const double thickness = distribution.parameter;
  if (distribution.name == "uniform")
  {
    const double most = distribution.parameter / static_cast<double>(count);
    return samplePoints(count,
      [&] {
        return Point{ random.uniform(), random.uniform(), most > 0 ? most * random.uniform() : 0 };
      });
  }
  if (distribution.name == "square-grid" || distribution.name == "weighted-grid")
  {
    return squareGrid(count, distribution.isWeighted() ? 1 : 0);
  }
  if (distribution.name == "circle")
  {
    return samplePoints(count, [&] { return onCircle(random); });
  }
  if (distribution.name == "clusters")
  {
    return clusters(random, count);
  }
  if (distribution.name == "collinear")
  {
    return samplePoints(count, [&] { return onLine(random); });
  }
  if (distribution.name == "scan")
  {
    return scanLines(random, count);
  }
  if (distribution.name == "cube")
  {
    return samplePoints(count, [&] { return random.inCube(); });
  }
  if (distribution.name == "ball")
  {
    return samplePoints(count, [&] { return inShell(random, 0.5); });
  }
  if (distribution.name == "box")
  {
    return samplePoints(count, [&] { return inBox(random, thickness); });
  }
  if (distribution.name == "shell" && thickness > 0)
  {
    return samplePoints(count, [&] { return inShell(random, thickness); });
  }
  if (distribution.name == "shell")
  {
    return samplePoints(count, [&] { return onSphere(random, 0.5); });
  }
  if (distribution.name == "duplicates")
  {
    return duplicates(random, count);
  }
  if (distribution.name == "coplanar")
  {
    return samplePoints(count, [&] { return inPlane(random); });
  }
  if (distribution.name == "repeats")
  {
    return repeats(random, count);
  }
  if (distribution.name == "grid")
  {
    return grid(count);
  }
  Coordinates points = surfaceGrid(count);
  if (distribution.name == "rotated-grid")
  {
    rotate(points);
  }
  return points;
}

}
