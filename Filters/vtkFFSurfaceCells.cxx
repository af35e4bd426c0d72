// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFSurfaceCells.h"

#include <flipflop/Error.h>

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <cstddef>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// Where a cell's corners begin; past the last cell, where they end. VTK takes any place.
vtkIdType beginOf(vtkCellArray* cells, vtkIdType cell)
{
  return static_cast<vtkIdType>(cells->GetOffsetsArray()->GetComponent(cell, 0));
}

/// The first cell of fewer than three corners; the number of cells if there is none.
vtkIdType findSmall(vtkCellArray* cells)
{
  const vtkIdType count = cells->GetNumberOfCells();
  vtkIdType cell = 0;
  while (cell < count && cells->GetCellSize(cell) >= 3)
  {
    ++cell;
  }
  return cell;
}

}

//------------------------------------------------------------------------------
std::string vtkFFSurfaceCells::DescribeOffsets(vtkCellArray* cells, const std::string& whose)
{
  const vtkIdType count = cells->GetNumberOfCells();
  if (count == 0)
  {
    return {};
  }
  const vtkIdType given = cells->GetConnectivityArray()->GetNumberOfTuples();
  const vtkIdType first = beginOf(cells, 0);
  const vtkIdType last = beginOf(cells, count);
  bool ascending = first >= 0 && last <= given;
  for (vtkIdType i = 0; ascending && i < count; ++i)
  {
    ascending = beginOf(cells, i) <= beginOf(cells, i + 1);
  }
  if (ascending)
  {
    return {};
  }
  std::ostringstream message;
  message << "The " << whose << " are not valid: their offsets name corners " << first << " to "
          << last - 1 << ", and the connectivity has " << given << ".";
  return message.str();
}

//------------------------------------------------------------------------------
std::string vtkFFSurfaceCells::DescribeFault(vtkPolyData* surface, const std::string& ofBlock)
{
  vtkCellArray* polygons = surface->GetPolys();
  vtkCellArray* strips = surface->GetStrips();
  const vtkIdType vertices = surface->GetNumberOfVerts();
  const vtkIdType lines = surface->GetNumberOfLines();
  const vtkIdType faces = polygons->GetNumberOfCells() + strips->GetNumberOfCells();
  std::ostringstream message;
  if (vertices + lines > 0 && faces == 0)
  {
    message << "The surface" << ofBlock << " has no polygons: its cells are "
            << (lines == 0         ? "vertices"
                   : vertices == 0 ? "lines"
                                   : "vertices and lines")
            << ". It takes triangles, polygons and triangle strips; Convex Hull (vtkFFHullFilter) "
               "gives the hull of points.";
    return message.str();
  }
  if (vertices + lines > 0)
  {
    message
      << "Every cell of the input must be a triangle, a polygon or a triangle strip, but cell "
         "0"
      << ofBlock << " is a " << (vertices > 0 ? "vertex" : "line")
      << " cell. Take vertices and lines out: Extract Cells By Type "
         "(vtkExtractCellsByType) can do that.";
    return message.str();
  }
  for (vtkCellArray* cells : { polygons, strips })
  {
    const std::string fault = DescribeOffsets(cells, "input\'s cells" + ofBlock);
    if (!fault.empty())
    {
      return fault;
    }
  }
  // Cells are counted as vtkPolyData does: polygons, then strips.
  const vtkIdType polygon = findSmall(polygons);
  const vtkIdType strip = findSmall(strips);
  const bool isPolygon = polygon < polygons->GetNumberOfCells();
  if (isPolygon || strip < strips->GetNumberOfCells())
  {
    message << "Every polygon and every triangle strip must have three points or more, but cell "
            << (isPolygon ? polygon : polygons->GetNumberOfCells() + strip) << ofBlock << " is a "
            << (isPolygon ? "polygon" : "strip") << " of "
            << (isPolygon ? polygons->GetCellSize(polygon) : strips->GetCellSize(strip))
            << ". Clean (vtkCleanPolyData) can take it out.";
  }
  return message.str();
}

