// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HalfSpaces/InteriorPoint.h"

#include "HalfSpaces/HalfSpaceRow.h"
#include "Points/PointSource.h"
#include "Surface/LinearProgram.h"
#include <flipflop/ConvexHull.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipflop
{

namespace
{

using Rational = boost::multiprecision::number<
  boost::multiprecision::rational_adaptor<boost::multiprecision::cpp_int_backend<>>,
  boost::multiprecision::et_off>;

/// The constraint of a half-space on a position and its margin, the last variable: margins are in
/// units of the normals.
template <int Dimension, class Number>
HalfSpace<Dimension + 1, Number> constraintOf(const double* row)
{
  HalfSpace<Dimension + 1, Number> result;
  double most = 0;
  for (int i = 0; i < Dimension; ++i)
  {
    result.normal[i] = row[i];
    most = std::max(most, std::fabs(row[i]));
  }
  result.normal[Dimension] = most;
  result.bound = row[3];
  return result;
}

/// By how much a position with a margin does not satisfy it.
template <int Dimension, class Number>
Number excessOf(const HalfSpace<Dimension, Number>& constraint, const Number* x)
{
  Number excess = -constraint.bound;
  for (int i = 0; i < Dimension; ++i)
  {
    excess += constraint.normal[i] * x[i];
  }
  return excess;
}

/// Is a normal zero?
bool hasNoNormal(const double* row)
{
  return row[0] == 0 && row[1] == 0 && row[2] == 0;
}

/// The constraints of half-spaces that have a border, with normals whose largest number is 1.
/// @return the greatest bound: no ball in a bounded intersection has a greater radius
template <int Dimension>
double roundedConstraints(
  const HalfSpaceRows& rows, std::vector<HalfSpace<Dimension + 1>>& constraints)
{
  double most = 0;
  for (std::size_t i = 0; i < rows.size(); i += 4)
  {
    if (hasNoNormal(rows.data() + i))
    {
      continue;
    }
    HalfSpace<Dimension + 1> constraint = constraintOf<Dimension, double>(rows.data() + i);
    const double size = constraint.normal[Dimension];
    for (double& number : constraint.normal)
    {
      number /= size;
    }
    constraint.bound /= size;
    most = std::max(most, std::fabs(constraint.bound));
    constraints.push_back(constraint);
  }
  return most > 0 ? std::min(most, std::numeric_limits<double>::max()) : 1;
}

/// No margin is greater.
template <int Dimension, class Number>
HalfSpace<Dimension + 1, Number> limitOfMargin(const Number& most)
{
  HalfSpace<Dimension + 1, Number> limit{};
  limit.normal[Dimension] = 1;
  limit.bound = most;
  return limit;
}

/// The best position and margin, rounded; false: none was found.
/// @param unit of lengths
template <int Dimension>
bool maximizeRounded(std::vector<HalfSpace<Dimension + 1>> constraints, double unit, double* best)
{
  for (HalfSpace<Dimension + 1>& constraint : constraints)
  {
    constraint.bound /= unit;
  }
  constraints.push_back(limitOfMargin<Dimension, double>(1.0));
  double objective[Dimension + 1] = {};
  objective[Dimension] = 1;
  const bool found = maximize<Dimension + 1>(objective, constraints, 0x1p20, best);
  std::transform(best, best + Dimension + 1, best, [unit](double x) { return x * unit; });
  return found && best[Dimension] > 0;
}

/// The constraint that a position with a margin satisfies least, as far as rounding shows.
/// @param x must not be beyond doubles by itself
template <int Dimension>
std::size_t leastSatisfied(
  const std::vector<HalfSpace<Dimension>>& constraints, const Rational* x, Monitor& monitor)
{
  Rational size = 1;
  for (int i = 0; i < Dimension; ++i)
  {
    size = std::max<Rational>(size, abs(x[i]));
  }
  double rounded[Dimension];
  std::transform(x, x + Dimension, rounded,
    [&size](const Rational& a) { return Rational(a / size).template convert_to<double>(); });
  const double share = Rational(1 / size).template convert_to<double>();
  StepPoll poll(monitor);
  std::size_t worst = 0;
  double most = -HUGE_VAL;
  for (std::size_t i = 0; i < constraints.size(); ++i)
  {
    poll.step();
    HalfSpace<Dimension> scaled = constraints[i];
    scaled.bound *= share;
    const double excess = excessOf(scaled, rounded);
    if (excess > most)
    {
      most = excess;
      worst = i;
    }
  }
  return worst;
}

/// The exact optimum, over a growing set of constraints: each time one that its optimum does not
/// satisfy joins.
/// @param constraints the same in doubles, in the order of the rows that have a border
/// @param inDoubles   only positions in the range of doubles count
template <int Dimension>
void maximizeExactly(const HalfSpaceRows& rows,
  const std::vector<HalfSpace<Dimension + 1>>& constraints, double unit, bool inDoubles,
  Rational* best, Monitor& monitor)
{
  std::vector<const double*> bordered;
  for (std::size_t i = 0; i < rows.size(); i += 4)
  {
    if (!hasNoNormal(rows.data() + i))
    {
      bordered.push_back(rows.data() + i);
    }
  }
  // Quotients of doubles are below 2^2098: so the origin has a margin in this box.
  const Rational box(boost::multiprecision::cpp_int(1) << 2100);
  Rational objective[Dimension + 1];
  objective[Dimension] = 1;
  std::vector<HalfSpace<Dimension + 1, Rational>> chosen;
  chosen.push_back(limitOfMargin<Dimension, Rational>(2 * Rational(unit)));
  for (int i = 0; i < 2 * Dimension && inDoubles; ++i)
  {
    HalfSpace<Dimension + 1, Rational> wall;
    wall.normal[i / 2] = i % 2 ? 1 : -1;
    wall.bound = Rational(std::numeric_limits<double>::max());
    chosen.push_back(wall);
  }
  StepPoll poll(monitor);
  while (true)
  {
    ensure(maximize<Dimension + 1, Rational>(objective, chosen, box, best));
    const auto isViolated = [&](std::size_t i)
    {
      poll.step();
      const auto constraint = constraintOf<Dimension, Rational>(bordered[i]);
      if (excessOf(constraint, best) > 0)
      {
        chosen.push_back(constraint);
        return true;
      }
      return false;
    };
    bool isOptimum =
      constraints.empty() || !isViolated(leastSatisfied<Dimension + 1>(constraints, best, monitor));
    for (std::size_t i = 0; i < constraints.size() && isOptimum; ++i)
    {
      isOptimum = !isViolated(i);
    }
    if (isOptimum)
    {
      return;
    }
  }
}

template <int Dimension>
Intersection findInteriorIn(const HalfSpaceRows& rows, double* c, Monitor& monitor)
{
  std::vector<HalfSpace<Dimension + 1>> constraints;
  const double unit = roundedConstraints<Dimension>(rows, constraints);
  double rounded[Dimension + 1];
  const auto isInside = [&](const auto& coordinate)
  {
    for (int i = 0; i < 3; ++i)
    {
      c[i] = i < Dimension ? coordinate(i) : 0.0;
    }
    return isFinite(c) && firstNotHolding(rows, c, monitor) < 0;
  };
  if (maximizeRounded<Dimension>(constraints, unit, rounded) &&
    isInside([&](int i) { return rounded[i]; }))
  {
    return Intersection::Bounded;
  }
  Rational best[Dimension + 1];
  for (const bool inDoubles : { false, true })
  {
    maximizeExactly<Dimension>(rows, constraints, unit, inDoubles, best, monitor);
    const int margin = best[Dimension].sign();
    if (margin <= 0 && !inDoubles)
    {
      return margin < 0 ? Intersection::Empty : Intersection::Flat;
    }
    if (isInside([&](int i) { return best[i].template convert_to<double>(); }))
    {
      return Intersection::Bounded;
    }
  }
  throw badArgument("no position in doubles was found strictly inside all half-spaces");
}

}

std::int64_t firstNotHolding(const HalfSpaceRows& rows, const double* c, Monitor& monitor)
{
  StepPoll poll(monitor);
  for (std::size_t i = 0; i < rows.size(); i += 4)
  {
    poll.step();
    if (depthSign(rows.data() + i, c) <= 0 && !(hasNoNormal(rows.data() + i) && rows[i + 3] >= 0))
    {
      return static_cast<std::int64_t>(i / 4);
    }
  }
  return -1;
}

Intersection findInterior(const HalfSpaceRows& rows, int dimension, double* c, Monitor& monitor)
{
  for (std::size_t i = 0; i < rows.size(); i += 4)
  {
    if (hasNoNormal(rows.data() + i) && rows[i + 3] < 0)
    {
      return Intersection::Empty;
    }
  }
  return dimension == 2 ? findInteriorIn<2>(rows, c, monitor) : findInteriorIn<3>(rows, c, monitor);
}

bool areNormalsAllAround(const HalfSpaceRows& rows, int threads)
{
  Options options;
  options.threads = threads;
  const Hull hull =
    convexHull(PointView(rows.data(), static_cast<std::int64_t>(rows.size() / 4), 4), options);
  if (hull.dimension < 3)
  {
    return false;
  }
  std::vector<HalfSpaceRow> corners(hull.pointIds.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    std::copy_n(rows.data() + 4 * hull.pointIds[i], 4, corners[i].number);
  }
  for (std::size_t t = 0; t < hull.connectivity.size(); t += 3)
  {
    const HalfSpaceRow* triangle[3];
    for (std::size_t i = 0; i < 3; ++i)
    {
      triangle[i] = &corners[static_cast<std::size_t>(hull.connectivity[t + i])];
    }
    if (exactDeterminantSign<3>(triangle, RowColumns) <= 0)
    {
      return false;
    }
  }
  return true;
}

}
