// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The steps in which every geometry decides a sign (paper, section 3.3): a floating-point filter,
/// exact arithmetic, and perturbation where the exact sign is zero.
#ifndef flipflop_PredicateSteps_h
#define flipflop_PredicateSteps_h

#include "Points/Vertex.h"
#include "Support/HostDevice.h"

#include <cstdint>

namespace flipflop
{

/// What a geometry counts while it decides. It is copied for each task.
struct PredicateCounts
{
  std::int64_t exact = 0; ///< signs that the floating-point filter left undecided
  std::int64_t ties = 0;  ///< signs of "above" that only the perturbation decides
};

/// @tparam Geometry derives from this, and has each step alone: filterAbove, exactAbove, tieAbove
/// and
///               filterKernelBeneath, exactKernelBeneath, tieKernelBeneath
template <class Geometry>
class PredicateSteps
{
public:
  FF_HD FF_INLINE int above(
    const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    int sign;
    return this->geometry().filterAbove(a, b, c, p, sign) ? sign
                                                          : this->geometry().exactAbove(a, b, c, p);
  }

  FF_HD FF_INLINE int perturbedAbove(
    const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    const int sign = this->above(a, b, c, p);
    if (sign)
    {
      return sign;
    }
    ++this->counts.ties;
    return this->geometry().tieAbove(a, b, c, p);
  }

  FF_HD int kernelBeneath(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    int sign;
    return this->geometry().filterKernelBeneath(a, b, c, sign)
      ? sign
      : this->geometry().exactKernelBeneath(a, b, c);
  }

  FF_HD int perturbedKernelBeneath(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    const int sign = this->kernelBeneath(a, b, c);
    return sign ? sign : this->geometry().tieKernelBeneath(a, b, c);
  }

  FF_HD const PredicateCounts& predicateCounts() const { return this->counts; }

protected:
  mutable PredicateCounts counts;

private:
  FF_HD const Geometry& geometry() const { return static_cast<const Geometry&>(*this); }
};

}

#endif
