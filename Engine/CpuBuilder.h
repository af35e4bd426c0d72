// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The engine on this machine's threads, whichever suits the geometry.
#ifndef flipflop_CpuBuilder_h
#define flipflop_CpuBuilder_h

#include "Builder.h"
#include "InsertionBuilder.h"

#include <type_traits>

namespace flipflop
{

template <class Geometry>
using CpuBuilder =
  std::conditional_t<Geometry::InsertsAtOnce, InsertionBuilder<Geometry>, Builder<Geometry>>;

}

#endif
