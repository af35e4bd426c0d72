// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Questions to a triangulation, which knows how many points it was given.
#ifndef flipflop_TriangulationSites_h
#define flipflop_TriangulationSites_h

#include <flipflop/TriangulationQueries.h>

#include <cstdint>

namespace flipflop
{

struct Sites
{
  TriangulationQueries queries;
  std::int64_t points;
};

}

#endif
