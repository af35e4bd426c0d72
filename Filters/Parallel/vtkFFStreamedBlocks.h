// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFStreamedBlocks
 * @brief   a hull or a triangulation of more points than memory holds, on one machine
 *
 * Points come piece by piece. All pieces are read twice: first for a sample, whose k-d tree gives
 * each block its region; then each point is dealt to the block of its region. Blocks are
 * flipflop::BlockRun. They wait as bytes in files, all but a few, and send each other messages. The
 * cells of all blocks together are those of one run on all points, bit for bit.
 *
 * DIY holds the blocks, the files, and the messages: without MPI, so that a program needs none.
 */

#ifndef vtkFFStreamedBlocks_h
#define vtkFFStreamedBlocks_h

#include "vtkFFMarks.h"
#include "vtkType.h"

#include <flipflop/BlockRun.h>
#include <flipflop/Options.h>

#include <functional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkFFStreamedBlocks
{
public:
  struct SettingsType
  {
    flipflop::BlockShape Shape = flipflop::BlockShape::Delaunay;

    /**
     * Of each block's runs; so many threads work on blocks, each on one. The progress function is
     * called by these threads, one at a time, to ask for an abort.
     */
    flipflop::Options Options;

    int NumberOfBlocks = 16; ///< 1 or more
    int BlocksInMemory = 4;  ///< 1 or more: at most so many at once

    /**
     * Where files are while Run() lasts, in a folder of their own: it must exist. They take about
     * 100 bytes a point.
     */
    std::string Folder;
  };

  /**
   * The points of a piece, three numbers each, as BlockPoints has them. Ids go from 0 on, from
   * piece to piece. Pieces are read in their order, by the calling thread, and must be the same
   * each time.
   */
  using PieceOf = std::function<std::vector<double>(vtkIdType piece)>;

  /**
   * Gets the results of the blocks, one at a time, in any order.
   */
  using Use = std::function<void(int block, flipflop::BlockResult&& result)>;

  /**
   * Runs all. No file is left, whatever happens.
   *
   * @throw flipflop::Error    of a run: OutOfMemory, Aborted, ...
   * @throw std::runtime_error of a piece, which it names; or of the folder.
   */
  static void Run(
    const SettingsType& settings, vtkIdType numberOfPieces, const PieceOf& pieceOf, const Use& use);
};
VTK_ABI_NAMESPACE_END

#endif
