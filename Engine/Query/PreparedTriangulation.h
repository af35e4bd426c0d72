// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A triangulation as queries need it: its sites in the arithmetic that carries them, its triangles
/// with a locator, or its chain of segments. Sites and triangles are in memory as they are in the
/// plane: along a curve.
#ifndef flipflop_PreparedTriangulation_h
#define flipflop_PreparedTriangulation_h

#include "Query/FanMesh.h"
#include "Query/SiteChain.h"
#include "Query/SiteLocator.h"
#include "Query/Sites.h"
#include <flipflop/Buffer.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>
#include <flipflop/Triangulation.h>

#include <cstdint>

namespace flipflop
{

class PreparedTriangulation
{
public:
  /// @param fixedEdges null: of a regular triangulation
  /// @param inside     a mask of the cells, of any dimension; null: all are inside
  /// @throw Error as TriangulationQueries
  PreparedTriangulation(const PointView& points, const WeightView& weights,
    const Triangulation& triangulation, const Buffer<std::int64_t>* fixedEdges,
    const std::uint8_t* inside, const Options& options);

  /// The locator refers to the sites.
  PreparedTriangulation(const PreparedTriangulation&) = delete;
  PreparedTriangulation& operator=(const PreparedTriangulation&) = delete;

  /// @param start where the search begins
  /// @return      -1 outside
  std::int64_t cellAt(const SiteSigns& signs, const double* position, WalkStart& start) const;

  /// -1: there is no site.
  std::int64_t nearestTo(const SiteSigns& signs, const double* position) const;

  /// The lowest cell that holds a position, by its number among those inside; NoIndex: there is
  /// none.
  std::uint32_t lowestCell(const MeshLocation& location) const;

  /// Is there one?
  bool isInside(const MeshLocation& location) const
  {
    return this->numbers.empty() ? location.kind != MeshLocation::Outside
                                 : this->lowestCell(location) != NoIndex;
  }

  /// The number of a cell among those inside; NoIndex: it is not one of them.
  std::uint32_t numberOf(std::uint32_t cell) const
  {
    return this->numbers.empty() ? cell : this->numbers[cell];
  }

  /// @throw Error BadArgument
  void requireRegular(const char* sentence) const;

  int dimension = -1;
  Sites sites;
  FanMesh mesh;        ///< of dimension 2
  SiteLocator locator; ///< of dimension 2
  SiteChain chain;     ///< of dimension 1; its cells have their numbers among those inside

private:
  void renumber(Monitor& monitor);
  void numberCells(std::int64_t count, const std::uint8_t* inside);

  bool isConstrained;
  Buffer<std::uint32_t> numbers; ///< of each cell; empty: its own
};

}

#endif
