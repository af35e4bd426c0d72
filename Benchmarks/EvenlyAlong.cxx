// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"

namespace flipflop
{
namespace
{

double distance(const SpacePoint& a, const SpacePoint& b)
{
  return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

}

Coordinates evenlyAlong(const std::vector<Line>& lines, std::int64_t count)
{
  double total = 0;
  for (const Line& line : lines)
  {
    for (std::size_t k = 1; k < line.size(); ++k)
    {
      total += distance(line[k - 1], line[k]);
    }
  }
  Coordinates points;
  points.reserve(3 * static_cast<std::size_t>(count));
  const auto placeOf = [&](std::size_t i)
  { return total * ((static_cast<double>(i) + 0.5) / static_cast<double>(count)); };
  // The same sum once more: the last place is before its end.
  double passed = 0;
  for (const Line& line : lines)
  {
    for (std::size_t k = 1; k < line.size(); ++k)
    {
      const SpacePoint& a = line[k - 1];
      const SpacePoint& b = line[k];
      const double length = distance(a, b);
      while (placeOf(points.size() / 3) < passed + length)
      {
        const double t = (placeOf(points.size() / 3) - passed) / length;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          points.push_back(a[axis] + t * (b[axis] - a[axis]));
        }
      }
      passed += length;
    }
  }
  return points;
}

}
