// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What an engine does: from a tetrahedron to the hull of all points, perturbed. It may scan the
/// points, too. The other steps are the same for every engine (ConvexHull.cxx,
/// RegularTriangulation.cxx).
#ifndef flipflop_PolyhedronBuilder_h
#define flipflop_PolyhedronBuilder_h

#include "FlipFlop/FinishedCells.h"
#include "FlipFlop/Tally.h"
#include "Mesh/PlanePolyhedron.h"
#include "Mesh/Polyhedron.h"
#include "Points/PointSource.h"
#include "Points/Samples.h"
#include "Points/Scan.h"
#include "Support/Monitor.h"
#include <flipflop/Options.h>
#include <flipflop/Statistics.h>

#include <variant>

namespace flipflop
{

/// What there is to build from.
/// @tparam Geometry a model of the geometry concept (GeometryConcept.h)
template <class Geometry>
struct BuildTask
{
  Geometry& geometry; ///< its kernel point is inside the start
  const PointSource& source;
  const CoordinateRange& range; ///< of the scaled coordinates
  bool checkFinite;             ///< there are points to ignore
  const Options& options;
  int threads;
  Monitor& monitor;
  const Samples& samples; ///< see nestedSamples()
  bool measured = false;  ///< of FinishedCells, volume and area are wanted
  int scaleExponent = 0;  ///< coordinates are scaled by 2^scaleExponent
};

/// The hull of all points, perturbed, perhaps with gaps; or a triangulation of the plane without
/// weights, which is the true one already; or what an engine has finished itself.
using BuildResult = std::variant<Polyhedron, PlanePolyhedron, FinishedCells>;

template <class Geometry>
class PolyhedronBuilder : public PointScanner
{
public:
  /// Does it start from the points alone? Then a triangulation passes it no samples and no
  /// tetrahedron, and the geometry has no kernel point.
  virtual bool startsFromPoints() const { return false; }

  /// @param start a tetrahedron
  virtual BuildResult build(
    const BuildTask<Geometry>& task, Polyhedron&& start, Tally& tally, Statistics& statistics) = 0;
};

}

#endif
