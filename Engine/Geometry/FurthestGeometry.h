// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The geometry of furthest-site triangulations: LiftedGeometry without weights, its heights turned
/// over. A point is above a triangle if it is outside of its circle. It has the signs of the
/// concept in GeometryConcept.h, which insertion and the finish take.
#ifndef flipflop_FurthestGeometry_h
#define flipflop_FurthestGeometry_h

#include "Geometry/LiftedGeometry.h"
#include "Points/Vertex.h"
#include "Predicates/PredicateSteps.h"

namespace flipflop
{

class FurthestGeometry : public PredicateSteps<FurthestGeometry>
{
public:
  /// Only the corners of the convex hull are.
  static constexpr bool AllExtreme = false;

  FurthestGeometry() = default;
  explicit FurthestGeometry(const LiftedGeometry<false>& of)
    : lifted(of)
  {
  }

  bool filterAbove(
    const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p, int& sign) const
  {
    const bool decided = this->lifted.filterAbove(a, b, c, p, sign);
    sign *= turned(a, b, c, p);
    return decided;
  }

  bool filterKernelBeneath(const Vertex& a, const Vertex& b, const Vertex& c, int& sign) const
  {
    return this->lifted.filterKernelBeneath(a, b, c, sign);
  }

  int exactAbove(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    ++this->counts.exact;
    return turned(a, b, c, p) * this->lifted.exactAbove(a, b, c, p);
  }

  int exactKernelBeneath(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    ++this->counts.exact;
    return this->lifted.exactKernelBeneath(a, b, c);
  }

  int tieAbove(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    return turned(a, b, c, p) * this->lifted.tieAbove(a, b, c, p);
  }

  int tieKernelBeneath(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    return this->lifted.tieKernelBeneath(a, b, c);
  }

  /// On a triangle, only its corners are on its circle; on the border's line, what is between the
  /// ends is beneath their chord.
  static bool mayAppearOn(const Vertex&, const Vertex&, const Vertex&, const Vertex&)
  {
    return false;
  }

  bool collinear(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    return this->lifted.collinear(a, b, c);
  }

private:
  /// The virtual vertex is at height -infinity as before: orientations stay.
  static int turned(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p)
  {
    return LiftedGeometry<false>::isVirtual(a, b, c, p) ? 1 : -1;
  }

  LiftedGeometry<false> lifted;
};

}

#endif
