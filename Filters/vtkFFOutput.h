// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFOutput
 * @brief   the engine's results as VTK data
 *
 * vtkFFOutput turns what the engine gives into the parts of a vtkPolyData. The engine's buffers are
 * adopted by the VTK arrays, not copied.
 *
 * What the filters for distributed data need of it is exported: their module is another library.
 */

#ifndef vtkFFOutput_h
#define vtkFFOutput_h

#include <flipflop/Buffer.h>

#include "vtkFFMarks.h"
#include "vtkFiltersFlipFlopModule.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace flipflop
{
struct CellComplex;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkCellData;
class vtkDataSetAttributes;
class vtkFFPointSource;
class vtkFieldData;
class vtkIdTypeArray;
class vtkPointData;
class vtkPolyData;

class vtkFFOutput
{
public:
  /**
   * A source of point data: the data itself, and how many points it belongs to.
   */
  struct Source
  {
    vtkPointData* Data;
    vtkIdType NumberOfPoints;
  };

  /**
   * The whole of a result as a poly data: points, cells, point data, ids. @p data may be empty:
   * then none is passed. Gives the ids back.
   */
  static vtkSmartPointer<vtkIdTypeArray> Adopt(flipflop::CellComplex& cells,
    const vtkFFPointSource& points, const std::vector<Source>& data, bool visibleIds,
    vtkPolyData* output);

  /**
   * Ids as an array, which takes them over.
   */
  static vtkSmartPointer<vtkIdTypeArray> AdoptIds(flipflop::Buffer<std::int64_t>& ids);

  /**
   * Add the ids to the output's point (or cell) data as vtkOriginalPointIds and, if @p visible, a
   * second time as OriginalPointIds.
   */
  static void AddIds(vtkIdTypeArray* ids, bool visible, vtkDataSetAttributes* output);

  /**
   * The cells as vertices, lines or polygons of @p output, which takes them over.
   */
  static void AdoptCells(flipflop::CellComplex& cells, vtkPolyData* output);

  /**
   * The point data of the points named by @p ids, ascending, where the points of @p sources are
   * counted one after another. Arrays keep their type, names and attributes. An array is passed
   * when every source with a point has it, of one type and number of components, and a value for
   * every point. The output is point data, or cell data where each cell stands for one point.
   */
  static void CopyPointData(
    const std::vector<Source>& sources, vtkIdTypeArray* ids, vtkDataSetAttributes* output);

  /**
   * Remove the arrays whose names begin with FlipFlop: what filters upstream report.
   */
  static void RemoveReport(vtkFieldData* data);

  //@{
  /**
   * The same for an output that users see. Attributes that tell of the input's own surface
   * (normals, tangents, edge flags, and what curved cells need) are active no more: they would
   * shade and draw another surface falsely. In cell data the marks of vtkGhostType are those of
   * cells.
   */
  static void PassPointData(
    const std::vector<Source>& sources, vtkIdTypeArray* ids, vtkPointData* output);
  static void PassPointData(
    const std::vector<Source>& sources, vtkIdTypeArray* ids, vtkCellData* output);
  //@}

  /**
   * Put another id, @p idOf(id), in the place of each of the output's original ids, if it has any.
   */
  VTKFILTERSFLIPFLOP_EXPORT static void Renumber(
    vtkDataSetAttributes* output, const std::function<vtkIdType(vtkIdType)>& idOf);

  //@{
  /**
   * Add an array of one value.
   */
  static void AddValue(vtkFieldData* output, const char* name, int value);
  static void AddValue(vtkFieldData* output, const char* name, std::int64_t value);
  static void AddValue(vtkFieldData* output, const char* name, double value);
  static void AddValue(vtkFieldData* output, const char* name, const char* value);
  //@}
};
VTK_ABI_NAMESPACE_END

#endif
