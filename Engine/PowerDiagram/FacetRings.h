// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The facets around each vertex of a planar complex, counter-clockwise.
#ifndef flipflop_FacetRings_h
#define flipflop_FacetRings_h

#include "Points/Vertex.h"
#include "Support/BucketSort.h"
#include "Support/Parallel.h"
#include <flipflop/CellComplex.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

/// A half-edge is an index in the connectivity: it leaves the corner there. All indices must be in
/// range, and below NoIndex; whatever else is wrong with a complex, walk() finds.
class FacetRings
{
public:
  explicit FacetRings(const CellComplex& triangulation)
    : t(triangulation)
    , facets(t.cellSize > 0 ? 0 : t.connectivity.size())
    , ofSite(t.pointIds.size())
  {
    if (t.cellSize == 0)
    {
      eachChunk(static_cast<std::size_t>(t.cellCount()), ItemsPerTask,
        [this](std::size_t begin, std::size_t end, std::size_t)
        {
          for (std::size_t c = begin; c < end; ++c)
          {
            const auto cell = static_cast<std::int64_t>(c);
            std::fill(this->facets.begin() + t.cellBegin(cell),
              this->facets.begin() + t.cellBegin(cell + 1), static_cast<std::uint32_t>(c));
          }
        });
    }
    BucketSort<Leaving, SiteOf> sort(
      t.pointIds.size(), chunkCount(t.connectivity.size(), this->chunkSize()));
    this->eachHalfEdge([&](std::size_t run, std::uint32_t h) { sort.count(run, this->site(h)); });
    sort.endCounting(Buffer<Leaving>());
    this->eachHalfEdge(
      [&](std::size_t run, std::uint32_t h) {
        sort.put(run, { this->site(h), h });
      });
    this->leaving = sort.sort(
      [this](std::uint32_t site, const Leaving* begin, const Leaving* end, std::size_t) {
        this->ofSite[site] = { begin, end };
      });
  }

  /// The facets around one site, by the half-edges that leave it.
  struct Ring
  {
    std::vector<std::uint32_t> halfEdges; ///< in the order of their facets
    bool closed = false;                  ///< or from the border to the border

  private:
    friend class FacetRings;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> byDestination; ///< indices around the site
    std::vector<std::uint32_t> following;                               ///< of each its next
    std::vector<std::uint8_t> follows;
  };

  /// The ring of @p site: from the lowest facet on, or, at the border, from the first on.
  void walk(std::uint32_t site, Ring& ring) const
  {
    const Leaving* const leaves = this->ofSite[site].begin;
    const auto count = static_cast<std::uint32_t>(this->ofSite[site].end - leaves);
    ring.byDestination.clear();
    for (std::uint32_t i = 0; i < count; ++i)
    {
      ring.byDestination.emplace_back(this->destination(leaves[i].halfEdge), i);
    }
    std::sort(ring.byDestination.begin(), ring.byDestination.end());
    ring.following.assign(count, NoIndex);
    ring.follows.assign(count, 0);
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const std::uint32_t from = this->source(leaves[i].halfEdge);
      const auto found = std::lower_bound(
        ring.byDestination.begin(), ring.byDestination.end(), std::make_pair(from, 0u));
      if (found == ring.byDestination.end() || found->first != from)
      {
        continue;
      }
      ring.following[i] = found->second;
      if (ring.follows[found->second]++ != 0)
      {
        this->refuse(site);
      }
    }
    // At the border one facet follows no other.
    const auto border = std::find(ring.follows.begin(), ring.follows.end(), 0);
    ring.closed = border == ring.follows.end();
    const std::uint32_t begin =
      ring.closed ? 0 : static_cast<std::uint32_t>(border - ring.follows.begin());
    ring.halfEdges.clear();
    std::uint32_t i = count ? begin : NoIndex;
    while (i != NoIndex && (ring.halfEdges.empty() || i != begin))
    {
      ring.halfEdges.push_back(leaves[i].halfEdge);
      i = ring.following[i];
    }
    // None, or several rings around one site: no triangulation.
    if (ring.halfEdges.empty() || ring.halfEdges.size() != count)
    {
      this->refuse(site);
    }
  }

  std::uint32_t facet(std::uint32_t h) const
  {
    return this->t.cellSize > 0 ? h / static_cast<std::uint32_t>(this->t.cellSize)
                                : this->facets[h];
  }

  std::uint32_t destination(std::uint32_t h) const
  {
    const std::int64_t c = this->facet(h);
    const std::int64_t next = h + std::int64_t(1);
    return this->site(next == this->t.cellBegin(c + 1) ? this->t.cellBegin(c) : next);
  }

  /// Where the half-edge before @p h comes from.
  std::uint32_t source(std::uint32_t h) const
  {
    const std::int64_t c = this->facet(h);
    return this->site((h == this->t.cellBegin(c) ? this->t.cellBegin(c + 1) : h) - 1);
  }

private:
  static constexpr std::size_t ItemsPerTask = 1 << 14; ///< facets or half-edges

  struct Leaving
  {
    std::uint32_t site;
    std::uint32_t halfEdge;
  };
  struct SiteOf
  {
    std::uint32_t operator()(const Leaving& edge) const { return edge.site; }
  };
  struct Around
  {
    const Leaving* begin;
    const Leaving* end;
  };

  /// Some hundred runs at most, for the sort counts in each.
  std::size_t chunkSize() const { return std::max(ItemsPerTask, this->t.connectivity.size() >> 9); }

  /// use(number of the run, half-edge) for runs in parallel.
  template <class Use>
  void eachHalfEdge(const Use& use) const
  {
    eachChunk(this->t.connectivity.size(), this->chunkSize(),
      [&](std::size_t begin, std::size_t end, std::size_t run)
      {
        for (std::size_t h = begin; h < end; ++h)
        {
          use(run, static_cast<std::uint32_t>(h));
        }
      });
  }

  [[noreturn]] void refuse(std::uint32_t site) const
  {
    throw badArgument(
      "the triangulation must be one: facets form one ring around a site", this->t.pointIds[site]);
  }

  std::uint32_t site(std::int64_t h) const
  {
    return static_cast<std::uint32_t>(this->t.connectivity[static_cast<std::size_t>(h)]);
  }

  const CellComplex& t;
  Buffer<std::uint32_t> facets; ///< of each half-edge, where sizes differ
  Buffer<Around> ofSite;        ///< in leaving: ascending half-edges
  Buffer<Leaving> leaving;      ///< site by site
};

}

#endif
