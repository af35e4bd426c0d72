// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A result that an engine has finished itself, in memory of its own: then the polyhedron never
/// leaves it. An engine may do so where no sign was a tie, for then no edge is flat and no two
/// vertices are at one position; all else of the finish is CanonicalForm's.
#ifndef flipflop_FinishedCells_h
#define flipflop_FinishedCells_h

#include <flipflop/Hull.h>

#include <cstdint>

namespace flipflop
{

struct FinishedCells
{
  Buffer<std::int64_t> pointIds;
  Buffer<std::int64_t> connectivity; ///< of triangles, in canonical order
  double volume = 0;                 ///< where they are wanted
  double area = 0;
};

}

#endif
