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
   * Add to each block's cells those of other blocks that touch a point of the block: so it has all
   * cells around its points. They stay in canonical form. False if there is a failure, on any
   * process. Collective.
   *
   * @param facets polygons or triangles: what the cells are
   * @param result the block's cells
   * @param ghosts becomes whether each of the cells is another block's
   */
  static bool Add(flipflop::FacetMode facets, vtkFFBlockExchange& exchange,
    flipflop::BlockResult& result, std::vector<bool>& ghosts);
};
VTK_ABI_NAMESPACE_END

#endif
