// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFProcesses
 * @brief   what the processes of a distributed filter tell each other
 *
 * vtkFFProcesses is a vtkMultiProcessController in the terms of the Flip-Flop filters. Unless they
 * say otherwise, its methods are collective: every process calls them, in the same order, whatever
 * went wrong on it. What goes wrong on one process is known to all after the next Share(), so that
 * they stop together and none waits for another.
 */

#ifndef vtkFFProcesses_h
#define vtkFFProcesses_h

#include "vtkFFBlock.h"

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;
class vtkPointSet;
class vtkPolyData;
struct vtkFFFailure;

class vtkFFProcesses
{
public:
  /**
   * Without a controller there is one process.
   */
  explicit vtkFFProcesses(vtkMultiProcessController* controller);

  //@{
  /**
   * How many processes there are, and which this is. Not collective.
   */
  int GetCount() const { return this->Count; }
  int GetRank() const { return this->Rank; }
  //@}

  /**
   * Every process's values, one process after another. All give equally many.
   */
  std::vector<vtkIdType> Gather(const std::vector<vtkIdType>& values);

  /**
   * Every process's values, of which each may give another number.
   */
  std::vector<std::vector<vtkIdType>> GatherLists(const std::vector<vtkIdType>& values);

  /**
   * The failures of all processes together, the same for each. False if there is any.
   */
  bool Share(vtkFFFailure& failure);

  /**
   * Leave the blocks that any process has data for; blocks in the same place of their process's
   * list are one. It is a failure where lists differ in length and are to be @p alike. False if
   * there is a failure, here or already on some process.
   */
  bool SelectBlocks(bool alike, std::vector<vtkFFBlock>& blocks, vtkFFFailure& failure);

  /**
   * Process @p from sends @p data, of which nothing is lost, to process @p to, which gets it as
   * @p received (for others, null). Several pairs may be under way at once: a process that has no
   * part gives -1 for both. Ends with a Share().
   */
  bool Send(vtkPointSet* data, int from, int to, vtkSmartPointer<vtkPolyData>& received,
    vtkFFFailure& failure);

private:
  vtkMultiProcessController* Controller;
  int Count;
  int Rank;
};
VTK_ABI_NAMESPACE_END

#endif
