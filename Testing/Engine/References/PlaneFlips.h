// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A triangulation of few weighted integer points that is grown and then flipped by the
/// V-criterion alone: what gets stuck where Flip-Flop does not.
#ifndef flipflop_test_PlaneFlips_h
#define flipflop_test_PlaneFlips_h

#include "Testing/Engine/References/Exact.h"

#include <cstdint>
#include <vector>

namespace flipflop
{
namespace test
{

class PlaneFlips
{
public:
  /// Start with the triangle of the first three points. Then, round by round, each triangle takes
  /// the one of its points that is furthest below it, until there is none below any; no flips.
  /// Points on an edge are left out.
  explicit PlaneFlips(const Cloud& weighted);

  /// Flip, in random order, edges that are not locally regular, 2-2 or 3-1, as long as there are
  /// any that can be flipped.
  void flip(std::uint64_t seed);

  int irregularEdges() const; ///< that are left
  int inserted() const { return this->Inserted; }
  int flips() const { return this->Flips; }

private:
  using Triangle = std::array<int, 3>;
  using Site = std::array<std::int64_t, 3>; ///< lifted

  std::int64_t turn(int i, int j, int k) const;
  std::int64_t height(const Triangle& t, int l) const; ///< above the plane, times the area
  bool isIrregular(std::size_t t, int e) const;
  std::size_t across(std::size_t t, int e) const; ///< the triangle, or size()
  bool tryFlip(std::size_t t, int e);

  std::vector<Site> Sites;
  std::vector<Triangle> Triangles;
  int Inserted = 3;
  int Flips = 0;
};

}
}

#endif
