// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFPointInterpolator2D
 * @brief   point data between points in the plane, by their triangulation
 *
 * vtkFFPointInterpolator2D gives the points of its input (port 0) values from a source (port 1):
 * points with point data. It is used as vtkPointInterpolator2D is: x and y of all points count, z
 * does not. Between the points of the source, values are interpolated over their Delaunay
 * triangulation. If weights are chosen, it is their regular triangulation, as
 * vtkFFRegularTriangulationFilter gives it:
 *
 *     filter->SetInputArrayToProcess(
 *       0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "weights");
 *
 * There are three ways to interpolate (see SetInterpolationMode()). All give a source point's own
 * value at its place, and reproduce linear functions up to rounding. Which triangle a point is in
 * is decided exactly, so the values do not depend on a tolerance, a radius, or a number of
 * neighbours.
 *
 * The output is a shallow copy of the input with these point arrays, which take the place of the
 * input's arrays of the same names:
 *
 * - each point array of numbers of the source: as float if it is float,
 *   otherwise as double. Left out are vtkGhostType, global and pedigree
 *   ids, and excluded arrays (see AddExcludedArray()). Integers that no
 *   double holds are rounded.
 * - Elevation: the z of the source's points, if InterpolateZ is on, and
 *   if the source has no array of that name
 * - vtkValidPointMask (vtkCharArray): 1 for points that have values, 0
 *   for null points, if NullPointsStrategy is MASK_POINTS
 *
 * The source's active scalars, vectors, tensors and texture coordinates are active in the output.
 *
 * The points of a vtkImageData along the axes are found by triangles, which is much faster. Their
 * values are those that they have as points, bit for bit.
 *
 * A null point is one outside the convex hull of the source's points, where nothing can be
 * interpolated; see SetNullPointsStrategy(). If the source's points are on a line, so is their
 * hull. If the source has no points, all are null. So is a point that is not finite, if such points
 * are ignored.
 *
 * Source points that are hidden have no part in it: of points at one position, that of the greatest
 * weight counts, then that of the lowest id.
 *
 * @warning
 * At most 2^32 - 2 points can be given, about 5e8 in the source.
 *
 * @sa
 * vtkFFQueryAlgorithm vtkFFRegularTriangulationFilter vtkPointInterpolator2D vtkProbeFilter
 */

#ifndef vtkFFPointInterpolator2D_h
#define vtkFFPointInterpolator2D_h

#include "vtkFFMarks.h" // For VTK_MARSHALAUTO
#include "vtkFFQueryAlgorithm.h"
#include "vtkFiltersFlipFlopModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For std::vector

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithmOutput;
class vtkDataObject;
class vtkFFRun;
struct vtkFFPreparedSource;

