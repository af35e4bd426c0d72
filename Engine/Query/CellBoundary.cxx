// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A walk along the border turns at each corner around the cells that are linked there, and so
/// surrounds what is connected by edges. It may pass a corner twice, on both sides of a pinch:
/// there it is cut in two. Cuts do not cross, so it does not matter where the walk begins.
#include <flipflop/CellBoundary.h>

#include "Mesh/CellStructure.h"
#include "Mesh/VertexStars.h"
#include "Run/QueryRun.h"
#include "Support/EngineCall.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace flipflop
{

namespace
{

class BoundaryWalk
{
public:
  BoundaryWalk(const CellComplex& cells, Monitor& monitor)
    : stars(CellSides(cells))
    , poll(monitor)
    , twin(cells.connectivity.size())
    , pathIndex(cells.pointIds.size(), NoIndex)
  {
    LinkFaults faults;
    linkTwins(
      this->stars, [&] { monitor.poll(); },
      [this](std::uint32_t side, std::uint32_t other) { this->twin[side] = other; }, faults);
    if (faults.crowded.count() + faults.turned.count() > 0)
    {
      throw badArgument("cells must share each edge by two at most, once in either direction",
        std::min(faults.crowded.first(), faults.turned.first()));
    }
  }

  void write(CellBoundary& boundary)
  {
    for (std::uint32_t k = 0; k < this->twin.size(); ++k)
    {
      if (this->twin[k] == NoIndex)
      {
        this->walk(k);
      }
    }
    std::sort(this->rings.begin(), this->rings.end(),
      [this](const Ring& a, const Ring& b)
      {
        const auto begin = this->corners.begin();
        return std::lexicographical_compare(
          begin + a.begin, begin + a.end, begin + b.begin, begin + b.end);
      });
    boundary.connectivity.allocate(this->corners.size());
    boundary.offsets.allocate(this->rings.size() + 1);
    std::size_t size = 0;
    for (std::size_t i = 0; i < this->rings.size(); ++i)
    {
      boundary.offsets[i] = static_cast<std::int64_t>(size);
      const Ring& ring = this->rings[i];
      std::copy(this->corners.begin() + ring.begin, this->corners.begin() + ring.end,
        boundary.connectivity.begin() + size);
      size += static_cast<std::size_t>(ring.end - ring.begin);
    }
    boundary.offsets[this->rings.size()] = static_cast<std::int64_t>(size);
  }

private:
  /// A range of corners.
  struct Ring
  {
    std::ptrdiff_t begin, end;
  };

  /// Along the border from side @p first, whose sides are not walked again.
  void walk(std::uint32_t first)
  {
    std::uint32_t k = first;
    do
    {
      this->poll.step();
      const std::uint32_t v = this->stars.of().origin(k);
      if (this->pathIndex[v] != NoIndex)
      {
        this->cut(this->pathIndex[v]);
      }
      this->pathIndex[v] = static_cast<std::uint32_t>(this->path.size());
      this->path.push_back(v);
      this->twin[k] = Walked;
      for (k = this->stars.of().next(k); this->twin[k] < Walked;
           k = this->stars.of().next(this->twin[k]))
      {
        this->poll.step();
      }
    } while (k != first);
    this->cut(0);
  }

  /// The path from that index on is a ring.
  void cut(std::uint32_t from)
  {
    const auto begin = this->path.begin() + from;
    for (auto v = begin; v != this->path.end(); ++v)
    {
      this->pathIndex[*v] = NoIndex;
    }
    std::rotate(begin, std::min_element(begin, this->path.end()), this->path.end());
    const auto size = static_cast<std::ptrdiff_t>(this->corners.size());
    this->corners.insert(this->corners.end(), begin, this->path.end());
    this->rings.push_back({ size, static_cast<std::ptrdiff_t>(this->corners.size()) });
    this->path.resize(from);
  }

  /// The twin of a side at the border that is done with.
  static constexpr std::uint32_t Walked = NoIndex - 1;

  const VertexStars<CellSides> stars;
  StepPoll poll;
  std::vector<std::uint32_t> twin;      ///< of each side; NoIndex: it is at the border
  std::vector<std::uint32_t> pathIndex; ///< of each corner in the path; NoIndex: it is not there
  std::vector<std::uint32_t> path;
  std::vector<std::uint32_t> corners; ///< of the rings
  std::vector<Ring> rings;
};

}

CellBoundary cellBoundary(const CellComplex& cells, const Options& options)
{
  return engineCall(
    [&]
    {
      const std::size_t entries = cells.connectivity.size();
      if (entries >= NoIndex - 1)
      {
        throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(entries));
      }
      CellBoundary boundary;
      runOver(entries, options,
        [&](Monitor& monitor)
        {
          if (!checkStructure(std::numeric_limits<std::int64_t>::max(), cells, 2, true))
          {
            throw badArgument("cells must be of dimension -1 to 2, with corners in range");
          }
          if (cells.dimension < 2)
          {
            boundary.offsets.allocate(1);
            boundary.offsets[0] = 0;
            return;
          }
          BoundaryWalk(cells, monitor).write(boundary);
        });
      return boundary;
    });
}

}
