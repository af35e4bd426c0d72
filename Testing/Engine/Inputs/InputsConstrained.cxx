// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Inputs/InputsConstrained.h"
#include "Testing/Engine/Inputs/InputMaking.h"

#include <cmath>
#include <map>
#include <utility>

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
  ConstrainedInput map;
  for (const Line& line : contourLines())
  {
    for (std::size_t i = 0; i < line.size(); ++i)
    {
      const auto id = static_cast<std::int64_t>(map.cloud.size());
      map.cloud.push_back(line[i]);
      if (i > 0)
      {
        map.segments.push_back({ id - 1, id });
      }
    }
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

ConstrainedInput gridWithSteps(int count, int step, int most, Random& random)
{
  const int side = rowOf(count);
  ConstrainedInput map;
  map.cloud = generate(side * side,
    [&](int i)
    {
      const double x = i % side + 0.8 * random.uniform();
      return Point{ x, i / side + 0.8 * random.uniform(), 0 };
    });
  for (std::int64_t y = 0; y < side; y += 2)
  {
    for (std::int64_t x = 0; x + step < side && map.segments.size() < std::size_t(most); x += step)
    {
      map.segments.push_back({ y * side + x, y * side + x + step });
    }
  }
  return map;
}

ConstrainedInput streetsAmongPoints(int count, Random& random)
{
  ConstrainedInput map;
  const double reach = 5 / std::sqrt(count);
  for (int i = 0; i < count / 10; ++i)
  {
    const double most = i % 1000 == 0 ? 0.3 : reach;
    const Point p = { random.uniform(), random.uniform(), 0 };
    map.cloud.push_back(p);
    map.cloud.push_back(
      { p[0] + random.uniform(-most, most), p[1] + random.uniform(-most, most), 0 });
    map.segments.push_back({ 2 * std::int64_t(i), 2 * std::int64_t(i) + 1 });
  }
  while (map.cloud.size() < static_cast<std::size_t>(count))
  {
    map.cloud.push_back({ random.uniform(), random.uniform(), 0 });
  }
  return map;
}

ConstrainedInput contoursAmongPoints(int count, Random& random)
{
  ConstrainedInput map;
  double high[2] = { 0, 0 };
  std::map<Point, std::int64_t> idAt; // closed lines end where they began
  for (const Line& line : contourLines())
  {
    std::int64_t last = -1;
    for (const Point& p : line)
    {
      const auto next = static_cast<std::int64_t>(map.cloud.size());
      const auto found = idAt.emplace(p, next);
      const std::int64_t id = found.first->second;
      if (found.second)
      {
        map.cloud.push_back(p);
        high[0] = std::fmax(high[0], p[0]);
        high[1] = std::fmax(high[1], p[1]);
      }
      if (last >= 0 && last != id)
      {
        map.segments.push_back({ last, id });
      }
      last = id;
    }
  }
  for (int i = 0; i < count; ++i)
  {
    const double x = high[0] * random.uniform();
    map.cloud.push_back({ x, high[1] * random.uniform(), 0 });
  }
  return map;
}

}
}
