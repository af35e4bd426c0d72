// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Merge two triangulated parts that a line separates (in space, a plane through the kernel point):
/// the rising bubble (L. Guibas, J. Stolfi: Primitives for the manipulation of general
/// subdivisions, 1985), on triangles with the virtual vertex.
///
///                 upper tangent
///                .-------------.
///      left     a               c     right      a, c  the next vertex up on each shore
///      part   / |               | \   part       d     the corner behind the border edge from l to
///      a
///            d  |   ?       ?   |
///             \ |               |  /             The next triangle on the base l-r has the corner
///               l---------------r                a or c, whose circle through l and r is empty.
///               |    base      /|                First, while d is in the circle of l, r and a,
///               | \         /   |                the edge from l to a goes, and d is the next on
///               |    \  /       |                the left, and likewise on the right.
///               x-------.-------y
///                 lower tangent
///
/// From the lower common tangent up, the seam fills the gap with triangles. Between a shore and the
/// gap are virtual triangles, one for each border edge:
///  - an edge that loses is flipped: its virtual triangle and the triangle behind it become the
///    virtual triangles of the two edges at d;
///  - an edge that the seam reaches gives its virtual triangle, which becomes the seam's;
///  - at the tangents, two free triangles close the border of the whole.
/// So a merge needs no memory.
///
/// With weights and in space, the circle test is the power test or the side of a plane, by
/// perturbed signs, and vertices may be hidden: the seam passes over them. Seen from the seam's
/// last edge, such a vertex is behind the triangle beneath, so its edge from there is no edge of
/// the whole. Such edges are flipped away like those that lose. One that has no triangle on either
/// side is all that connects what is beyond it, for the border passes it twice: this is hidden,
/// too. Whatever is flipped away, the points of the other side are above it; the seam's triangles
/// are right for any convex lift.
#ifndef flipflop_PartMerge_h
#define flipflop_PartMerge_h

#include "FlipFlop/Part.h"
#include "FlipFlop/Tally.h"
#include "Geometry/HullGeometry.h"
#include "Geometry/LiftedGeometry.h"

#include <cstdint>
#include <vector>

namespace flipflop
{

/// @tparam Geometry LiftedGeometry, or HullGeometry with a kernel point that is a double's
template <class Geometry>
class PartMerge
{
public:
  using AnyMesh = PartMesh<Geometry>;

  /// @param geometryToUse its kernel point is the virtual vertex
  PartMerge(const Geometry& geometryToUse, const AnyMesh& meshToChange)
    : geometry(geometryToUse)
    , mesh(meshToChange)
    , ring(meshToChange)
  {
  }

  /// The triangulation of both parts' points. Their order does not matter.
  Part merge(const Part& first, const Part& second);

  void addTo(Tally& tally) const;

protected:
  /// Vertices may be hidden, and signs are perturbed.
  static constexpr bool Hides = !Geometry::AllExtreme;

  /// One part's side of the seam. Up, the border goes clockwise around the right part, and
  /// counter-clockwise around the left one.
  struct Shore
  {
    bool isLeft;
    std::uint32_t vertex;    ///< where the seam is
    std::uint32_t spoke;     ///< of the next border edge up; NoIndex: there is none
    std::uint32_t edges = 0; ///< so many are still to be reached
    std::uint32_t reached = 0;
  };

  /// What the seam's next triangle may have as its third corner.
  struct Candidate
  {
    const Shore* shore;
    std::uint32_t vertex = NoIndex;
    bool isAbove = false; ///< the seam's last edge
    bool isFlat = false;  ///< its circle goes through the corner behind its border edge, too
  };

  Shore shoreOf(bool isLeft, std::uint32_t vertex, std::uint32_t spoke) const
  {
    return { isLeft, vertex, spoke == NoIndex || !isLeft ? spoke : this->ring.previous(spoke) };
  }

