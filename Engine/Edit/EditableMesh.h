// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A regular triangulation of the plane that points come into and go out of, one after another.
///
/// Under the ties of RaisedGeometry.h a set of points has one triangulation. So each edit only has
/// to make the triangulation right, and it is what a run from nothing would make.
///
/// - Insertion: a walk to the point; the triangles that it is above, from there on, are the cavity,
///   which a fan around the point replaces (A. Bowyer, D. F. Watson, 1981). Fixed edges bound it.
/// - Removal: the triangles around the vertex become those of its link alone: by ears (by
///   the power test), of many by a triangulation of the link.
/// - A hidden point hangs where it is found again once it may appear: at a point of its position
///   that hides it, or else in the triangle that it is beneath (the conflict lists of Flip-Flop for
///   regular triangulations; the paper's section 4). When that triangle goes, it is tried again.
///
/// Points are named by slots; slot 0 is the virtual vertex, which closes the border. Ids, by which
/// ties go, may be any.
#ifndef flipflop_EditableMesh_h
#define flipflop_EditableMesh_h

#include "Edit/JournaledArray.h"
#include "Edit/RaisedGeometry.h"
#include "Geometry/PositionGrid.h"
#include "Mesh/Mesh.h"
#include "Points/Vertex.h"
#include <flipflop/ConstrainedTriangulation.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

namespace flipflop
{

/// Of a hidden point its neighbours in the list that it is in; of any point the list of those that
/// hang at it, by increasing ids where there are no weights.
struct HangingPoints
{
  std::uint32_t next, previous;
  std::uint32_t first, last;
};

template <bool Weighted>
class EditableMesh
{
public:
  using Geometry = LiftedGeometry<Weighted>;

  /// No more slots than this.
  static constexpr std::uint32_t MostSlots = 1u << 30;

  explicit EditableMesh(const Geometry& geometry);

  /// The same triangulation, for points that may have weights.
  /// @param other without weights, committed
  EditableMesh(const Geometry& geometry, EditableMesh<false>&& other);

  ///@{
  /// Points.
  std::uint32_t slotCount() const { return static_cast<std::uint32_t>(this->vertices.size()); }
  const Vertex& vertex(std::uint32_t slot) const { return this->vertices[slot]; }
  bool isVisible(std::uint32_t slot) const { return (this->vertices[slot].flags & VertexAlive); }

  /// Add a slot, which is not in the triangulation yet.
  /// @throw Error TooManyPoints
  std::uint32_t addSlot(const Vertex& point);

  /// Of a slot that is not in the triangulation, or of all slots.
  void setPoint(std::uint32_t slot, const Vertex& point) { this->vertices.edit(slot) = point; }

  ///@{
  /// Of a point that is there without a triangulation, or no more.
  void wait(std::uint32_t slot) { this->vertices.edit(slot).flags = Waiting; }
  void forget(std::uint32_t slot) { this->vertices.edit(slot).flags = 0; }
  ///@}

  /// The signs for all points that are there, as they are scaled.
  void setGeometry(const Geometry& signs) noexcept
  {
    this->geometry = RaisedGeometry<Weighted>(signs);
  }
  ///@}

  ///@{
  /// Triangles, by index; some are dead.
  bool hasTriangles() const { return this->live > 0; }
  std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(this->triangles.size()); }
  const Triangle& triangle(std::uint32_t t) const { return this->triangles[t]; }
  bool isDead(std::uint32_t t) const { return (this->triangles[t].flags & TriangleDead) != 0; }
  bool isVirtual(std::uint32_t t) const
  {
    const std::uint32_t* const v = this->triangles[t].v;
    return v[0] == 0 || v[1] == 0 || v[2] == 0;
  }
  ///@}

  /// Begin with three points, in slots, which are not collinear.
  void start(const std::uint32_t (&corner)[3]);

  /// Begin with a triangulation of slots.
  /// @param slotOf std::uint32_t (corner of it)
  template <class SlotOf>
  void adopt(const ConstrainedTriangulation& made, const SlotOf& slotOf)
  {
    std::vector<std::uint32_t> corners;
    corners.reserve(made.connectivity.size());
    std::transform(
      made.connectivity.begin(), made.connectivity.end(), std::back_inserter(corners), slotOf);
    this->adopt(corners);
    std::vector<std::uint64_t> fixed;
    fixed.reserve(made.fixedEdges.size() / 2);
    for (std::size_t i = 0; i < made.fixedEdges.size(); i += 2)
    {
      fixed.push_back(edgeKey(slotOf(made.fixedEdges[i]), slotOf(made.fixedEdges[i + 1])));
    }
    std::sort(fixed.begin(), fixed.end());
    this->fix(fixed);
  }

