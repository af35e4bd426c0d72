// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Claims about weighted clouds, right and wrong, for the oracle to judge.
#ifndef flipflop_test_TriangulationClaims_h
#define flipflop_test_TriangulationClaims_h

#include "Testing/Engine/Conformance/CompareTriangulation.h"

#include <algorithm>
#include <functional>

namespace flipflop
{
namespace test
{

inline Fault faultOf(const Cloud& weighted, const Triangulation& triangulation)
{
  const Validation one = validate(viewOf(weighted), weightsOf(weighted), triangulation, 1);
  const Validation two = validate(viewOf(weighted), weightsOf(weighted), triangulation, 2);
  EXPECT_EQ(one.fault, two.fault);
  EXPECT_EQ(one.index, two.index);
  EXPECT_STRNE(describe(one.fault), "");
  return one.fault;
}

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

/// The triangles of a reference, or of cells, as they are.
inline Triangulation claimTriangles(const Cloud& weighted, std::vector<Cell> cells)
{
  return claim(weighted, 2, std::move(cells), FacetMode::Triangles);
}

inline Triangulation whole(const Cloud& weighted, FacetMode facets = FacetMode::Polygons)
{
  return makeTriangulation(cgalTriangulation(weighted, kernelForWeighted(weighted)),
    static_cast<std::int64_t>(weighted.size()), facets);
}

/// Break a copy, expecting Structure.
class Breaker
{
public:
  Breaker(const Cloud& weighted, const Triangulation& right)
    : Weighted(weighted)
    , Right(right)
  {
    EXPECT_EQ(faultOf(weighted, right), Fault::None);
  }

  void operator()(const char* what, const std::function<void(Triangulation&)>& change) const
  {
    Triangulation copy = clone(this->Right);
    change(copy);
    EXPECT_EQ(faultOf(this->Weighted, copy), Fault::Structure) << what;
  }

private:
  const Cloud& Weighted;
  const Triangulation& Right;
};

}
}

#endif
