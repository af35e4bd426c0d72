// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A cloud from another: moved, repeated, in another order, with what is not finite in between.
#include "Testing/Engine/Inputs/Inputs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace flipflop
{
namespace test
{

Cloud rotated(Cloud cloud)
{
  // From the quaternion (1, 2, 3, 4), so that only the products are rounded.
  static const double m[3][3] = { { -20.0 / 30, 4.0 / 30, 22.0 / 30 },
    { 20.0 / 30, -10.0 / 30, 20.0 / 30 }, { 10.0 / 30, 28.0 / 30, 4.0 / 30 } };
  for (Point& p : cloud)
  {
    const Point q = p;
    for (int r = 0; r < 3; ++r)
    {
      p[r] = m[r][0] * q[0] + m[r][1] * q[1] + m[r][2] * q[2];
    }
  }
  return cloud;
}

Cloud repeated(const Cloud& cloud, int times, Random& random)
{
  Cloud all;
  for (int i = 0; i < times; ++i)
  {
    all.insert(all.end(), cloud.begin(), cloud.end());
  }
  random.shuffle(all);
  return all;
}

Cloud scaled(Cloud cloud, double x, double y, double z)
{
  for (Point& p : cloud)
  {
    p = { p[0] * x, p[1] * y, p[2] * z };
  }
  return cloud;
}

Cloud moved(Cloud cloud, double x, double y, double z)
{
  for (Point& p : cloud)
  {
    p = { p[0] + x, p[1] + y, p[2] + z };
  }
  return cloud;
}

Cloud permuted(const Cloud& cloud, const std::vector<int>& order)
{
  Cloud result;
  for (int i : order)
  {
    result.push_back(cloud[i]);
  }
  return result;
}

std::vector<int> orderOf(const Cloud& cloud, std::uint64_t which)
{
  std::vector<int> order(cloud.size());
  std::iota(order.begin(), order.end(), 0);
  if (which == 0)
  {
    std::reverse(order.begin(), order.end());
  }
  else if (which == 1)
  {
    std::sort(order.begin(), order.end(), [&](int i, int j) { return cloud[i] < cloud[j]; });
  }
  else
  {
    Random(which).shuffle(order);
  }
  return order;
}

Cloud withNonFinite(const Cloud& cloud, Random& random, std::vector<std::int64_t>& places)
{
  Cloud result;
  for (const Point& p : cloud)
  {
    while (random.integer(0, 3) == 0)
    {
      Point q = p;
      q[random.integer(0, 2)] = random.integer(0, 1) ? std::numeric_limits<double>::quiet_NaN()
                                                     : -std::numeric_limits<double>::infinity();
      result.push_back(q);
    }
    places.push_back(static_cast<std::int64_t>(result.size()));
    result.push_back(p);
  }
  return result;
}

Cloud roundedToFloat(Cloud cloud)
{
  for (Point& p : cloud)
  {
    for (double& x : p)
    {
      // At -O3, GCC 12 vectorises this loop and forgets some of its numbers.
      volatile const float rounded = static_cast<float>(x);
      x = rounded;
    }
  }
  return cloud;
}

bool isFloat(const Cloud& cloud)
{
  for (const Point& p : cloud)
  {
    for (double x : p)
    {
      if (!(std::fabs(x) <= 3.4028234663852886e38) || static_cast<float>(x) != x)
      {
        return false;
      }
    }
  }
  return true;
}

Cloud joined(Cloud a, const Cloud& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}
}