  /// The triangle that holds a point, its border included; a virtual one if the point is outside.
  /// @param fewSteps after so many from where the last edit was, a grid of hints is asked
  std::uint32_t locate(const Vertex& point, std::uint32_t fewSteps = 6);

  /// Of the triangles that hold a point, borders included, the first in the order of a snapshot.
  /// @param slots receives its corners, that of the lowest id first
  /// @return      false: the point is outside
  bool firstHolding(const Vertex& point, std::uint32_t* slots);

  /// Insert the point of a slot.
  /// @return whether it is visible
  bool insert(std::uint32_t slot)
  {
    return this->insertIn(slot, this->locate(this->vertices[slot]));
  }

  /// The same of one of many that are inserted along a curve.
  bool insertNext(std::uint32_t slot)
  {
    return this->insertIn(slot, this->locate(this->vertices[slot], 64));
  }

  /// The same in the triangle that holds it, as locate() gives it.
  bool insertIn(std::uint32_t slot, std::uint32_t t);

  ///@{
  /// For Delaunay refinement, of a triangulation without weights.

  /// An edge around a cavity, which is on its left.
  struct Side
  {
    std::uint32_t from, to;
    std::uint32_t outer; ///< the opposite half-edge
    bool isFixed;
  };

  /// From a triangle towards a point, as far as no fixed edge is in the way, or at the point.
  /// @param blocked receives a half-edge that is; or NoIndex
  /// @return        the last triangle; a virtual one if the point is outside
  std::uint32_t walkWithin(const Vertex& point, std::uint32_t t, std::uint32_t& blocked);

  /// Insert a point that has no slot yet, if it is at no vertex, and the caller agrees. It is on no
  /// fixed edge.
  /// @param t      the triangle that holds it
  /// @param agrees bool (sides of the cavity)
  /// @return       its slot; 0: nothing was changed
  template <class Agrees>
  std::uint32_t insertIf(const Vertex& point, std::uint32_t t, const Agrees& agrees)
  {
    if (!this->isAbove(t, point))
    {
      return NoSlot;
    }
    this->openCavity(point, t);
    if (!agrees(this->found))
    {
      this->closeCavity();
      return NoSlot;
    }
    return this->insertInCavity(point);
  }

  /// Insert a point that has no slot yet, near a fixed edge or on it, and let the edge run through
  /// it instead.
  /// @param h of the edge
  /// @return  its slot; 0: nothing was changed, since a vertex is too near
  std::uint32_t bendFixed(const Vertex& point, std::uint32_t h);

  /// Make an edge fixed, or an ordinary one.
  void setFixed(std::uint32_t h, bool isFixed);

  /// The half-edge from one vertex to another; NoIndex: there is none.
  std::uint32_t halfEdgeTo(std::uint32_t from, std::uint32_t to) const;
  ///@}

  /// Remove the point of a slot. No edge at it is fixed.
  /// @return false if the visible points left would span no triangle: then nothing was changed
  bool remove(std::uint32_t slot);

  ///@{
  /// Of the last insertion that made a point visible: the triangles that were replaced, and those
  /// in their place, counter-clockwise around the point. Some have the same indices. Side i of the
  /// cavity is that of triangle i.
  const std::vector<std::uint32_t>& replaced() const { return this->cavity; }
  const std::vector<std::uint32_t>& fan() const { return this->fresh; }
  std::uint32_t sideOrigin(std::size_t i) const { return this->sides[i].from; }
  ///@}

  ///@{
  /// Fixed edges, of a triangulation without weights.
  bool isFixed(std::uint32_t h) const
  {
    return (this->triangles[triangleOf(h)].flags >> cornerOf(h) & EdgeFixed) != 0;
  }
  std::uint32_t twin(std::uint32_t h) const { return this->triangles[h >> 2].twin[h & 3]; }
  std::uint32_t origin(std::uint32_t h) const { return this->triangles[h >> 2].v[h & 3]; }

