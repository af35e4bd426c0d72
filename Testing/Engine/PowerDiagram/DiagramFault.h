// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A power diagram in a box against all that it promises, in exact arithmetic.
#ifndef flipflop_test_DiagramFault_h
#define flipflop_test_DiagramFault_h

#include "Testing/Engine/Inputs/Cloud.h"

#include <flipflop/PowerDiagram.h>

#include <array>
#include <string>

namespace flipflop
{
namespace test
{

/// x least, x greatest, y least, y greatest.
using Box = std::array<double, 4>;

/// The first fault in words, or nothing: the form; cells are simple, counter-clockwise, fill the
/// box edge to edge, and reach no more than 16 units of the last place beyond the lines of equal
/// power to any other site. So each position has, but for these, the cell of its site.
std::string diagramFault(const PowerDiagram& diagram, const Cloud& sites,
  const Triangulation& triangulation, const Box& box);

/// Does any cell have a corner that turns right?
bool hasReflexCorner(const PowerDiagram& diagram);

}
}

#endif
