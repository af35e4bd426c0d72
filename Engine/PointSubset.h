// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which points of the input take part in a round.
#ifndef flipflop_PointSubset_h
#define flipflop_PointSubset_h

#include "PointSource.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace flipflop
{

struct PointSubset
{
  const std::uint32_t* ids = nullptr;   ///< ascending; null: all points
  std::uint32_t count = 0;              ///< #ids, or #points
  const std::uint32_t* taken = nullptr; ///< ascending: already vertices or decided, to be left out
  std::uint32_t takenCount = 0;
  bool checkFinite = false; ///< there are points to ignore

  /// @param left ids, ascending; they must outlive this
  void leaveOut(const std::vector<std::uint32_t>& left)
  {
    this->taken = left.data();
    this->takenCount = static_cast<std::uint32_t>(left.size());
  }

  std::uint32_t idAt(std::uint32_t i) const { return this->ids ? this->ids[i] : i; }

  /// use(id) for the points from place @p begin to @p end that are to be looked at.
  template <class Use>
  void eachWanted(
    const PointSource& source, std::uint32_t begin, std::uint32_t end, Use&& use) const
  {
    const std::uint32_t* const takenEnd = this->taken + this->takenCount;
    const std::uint32_t* next =
      begin < end ? std::lower_bound(this->taken, takenEnd, this->idAt(begin)) : takenEnd;
    for (std::uint32_t i = begin; i < end; ++i)
    {
      const std::uint32_t id = this->idAt(i);
      while (next != takenEnd && *next < id)
      {
        ++next; // not in the subset
      }
      double x[3];
      if (this->checkFinite)
      {
        source.load(id, x);
      }
      if ((next == takenEnd || *next != id) && (!this->checkFinite || isFinite(x)))
      {
        use(id);
      }
    }
  }
};

}

#endif
