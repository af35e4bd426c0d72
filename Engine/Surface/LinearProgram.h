// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Small-dimensional linear programming (R. Seidel, "Small-Dimensional Linear Programming and
/// Convex Hulls Made Easy", 1991), rounded: expected linear time in the number of constraints.
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
template <int Dimension>
struct HalfSpace
{
  double normal[Dimension];
  double bound;
};

namespace detail
{

constexpr double Slack = 1e-13;

/// Along a line.
inline bool maximizeOnLine(double objective, const std::vector<HalfSpace<1>>& constraints,
  std::size_t count, double box, double& x)
{
  double low = -box;
  double high = box;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double a = constraints[i].normal[0];
    const double b = constraints[i].bound;
    if (std::fabs(a) > Slack)
    {
      a > 0 ? high = std::min(high, b / a) : low = std::max(low, b / a);
    }
    else if (b < -Slack)
    {
      return false;
    }
  }
  x = objective >= 0 ? high : low;
  return low <= high + Slack;
}

/// Replaces one variable, by the others on a constraint's plane.
template <int Dimension>
class Elimination
{
public:
  /// The variable is the one with the largest factor.
  explicit Elimination(const HalfSpace<Dimension>& constraint)
    : tight(constraint)
  {
    for (int i = 1; i < Dimension; ++i)
    {
      this->out = std::fabs(tight.normal[i]) > std::fabs(tight.normal[this->out]) ? i : this->out;
    }
  }

  bool isPossible() const { return !(std::fabs(this->tight.normal[this->out]) < Slack); }

  HalfSpace<Dimension - 1> operator()(const HalfSpace<Dimension>& from) const
  {
    HalfSpace<Dimension - 1> to;
    const double factor = from.normal[this->out] / this->tight.normal[this->out];
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
  std::vector<HalfSpace<Dimension - 1>> reduced(
    const std::vector<HalfSpace<Dimension>>& constraints, std::size_t count, double box) const
  {
    std::vector<HalfSpace<Dimension - 1>> result;
    result.reserve(count + 2);
    for (std::size_t i = 0; i < count; ++i)
    {
      result.push_back((*this)(constraints[i]));
    }
    for (const double sign : { 1.0, -1.0 })
    {
      HalfSpace<Dimension> wall{};
      wall.normal[this->out] = sign;
      wall.bound = box;
      result.push_back((*this)(wall));
    }
    return result;
  }

  /// All variables, from the others.
  void expand(const double* others, double* x) const
  {
    double rest = this->tight.bound;
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
  const HalfSpace<Dimension>& tight;
  int out = 0; ///< the variable
};

/// In order; the constraints before the one that fails are tight on it.
template <int Dimension>
bool maximizeInOrder(const double* objective, const std::vector<HalfSpace<Dimension>>& constraints,
  std::size_t count, double box, double* x)
{
  if constexpr (Dimension == 1)
  {
    return maximizeOnLine(objective[0], constraints, count, box, x[0]);
  }
  else
  {
    for (int i = 0; i < Dimension; ++i)
    {
      x[i] = objective[i] >= 0 ? box : -box;
    }
    for (std::size_t k = 0; k < count; ++k)
    {
      double value = -constraints[k].bound;
      for (int i = 0; i < Dimension; ++i)
      {
        value += constraints[k].normal[i] * x[i];
      }
      if (value <= Slack)
      {
        continue;
      }
      // The optimum lies on this constraint.
      const Elimination<Dimension> eliminate(constraints[k]);
      if (!eliminate.isPossible())
      {
        return false;
      }
      HalfSpace<Dimension> goal{};
      std::copy(objective, objective + Dimension, goal.normal);
      const HalfSpace<Dimension - 1> reducedGoal = eliminate(goal);
      const auto reduced = eliminate.reduced(constraints, k, box);
      double y[Dimension - 1];
      if (!maximizeInOrder<Dimension - 1>(reducedGoal.normal, reduced, reduced.size(), box, y))
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
template <int Dimension>
bool maximize(
  const double* objective, std::vector<HalfSpace<Dimension>>& constraints, double box, double* x)
{
  std::uint64_t state = 0x9E3779B97F4A7C15ull;
  for (std::size_t i = constraints.size(); i > 1; --i)
  {
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    std::swap(constraints[i - 1], constraints[(state >> 33) % i]);
  }
  return detail::maximizeInOrder<Dimension>(objective, constraints, constraints.size(), box, x);
}

}

#endif
