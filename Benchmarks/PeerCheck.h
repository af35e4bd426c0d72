// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exact checks of what another library returned: coordinates and cells, in any form and order.
///
/// Its points are taken for the input's points of the same coordinates. Where it rounds them to
/// float, each stands for an input point that rounds alike: what is checked is which points it
/// chose and how it joined them. What it is compared with is the engine's own result, which
/// `validate` must have passed.
#ifndef flipflop_PeerCheck_h
#define flipflop_PeerCheck_h

#include "SurfaceCheck.h"
#include <flipflop/PointView.h>

#include <cstdint>
#include <string>
#include <vector>

namespace flipflop
{

struct PeerOutput
{
  std::vector<double> points; ///< x y z of each
  bool rounded = false;       ///< to float
  std::vector<std::int64_t> offsets = { 0 };
  std::vector<std::int64_t> connectivity;

  std::int64_t cellCount() const { return static_cast<std::int64_t>(this->offsets.size()) - 1; }

  /// How many points the cells use.
  std::int64_t vertexCount() const;
};

struct PeerReport
{
  bool possible = true;            ///< the points span enough
  std::int64_t unknownCorners = 0; ///< cells with a corner that is no input point
  std::int64_t outside = 0;        ///< input points outside the hull of the output's points
  double farthest = 0; ///< of them, by the points' greatest extent; 0 if rounding may explain it
  SurfaceFaults faults;

  bool isValid() const { return !this->unknownCorners && !this->faults.any(); }
};

/// Is it the hull of points in space? In a plane, it may also be their polygon.
PeerReport checkHull(const PointView& points, const PeerOutput& output);

/// Is it a Delaunay triangulation of points in the plane? Any one of cocircular points will do.
PeerReport checkDelaunay(const PointView& points, const PeerOutput& output);

/// In words. Of a triangulation, "only gaps" says that every point is there, and every triangle is
/// Delaunay.
std::string describeHull(const PeerReport& report);
std::string describeDelaunay(const PeerReport& report);

}

#endif
