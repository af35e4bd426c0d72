// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFConstrainedDelaunayFilter
 * @brief   the exact Delaunay triangulation of points that has given edges
 *
 * vtkFFConstrainedDelaunayFilter computes the Delaunay triangulation of points in the plane, with
 * constraints: lines, polylines and polygons of a second input that are to be edges of it. All
 * other edges are Delaunay as far as the constraints let points see each other. They name points of
 * the input, or have points of their own, which join the others: see SetSourcePoints(). Cells of
 * the first input are ignored, and there are no weights. Without a second input, it is the Delaunay
 * triangulation.
 *
 * - Port 0, the triangulation, in the form that
 *   vtkFFRegularTriangulationFilter gives it. As polygons (see
 *   SetFacetMode()), a cell is all points of one circle that no
 *   constraint parts.
 * - Port 1, the fixed edges: a line for each edge of the triangulation
 *   that a constraint runs along, with the points of port 0. The cell
 *   array ConstraintCellIds (a vtkIdTypeArray) has the id of the first
 *   cell of the source that does. The edges are by ascending ids.
 *
 * The result does not depend on the order of the constraints. A constraint through points is parted
 * there, and one that ends at a duplicate ends at the lowest id of that position. Constraints that
 * cross between points are an error that names both cells, unless they are to be split: see
 * SetSplitCrossingConstraints(). So is a constraint whose point is not there or is left out.
 *
 * Polygons also define what is inside: see SetPolygonRule(). Cells that are not inside are left out
 * and counted; if no cell is inside, a warning says so. All points stay in the output, also those
 * that no cell has any more.
 *
 * The input must be one data set. This filter runs on the CPU
 * engine. Asking it for the CUDA engine is an error, and so is an array of weights.
 *
 * @sa
 * vtkFFPlanarAlgorithm vtkFFRegularTriangulationFilter vtkDelaunay2D
 */

#ifndef vtkFFConstrainedDelaunayFilter_h
#define vtkFFConstrainedDelaunayFilter_h

#include "vtkFFMarks.h" // For VTK_MARSHALAUTO
#include "vtkFFPlanarAlgorithm.h"
#include "vtkFiltersFlipFlopModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithmOutput;

