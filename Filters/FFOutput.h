// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The engine's results as VTK data: points, cells, point data and ids.
 *
 * VTK arrays take over the engine's buffers without a copy.
 */

#ifndef FFOutput_h
#define FFOutput_h

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkVariant.h"

#include <flipflop/Buffer.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace flipflop
{
struct CellComplex;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkCellArray;
class vtkDataObject;
class vtkDataSetAttributes;
class FFPointSource;
class vtkFieldData;
class vtkIdTypeArray;
class vtkPointData;
class vtkPointSet;
class vtkPolyData;

namespace FFOutput
{

/// A source of point data: the data itself, and how many points it belongs to.
struct Source
{
  vtkPointData* Data;
  vtkIdType NumberOfPoints;
};
std::vector<Source> DataOf(const std::vector<vtkPointSet*>& pieces);

/// A complete result as a poly data: points, cells, point data, ids. If @p data is empty, no point
/// data is passed. Returns the ids.
vtkSmartPointer<vtkIdTypeArray> Adopt(flipflop::CellComplex& cells, const FFPointSource& points,
  const std::vector<Source>& data, vtkPolyData* output);

///@{
/// Ids as an array, which takes them over; and that as the array vtkOriginalPointIds of point (or
/// cell) data; each of these replaced by @p idOf(id), if there are some; and the array a second
/// time, as OriginalPointIds.
vtkSmartPointer<vtkIdTypeArray> AdoptIds(flipflop::Buffer<std::int64_t>& ids);
void AddIds(vtkIdTypeArray* ids, vtkDataSetAttributes* output);
void Renumber(vtkDataSetAttributes* output, const std::function<vtkIdType(vtkIdType)>& idOf);
void ShowIds(vtkDataSetAttributes* output);
///@}

/// Make the cells vertices, lines or polygons of @p output, which takes them over.
void AdoptCells(flipflop::CellComplex& cells, vtkPolyData* output);

/// The other way: connectivity and offsets of cells, whatever integers these have.
void CopyCells(vtkCellArray* cells, flipflop::CellComplex& complex);

/// Turn polygons of an output, which the engine gave, into the triangles that it would give.
void FanPolygons(vtkPolyData* output);

/**
 * Copy the point data of the points that @p ids names, ascending. Ids count the points of all
 * @p sources, one source after another. The output is point data, or cell data if each cell
 * represents one point.
 *
 * Arrays keep their type, names and attributes. An array is passed if every source with a point has
 * it, with the same type and number of components, and with a value for every point. Attributes
 * that describe the input's own surface are no longer active, since they would shade and draw
 * another surface falsely. In cell data, vtkGhostType has the marks for cells.
 */
void PassPointData(
  const std::vector<Source>& sources, vtkIdTypeArray* ids, vtkDataSetAttributes* output);

///@{
/// Pass the field data of an input, if it has some, as the executive does; remove the arrays whose
/// names begin with FlipFlop, the reports of filters upstream; add an array of one value.
void PassFieldData(vtkDataObject* input, vtkDataObject* output);
void RemoveReport(vtkFieldData* data);
void AddValue(vtkFieldData* output, const char* name, const vtkVariant& value);
///@}

/**
 * The points of all @p pieces, one piece after another, with the point arrays that all of them
 * have. A piece that has all points is returned unchanged. The first points can be left out: so
 * many have a say in the type and the data of the others, and are not among them.
 *
 * @throw FFInexactValue, flipflop::Error OutOfMemory.
 */
vtkSmartPointer<vtkPointSet> Append(const std::vector<vtkPointSet*>& pieces, vtkIdType leftOut = 0);

/// Some points of a piece, by ascending ids, with their point data.
vtkSmartPointer<vtkPointSet> Select(vtkPointSet* piece, vtkIdTypeArray* which);

/// These points of a source, with the arrays of point data that those have which they are to
/// follow, but global ids. Values are those of the source's array of the same name and number of
/// components; without one, NaN, or 0 and an empty string of types that have none.
vtkSmartPointer<vtkPolyData> SelectLike(
  vtkPointSet* followed, vtkPolyData* source, const flipflop::Buffer<std::int64_t>& which);

}
VTK_ABI_NAMESPACE_END

#endif
