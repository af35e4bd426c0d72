// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Triangles from a few bytes: star-shaped surfaces, and what only begins as one.
#ifndef flipflop_fuzz_DrawSurface_h
#define flipflop_fuzz_DrawSurface_h

#include "Bytes.h"

#include "Testing/Engine/Inputs/Surfaces.h"

namespace flipflop
{
namespace fuzz
{

/// The hull of some points, its vertices drawn towards their mean; or any triangles. With a few
/// changes: corners swapped or out of range, triangles removed or doubled.
test::Surface drawSurface(Bytes& bytes, int most);

}
}

#endif
