// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Merge two triangulated parts that a vertical or a horizontal line separates: the rising bubble
/// (L. Guibas, J. Stolfi: Primitives for the manipulation of general subdivisions, 1985), on
/// triangles with the virtual vertex.
///
/// From the lower common tangent up, the next corner of the seam is the one whose circle through
/// the ends of the last edge is empty. An edge inside a part that loses is flipped with the virtual
/// triangle next to it, and so comes to the border; the virtual triangle of a border edge that the
/// seam reaches becomes the seam's triangle. Two free triangles close the border at the tangents.
///
/// With weights, the circle test is the power test, by perturbed signs, and vertices may be hidden:
/// the seam triangle passes over them. Seen from the seam's last edge, such a vertex is behind the
/// triangle beneath, so its edge from there is no edge of the whole. Such edges are flipped away
/// like those that lose. One that has no triangle on either side is all that connects what is
/// beyond it, for the border passes it twice: this is hidden, too. Whatever is flipped away, the
/// points of the other side are above it; the seam's triangles are right for any convex lift.
#ifndef flipflop_PartMerge_h
#define flipflop_PartMerge_h

#include "FlipFlop/PlanePart.h"
#include "FlipFlop/Tally.h"
#include "Geometry/LiftedGeometry.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

/// @tparam Weighted false: all weights are zero
template <bool Weighted>
class PartMerge
{
public:
  using Geometry = LiftedGeometry<Weighted>;
  using Mesh = PartMesh<Weighted>;

  PartMerge(const Geometry& geometryToUse, const Mesh& meshToChange)
    : geometry(geometryToUse)
    , mesh(meshToChange)
    , ring(meshToChange)
  {
  }

  /// The triangulation of both parts' points. Their order does not matter.
  PlanePart merge(const PlanePart& first, const PlanePart& second);

  void addTo(Tally& tally) const;

private:
  /// One part's side of the seam.
  struct Shore
  {
    std::uint32_t vertex; ///< where the seam is
    std::uint32_t spoke;  ///< of the next border edge that the seam reaches; NoIndex: there is none
    std::uint32_t edges;  ///< so many are still to be reached
    std::uint32_t reached;

    void advance()
    {
      --this->edges;
      ++this->reached;
    }
  };

  struct Candidate
  {
    std::uint32_t vertex = NoIndex;
    bool isLeft = false;
    bool isAbove = false; ///< the seam's last edge
    bool isFlat = false;  ///< its circle goes through the corner behind its border edge, too
  };

  void countEdgesAbove();
  void findLowerTangent();
  PlanePart join(const PlanePart& lower, const PlanePart& upper);
  Candidate candidate(bool isLeft);
  bool isPassed(bool isLeft, std::uint32_t vertex);
  void hideBeyond(bool isLeft, std::uint32_t inner);
  void uncoverLeft(std::uint32_t inner, std::uint32_t a, std::uint32_t d);
  void uncoverRight(std::uint32_t inner, std::uint32_t c, std::uint32_t d);
  void rise();
  void reachLeft(const Candidate& next);
  void reachRight(const Candidate& next);
  void closeTriangle(std::uint32_t onBase, std::uint32_t outer, const Candidate& next);

  /// With weights, never zero.
  int orient(std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    const int sign =
      this->geometry.orient(this->mesh.vertex(a), this->mesh.vertex(b), this->mesh.vertex(c));
    if (Weighted && sign == 0)
    {
      ++this->ties; // a facet that is vertical
      return this->geometry.tieKernelBeneath(
        this->mesh.vertex(a), this->mesh.vertex(b), this->mesh.vertex(c));
    }
    return sign;
  }
  /// Is p inside the circle through the ends of the seam's last edge and the next corner? With
  /// weights, the power test, and never zero.
  int inCircle(bool isLeft, std::uint32_t next, std::uint32_t p)
  {
    const int sign = this->exactInCircle(isLeft, next, p);
    return Weighted && sign == 0
      ? this->geometry.tieAbove(this->mesh.vertex(this->left.vertex),
          this->mesh.vertex(this->right.vertex), this->mesh.vertex(next), this->mesh.vertex(p))
      : sign;
  }
  /// Relative to the edge's end on the corner's side: the differences are short there, and so is
  /// the rounding error.
  int exactInCircle(bool isLeft, std::uint32_t next, std::uint32_t p)
  {
    ++this->checks;
    const Vertex l = this->mesh.vertex(this->left.vertex);
    const Vertex r = this->mesh.vertex(this->right.vertex);
    const Vertex n = this->mesh.vertex(next);
    const Vertex q = this->mesh.vertex(p);
    const int sign = isLeft ? this->geometry.above(l, r, n, q) : this->geometry.above(r, n, l, q);
    this->ties += sign == 0 ? 1 : 0;
    return sign;
  }

  /// An edge goes: where its ends are at one position, one id stands for both.
  void noteIfDuplicates(std::uint32_t a, std::uint32_t b)
  {
    const auto* const v = this->mesh.vertices;
    if (Weighted && samePosition(v[a], v[b]))
    {
      this->duplicates.push_back({ v[a].id, v[b].id });
    }
  }

  const Geometry& geometry;
  const Mesh mesh;
  const BorderRing<Mesh> ring;
  Shore left{};
  Shore right{};
  std::uint32_t base = NoIndex;  ///< the seam's last edge: a half-edge from right to left
  std::uint32_t below = NoIndex; ///< the corner beneath it; NoIndex at the start
  std::vector<Duplicate> duplicates;
  std::vector<std::uint32_t> hiding; ///< triangles
  std::int64_t flips = 0;
  std::int64_t hidden = 0;
  std::int64_t checks = 0;
  std::int64_t ties = 0;
};

extern template class PartMerge<false>;
extern template class PartMerge<true>;

}

#endif
