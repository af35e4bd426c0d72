// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cells of the points of all processes, a block of points on each.
 *
 * A point on the border of two blocks is on both processes. All but one of those that have it mark
 * it as a duplicate, so that a sum over processes counts each point once.
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
   * The cells of this process's block: carries the messages of flipflop::BlockRun until no block
   * has a query. Collective, as is the next function.
   *
   * @param options of each run
   * @param size    becomes the volume and the area of a hull; null: they are not wanted
   */
  static flipflop::BlockResult Compute(flipflop::BlockShape shape, flipflop::BlockPoints&& points,
    const flipflop::Options& options, FFProcesses& processes, double* size = nullptr);

  /**
   * The cells of a block and those of other blocks that touch its points, so that all cells around
   * these are there. They are in canonical form. Hidden points are not copied.
   *
   * @param facets polygons or triangles: what the cells are
   * @param ghosts becomes whether each of the cells is another block's
   */
  static flipflop::BlockResult AddGhosts(flipflop::FacetMode facets,
    const flipflop::BlockResult& own, FFProcesses& processes, std::vector<bool>& ghosts);

  ///@{
  /**
   * Whether another process counts each of this process's points: its owner, if that has it, or
   * else the first process that has it. Points are the same by ids, or by positions (x, y of each),
   * whose owner is any process, the same for all. Collective.
   */
  static std::vector<bool> FindDuplicates(const flipflop::Buffer<std::int64_t>& ids,
    const flipflop::Buffer<std::int32_t>& owners, FFProcesses& processes);
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
