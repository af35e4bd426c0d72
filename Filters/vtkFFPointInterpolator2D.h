// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFPointInterpolator2D
 * @brief   point data between points in the plane, by their triangulation
 *
 * vtkFFPointInterpolator2D gives the points of its input (port 0) values from a source (port 1):
 * points with point data. It is used as vtkPointInterpolator2D is: x and y count, z does not.
 * Between the points of the source, values are interpolated over their Delaunay triangulation; if
 * weights are chosen, over their regular triangulation, of which hidden points are no part. (As for
 * vtkFFPlanarAlgorithm, but SetInputArrayToProcess() takes port 1.) Which triangle a point is in is
 * decided exactly. At most 2^32 - 2 points can be given, about 5e8 in the source.
 *
 * The output is a shallow copy of the input with these point arrays, instead of those of its names:
 *
 * - each point array of numbers of the source, as float if it is float,
 *   otherwise as double, but vtkGhostType, global and pedigree ids, and
 *   excluded arrays. Integers that no double holds are rounded. Active
 *   scalars, vectors, tensors and texture coordinates stay so.
 * - Elevation: see SetInterpolateZ()
 * - vtkValidPointMask: see SetNullPointsStrategy()
 *
 * A null point is one outside the convex hull of the source's points, where nothing can be
 * interpolated: of points on a line, off the line. So is a point that is not finite, if such points
 * are ignored. Points of a vtkImageData along the axes have the same bits much faster.
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
class FFInterpolatedData;
class FFRun;

class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFPointInterpolator2D
  : public vtkFFQueryAlgorithm
{
public:
  ///@{
  /// Standard methods for instantiation, type information and printing.
  static vtkFFPointInterpolator2D* New();
  vtkTypeMacro(vtkFFPointInterpolator2D, vtkFFQueryAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /// How values are interpolated.
  enum InterpolationModeType
  {
    LINEAR = 0,
    NATURAL_NEIGHBOR = 1,
    CLOUGH_TOCHER = 2
  };

  /// What the values of the weights' array are.
  enum WeightModeType
  {
    WEIGHTS = 0,
    RADII = 1
  };

  /// What null points get. The values are those of vtkPointInterpolator.
  enum Strategy
  {
    MASK_POINTS = 0,
    NULL_VALUE = 1,
    CLOSEST_POINT = 2
  };

  ///@{
  /**
   * Set/Get the source (the input of port 1): points with point data.
   */
  void SetSourceData(vtkDataObject* source) { this->SetInputData(1, source); }
  void SetSourceConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  vtkDataObject* GetSource() { return this->GetSecondInput(); }
  ///@}

  ///@{
  /**
   * Set/Get how values are interpolated. All modes give a source point's own value at its place,
   * and reproduce linear functions up to rounding.
   *
   * - LINEAR (the default): linearly over each triangle
   * - NATURAL_NEIGHBOR: by natural neighbours (R. Sibson, 1981).
   *   Values are smooth but at the source's points, and do not depend
   *   on how points of one circle are cut into triangles. It takes
   *   longer. (With weights, values are continuous.)
   * - CLOUGH_TOCHER: by a surface of cubic pieces over each triangle,
   *   with gradients that are estimated from the values around. Values
   *   and gradients are continuous. On smooth functions its error is the
   *   least; where values jump, it swings beyond them.
   */
  vtkSetClampMacro(InterpolationMode, int, LINEAR, CLOUGH_TOCHER);
  vtkGetMacro(InterpolationMode, int);
  void SetInterpolationModeToLinear() { this->SetInterpolationMode(LINEAR); }
  void SetInterpolationModeToNaturalNeighbor() { this->SetInterpolationMode(NATURAL_NEIGHBOR); }
  void SetInterpolationModeToCloughTocher() { this->SetInterpolationMode(CLOUGH_TOCHER); }
  ///@}

  ///@{
  /**
   * Set/Get what the values of the weights' array are, WEIGHTS (the default) or RADII, and their
   * factor (1 by default), as for vtkFFPlanarAlgorithm. Without an array, they do not matter.
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
   * Set/Get what null points get: NullValue, and a mask array that is 0 there and 1 elsewhere
   * (MASK_POINTS, the default); NullValue (NULL_VALUE, vtkPointInterpolator's default); or the
   * values of the closest point of the source, with weights by power distance, and NullValue if
   * there is none, or the null point is not finite (CLOSEST_POINT). The value is 0 by default, in
   * all components (NaN is possible), the name of the mask array "vtkValidPointMask".
   */
  vtkSetClampMacro(NullPointsStrategy, int, MASK_POINTS, CLOSEST_POINT);
  vtkGetMacro(NullPointsStrategy, int);
  void SetNullPointsStrategyToMaskPoints() { this->SetNullPointsStrategy(MASK_POINTS); }
  void SetNullPointsStrategyToNullValue() { this->SetNullPointsStrategy(NULL_VALUE); }
  void SetNullPointsStrategyToClosestPoint() { this->SetNullPointsStrategy(CLOSEST_POINT); }
  vtkSetMacro(NullValue, double);
  vtkGetMacro(NullValue, double);
  vtkSetMacro(ValidPointsMaskArrayName, std::string);
  vtkGetMacro(ValidPointsMaskArrayName, std::string);
  ///@}

  ///@{
  /**
   * Set/Get whether the z of the source's points is interpolated, too (on by default), and the name
   * of its array ("Elevation" by default); not if the source has an array of that name.
   */
  vtkSetMacro(InterpolateZ, bool);
  vtkGetMacro(InterpolateZ, bool);
  vtkBooleanMacro(InterpolateZ, bool);
  vtkSetMacro(ZArrayName, std::string);
  vtkGetMacro(ZArrayName, std::string);
  ///@}

  ///@{
  /// Name an array of the source that is not interpolated, or remove all such names.
  void AddExcludedArray(const char* name);
  void ClearExcludedArrays();
  ///@}

  ///@{
  /**
   * Set/Get whether the input's point data, cell data and field data are passed. On by default.
   */
  vtkSetMacro(PassPointArrays, bool);
  vtkGetMacro(PassPointArrays, bool);
  vtkBooleanMacro(PassPointArrays, bool);
  vtkSetMacro(PassCellArrays, bool);
  vtkGetMacro(PassCellArrays, bool);
  vtkBooleanMacro(PassCellArrays, bool);
  vtkSetMacro(PassFieldArrays, bool);
  vtkGetMacro(PassFieldArrays, bool);
  vtkBooleanMacro(PassFieldArrays, bool);
  ///@}

protected:
  vtkFFPointInterpolator2D();
  ~vtkFFPointInterpolator2D() override;

  double Prepare(vtkDataObject* source, FFRun& run) override;
  void Execute(vtkDataObject* data, vtkDataSet* result, FFRun& run) override;
  const char* GetTitle() const override { return "Point interpolation"; }

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

  std::unique_ptr<const FFInterpolatedData> Prepared; ///< null: there is none
  int PreparedDimension = -1;
};
VTK_ABI_NAMESPACE_END

#endif
