// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What an EditableTriangulation has: a mesh, and what is known of its points.
///
/// As long as all points are on one line there are no triangles, and the points only wait. The
/// first off the line, and an edit of very many points, make the mesh again, by parts.
#ifndef flipflop_EditableState_h
#define flipflop_EditableState_h

#include "Edit/ConstrainedEdits.h"
#include "Edit/ConstraintList.h"
#include "Edit/EditableMesh.h"
#include "Edit/PointFrame.h"
#include "Points/PointSource.h"
#include "Support/Monitor.h"
#include "Support/ProgressOfParts.h"
#include <flipflop/EditableTriangulation.h>

#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace flipflop
{

class EditableState
{
public:
  EditableState() { this->commit(); }

  /// The slot of a point. Ids count from 0, slots from 1.
  static std::uint32_t slotOf(std::int64_t id) { return static_cast<std::uint32_t>(id) + 1; }

  std::int64_t idCount() const;
  std::int64_t pointCount() const { return this->known.present; }
  bool contains(std::int64_t id) const;
  /// Of a slot with a point: x, y and the weight as they were given.
  void load(std::uint32_t slot, double* x) const;

  ///@{
  /// Edits, of which nothing is final before commit().
  /// @param points as they were given; those that are not finite are left out
  void insert(const PointSource& points, Monitor& monitor, ProgressOfParts& parts);
  void remove(const std::vector<std::uint32_t>& slots, Monitor& monitor, ProgressOfParts& parts);
  void move(const std::vector<std::uint32_t>& slots, const PointSource& points, bool keepWeights,
    Monitor& monitor, ProgressOfParts& parts);
  /// @param ends slots, two a constraint
  /// @throw Error ConstraintsCross (index: the constraint, by its index here), BadArgument
  void insertConstraints(const std::vector<std::uint32_t>& ends, Monitor& monitor);
  void removeConstraints(const std::vector<std::uint32_t>& numbers, Monitor& monitor);
  void commit() noexcept;
  void rollback() noexcept;
  ///@}

  const ConstraintList& constraints() const { return this->list; }
  /// Give numbers to no constraint.
  void skipConstraints(std::int64_t count) { this->list.skip(count); }
  /// Of the last edit: how many fixed edges its points divide.
  std::int64_t dividedCount() const { return this->known.divided; }

  bool locate(const double* x, std::int64_t* corners);
  ConstrainedTriangulation snapshot(const Options& options) const;

private:
  using AnyMesh = std::variant<EditableMesh<false>, EditableMesh<true>>;

  template <class Use>
  decltype(auto) inMesh(Use&& use)
  {
    return std::visit(std::forward<Use>(use), this->now.mesh);
  }
  template <class Use>
  decltype(auto) inMesh(Use&& use) const
  {
    return std::visit(std::forward<Use>(use), this->now.mesh);
  }

  /// Of points that do not wait for a second dimension: are there triangles?
  bool hasTriangles() const;

  void setFrame(const PointFrame& next);
  void setGeometry() noexcept;
  PointFrame frameWith(const PointSource& points) const;
  void admit(const PointSource& points);
  Vertex scaled(const double* x, std::uint32_t slot) const;
  const Vertex& vertex(std::uint32_t slot) const;
  void setPoint(std::uint32_t slot, const Vertex& point);

  /// What the steps of an edit need.
  struct Edit
  {
    Monitor& monitor;
    ProgressOfParts& parts;                      ///< of calls of other parts of the engine
    std::optional<ConstrainedEdits> constrained; ///< while there are triangles and constraints
    bool isAlongCurve;                           ///< points that follow each other are near
  };
  Edit beginEdit(Monitor& monitor, ProgressOfParts& parts);
  void countDivided(const std::vector<std::uint32_t>& slots, Monitor& monitor);

  void sortSlots(std::vector<std::uint32_t>& slots, Edit& edit) const;
  void insertSlot(std::uint32_t slot, Edit& edit);
  bool removeFromTriangles(std::uint32_t slot, Edit& edit);
  void addToSpan(std::uint32_t slot);
  bool paysToRemake(std::size_t edits) const;
  void triangulate(Edit& edit);
  template <bool Weighted>
  void adopt(EditableMesh<Weighted>& fresh, const std::vector<std::uint32_t>& slots,
    const ConstrainedTriangulation& made, Edit& edit) const;

  std::vector<std::uint32_t> presentSlots() const;
  std::vector<std::uint32_t> presentConstraints() const;
  ConstrainedTriangulation triangulationOf(
    const std::vector<std::uint32_t>& slots, const Options& options) const;

  /// What there is with the mesh.
  struct Known
  {
    PointFrame frame;
    /// While points wait: they are on the line through the positions of both, which are two, and
    /// may be those of removed points. The second is 0: all are at the position of the first.
    std::uint32_t span[2] = { 0, 0 };
    std::int64_t present = 0;
    std::int64_t divided = 0;
  };

  /// What is made again as a whole.
  struct Made
  {
    AnyMesh mesh;
    EdgeCounts counts; ///< of the mesh's fixed edges
  };

  Made now = { EditableMesh<false>(LiftedGeometry<false>()), EdgeCounts() };
  std::optional<Made> before; ///< if it was made again since the last commit
  ConstraintList list;
  Known known, committed;
};

}

#endif
