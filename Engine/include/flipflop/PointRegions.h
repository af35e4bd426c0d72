// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Regions that have about as many points each, for the blocks of a BlockRun.
#ifndef flipflop_PointRegions_h
#define flipflop_PointRegions_h

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace flipflop
{

/// The leaves of a k-d tree over a sample of the points.
class PointRegions
{
public:
  /// A point's coordinates in the tree: the same for all points at one position. Of points in the
  /// plane, the third is 0.
  using Key = std::array<double, 3>;

  /// So many keys, or all that there are, make regions that are alike to some percent.
  static constexpr std::size_t sampleSize(std::size_t regions)
  {
    return regions < 32 ? std::size_t(1) << 14 : 512 * regions;
  }

  /// @param sample  keys of some of the points, all finite; may be empty
  /// @param regions how many; 1 or more
  PointRegions(std::vector<Key> sample, int regions);

  /// The region of each key, from 0 on.
  /// @param keys    so many, all finite
  /// @param count   how many
  /// @param regions space for one a key
  void find(const Key* keys, std::size_t count, int* regions) const;

private:
  class Tree;
  std::shared_ptr<const Tree> tree;
};

}

#endif
