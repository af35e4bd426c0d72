// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Functions that the families of inputs share.
#ifndef flipflop_test_InputMaking_h
#define flipflop_test_InputMaking_h

#include "Testing/Engine/Inputs/Inputs.h"

#include <cmath>
#include <type_traits>

namespace flipflop
{
namespace test
{

/// @p count points. @param make Point (int): one by its number
template <class Make>
Cloud generate(int count, const Make& make)
{
  Cloud cloud;
  cloud.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    cloud.push_back(make(i));
  }
  return cloud;
}

constexpr double Turn = 6.283185307179586;

/// Uniform: x first, then y, then z.
Point inCube(Random& random, double low = 0, double high = 1);

/// On a circle, or a point of a helix at height z.
inline Point onCircle(double angle, double radius = 1, double z = 0)
{
  return { radius * std::cos(angle), radius * std::sin(angle), z };
}

inline Point times(const Point& p, double factor)
{
  return { p[0] * factor, p[1] * factor, p[2] * factor };
}

/// A family whose points are made one by one.
/// @param make Point (Random&), or Point (Random&, int number, int count)
template <class Make>
Family::Make each(const Make& make)
{
  return [make](int count, Random& random)
  {
    return generate(count,
      [&](int i)
      {
        if constexpr (std::is_invocable_v<Make, Random&>)
        {
          return Point(make(random));
        }
        else
        {
          return Point(make(random, i, count));
        }
      });
  };
}

/// The points of another family, changed. @param change Cloud (Cloud), or Cloud (Cloud, Random&)
template <class Change>
Family::Make changed(const Family::Make& make, const Change& change)
{
  return [make, change](int count, Random& random)
  {
    Cloud cloud = make(count, random);
    if constexpr (std::is_invocable_v<Change, Cloud>)
    {
      return change(std::move(cloud));
    }
    else
    {
      return change(std::move(cloud), random);
    }
  };
}

/// In the ball of radius 0.5, at most @p thickness times that from its sphere.
Family::Make shell(double thickness);

/// The points in a row of a square that has @p count points, or a few more.
inline int rowOf(double count)
{
  return static_cast<int>(std::ceil(std::sqrt(count)));
}

inline double toStep(double x, double stepsPerUnit)
{
  return std::round(stepsPerUnit * x) / stepsPerUnit;
}
inline Cloud toSteps(Cloud cloud, double stepsPerUnit)
{
  for (Point& p : cloud)
  {
    p = { toStep(p[0], stepsPerUnit), toStep(p[1], stepsPerUnit), toStep(p[2], stepsPerUnit) };
  }
  return cloud;
}

using Line = Cloud;

/// Points at equal steps along the lines, one line after another.
Cloud evenlyAlong(const std::vector<Line>& lines, int count);

/// The contours of Mount St Helens, in metres, of Data/sainthelens-contours.f32, which
/// Data/vtp-to-contours.py writes: NaN ends a line.
/// @throw std::runtime_error if there are none
std::vector<Line> contourLines();

/// Special inputs by their names.
struct InputList
{
  std::vector<Input> inputs;

  void add(std::string name, std::function<Cloud()> make)
  {
    this->inputs.push_back({ std::move(name), 0, std::move(make) });
  }
  void add(std::string name, const Cloud& cloud)
  {
    this->add(std::move(name), [cloud]() { return cloud; });
  }
  template <class Make>
  void addRandom(std::string name, std::uint64_t seed, Make make)
  {
    this->inputs.push_back({ std::move(name), seed,
      [make, seed]()
      {
        Random random(seed);
        return make(random);
      } });
  }
};

}
}

#endif
