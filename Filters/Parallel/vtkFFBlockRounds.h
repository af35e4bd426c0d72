// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFBlockRounds
 * @brief   the blocks of all processes, from their introductions to their cells
 *
 * vtkFFBlockRounds carries the messages of flipflop::BlockRun, one on each process, until no block
 * has a question left.
 */

#ifndef vtkFFBlockRounds_h
#define vtkFFBlockRounds_h

#include "vtkFFMarks.h"

#include <flipflop/BlockRun.h>

VTK_ABI_NAMESPACE_BEGIN
class vtkFFBlockExchange;

class vtkFFBlockRounds
{
public:
  struct Size
  {
    double Volume = 0.0;
    double Area = 0.0;
  };

  /**
   * The cells of this process's block, as @p result. Collective, as
   * vtkFFBlockExchange::Exchange() is.
   *
   * @param size becomes the volume and the area of a hull; null: they are not wanted
   */
  static void Run(flipflop::BlockShape shape, flipflop::BlockPoints&& points,
    const flipflop::Options& options, vtkFFBlockExchange& exchange, flipflop::BlockResult& result,
    Size* size = nullptr);
};
VTK_ABI_NAMESPACE_END

#endif
