// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What is interpolated, by which method, and what there is outside.
#ifndef flipflop_InterpolationTask_h
#define flipflop_InterpolationTask_h

#include "Query/PlaneShares.h"
#include "Query/Sites.h"
#include <flipflop/TriangulationQueries.h>

#include <cstdint>
#include <vector>

namespace flipflop
{

class SiteGradients;

struct InterpolationTask
{
  Interpolation method;
  const double* values; ///< values[id * components + c]
  std::int64_t components;
  double fill;
  bool areBySite = false; ///< values[site * components + c]: what is near is near in memory
  const SiteGradients* gradients = nullptr; ///< for Interpolation::CloughTocher
  /// Of each query: receives its shares, by site. There are no values then.
  PlaneShares* shares = nullptr;

  bool isNatural() const
  {
    return this->method == Interpolation::Natural || this->method == Interpolation::Laplace;
  }

  const double* valuesOf(const Sites& sites, std::uint32_t site) const
  {
    return this->values +
      static_cast<std::int64_t>(this->areBySite ? site : sites[site].id) * this->components;
  }
};

}

#endif
