// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cells of the points of all processes, a block of points on each.
 *
 * A point on the border of two blocks is on both processes. All but one of those that have it mark
 * it as a duplicate, so that a sum over processes counts each point once. The functions are
 * collective, unless stated otherwise.
 */

#ifndef FFDistributedCells_h
#define FFDistributedCells_h

#include "vtkFFMarks.h"

#include <flipflop/BlockRun.h>

#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSetAttributes;
class FFProcesses;

class FFDistributedCells
{
public:
  /**
   * A point: x, y, and z or weight.
   */
  struct Point
  {
    double Position[3];
    std::int64_t Id;
  };

  /**
   * The cells of a block of all processes' points. Points move to the processes of their regions
   * (flipflop::PointRegions, over a sample of all points): each gets about as many, and points at
   * the same position stay together. Ids ascend here and from process to process.
   *
   * @param options of each run
   * @param size    becomes the volume and the area of a hull; null: they are not wanted
   */
  static flipflop::BlockResult Compute(flipflop::BlockShape shape, std::vector<Point>&& points,
    const flipflop::Options& options, FFProcesses& processes, double* size = nullptr);

  /**
   * Add the cells of other blocks that touch a block's points, so that all cells around these are
   * there, in canonical form. Returns whether each of the cells is another block's.
   *
   * @param facets polygons or triangles: what the cells are
   */
  static std::vector<bool> AddGhosts(
    flipflop::FacetMode facets, flipflop::BlockResult& cells, FFProcesses& processes);

  ///@{
  /**
   * Whether another process counts each of this process's points: its owner, if that has it, or
   * else the first process that has it. Points are the same by ids, or by positions (x, y of each),
   * whose owner is any process, the same for all.
   */
  static std::vector<bool> FindDuplicates(
    const flipflop::BlockResult& cells, FFProcesses& processes);
  static std::vector<bool> FindDuplicatePositions(
    const flipflop::Buffer<double>& positions, FFProcesses& processes);
  ///@}

  /**
   * Set a mark in vtkGhostType, which may be there already, where that is so, and clear it
   * elsewhere. Not collective.
   */
  static void Mark(vtkDataSetAttributes* data, const std::vector<bool>& where, int mark);
};
VTK_ABI_NAMESPACE_END

#endif