  /// Both ends, the lower one high.
  static std::uint64_t edgeKey(std::uint32_t a, std::uint32_t b)
  {
    return std::uint64_t(a < b ? a : b) << 32 | (a < b ? b : a);
  }

  /// Of the last insertion that made a point visible: the ends of the fixed edge that it divided.
  /// Both are 0: none.
  const std::uint32_t* dividedEdge() const { return this->divided; }

  /// use (from, to) for each fixed edge along the line from one visible point to another.
  template <class Use>
  void eachFixedEdge(std::uint32_t u, std::uint32_t v, const Use& use) const
  {
    while (u != v)
    {
      const std::uint32_t next = this->fixedTowards(u, v);
      use(u, next);
      u = next;
    }
  }

  /// The visible point at the position of one.
  std::uint32_t visibleAt(std::uint32_t slot);

  /// The same for all slots.
  std::vector<std::uint32_t> visibleOfAll() const;

  /// use (slot) for a visible point, and for each that is hidden at its position.
  template <class Use>
  void eachAt(std::uint32_t slot, const Use& use) const
  {
    use(slot);
    for (std::uint32_t other = this->nextAt(slot); other != NoSlot;
         other = this->hanging[other].next)
    {
      use(other);
    }
  }

  /// The next point that is visible where a visible one is; 0: there is none.
  std::uint32_t nextAt(std::uint32_t slot) const { return this->hangingOf(slot).first; }
  ///@}

  ///@{
  /// For EdgeInsertion.
  Mesh mesh()
  {
    Mesh result;
    result.triangles = &this->triangles.again(0);
    result.vertices = &this->vertices.again(0);
    return result;
  }
  int orient(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    return this->geometry.orient(a, b, c);
  }
  bool isAbove(const Triangle& triangle, const Vertex& p) const
  {
    const std::uint32_t* const v = triangle.v;
    return this->geometry.isAbove(
      this->vertices[v[0]], this->vertices[v[1]], this->vertices[v[2]], p);
  }
  std::uint32_t leaving(std::uint32_t v) const { return this->at[v]; }
  void setLeaving(std::uint32_t v, std::uint32_t h) { this->at.edit(v) = h; }
  void leaveThrough(std::uint32_t t)
  {
    for (int e = 0; e < 3; ++e)
    {
      this->at.edit(this->triangles[t].v[e]) = halfEdge(t, e);
    }
  }
  void willChange(std::uint32_t t) { this->triangles.edit(t); }
  void changed(const std::vector<std::uint32_t>&) {}
  ///@}

  ///@{
  /// Make the edits since the last commit final, or take them back.
  void commit() noexcept;
  void rollback() noexcept;
  ///@}

  const RaisedGeometry<Weighted>& signs() const { return this->geometry; }
  std::int64_t checkCount() const { return this->checks; }

private:
  friend class EditableMesh<true>; // which takes over the other's arrays

  static constexpr std::uint32_t HiddenInTriangle = 8; ///< VertexFlags; at[slot] is the triangle
  static constexpr std::uint32_t HiddenAtPoint = 16;   ///< in the list of that point
  static constexpr std::uint32_t Waiting = 32;
  static constexpr std::uint32_t TriangleInCavity = 0x40000000u;
  static constexpr std::uint32_t NoSlot = 0;

  /// What changes with the arrays.
  struct Counts
  {
    std::uint32_t visible, live, firstFree, last;
  };

  bool isAbove(std::uint32_t t, const Vertex& p) const
  {
    return this->isAbove(this->triangles[t], p);
  }

  /// @param corners of counter-clockwise triangles, without the virtual ones
  void adopt(const std::vector<std::uint32_t>& corners);
  /// @param edges keys, sorted
  void fix(const std::vector<std::uint64_t>& edges);

  /// The first hidden point of a triangle: before the finish, flatEdges has no other use.
  std::uint32_t firstHidden(std::uint32_t t) const { return this->triangles[t].flatEdges; }

