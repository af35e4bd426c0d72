// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The finish, second part: the one canonical form of a result (see CellComplex.h).
#ifndef flipflop_Canonical_h
#define flipflop_Canonical_h

#include "Mesh/Polyhedron.h"
#include "Points/CoordinateRange.h"
#include "Points/Duplicate.h"
#include "Support/Monitor.h"
#include <flipflop/CellComplex.h>
#include <flipflop/Hull.h>
#include <flipflop/Options.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace flipflop
{

class FacetPolygons;

/// What touches the virtual vertex is left out: it is no facet of the result, and no point.
class CanonicalForm
{
public:
  /// @param polyhedron strictly extreme vertices only; flatEdges() tells which edges are flat. It
  ///                   must outlive this.
  /// @param anyFlat    whether there is a flat edge at all
  /// @param duplicates pairs of ids at one position
  /// @param pointCount ids are below this
  /// @param facets     what writeCells will write
  /// @param monitor    is asked while it works
  /// @param pointIds   is filled in
  /// @throw Error Aborted
  CanonicalForm(Polyhedron& polyhedron, bool anyFlat, const std::vector<Duplicate>& duplicates,
    std::uint32_t pointCount, FacetMode facets, Monitor& monitor, Buffer<std::int64_t>& pointIds);
  ~CanonicalForm();

  /// Where in the result's points a vertex is; NoIndex: it is none of them.
  std::uint32_t rankOf(std::uint32_t vertex) const { return this->rank[vertex]; }

  /// The facets, in their order. The last call: the polyhedron's memory becomes theirs.
  /// @throw Error Aborted, between its passes
  void writeCells(Monitor& monitor, CellComplex& complex);

  /// The same of a hull, with its volume and area. Both facet modes measure the same triangles.
  /// @param range    of the scaled coordinates
  /// @param exponent coordinates are scaled by 2^exponent
  void writeHull(const CoordinateRange& range, int exponent, Monitor& monitor, Hull& hull);

private:
  std::uint32_t otherOf(std::uint32_t t) const;
  template <class Use>
  void useSingle(std::uint32_t t, Use&& use) const;
  template <class Use>
  void usePair(std::uint32_t t, std::uint32_t other, Use&& use) const;
  template <class Use>
  void eachFanTriangle(Use&& use) const;
  template <class Use>
  void eachPolygonCell(std::uint32_t pointCount, Use&& use) const;
  template <class Use>
  void write(Monitor& monitor, CellComplex& complex, Use&& useToo);

  const FacetMode facets;
  Polyhedron& polyhedron;
  Buffer<std::uint32_t> rank;                    ///< by vertex; NoIndex: no point of the result
  std::unique_ptr<const FacetPolygons> polygons; ///< null: no edge is flat
};

}

#endif
