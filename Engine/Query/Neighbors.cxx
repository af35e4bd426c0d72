// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/Neighbors.h>

#include "Points/Vertex.h"
#include "Run/QueryRun.h"
#include "Support/EngineCall.h"
#include "Surface/Sides.h"
#include "Validate/ValidateStructure.h"

#include <algorithm>
#include <limits>

namespace flipflop
{

Buffer<std::int64_t> cellNeighbors(const CellComplex& complex, const Options& options)
{
  return engineCall(
    [&]
    {
      const std::size_t entries = complex.connectivity.size();
      if (entries >= NoIndex)
      {
        throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(entries));
      }
      Buffer<std::int64_t> neighbors;
      runOver(entries, options,
        [&](Monitor& monitor)
        {
          if (!checkStructure(std::numeric_limits<std::int64_t>::max(), complex, 3, true))
          {
            throw badArgument("cells must be of dimension -1 to 3, with corners in range");
          }
          monitor.stage(0.1, 0.3, 1);
          neighbors.allocate(entries);
          Buffer<std::uint32_t> cellOf;
          Buffer<CellSide> sides = sidesOf(complex, cellOf);
          monitor.stage(0.3, 1.0, 1);
          StepPoll poll(monitor);
          std::uint32_t crowded = NoIndex;
          eachEdge(sides,
            [&](const CellSide* side, const CellSide* end)
            {
              poll.step();
              if (end - side > 2)
              {
                crowded = std::min(crowded, cellOf[side->index]);
                return;
              }
              const CellSide* const other = end - 1;
              const bool alone = other == side;
              neighbors[side->index] = alone ? -1 : std::int64_t(cellOf[other->index]);
              neighbors[other->index] = alone ? -1 : std::int64_t(cellOf[side->index]);
            });
          if (crowded != NoIndex)
          {
            throw badArgument("cells must share each edge by two at most", std::int64_t(crowded));
          }
        });
      return neighbors;
    });
}

}
