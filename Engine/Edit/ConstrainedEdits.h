// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Edits of a triangulation that has constraints.
///
/// A constraint runs from one end to the other along fixed edges, and each edge has the count of
/// those along it. So a point that comes onto a fixed edge divides it, and one that goes out of the
/// middle of two joins them. Where another point takes over a position, the edges there are
/// released first, and made again to the new one. A constraint that ends at a hidden point ends at
/// the visible one there.
#ifndef flipflop_ConstrainedEdits_h
#define flipflop_ConstrainedEdits_h

#include "Constraints/EdgeInsertion.h"
#include "Edit/ConstraintList.h"
#include "Edit/EditableMesh.h"
#include "Support/Monitor.h"

#include <cstdint>
#include <vector>

namespace flipflop
{

class ConstrainedEdits
{
public:
  using MeshOfPoints = EditableMesh<false>;

  /// @param counts of the mesh's fixed edges
  ConstrainedEdits(
    MeshOfPoints& mesh, const ConstraintList& constraints, EdgeCounts& counts, Monitor& monitor);

  /// Is a point visible inside a constraint? Then it divides a fixed edge.
  bool divides(std::uint32_t slot) const;

  void insertPoint(std::uint32_t slot);

  /// @return false: all is to be made again, since the other points span no triangle, or
  /// constraints
  ///         meet at the point. Then nothing was changed, but for fixed edges at the point
  bool removePoint(std::uint32_t slot);

  /// Fix the edges of a constraint.
  /// @throw Error ConstraintsCross, without index; count: the first that it crosses
  void insert(std::uint32_t number);

  /// Release those of a constraint that no other runs along.
  void release(std::uint32_t number);

  /// Count the constraints along the fixed edges of a mesh that was made with all of them.
  void countAll();

private:
  /// A fixed edge at a point.
  struct Spoke
  {
    std::uint32_t halfEdge, end, count;
  };

  /// use (half-edge) for each edge of a constraint, all fixed.
  template <class Use>
  void eachEdge(std::uint32_t number, const Use& use);

  std::vector<Spoke> spokesOf(std::uint32_t slot) const;
  void releaseSpokes(std::uint32_t slot, const std::vector<Spoke>& spokes);
  void fix(std::uint32_t from, std::uint32_t to, std::uint32_t count);
  void setCount(std::uint32_t from, std::uint32_t to, std::uint32_t count);
  std::uint32_t countOf(std::uint32_t from, std::uint32_t to) const;
  std::uint32_t halfEdgeTo(std::uint32_t from, std::uint32_t to) const;
  std::uint32_t firstAlong(const std::vector<std::uint64_t>& edges);

  MeshOfPoints& mesh;
  const ConstraintList& constraints;
  EdgeCounts& counts;
  EdgeInsertion<MeshOfPoints> insertion;
  std::vector<std::uint32_t> absent; ///< constraints that have no edges now
};

}

#endif
