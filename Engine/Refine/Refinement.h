// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Delaunay refinement (J. Ruppert, "A Delaunay refinement algorithm for quality 2-dimensional mesh
/// generation", 1995; L. P. Chew, "Guaranteed-quality mesh generation for curved surfaces", 1993).
///
/// - A segment that a vertex encroaches upon is divided, in the middle; at a small angle of the
///   input, at a power of two from its apex.
/// - A triangle with a small angle, or that is too large, gets a vertex at its center, or at the
///   off-center. If that would encroach upon a segment, or is behind one, the segment is divided.
/// - A small angle between two segments of the input stays. A triangle whose shortest edge is
///   between two such segments, on one circle around their apex, is not divided: it would not end
///   (G. L. Miller, S. E. Pav, N. J. Walkington, "When and why Ruppert's algorithm works", 2003).
///
/// One insertion is after another, in an order that depends on nothing but the input.
#ifndef flipflop_Refinement_h
#define flipflop_Refinement_h

#include "Edit/EditableMesh.h"
#include "Refine/AreaField.h"
#include "Refine/BadTriangles.h"
#include "Refine/SplitPoints.h"
#include "Refine/TriangleQuality.h"
#include "Support/Monitor.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace flipflop
{

/// When the triangles of a mesh are good.
struct RefinementLimits
{
  AngleBound angle;
  std::vector<double> mostArea; ///< by region; infinite: any. Region 0 is outside of the mesh
  std::int64_t mostPoints;      ///< new ones
  const AreaField* areas;       ///< by position; null: there are none
  int exponent;                 ///< coordinates are the caller's by 2^this
};

class Refinement
{
public:
  using Mesh = EditableMesh<false>;

  /// @param toRefine  with all segments fixed
  /// @param regionOf  by triangle
  /// @param firstId   of new points
  Refinement(Mesh& toRefine, std::vector<std::uint32_t> regionOf, const RefinementLimits& limits,
    const RoundedPositions& positions, std::uint32_t firstId, Monitor& monitor);

  /// Add a segment of the input, if it is not there. They are numbered from 0 on.
  void addSegment(std::uint32_t from, std::uint32_t to);

  void run();

  std::uint32_t region(std::uint32_t t) const { return this->regionOf[t]; }

  /// Of a new vertex, or NoIndex.
  std::uint32_t segmentOf(std::uint32_t slot) const { return this->vertices[slot].segment; }

  /// Of a new vertex in a segment: the segment's ends, and the share of the second one.
  double shareAlong(std::uint32_t slot, std::uint32_t (&ends)[2]) const;

  /// use (from, to, number) for each part of a segment.
  template <class Use>
  void eachPart(const Use& use) const
  {
    for (std::uint32_t number = 0; number < this->segments.size(); ++number)
    {
      const Segment& segment = this->segments[number];
      std::uint32_t from = segment.from;
      std::uint32_t to = segment.first;
      for (use(from, to, number); to != segment.to; use(from, to, number))
      {
        from = to;
        to = this->vertices[from].next[1];
      }
    }
  }

  /// The apex and the other ends of each angle between segments that is less than 60 degrees.
  const std::vector<std::array<std::uint32_t, 3>>& smallAngles() const { return this->small; }

  ///@{
  /// What was left as it is: segments whose middle would be too near to a vertex, and triangles
  /// whose center would.
  std::int64_t keptSegments() const { return this->segmentsLeft; }
  std::int64_t keptTriangles() const { return this->trianglesLeft; }
  bool reachedLimit() const { return this->isFull; }
  ///@}

private:
  /// Of the input.
  struct Segment
  {
    std::uint32_t from, to;
    std::uint32_t first; ///< the vertex next to the one that it is from
    double length;
    bool isSmallAt[2]; ///< the angle to another at an end
  };

  /// Of a vertex in a segment.
  struct SegmentVertex
  {
    std::uint32_t segment; ///< NoIndex: it is in none
    std::uint32_t
      next[2];          ///< the vertices next to it in the segment: towards its begin and its end
    double distance[2]; ///< from both ends, as it was meant, not rounded
  };

  /// Of a segment, in its direction.
  struct Part
  {
    std::uint32_t from, to;
    std::uint32_t number;
  };

  /// A part that may have to be divided.
  struct Candidate
  {
    std::uint32_t from, to;
    bool isForced; ///< without a vertex that encroaches upon it
  };

  const double* position(std::uint32_t slot) const { return this->mesh.vertex(slot).x; }
  bool isInside(std::uint32_t t) const { return this->regionOf[t] != 0; }
  Part part(std::uint32_t a, std::uint32_t b) const;
  bool isLeft(std::uint32_t a, std::uint32_t b) const;
  SegmentVertex vertexOf(std::uint32_t segment, std::uint32_t slot) const;
  SegmentVertex middleOf(const Part& part, double& share) const;

  void findSmallAngles();
  bool encroaches(std::uint32_t a, std::uint32_t b, std::uint32_t v) const;
  bool isEncroached(std::uint32_t h) const;
  void queueIfEncroached(std::uint32_t h);
  void examine(std::uint32_t t);
  bool isBetweenSegments(const ShapedTriangle& shape, const std::uint32_t* corner) const;
  ShapedTriangle shapeOf(std::uint32_t t) const;
  void divideAllBad();
  bool findTooLarge();

  void divideSegments();
  bool divide(const Candidate& candidate);
  std::uint32_t insertBetween(const Part& part, double share);
  void removeNear(std::uint32_t from, std::uint32_t to);
  void divideTriangle(const BadTriangle& bad);
  bool mayInsert(const std::vector<Mesh::Side>& sides, const double* x);
  bool force(std::uint32_t a, std::uint32_t b);
  Vertex newVertex(double x, double y) const;
  void afterInsertion(
    const SegmentVertex& vertex, const std::uint32_t (&ends)[2], const std::uint32_t (&regions)[2]);
  void setRegion(std::uint32_t t, std::uint32_t region);

  Mesh& mesh;
  std::vector<std::uint32_t> regionOf; ///< by triangle
  std::vector<std::uint32_t> stampOf;  ///< by triangle
  const RefinementLimits& limits;
  const RoundedPositions& positions;
  const std::uint32_t firstId;
  Monitor& monitor;
  StepPoll poll;
  const std::uint32_t firstNewSlot;
  std::vector<SegmentVertex> vertices;                    ///< by slot
  std::vector<Segment> segments;                          ///< by number
  std::unordered_map<std::uint64_t, std::uint32_t> whole; ///< numbers by edgeKey of their ends
  std::unordered_set<std::uint64_t> left;                 ///< parts too short to be divided
  std::vector<std::array<std::uint32_t, 3>> small;        ///< smallAngles()
  std::vector<Candidate> waiting;                         ///< of segments
  std::size_t next = 0;                                   ///< of these
  BadTriangles bad;
  std::vector<BadTriangle> unmeasured; ///< good ones, whose area is to be compared with the field
  std::int64_t inserted = 0;
  std::int64_t segmentsLeft = 0;
  std::int64_t trianglesLeft = 0;
  bool isFull = false;
};

}

#endif
