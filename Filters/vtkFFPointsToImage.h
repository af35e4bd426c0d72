// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFPointsToImage
 * @brief   an image (raster) of point data, by the points' triangulation
 *
 * vtkFFPointsToImage makes a vtkImageData of one layer from points with point data. Between the
 * points, values are interpolated over their Delaunay triangulation in a plane; if weights are
 * chosen, over their regular triangulation: see vtkFFPlanarAlgorithm. Cells of the input are
 * ignored. Which triangle a pixel is in is decided exactly. The values are those of
 * vtkFFPointInterpolator2D at the image's points, bit for bit, and those of Python's to_image(),
 * whose rows are counted from the other end, where that rounds nothing.
 *
 * The image has the point arrays that vtkFFPointInterpolator2D makes of this source; those of the
 * points' data if PassPointData is on. SetFacetMode(), SetVisiblePointIds() and
 * SetGenerateCellMeasures() have no effect.
 *
 * The points of the image are the centers of its pixels. With x along columns and y along rows, the
 * image is at z = 0 for XY_PLANE, and in the transform's coordinates for TRANSFORM_PLANE. For
 * BEST_FITTING_PLANE, it lies in that plane, by its direction matrix.
 *
 * A null pixel is one outside the convex hull of the points, or outside the polygons of the source,
 * where nothing can be interpolated. Without a point, the output is empty, or of bounds that are
 * given has null pixels alone.
 *
 * The whole extent is known before the data by dimensions, and by a spacing if the bounds are
 * given. Otherwise it is empty until the filter has run.
 *
 * @sa
 * vtkFFPointInterpolator2D vtkFFPlanarAlgorithm vtkFFRegularTriangulationFilter vtkResampleToImage
 */

#ifndef vtkFFPointsToImage_h
#define vtkFFPointsToImage_h

#include "vtkFFMarks.h" // For VTK_MARSHALAUTO
#include "vtkFFPlanarAlgorithm.h"
#include "vtkFiltersFlipFlopModule.h" // For export macro

#include <string> // For std::string

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithmOutput;
class vtkImageData;