//------------------------------------------------------------------------------
vtkFFSurfaceCells::vtkFFSurfaceCells(
  vtkPolyData* surface, const flipflop::PointView& points, const flipflop::Options& options)
{
  vtkCellArray* polygons = surface->GetPolys();
  const bool areTriangles = surface->GetNumberOfStrips() == 0 &&
    (polygons->GetNumberOfCells() == 0 || polygons->IsHomogeneous() == 3);
  if (areTriangles)
  {
    this->TakeTriangles(polygons);
    return;
  }
  this->TakePolygons(polygons, surface->GetStrips());
  flipflop::PolygonView view;
  view.corners = this->Corners.data();
  view.offsets = this->Offsets.data();
  view.count = static_cast<std::int64_t>(this->CellIds.size());
  try
  {
    this->Triangles = flipflop::triangulatePolygons(points, view, options);
  }
  catch (const flipflop::Error& error)
  {
    const bool isOfCell = error.code() == flipflop::ErrorCode::BadTriangle ||
      error.code() == flipflop::ErrorCode::NotSimple;
    throw isOfCell ? flipflop::Error(error.code(),
                       this->CellIds[static_cast<std::size_t>(error.index())], error.count())
                   : error;
  }
  this->View.corners = this->Triangles.corners.data();
  this->View.count = static_cast<std::int64_t>(this->Triangles.polygonIds.size());
}

//------------------------------------------------------------------------------
void vtkFFSurfaceCells::TakeTriangles(vtkCellArray* cells)
{
  this->View.count = cells->GetNumberOfCells();
  if (this->View.count == 0)
  {
    return;
  }
  vtkDataArray* corners = cells->GetConnectivityArray();
  const vtkIdType first = beginOf(cells, 0);
  if (auto* wide = vtkAOSDataArrayTemplate<vtkTypeInt64>::FastDownCast(corners))
  {
    static_assert(sizeof(vtkTypeInt64) == sizeof(std::int64_t), "the same type by two names");
    this->View.corners = reinterpret_cast<const std::int64_t*>(wide->GetPointer(first));
    return;
  }
  const vtkIdType size = 3 * static_cast<vtkIdType>(this->View.count);
  this->Copy.allocate(static_cast<std::size_t>(size));
  auto* narrow = vtkAOSDataArrayTemplate<vtkTypeInt32>::FastDownCast(corners);
  for (vtkIdType i = 0; i < size; ++i)
  {
    this->Copy[static_cast<std::size_t>(i)] = narrow
      ? static_cast<std::int64_t>(narrow->GetValue(first + i))
      : static_cast<std::int64_t>(corners->GetComponent(first + i, 0));
  }
  this->View.corners = this->Copy.data();
}

//------------------------------------------------------------------------------
void vtkFFSurfaceCells::TakePolygons(vtkCellArray* polygons, vtkCellArray* strips)
{
  this->Offsets.push_back(0);
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i)
  {
    polygons->GetCellAtId(i, size, corners);
    this->Corners.insert(this->Corners.end(), corners, corners + size);
    this->Offsets.push_back(static_cast<std::int64_t>(this->Corners.size()));
    this->CellIds.push_back(i);
  }
  for (vtkIdType i = 0; i < strips->GetNumberOfCells(); ++i)
  {
    strips->GetCellAtId(i, size, corners);
    for (vtkIdType k = 0; k + 2 < size; ++k)
    {
      // Every other triangle of a strip goes the other way round.
      const vtkIdType odd = k % 2;
      for (const vtkIdType corner : { corners[k + odd], corners[k + 1 - odd], corners[k + 2] })
      {
        this->Corners.push_back(corner);
      }
      this->Offsets.push_back(static_cast<std::int64_t>(this->Corners.size()));
      this->CellIds.push_back(polygons->GetNumberOfCells() + i);
    }
  }
}

//------------------------------------------------------------------------------
std::int64_t vtkFFSurfaceCells::CellOf(std::int64_t triangle) const
{
  if (this->CellIds.empty() || triangle < 0)
  {
    return triangle;
  }
  const std::int64_t polygon = this->Triangles.polygonIds[static_cast<std::size_t>(triangle)];
  return this->CellIds[static_cast<std::size_t>(polygon)];
}

//------------------------------------------------------------------------------
flipflop::Hull vtkFFSurfaceCells::FlipFlop(
  const flipflop::PointView& points, const double* kernel, const flipflop::Options& options) const
{
  try
  {
    return flipflop::convexify(points, this->View, kernel, options);
  }
  catch (const flipflop::Error& error)
  {
    switch (error.code())
    {
      case flipflop::ErrorCode::BadTriangle:
      case flipflop::ErrorCode::NotClosed:
      case flipflop::ErrorCode::NotManifold:
      case flipflop::ErrorCode::NotOriented:
      case flipflop::ErrorCode::NotStarShaped:
        throw flipflop::Error(error.code(), this->CellOf(error.index()), error.count());
      default:
        throw;
    }
  }
}
VTK_ABI_NAMESPACE_END
