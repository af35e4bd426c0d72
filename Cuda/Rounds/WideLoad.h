// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Triangles and vertices, read whole: by two loads of 16 bytes each, where field by field it would
/// be up to eight. What a warp's threads read lies far apart, so the loads count, not their bytes.
#ifndef flipflop_WideLoad_h
#define flipflop_WideLoad_h

#include "Support/HostDevice.h"

#include <cstring>

namespace flipflop
{

/// A copy.
template <class T>
FF_HD FF_INLINE T whole(const T& from)
{
#if defined(__CUDA_ARCH__)
  static_assert(sizeof(T) == 32 && alignof(T) == 32, "two loads");
  const uint4* const halves = reinterpret_cast<const uint4*>(&from);
  const uint4 copies[2] = { halves[0], halves[1] };
  T result;
  memcpy(&result, copies, sizeof(result));
  return result;
#else
  return from;
#endif
}

}

#endif
