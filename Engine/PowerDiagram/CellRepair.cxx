// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cells are rings of edges, and every edge inside the domain is there once in either direction.
/// Each step keeps that: to merge two corners, to cut a ring along a diagonal, to join two rings at
/// an edge. Rings that pair so have the domain for their sum, wherever their corners are; once each
/// is simple and turns left, they fill it without gap or overlap. Merging and joining take edges
/// away, and cuts are counted, so the repair ends.
#include "PowerDiagram/CellRepair.h"

#include "Points/Vertex.h"
#include "PowerDiagram/BoxScale.h"
#include "PowerDiagram/ChangedRings.h"
#include "PowerDiagram/DomainCorners.h"
#include "PowerDiagram/PlanarRings.h"
#include "PowerDiagram/TriangulationInput.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace flipflop
{
namespace
{

using Index = std::uint32_t;

/// How far merging may take a corner: units in the last place of its greater coordinate.
constexpr int MostUnits = 4;
/// The most corners that a cut takes off, the reflex corners it is looked for at, and the corners
/// up to which a joined ring is tried before it is taken.
constexpr std::size_t MostCut = 4;
constexpr std::size_t MostCuts = 8;
constexpr std::size_t MostTried = 256;

class CellRepair
{
public:
  CellRepair(RoundedCells& cells, const std::vector<double>& polygon, Monitor& monitor)
    : cells(cells)
    , plane(cells.positions)
    , box(boundingBox(polygon))
    , scale(box.data())
    , monitor(monitor)
    , rings(cells)
  {
    for (std::size_t i = 0; i < polygon.size(); i += 2)
    {
      this->fixed.insert({ { polygon[i] + 0.0, polygon[i + 1] + 0.0 } }); // -0 is 0
    }
  }

  /// @param broken the cells that are not convex
  void run(const std::vector<Index>& broken)
  {
    for (const Index cell : broken)
    {
      this->push(cell);
    }
    while (!this->queue.empty())
    {
      this->monitor.poll();
      const Index l = this->queue.front();
      this->queue.pop_front();
      this->queued.erase(l);
      this->mend(l);
    }
    this->finish();
  }

private:
  void push(Index l)
  {
    if (this->queued.insert(l).second)
    {
      this->queue.push_back(l);
    }
  }

  /// A piece that belongs to no cell until it is given away.
  bool isPiece(Index l) const { return l >= this->cells.ids.size(); }

  void mend(Index l)
  {
    this->split(l);
    Ring& ring = this->rings[l];
    if (this->isOnOneSide(ring))
    {
      ring.clear(); // what remains of it is the others' border
    }
    if (ring.empty())
    {
      return;
    }
    if (this->isPiece(l))
    {
      this->assign(l);
    }
    else if (!this->plane.isConvex(ring.data(), ring.size()) && !this->mergeShort(l) &&
      !this->plane.isSimple(ring) && !this->cut(l))
    {
      this->assign(l);
    }
  }

  // ---- One ring ------------------------------------------------------------------------------

  double area(const Ring& ring) const
  {
    double sum = 0.0;
    const double* o = this->plane.position(ring[0]);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    {
      sum += this->scale.area(o, this->plane.position(ring[i]), this->plane.position(ring[i + 1]));
    }
    return sum;
  }

  /// A ring that comes to one corner twice is several: the largest stays, the others are pieces.
  void split(Index l)
  {
    Ring& largest = this->rings[l];
    if (ChangedRings::isOnePart(largest))
    {
      return;
    }
    std::vector<Ring> all = ChangedRings::parts(largest);
    largest.clear();
    for (Ring& part : all)
    {
      if (largest.empty() || this->area(part) > this->area(largest))
      {
        largest.swap(part);
      }
      if (!part.empty())
      {
        this->push(this->rings.add(std::move(part)));
      }
    }
  }

  // ---- Merging -------------------------------------------------------------------------------

  static double gapBelow(double x)
  {
    const double size = std::fabs(x);
    return size - std::nextafter(size, 0.0);
  }

  double unit(Index v) const
  {
    const double* x = this->plane.position(v);
    return std::max(gapBelow(x[0]), gapBelow(x[1]));
  }

  double length(Index a, Index b) const
  {
    const double* p = this->plane.position(a);
    const double* q = this->plane.position(b);
    return std::max(std::fabs(p[0] - q[0]), std::fabs(p[1] - q[1]));
  }

  /// The sides of the bounding box that a corner lies on, a bit each.
  int sides(Index v) const
  {
    int result = 0;
    for (int k = 0; k < 4; ++k)
    {
      result |= (this->plane.position(v)[k / 2] == this->box[k] ? 1 : 0) << k;
    }
    return result;
  }

  bool isOnOneSide(const Ring& ring) const
  {
    int common = 15;
    for (const Index v : ring)
    {
      common &= this->sides(v);
    }
    return common != 0;
  }

  /// The bounds of all that was merged into a corner.
  using Bounds = std::array<double, 4>;
  Bounds boundsOf(Index v) const
  {
    const auto found = this->merged.find(v);
    const double* x = this->plane.position(v);
    return found == this->merged.end() ? Bounds{ { x[0], x[0], x[1], x[1] } } : found->second;
  }

  bool isFixed(Index v) const
  {
    const double* const x = this->plane.position(v);
    return this->fixed.count({ { x[0], x[1] } }) != 0;
  }

  /// May @p from be moved to @p to, with all that was merged into it? On a side it stays there.
  bool mayMove(Index from, Index to) const
  {
    if (this->isFixed(from))
    {
      return false;
    }
    const double limit = MostUnits * std::max(this->unit(from), this->unit(to));
    const int sides = this->sides(from);
    if (this->length(from, to) > limit || (sides & this->sides(to)) != sides)
    {
      return false;
    }
    const Bounds bounds = this->boundsOf(from);
    const double* x = this->plane.position(to);
    return bounds[1] - x[0] <= limit && x[0] - bounds[0] <= limit && bounds[3] - x[1] <= limit &&
      x[1] - bounds[2] <= limit;
  }

  struct Merge
  {
    double length;
    Index from, to;
  };

  /// Merge the ends of the ring's short edges at reflex corners, the shortest first. Returns
  /// whether there were any.
  bool mergeShort(Index l)
  {
    const Ring& ring = this->rings[l];
    const std::size_t count = ring.size();
    std::vector<char> reflex(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      reflex[i] =
        this->plane.isReflex(ring[(i + count - 1) % count], ring[i], ring[(i + 1) % count]);
    }
    std::vector<Merge> merges;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (!reflex[i] && !reflex[(i + 1) % count])
      {
        continue;
      }
      const Index a = ring[i];
      const Index b = ring[(i + 1) % count];
      const bool forward = this->mayMove(a, b);
      const bool backward = this->mayMove(b, a);
      if (forward && (!backward || this->isLesser(a, b)))
      {
        merges.push_back({ this->length(a, b), a, b });
      }
      else if (backward)
      {
        merges.push_back({ this->length(a, b), b, a });
      }
    }
    std::sort(merges.begin(), merges.end(),
      [this](const Merge& a, const Merge& b)
      {
        return a.length != b.length ? a.length < b.length
          : a.from != b.from        ? this->plane.before(a.from, b.from)
                                    : this->plane.before(a.to, b.to);
      });
    std::unordered_set<Index> touched;
    for (const Merge& m : merges)
    {
      if (touched.count(m.from) == 0 && touched.count(m.to) == 0)
      {
        touched.insert(m.from);
        touched.insert(m.to);
        this->merge(m.from, m.to);
      }
    }
    return !merges.empty();
  }

  /// Rather the corner of fewer cells moves.
  bool isLesser(Index a, Index b)
  {
    const std::size_t cellsOfA = this->rings.countAt(a);
    const std::size_t cellsOfB = this->rings.countAt(b);
    return cellsOfA != cellsOfB ? cellsOfA < cellsOfB : this->plane.before(b, a);
  }

  void merge(Index from, Index to)
  {
    Bounds bounds = this->boundsOf(from);
    const Bounds other = this->boundsOf(to);
    for (std::size_t k = 0; k < 4; k += 2)
    {
      bounds[k] = std::min(bounds[k], other[k]);
      bounds[k + 1] = std::max(bounds[k + 1], other[k + 1]);
    }
    this->merged[to] = bounds;
    this->movedTo[from] = to;
    this->rings.merge(from, to, [this](Index l) { this->push(l); });
  }

  // ---- Cutting and joining -------------------------------------------------------------------

  /// What becomes of a neighbour that takes a ring.
  struct Receiver
  {
    Index ring = NoIndex;
    int fit = -1; ///< 2: as simple as before; 1: a cell; 0: a piece
    double length = 0.0;
    Ring joined;

    bool isBetterThan(const Receiver& other) const
    {
      return this->fit != other.fit ? this->fit > other.fit : this->length > other.length;
    }
  };

  /// The best neighbour of @p ring but for @p self; then along the longest edge.
  Receiver receiverOf(const Ring& ring, Index self)
  {
    const std::size_t count = ring.size();
    Receiver best;
    for (std::size_t i = 0; i < count; ++i)
    {
      const Index a = ring[i];
      const Index b = ring[(i + 1) % count];
      Receiver receiver;
      receiver.ring = this->rings.across(a, b);
      if (receiver.ring == NoIndex || receiver.ring == self)
      {
        continue;
      }
      receiver.joined = this->rings.joined(receiver.ring, ring, i);
      receiver.length = this->length(a, b);
      receiver.fit = this->isPiece(receiver.ring)                      ? 0
        : this->isNoWorse(receiver.joined, this->rings[receiver.ring]) ? 2
                                                                       : 1;
      if (receiver.isBetterThan(best))
      {
        best = std::move(receiver);
      }
    }
    return best;
  }

  bool isNoWorse(const Ring& joined, const Ring& before) const
  {
    const std::vector<Ring> all = ChangedRings::parts(joined);
    return all.size() == 1 &&
      (joined.size() > MostTried ||
        (this->plane.isCounterClockwise(all[0]) &&
          this->plane.crossings(all[0]) <= this->plane.crossings(before)));
  }

  void join(Receiver& receiver)
  {
    this->rings.set(receiver.ring, std::move(receiver.joined));
    this->push(receiver.ring);
  }

  /// Cut off what makes a ring cross itself, the tip of a needle: a few corners in a row, for the
  /// best neighbour to take; as few as do, with the least area. Returns whether it could be done.
  bool cut(Index l)
  {
    Ring& ring = this->rings[l];
    const std::size_t count = ring.size();
    const std::size_t crossings = this->plane.crossings(ring);
    std::size_t& remaining = this->cutsRemaining.emplace(l, count).first->second;
    if (remaining == 0)
    {
      return false;
    }
    Receiver best;
    Ring bestRest;
    Ring bestPiece;
    for (std::size_t k = 1; k <= MostCut && k + 3 <= count; ++k)
    {
      for (const std::size_t i : this->cutIndices(ring, k))
      {
        Ring rest = ring;
        std::rotate(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(i), rest.end());
        const Ring piece(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(k + 2));
        rest.erase(rest.begin() + 1, rest.begin() + static_cast<std::ptrdiff_t>(k + 1));
        if (this->assigned.count(ChangedRings::sorted(piece)) != 0 ||
          this->plane.crossings(rest) >= crossings || !this->plane.isCounterClockwise(rest))
        {
          continue;
        }
        Receiver receiver = this->receiverOf(piece, l);
        if (receiver.fit > best.fit ||
          (receiver.fit == best.fit && piece.size() == bestPiece.size() &&
            std::fabs(this->area(piece)) < std::fabs(this->area(bestPiece))))
        {
          best = std::move(receiver);
          bestRest = std::move(rest);
          bestPiece = piece;
        }
      }
    }
    if (best.ring == NoIndex)
    {
      return false;
    }
    --remaining;
    this->assigned.insert(ChangedRings::sorted(bestPiece));
    ring.swap(bestRest);
    this->push(l);
    this->join(best);
    return true;
  }

  /// Where a piece of @p k corners that has a reflex corner in it or next to it may begin: the
  /// position before it.
  std::vector<std::size_t> cutIndices(const Ring& ring, std::size_t k) const
  {
    const std::size_t count = ring.size();
    std::vector<std::size_t> indices;
    std::size_t found = 0;
    for (std::size_t i = 0; i < count && found < MostCuts; ++i)
    {
      if (this->plane.isReflex(ring[(i + count - 1) % count], ring[i], ring[(i + 1) % count]))
      {
        ++found;
        for (std::size_t j = 0; j < k + 2; ++j)
        {
          indices.push_back((i + 2 * count - k - 1 + j) % count);
        }
      }
    }
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    return indices;
  }

  void assign(Index l)
  {
    const Ring ring = this->rings[l];
    Receiver receiver = this->receiverOf(ring, l);
    if (receiver.ring != NoIndex)
    {
      this->join(receiver);
    }
    this->rings[l].clear();
  }

  // ---- The end -------------------------------------------------------------------------------

  /// A changed cell begins at the first of its old corners that it still has.
  Ring fromItsStart(Index cell, const Ring& ring) const
  {
    for (std::int64_t i = this->cells.ends[cell]; i < this->cells.ends[cell + std::size_t(1)]; ++i)
    {
      Index v = this->cells.corners[static_cast<std::size_t>(i)];
      for (auto moved = this->movedTo.find(v); moved != this->movedTo.end();
           moved = this->movedTo.find(v))
      {
        v = moved->second;
      }
      const auto found = std::find(ring.begin(), ring.end(), v);
      if (found != ring.end())
      {
        Ring result(found, ring.end());
        result.insert(result.end(), ring.begin(), found);
        return result;
      }
    }
    return ring;
  }

  void finish()
  {
    RoundedCells result;
    result.ends.push_back(0);
    for (std::size_t c = 0; c < this->cells.ids.size(); ++c)
    {
      const Ring* changed = this->rings.find(static_cast<Index>(c));
      if (changed && changed->empty())
      {
        continue;
      }
      if (changed)
      {
        const Ring ring = this->fromItsStart(static_cast<Index>(c), *changed);
        result.corners.insert(result.corners.end(), ring.begin(), ring.end());
      }
      else
      {
        result.corners.insert(result.corners.end(),
          this->cells.corners.begin() + this->cells.ends[c],
          this->cells.corners.begin() + this->cells.ends[c + 1]);
      }
      result.ends.push_back(static_cast<std::int64_t>(result.corners.size()));
      result.ids.push_back(this->cells.ids[c]);
    }
    std::vector<Index> numbers(this->cells.positions.size() / 2, NoIndex);
    for (Index& v : result.corners)
    {
      Index& number = numbers[v];
      if (number == NoIndex)
      {
        number = static_cast<Index>(result.positions.size() / 2);
        const double* x = this->plane.position(v);
        result.positions.insert(result.positions.end(), x, x + 2);
      }
      v = number;
    }
    this->cells = std::move(result);
  }

  RoundedCells& cells;
  const PlanarRings plane;
  const std::array<double, 4> box;
  const BoxScale scale;
  Monitor& monitor;
  ChangedRings rings; ///< the cells, then pieces
  std::deque<Index> queue;
  std::unordered_set<Index> queued;
  std::unordered_map<Index, Bounds> merged;
  std::unordered_map<Index, Index> movedTo;
  std::unordered_map<Index, std::size_t> cutsRemaining;
  std::set<std::array<double, 2>> fixed; ///< the polygon's corners
  std::set<Ring> assigned;               ///< sorted pieces, lest one go round and round
};

/// Those that are not convex.
/// @throw Error BadArgument for one that turns over by more than rounding explains
std::vector<Index> brokenCells(
  const RoundedCells& cells, const std::vector<double>& polygon, Monitor& monitor)
{
  const PlanarRings plane(cells.positions);
  const BoxScale scale(boundingBox(polygon).data());
  constexpr std::size_t CellsPerTask = 1 << 12;
  std::vector<std::vector<Index>> found(chunkCount(cells.ids.size(), CellsPerTask));
  eachCheckedChunk(cells.ids.size(), CellsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t run)
    {
      monitor.poll();
      for (std::size_t c = begin; c < end; ++c)
      {
        const Index* ring = cells.corners.data() + cells.ends[c];
        const std::size_t count = static_cast<std::size_t>(cells.ends[c + 1] - cells.ends[c]);
        if (plane.isConvex(ring, count))
        {
          continue;
        }
        for (std::size_t i = 0; i < count; ++i)
        {
          if (scale.turnsTooFar(plane.position(ring[i]), plane.position(ring[(i + 1) % count]),
                plane.position(ring[(i + 2) % count])))
          {
            throw badArgument(NotATriangulation, cells.ids[c]);
          }
        }
        found[run].push_back(static_cast<Index>(c));
      }
    });
  std::vector<Index> broken;
  for (const std::vector<Index>& list : found)
  {
    broken.insert(broken.end(), list.begin(), list.end());
  }
  return broken;
}

}

bool areConvex(const RoundedCells& cells, const std::vector<double>& polygon, Monitor& monitor)
{
  return brokenCells(cells, polygon, monitor).empty();
}

void repairCells(RoundedCells& cells, const std::vector<double>& polygon, Monitor& monitor)
{
  const std::vector<Index> broken = brokenCells(cells, polygon, monitor);
  if (!broken.empty())
  {
    CellRepair(cells, polygon, monitor).run(broken);
  }
}

}
