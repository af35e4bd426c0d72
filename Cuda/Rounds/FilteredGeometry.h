// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A geometry that decides by its floating-point filter alone, and notes when that was not enough.
///
/// The fast kernels use it, so they are compiled without a trace of exact arithmetic: few
/// registers, no stack. What an item comes to while `undecided` is set is void: the item goes to
/// the exact kernel, which uses the geometry itself.
#ifndef flipflop_FilteredGeometry_h
#define flipflop_FilteredGeometry_h

#include "Points/Vertex.h"
#include "Support/HostDevice.h"

namespace flipflop
{

/// @tparam Geometry a model of the geometry concept (GeometryConcept.h)
template <class Geometry>
class FilteredGeometry
{
public:
  FF_HD explicit FilteredGeometry(const Geometry& exact)
    : geometry(exact)
  {
  }

  FF_HD int perturbedAbove(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    int sign = 0;
    const bool known = this->geometry.filterAbove(a, b, c, p, sign);
    return this->checked(known, sign);
  }

  FF_HD int perturbedKernelBeneath(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    int sign = 0;
    const bool known = this->geometry.filterKernelBeneath(a, b, c, sign);
    return this->checked(known, sign);
  }

  mutable bool undecided = false;

private:
  /// A tie is for the perturbation, which is exact arithmetic too.
  FF_HD int checked(bool known, int sign) const
  {
    this->undecided = this->undecided || !known || sign == 0;
    return sign;
  }

  const Geometry& geometry;
};

/// Was the filter not enough? The geometry itself always is.
template <class Geometry>
FF_HD bool isUndecided(const FilteredGeometry<Geometry>& geometry)
{
  return geometry.undecided;
}
template <class Geometry>
FF_HD bool isUndecided(const Geometry&)
{
  return false;
}

}

#endif
