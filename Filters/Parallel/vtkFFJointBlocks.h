// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFJointBlocks
 * @brief   the way of a filter of several processes through its input
 *
 * The executive would take a composite apart on each process alone, though they work together on
 * each data set, and it would refuse an input on one process while the others wait. So here any
 * input is taken, and what is wrong with it is the failure of all processes. The blocks in the same
 * place on all processes belong together. The partitions of a vtkPartitionedDataSet are the pieces
 * of one block.
 */

#ifndef vtkFFJointBlocks_h
#define vtkFFJointBlocks_h

#include "vtkFFInput.h"
#include "vtkFFMarks.h"

#include <functional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkFFAlgorithm;
class vtkFFRun;
class vtkInformation;
class vtkInformationVector;
class vtkMultiProcessController;

class vtkFFJointBlocks
{
public:
  static bool AreSeveral(vtkMultiProcessController* controller);

  //@{
  /**
   * Where there are several processes: the ports take and give anything, and the outputs are a
   * vtkPolyData each, or composites like the input. Otherwise 0, and that is the superclass's.
   */
  static int FillInputPort(vtkMultiProcessController* controller, int port, vtkInformation* info);
  static int FillOutputPort(vtkMultiProcessController* controller, vtkInformation* info);
  static int MakeOutputs(vtkAlgorithm* filter, vtkMultiProcessController* controller,
    bool likeInput, vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector);
  //@}

  /**
   * What this process has of a block. The flat index is 0 if the block is worked on alone: the run
   * names it then.
   */
  struct BlockType
  {
    std::vector<vtkFFInput::PieceType> Pieces;
    unsigned int FlatIndex = 0;
  };

  /**
   * Works on blocks for outputs, one for each port. The run has its failure, which is that of all
   * processes in the end. A vtkFFSharedFailure ends it.
   */
  using Work = std::function<void(const std::vector<BlockType>&, vtkFFRun&, vtkInformationVector*)>;

  /**
   * RequestData(): @p check throws what is wrong with the settings; then there is work for one
   * block after another, or @p joined for all at once. Blocks without data on any process are left
   * out. Process 0 reports errors. Collective.
   */
  static int Run(vtkFFAlgorithm* filter, vtkMultiProcessController* controller, const char* title,
    bool joined, vtkInformationVector** inputVector, vtkInformationVector* outputVector,
    const std::function<void()>& check, const Work& work);

  /**
   * Work on a block where the processes cannot do it together, for that reason: process 0 gathers
   * all points, with a warning if others have some, and @p runAlone has them for its input.
   */
  static void RunGathered(vtkFFAlgorithm* filter, vtkMultiProcessController* controller,
    const BlockType& block, const std::string& reason, vtkFFRun& run,
    const std::function<void(vtkInformationVector**)>& runAlone);
};
VTK_ABI_NAMESPACE_END

#endif
