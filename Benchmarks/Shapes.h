// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the families of ShapesInUse.h are made of.
#ifndef flipflop_Shapes_h
#define flipflop_Shapes_h

#include "RandomPoints.h"

#include <cstdint>
#include <vector>

namespace flipflop
{

constexpr double Turn = 6.283185307179586;

struct Shape
{
  const char* name;
  /// x y z (in the plane: the weight, or 0) of so many points.
  Coordinates (*make)(RandomPoints& random, std::int64_t count);
  bool weighted = false;
};

const std::vector<Shape>& drawingShapes(); ///< in the plane
const std::vector<Shape>& surveyShapes();  ///< in the plane
const std::vector<Shape>& spaceShapes();

/// For a shape whose points are drawn one by one.
template <SpacePoint (*draw)(RandomPoints&)>
Coordinates drawn(RandomPoints& random, std::int64_t count)
{
  return samplePoints(count, [&random] { return draw(random); });
}

/// The least number of points in a row where all rows have as many, and there are as many rows.
inline std::int64_t rowOf(std::int64_t count)
{
  return static_cast<std::int64_t>(std::ceil(std::sqrt(static_cast<double>(count))));
}

using Line = std::vector<SpacePoint>;

/// Points at equal steps along the lines, one line after another.
Coordinates evenlyAlong(const std::vector<Line>& lines, std::int64_t count);

inline double toStep(double x, double stepsPerUnit)
{
  return std::round(stepsPerUnit * x) / stepsPerUnit;
}

inline Coordinates toSteps(Coordinates points, double stepsPerUnit)
{
  for (double& x : points)
  {
    x = toStep(x, stepsPerUnit);
  }
  return points;
}

}

#endif
