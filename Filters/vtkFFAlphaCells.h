// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFAlphaCells
 * @brief   what an alpha complex leaves of a triangulation, and its border
 *
 * vtkFFAlphaCells leaves cells out, and keeps the edges and points that are left as lines and
 * vertices of the same output. Its cell arrays go over all of them in VTK's order: vertices, lines,
 * polygons.
 */

#ifndef vtkFFAlphaCells_h
#define vtkFFAlphaCells_h

#include "vtkFFMarks.h"

#include <flipflop/AlphaComplex.h>
#include <flipflop/Buffer.h>
#include <flipflop/CellComplex.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>

#include "vtkType.h"

#include <cstdint>
#include <functional>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;

class vtkFFAlphaCells
{
public:
  /**
   * Leave out the cells that are not in the complex. Returns how many these are.
   *
   * @param lines    keep the edges that are left
   * @param vertices keep the points that are left
   */
  std::int64_t Take(const flipflop::PointView& points, const flipflop::WeightView& weights,
    double alpha, bool lines, bool vertices, const flipflop::Options& options,
    flipflop::CellComplex& cells);

  /**
   * Leave out the lines that are longer. Returns how many these are.
   */
  std::int64_t DropLongLines(const flipflop::PointView& points, double longest,
    const flipflop::Options& options, flipflop::CellComplex& cells);

  /**
   * Calls @p use(complex) for the lines that are kept, if there are some, as cells of the same
   * points.
   */
  void WithLines(
    flipflop::CellComplex& cells, const std::function<void(flipflop::CellComplex&)>& use);

  //@{
  /**
   * How many vertices and lines are kept, and all that is in the output with these cells; the
   * vertices' points.
   */
  std::int64_t GetNumberOfVertices() const;
  std::int64_t GetNumberOfLines() const;
  std::int64_t GetNumberOfCells(const flipflop::CellComplex& cells) const;
  const flipflop::Buffer<std::int64_t>& GetVertices() const { return this->Vertices.connectivity; }
  //@}

  /**
   * Add the least alpha of each cell as the cell array Alpha. Before AddTo().
   */
  void AddAlphas(const flipflop::PointView& points, const flipflop::WeightView& weights,
    const flipflop::Options& options, const flipflop::CellComplex& cells,
    vtkPolyData* output) const;

  /**
   * Make what is kept vertices and lines of the output.
   */
  void AddTo(vtkPolyData* output);

  /**
   * The border of the cells: closed polylines over the points that they have.
   */
  static flipflop::CellComplex MakeBoundary(
    const flipflop::CellComplex& cells, const flipflop::Options& options);

private:
  flipflop::CellComplex Lines;
  flipflop::CellComplex Vertices;
  flipflop::Buffer<double> LineAlphas;
  flipflop::Buffer<double> VertexAlphas;
};
VTK_ABI_NAMESPACE_END

#endif
