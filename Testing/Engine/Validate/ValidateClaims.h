// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Claims of results of either kind, right and wrong, to be validated.
#ifndef flipflop_test_ValidateClaims_h
#define flipflop_test_ValidateClaims_h

#include "Testing/Engine/Conformance/Kind.h"
#include "Testing/Engine/Validate/TriangulationClaims.h"

namespace flipflop
{
namespace test
{

/// A result of a kind, made as a triangulation.
inline Result asKind(const Kind& kind, Triangulation made)
{
  if (kind.dimension == 2)
  {
    return made;
  }
  Hull hull;
  copyCells(made, hull);
  return hull;
}

/// A result of a kind from plain values.
inline Result makeResult(
  const Kind& kind, const ReferenceHull& reference, std::size_t points, FacetMode facets)
{
  return asKind(kind, makeTriangulation(reference, static_cast<std::int64_t>(points), facets));
}

inline CellComplex& cellsIn(Result& result)
{
  auto* hull = std::get_if<Hull>(&result);
  return hull ? static_cast<CellComplex&>(*hull) : std::get<Triangulation>(result);
}

inline Result clone(const Result& result)
{
  const auto* hull = std::get_if<Hull>(&result);
  return hull ? Result(clone(*hull)) : Result(clone(std::get<Triangulation>(result)));
}

/// What validate finds, the same on one thread and on two.
inline Validation validationOf(const Cloud& cloud, const Result& result)
{
  const Validation one = validate(cloud, result, 1);
  const Validation two = validate(cloud, result, 2);
  EXPECT_EQ(one.fault, two.fault);
  EXPECT_EQ(one.index, two.index);
  EXPECT_STRNE(describe(one.fault), "");
  return one;
}

/// A claim from cells alone: the ids are those in the cells.
/// @param facets with Triangles, the cells are triangles as they are
inline Result claimOf(const Kind& kind, const Cloud& cloud, int dimension, std::vector<Cell> cells,
  FacetMode facets = FacetMode::Polygons)
{
  return asKind(kind, claim(cloud, dimension, std::move(cells), facets));
}

}
}

#endif
