// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Natural neighbour coordinates (R. Sibson, 1981), and Laplace's (V. V. Belikov et al., 1997),
/// also of weighted points.
#ifndef flipflop_NaturalShares_h
#define flipflop_NaturalShares_h

#include "Query/FanMesh.h"
#include "Query/PlaneShares.h"
#include "Query/Sites.h"

#include <cstdint>
#include <memory>

namespace flipflop
{

/// What a natural neighbour's share is of.
enum class NaturalMeasure
{
  Area,      ///< what the query's cell takes from the site's (Sibson)
  SideLength ///< the side between both cells, over the distance of the site (Laplace)
};

/// For one task: it keeps its memory from query to query.
class NaturalNeighbours
{
public:
  explicit NaturalNeighbours(const FanMesh& mesh);
  ~NaturalNeighbours();

  /// @param space  of the query, whose weight is set
  /// @param start  a triangle that holds the query, which is strictly inside the hull and not at a
  ///               site
  /// @param shares is left as it is where rounding has put the query beneath the sites' surface
  /// @{
  void share(const SiteSigns::Narrow& space, std::uint32_t start, NaturalMeasure measure,
    PlaneShares& shares);
  void share(
    const SiteSigns::Wide& space, std::uint32_t start, NaturalMeasure measure, PlaneShares& shares);
  /// @}

private:
  class State;
  std::unique_ptr<State> state;
};

}

#endif
