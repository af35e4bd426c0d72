// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The cells of a diagram as rings of corners, of which few change: those are lists of their own,
/// all others stay where they are. Which rings there are at a corner is known the same way.
#ifndef flipflop_ChangedRings_h
#define flipflop_ChangedRings_h

#include "Points/Vertex.h"
#include "PowerDiagram/CellRepair.h"
#include "PowerDiagram/PlanarRings.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace flipflop
{

/// Lists of which few change.
class ChangedLists
{
public:
  using Index = std::uint32_t;

  /// @param ends, items list i is items[ends[i]] to items[ends[i + 1]]; they must live on
  ChangedLists(const std::vector<std::int64_t>& ends, const std::vector<Index>& items)
    : ends(ends)
    , items(items)
    , next(static_cast<Index>(ends.size() - 1))
  {
  }

  /// The reference stays good.
  Ring& operator[](Index i)
  {
    const auto found = this->changed.find(i);
    if (found != this->changed.end())
    {
      return found->second;
    }
    Ring& list = this->changed[i];
    list.assign(
      this->items.begin() + this->ends[i], this->items.begin() + this->ends[i + std::size_t(1)]);
    return list;
  }

  /// Null where it was never requested.
  const Ring* find(Index i) const
  {
    const auto found = this->changed.find(i);
    return found == this->changed.end() ? nullptr : &found->second;
  }

  /// The index of a new list.
  Index add(Ring list)
  {
    this->changed[this->next] = std::move(list);
    return this->next++;
  }

private:
  const std::vector<std::int64_t>& ends;
  const std::vector<Index>& items;
  Index next;
  std::unordered_map<Index, Ring> changed;
};

class ChangedRings
{
public:
  using Index = std::uint32_t;

  /// @param cells must live on
  explicit ChangedRings(const RoundedCells& cells)
    : rings(cells.ends, cells.corners)
    , cellEnds(cells.positions.size() / 2 + 1)
    , cellsAround(cells.corners.size())
    , around(cellEnds, cellsAround)
  {
    for (const Index v : cells.corners)
    {
      ++this->cellEnds[v];
    }
    std::int64_t end = 0;
    for (std::int64_t& at : this->cellEnds)
    {
      end += at;
      at = end;
    }
    for (std::size_t c = cells.ids.size(); c-- > 0;)
    {
      for (std::int64_t i = cells.ends[c]; i < cells.ends[c + 1]; ++i)
      {
        this->cellsAround[--this->cellEnds[cells.corners[i]]] = static_cast<Index>(c);
      }
    }
  }
  ChangedRings(const ChangedRings&) = delete;
  ChangedRings& operator=(const ChangedRings&) = delete;

  /// Corners may be taken out of it; for others there is set().
  Ring& operator[](Index l) { return this->rings[l]; }

  const Ring* find(Index l) const { return this->rings.find(l); }

  void set(Index l, Ring ring)
  {
    for (const Index v : ring)
    {
      this->comeTo(v, l);
    }
    this->rings[l] = std::move(ring);
  }

  /// The index of a new ring.
  Index add(Ring ring)
  {
    const Index l = this->rings.add(Ring());
    this->set(l, std::move(ring));
    return l;
  }

  /// How many rings have the corner, or had it.
  std::size_t countAt(Index v) { return this->around[v].size(); }

  /// Put corner @p to in the place of @p from; @p use (ring) for each that had it.
  template <class Use>
  void merge(Index from, Index to, const Use& use)
  {
    Ring moved;
    moved.swap(this->around[from]);
    for (const Index l : moved)
    {
      Ring& ring = this->rings[l];
      if (std::find(ring.begin(), ring.end(), from) == ring.end())
      {
        continue;
      }
      std::replace(ring.begin(), ring.end(), from, to);
      ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
      while (ring.size() > 1 && ring.front() == ring.back())
      {
        ring.pop_back();
      }
      this->comeTo(to, l);
      use(l);
    }
  }

  /// The ring on the other side of the edge from @p a to @p b, or NoIndex.
  Index across(Index a, Index b)
  {
    for (const Index l : this->around[a])
    {
      const Ring& ring = this->rings[l];
      if (indexOf(ring, b, a) < ring.size())
      {
        return l;
      }
    }
    return NoIndex;
  }

  /// Ring @p l, and @p other on the other side of edge @p i of @p other: one ring.
  Ring joined(Index l, const Ring& other, std::size_t i)
  {
    const std::size_t count = other.size();
    const Ring& ring = this->rings[l];
    const auto split = ring.begin() + 1 +
      static_cast<std::ptrdiff_t>(indexOf(ring, other[(i + 1) % count], other[i]));
    Ring result(ring.begin(), split);
    for (std::size_t j = 2; j < count; ++j)
    {
      result.push_back(other[(i + j) % count]);
    }
    result.insert(result.end(), split, ring.end());
    return result;
  }

  static Ring sorted(Ring ring)
  {
    std::sort(ring.begin(), ring.end());
    return ring;
  }

  /// Three corners at least, and all different?
  static bool isOnePart(const Ring& ring)
  {
    if (ring.size() > 32)
    {
      const Ring corners = sorted(ring);
      return std::adjacent_find(corners.begin(), corners.end()) == corners.end();
    }
    bool twice = false;
    for (auto v = ring.begin(); v != ring.end() && !twice; ++v)
    {
      twice = std::find(ring.begin(), v, *v) != v;
    }
    return ring.size() > 2 && !twice;
  }

  /// A ring as rings of different corners each. Edges that come and go cancel out.
  static std::vector<Ring> parts(const Ring& ring)
  {
    std::vector<Ring> result;
    Ring way;
    std::unordered_map<Index, std::size_t> indices; // on the way
    for (const Index v : ring)
    {
      const auto known = indices.find(v);
      if (known != indices.end())
      {
        const std::size_t index = known->second;
        if (way.size() - index > 2)
        {
          result.emplace_back(way.begin() + static_cast<std::ptrdiff_t>(index), way.end());
        }
        while (way.size() > index)
        {
          indices.erase(way.back());
          way.pop_back();
        }
      }
      indices[v] = way.size();
      way.push_back(v);
    }
    if (way.size() > 2)
    {
      result.push_back(std::move(way));
    }
    return result;
  }

private:
  void comeTo(Index v, Index l)
  {
    Ring& list = this->around[v];
    if (std::find(list.begin(), list.end(), l) == list.end())
    {
      list.push_back(l);
    }
  }

  /// Where the edge from @p a to @p b begins in a ring, or the ring's size.
  static std::size_t indexOf(const Ring& ring, Index a, Index b)
  {
    const auto found = std::find(ring.begin(), ring.end(), a);
    const std::size_t index = static_cast<std::size_t>(found - ring.begin());
    return index < ring.size() && ring[(index + 1) % ring.size()] == b ? index : ring.size();
  }

  ChangedLists rings; ///< the cells, then others
  std::vector<std::int64_t> cellEnds;
  std::vector<Index> cellsAround;
  ChangedLists around;
};

}

#endif
