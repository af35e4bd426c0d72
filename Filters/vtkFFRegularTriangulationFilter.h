// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFRegularTriangulationFilter
 * @brief   the exact Delaunay or regular (weighted) triangulation in the plane
 *
 * vtkFFRegularTriangulationFilter computes the regular triangulation of the points of any
 * vtkPointSet, vtkImageData or vtkRectilinearGrid; without weights, that is the Delaunay
 * triangulation. vtkFFPlanarAlgorithm says what weights are, and how to give them. Cells of the
 * input are ignored. The triangulation is exact for every finite input: no tolerance decides
 * anything. Its dual is the power diagram: see vtkFFPowerDiagramFilter.
 *
 * The algorithm is ffRT of the paper named in vtkFFAlgorithm. The points are lifted to (x, y,
 * x^2 + y^2 - w), a star-shaped surface below all lifts is grown, and Flip-Flop turns it into the
 * lower hull of the lifts by local flips. A point appears if its lift is a strictly extreme vertex
 * of the lower hull. Of points with the same position and weight, the one of lowest id appears. All
 * other points are hidden, also ties. Without weights, only duplicates are hidden.
 *
 * The output is a function of the input alone:
 *
 * - Port 0, the triangulation: the points that appear, by ascending id,
 *   in their original place in space, type and bits (floats stay
 *   floats). The cells are triangles, counter-clockwise as seen from
 *   the plane's upper side, none without area. As polygons (see
 *   SetFacetMode()), there is one cell for all points of one empty
 *   power circle, which is a circle without weights. As triangles, such
 *   points give the fan from the lowest id. Each cell starts at its
 *   lowest id; all are in lexicographic order.
 * - Port 1, the hidden points: a vertex cell each, by ascending id.
 * - Port 2, the border of the cells: empty unless GenerateBoundary is
 *   on.
 *
 * On all ports, the point array vtkOriginalPointIds (a vtkIdTypeArray) has the id that each point
 * has in the input. The input's point data is passed, unless PassPointData is off.
 *
 * Every input has an answer:
 *
 * - no point: empty, dimension -1, no error
 * - one position: one vertex cell: the greatest weight, then the lowest
 *   id
 * - collinear points: a chain of line cells through the points that
 *   appear
 * - duplicates: the greatest weight, then the lowest id, represents all
 * - NaN or infinity, unusable weights, too many points: an error and
 *   empty output; points that are left out are on no port
 *
 * A setting that concerns the output alone (alpha, edge length, border, arrays, the report) does
 * not triangulate again while the input is unchanged. Neither do facets as triangles after facets
 * as polygons. The filter keeps its last triangulation for that, in 28 bytes for each point. It
 * keeps none of composites, and none if its release data flag is on.
 *
 * @warning
 * At most 2^32 - 2 points can be given, about 5e8 if nearly all are visible.
 *
 * @sa
 * vtkFFPlanarAlgorithm vtkFFPowerDiagramFilter vtkFFConstrainedDelaunayFilter vtkDelaunay2D
 */

#ifndef vtkFFRegularTriangulationFilter_h
#define vtkFFRegularTriangulationFilter_h

#include "vtkFFMarks.h" // For VTK_MARSHALAUTO
#include "vtkFFPlanarAlgorithm.h"
#include "vtkFiltersFlipFlopModule.h" // For export macro

#include <memory> // For std::shared_ptr

VTK_ABI_NAMESPACE_BEGIN
class vtkFFKeptTriangulation;

