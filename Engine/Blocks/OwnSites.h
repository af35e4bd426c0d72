// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points of a block, as its caller gives them, made sites.
#ifndef flipflop_OwnSites_h
#define flipflop_OwnSites_h

#include "Blocks/BlockSite.h"
#include <flipflop/BlockRun.h>
#include <flipflop/Options.h>

#include <vector>

namespace flipflop
{

/// Points near each other come near each other, those of one position by id.
/// @throw Error BadArgument, NonFinite
std::vector<BlockSite> sitesAlongCurve(
  BlockShape shape, const BlockPoints& points, const Options& options);

}

#endif
