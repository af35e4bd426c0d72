// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The shares that sites have in a value between them; and those of a linear function.
#ifndef flipflop_PlaneShares_h
#define flipflop_PlaneShares_h

#include "Query/FanMesh.h"
#include "Query/SiteChain.h"
#include "Query/SiteLocator.h"

#include <cstdint>
#include <vector>

namespace flipflop
{

/// They sum to 1, but for rounding. Empty: the position is outside.
struct PlaneShare
{
  std::uint32_t site;
  double share;
};
using PlaneShares = std::vector<PlaneShare>;

/// Space: SiteSigns::Narrow or Wide.
/// @{

/// Of the corners of the triangle that holds the query.
template <class Space>
void sharesOfCorners(const Space& space, const std::uint32_t* corners, PlaneShares& shares);

/// Of a function that is linear over each triangle.
template <class Space>
void linearShares(
  const Space& space, const FanMesh& mesh, const MeshLocation& location, PlaneShares& shares);

/// The same along a chain.
template <class Space>
void linearShares(const Space& space, const ChainLocation& location, PlaneShares& shares);
/// @}

}

#endif
