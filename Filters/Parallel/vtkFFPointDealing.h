// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFPointDealing
 * @brief   deals distributed points out to blocks by place
 *
 * vtkFFPointDealing moves points such that each process has those of one region, and about as many
 * as each other process. The regions are the leaves of a k-d tree, which one process builds over a
 * sample of all points. Points of the same place are never parted.
 *
 * DIY's own k-d trees do not do here: their coordinates are floats, in which a cluster may be a
 * single place; they take a power of two of blocks; and where many points share a place they fail
 * on regions without points. DIY carries the points.
 */

#ifndef vtkFFPointDealing_h
#define vtkFFPointDealing_h

#include "vtkFFMarks.h"

#include <flipflop/BlockRun.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkFFBlockExchange;

class vtkFFPointDealing
{
public:
  /**
   * A point, as a block takes it.
   */
  struct Point
  {
    double Place[3];
    std::int64_t Id;
  };

  /**
   * What decides where a point goes: its two coordinates in the k-d tree. The same for all points
   * of a place.
   */
  using Key = std::array<double, 2>;
  using KeyOf = std::function<Key(const Point&)>;

  /**
   * Deal out the points of all processes. Ids ascend here and from process to process, and ascend
   * in what this process has in the end. Collective, as vtkFFBlockExchange::Exchange() is.
   */
  static void Deal(std::vector<Point>&& points, const KeyOf& keyOf, vtkFFBlockExchange& exchange,
    flipflop::BlockPoints& dealt);
};
VTK_ABI_NAMESPACE_END

#endif
