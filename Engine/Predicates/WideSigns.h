// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The exact stage for coordinates whose exponents span more than expansions carry: the same signs
/// as ExpansionSigns, in integers of any size. Host only, and slow: it serves inputs that mix
/// 1e-300 with 1e300.
#ifndef flipflop_WideSigns_h
#define flipflop_WideSigns_h

#include "Predicates/ExactSigns.h"

namespace flipflop
{

struct WideSigns
{
  template <int Count>
  static int orient3(
    const double* a, const double* b, const double* c, const DeterminantRow<Count>& d);
  template <int Count>
  static int orient2(
    const double* a, const double* b, const DeterminantRow<Count>& c, int p, int q);
  template <int Count>
  static int compare(const double* a, const DeterminantRow<Count>& b, int p);
  static int along(const double* d, const double* a, const double* b);
  static int compareDistances(const double* a, const double* b, const double* c, const double* d);
};

/// The same for LiftedSigns. Where points are unweighted their weights are zeros.
struct WideLiftedSigns
{
  static int orient3(const double* a, const double* b, const double* c, const DeterminantRow<1>& d);
  static int orient2(const double* a, const double* b, const DeterminantRow<1>& c, int p, int q);
  static int compare(const double* a, const DeterminantRow<1>& b, int p);
  static int comparePowers(const double* q, const double* a, const double* b);
};

/// use (signs): with the signs that carry the range. The device leaves wide ranges to the host.
template <class Narrow, class Wide, class Use>
FF_HD int inArithmetic(bool wide, Use&& use)
{
#if defined(__CUDA_ARCH__)
  (void)wide;
#else
  if (wide)
  {
    return use(Wide());
  }
#endif
  return use(Narrow());
}

}

#endif
