// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A power cell in a convex polygon: the polygon, cut by the lines of equal power to the neighbours
/// of the cell's site. A box is a polygon of four corners.
///
/// A cut starts at the corner that is farthest across the line. If signs are exact, it is sought
/// uphill from the last cut: neighbours come in their order around the site, so that corner is
/// near, and a cell takes a time proportional to the sides and the neighbours.
#ifndef flipflop_CellRing_h
#define flipflop_CellRing_h

#include "Points/Vertex.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// Lines are numbered: those that cut from 0 on, and the sides of the polygon below.
constexpr std::int64_t sideLine(std::int64_t side)
{
  return -1 - side;
}

struct RingCorner
{
  double x[2];
  std::int64_t line; ///< of the edge to the next corner
  std::uint32_t before;
  std::uint32_t after;
};

class CellRing
{
public:
  using Index = std::uint32_t;

  /// Begins with the whole polygon.
  /// @param polygon two numbers for each corner
  /// @param origin  is subtracted from each
  void begin(const std::vector<double>& polygon, double originX = 0.0, double originY = 0.0)
  {
    const auto count = static_cast<Index>(polygon.size() / 2);
    this->corners.resize(count);
    for (Index i = 0; i < count; ++i)
    {
      const double* const x = polygon.data() + 2 * std::size_t(i);
      this->corners[i] = { { x[0] - originX, x[1] - originY }, sideLine(i), i ? i - 1 : count - 1,
        i + 1 < count ? i + 1 : 0 };
    }
    this->at = 0;
    this->start = 0;
  }

  bool isEmpty() const { return this->at == NoIndex; }

  const RingCorner& operator[](Index corner) const { return this->corners[corner]; }

  /// The first corner that is left, counted from the polygon's first.
  Index first() const { return this->start; }

  /// use(index) for each corner, once around from @p from on.
  template <class Use>
  void eachFrom(Index from, const Use& use) const
  {
    Index i = from;
    do
    {
      use(i);
      i = this->corners[i].after;
    } while (i != from);
  }

  /// use(from, to) for the ends of each edge.
  template <class Use>
  void eachEdge(const Use& use) const
  {
    if (!this->isEmpty())
    {
      this->eachFrom(
        this->at, [&](Index i) { use(this->corners[i], this->corners[this->corners[i].after]); });
    }
  }

  /// Leaves what is within a line; what has no inside then is empty.
  ///
  /// @param cutter int side(before, corner): the corner, whose last one is given, is within the
  ///               line: positive, on it: zero, beyond: negative.
  ///               void meet(from, to, bool leaves, double* x): where the edge meets the line, and
  ///               leaves what is within or enters it.
  ///               static constexpr bool IsExact; if so, int rise(from, to): the edge comes nearer
  ///               to what is beyond: positive; else double beyond(corner): how far
  template <class Cutter>
  void cut(const Cutter& cutter, std::int64_t line)
  {
    const Index top = this->farthest(cutter);
    this->at = top;
    if (this->side(cutter, top) >= 0)
    {
      return;
    }
    // Both ways to the first that are not beyond.
    bool keepsStart = true;
    Index next = top;
    int sideOfNext = -1;
    while (sideOfNext < 0)
    {
      keepsStart = keepsStart && next != this->start;
      next = this->corners[next].after;
      if (next == top)
      {
        this->at = NoIndex;
        return;
      }
      sideOfNext = this->side(cutter, next);
    }
    Index last = top;
    int sideOfLast = -1;
    while (sideOfLast < 0)
    {
      keepsStart = keepsStart && last != this->start;
      last = this->corners[last].before;
      sideOfLast = this->side(cutter, last);
    }
    // A corner or an edge on the line, and nothing within.
    if (sideOfNext == 0 && sideOfLast == 0 && (next == last || this->corners[next].after == last))
    {
      this->at = NoIndex;
      return;
    }
    if (sideOfLast > 0)
    {
      last = this->add(cutter, last, true, line);
    }
    this->corners[last].line = line;
    if (sideOfNext > 0)
    {
      next = this->add(
        cutter, this->corners[next].before, false, this->corners[this->corners[next].before].line);
    }
    this->link(last, next);
    this->at = next;
    this->start = keepsStart ? this->start : next;
  }

  /// Of the edges of a corner that goes, one on a side of the polygon stays.
  void remove(Index corner)
  {
    const RingCorner& gone = this->corners[corner];
    RingCorner& last = this->corners[gone.before];
    last.line = gone.line < 0 ? gone.line : last.line;
    this->at = gone.after;
    this->start = corner == this->start ? gone.after : this->start;
    this->link(gone.before, gone.after);
  }

private:
  template <class Cutter>
  int side(const Cutter& cutter, Index corner) const
  {
    return cutter.side(this->corners[this->corners[corner].before], this->corners[corner]);
  }

  /// Rounded, a cell may have more tops than one.
  template <class Cutter>
  Index farthest(const Cutter& cutter) const
  {
    if constexpr (Cutter::IsExact)
    {
      return this->uphill(cutter);
    }
    else
    {
      Index top = this->at;
      double most = cutter.beyond(this->corners[top]);
      for (Index i = this->corners[top].after; i != this->at; i = this->corners[i].after)
      {
        const double far = cutter.beyond(this->corners[i]);
        top = far > most ? i : top;
        most = far > most ? far : most;
      }
      return top;
    }
  }

  /// A convex polygon has no other top.
  template <class Cutter>
  Index uphill(const Cutter& cutter) const
  {
    const auto rise = [&](Index from)
    { return cutter.rise(this->corners[from], this->corners[this->corners[from].after]); };
    Index corner = this->at;
    if (rise(corner) > 0)
    {
      do
      {
        corner = this->corners[corner].after;
      } while (rise(corner) > 0);
      return corner;
    }
    while (rise(this->corners[corner].before) < 0)
    {
      corner = this->corners[corner].before;
    }
    return corner;
  }

  /// The corner where the edge from @p from meets the line, linked to the end that is kept.
  template <class Cutter>
  Index add(const Cutter& cutter, Index from, bool leaves, std::int64_t line)
  {
    const Index to = this->corners[from].after;
    RingCorner corner = { { 0, 0 }, line, NoIndex, NoIndex };
    cutter.meet(this->corners[from], this->corners[to], leaves, corner.x);
    const auto index = static_cast<Index>(this->corners.size());
    this->corners.push_back(corner);
    leaves ? this->link(from, index) : this->link(index, to);
    return index;
  }

  void link(Index a, Index b)
  {
    this->corners[a].after = b;
    this->corners[b].before = a;
  }

  std::vector<RingCorner> corners;
  Index at = 0; ///< a corner of the ring, at the end of the last cut; NoIndex: the ring is empty
  Index start = 0;
};

}

#endif
