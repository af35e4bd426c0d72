// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The gradients of values at the sites, estimated: those of the quadratic function through the
/// site's value that fits the values around best, by least squares.
///
/// Around are the site's neighbours, and the corners opposite them beyond the edges that link them;
/// near the border more. A distance counts by its third power, which is what errs least on smooth
/// functions. So quadratic functions have their gradients, up to rounding. Where the positions fix
/// no quadratic function, a linear one is fitted. Fixed edges do not count.
#ifndef flipflop_SiteGradients_h
#define flipflop_SiteGradients_h

#include "Query/InterpolationTask.h"
#include "Query/PreparedTriangulation.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>

#include <cstdint>

namespace flipflop
{

class SiteGradients
{
public:
  /// @param toDo    has the values, which must outlive the gradients
  /// @param isTable compute all now? Else each when it is queried. They are the same.
  /// @throw Error OutOfMemory, Aborted
  SiteGradients(const PreparedTriangulation& triangulation, const InterpolationTask& toDo,
    bool isTable, Monitor& monitor);

  /// Gradients are per unit of positions times this power of two, which makes them less than 1.
  double unit() const { return this->scale; }

  /// @param gradients receives two numbers a component
  void at(std::uint32_t site, double* gradients) const;

private:
  class Fit;

  void compute(std::uint32_t site, double* gradients) const;

  const PreparedTriangulation& prepared;
  const InterpolationTask task;
  double scale = 1;
  Buffer<double> table;
};

}

#endif
