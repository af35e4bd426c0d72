// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFSurfaceCells.h"

#include "FFOutput.h"

#include <flipflop/Error.h>

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTriangleStrip.h"

#include <cstddef>
#include <stdexcept>

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
std::string FFSurfaceCells::DescribeOffsets(vtkCellArray* cells, const std::string& whose)
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
  return ascending ? std::string()
                   : "The " + whose + " are not valid: their offsets name corners " +
      std::to_string(first) + " to " + std::to_string(last - 1) + ", and the connectivity has " +
      std::to_string(given) + ".";
}

//------------------------------------------------------------------------------
vtkPolyData* FFSurfaceCells::SurfaceOf(vtkDataObject* input, const std::string& of)
{
  const auto refuse = [](const std::string& message) { throw std::runtime_error(message); };
  auto* const surface = vtkPolyData::SafeDownCast(input);
  if (!surface) // in a composite, VTK does not check types
  {
    refuse("The data" + of + " is a " + input->GetClassName() + ". It must be a vtkPolyData.");
  }
  vtkCellArray* const polygons = surface->GetPolys();
  vtkCellArray* const strips = surface->GetStrips();
  const std::string vertices = surface->GetNumberOfVerts() > 0 ? "vertices" : "";
  const std::string lines = surface->GetNumberOfLines() > 0 ? "lines" : "";
  const bool hasOthers = !vertices.empty() || !lines.empty();
  if (polygons->GetNumberOfCells() + strips->GetNumberOfCells() == 0 &&
    (hasOthers || surface->GetNumberOfPoints() > 0))
  {
    const std::string both = vertices.empty() || lines.empty() ? "" : " and ";
    refuse("The surface" + of + " has no " +
      (hasOthers ? "polygons: its cells are " + vertices + both + lines
                 : "cells, but " + std::to_string(surface->GetNumberOfPoints()) + " point(s)") +
      ". It takes triangles, polygons and triangle strips; Convex Hull (vtkFFHullFilter) gives the "
      "hull of points.");
  }
  if (hasOthers)
  {
    refuse("Every cell of the input must be a triangle, a polygon or a triangle strip, but cell 0" +
      of + " is a " + (lines.empty() || !vertices.empty() ? "vertex" : "line") +
      " cell. Take vertices and lines out: Extract Cells By Type (vtkExtractCellsByType) can do "
      "that.");
  }
  vtkIdType before = 0; // Cells are counted as vtkPolyData does: polygons, then strips.
  for (vtkCellArray* cells : { polygons, strips })
  {
    const std::string fault = DescribeOffsets(cells, "input's cells" + of);
    if (!fault.empty())
    {
      refuse(fault);
    }
  }
  for (vtkCellArray* cells : { polygons, strips })
  {
    const vtkIdType small = findSmall(cells);
    if (small < cells->GetNumberOfCells())
    {
      refuse("Every polygon and every triangle strip must have three points or more, but cell " +
        std::to_string(before + small) + of + " is a " + (cells == strips ? "strip" : "polygon") +
        " of " + std::to_string(cells->GetCellSize(small)) +
        ". Clean (vtkCleanPolyData) can take it out.");
    }
    before += cells->GetNumberOfCells();
  }
  return surface;
}

//------------------------------------------------------------------------------
FFSurfaceCells::FFSurfaceCells(
  vtkPolyData* surface, const flipflop::PointView& points, const flipflop::Options& options)
{
  vtkCellArray* const polygons = surface->GetPolys();
  vtkCellArray* const strips = surface->GetStrips();
  const vtkIdType count = polygons->GetNumberOfCells();
  if (strips->GetNumberOfCells() == 0 && (count == 0 || polygons->IsHomogeneous() == 3))
  {
    static_assert(sizeof(vtkTypeInt64) == sizeof(std::int64_t), "the same type by two names");
    auto* const wide =
      vtkAOSDataArrayTemplate<vtkTypeInt64>::FastDownCast(polygons->GetConnectivityArray());
    if (!wide)
    {
      FFOutput::CopyCells(polygons, this->Copy);
    }
    this->View.corners = wide && count > 0
      ? reinterpret_cast<const std::int64_t*>(wide->GetPointer(beginOf(polygons, 0)))
      : this->Copy.connectivity.data();
    this->View.count = count;
    return;
  }

  vtkNew<vtkCellArray> all;
  vtkNew<vtkIdList> corners; // of our own: other threads may read the same cells
  for (vtkIdType i = 0; i < count + strips->GetNumberOfCells(); ++i)
  {
    if (i < count)
    {
      polygons->GetCellAtId(i, corners);
      all->InsertNextCell(corners);
    }
    else
    {
      strips->GetCellAtId(i - count, corners);
      vtkTriangleStrip::DecomposeStrip(
        static_cast<int>(corners->GetNumberOfIds()), corners->GetPointer(0), all);
    }
    this->CellIds.resize(static_cast<std::size_t>(all->GetNumberOfCells()), i);
  }
  FFOutput::CopyCells(all, this->Copy);
  try
  {
    this->Triangles = flipflop::triangulatePolygons(points,
      { this->Copy.connectivity.data(), this->Copy.offsets.data(), this->Copy.cellCount() },
      options);
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
flipflop::Hull FFSurfaceCells::FlipFlop(
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
        break;
      default:
        throw;
    }
    std::int64_t cell = error.index();
    if (cell >= 0 && !this->CellIds.empty())
    {
      const std::int64_t polygon = this->Triangles.polygonIds[static_cast<std::size_t>(cell)];
      cell = this->CellIds[static_cast<std::size_t>(polygon)];
    }
    throw flipflop::Error(error.code(), cell, error.count());
  }
}
VTK_ABI_NAMESPACE_END
