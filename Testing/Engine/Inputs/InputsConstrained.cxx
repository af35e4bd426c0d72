// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Inputs/InputsConstrained.h"

#include <cmath>
#include <fstream>
#include <stdexcept>

namespace flipflop
{
namespace test
{

namespace
{

/// A ragged ring around (x, y), counter-clockwise, or clockwise for what is no land; in doubles
/// between a half and the whole of the radius from its middle. It is a star, so it is simple.
void addShore(ConstrainedInput& map, int corners, double x, double y, double radius, bool isLand,
  Random& random)
{
  const auto first = static_cast<std::int64_t>(map.cloud.size());
  double reach = 0.75;
  for (int i = 0; i < corners; ++i)
  {
    reach += random.uniform(-0.1, 0.1);
    reach = std::fmin(0.97, std::fmax(0.55, reach));
    const double angle = (isLand ? 6.2831853 : -6.2831853) * i / corners;
    map.cloud.push_back(
      { x + reach * radius * std::cos(angle), y + reach * radius * std::sin(angle), 0 });
    map.segments.push_back({ first + i, first + (i + 1) % corners });
  }
  map.sides += corners;
}

/// A shore, and others in it, in a row, of a third the size; land and water take turns.
void addNested(
  ConstrainedInput& map, int corners, double x, double y, double radius, int depth, Random& random)
{
  addShore(map, corners, x, y, radius, depth % 2 == 0, random);
  if (depth < 3)
  {
    // Within half the radius nothing of the shore is.
    for (const double side : { -0.25, 0.25 })
    {
      addNested(map, corners / 2 + 3, x + side * radius, y, 0.24 * radius, depth + 1, random);
    }
  }
}

}

ConstrainedInput coast(int corners, Random& random)
{
  ConstrainedInput map;
  addNested(map, corners / 4, 100, -40, 10, 0, random);
  for (int i = 0; i < corners / 4; ++i)
  {
    map.cloud.push_back({ random.uniform(88, 112), random.uniform(-52, -28), 0 });
  }
  return map;
}

ConstrainedInput contours()
{
  std::ifstream file(FLIPFLOP_TEST_DATA "/../../Data/sainthelens-contours.f32", std::ios::binary);
  ConstrainedInput map;
  float xy[2];
  bool goesOn = false; // two NaNs end a polyline
  while (file.read(reinterpret_cast<char*>(xy), sizeof(xy)))
  {
    const auto id = static_cast<std::int64_t>(map.cloud.size());
    if (!std::isnan(xy[0]))
    {
      map.cloud.push_back({ xy[0], xy[1], 0 });
      if (goesOn)
      {
        map.segments.push_back({ id - 1, id });
      }
    }
    goesOn = !std::isnan(xy[0]);
  }
  if (map.cloud.empty())
  {
    throw std::runtime_error("there are no contours");
  }
  return map;
}

ConstrainedInput streets(int count, Random& random)
{
  ConstrainedInput map;
  const double step = 1.5 / std::sqrt(count);
  for (int i = 0; i < count; ++i)
  {
    const double x = random.uniform(), y = random.uniform();
    const double reach = i % 200 == 0 ? 0.5 : step;
    double dx = random.uniform(-reach, reach), dy = random.uniform(-reach, reach);
    if (i % 3 == 0) // parallel to a grid's directions, which are not the axes'
    {
      const bool isAcross = random.integer(0, 1) == 0;
      dx = isAcross ? dx : -0.25 * dy;
      dy = isAcross ? 0.25 * dx : dy;
    }
    const auto id = static_cast<std::int64_t>(map.cloud.size());
    map.cloud.push_back({ x, y, 0 });
    map.cloud.push_back({ x + dx, y + dy, 0 });
    map.segments.push_back({ id, id + 1 });
  }
  return map;
}

}
}
