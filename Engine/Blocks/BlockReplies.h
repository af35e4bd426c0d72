// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a block replies: which of its points are in conflict with the facets of others?
#ifndef flipflop_BlockReplies_h
#define flipflop_BlockReplies_h

#include "Blocks/BlockFrame.h"
#include "Blocks/BlockSite.h"
#include <flipflop/Options.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace flipflop
{

/// Is there a point above a facet?
struct ConflictQuery
{
  double corner[3][3]; ///< of a border's edge only two
  int isBorder;        ///< no bool: a damaged message may have any bits here
  int wantsTies;       ///< or, if there is none, on it
  std::uint32_t limit; ///< so many of the furthest are enough; 1 or more
};

/// Over one geometry.
class BlockReplies
{
public:
  virtual ~BlockReplies() = default;

  /// For each query some of the furthest points above the facet, one at least if there is any;
  /// or all points on it. Each point once.
  virtual std::vector<BlockSite> conflicts(const std::vector<ConflictQuery>& queries) const = 0;

  virtual const std::vector<BlockSite>& all() const = 0;

  /// @param sites   that others may request; near each other in their order are those near each
  /// other
  /// @param frame, options live as long as the replies
  static std::unique_ptr<BlockReplies> make(
    std::vector<BlockSite> sites, const BlockFrame& frame, const Options& options);
};

}

#endif