class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFConstrainedDelaunayFilter
  : public vtkFFPlanarAlgorithm
{
public:
  //@{
  /**
   * Standard methods for instantiation, type information and printing.
   */
  static vtkFFConstrainedDelaunayFilter* New();
  vtkTypeMacro(vtkFFConstrainedDelaunayFilter, vtkFFPlanarAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  //@}

  /**
   * How the polygons of the source define what is inside.
   */
  enum PolygonRuleType
  {
    EVEN_ODD = 0,
    DIRECTION = 1
  };

  /**
   * Whose points the source's cells name.
   */
  enum SourcePointsType
  {
    AUTOMATIC_POINTS = 0,
    INPUT_POINTS = 1,
    OWN_POINTS = 2
  };

  //@{
  /**
   * Set/Get the second input, on port 1: the constraints. None by default. SetSourcePoints() says
   * whose points they name.
   */
  void SetSourceData(vtkPolyData* source);
  void SetSourceConnection(vtkAlgorithmOutput* output);
  void RemoveSource() { this->SetSourceConnection(nullptr); }
  vtkPolyData* GetSource();
  //@}

  //@{
  /**
   * Set/Get whose points the cells of the source name. Points are compared as given, before a
   * transform.
   *
   * - AUTOMATIC_POINTS (the default): the input's, if the source has
   *   no points, or if at all ids that its cells name its points are
   *   those of the input, in all three coordinates. Otherwise its
   *   own.
   * - INPUT_POINTS: the input's, by id, as in vtkDelaunay2D. The
   *   source has no points, or at these ids those of the input (x and
   *   y alone for XY_PLANE): anything else is an error that names the
   *   first id at which they differ, with both coordinates.
   * - OWN_POINTS: the source's.
   *
   * Own points that cells name join the points of the input, after them. At the position of a point
   * of the input, in the plane of the triangulation, that point is used, with its own z and data;
   * of several own points at one position, the first. Point data of the same name and number of
   * components comes along. Where the source has no such array, added points have NaN, or 0 in
   * arrays that are no floating-point numbers. Arrays that the input lacks, and global ids, do not
   * come along. A point that is not finite is an error that names its cell. In vtkOriginalPointIds,
   * added points have -1.
   *
   * With own points, or if crossing constraints are split, the output has the point array
   * PointOrigin (a vtkUnsignedCharArray): 0 for points of the input, 1 for those that the source
   * adds, 2 for those where constraints cross. For XY_PLANE it also has HeightRange, a
   * vtkDoubleArray of two components: the lowest and the highest of all z that are given for a
   * point, by itself, by points of the source at its position, and by the lines that end there or
   * run through it. GetNumberOfHeightDifferences() returns at how many points these differ.
   */
  vtkSetClampMacro(SourcePoints, int, AUTOMATIC_POINTS, OWN_POINTS);
  vtkGetMacro(SourcePoints, int);
  //@}

  //@{
  /**
   * Set/Get whether closed lines of the source are polygons, which define what is inside: see
   * SetPolygonRule(). Lines are joined end to end first, as slices and feature edges need it: at a
   * position where exactly two of their ends are. A line, or a sequence of them, that then ends
   * where it begins is closed, unless it encloses nothing. It runs as its first line does. One that
   * runs all the way along the outline of the source's polygons and of the closed lines before it
   * is this outline, and no second polygon. Off by default.
   */
  vtkSetMacro(ClosedLinesAsBorders, bool);
  vtkGetMacro(ClosedLinesAsBorders, bool);
  //@}

  //@{
  /**
   * Set/Get whether constraints are split where they cross between points. Off by default: they
   * are an error.
   *
   * The output then has a new point at each crossing, after the others. Its place in the plane of
   * the triangulation is the crossing with each coordinate rounded to the nearest double, so
   * constraints bend there, by half a unit in the last place at most, between the points that are
   * on them: these stay on them. Where bent constraints cross again, which is rare, they are split
   * once more. A crossing that is the position of a point, as
   * rounded, takes that point.
   *
   * Positions in space and point data are interpolated along the first of the constraints that
   * cross there, by their order in the source: lines, then polygons, whose last side is the one
   * that closes them. So for XY_PLANE that line's z
   * counts; those of the others are in HeightRange: see SetSourcePoints(). Data that cannot be
   * interpolated, such as global ids, is not passed then. The points of the output are double. In
   * vtkOriginalPointIds, new points have -1.
   */
  vtkSetMacro(SplitCrossingConstraints, bool);
  vtkGetMacro(SplitCrossingConstraints, bool);
  //@}

  //@{
  /**
   * Set/Get how polygons of the source define what is inside. Without polygons, all
   * cells stay. So they do where all points are on one line.
   *
   * - EVEN_ODD (the default): by nesting. A polygon keeps its inside,
   *   one in it is a hole, to any depth, whatever their directions.
   *   Each side of each polygon counts: a cell is inside if a way to
   *   it from outside crosses an odd number of sides. So of polygons
   *   that overlap, what two have in common is outside.
   * - DIRECTION: as in vtkDelaunay2D. What is on the left of a side,
   *   as seen from the plane's upper side, is inside. So a polygon
   *   that runs counter-clockwise keeps its inside, and a clockwise
   *   one in it is a hole, to any depth; a clockwise one alone is a
   *   hole in all. Polygons that say different things of one cell are
   *   an error that names two of them, and which to reverse.
   *
   * If holes run clockwise in polygons that run counter-clockwise, both rules give the same.
   */
  vtkSetClampMacro(PolygonRule, int, EVEN_ODD, DIRECTION);
  vtkGetMacro(PolygonRule, int);
  //@}

  //@{
  /**
   * Set/Get the length of the longest edge that the cells of port 0 may have, as
   * vtkFFRegularTriangulationFilter has it. 0 by default: any. All points stay in the output.
   */
  virtual void SetMaximumEdgeLength(double length)
  {
    this->ChangeOutput(this->MaximumEdgeLength, length);
  }
  vtkGetMacro(MaximumEdgeLength, double);
  //@}

  //@{
  /**
   * Get how many points the last run added: where constraints cross, and of the source; and at how
   * many points several heights were given that differ.
   */
  vtkGetMacro(NumberOfSplitPoints, vtkIdType);
  vtkGetMacro(NumberOfAddedPoints, vtkIdType);
  vtkGetMacro(NumberOfHeightDifferences, vtkIdType);
  //@}

protected:
  vtkFFConstrainedDelaunayFilter();
  ~vtkFFConstrainedDelaunayFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void ForgetReport() override;

  int SourcePoints = AUTOMATIC_POINTS;
  bool ClosedLinesAsBorders = false;
  bool SplitCrossingConstraints = false;
  int PolygonRule = EVEN_ODD;
  double MaximumEdgeLength = 0.0;
  vtkIdType NumberOfSplitPoints = 0;
  vtkIdType NumberOfAddedPoints = 0;
  vtkIdType NumberOfHeightDifferences = 0;

private:
  vtkFFConstrainedDelaunayFilter(const vtkFFConstrainedDelaunayFilter&) = delete;
  void operator=(const vtkFFConstrainedDelaunayFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
