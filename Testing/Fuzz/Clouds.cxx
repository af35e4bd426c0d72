// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Clouds.h"
#include "Testing/Engine/Inputs/InputsInUse.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipflop
{
namespace fuzz
{

namespace
{

/// Sizes of clouds that a generator makes. The engine takes samples from 2,048 points on.
int drawCount(Bytes& bytes, int most)
{
  const int size = bytes.byte();
  const int count = size < 128 ? size : size < 252 ? 4 * (size - 96) : 2040 + 3 * bytes.byte();
  return std::min(count, most);
}

std::vector<std::string> namesOf(bool isPlane)
{
  std::vector<std::string> names = test::namesInUse(isPlane);
  for (const test::Family& family : isPlane ? test::weightedFamilies() : test::families())
  {
    names.push_back(family.name);
  }
  return names;
}

/// Of the tests' families, and of those in use: points on lines, rims, walls and grids, which
/// rounding does not quite keep.
Cloud drawFamily(Bytes& bytes, int most)
{
  static const std::vector<std::string> names[2] = { namesOf(false), namesOf(true) };
  const bool isPlane = bytes.flag();
  const std::string& name =
    names[isPlane][static_cast<std::size_t>(bytes.below(128)) % names[isPlane].size()];
  const int count = drawCount(bytes, most);
  return test::makeCloud(name, isPlane, count, bytes.raw<std::uint16_t>());
}

/// Numbers out of the bytes: each its own, or of a palette of a few.
Cloud drawNumbers(Bytes& bytes, bool any)
{
  std::vector<double> palette;
  for (int n = bytes.below(8); n > 0; --n)
  {
    palette.push_back(bytes.number());
  }
  Cloud cloud;
  for (int n = bytes.below(40); n > 0; --n)
  {
    Point p;
    for (double& x : p)
    {
      x = !palette.empty() ? palette[static_cast<std::size_t>(bytes.byte()) % palette.size()]
        : any              ? bytes.number()
                           : static_cast<double>(bytes.raw<std::int8_t>() / 16);
    }
    cloud.push_back(p);
  }
  return cloud;
}

/// To where differences overflow, or are a unit of the last place, or the least that there is.
void toExtremes(Cloud& cloud, int kind, std::size_t axis)
{
  using Limits = std::numeric_limits<double>;
  double most = 0;
  for (const Point& p : cloud)
  {
    most = std::isfinite(p[axis]) ? std::max(most, std::fabs(p[axis])) : most;
  }
  for (Point& p : cloud)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      double& x = p[k];
      const double share = most > 0 ? std::clamp(x / most, -1.0, 1.0) : 0;
      switch (kind)
      {
        case 0: // as large as numbers get
          x = share * Limits::max();
          break;
        case 1: // units of the last place beside one
          x = 1 + std::floor(4 * share) * Limits::epsilon();
          break;
        case 2: // the least numbers along one axis
          x = k == axis ? std::floor(4 * share) * Limits::denorm_min() : x;
          break;
        default: // a plane of the largest numbers, nearly
          x = k == axis ? std::floor(2 * share) * Limits::denorm_min() : share * Limits::max();
          break;
      }
    }
  }
}

/// Some changes to a cloud that is there. Numbers of very different sizes are for small ones only:
/// a large one would keep the widest integers busy for minutes.
void change(Bytes& bytes, Cloud& cloud, int most)
{
  constexpr std::size_t small = 300;
  for (int times = bytes.below(4); times > 0 && !cloud.empty(); --times)
  {
    const std::size_t at = bytes.raw<std::uint16_t>() % cloud.size();
    const auto axis = static_cast<std::size_t>(bytes.below(3));
    const int kind = bytes.byte();
    if (kind >= 192)
    {
      if (cloud.size() <= small)
      {
        toExtremes(cloud, kind % 4, axis);
      }
      continue;
    }
    switch (kind % 8)
    {
      case 1: // the same point again
        cloud[bytes.raw<std::uint16_t>() % cloud.size()] = cloud[at];
        break;
      case 2: // beside it
        cloud[at][axis] = std::nextafter(cloud[at][axis], bytes.flag() ? 1e300 : -1e300);
        break;
      case 3: // all of them again
        if (cloud.size() <= static_cast<std::size_t>(most) / 2)
        {
          cloud.insert(cloud.end(), cloud.begin() + static_cast<std::ptrdiff_t>(at), cloud.end());
        }
        break;
      case 4: // all on a plane
      {
        const double value = cloud[at][axis];
        for (Point& p : cloud)
        {
          p[axis] = value;
        }
        break;
      }
      case 5: // smaller, larger
      {
        const int exponent = 8 * bytes.raw<std::int8_t>();
        for (Point& p : cloud)
        {
          for (double& x : p)
          {
            x = std::ldexp(x, exponent);
          }
        }
        break;
      }
      case 6: // elsewhere
      {
        const double step = cloud.size() <= small ? bytes.number() : bytes.raw<std::int8_t>();
        for (Point& p : cloud)
        {
          p[axis] += step;
        }
        break;
      }
      case 7: // thin
      {
        const int exponent = -bytes.byte() / (cloud.size() <= small ? 1 : 8);
        for (Point& p : cloud)
        {
          p[axis] = std::ldexp(p[axis], exponent);
        }
        break;
      }
      default:
        cloud[at][axis] = cloud.size() <= small ? bytes.number() : bytes.raw<std::int8_t>();
        break;
    }
  }
}

}

Cloud drawCloud(Bytes& bytes, int most)
{
  const int kind = bytes.below(8);
  Cloud cloud = kind < 5 ? drawNumbers(bytes, kind > 2) : drawFamily(bytes, most);
  change(bytes, cloud, most);
  return cloud;
}

void drawWeights(Bytes& bytes, Cloud& cloud)
{
  const int kind = bytes.below(6);
  const double one = kind == 1 || kind == 5 ? bytes.number() : 0;
  for (Point& p : cloud)
  {
    switch (kind)
    {
      case 1: // the same for all
        p[2] = one;
        break;
      case 2: // lifts in one plane, but for rounding
        p[2] = p[0] * p[0] + p[1] * p[1];
        break;
      case 3:
        p[2] = cloud.size() <= 300 ? bytes.number() : bytes.raw<std::int8_t>();
        break;
      case 4: // small, of few values
        p[2] = bytes.raw<std::int8_t>() / 32;
        break;
      case 5: // nearly one plane's
        p[2] = p[0] * p[0] + p[1] * p[1] + one * bytes.raw<std::int8_t>();
        break;
      default: // as they are
        break;
    }
  }
}

NonFinite findNonFinite(const Cloud& cloud, int axes)
{
  NonFinite found;
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    if (!std::all_of(
          cloud[i].begin(), cloud[i].begin() + axes, [](double x) { return std::isfinite(x); }))
    {
      found.first = found.count++ ? found.first : static_cast<std::int64_t>(i);
    }
  }
  return found;
}

}
}
