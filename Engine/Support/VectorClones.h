// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// FF_VECTOR_CLONES before a function compiles it for several vector units; the loader picks at run
/// time.
///
/// FF_VECTOR_TARGETS is defined where a function may be written once for each of these units.
///
/// For the few loops that pass over all points. What they compute is the same on every unit: sums
/// are not reordered, products not fused.
#ifndef flipflop_VectorClones_h
#define flipflop_VectorClones_h

#include <cstddef> // for __GLIBC__

#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
#define FF_VECTOR_CLONES // a sanitizer is not ready yet when the loader picks
#elif defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && __GNUC__ >= 12 &&          \
  !defined(__clang__)
#define FF_VECTOR_TARGETS
#define FF_VECTOR_CLONES                                                                           \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define FF_VECTOR_CLONES
#endif

#endif
