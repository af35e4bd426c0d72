// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Run the regular triangulation and hold what it says to a reference, cell by cell.
#ifndef flipflop_test_CompareTriangulation_h
#define flipflop_test_CompareTriangulation_h

#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/References/ReferenceTriangulation.h"
#include <flipflop/RegularTriangulation.h>

namespace flipflop
{
namespace test
{

/// The weights of a weighted cloud, as they lie in it; its points are viewOf().
WeightView weightsOf(const Cloud& weighted);

Triangulation clone(const Triangulation& triangulation);

/// A Triangulation from plain values.
Triangulation makeTriangulation(const ReferenceTriangulation& reference, std::int64_t points,
  FacetMode facets = FacetMode::Polygons);

/// What differs from the reference, in words; empty when nothing does.
std::string difference(const Triangulation& triangulation, const ReferenceTriangulation& reference,
  FacetMode facets, std::int64_t points);

std::string bitDifference(const Triangulation& a, const Triangulation& b);

/// Identities that every run's statistics keep.
std::string statisticsFault(const Triangulation& triangulation, std::int64_t points);

}
}

#endif
