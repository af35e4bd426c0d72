// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFDistributedInput
 * @brief   the input of several processes, block by block
 *
 * The executive would iterate over a composite on each process alone, and refuse an input on one
 * process while the others wait. So here several processes accept any input, and what is wrong with
 * it is the failure of all. The blocks at the same place in the input of all processes belong
 * together. The partitions of a vtkPartitionedDataSet are the pieces of one block: processes have
 * different numbers of them.
 */

#ifndef vtkFFDistributedInput_h
#define vtkFFDistributedInput_h

#include "vtkFFInput.h"
#include "vtkFFMarks.h"

#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkFFAlgorithm;
class vtkFFProcesses;
class vtkInformation;
class vtkInformationVector;
class vtkMultiProcessController;

class vtkFFDistributedInput
{
public:
  /**
   * FillInputPortInformation() after the superclass's: port 0 of several processes accepts any
   * data, or none. Returns 1.
   */
  static int FillInputPort(vtkMultiProcessController* controller, int port, vtkInformation* info);

  /**
   * For several processes, answer REQUEST_DATA_OBJECT: each output is a vtkPolyData, or, if that is
   * wanted, a composite like a composite input. Returns 0 for any other request and for one
   * process.
   */
  static int MakeOutputs(vtkAlgorithm* filter, vtkMultiProcessController* controller,
    bool likeInput, vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector);

  /**
   * This process's part of a block. The flat index is 0 if blocks have a result each: then the run
   * names the block.
   */
  struct BlockType
  {
    std::vector<vtkFFInput::PieceType> Pieces;
    unsigned int FlatIndex = 0;
    bool HasData = false; ///< on some process
  };

  /**
   * Work on blocks for outputs, one for each port, within vtkFFProcesses::Do().
   */
  using Work =
    std::function<void(const std::vector<BlockType>&, vtkFFProcesses&, vtkInformationVector*)>;

  /**
   * RequestData() of several processes: @p check throws what is wrong with the settings; then there
   * is work for one block after another, or @p joined for all at once. Blocks without data on any
   * process are left out. Process 0 reports errors.
   */
  static int Run(vtkFFAlgorithm* filter, vtkMultiProcessController* controller, const char* title,
    bool joined, vtkInformationVector** inputVector, vtkInformationVector* outputVector,
    const std::function<void()>& check, const Work& work);
};
VTK_ABI_NAMESPACE_END

#endif
