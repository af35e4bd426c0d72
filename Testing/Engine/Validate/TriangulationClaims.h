// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Claims about weighted clouds, right and wrong, for the oracle to judge.
#ifndef flipflop_test_TriangulationClaims_h
#define flipflop_test_TriangulationClaims_h

#include "Testing/Engine/Conformance/CompareTriangulation.h"

namespace flipflop
{
namespace test
{

/// A claim about the cloud from plain values; the ids are those in the cells.
inline Triangulation claim(const Cloud& weighted, int dimension, std::vector<Cell> cells,
  FacetMode facets = FacetMode::Polygons)
{
  ReferenceTriangulation reference;
  reference.dimension = dimension;
  reference.ids = idsIn(cells);
  canonicalise(cells);
  reference.cells = std::move(cells);
  return makeTriangulation(reference, static_cast<std::int64_t>(weighted.size()), facets);
}

}
}

#endif
