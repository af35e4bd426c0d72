// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFGhostCells
 * @brief   gives blocks the cells of others that touch their points
 */

#ifndef vtkFFGhostCells_h
#define vtkFFGhostCells_h

#include "vtkFFMarks.h"

#include <flipflop/Options.h>

#include <vector>

namespace flipflop
{
struct BlockResult;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkFFBlockExchange;

class vtkFFGhostCells
{
public:
  /**
   * Give each block, beside its own cells, those of other blocks that touch a point of the block:
   * so it has all cells around its points. They are in canonical form. Collective, as
   * vtkFFBlockExchange::Exchange() is.
   *
   * @param facets polygons or triangles: what the cells are
   * @param own    the block's cells
   * @param all    becomes these and the others; hidden points are not copied
   * @param ghosts becomes whether each of the cells is another block's
   */
  static void Add(flipflop::FacetMode facets, const flipflop::BlockResult& own,
    vtkFFBlockExchange& exchange, flipflop::BlockResult& all, std::vector<bool>& ghosts);
};
VTK_ABI_NAMESPACE_END

#endif
