// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The arrays of an editable mesh at a moment: the finish of a run, on a copy of it.
#ifndef flipflop_MeshSnapshot_h
#define flipflop_MeshSnapshot_h

#include "Edit/EditableMesh.h"
#include "Support/Monitor.h"
#include <flipflop/ConstrainedTriangulation.h>

#include <cstdint>
#include <vector>

namespace flipflop
{

/// Write the points and the cells of a mesh with triangles, with the vertices' ids.
/// @param idLimit ids are below this
template <bool Weighted>
void writeCells(const EditableMesh<Weighted>& mesh, std::uint32_t idLimit, const Options& options,
  Monitor& monitor, Triangulation& result);

/// A constraint, by the slots of two visible points.
struct MeshConstraint
{
  std::uint32_t from, to;
  std::uint32_t number;
  bool isSide; ///< of a polygon
};

/// Write the fixed edges, after the cells.
/// @param constraints all, by ascending numbers; each runs along fixed edges
void writeConstraints(const EditableMesh<false>& mesh,
  const std::vector<MeshConstraint>& constraints, ConstrainedTriangulation& result);

}

#endif
