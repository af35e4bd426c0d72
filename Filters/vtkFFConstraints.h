// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFConstraints
 * @brief   the lines and polygons of a source as the engine's constraints
 *
 * vtkFFConstraints gives the engine the segments of the lines, polylines and polygons of a
 * vtkPolyData, whose ids are those of another data set's points. Polygons come last, as the engine
 * asks.
 */

#ifndef vtkFFConstraints_h
#define vtkFFConstraints_h

#include "vtkFFMarks.h"
#include "vtkType.h"

#include <flipflop/ConstrainedTriangulation.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkCellArray;
class vtkDataSet;
class vtkPolyData;

class vtkFFConstraints
{
public:
  /**
   * @param source     whose cells are read
   * @param input      the data set whose points ids name
   * @param places     of those of these points that the engine was given, ascending; empty: it was
   *                   given all
   * @param withHeight whether z matters, where points are compared
   * @throw std::runtime_error where a cell names a point that is not there, or that has other
   *                           coordinates in the source, if it has points
   */
  vtkFFConstraints(
    vtkPolyData* source, vtkDataSet* input, const std::vector<vtkIdType>& places, bool withHeight);

  vtkFFConstraints(const vtkFFConstraints&) = delete;
  void operator=(const vtkFFConstraints&) = delete;

  /**
   * The constraints; valid as long as this object exists.
   */
  flipflop::ConstraintView GetView() const;

  /**
   * The cell of the source that a constraint is of, in words.
   */
  std::string DescribeCell(std::int64_t constraint) const;

  /**
   * Its id.
   */
  vtkIdType GetCellId(std::int64_t constraint) const
  {
    return this->CellIds[static_cast<std::size_t>(constraint)];
  }

private:
  void Take(vtkCellArray* cells, vtkIdType firstCell, bool areClosed);
  std::int64_t GetId(vtkIdType point, vtkIdType cell) const;
  void CheckPoint(vtkIdType point, vtkIdType cell) const;

  vtkPolyData* const Source; // while it is read
  vtkDataSet* const Input;
  const int Dimensions; // that are compared
  const std::vector<vtkIdType>& Places;
  std::vector<std::int64_t> Ends;
  std::vector<vtkIdType> CellIds; // of each constraint
  std::int64_t Sides = 0;
};
VTK_ABI_NAMESPACE_END

#endif