  // Of a border edge's spoke, on a shore.
  std::uint32_t upper(const Shore& shore, std::uint32_t spoke) const
  {
    return shore.isLeft ? this->ring.begin(spoke) : this->ring.end(spoke);
  }
  std::uint32_t lower(const Shore& shore, std::uint32_t spoke) const
  {
    return shore.isLeft ? this->ring.end(spoke) : this->ring.begin(spoke);
  }
  std::uint32_t onward(const Shore& shore, std::uint32_t spoke) const
  {
    return shore.isLeft ? this->ring.previous(spoke) : this->ring.next(spoke);
  }
  std::uint32_t backward(const Shore& shore, std::uint32_t spoke) const
  {
    return shore.isLeft ? this->ring.next(spoke) : this->ring.previous(spoke);
  }
  /// The virtual triangle's half-edge between the virtual vertex and the edge's upper end.
  static std::uint32_t upperSide(const Shore& shore, std::uint32_t spoke)
  {
    return shore.isLeft ? spoke : previousHalfEdge(spoke);
  }
  static std::uint32_t lowerSide(const Shore& shore, std::uint32_t spoke)
  {
    return shore.isLeft ? previousHalfEdge(spoke) : spoke;
  }
  /// The same of the triangle that closes the border below.
  static std::uint32_t bottomSide(const Shore& shore, std::uint32_t bottom)
  {
    return halfEdge(bottom, shore.isLeft ? 1 : 2);
  }

  void findTangents(const Part& lower, const Part& upper, int axis);
  void findTangents(const Part& first, const Part& second);
  bool follow(Shore& shore, bool up, const Shore& l, const Shore& r);
  void turn(Shore& l, Shore& r, bool up);
  void cutBorders(std::uint32_t bottom);
  Part join(const Part& lower, const Part& upper);
  void rise();
  Candidate candidate(Shore& shore);
  bool isPassed(const Shore& shore, std::uint32_t vertex);
  bool losesBeyond(const Shore& shore, std::uint32_t inner, const Candidate& found);
  std::uint32_t edgesUntil(const Shore& shore, std::uint32_t inner);
  void hideBeyond(Shore& shore, std::uint32_t inner);
  void uncover(Shore& shore, std::uint32_t inner);
  void reach(Shore& shore, const Candidate& next);
  void closeTriangle(std::uint32_t onBase, std::uint32_t outer, const Candidate& next);

  /// Perturbed, never zero.
  int orient(std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    const int sign =
      this->geometry.orient(this->mesh.vertex(a), this->mesh.vertex(b), this->mesh.vertex(c));
    if (Hides && sign == 0)
    {
      ++this->ties; // a facet that is vertical
      return this->geometry.tieKernelBeneath(
        this->mesh.vertex(a), this->mesh.vertex(b), this->mesh.vertex(c));
    }
    return sign;
  }
  /// Is p inside the circle through the ends of the seam's last edge and the next corner?
  /// Perturbed, never zero.
  int inCircle(const Candidate& next, std::uint32_t p)
  {
    const int sign = this->exactInCircle(next, p);
    return Hides && sign == 0 ? this->geometry.tieAbove(this->mesh.vertex(this->left.vertex),
                                  this->mesh.vertex(this->right.vertex),
                                  this->mesh.vertex(next.vertex), this->mesh.vertex(p))
                              : sign;
  }
  /// Relative to the edge's end on the corner's side: the differences are short there, and so is
  /// the rounding error.
  int exactInCircle(const Candidate& next, std::uint32_t p)
  {
    ++this->checks;
    const Vertex l = this->mesh.vertex(this->left.vertex);
    const Vertex r = this->mesh.vertex(this->right.vertex);
    const Vertex n = this->mesh.vertex(next.vertex);
    const Vertex q = this->mesh.vertex(p);
    const int sign =
      next.shore->isLeft ? this->geometry.above(l, r, n, q) : this->geometry.above(r, n, l, q);
    this->ties += sign == 0 ? 1 : 0;
    return sign;
  }

  /// An edge goes: where its ends are at one position, one id stands for both.
  void noteIfDuplicates(std::uint32_t a, std::uint32_t b)
  {
    const auto* const v = this->mesh.vertices;
    if (Hides && samePosition(v[a], v[b]))
    {
      this->duplicates.push_back({ v[a].id, v[b].id });
    }
  }

  const Geometry& geometry;
  const AnyMesh mesh;
  const BorderRing<AnyMesh> ring;
  Shore left{};
  Shore right{};
  std::uint32_t base = NoIndex;  ///< the seam's last edge: a half-edge from right to left
  std::uint32_t below = NoIndex; ///< the corner beneath it; NoIndex at the start
  std::vector<Duplicate> duplicates;
  std::vector<std::uint32_t> hiding; ///< triangles
  std::int64_t flips = 0;
  std::int64_t hidden = 0;
  std::int64_t checks = 0;
  std::int64_t walked = 0;
  std::int64_t ties = 0;
};

extern template class PartMerge<LiftedGeometry<false>>;
extern template class PartMerge<LiftedGeometry<true>>;
extern template class PartMerge<HullGeometry>;

}

#endif
