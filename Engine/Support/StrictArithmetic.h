// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Stops a build whose arithmetic is not IEEE 754's: exact signs would be wrong in silence.
///
/// No macro says whether products and sums are fused: the build's own -ffp-contract=off and
/// -fno-unsafe-math-optimizations come after a host's flags (CMake/FlipFlopCompilerOptions.cmake).
#ifndef flipflop_StrictArithmetic_h
#define flipflop_StrictArithmetic_h

#include <cfloat>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||     \
  defined(__NO_SIGNED_ZEROS__) || defined(_M_FP_FAST) ||                                           \
  (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0)
#error                                                                                             \
  "FlipFlop is exact only with IEEE 754 arithmetic: build it without -ffast-math, /fp:fast and parts of them."
#endif

// 16: half precision alone is evaluated as such.
#if FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16
#error                                                                                             \
  "FlipFlop is exact only where doubles are evaluated as doubles: build it with -msse2 -mfpmath=sse."
#endif

#endif
