// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What an engine does: from a tetrahedron to the hull of all points, perturbed. The first look at
/// the points is its own, too, if it will. All else of a run is the same for every engine (see
/// GeometryRun).
#ifndef flipflop_PolyhedronBuilder_h
#define flipflop_PolyhedronBuilder_h

#include "FlipFlop/FinishedCells.h"
#include "FlipFlop/Tally.h"
#include "Mesh/PlanePolyhedron.h"
#include "Mesh/Polyhedron.h"
#include "Points/PointSource.h"
#include "Points/Scan.h"
#include "Support/Monitor.h"
#include <flipflop/Options.h>
#include <flipflop/Statistics.h>

#include <cstdint>
#include <vector>

namespace flipflop
{

/// What there is to build from.
/// @tparam Model a model of the geometry concept (GeometryConcept.h)
template <class Model>
struct BuildTask
{
  Model& geometry; ///< its kernel point is inside the start
  const PointSource& source;
  const CoordinateRange& range; ///< of the scaled coordinates
  bool checkFinite;             ///< there are points to ignore
  const Options& options;
  int threads;
  Monitor& monitor;
  const std::vector<std::vector<std::uint32_t>>& samples; ///< as nestedSamples gives them
  /// For an engine that finishes itself; null: the hull is wanted.
  FinishedCells* finished;
  /// For an engine that makes triangulations in the plane alone; empty, where another has run.
  PlanePolyhedron* plane = nullptr;
};

template <class Model>
class PolyhedronBuilder : public PointScanner
{
public:
  /// Does it start from the points alone? Then it is given no samples and no tetrahedron, and the
  /// geometry has no kernel point.
  virtual bool startsFromPoints() const { return false; }

  /// @param start a tetrahedron
  /// @return the hull, perhaps with gaps; nothing, where *task.finished or *task.plane is written
  virtual Polyhedron build(
    const BuildTask<Model>& task, Polyhedron&& start, Tally& tally, Statistics& statistics) = 0;
};

}

#endif
