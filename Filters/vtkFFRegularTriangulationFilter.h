// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFRegularTriangulationFilter
 * @brief   the exact Delaunay or regular (weighted) triangulation in the plane
 *
 * vtkFFRegularTriangulationFilter computes the regular triangulation of the points of any
 * vtkPointSet, vtkImageData or vtkRectilinearGrid. On request it also computes the dual, the power
 * diagram. Without weights, these are the Delaunay triangulation and the Voronoi diagram. Cells of
 * the input are ignored. The triangulation is exact for every finite input: no tolerance decides
 * anything.
 *
 * Weights come from a point array of one component and any numeric type:
 *
 *     filter->SetInputArrayToProcess(
 *       0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "weights");
 *
 * By default there is no array, and all points weigh the same. An empty name means the same, and so
 * does the name None if no array has it. A weight is a squared length and may be negative: the
 * power distance of x from a point p of weight w is |x - p|^2 - w, so a disk of radius r has the
 * weight r^2. The array may also have the radii (see SetWeightMode()). Adding the same number to
 * all weights changes nothing.
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
 * - Port 2, the power diagram: empty unless GeneratePowerDiagram is on.
 *   It has one polygon for each point of port 0 whose region meets the
 *   inside of a box, by ascending id. Neighbours share their corners,
 *   and points of one power circle meet in one corner. The choice of
 *   the regions that meet is exact; the corners' coordinates are
 *   rounded (see SetGeneratePowerDiagram()).
 * - Port 3, the border of the cells: empty unless GenerateBoundary is
 *   on.
 *
 * On ports 0 and 1, the point array vtkOriginalPointIds (a vtkIdTypeArray) has the id that each
 * point has in the input. The input's point data is passed, unless PassPointData is off. On port 2,
 * both are cell data: each cell has the data of its point. In vtkGhostType, each cell has the mark
 * for cells that corresponds to its point's mark.
 *
 * Every input has an answer:
 *
 * - no point: empty, dimension -1, no error
 * - one position: one vertex cell: the greatest weight, then the lowest
 *   id
 * - collinear points: a chain of line cells through the points that
 *   appear
 * - duplicates: the greatest weight, then the lowest id, represents all
 * - NaN or infinity: an error naming the first point and the count, and
 *   empty output
 * - NaN or infinity with SetNonFinitePointsToIgnore(): left out and
 *   counted
 * - missing or unusable weights: an error naming the array, and empty
 *   output
 * - a negative radius, or a weight that WeightMode or WeightFactor make
 *   too large: an error naming the point, and empty output
 * - ghost points: left out, unless SkipGhostPoints is off
 * - cells with an edge longer than MaximumEdgeLength, or with a circle
 *   larger than Alpha, if these are not 0: left out and counted
 * - constraints that cross between points, or name a point that is not
 *   there: an error naming the cells, and empty output; those that
 *   cross are split if SplitCrossingConstraints is on
 * - too many points, no memory: an error, and empty output
 *
 * Weights are unusable if they are not numbers, or if there is not one for each point. Without
 * points, no weights are needed. A point is not finite if its weight or any coordinate is NaN or
 * infinite, also z if z does not matter. Points left out for that are on no port.
 *
 * @warning
 * At most 2^32 - 2 points can be given, about 5e8 if nearly all are visible.
 *
 * @sa
 * vtkFFAlgorithm vtkFFHullFilter vtkDelaunay2D vtkVoronoi2D
 */

#ifndef vtkFFRegularTriangulationFilter_h
#define vtkFFRegularTriangulationFilter_h

#include "vtkFFAlgorithm.h"
#include "vtkFFMarks.h"               // For VTK_MARSHALAUTO
#include "vtkFiltersFlipFlopModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractTransform;
class vtkAlgorithmOutput;

