// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The finish, second part: the one canonical form of a result (see CellComplex.h).
#ifndef flipflop_Canonical_h
#define flipflop_Canonical_h

#include "Finish/FacetPolygons.h"
#include "Finish/VertexRanks.h"
#include "Mesh/PlanePolyhedron.h"
#include "Mesh/Polyhedron.h"
#include "Points/CoordinateRange.h"
#include "Support/Monitor.h"
#include <flipflop/CellComplex.h>
#include <flipflop/Hull.h>
#include <flipflop/Options.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace flipflop
{

/// What touches the virtual vertex is omitted: it is no facet of the result, and no point.
/// @tparam Surface Polyhedron, or PlanePolyhedron
template <class Surface>
class CanonicalForm
{
public:
  /// @param surface    vertices that are alive are strictly extreme; flatEdges() holds the edges
  ///                   that facets go on across. It must outlive this.
  /// @param anyFlat    whether there may be a flat edge
  /// @param duplicates pairs of ids at one position
  /// @param pointCount ids are below this
  /// @param facets     what writeCells will write
  /// @param monitor    is polled
  /// @param pointIds   is filled in
  /// @throw Error Aborted
  CanonicalForm(Surface& surface, bool anyFlat, const std::vector<Duplicate>& duplicates,
    std::uint32_t pointCount, FacetMode facets, Monitor& monitor, Buffer<std::int64_t>& pointIds);

  /// Where in the result's points the vertices are.
  const VertexRanks& ranks() const { return this->rank; }

  /// The facets, in their order. The last call: the surface's memory becomes theirs.
  /// @throw Error Aborted, between its passes
  void writeCells(Monitor& monitor, CellComplex& complex);

  /// The same of a hull, with its volume and area. Both facet modes measure the same triangles.
  /// @param range    of the scaled coordinates
  /// @param exponent coordinates are scaled by 2^exponent
  void writeHull(const CoordinateRange& range, int exponent, Monitor& monitor, Hull& hull);

private:
  template <class Use>
  void eachTriangle(Use&& use) const;
  template <class Use>
  void eachFanTriangle(Use&& use) const;
  template <class Use>
  void eachPolygonCell(std::uint32_t pointCount, Use&& use) const;
  template <class Use>
  void write(Monitor& monitor, CellComplex& complex, Use&& useToo);

  const FacetMode facets;
  Surface& surface;
  VertexRanks rank;
  std::optional<FacetPolygons<Surface>> polygons; ///< none: no edge is flat
};

extern template class CanonicalForm<Polyhedron>;
extern template class CanonicalForm<PlanePolyhedron>;

}

#endif
