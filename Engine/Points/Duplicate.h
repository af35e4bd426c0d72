// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points at one position: whichever becomes a vertex, the lowest id stands for all in the end.
#ifndef flipflop_Duplicate_h
#define flipflop_Duplicate_h

#include <cstdint>

namespace flipflop
{

/// Two ids at one position.
struct Duplicate
{
  std::uint32_t first;
  std::uint32_t second;
};

}

#endif
