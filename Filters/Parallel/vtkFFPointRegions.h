// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFPointRegions
 * @brief   regions that have about as many points each: the leaves of a k-d tree over a sample
 *
 * DIY's k-d trees do not do: their coordinates are floats, in which a cluster may be a single
 * position; they take a power of two of blocks; and where many points are at one position they fail
 * on regions without points.
 */

#ifndef vtkFFPointRegions_h
#define vtkFFPointRegions_h

#include "vtkFFMarks.h"

#include <array>
#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkFFPointRegions
{
public:
  /**
   * A point's coordinates in the tree. The same for all points at one position.
   */
  using Key = std::array<double, 2>;

  /**
   * So many keys, or all, make regions that are alike to some percent.
   */
  static std::size_t GetSampleSize(int regions);

  /**
   * @param sample  may be empty
   * @param regions 1 or more
   */
  vtkFFPointRegions(std::vector<Key> sample, int regions);

  /**
   * The region of a key, from 0 on.
   */
  int Find(const Key& key) const;

private:
  /**
   * The regions from first to last, of which those from middle on have no key before the cut.
   */
  struct Node
  {
    int First, Last;
    std::size_t Axis;
    Key Cut;
    std::size_t Upper; ///< the node of the regions from the middle on; the other one is next

    int Middle() const { return this->First + (this->Last - this->First) / 2; }
  };
  void Split(Key* begin, Key* end, int first, int last);

  std::vector<Node> Nodes;
};
VTK_ABI_NAMESPACE_END

#endif
