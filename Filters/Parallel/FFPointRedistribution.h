// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Moves points to the processes of their regions.
 *
 * Each process gets the points of one region (flipflop::PointRegions, over a sample of all points),
 * about as many as each other process. Points at the same position stay together.
 */

#ifndef FFPointRedistribution_h
#define FFPointRedistribution_h

#include "vtkFFMarks.h"

#include <flipflop/BlockRun.h>
#include <flipflop/PointRegions.h>

#include <cstdint>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class FFProcesses;

class FFPointRedistribution
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

  using Key = flipflop::PointRegions::Key;
  using KeyOf = std::function<Key(const Point&)>;

  /**
   * The points of this process's region. Ids ascend in the input and from process to process, and
   * ascend in the result. Collective.
   */
  static flipflop::BlockPoints Run(
    std::vector<Point>&& points, const KeyOf& keyOf, FFProcesses& processes);
};
VTK_ABI_NAMESPACE_END

#endif
