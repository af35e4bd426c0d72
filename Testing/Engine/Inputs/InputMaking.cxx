// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Inputs/InputMaking.h"

#include <cmath>
#include <fstream>
#include <stdexcept>

namespace flipflop
{
namespace test
{
namespace
{

double distance(const Point& a, const Point& b)
{
  return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

}

Point inCube(Random& random, double low, double high)
{
  const double x = random.uniform(low, high);
  const double y = random.uniform(low, high);
  const double z = random.uniform(low, high);
  return { x, y, z };
}

Cloud evenlyAlong(const std::vector<Line>& lines, int count)
{
  double total = 0;
  for (const Line& line : lines)
  {
    for (std::size_t k = 1; k < line.size(); ++k)
    {
      total += distance(line[k - 1], line[k]);
    }
  }
  Cloud points;
  points.reserve(static_cast<std::size_t>(count));
  const auto position = [&] { return total * ((double(points.size()) + 0.5) / count); };
  // The same sum again: the last position is before its end.
  double passed = 0;
  for (const Line& line : lines)
  {
    for (std::size_t k = 1; k < line.size(); ++k)
    {
      const Point& a = line[k - 1];
      const Point& b = line[k];
      const double length = distance(a, b);
      while (position() < passed + length)
      {
        const double t = (position() - passed) / length;
        points.push_back(
          { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]) });
      }
      passed += length;
    }
  }
  return points;
}

std::vector<Line> contourLines()
{
  std::ifstream file(FLIPFLOP_TEST_DATA "/../../Data/sainthelens-contours.f32", std::ios::binary);
  std::vector<Line> lines(1);
  float xy[2];
  while (file.read(reinterpret_cast<char*>(xy), sizeof(xy)))
  {
    if (std::isnan(xy[0]))
    {
      lines.emplace_back();
    }
    else
    {
      lines.back().push_back({ xy[0], xy[1], 0 });
    }
  }
  if (lines.size() == 1)
  {
    throw std::runtime_error("there are no contours");
  }
  return lines;
}

}
}
