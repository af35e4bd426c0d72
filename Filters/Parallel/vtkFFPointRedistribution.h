// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFPointRedistribution
 * @brief   moves points to the processes of their regions
 *
 * Each process gets the points of one region, about as many as each other process. The regions are
 * the leaves of a k-d tree over a sample of all points. Points at the same
 * position stay together.
 *
 * DIY's k-d trees do not do: their coordinates are floats, in which a cluster may be a single
 * position; they take a power of two of blocks; and where many points are at one position they fail
 * on regions without points.
 */

#ifndef vtkFFPointRedistribution_h
#define vtkFFPointRedistribution_h

#include "vtkFFMarks.h"

#include <flipflop/BlockRun.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkFFProcesses;

class vtkFFPointRedistribution
{
public:
  /**
   * A point of a block: x, y, and z or weight.
   */
  struct Point
  {
    double Position[3];
    std::int64_t Id;
  };

  /**
   * A point's coordinates in the k-d tree. The same for all points at one position.
   */
  using Key = std::array<double, 2>;
  using KeyOf = std::function<Key(const Point&)>;

  /**
   * The points of this process's region. Ids ascend in the input and from process to process, and
   * ascend in the result. Collective.
   */
  static flipflop::BlockPoints Run(
    std::vector<Point>&& points, const KeyOf& keyOf, vtkFFProcesses& processes);
};
VTK_ABI_NAMESPACE_END

#endif