  void setTriangle(std::uint32_t t, std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void linkTwins(std::uint32_t h, std::uint32_t other);
  std::uint32_t newTriangle();
  void freeTriangle(std::uint32_t t);
  void setVisible(std::uint32_t slot);

  /// The half-edge of a triangle through which a visibility walk leaves it; NoIndex: it is there.
  /// Between fixed edges a walk might run in a circle, if it did not turn left first at times, and
  /// right at others.
  /// @param entered the half-edge that it came through
  std::uint32_t exitTowards(const Vertex& p, std::uint32_t t, std::uint32_t entered)
  {
    const std::uint32_t* const v = this->triangles[t].v;
    this->turns = this->turns * 1664525u + 1013904223u;
    int e = static_cast<int>((this->turns >> 16) % 3);
    const bool left = (this->turns >> 30 & 1) != 0;
    for (int i = 0; i < 3; ++i)
    {
      if (halfEdge(t, e) != entered &&
        this->geometry.orient(this->vertices[v[e]], this->vertices[v[nextCorner(e)]], p) < 0)
      {
        return halfEdge(t, e);
      }
      e = left ? nextCorner(e) : previousCorner(e);
    }
    return NoIndex;
  }

  std::uint32_t walk(const Vertex& p, std::uint32_t t, std::uint32_t mostSteps);
  std::uint32_t inner(std::uint32_t t) const;
  std::uint32_t fixedTowards(std::uint32_t u, std::uint32_t v) const;
  void buildHints();

  void openCavity(const Vertex& p, std::uint32_t t);
  void addToCavity(std::uint32_t t);
  void orderSides();
  void takeHidden();
  void fillCavity(std::uint32_t slot);
  void closeCavity();
  std::uint32_t insertInCavity(const Vertex& point);
  bool isAtCavity(std::uint32_t end) const;
  bool isNoneBetween(std::uint32_t from, std::uint32_t to, const Vertex& p) const;
  bool isStarShaped(const Vertex& p) const;

  void hide(std::uint32_t slot, std::uint32_t t);
  void hangAt(std::uint32_t slot, std::uint32_t point);
  void unlinkHidden(std::uint32_t slot);
  std::uint32_t takeBestAt(std::uint32_t point);
  HangingPoints hangingOf(std::uint32_t slot) const
  {
    return slot < this->hanging.size() ? this->hanging[slot] : HangingPoints{};
  }
  HangingPoints& editHanging(std::uint32_t slot);
  void hangIn(std::uint32_t slot, std::uint32_t t);
  void settle(std::uint32_t t);

  void removeHidden(std::uint32_t slot);
  bool removeVisible(std::uint32_t slot);
  void openStar(std::uint32_t slot);
  bool isLinkOnLine() const;
  void fillByEars();
  bool isEar(std::size_t i, std::size_t j, const std::vector<std::size_t>& next) const;
  void fillAlongLine();
  void fillByTriangulation();
  std::uint32_t nextOfStar();
  void attach(std::uint32_t h, const Side& side);

  RaisedGeometry<Weighted> geometry;
  JournaledArray<Vertex> vertices;
  JournaledArray<Triangle> triangles;
  JournaledArray<std::uint32_t> at;      ///< by slot: of a visible point a half-edge that leaves it
  JournaledArray<HangingPoints> hanging; ///< by slot, as far as any was hidden
  Counts committedCounts{};
  std::uint32_t visible = 0;
  std::uint32_t live = 0;            ///< triangles
  std::uint32_t firstFree = NoIndex; ///< dead triangle; twin[0] is the next
  std::uint32_t last = 0;            ///< where the next walk starts

  PositionGrid hints;        ///< slots
  std::uint32_t hintsOf = 0; ///< as many points were visible then
  std::uint32_t turns = 1;   ///< of walks

  std::vector<std::uint32_t> sideFrom; ///< by slot: which of the sides leaves it
  std::vector<std::uint32_t> cavity;
  std::vector<Side> sides;            ///< counter-clockwise
  std::vector<Side> found;            ///< sides, in any order
  std::vector<std::uint32_t> fresh;   ///< triangles
  std::vector<std::uint32_t> waiting; ///< points that an edit has to hide or insert again
  std::uint32_t split = NoIndex;      ///< a half-edge of the fixed edge that a new point is on
  std::uint32_t divided[2] = { 0, 0 };
  std::size_t used = 0;    ///< of the cavity's triangles, by new ones
  std::int64_t checks = 0; ///< of triangles
};

}

#endif
