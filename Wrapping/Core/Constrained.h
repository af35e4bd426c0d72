// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Constrained triangulations, as Python has them.
#ifndef flipflop_Constrained_h
#define flipflop_Constrained_h

#include "Results.h"

#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/Triangulation.h>

#include <memory>

namespace flipflop
{

/// A constrained triangulation as a whole, and what is inside its polygons.
struct Constrained
{
  std::shared_ptr<const ConstrainedTriangulation> whole;
  Handle<Triangulation> inside; ///< the whole itself, if all is inside
};

}

#endif
