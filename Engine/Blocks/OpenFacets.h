// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The facets around a block's points, until no block has a point in conflict with them.
///
/// A facet is settled when all blocks that might have a point in conflict with it have been
/// queried, and it is still there. A point of the block is active while a facet around it is not
/// settled. After the first run, on all points of the block, only active points are triangulated
/// again: together with the corners of the facets around them, and with what other blocks have
/// sent. That is enough: a facet of all known points, around an active point, has its corners among
/// the corners of the facets that were there before, and the points that are new.
///
/// Rounds end. In each, the numbers of blocks that a facet queries and of points in a reply double.
/// Take a facet that points of replies make around an active point. A point in conflict with it
/// was in conflict with one of the two facets that shared an edge of it before. Both were around
/// the same point, so when replies hold all points in conflict, it has these. Hence there are at
/// most log2(n) + 2 rounds, n being the greater of the blocks and the points of a block.
///
/// A point that is settled stays so. A facet of it may still grow, by points on it that the cell of
/// another block needs; but what is around the point is no longer among what is triangulated.
#ifndef flipflop_OpenFacets_h
#define flipflop_OpenFacets_h

#include "Blocks/BlockCells.h"
#include "Blocks/BlockFrame.h"
#include "Blocks/BlockReach.h"
#include "Blocks/ReceivedSites.h"
#include <flipflop/CellComplex.h>
#include <flipflop/Options.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// A facet around an active point.
struct OpenFacet
{
  std::vector<SiteHandle> corners; ///< from the lowest handle on; of a border's edge, its two ends
  bool isSettled = false;
  std::vector<int> reach = {}; ///< blocks that might have a point in conflict
  std::size_t queried = 0;     ///< so many of these have been

  bool isBorder() const { return this->corners.size() == 2; }

  template <class Self, class Archive>
  static void visit(Self& self, Archive& archive)
  {
    archive(self.corners, self.isSettled, self.reach, self.queried);
  }
};

class OpenFacets
{
public:
  /// @param frame, options, known, cells live as long as this; settled cells that the block owns go
  ///                              to cells
  OpenFacets(
    const BlockFrame& frame, const Options& options, const ReceivedSites& known, BlockCells& cells);

  /// Read instead of begin().
  template <class Self, class Archive>
  static void visit(Self& self, Archive& archive)
  {
    std::vector<SiteHandle> active = self.activePoints();
    archive(active, self.core, self.hidden, self.facets);
    if constexpr (Archive::IsReader)
    {
      self.setActive(active);
    }
  }

  /// Take the cells of the first run, on all that is known.
  void begin(const CellComplex& complex, const BlockReach& reach);

  /// Replace the cells by those of a later run; facets that stay keep their state.
  /// @param members the points of the complex, ascending
  void replace(const CellComplex& complex, const std::vector<SiteHandle>& members);

  /// Settle facets that have no more blocks to query.
  void update(const BlockReach& reach);

  /// use (OpenFacet&) for each that is not settled.
  template <class Use>
  void eachOpen(const Use& use)
  {
    for (OpenFacet& facet : this->facets)
    {
      if (!facet.isSettled)
      {
        use(facet);
      }
    }
  }

  /// The active points, and the corners of the facets around them.
  const std::vector<SiteHandle>& members() const { return this->core; }

  /// Ids of the block's points that do not appear.
  const std::vector<std::int64_t>& hiddenIds() const { return this->hidden; }

private:
  std::vector<SiteHandle> activePoints() const;
  void setActive(const std::vector<SiteHandle>& active);
  void hideMissing(const CellComplex& complex, const std::vector<SiteHandle>& members);

  enum class CellState : std::uint8_t
  {
    Elsewhere, ///< around no point of the block
    Open,
    Settled, ///< no other block can have a point in conflict with it
    Owned    ///< likewise, and the block's
  };
  std::vector<CellState> statesOf(const CellComplex& complex,
    const std::vector<SiteHandle>& members, const BlockReach& reach) const;

  ConflictBound boundOf(const std::vector<SiteHandle>& corners) const;
  void keep(std::vector<SiteHandle> corners);
  void findActive();

  /// Is there an active point among the corners?
  bool isAround(const std::vector<SiteHandle>& corners) const
  {
    return std::any_of(
      corners.begin(), corners.end(), [this](SiteHandle handle) { return this->isActive(handle); });
  }
  bool isActive(SiteHandle handle) const
  {
    return handle < this->activity.size() && this->activity[handle] != Idle;
  }

  enum : std::uint8_t
  {
    Idle,
    Active,
    Open ///< while activity is found out: a facet is not settled
  };

  const BlockFrame& frame;
  const Options& options;
  const ReceivedSites& known;
  BlockCells& cells;
  std::vector<std::uint8_t> activity; ///< of the points that were known in the beginning
  std::vector<OpenFacet> facets;
  std::vector<SiteHandle> core;
  std::vector<std::int64_t> hidden;
};

}

#endif
