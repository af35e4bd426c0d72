// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The exact stage of the predicates on lifted points, in expansions.
///
/// A weighted point (x, y, w) stands for the point (x, y, h) of height h = w - x^2 - y^2: the
/// paper's lift turned upside down, so that triangles of the plane are counter-clockwise seen from
/// outside. Heights are never rounded: only differences of heights occur, and those are expansions.
#ifndef flipflop_LiftedSigns_h
#define flipflop_LiftedSigns_h

#include "Predicates/ExactSigns.h"

namespace flipflop
{

/// With the interface of ExpansionSigns; coordinate 2 is the height.
/// @tparam Weighted false: all weights are zero
template <bool Weighted>
struct LiftedSigns
{
  /// Sign of det[b - a; c - a; d - a].
  FF_HD FF_OUTLINED static int orient3(
    const double* a, const double* b, const double* c, const DeterminantRow<1>& d)
  {
    const double* const row[3] = { b, c, d.point[0] };
    int sign = roundedOrient3(a, row);
    if (sign != 0 || fixedLiftedOrient3<Weighted>(a, b, c, d.point[0], sign))
    {
      return sign;
    }
    Expansion<2> u[3][2];
    for (int i = 0; i < 3; ++i)
    {
      u[i][0] = difference(row[i][0], a[0]);
      u[i][1] = difference(row[i][1], a[1]);
    }
    ProductSum det;
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      det.add(minor(u[i], u[j], 0, 1), heightOver(a, row[k], u[k]));
    }
    return det.sign();
  }

  /// Sign of det[b - a; c - a] in the coordinates p, q.
  FF_HD FF_OUTLINED static int orient2(
    const double* a, const double* b, const DeterminantRow<1>& c, int p, int q)
  {
    if (p < 2 && q < 2)
    {
      return ExpansionSigns::orient2(a, b, c, p, q);
    }
    const double* const d = c.point[0];
    const int axis = p < 2 ? p : q;
    if (a[axis] == b[axis] && a[axis] == d[axis])
    {
      return 0; // seen along a line that they are on
    }
    double error1, error2;
    const DoubleDouble height1 = roundedHeight(b, a, error1);
    const DoubleDouble height2 = roundedHeight(d, a, error2);
    int sign;
    if (ExpansionSigns::signOfMinor(doubleDifference(b[axis], a[axis]), height1,
          doubleDifference(d[axis], a[axis]), height2, error1, error2, sign))
    {
      return p < 2 ? sign : -sign;
    }
    ProductSum det;
    det.add(offsetOf(d, a, q), offsetOf(b, a, p));
    det.add(offsetOf(d, a, p), offsetOf(b, a, q), -1.0);
    return det.sign();
  }

  /// Is q by power distance nearer to a (-1) or to b (1)?
  FF_HD FF_OUTLINED static int comparePowers(const double* q, const double* a, const double* b)
  {
    // |q - a|^2 - |q - b|^2 = (a - b) ((a - q) + (b - q))
    ProductSum powers;
    for (int i = 0; i < 2; ++i)
    {
      powers.add(difference(a[i], b[i]), sum(difference(a[i], q[i]), difference(b[i], q[i])));
    }
    Expansion<2> one;
    one.append(1.0);
    powers.add(weightOffset(a, b), one);
    return powers.sign();
  }

  /// Sign of a - b in the coordinate p.
  FF_HD FF_OUTLINED static int compare(const double* a, const DeterminantRow<1>& b, int p)
  {
    return -offsetOf(b.point[0], a, p).sign();
  }

private:
  using Height = Expansion<18>;

  /// Height of p over the plane that touches the paraboloid at a's position, and passes through a:
  /// the determinant of orient3 has the columns x and y too, so such a plane makes no difference.
  FF_HD static Height heightOver(const double* a, const double* p, const Expansion<2>* u)
  {
    const auto square = sum(product(u[0], u[0]), product(u[1], u[1]));
    return sum(weightOffset(a, p), square, -1.0);
  }

  FF_HD static Expansion<2> weightOffset(const double* a, const double* p)
  {
    return Weighted ? difference(p[2], a[2]) : Expansion<2>();
  }

  /// p - a in one coordinate.
  FF_HD FF_OUTLINED static Height offsetOf(const double* p, const double* a, int axis)
  {
    if (axis < 2)
    {
      return sum(Expansion<16>(), difference(p[axis], a[axis]));
    }
    // x^2 - a^2 = (x - a) (x + a)
    const auto x = product(difference(p[0], a[0]), difference(p[0], -a[0]));
    const auto y = product(difference(p[1], a[1]), difference(p[1], -a[1]));
    return sum(weightOffset(a, p), sum(x, y), -1.0);
  }

  /// Height of p over a.
  FF_HD static DoubleDouble roundedHeight(const double* p, const double* a, double& error)
  {
    const DoubleDouble x = doubleDifference(p[0], a[0]) * doubleDifference(p[0], -a[0]);
    const DoubleDouble y = doubleDifference(p[1], a[1]) * doubleDifference(p[1], -a[1]);
    DoubleDouble weight = { 0.0, 0.0 };
    if (Weighted)
    {
      weight = doubleDifference(p[2], a[2]);
    }
    error = HeightError * (std::fabs(x.high) + std::fabs(y.high) + std::fabs(weight.high));
    return weight - (x + y);
  }

  /// Sign of the determinant of orient3 in double-double, or 0 when its error bound leaves it open.
  FF_HD FF_OUTLINED FF_FLATTEN static int roundedOrient3(const double* a, const double* const* row)
  {
    DoubleDouble u[3][3];
    double size[3] = { 0.0, 0.0, 0.0 };
    for (int i = 0; i < 3; ++i)
    {
      u[i][0] = doubleDifference(row[i][0], a[0]);
      u[i][1] = doubleDifference(row[i][1], a[1]);
      const DoubleDouble square =
        looseSum(looseProduct(u[i][0], u[i][0]), looseProduct(u[i][1], u[i][1]));
      u[i][2] = DoubleDouble{ -square.high, -square.low };
      double height = square.high;
      if (Weighted)
      {
        const DoubleDouble weight = doubleDifference(row[i][2], a[2]);
        u[i][2] = looseSum(u[i][2], weight);
        height += std::fabs(weight.high);
      }
      size[0] = std::fmax(size[0], std::fabs(u[i][0].high));
      size[1] = std::fmax(size[1], std::fabs(u[i][1].high));
      size[2] = std::fmax(size[2], height);
    }
    if (!(size[0] >= RoundedLiftedFloor && size[1] >= RoundedLiftedFloor &&
          size[0] <= LiftedCeiling && size[1] <= LiftedCeiling &&
          size[2] <= LiftedCeiling * LiftedCeiling))
    {
      return 0;
    }
    const auto term = [&u](int i, int j, int k)
    {
      return looseProduct(
        looseDifference(looseProduct(u[i][0], u[j][1]), looseProduct(u[i][1], u[j][0])), u[k][2]);
    };
    const DoubleDouble det = looseSum(looseSum(term(0, 1, 2), term(1, 2, 0)), term(2, 0, 1));
    const double value = det.high + det.low;
    const double bound = size[0] * size[1] * size[2] * RoundedLiftedError;
    return value > bound ? 1 : (value < -bound ? -1 : 0);
  }
};

}

#endif
