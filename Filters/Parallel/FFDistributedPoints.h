// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The points of all processes and their data, by id.
 *
 * Ids count the points of the processes, one process after another. A process can fetch any of
 * them, in their own type and bits, with their data. All processes get the same type and arrays, as
 * if all points had been appended.
 */

#ifndef FFDistributedPoints_h
#define FFDistributedPoints_h

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class FFProcesses;
class vtkPointSet;

class FFDistributedPoints
{
public:
  explicit FFDistributedPoints(FFProcesses& processes)
    : Processes(processes)
  {
  }

  /**
   * Count this process's points, and get how many the others have. Collective, as SetPoints() and
   * Fetch() are.
   *
   * @throw flipflop::Error TooManyPoints for more than ids can count.
   */
  void Count(vtkIdType points);

  ///@{
  /**
   * The first id of this process's points; the number of all points; how many processes have some.
   */
  vtkIdType GetBegin() const;
  vtkIdType GetNumberOfPoints() const { return this->Begins.back(); }
  int GetNumberOfSources() const;
  ///@}

  /**
   * Set this process's points, as many as were counted.
   */
  void SetPoints(vtkPointSet* own);

  /**
   * The type of all points, and which data all have: one of them; no point if there is none.
   */
  vtkPointSet* GetKind() const { return this->Kind; }

  /**
   * The points of these ids, which ascend; for no id, the kind.
   */
  vtkSmartPointer<vtkPointSet> Fetch(const std::vector<vtkIdType>& ids, bool withData);

private:
  FFProcesses& Processes;
  std::vector<vtkIdType> Begins; // of each process's ids; then the end of all
  vtkSmartPointer<vtkPointSet> Own;
  vtkSmartPointer<vtkPointSet> Kind;
};
VTK_ABI_NAMESPACE_END

#endif
