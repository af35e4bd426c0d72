// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFPointFetch
 * @brief   distributed points and their data, by id, from where they are
 *
 * vtkFFPointFetch gives a process any points of all processes, in their own type and bits, with
 * their point data. Ids count the points of the processes, one process after another. The type of
 * the points, and which arrays are passed, does not depend on which points are asked for: all
 * processes get the same, as if all points had been appended.
 */

#ifndef vtkFFPointFetch_h
#define vtkFFPointFetch_h

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkFFBlockExchange;
class vtkPointSet;

class vtkFFPointFetch
{
public:
  explicit vtkFFPointFetch(vtkFFBlockExchange& exchange)
    : Exchange(exchange)
  {
  }

  /**
   * Count this process's points, and know how many the others have. More than ids can count are a
   * failure. Collective.
   */
  void Count(vtkIdType points);

  /**
   * The first id of this process's points, and the number of all points, once they are counted.
   */
  vtkIdType GetBegin() const;
  vtkIdType GetNumberOfPoints() const { return this->Begins.back(); }

  /**
   * Have this process's points. After this, all processes know of what kind all points are.
   * Collective, as vtkFFBlockExchange::Exchange() is.
   */
  void SetPoints(vtkPointSet* own);

  /**
   * Of what kind all points are: one of them, with what all have of data. No point if there is
   * none.
   */
  vtkPointSet* GetKind() const { return this->Kind; }

  /**
   * Whether several processes have points.
   */
  bool HasSeveralSources() const;

  /**
   * The points of these ids, which ascend; for no id, the kind. Collective, as
   * vtkFFBlockExchange::Exchange() is.
   */
  void Fetch(
    const std::vector<vtkIdType>& ids, bool withData, vtkSmartPointer<vtkPointSet>& points);

private:
  vtkFFBlockExchange& Exchange;
  std::vector<vtkIdType> Begins; // of each process's ids; then the end of all
  vtkSmartPointer<vtkPointSet> Own;
  vtkSmartPointer<vtkPointSet> Kind;
};
VTK_ABI_NAMESPACE_END

#endif
