// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/Neighbors.h>

#include "Mesh/CellStructure.h"
#include "Mesh/VertexStars.h"
#include "Run/QueryRun.h"
#include "Support/EngineCall.h"

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
          const VertexStars<CellSides> stars{ CellSides(complex) };
          monitor.stage(0.3, 1.0, 1);
          LinkFaults faults;
          linkTwins(
            stars, [&] { monitor.poll(); },
            [&](std::uint32_t side, std::uint32_t twin)
            { neighbors[side] = twin == NoIndex ? -1 : std::int64_t(stars.of().cell(twin)); },
            faults);
          if (faults.crowded.count() > 0)
          {
            throw badArgument("cells must share each edge by two at most", faults.crowded.first());
          }
        });
      return neighbors;
    });
}

}
