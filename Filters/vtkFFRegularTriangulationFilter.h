// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFRegularTriangulationFilter
 * @brief   the exact Delaunay or regular (weighted) triangulation in the plane
 *
 * vtkFFRegularTriangulationFilter gives the regular triangulation of the points of any vtkPointSet,
 * vtkImageData or vtkRectilinearGrid, and on request the power diagram, its dual. Without weights
 * these are the Delaunay triangulation and the Voronoi diagram. Cells of the input do not matter.
 * The triangulation is exact for every finite input: no tolerance decides anything.
 *
 * Weights come from a point array of one component and any numeric type:
 *
 *     filter->SetInputArrayToProcess(
 *       0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "weights");
 *
 * None is set by default, nor by an empty name, nor by the name None where no array has it: all
 * points then weigh the same. A weight is a
 * squared length and may be negative: the power distance of x from a point p of weight w is
 * |x - p|^2 - w, so a disk of radius r has the weight r^2. The same number added to all weights
 * changes nothing.
 *
 * The algorithm is ffRT of the paper named in vtkFFAlgorithm: the points are lifted to (x, y,
 * x^2 + y^2 - w), a star-shaped surface below all lifts is grown, and Flip-Flop turns it into their
 * lower hull by local flips. A point appears when its lift is a strictly extreme vertex of the
 * lower hull; of points with one position and one weight, the one of lowest id. All others are
 * hidden, ties included. Without weights, only duplicates are hidden.
 *
 * What comes out is a function of the input alone:
 *
 * - Port 0, the triangulation: the points that appear, by ascending id,
 *   in their original place in space, type and bits (floats stay
 *   floats). The cells are triangles, counter-clockwise as seen from the
 *   plane's upper side, none without area; or, as polygons (see
 *   SetFacetMode()), one cell for all points of one empty power circle,
 *   without weights one circle. The triangles of such points are the fan
 *   from the lowest id. Each cell starts at its lowest id; all are in
 *   lexicographic order.
 * - Port 1, the hidden points: a vertex cell each, by ascending id.
 * - Port 2, the power diagram: empty unless GeneratePowerDiagram is on.
 *   One polygon for each point of port 0 whose region meets the
 *   inside of a box, by ascending id. Neighbours share their corners,
 *   and points of one power circle meet in one corner. Which regions
 *   meet is exact, the corners' coordinates are rounded (see
 *   SetGeneratePowerDiagram()).
 *
 * On ports 0 and 1 the point array vtkOriginalPointIds (a vtkIdTypeArray) has the id that each
 * point has in the input, and the input's point data is passed, unless PassPointData is off. On
 * port 2 both belong to the cells: each carries the data of its point, and in vtkGhostType the
 * marks of cells that say the same.
 *
 * Every input has an answer:
 *
 * - no point: empty, dimension -1, no error
 * - one position: one vertex cell: the greatest weight, then the lowest
 *   id
 * - collinear points: a chain of line cells through the points that
 *   appear
 * - duplicates: the greatest weight, then the lowest id, stands for all
 * - NaN or infinity: an error naming the first point and the count, and
 *   empty output
 * - the same, to be ignored: left out and counted:
 *   SetNonFinitePointsToIgnore()
 * - no or unusable weights: an error naming the array, and empty output
 * - ghost points: left out, unless SkipGhostPoints is off
 * - too many points, no memory: an error, and empty output
 *
 * Weights are unusable if they are no numbers, or not one for each point; for no point, none are
 * needed. NaN or infinity counts wherever it is: in a weight, in a coordinate, in z even where z
 * does not matter. Points left out for that are on no port.
 *
 * @warning
 * At most 2^32 - 2 points can be given, about 5e8 where nearly all are visible.
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
   * The box to which the power diagram is clipped.
   */
  enum PowerDiagramBoxModeType
  {
    BOX_OF_POINTS = 0,
    BOX_OF_BOUNDS = 1
  };

  // What sets a mode as well comes before that mode: VTK reads a state back in this order, so that
  // the mode is the one that was written.

  //@{
  /**
   * Set/Get the transform that takes the points to the XY plane. To set one sets
   * ProjectionPlaneMode to TRANSFORM_PLANE, which needs one; a mode set later prevails. To set none
   * leaves the mode as it is. None by default.
   *
   * StoreTransform() never changes the mode: it is for applications that set all they have, in
   * whatever order.
   */
  virtual void SetTransform(vtkAbstractTransform* transform);
  void StoreTransform(vtkAbstractTransform* transform);
  vtkGetObjectMacro(Transform, vtkAbstractTransform);
  //@}

  //@{
  /**
   * Set/Get the plane in which the points are triangulated. The output's points keep their original
   * places.
   *
   * - XY_PLANE (the default): z is left out. The points are not
   *   copied, and nothing is rounded.
   * - TRANSFORM_PLANE: the points are transformed by Transform, and z
   *   is left out. Weights are squared lengths after the transform.
   * - BEST_FITTING_PLANE: the points are projected to the plane
   *   through their centroid with the least sum of squared distances;
   *   all finite points count alike, whatever their weight. Its normal
   *   is turned so that the component of largest magnitude (the last
   *   one, of equals) is positive; seen from the normal's tip,
   *   triangles are counter-clockwise. Positions in the plane are
   *   measured from the first finite point. The first axis is a
   *   coordinate axis laid into the plane: x if the normal is mostly
   *   along z, y if along x, z if along y.
   *
   * In the latter two the triangulation is exact for the projected positions, which are rounded
   * to double. Both are computed alike each time, for any number of threads.
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
   * Set/Get whether port 2 gives the power diagram. Off by default.
   *
   * Its corners lie in the plane of the triangulation: at z = 0 for XY_PLANE, in the fitted plane
   * for BEST_FITTING_PLANE, and for TRANSFORM_PLANE where the inverse transform takes z = 0; a
   * transform without an inverse is an error then. The seconds reported are the triangulation's.
   *
   * In the plane, the cells are simple polygons, counter-clockwise, that fill the box edge to edge
   * without gap or overlap, exactly so for the corners as they were rounded. They are convex but
   * for rounding: a corner may turn the other way by a few units in the last place. Cells that
   * rounding leaves no inside are missing; corners within some units of each other may be merged
   * where a cell would not be simple or convex otherwise. (Fitted planes and transforms round the
   * corners once more on their way back into space.)
   */
  vtkSetMacro(GeneratePowerDiagram, bool);
  vtkGetMacro(GeneratePowerDiagram, bool);
  vtkBooleanMacro(GeneratePowerDiagram, bool);
  //@}

  //@{
  /**
   * Set/Get the box of BOX_OF_BOUNDS, (xmin, xmax, ymin, ymax) in the plane: of x and y, of the
   * transformed points, or measured in the fitted plane. It must be finite and have an inside. To
   * set it sets PowerDiagramBoxMode to BOX_OF_BOUNDS; a mode set later prevails. (0, 1, 0, 1) by
   * default.
   *
   * StorePowerDiagramBounds() never changes the mode: it is for applications that set all they
   * have, in whatever order.
   */
  virtual void SetPowerDiagramBounds(double xmin, double xmax, double ymin, double ymax);
  virtual void SetPowerDiagramBounds(const double bounds[4]);
  void StorePowerDiagramBounds(double xmin, double xmax, double ymin, double ymax);
  vtkGetVector4Macro(PowerDiagramBounds, double);
  //@}

  //@{
  /**
   * Set/Get the box to which the power diagram is clipped: the bounds of the points in the plane
   * (BOX_OF_POINTS, the default), or PowerDiagramBounds (BOX_OF_BOUNDS). Points without an extent
   * along x or y get that of the other direction, half of it on either side; a single position gets
   * a box of side 1.
   */
  vtkSetClampMacro(PowerDiagramBoxMode, int, BOX_OF_POINTS, BOX_OF_BOUNDS);
  vtkGetMacro(PowerDiagramBoxMode, int);
  void SetPowerDiagramBoxModeToPoints() { this->SetPowerDiagramBoxMode(BOX_OF_POINTS); }
  void SetPowerDiagramBoxModeToBounds() { this->SetPowerDiagramBoxMode(BOX_OF_BOUNDS); }
  const char* GetPowerDiagramBoxModeAsString();
  //@}

  //@{
  /**
   * Get the outputs of ports 1 and 2: the hidden points and the power diagram.
   */
  vtkPolyData* GetHiddenPointsOutput();
  vtkPolyData* GetPowerDiagramOutput();
  //@}

  /**
   * Get the number of points that the last run found hidden; the sum for several blocks.
   */
  vtkGetMacro(NumberOfHiddenPoints, vtkIdType);

  /**
   * The transform counts.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkFFRegularTriangulationFilter();
  ~vtkFFRegularTriangulationFilter() override;

  class vtkInternals;

  int ProjectionPlaneMode;
  vtkAbstractTransform* Transform;
  bool GeneratePowerDiagram;
  int PowerDiagramBoxMode;
  double PowerDiagramBounds[4];

private:
  vtkFFRegularTriangulationFilter(const vtkFFRegularTriangulationFilter&) = delete;
  void operator=(const vtkFFRegularTriangulationFilter&) = delete;

  vtkIdType NumberOfHiddenPoints;
};
VTK_ABI_NAMESPACE_END

#endif
