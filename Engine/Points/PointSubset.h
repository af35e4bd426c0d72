// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which points of the input take part in a round.
#ifndef flipflop_PointSubset_h
#define flipflop_PointSubset_h

#include "Points/PointSource.h"
#include "Support/Monitor.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

struct PointSubset
{
  const std::uint32_t* ids = nullptr;      ///< ascending; null: all points
  std::uint32_t count = 0;                 ///< #ids, or #points
  const std::uint32_t* excluded = nullptr; ///< ascending: already vertices, or decided
  std::uint32_t excludedCount = 0;
  bool checkFinite = false; ///< there are points to ignore

  /// @param sorted ids, ascending; they must outlive this
  void exclude(const std::vector<std::uint32_t>& sorted)
  {
    this->excluded = sorted.data();
    this->excludedCount = static_cast<std::uint32_t>(sorted.size());
  }

  std::uint32_t idAt(std::uint32_t i) const { return this->ids ? this->ids[i] : i; }

  /// use(id) for the points from index @p begin to @p end that are to be examined.
  template <class Use>
  void eachWanted(
    const PointSource& source, std::uint32_t begin, std::uint32_t end, Use&& use) const
  {
    eachRemaining(
      begin, end, [this](std::uint32_t i) { return this->idAt(i); }, this->excluded,
      this->excluded + this->excludedCount, this->checkFinite ? &source : nullptr, use);
  }

  /// use(idAt(i)) for i from @p begin to @p end, but for ids that are excluded.
  /// @param idAt      ascending
  /// @param excludedIds  ascending
  /// @param finiteOf  leave points out that are not finite, too; null: there are none
  template <class IdAt, class Id, class Use>
  static void eachRemaining(std::uint32_t begin, std::uint32_t end, const IdAt& idAt,
    const Id* excludedIds, const Id* excludedEnd, const PointSource* finiteOf, Use&& use)
  {
    const Id* next = begin < end
      ? std::lower_bound(excludedIds, excludedEnd, static_cast<Id>(idAt(begin)))
      : excludedEnd;
    for (std::uint32_t i = begin; i < end; ++i)
    {
      const std::uint32_t id = idAt(i);
      while (next != excludedEnd && *next < id)
      {
        ++next; // not in the subset
      }
      double x[3];
      if (finiteOf)
      {
        finiteOf->load(id, x);
      }
      if ((next == excludedEnd || *next != id) && (!finiteOf || isFinite(x)))
      {
        use(id);
      }
    }
  }
};

/// The ids of a subset's wanted points, ascending, by several threads.
/// @param allocate void (count): there are so many
/// @param write    void (index, id)
/// @throw Error Aborted
template <class Allocate, class Write>
void compactWanted(const PointSource& source, const PointSubset& subset, Monitor& monitor,
  const Allocate& allocate, const Write& write)
{
  constexpr std::size_t PointsPerTask = 1 << 15;
  parallelCompact(
    subset.count, PointsPerTask,
    [&](std::size_t begin, std::size_t end, const auto& emit)
    {
      monitor.poll();
      subset.eachWanted(
        source, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), emit);
    },
    allocate, write);
}

/// use(vertex) for every point, or every finite one.
template <class Use>
void eachFinite(const PointSource& source, bool checkFinite, Monitor& monitor, Use&& use)
{
  for (std::uint32_t id = 0; id < source.count(); ++id)
  {
    if ((id & 0xFFFF) == 0)
    {
      monitor.poll();
    }
    const Vertex v = source.vertex(id);
    if (!checkFinite || isFinite(v.x))
    {
      use(v);
    }
  }
}

}

#endif
