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
LinearConstraint<Dimension + 1, Number> constraintOf(const double* row)
{
  LinearConstraint<Dimension + 1, Number> result;
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
Number excessOf(const LinearConstraint<Dimension, Number>& constraint, const Number* x)
{
  Number excess = -constraint.bound;
  for (int i = 0; i < Dimension; ++i)
  {
    excess += constraint.normal[i] * x[i];
  }
  return excess;
}

/// The constraints of half-spaces that have a border, with normals whose largest number is 1.
/// @return the greatest bound: no ball in a bounded intersection has a greater radius
template <int Dimension>
double roundedConstraints(
  const HalfSpaceRows& rows, std::vector<LinearConstraint<Dimension + 1>>& constraints)
{
  double most = 0;
  for (std::size_t i = 0; i < rows.size(); i += 4)
  {
    if (hasNoNormal(rows.data() + i))
    {
      continue;
    }
    LinearConstraint<Dimension + 1> constraint = constraintOf<Dimension, double>(rows.data() + i);
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

/// The best position and margin, rounded; false: none was found.
/// @param unit of lengths
template <int Dimension>
bool maximizeRounded(
  std::vector<LinearConstraint<Dimension + 1>> constraints, double unit, double* best)
{
  for (LinearConstraint<Dimension + 1>& constraint : constraints)
  {
    constraint.bound /= unit;
  }
  LinearConstraint<Dimension + 1> limit{}; // of margins
  limit.normal[Dimension] = 1;
  limit.bound = 1;
  constraints.push_back(limit);
  double objective[Dimension + 1] = {};
  objective[Dimension] = 1;
  const bool found = maximize<Dimension + 1>(objective, constraints, 0x1p20, best);
  std::transform(best, best + Dimension + 1, best, [unit](double x) { return x * unit; });
  return found && best[Dimension] > 0;
}

/// Vertices of these programmes are quotients of determinants of doubles: below two to this.
constexpr int Beyond = 9000;

/// The exact programme: over a growing set of constraints, to which one joins that the optimum so
/// far does not satisfy.
template <int Dimension>
class ExactProgram
{
public:
  static constexpr int Variables = Dimension + 1; ///< a position and its margin
  using Constraint = LinearConstraint<Variables, Rational>;

  /// @param rounded the same in doubles, in the order of the rows that have a border
  ExactProgram(const HalfSpaceRows& rows, const std::vector<LinearConstraint<Variables>>& rounded,
    Monitor& monitor)
    : rounded(rounded)
    , monitor(monitor)
  {
    for (std::size_t i = 0; i < rows.size(); i += 4)
    {
      if (!hasNoNormal(rows.data() + i))
      {
        this->bordered.push_back(rows.data() + i);
      }
    }
  }

  /// Maximise a variable, or minimise it.
  /// @param limits   of the programme's own
  /// @param exponent no variable is beyond 2^exponent
  /// @return false: nothing satisfies the limits
  bool optimize(
    int variable, int sign, const std::vector<Constraint>& limits, int exponent, Rational* best)
  {
    const Rational box(boost::multiprecision::cpp_int(1) << exponent);
    Rational objective[Variables];
    objective[variable] = sign;
    while (true)
    {
      std::vector<Constraint> all = limits;
      all.insert(all.end(), this->chosen.begin(), this->chosen.end());
      if (!maximize<Variables, Rational>(objective, all, box, best))
      {
        return false;
      }
      std::size_t worst = this->leastSatisfied(best);
      worst = this->isViolated(worst, best) ? worst : this->exactlyLeastSatisfied(best);
      if (!this->isViolated(worst, best))
      {
        return true;
      }
      this->chosen.push_back(constraintOf<Dimension, Rational>(this->bordered[worst]));
    }
  }

private:
  /// @param i as many as there are: none
  bool isViolated(std::size_t i, const Rational* x) const
  {
    return i < this->bordered.size() && this->excess(i, x) > 0;
  }

  Rational excess(std::size_t i, const Rational* x) const
  {
    const Constraint constraint = constraintOf<Dimension, Rational>(this->bordered[i]);
    return excessOf(constraint, x) / constraint.normal[Dimension];
  }

  /// As far as rounding shows: in units of the largest variable.
  std::size_t leastSatisfied(const Rational* x) const
  {
    Rational size = 1;
    for (int i = 0; i < Variables; ++i)
    {
      size = std::max<Rational>(size, abs(x[i]));
    }
    double scaled[Variables];
    std::transform(x, x + Variables, scaled,
      [&size](const Rational& a) { return Rational(a / size).template convert_to<double>(); });
    const double share = Rational(1 / size).template convert_to<double>();
    StepPoll poll(this->monitor);
    std::size_t worst = this->rounded.size();
    double most = -HUGE_VAL;
    for (std::size_t i = 0; i < this->rounded.size(); ++i)
    {
      poll.step();
      LinearConstraint<Variables> constraint = this->rounded[i];
      constraint.bound *= share;
      const double value = excessOf(constraint, scaled);
      if (value > most)
      {
        most = value;
        worst = i;
      }
    }
    return worst;
  }

  std::size_t exactlyLeastSatisfied(const Rational* x) const
  {
    StepPoll poll(this->monitor);
    std::size_t worst = this->bordered.size();
    Rational most = 0;
    for (std::size_t i = 0; i < this->bordered.size(); ++i)
    {
      poll.step();
      const Rational value = this->excess(i, x);
      if (value > most)
      {
        most = value;
        worst = i;
      }
    }
    return worst;
  }

  const std::vector<LinearConstraint<Variables>>& rounded;
  Monitor& monitor;
  std::vector<const double*> bordered;
  std::vector<Constraint> chosen;
};

/// normal . variables <= bound, of one variable.
template <int Variables>
LinearConstraint<Variables, Rational> limitOf(int variable, int sign, const Rational& bound)
{
  LinearConstraint<Variables, Rational> limit;
  limit.normal[variable] = sign;
  limit.bound = bound;
  return limit;
}

/// The middle of positions that are half as deep inside as the best: the mean of those that are
/// furthest along the axes, not much further away than the best is.
template <int Dimension>
void centerExactly(ExactProgram<Dimension>& program, double unit, Rational* best)
{
  constexpr int Variables = Dimension + 1;
  std::vector<LinearConstraint<Variables, Rational>> limits;
  const Rational half = best[Dimension] / 2;
  limits.push_back(limitOf<Variables>(Dimension, 1, half));
  limits.push_back(limitOf<Variables>(Dimension, -1, -half));
  for (int axis = 0; axis < Dimension; ++axis)
  {
    const Rational reach = 4 * std::max<Rational>(abs(best[axis]), Rational(unit));
    limits.push_back(limitOf<Variables>(axis, 1, reach));
    limits.push_back(limitOf<Variables>(axis, -1, reach));
  }
  Rational sum[Dimension];
  for (int i = 0; i < 2 * Dimension; ++i)
  {
    Rational end[Variables];
    ensure(program.optimize(i / 2, i % 2 ? 1 : -1, limits, Beyond, end));
    for (int axis = 0; axis < Dimension; ++axis)
    {
      sum[axis] += end[axis];
    }
  }
  for (int axis = 0; axis < Dimension; ++axis)
  {
    best[axis] = sum[axis] / (2 * Dimension);
  }
}

template <int Dimension>
Intersection findInteriorIn(const HalfSpaceRows& rows, double* c, Monitor& monitor)
{
  constexpr int Variables = Dimension + 1;
  std::vector<LinearConstraint<Variables>> constraints;
  const double unit = roundedConstraints<Dimension>(rows, constraints);
  const auto takeIfInside = [&](const auto& coordinate)
  {
    for (int i = 0; i < 3; ++i)
    {
      c[i] = i < Dimension ? coordinate(i) : 0.0;
    }
    return isFinite(c) && firstNotHolding(rows, c, monitor) < 0;
  };
  double rounded[Variables];
  if ((maximizeRounded<Dimension>(constraints, unit, rounded) &&
        takeIfInside([&](int i) { return rounded[i]; })) ||
    takeIfInside([](int) { return 0.0; }))
  {
    return Intersection::Bounded;
  }
  ExactProgram<Dimension> program(rows, constraints, monitor);
  // No ball in a bounded intersection has a greater radius.
  std::vector<LinearConstraint<Variables, Rational>> limits{ limitOf<Variables>(
    Dimension, 1, 2 * Rational(unit)) };
  Rational best[Variables];
  // Small numbers, where they are enough: only the last decide that there is no inside.
  for (const int exponent : { std::max(std::ilogb(unit), 0) + 64, Beyond })
  {
    if (program.optimize(Dimension, 1, limits, exponent, best) && best[Dimension] > 0)
    {
      break;
    }
    if (exponent == Beyond)
    {
      return best[Dimension] < 0 ? Intersection::Empty : Intersection::Flat;
    }
  }
  for (int axis = 0; axis < Dimension; ++axis)
  {
    const Rational most(std::numeric_limits<double>::max());
    limits.push_back(limitOf<Variables>(axis, 1, most));
    limits.push_back(limitOf<Variables>(axis, -1, most));
  }
  if (program.optimize(Dimension, 1, limits, Beyond, best) && best[Dimension] > 0)
  {
    const auto nearest = [&](int i) { return best[i].template convert_to<double>(); };
    if (takeIfInside(nearest))
    {
      return Intersection::Bounded;
    }
    centerExactly<Dimension>(program, unit, best);
    if (takeIfInside(nearest))
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
