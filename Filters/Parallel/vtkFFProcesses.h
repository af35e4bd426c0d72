// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFProcesses
 * @brief   what the processes of a distributed filter tell each other
 *
 * vtkFFProcesses wraps a vtkMultiProcessController for the Flip-Flop filters. Unless stated
 * otherwise, its methods are collective: every process calls them, in the same order, also after a
 * failure. After the next Share(), all processes know of a failure on one of them. So they stop
 * together, and none waits for another.
 */

#ifndef vtkFFProcesses_h
#define vtkFFProcesses_h

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>
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
   * Every process's values, one process after another. Each process gives the same number of
   * values.
   */
  std::vector<vtkIdType> Gather(const std::vector<vtkIdType>& values);

  /**
   * Every process's values. Each process may give a different number of values.
   */
  std::vector<std::vector<vtkIdType>> GatherLists(const std::vector<vtkIdType>& values);

  //@{
  /**
   * The sum of all processes' numbers, and the least of them.
   */
  vtkIdType Sum(vtkIdType value);
  double Least(double value);
  //@}

  /**
   * The sums over all processes of each of the values. Each process gives as many.
   */
  std::vector<vtkIdType> Sum(const std::vector<vtkIdType>& values);

  /**
   * One process after another works on values that the one before it leaves. All get what the last
   * one leaves. The work may not throw.
   */
  void PassOn(std::vector<double>& values, const std::function<void()>& work);

  /**
   * Combine the failures of all processes; each process gets the same. False if there is any.
   */
  bool Share(vtkFFFailure& failure);

  /**
   * Process @p from sends @p data without loss to process @p to, which gets it as @p received (null
   * on other processes). Several pairs may send at the same time. A process that takes no
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
