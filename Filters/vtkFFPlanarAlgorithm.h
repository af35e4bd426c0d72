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
 * By default there is no array, and all points weigh the same; so too by an empty name, and by the
 * name None if no array has it. A weight is a squared length and may be negative: the power
 * distance of x from a point p of weight w is |x - p|^2 - w, so a disk of radius r has the weight
 * r^2. Adding the same number to all weights changes nothing.
 *
 * An array that has no numbers, or not one for each point, is an error that names it. Without
 * points, no weights are needed. A point is not finite if its weight or any coordinate is NaN or
 * infinite, also z if z does not matter.
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
  /// Standard methods for type information and printing.
  vtkAbstractTypeMacro(vtkFFPlanarAlgorithm, vtkFFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /// The plane in which points are triangulated. The values are those of vtkDelaunay2D.
  enum ProjectionPlaneModeType
  {
    XY_PLANE = 0,
    TRANSFORM_PLANE = 1,
    BEST_FITTING_PLANE = 2
  };

  /// What the values of the weights' array are.
  enum WeightModeType
  {
    WEIGHTS = 0,
    RADII = 1
  };

  // What sets a mode as well comes before that mode: VTK reads a state back in this order, so that
  // the mode is the one that was written.

  ///@{
  /**
   * Set/Get the transform that takes the points to the XY plane. None by default, which is an error
   * for TRANSFORM_PLANE. SetTransform() with a transform also sets that mode; StoreTransform() does
   * not: it is for applications that set all properties.
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
   * - XY_PLANE (the default): z is left out; nothing is copied or
   *   rounded.
   * - TRANSFORM_PLANE: the points are transformed by Transform, and z
   *   is left out. Weights are squared lengths after the transform.
   * - BEST_FITTING_PLANE: the points are projected to the plane
   *   through their centroid with the least sum of squared distances.
   *   All finite points count the same. The normal's component of
   *   largest magnitude (of several the last) is positive; seen from
   *   its tip, triangles are counter-clockwise. Positions in the plane
   *   are measured from the first finite point, along x projected into
   *   the plane if the normal is mostly along z, y if along x, z if
   *   along y.
   *
   * In the latter two modes, the triangulation is exact for the projected positions, which are
   * rounded to double, the same in each run.
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
   * Set/Get what the values v of the weights' array are, and their factor f (1 by default, finite;
   * it may be negative or 0). Without an array, neither matters.
   *
   * - WEIGHTS (the default): the weight is f * v, rounded once.
   * - RADII: the weight is s * s of the double s = f * v. A negative
   *   radius is an error.
   *
   * So the weights are the same bits as in C++ or NumPy, and the result is exact for them. A weight
   * that is too large for a double, though the value is finite, is an error.
   */
  vtkSetClampMacro(WeightMode, int, WEIGHTS, RADII);
  vtkGetMacro(WeightMode, int);
  void SetWeightModeToWeights() { this->SetWeightMode(WEIGHTS); }
  void SetWeightModeToRadii() { this->SetWeightMode(RADII); }
  vtkSetMacro(WeightFactor, double);
  vtkGetMacro(WeightFactor, double);
  ///@}

  ///@{
  /**
   * Set/Get whether cells have the cell arrays Area and Centroid (a position in space), both
   * vtkDoubleArray. Off by default. Lines and vertices have the area 0, and their middle.
   *
   * Both are measured in the plane of the triangulation, after a transform. Centroids lie in it: at
   * the points' lowest z for XY_PLANE, or where the inverse transform takes z = 0; without an
   * inverse, that is an error. An area is off by no more than 2^-50 of itself; of a power cell that
   * rounding made concave, of the fan from the first corner.
   */
  vtkSetMacro(GenerateCellMeasures, bool);
  vtkGetMacro(GenerateCellMeasures, bool);
  vtkBooleanMacro(GenerateCellMeasures, bool);
  ///@}

  ///@{
  /**
   * Get how many points the last run found hidden, and how many cells it left out for the filter's
   * settings; of several blocks the sums.
   */
  vtkIdType GetNumberOfHiddenPoints() { return this->Report.NumberOfHiddenPoints; }
  vtkIdType GetNumberOfDroppedCells() { return this->Report.NumberOfDroppedCells; }
  ///@}

  vtkMTimeType GetMTime() override; ///< the last change, also of the transform

protected:
  vtkFFPlanarAlgorithm() = default;
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
