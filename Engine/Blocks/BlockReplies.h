// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a block replies: which of its points are in conflict with the facets of others?
///
/// Each facet is searched for in a tree. Where that examines too many points for too many facets,
/// the corners of these facets are triangulated together with the block's points: a facet whose
/// corners have a cell in common there has no point above it. So the work is about that of a
/// triangulation, also if all points are of one circle.
#ifndef flipflop_BlockReplies_h
#define flipflop_BlockReplies_h

#include "Blocks/BlockFrame.h"
#include "Blocks/BlockSite.h"
#include <flipflop/Options.h>

#include <cstddef>
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
  std::uint32_t limit; ///< so many are enough; 1 or more
};

/// When facets are triangulated. Tests take less, so that small blocks do so.
struct ReplyLimits
{
  std::size_t examined = 64; ///< points, in the search for a facet
  std::size_t run = 32;      ///< as many examined points take the time of a run, for each of its
};
inline ReplyLimits& replyLimits()
{
  static ReplyLimits limits;
  return limits;
}

/// What is sent, and the exact signs that it took.
struct ConflictReply
{
  std::vector<BlockSite> sites;
  std::int64_t exactCalls = 0;
};

/// Over one geometry.
class BlockReplies
{
public:
  virtual ~BlockReplies() = default;

  /// For each query as many points above the facet as its limit, or all; if there is none, those on
  /// it that may be its corners. Each point once.
  virtual ConflictReply conflicts(const std::vector<ConflictQuery>& queries) const = 0;

  virtual const std::vector<BlockSite>& all() const = 0;

  /// @param sites   that others may request; near each other in their order are those near each
  /// other
  /// @param frame, options live as long as the replies
  static std::unique_ptr<BlockReplies> make(
    std::vector<BlockSite> sites, const BlockFrame& frame, const Options& options);
};

}

#endif
