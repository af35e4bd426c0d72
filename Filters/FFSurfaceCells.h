// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The cells of a surface as the engine's triangles.
 *
 * FFSurfaceCells gives the engine the triangles, polygons and triangle strips of a vtkPolyData.
 * Where all cells are triangles, their corners are copied only if they are not 64-bit integers.
 * Otherwise, the engine cuts the polygons: flipflop::triangulatePolygons().
 */

#ifndef FFSurfaceCells_h
#define FFSurfaceCells_h

#include "vtkFFMarks.h"
#include "vtkType.h"

#include <flipflop/CellComplex.h>
#include <flipflop/Convexify.h>
#include <flipflop/SurfacePolygons.h>

#include <cstdint>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkCellArray;
class vtkDataObject;
class vtkPolyData;

class FFSurfaceCells
{
public:
  /**
   * The input as a surface that has cells, and no others than a surface's.
   *
   * @param of how errors name the block: " of the block of flat index 2", or nothing
   * @throw std::runtime_error that says what is wrong
   */
  static vtkPolyData* SurfaceOf(vtkDataObject* input, const std::string& of);

  /**
   * Whether the corners of cells are there, which VTK's own calls rely on: what is wrong with them,
   * in a sentence. Empty: nothing.
   *
   * @param whose how errors tell the cells: "source's cells"
   */
  static std::string DescribeOffsets(vtkCellArray* cells, const std::string& whose);

  /**
   * The cells of a surface without such a fault.
   *
   * @param points  its points
   * @param options of which the progress function is used
   * @throw flipflop::Error as triangulatePolygons(), with cells for polygons.
   */
  FFSurfaceCells(
    vtkPolyData* surface, const flipflop::PointView& points, const flipflop::Options& options);

  FFSurfaceCells(const FFSurfaceCells&) = delete;
  void operator=(const FFSurfaceCells&) = delete;

  /// The triangles; valid as long as this object and the surface exist.
  const flipflop::TriangleView& GetView() const { return this->View; }

  /**
   * The surface's hull by flips.
   *
   * @throw flipflop::Error as convexify(), with cells for triangles.
   */
  flipflop::Hull FlipFlop(const flipflop::PointView& points, const double* kernel,
    const flipflop::Options& options) const;

private:
  flipflop::TriangleView View;
  flipflop::CellComplex Copy;           // of cells that the engine does not read in place
  flipflop::PolygonTriangles Triangles; // that polygons were cut into
  std::vector<std::int64_t> CellIds;    // of polygons; a strip is several triangles
};
VTK_ABI_NAMESPACE_END

#endif
