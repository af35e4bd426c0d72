// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFPlanarAlgorithm
 * @brief   what the filters that triangulate in a plane have in common
 *
 * vtkFFPlanarAlgorithm is the abstract superclass of the Flip-Flop filters that work in a plane. It
 * has the plane, the weights of the points, and the measures of cells.
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
 * Weights are unusable if they are not numbers, or if there is not one for each point: an error
 * that names the array. Without points, no weights are needed. A point is not finite if its weight
 * or any coordinate is NaN or infinite, also z if z does not matter.
 *
 * @sa
 * vtkFFRegularTriangulationFilter vtkFFPowerDiagramFilter
 */

#ifndef vtkFFPlanarAlgorithm_h
#define vtkFFPlanarAlgorithm_h

#include "vtkFFAlgorithm.h"
#include "vtkFFMarks.h"               // For VTK_MARSHALAUTO
#include "vtkFiltersFlipFlopModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractTransform;

class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFPlanarAlgorithm : public vtkFFAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for type information and printing.
   */
  vtkAbstractTypeMacro(vtkFFPlanarAlgorithm, vtkFFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

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

  // What sets a mode as well comes before that mode: VTK reads a state back in this order, so that
  // the mode is the one that was written.

  ///@{
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
  ///@}

  ///@{
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
  void SetProjectionPlaneModeToTransformPlane() { this->SetProjectionPlaneMode(TRANSFORM_PLANE); }
  void SetProjectionPlaneModeToBestFittingPlane()
  {
    this->SetProjectionPlaneMode(BEST_FITTING_PLANE);
  }
  ///@}

  ///@{
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
  ///@}

  ///@{
  /**
   * Set/Get the factor of all weights, or of all radii: see SetWeightMode(). 1 by default, with
   * which weights are taken as they are, and nothing is rounded. It may be negative or 0; NaN and
   * infinity are errors.
   */
  vtkSetMacro(WeightFactor, double);
  vtkGetMacro(WeightFactor, double);
  ///@}

  ///@{
  /**
   * Set/Get whether the cells have two more cell arrays: Area (vtkDoubleArray) and Centroid
   * (vtkDoubleArray, a position in space). Off by default.
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
  ///@}

  ///@{
  /**
   * Get the number of points that the last run found hidden and of the
   * cells that it left out for the filter's settings; the sums for several blocks.
   */
  vtkIdType GetNumberOfHiddenPoints() { return this->Report.NumberOfHiddenPoints; }
  vtkIdType GetNumberOfDroppedCells() { return this->Report.NumberOfDroppedCells; }
  ///@}

  /**
   * The time of the last change, also of the transform.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkFFPlanarAlgorithm();
  ~vtkFFPlanarAlgorithm() override;

  /// Nothing is known of threads in a transform that somebody else wrote.
  bool IsConcurrent() const override { return this->ProjectionPlaneMode != TRANSFORM_PLANE; }

  int ProjectionPlaneMode = XY_PLANE;
  vtkAbstractTransform* Transform = nullptr;
  int WeightMode = WEIGHTS;
  double WeightFactor = 1.0;
  bool GenerateCellMeasures = false;

private:
  vtkFFPlanarAlgorithm(const vtkFFPlanarAlgorithm&) = delete;
  void operator=(const vtkFFPlanarAlgorithm&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
