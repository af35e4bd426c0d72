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

/// In order; the constraints before the one that fails are tight on it.
template <int Dimension>
bool maximizeInOrder(const double* objective, const std::vector<HalfSpace<Dimension>>& constraints,
  std::size_t count, double box, double* x)
{
  constexpr double Slack = 1e-13;
  if constexpr (Dimension == 1)
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
    x[0] = objective[0] >= 0 ? high : low;
    return low <= high + Slack;
  }
  else
  {
    for (int i = 0; i < Dimension; ++i)
    {
      x[i] = objective[i] >= 0 ? box : -box;
    }
    for (std::size_t k = 0; k < count; ++k)
    {
      const HalfSpace<Dimension>& tight = constraints[k];
      double value = -tight.bound;
      for (int i = 0; i < Dimension; ++i)
      {
        value += tight.normal[i] * x[i];
      }
      if (value <= Slack)
      {
        continue;
      }
      // The optimum lies on this constraint: eliminate the variable that it knows best.
      int out = 0;
      for (int i = 1; i < Dimension; ++i)
      {
        out = std::fabs(tight.normal[i]) > std::fabs(tight.normal[out]) ? i : out;
      }
      if (std::fabs(tight.normal[out]) < Slack)
      {
        return false;
      }
      const auto eliminate = [&](const HalfSpace<Dimension>& from)
      {
        HalfSpace<Dimension - 1> to;
        const double factor = from.normal[out] / tight.normal[out];
        for (int i = 0, j = 0; i < Dimension; ++i)
        {
          if (i != out)
          {
            to.normal[j++] = from.normal[i] - factor * tight.normal[i];
          }
        }
        to.bound = from.bound - factor * tight.bound;
        return to;
      };
      std::vector<HalfSpace<Dimension - 1>> reduced;
      reduced.reserve(k + 2);
      for (std::size_t i = 0; i < k; ++i)
      {
        reduced.push_back(eliminate(constraints[i]));
      }
      // The eliminated variable stays in the box too.
      for (const double sign : { 1.0, -1.0 })
      {
        HalfSpace<Dimension> wall{};
        wall.normal[out] = sign;
        wall.bound = box;
        reduced.push_back(eliminate(wall));
      }
      HalfSpace<Dimension> goal{};
      std::copy(objective, objective + Dimension, goal.normal);
      const HalfSpace<Dimension - 1> reducedGoal = eliminate(goal);
      double y[Dimension - 1];
      if (!maximizeInOrder<Dimension - 1>(reducedGoal.normal, reduced, reduced.size(), box, y))
      {
        return false;
      }
      double rest = tight.bound;
      for (int i = 0, j = 0; i < Dimension; ++i)
      {
        if (i != out)
        {
          x[i] = y[j++];
          rest -= tight.normal[i] * x[i];
        }
      }
      x[out] = rest / tight.normal[out];
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
