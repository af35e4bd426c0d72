// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The reduced element of R. W. Clough and J. L. Tocher (1965): from values and gradients at the
/// corners of a triangle to a function of three cubic pieces around the centroid, whose derivative
/// across each side is linear along it. So it and its gradient are continuous from triangle to
/// triangle, and quadratic functions are reproduced.
#ifndef flipflop_CloughTocher_h
#define flipflop_CloughTocher_h

namespace flipflop
{

/// What is given at a corner; positions and gradients in one unit.
struct ElementCorner
{
  double x[2];
  double value;
  double gradient[2];
};

/// How much the tangent plane at a corner rises on the way to a position.
inline double riseTo(const ElementCorner& corner, const double* x)
{
  return corner.gradient[0] * (x[0] - corner.x[0]) + corner.gradient[1] * (x[1] - corner.x[1]);
}

/// Along an edge, which the position divides in these shares.
inline double cubicOnEdge(const ElementCorner* corners, const double* shares)
{
  const double s = shares[0], t = shares[1];
  const double ofFirst = riseTo(corners[0], corners[1].x) / 3;
  const double rise = corners[1].value - corners[0].value;
  const double ofSecond = rise + riseTo(corners[1], corners[0].x) / 3;
  return corners[0].value + t * (3 * s * (s * ofFirst + t * ofSecond) + t * t * rise);
}

/// In a triangle, from the corners' shares. All is against the first corner's value.
inline double cloughTocher(const ElementCorner* corners, const double* shares)
{
  double center[2];
  for (int k = 0; k < 2; ++k)
  {
    center[k] = corners[0].x[k] +
      ((corners[1].x[k] - corners[0].x[k]) + (corners[2].x[k] - corners[0].x[k])) / 3;
  }
  // Bezier coefficients: at a corner, from there to the next corner and to the one before, and to
  // the centroid; beside the middle of the side from a corner to the next.
  double at[3], forth[3], back[3], inward[3], side[3];
  for (int i = 0; i < 3; ++i)
  {
    const int next = i < 2 ? i + 1 : 0, last = i > 0 ? i - 1 : 2;
    at[i] = corners[i].value - corners[0].value;
    forth[i] = at[i] + riseTo(corners[i], corners[next].x) / 3;
    back[i] = at[i] + riseTo(corners[i], corners[last].x) / 3;
    inward[i] = at[i] + riseTo(corners[i], center) / 3;
  }
  for (int i = 0; i < 3; ++i)
  {
    // The derivative perpendicular to the side, in the middle, is the mean of those at the ends.
    const int next = i < 2 ? i + 1 : 0;
    const double along[] = { corners[next].x[0] - corners[i].x[0],
      corners[next].x[1] - corners[i].x[1] };
    const double foot =
      ((center[0] - corners[i].x[0]) * along[0] + (center[1] - corners[i].x[1]) * along[1]) /
      (along[0] * along[0] + along[1] * along[1]);
    const double first = inward[i] - (1 - foot) * at[i] - foot * forth[i];
    const double second = inward[next] - (1 - foot) * back[next] - foot * at[next];
    side[i] = (1 - foot) * forth[i] + foot * back[next] + (first + second) / 2;
  }
  double middle[3]; // from a corner to the centroid, the second one
  for (int i = 0; i < 3; ++i)
  {
    middle[i] = (inward[i] + side[i] + side[i > 0 ? i - 1 : 2]) / 3;
  }
  const double atCenter = (middle[0] + middle[1] + middle[2]) / 3;
  // The piece is that of the side opposite the corner with the least share.
  const int least =
    shares[0] < shares[1] ? (shares[0] < shares[2] ? 0 : 2) : (shares[1] < shares[2] ? 1 : 2);
  const int i = least < 2 ? least + 1 : 0, j = least > 0 ? least - 1 : 2;
  const double a = shares[i] - shares[least], b = shares[j] - shares[least];
  const double c = 3 * shares[least];
  return corners[0].value +
    (a * a * (a * at[i] + 3 * (b * forth[i] + c * inward[i])) +
      b * b * (b * at[j] + 3 * (a * back[j] + c * inward[j])) +
      c * (c * (3 * (a * middle[i] + b * middle[j]) + c * atCenter) + 6 * a * b * side[i]));
}

}

#endif