class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFRegularTriangulationFilter
  : public vtkFFPlanarAlgorithm
{
public:
  //@{
  /**
   * Standard methods for instantiation, type information and printing.
   */
  static vtkFFRegularTriangulationFilter* New();
  vtkTypeMacro(vtkFFRegularTriangulationFilter, vtkFFPlanarAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  //@}

  //@{
  /**
   * Set/Get alpha, a length: port 0 has the alpha complex of the triangulation. 0 by default: all
   * of it. As in vtkDelaunay2D, a triangle stays if its circumcircle has at most the radius Alpha;
   * that is decided exactly. With weights, it is the circle of power distance 0 from the corners,
   * and the square of its radius is compared with that of Alpha; it may be negative. A negative
   * number and NaN are an error of the update. Infinity leaves nothing out.
   *
   * AlphaLines adds the edges that are left as lines: those of no triangle that stays, whose own
   * least circle has at most the radius Alpha and no point in it. AlphaVerts adds the points that
   * are left as vertices. Both are off by default. MaximumEdgeLength applies to what Alpha leaves,
   * also to lines.
   *
   * GenerateAlphas adds the cell array Alpha (vtkDoubleArray): for each cell the least Alpha for
   * which it stays, without weights its circle's radius, rounded up. So a vtkThreshold of that
   * array gives the cells of any alpha, exactly. With weights, a negative number stands for a
   * negative square.
   *
   * All points stay in the output. Where several processes triangulate together, AlphaLines,
   * AlphaVerts and GenerateAlphas are errors.
   */
  virtual void SetAlpha(double alpha) { this->ChangeOutput(this->Alpha, alpha); }
  vtkGetMacro(Alpha, double);
  virtual void SetAlphaLines(bool on) { this->ChangeOutput(this->AlphaLines, on); }
  vtkGetMacro(AlphaLines, bool);
  virtual void SetAlphaVerts(bool on) { this->ChangeOutput(this->AlphaVerts, on); }
  vtkGetMacro(AlphaVerts, bool);
  virtual void SetGenerateAlphas(bool on) { this->ChangeOutput(this->GenerateAlphas, on); }
  vtkGetMacro(GenerateAlphas, bool);
  //@}

  //@{
  /**
   * Set/Get whether port 2 gives the border of the cells of port 0 as closed polylines. Off by
   * default. Cells are on the left of each, so one around cells is counter-clockwise, and one
   * around a hole is clockwise. No polyline passes a point twice; they may meet in points. Each
   * starts at its lowest id; they are in lexicographic order. The points are those of the border.
   * Where several processes triangulate together, it is an error.
   */
  virtual void SetGenerateBoundary(bool on) { this->ChangeOutput(this->GenerateBoundary, on); }
  vtkGetMacro(GenerateBoundary, bool);
  //@}

  //@{
  /**
   * Set/Get whether the output has a certificate as field data. Off by default. With it, a program
   * that shares nothing with this one checks the triangulation in linear time:
   * Checker/check_result.py.
   *
   * FlipFlopCertificate (vtkIdTypeArray) has for each point of the input, ghosts included, the cell
   * of port 0 that holds it, of several the lowest; a hidden point is hidden by it. -1 for a point
   * that was left out. Cells are counted before Alpha and MaximumEdgeLength leave some out. Where
   * several processes triangulate together, it is an error.
   */
  virtual void SetGenerateCertificate(bool on)
  {
    this->ChangeOutput(this->GenerateCertificate, on);
  }
  vtkGetMacro(GenerateCertificate, bool);
  //@}

  //@{
  /**
   * Set/Get the length of the longest edge that the cells of port 0 may have. 0 by default: any.
   * Cells with a longer edge are left out: triangles, and the lines of collinear points. Edges are
   * measured in the plane of the triangulation, and compared exactly: one as long as
   * MaximumEdgeLength stays. Infinity leaves nothing out. A negative number and NaN are an error
   * of the update.
   *
   * All points stay in the output, also those of no cell. The hidden points and the power diagram
   * do not change.
   *
   * As polygons (see SetFacetMode()), all points of one empty power circle are one cell, which is
   * judged by its border. As triangles, each triangle of the fan is judged by itself; some of its
   * edges are diagonals, so of a square of side 1, a length of 1.2 leaves out both triangles.
   */
  virtual void SetMaximumEdgeLength(double length)
  {
    this->ChangeOutput(this->MaximumEdgeLength, length);
  }
  vtkGetMacro(MaximumEdgeLength, double);
  //@}

protected:
  vtkFFRegularTriangulationFilter();
  ~vtkFFRegularTriangulationFilter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double Alpha = 0.0;
  bool AlphaLines = false;
  bool AlphaVerts = false;
  bool GenerateAlphas = false;
  bool GenerateBoundary = false;
  bool GenerateCertificate = false;
  double MaximumEdgeLength = 0.0;

private:
  vtkFFRegularTriangulationFilter(const vtkFFRegularTriangulationFilter&) = delete;
  void operator=(const vtkFFRegularTriangulationFilter&) = delete;

  std::shared_ptr<vtkFFKeptTriangulation> Kept;
};
VTK_ABI_NAMESPACE_END

#endif
