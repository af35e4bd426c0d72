// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which of many facets of another block have no point of a block above them?
///
/// The corners of the facets are triangulated together with the block's points. A true facet of
/// these has no point above it. So a facet whose corners share a true facet, in its order, is free,
/// and of the block's points on it those alone that the true facet has may be corners in the end.
/// The edge of a border is free if it is an edge of the border of all.
#ifndef flipflop_FreeFacets_h
#define flipflop_FreeFacets_h

#include "Blocks/BlockFrame.h"
#include "Blocks/BlockReplies.h"
#include "Blocks/BlockSite.h"
#include <flipflop/Options.h>

#include <cstdint>
#include <vector>

namespace flipflop
{

/// Removes the queries about free facets.
/// @param sites      that the block has
/// @param items      indices of sites are added: those on facets, where queries want them
/// @param exactCalls of the triangulation are added
void removeFree(const BlockFrame& frame, const Options& options,
  const std::vector<BlockSite>& sites, std::vector<ConflictQuery>& queries,
  std::vector<std::uint32_t>& items, std::int64_t& exactCalls);

}

#endif
