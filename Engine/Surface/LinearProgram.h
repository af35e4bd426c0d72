// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Small-dimensional linear programming (R. Seidel, "Small-Dimensional Linear Programming and
/// Convex Hulls Made Easy", 1991): expected linear time in the number of constraints. Rounded in
/// double; exact in rationals.
#ifndef flipflop_LinearProgram_h
#define flipflop_LinearProgram_h

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

/// normal . x <= bound
template <int Dimension, class Number = double>
struct LinearConstraint
{
  Number normal[Dimension];
  Number bound;
};

namespace detail
{

/// What rounding may leave of zero.
template <class Number>
constexpr double Slack = 0;
template <>
inline constexpr double Slack<double> = 1e-13;

/// Along a line.
template <class Number>
bool maximizeOnLine(const Number& objective,
  const std::vector<LinearConstraint<1, Number>>& constraints, std::size_t count, const Number& box,
  Number& x)
{
  using std::abs;
  Number low = -box;
  Number high = box;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Number& a = constraints[i].normal[0];
    const Number& b = constraints[i].bound;
    if (abs(a) > Slack<Number>)
    {
      const Number end = b / a;
      a > 0 ? high = std::min(high, end) : low = std::max(low, end);
    }
    else if (b < -Slack<Number>)
    {
      return false;
    }
  }
  // A variable that does not matter is in the middle, or near 0 where there is none.
  const bool isClosed = low > -box && high < box;
  const Number zero = 0;
  x = objective > 0 ? high
    : objective < 0 ? low
    : isClosed      ? Number((low + high) / 2)
                    : std::min(std::max(zero, low), high);
  return low <= high + Slack<Number>;
}

/// Replaces one variable, by the others on a constraint's plane.
template <int Dimension, class Number>
class Elimination
{
public:
  using Given = LinearConstraint<Dimension, Number>;
  using Reduced = LinearConstraint<Dimension - 1, Number>;

  /// The variable is the one with the largest factor.
  explicit Elimination(const Given& constraint)
    : tight(constraint)
  {
    using std::abs;
    for (int i = 1; i < Dimension; ++i)
    {
      this->out = abs(tight.normal[i]) > abs(tight.normal[this->out]) ? i : this->out;
    }
  }

  bool isPossible() const
  {
    using std::abs;
    const Number factor = abs(this->tight.normal[this->out]);
    return factor != 0 && !(factor < Slack<Number>);
  }

  Reduced operator()(const Given& from) const
  {
    Reduced to;
    const Number factor = from.normal[this->out] / this->tight.normal[this->out];
    for (int i = 0, j = 0; i < Dimension; ++i)
    {
      if (i != this->out)
      {
        to.normal[j++] = from.normal[i] - factor * this->tight.normal[i];
      }
    }
    to.bound = from.bound - factor * this->tight.bound;
    return to;
  }

  /// The first @p count constraints, and the cube's for the variable.
  std::vector<Reduced> reduced(
    const std::vector<Given>& constraints, std::size_t count, const Number& box) const
  {
    std::vector<Reduced> result;
    result.reserve(count + 2);
    for (std::size_t i = 0; i < count; ++i)
    {
      result.push_back((*this)(constraints[i]));
    }
    for (const int sign : { 1, -1 })
    {
      Given wall{};
      wall.normal[this->out] = sign;
      wall.bound = box;
      result.push_back((*this)(wall));
    }
    return result;
  }

  /// All variables, from the others.
  void expand(const Number* others, Number* x) const
  {
    Number rest = this->tight.bound;
    for (int i = 0, j = 0; i < Dimension; ++i)
    {
      if (i != this->out)
      {
        x[i] = others[j++];
        rest -= this->tight.normal[i] * x[i];
      }
    }
    x[this->out] = rest / this->tight.normal[this->out];
  }

private:
  const Given& tight;
  int out = 0; ///< the variable
};

/// In order; the constraints before the one that fails are tight on it.
template <int Dimension, class Number>
bool maximizeInOrder(const Number* objective,
  const std::vector<LinearConstraint<Dimension, Number>>& constraints, std::size_t count,
  const Number& box, Number* x)
{
  if constexpr (Dimension == 1)
  {
    return maximizeOnLine<Number>(objective[0], constraints, count, box, x[0]);
  }
  else
  {
    for (int i = 0; i < Dimension; ++i)
    {
      x[i] = objective[i] > 0 ? box : objective[i] < 0 ? Number(-box) : Number(0);
    }
    for (std::size_t k = 0; k < count; ++k)
    {
      Number value = -constraints[k].bound;
      for (int i = 0; i < Dimension; ++i)
      {
        value += constraints[k].normal[i] * x[i];
      }
      if (value <= Slack<Number>)
      {
        continue;
      }
      // The optimum lies on this constraint.
      const Elimination<Dimension, Number> eliminate(constraints[k]);
      if (!eliminate.isPossible())
      {
        return false;
      }
      LinearConstraint<Dimension, Number> goal{};
      std::copy(objective, objective + Dimension, goal.normal);
      const auto reducedGoal = eliminate(goal);
      const auto reduced = eliminate.reduced(constraints, k, box);
      Number y[Dimension - 1];
      if (!maximizeInOrder<Dimension - 1, Number>(
            reducedGoal.normal, reduced, reduced.size(), box, y))
      {
        return false;
      }
      eliminate.expand(y, x);
    }
    return true;
  }
}

}

/// Maximise objective . x over the constraints and the cube |x_i| <= box. The constraints are
/// shuffled, by a fixed seed.
/// @return false when nothing satisfies them
template <int Dimension, class Number = double>
bool maximize(const Number* objective,
  std::vector<LinearConstraint<Dimension, Number>>& constraints, const Number& box, Number* x)
{
  std::uint64_t state = 0x9E3779B97F4A7C15ull;
  for (std::size_t i = constraints.size(); i > 1; --i)
  {
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    std::swap(constraints[i - 1], constraints[(state >> 33) % i]);
  }
  return detail::maximizeInOrder<Dimension, Number>(
    objective, constraints, constraints.size(), box, x);
}

}

#endif