class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFPointInterpolator2D
  : public vtkFFQueryAlgorithm
{
public:
  //@{
  /**
   * Standard methods for instantiation, type information and printing.
   */
  static vtkFFPointInterpolator2D* New();
  vtkTypeMacro(vtkFFPointInterpolator2D, vtkFFQueryAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  //@}

  /**
   * How values are interpolated.
   */
  enum InterpolationModeType
  {
    LINEAR = 0,
    NATURAL_NEIGHBOR = 1,
    CLOUGH_TOCHER = 2
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
   * What to do at points where nothing can be interpolated. The values are those of
   * vtkPointInterpolator.
   */
  enum Strategy
  {
    MASK_POINTS = 0,
    NULL_VALUE = 1,
    CLOSEST_POINT = 2
  };

  //@{
  /**
   * Set/Get the source (the input of port 1): points with point data.
   */
  void SetSourceData(vtkDataObject* source);
  void SetSourceConnection(vtkAlgorithmOutput* output);
  vtkDataObject* GetSource();
  //@}

  //@{
  /**
   * Set/Get how values are interpolated.
   *
   * - LINEAR (the default): linearly over each triangle
   * - NATURAL_NEIGHBOR: by natural neighbours (Sibson). Values are
   *   smooth but at the source's points, and do not depend on how points
   *   of one circle are cut into triangles. It takes longer. (With
   *   weights, values are continuous.)
   * - CLOUGH_TOCHER: by a surface of cubic pieces over each triangle,
   *   with gradients that are estimated from the values around. Values
   *   and gradients are continuous. On smooth functions its error is the
   *   least; where values jump, it swings beyond them.
   */
  virtual void SetInterpolationMode(int mode)
  {
    this->ChangeOutput(
      this->InterpolationMode, vtkMath::ClampValue<int>(mode, LINEAR, CLOUGH_TOCHER));
  }
  vtkGetMacro(InterpolationMode, int);
  //@}

  //@{
  /**
   * Set/Get what the values of the weights' array are, WEIGHTS (the default) or RADII, and their
   * factor (1 by default), as for vtkFFPlanarAlgorithm. Without an array, they do not matter.
   */
  virtual void SetWeightMode(int mode)
  {
    this->ChangeOutput(this->WeightMode, vtkMath::ClampValue<int>(mode, WEIGHTS, RADII));
  }
  vtkGetMacro(WeightMode, int);
  virtual void SetWeightFactor(double value) { this->ChangeOutput(this->WeightFactor, value); }
  vtkGetMacro(WeightFactor, double);
  //@}

  //@{
  /**
   * Set/Get what null points get.
   *
   * - MASK_POINTS (the default): NullValue, and the mask array tells
   *   which points these are
   * - NULL_VALUE: NullValue. This is vtkPointInterpolator's default.
   * - CLOSEST_POINT: the values of the closest point of the source (with
   *   weights, by power distance). Points have NullValue only if there
   *   is none, or if they are not finite.
   */
  virtual void SetNullPointsStrategy(int mode)
  {
    this->ChangeOutput(
      this->NullPointsStrategy, vtkMath::ClampValue<int>(mode, MASK_POINTS, CLOSEST_POINT));
  }
  vtkGetMacro(NullPointsStrategy, int);
  //@}

  //@{
  /**
   * Set/Get the value of all components at null points (0 by default; NaN is possible), and the
   * name of the mask array ("vtkValidPointMask" by default).
   */
  virtual void SetNullValue(double value) { this->ChangeOutput(this->NullValue, value); }
  vtkGetMacro(NullValue, double);
  virtual void SetValidPointsMaskArrayName(std::string name)
  {
    this->ChangeOutput(this->ValidPointsMaskArrayName, name);
  }
  vtkGetMacro(ValidPointsMaskArrayName, std::string);
  //@}

  //@{
  /**
   * Set/Get whether the z of the source's points is interpolated, too (on by default), and the name
   * of its array ("Elevation" by default).
   */
  virtual void SetInterpolateZ(bool on) { this->ChangeOutput(this->InterpolateZ, on); }
  vtkGetMacro(InterpolateZ, bool);
  virtual void SetZArrayName(std::string name) { this->ChangeOutput(this->ZArrayName, name); }
  vtkGetMacro(ZArrayName, std::string);
  //@}

  //@{
  /**
   * Name an array of the source that is not interpolated, or remove all such names.
   */
  void AddExcludedArray(const char* name);
  void ClearExcludedArrays();
  //@}

  //@{
  /**
   * Set/Get whether the input's point data, cell data and field data are passed to the output. On
   * by default.
   */
  virtual void SetPassPointArrays(bool on) { this->ChangeOutput(this->PassPointArrays, on); }
  vtkGetMacro(PassPointArrays, bool);
  virtual void SetPassCellArrays(bool on) { this->ChangeOutput(this->PassCellArrays, on); }
  vtkGetMacro(PassCellArrays, bool);
  virtual void SetPassFieldArrays(bool on) { this->ChangeOutput(this->PassFieldArrays, on); }
  vtkGetMacro(PassFieldArrays, bool);
  //@}

protected:
  vtkFFPointInterpolator2D();
  ~vtkFFPointInterpolator2D() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int InterpolationMode = LINEAR;
  int WeightMode = WEIGHTS;
  double WeightFactor = 1.0;
  int NullPointsStrategy = MASK_POINTS;
  double NullValue = 0.0;
  std::string ValidPointsMaskArrayName = "vtkValidPointMask";
  bool InterpolateZ = true;
  std::string ZArrayName = "Elevation";
  std::vector<std::string> ExcludedArrays;
  bool PassPointArrays = true;
  bool PassCellArrays = true;
  bool PassFieldArrays = true;

private:
  vtkFFPointInterpolator2D(const vtkFFPointInterpolator2D&) = delete;
  void operator=(const vtkFFPointInterpolator2D&) = delete;

  /// Unless it is there already. Returns the share of the progress that it took.
  double Prepare(vtkDataObject* source, vtkFFRun& run);

  std::unique_ptr<vtkFFPreparedSource> Prepared; ///< null: there is none
};
VTK_ABI_NAMESPACE_END

#endif