class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFPointsToImage : public vtkFFPlanarAlgorithm
{
public:
  ///@{
  /// Standard methods for instantiation, type information and printing.
  static vtkFFPointsToImage* New();
  vtkTypeMacro(vtkFFPointsToImage, vtkFFPlanarAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /// What the size of the image is given by.
  enum SizeModeType
  {
    SIZE_BY_DIMENSIONS = 0,
    SIZE_BY_SPACING = 1
  };

  /// How values are interpolated, as vtkFFPointInterpolator2D.
  enum InterpolationModeType
  {
    LINEAR = 0,
    NATURAL_NEIGHBOR = 1,
    CLOUGH_TOCHER = 2
  };

  /// What null pixels get, as vtkFFPointInterpolator2D.
  enum Strategy
  {
    MASK_POINTS = 0,
    NULL_VALUE = 1,
    CLOSEST_POINT = 2
  };

  ///@{
  /**
   * Get the output; its type is not that of the superclass.
   */
  vtkImageData* GetOutput() { return this->GetOutput(0); }
  vtkImageData* GetOutput(int port);
  ///@}

  ///@{
  /**
   * Set/Get the second input, on port 1: breaklines, as lines and polygons whose sides are edges of
   * the triangulation. Polygons keep what is inside by the even-odd rule. None by default. Their
   * point ids are those of the input. The source has no points, or at the ids that its cells name
   * those of the input; for XY_PLANE, z may differ. With a source, weights, the CUDA engine,
   * NATURAL_NEIGHBOR and CLOSEST_POINT are errors. So are breaklines that cross between points: the
   * outputs 0 and 3 of vtkFFRegularTriangulationFilter, which splits them and takes points of their
   * own, are such a pair of inputs.
   */
  void SetSourceData(vtkDataObject* source) { this->SetInputData(1, source); }
  void SetSourceConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void RemoveSource() { this->SetSourceConnection(nullptr); }
  vtkDataObject* GetSource() { return this->GetSecondInput(); }
  ///@}

  ///@{
  /**
   * Set/Get what the size of the image is given by: the numbers of pixels, which divide the bounds
   * (SIZE_BY_DIMENSIONS, the default), or the lengths of a pixel (SIZE_BY_SPACING). Then pixels
   * begin at the least x and at the greatest y of the bounds; as many as cover these, but for a
   * millionth of a pixel, as rounding leaves it.
   */
  vtkSetClampMacro(SizeMode, int, SIZE_BY_DIMENSIONS, SIZE_BY_SPACING);
  vtkGetMacro(SizeMode, int);
  void SetSizeModeByDimensions() { this->SetSizeMode(SIZE_BY_DIMENSIONS); }
  void SetSizeModeBySpacing() { this->SetSizeMode(SIZE_BY_SPACING); }
  ///@}

  ///@{
  /**
   * Set/Get the numbers of pixels along x and y, for SIZE_BY_DIMENSIONS: (256, 256) by default; one
   * below 1 is an error. And the lengths of a pixel along x and y, in the unit of the points'
   * coordinates, for SIZE_BY_SPACING: (1, 1) by default; one that is not finite, not above 0 or
   * makes more than 2^31 - 1 pixels is an error.
   */
  vtkSetVector2Macro(Dimensions, int);
  vtkGetVector2Macro(Dimensions, int);
  vtkSetVector2Macro(Spacing, double);
  vtkGetVector2Macro(Spacing, double);
  ///@}

  ///@{
  /**
   * Set/Get whether the image's bounds, the outer sides of the outer pixels, are those of the
   * points that appear in the triangulation, in the plane. On by default. If these have no extent
   * along x or y, the bounds have the extent of the other direction, half of it on either side. A
   * single position gets bounds of side 1.
   *
   * If off, they are SamplingBounds, (xmin, xmax, ymin, ymax) in the plane: (0, 1, 0, 1) by
   * default. What is not finite or has no inside is an error.
   */
  vtkSetMacro(UseInputBounds, bool);
  vtkGetMacro(UseInputBounds, bool);
  vtkBooleanMacro(UseInputBounds, bool);
  vtkSetVector4Macro(SamplingBounds, double);
  vtkGetVector4Macro(SamplingBounds, double);
  ///@}

  ///@{
  /**
   * Set/Get how values are interpolated: LINEAR (the default), NATURAL_NEIGHBOR or CLOUGH_TOCHER,
   * as vtkFFPointInterpolator2D::SetInterpolationMode() says.
   */
  vtkSetClampMacro(InterpolationMode, int, LINEAR, CLOUGH_TOCHER);
  vtkGetMacro(InterpolationMode, int);
  void SetInterpolationModeToLinear() { this->SetInterpolationMode(LINEAR); }
  void SetInterpolationModeToNaturalNeighbor() { this->SetInterpolationMode(NATURAL_NEIGHBOR); }
  void SetInterpolationModeToCloughTocher() { this->SetInterpolationMode(CLOUGH_TOCHER); }
  ///@}

  ///@{
  /**
   * Set/Get what null pixels get, MASK_POINTS by default; the value of all components there (NaN by
   * default); and the name of the mask array ("vtkValidPointMask" by default), all as
   * vtkFFPointInterpolator2D::SetNullPointsStrategy() says.
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
   * Set/Get whether the z of the input's points is interpolated, too (on by default), and the name
   * of its array ("Elevation" by default); not if the input has an array of that name.
   */
  vtkSetMacro(InterpolateZ, bool);
  vtkGetMacro(InterpolateZ, bool);
  vtkBooleanMacro(InterpolateZ, bool);
  vtkSetMacro(ZArrayName, std::string);
  vtkGetMacro(ZArrayName, std::string);
  ///@}

protected:
  vtkFFPointsToImage();
  ~vtkFFPointsToImage() override = default;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void Execute(vtkDataObject* data, vtkInformationVector** inputVector,
    const std::vector<vtkDataObject*>& results, FFRun& run) override;
  const char* GetTitle() const override { return "Image of points"; }
  const char* GetResultType() const override { return "vtkImageData"; }
  bool IsConcurrent() const override { return false; } ///< few points can have many pixels

  int SizeMode = SIZE_BY_DIMENSIONS;
  int Dimensions[2] = { 256, 256 };
  double Spacing[2] = { 1.0, 1.0 };
  bool UseInputBounds = true;
  double SamplingBounds[4] = { 0.0, 1.0, 0.0, 1.0 };
  int InterpolationMode = LINEAR;
  int NullPointsStrategy = MASK_POINTS;
  double NullValue; ///< NaN: see the constructor
  std::string ValidPointsMaskArrayName = "vtkValidPointMask";
  bool InterpolateZ = true;
  std::string ZArrayName = "Elevation";

private:
  vtkFFPointsToImage(const vtkFFPointsToImage&) = delete;
  void operator=(const vtkFFPointsToImage&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
