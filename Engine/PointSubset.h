// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which points of the input take part in a round.
#ifndef flipflop_PointSubset_h
#define flipflop_PointSubset_h

#include "PointSource.h"

#include <algorithm>
#include <cstdint>

namespace flipflop
{

struct PointSubset
{
  const std::uint32_t* ids = nullptr;   ///< ascending; null: all points
  std::uint32_t count = 0;              ///< #ids, or #points
  const std::uint32_t* taken = nullptr; ///< ascending: already vertices or decided, to be left out
  std::uint32_t takenCount = 0;
  bool checkFinite = false; ///< there are points to ignore

  std::uint32_t idAt(std::uint32_t i) const { return this->ids ? this->ids[i] : i; }

  /// Is a point of the subset to be looked at?
  bool isWanted(const PointSource& source, std::uint32_t id) const
  {
    if (this->checkFinite)
    {
      double x[3];
      source.load(id, x);
      if (!isFinite(x))
      {
        return false;
      }
    }
    return !std::binary_search(this->taken, this->taken + this->takenCount, id);
  }
};

}

#endif
