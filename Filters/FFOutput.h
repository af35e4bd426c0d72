// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The engine's results as VTK data.
 *
 * FFOutput turns the engine's results into the parts of a vtkPolyData. The VTK arrays take over
 * the engine's buffers without a copy.
 */

#ifndef FFOutput_h
#define FFOutput_h

#include <flipflop/Buffer.h>

#include "vtkFFMarks.h"
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
class vtkCellArray;
class vtkCellData;
class vtkDataObject;
class vtkDataSetAttributes;
class FFPointSource;
class vtkFieldData;
class vtkIdTypeArray;
class vtkPointData;
class vtkPointSet;
class vtkPolyData;

class FFOutput
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
   * A complete result as a poly data: points, cells, point data, ids. If @p data is empty, no point
   * data is passed. Returns the ids.
   */
  static vtkSmartPointer<vtkIdTypeArray> Adopt(flipflop::CellComplex& cells,
    const FFPointSource& points, const std::vector<Source>& data, vtkPolyData* output);

  /**
   * Ids as an array, which takes them over.
   */
  static vtkSmartPointer<vtkIdTypeArray> AdoptIds(flipflop::Buffer<std::int64_t>& ids);

  /**
   * Add the ids to the output's point (or cell) data as vtkOriginalPointIds.
   */
  static void AddIds(vtkIdTypeArray* ids, vtkDataSetAttributes* output);

  /**
   * Give the array vtkOriginalPointIds a second time, as OriginalPointIds.
   */
  static void ShowIds(vtkDataSetAttributes* output);

  /**
   * Make the cells vertices, lines or polygons of @p output, which takes them over.
   */
  static void AdoptCells(flipflop::CellComplex& cells, vtkPolyData* output);

  /**
   * The other way: connectivity and offsets of cells, whatever integers these have.
   */
  static void CopyCells(vtkCellArray* cells, flipflop::CellComplex& complex);

  /**
   * Turn polygons of an output, which the engine gave, into the triangles that it would give.
   */
  static void FanPolygons(vtkPolyData* output);

  /**
   * Copy the point data of the points that @p ids names, ascending. Ids count the points of all
   * @p sources, one source after another. Arrays keep their type, names and attributes. An array is
   * passed if every source with a point has it, with the same type and number of components, and
   * with a value for every point. The output is point data, or cell data if each cell represents
   * one point.
   */
  static void CopyPointData(
    const std::vector<Source>& sources, vtkIdTypeArray* ids, vtkDataSetAttributes* output);

  /**
   * Pass the field data of an input, if it has some, as the executive does.
   */
  static void PassFieldData(vtkDataObject* input, vtkDataObject* output);

  /**
   * Remove the arrays whose names begin with FlipFlop: the reports of filters upstream.
   */
  static void RemoveReport(vtkFieldData* data);

  ///@{
  /**
   * The same for an output that users see. Attributes that describe the input's own surface
   * (normals, tangents, edge flags, and those that curved cells need) are no longer active, since
   * they would shade and draw another surface falsely. In cell data, vtkGhostType has the marks for
   * cells.
   */
  static void PassPointData(
    const std::vector<Source>& sources, vtkIdTypeArray* ids, vtkPointData* output);
  static void PassPointData(
    const std::vector<Source>& sources, vtkIdTypeArray* ids, vtkCellData* output);
  ///@}

  /**
   * Replace each of the output's original ids by @p idOf(id), if it has any.
   */
  static void Renumber(
    vtkDataSetAttributes* output, const std::function<vtkIdType(vtkIdType)>& idOf);

  ///@{
  /**
   * Add an array of one value.
   */
  static void AddValue(vtkFieldData* output, const char* name, int value);
  static void AddValue(vtkFieldData* output, const char* name, std::int64_t value);
  static void AddValue(vtkFieldData* output, const char* name, double value);
  static void AddValue(vtkFieldData* output, const char* name, const char* value);
  ///@}

  /**
   * The points of all @p pieces, one piece after another, with the point arrays that all of them
   * have. A piece that has all points is returned unchanged. The first points can be left out: so
   * many have a say in the type and the data of the others, and are not among them.
   *
   * @throw FFInexactValue, flipflop::Error OutOfMemory.
   */
  static vtkSmartPointer<vtkPointSet> Append(
    const std::vector<vtkPointSet*>& pieces, vtkIdType leftOut = 0);

  /**
   * Some points of a piece, by ascending ids, with their point data.
   */
  static vtkSmartPointer<vtkPointSet> Select(vtkPointSet* piece, vtkIdTypeArray* which);

  /**
   * These points of a source, with the arrays of point data that those have which they are to
   * follow, but global ids. Values are those of the source's array of the same name and number of
   * components; without one, NaN, or 0 and an empty string of types that have none.
   */
  static vtkSmartPointer<vtkPolyData> SelectLike(
    vtkPointSet* followed, vtkPolyData* source, const flipflop::Buffer<std::int64_t>& which);
};
VTK_ABI_NAMESPACE_END

#endif