class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFRegularTriangulationFilter
  : public vtkFFAlgorithm
{
public:
  //@{
  /**
   * Standard methods for instantiation, type information and printing.
   */
  static vtkFFRegularTriangulationFilter* New();
  vtkTypeMacro(vtkFFRegularTriangulationFilter, vtkFFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  //@}

  /**
   * The plane in which points are triangulated. The values are those of vtkDelaunay2D.
   */
  enum ProjectionPlaneModeType
  {
    XY_PLANE = 0,
    TRANSFORM_PLANE = 1,
    BEST_FITTING_PLANE = 2
  };

  /**
   * What the values of the weights' array are.
   */
  enum WeightModeType
  {
    WEIGHTS = 0,
    RADII = 1
  };

  /**
   * How the source's polygons tell what is inside.
   */
  enum PolygonRuleType
  {
    EVEN_ODD = 0,
    DIRECTION = 1
  };

  /**
   * The box to which the power diagram is clipped.
   */
  enum PowerDiagramBoxModeType
  {
    BOX_OF_POINTS = 0,
    BOX_OF_BOUNDS = 1
  };

  //@{
  /**
   * Set/Get the second input, on port 1: lines, polylines and polygons that are to be edges of the
   * triangulation. None by default. Their point ids are those of the input, as in vtkDelaunay2D.
   * The source has no points, or at the ids that its cells name the very coordinates of the input
   * (x and y alone, for XY_PLANE): points of its own are an error that names the first id at which
   * they differ, with both coordinates. Points are compared as given, before a transform.
   *
   * Polygons also tell what is inside: see SetPolygonRule(). Cells that are not inside are left out
   * and counted; if no cell is inside, a warning says so. All points stay in the output, also those
   * that no cell has any more.
   *
   * The result is the constrained Delaunay triangulation: all other edges are Delaunay as far as
   * the constraints let points see each other. It does not depend on the order of the constraints.
   * A constraint through points is parted there, and one that ends at a duplicate ends at the
   * lowest id of that position. Constraints that cross between points are an error that names both
   * cells, as is a point that is not there or is left out. As polygons (see SetFacetMode()), a cell
   * is all points of one circle that no constraint parts.
   *
   * With a source, there can be no weights, no power diagram, no CUDA engine and no more than one
   * block, and the points may not be distributed over processes: each is an error.
   */
  void SetSourceData(vtkDataObject* source);
  void SetSourceConnection(vtkAlgorithmOutput* output);
  void RemoveSource() { this->SetSourceConnection(nullptr); }
  vtkPolyData* GetSource();
  //@}

  // What sets a mode as well comes before that mode: VTK reads a state back in this order, so that
  // the mode is the one that was written.

  //@{
  /**
   * Set/Get the transform that takes the points to the XY plane. None by default. SetTransform()
   * with a transform also sets ProjectionPlaneMode to TRANSFORM_PLANE; you can set another mode
   * later. SetTransform() with null does not change the mode. TRANSFORM_PLANE needs a transform.
   *
   * StoreTransform() never changes the mode. It is for applications that set all properties, in
   * any order.
   */
  virtual void SetTransform(vtkAbstractTransform* transform);
  void StoreTransform(vtkAbstractTransform* transform);
  vtkGetObjectMacro(Transform, vtkAbstractTransform);
  //@}

  //@{
  /**
   * Set/Get the plane in which the points are triangulated. The output's points keep their original
   * positions.
   *
   * - XY_PLANE (the default): z is left out. The points are not
   *   copied, and nothing is rounded.
   * - TRANSFORM_PLANE: the points are transformed by Transform, and z
   *   is left out. Weights are squared lengths after the transform.
   * - BEST_FITTING_PLANE: the points are projected to the plane
   *   through their centroid with the least sum of squared distances.
   *   All finite points count the same, whatever their weight. The
   *   normal's component of largest magnitude (the last one, if
   *   several are equal) is positive. Seen from the normal's tip,
   *   triangles are counter-clockwise. Positions in the plane are
   *   measured from the first finite point. The first axis is a
   *   coordinate axis projected into the plane: x if the normal is
   *   mostly along z, y if along x, z if along y.
   *
   * In the latter two modes, the triangulation is exact for the projected positions, which are
   * rounded to double. These positions are the same in each run, for any number of threads.
   */
  vtkSetClampMacro(ProjectionPlaneMode, int, XY_PLANE, BEST_FITTING_PLANE);
  vtkGetMacro(ProjectionPlaneMode, int);
  void SetProjectionPlaneModeToXYPlane() { this->SetProjectionPlaneMode(XY_PLANE); }
  void SetProjectionPlaneModeToTransform() { this->SetProjectionPlaneMode(TRANSFORM_PLANE); }
  void SetProjectionPlaneModeToBestFittingPlane()
  {
    this->SetProjectionPlaneMode(BEST_FITTING_PLANE);
  }
  const char* GetProjectionPlaneModeAsString();
  //@}

  //@{
  /**
   * Set/Get what the values of the weights' array are. Without an array, this does not matter.
   *
   * - WEIGHTS (the default): weights. Each is multiplied by
   *   WeightFactor.
   * - RADII: the radii of disks. Each is multiplied by WeightFactor, and
   *   the weight is the square.
   *
   * Both are computed in double, from the values as they are: the product is rounded to double, and
   * so is its square. For any number r, that is s * s of the double s = WeightFactor * r. So the
   * weights are the same bits as in C++ or NumPy, and the result is exact for these weights. The
   * square of a float, or of an integer below 2^26, is not rounded at all.
   *
   * A negative radius is an error that names the point. So is a weight that is too large for a
   * double, though the value is finite.
   */
  vtkSetClampMacro(WeightMode, int, WEIGHTS, RADII);
  vtkGetMacro(WeightMode, int);
  void SetWeightModeToWeights() { this->SetWeightMode(WEIGHTS); }
  void SetWeightModeToRadii() { this->SetWeightMode(RADII); }
  const char* GetWeightModeAsString();
  //@}

  //@{
  /**
   * Set/Get the factor of all weights, or of all radii: see SetWeightMode(). 1 by default, with
   * which weights are taken as they are, and nothing is rounded. It may be negative or 0; NaN and
   * infinity are errors.
   */
  vtkSetMacro(WeightFactor, double);
  vtkGetMacro(WeightFactor, double);
  //@}

  //@{
  /**
   * Set/Get alpha, a length: port 0 has the alpha complex of the triangulation. 0 by default: all
   * of it. As in vtkDelaunay2D, a triangle stays if its circumcircle has at most the radius Alpha;
   * that is decided exactly. With weights, it is the circle of power distance 0 from the corners,
   * and the square of its radius is compared with that of Alpha; it may be negative. A negative
   * number and NaN are errors. Infinity leaves nothing out.
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
  vtkSetMacro(Alpha, double);
  vtkGetMacro(Alpha, double);
  vtkSetMacro(AlphaLines, bool);
  vtkGetMacro(AlphaLines, bool);
  vtkBooleanMacro(AlphaLines, bool);
  vtkSetMacro(AlphaVerts, bool);
  vtkGetMacro(AlphaVerts, bool);
  vtkBooleanMacro(AlphaVerts, bool);
  vtkSetMacro(GenerateAlphas, bool);
  vtkGetMacro(GenerateAlphas, bool);
  vtkBooleanMacro(GenerateAlphas, bool);
  //@}

  //@{
  /**
   * Set/Get whether port 3 gives the border of the cells of port 0 as closed polylines. Off by
   * default. Cells are on the left of each, so one around cells is counter-clockwise, and one
   * around a hole is clockwise. No polyline passes a point twice; they may meet in points. Each
   * starts at its lowest id; they are in lexicographic order. The points are those of the border.
   * Where several processes triangulate together, it is an error.
   */
  vtkSetMacro(GenerateBoundary, bool);
  vtkGetMacro(GenerateBoundary, bool);
  vtkBooleanMacro(GenerateBoundary, bool);
  //@}

  //@{
  /**
   * Set/Get the length of the longest edge that the cells of port 0 may have. 0 by default: any.
   * Cells with a longer edge are left out: triangles, and the lines of collinear points. Edges are
   * measured in the plane of the triangulation, and compared exactly: one as long as
   * MaximumEdgeLength stays. Infinity leaves nothing out. A negative number and NaN are errors.
   *
   * All points stay in the output, also those of no cell. The hidden points and the power diagram
   * do not change.
   *
   * As polygons (see SetFacetMode()), all points of one empty power circle are one cell, which is
   * judged by its border. As triangles, each triangle of the fan is judged by itself; some of its
   * edges are diagonals, so of a square of side 1, a length of 1.2 leaves out both triangles.
   */
  vtkSetMacro(MaximumEdgeLength, double);
  vtkGetMacro(MaximumEdgeLength, double);
  //@}

  //@{
  /**
   * Set/Get whether constraints are split where they cross between points: see SetSourceData(). Off
   * by default: they are an error. Without a source, this does not matter.
   *
   * The output then has a new point at each crossing, after the others. Its place in the plane of
   * the triangulation is the crossing with each coordinate rounded to the nearest double, so
   * constraints bend there, by half a unit in the last place at most. Where bent constraints cross
   * anew, which is rare, they are split once more. A crossing that is the position of a point, as
   * rounded, takes that point.
   *
   * Positions in space and point data are interpolated along the first of the constraints that
   * cross there, by their order in the source: lines, then polygons. Data that cannot be
   * interpolated, such as global ids, is not passed then. The points of the output are double. In
   * vtkOriginalPointIds, new points have -1.
   */
  vtkSetMacro(SplitCrossingConstraints, bool);
  vtkGetMacro(SplitCrossingConstraints, bool);
  vtkBooleanMacro(SplitCrossingConstraints, bool);
  //@}

  //@{
  /**
   * Set/Get how the source's polygons tell what is inside: see SetSourceData(). Without polygons,
   * this does not matter: all cells stay. So they do where all points are on one line.
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
  void SetPolygonRuleToEvenOdd() { this->SetPolygonRule(EVEN_ODD); }
  void SetPolygonRuleToDirection() { this->SetPolygonRule(DIRECTION); }
  const char* GetPolygonRuleAsString();
  //@}

  //@{
  /**
   * Set/Get whether port 2 gives the power diagram. Off by default.
   *
   * Its corners lie in the plane of the triangulation: for XY_PLANE at the lowest z of the points
   * that are triangulated or hidden, in the fitted plane for BEST_FITTING_PLANE, and for
   * TRANSFORM_PLANE where the inverse transform takes z = 0. A transform without an inverse is then
   * an error. Each block of a composite has its own lowest z. The reported seconds are the
   * triangulation's.
   *
   * In the plane, the cells are simple polygons, counter-clockwise, that fill the box edge to edge
   * without gap or overlap. That holds exactly for the rounded corners. The cells are convex except
   * for rounding: a corner may turn the other way by a few units in the last place. Cells that have
   * no inside after rounding are missing. Corners within a few units of each other may be merged if
   * a cell would otherwise not be simple or convex. (Fitted planes and transforms round the corners
   * once more on the way back into space.)
   */
  vtkSetMacro(GeneratePowerDiagram, bool);
  vtkGetMacro(GeneratePowerDiagram, bool);
  vtkBooleanMacro(GeneratePowerDiagram, bool);
  //@}

  //@{
  /**
   * Set/Get whether the cells of the triangulation and of the power diagram have two more cell
   * arrays: Area (vtkDoubleArray) and Centroid (vtkDoubleArray, a position in space). Off by
   * default.
   *
   * Both are measured in the plane of the triangulation, as seen along its normal: heights above
   * the plane make no cell larger, and with TRANSFORM_PLANE the cell is measured after the
   * transform. Centroids are positions of that plane, as the power diagram's corners are: at the
   * points' lowest z for XY_PLANE, in the fitted plane, or where the inverse transform takes z = 0.
   * A transform without an inverse is then an error. Lines and vertices have the area 0, and their
   * middle for a centroid.
   *
   * An area is off by no more than 2^-50 of itself, however flat a cell is. In power cells that
   * rounding made concave, it is 2^-50 of the areas of the fan from the first corner. Arrays of the
   * input with these names are not passed to the power diagram's cells.
   */
  vtkSetMacro(GenerateCellMeasures, bool);
  vtkGetMacro(GenerateCellMeasures, bool);
  vtkBooleanMacro(GenerateCellMeasures, bool);
  //@}

  //@{
  /**
   * Set/Get the box of BOX_OF_BOUNDS, (xmin, xmax, ymin, ymax) in the plane: of x and y, of the
   * transformed points, or measured in the fitted plane. (0, 1, 0, 1) by default. It must be finite
   * and have an inside. SetPowerDiagramBounds() also sets PowerDiagramBoxMode to BOX_OF_BOUNDS; you
   * can set another mode later.
   *
   * StorePowerDiagramBounds() never changes the mode. It is for applications that set all
   * properties, in any order.
   */
  virtual void SetPowerDiagramBounds(double xmin, double xmax, double ymin, double ymax);
  virtual void SetPowerDiagramBounds(const double bounds[4]);
  void StorePowerDiagramBounds(double xmin, double xmax, double ymin, double ymax);
  vtkGetVector4Macro(PowerDiagramBounds, double);
  //@}

  //@{
  /**
   * Set the same bounds by the box's least corner and its lengths, in any order; z does not count.
   * The mode stays. It is for applications whose users move a box in space.
   */
  void StorePowerDiagramCorner(double x, double y, double z);
  void StorePowerDiagramLengths(double x, double y, double z);
  //@}

  //@{
  /**
   * Set/Get the box to which the power diagram is clipped: the bounds of the points in the plane
   * (BOX_OF_POINTS, the default), or PowerDiagramBounds (BOX_OF_BOUNDS). If the points have no
   * extent along x or y, the box has the extent of the other direction, half of it on either side.
   * A single position gets a box of side 1.
   */
  vtkSetClampMacro(PowerDiagramBoxMode, int, BOX_OF_POINTS, BOX_OF_BOUNDS);
  vtkGetMacro(PowerDiagramBoxMode, int);
  void SetPowerDiagramBoxModeToPoints() { this->SetPowerDiagramBoxMode(BOX_OF_POINTS); }
  void SetPowerDiagramBoxModeToBounds() { this->SetPowerDiagramBoxMode(BOX_OF_BOUNDS); }
  const char* GetPowerDiagramBoxModeAsString();
  //@}

  //@{
  /**
   * Get the outputs of ports 1, 2 and 3: the hidden points, the power diagram and the border. Null
   * for a subclass that has not this port.
   */
  vtkPolyData* GetHiddenPointsOutput();
  vtkPolyData* GetPowerDiagramOutput();
  vtkPolyData* GetBoundaryOutput();
  //@}

  /**
   * Get the number of points that the last run found hidden; the sum for several blocks.
   */
  vtkGetMacro(NumberOfHiddenPoints, vtkIdType);

  /**
   * Get the number of cells that the last run left out, for Alpha, for MaximumEdgeLength or
   * since they are not inside the source's polygons; the sum for several blocks.
   */
  vtkGetMacro(NumberOfDroppedCells, vtkIdType);

  /**
   * Get the number of points that the last run added where constraints cross.
   */
  vtkGetMacro(NumberOfSplitPoints, vtkIdType);

  /**
   * The time of the last change, also of the transform.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkFFRegularTriangulationFilter();
  ~vtkFFRegularTriangulationFilter() override;

  class vtkInternals;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  /**
   * RequestData() of a subclass with a single output port: that is one of the four outputs.
   */
  int RequestDataOfOneOutput(int index, vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector);

  int ProjectionPlaneMode;
  vtkAbstractTransform* Transform;
  int WeightMode;
  double WeightFactor;
  double Alpha;
  bool AlphaLines;
  bool AlphaVerts;
  bool GenerateAlphas;
  bool GenerateBoundary;
  double MaximumEdgeLength;
  bool SplitCrossingConstraints;
  int PolygonRule;
  bool GeneratePowerDiagram;
  bool GenerateCellMeasures;
  int PowerDiagramBoxMode;
  double PowerDiagramBounds[4];
  double PowerDiagramLengths[2];

private:
  vtkFFRegularTriangulationFilter(const vtkFFRegularTriangulationFilter&) = delete;
  void operator=(const vtkFFRegularTriangulationFilter&) = delete;

  vtkIdType NumberOfHiddenPoints;
  vtkIdType NumberOfDroppedCells;
  vtkIdType NumberOfSplitPoints;
};
VTK_ABI_NAMESPACE_END

#endif
