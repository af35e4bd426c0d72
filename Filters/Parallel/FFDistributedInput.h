// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The input of several processes, block by block.
 *
 * The executive would iterate over a composite on each process alone, and refuse an input on one
 * process while the others wait. So here several processes accept any input, and what is wrong with
 * it is the failure of all. The blocks at the same place in the input of all processes belong
 * together. The partitions of a vtkPartitionedDataSet are the pieces of one block: processes have
 * different numbers of them. A composite that is no tree of blocks, such as an AMR, is refused.
 *
 * Update() has to be called on every process, and all that is upstream has to succeed there: where
 * the executive does not come to RequestData(), the other processes wait for ever.
 */

#ifndef FFDistributedInput_h
#define FFDistributedInput_h

#include "FFBlocks.h"
#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class FFRun;
class FFProcesses;
class vtkAlgorithm;
class vtkInformationVector;
class vtkMultiProcessController;

class FFDistributedInput
{
public:
  /**
   * For a filter's constructor: the global controller becomes its own, and its input is optional.
   */
  static void Prepare(vtkAlgorithm* filter, vtkSmartPointer<vtkMultiProcessController>& controller);

  /**
   * This process's part of a block. The flat index is 0 if blocks have a result each: then the run
   * names the block.
   */
  struct BlockType
  {
    std::vector<FFBlocks::PieceType> Pieces;
    unsigned int FlatIndex = 0;
    bool HasData = false; ///< on some process
  };

  /**
   * Work on blocks for results, one for each port, within FFProcesses::Do().
   */
  using Work =
    std::function<void(const std::vector<BlockType>&, FFProcesses&, const FFBlocks::Results&)>;

  /**
   * RequestData() of several processes: @p check throws what is wrong with the settings; then there
   * is work for one block after another, or @p joined for all at once. Blocks without data on any
   * process are left out. Process 0 reports errors.
   */
  static int Run(FFRun& run, vtkMultiProcessController* controller, bool joined,
    vtkInformationVector** inputVector, vtkInformationVector* outputVector,
    const std::function<void()>& check, const Work& work);
};
VTK_ABI_NAMESPACE_END

#endif
