// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFPowerDiagramFilter
 * @brief   the exact Voronoi or power diagram of points in the plane
 *
 * vtkFFPowerDiagramFilter computes the power diagram of points, clipped to a box: the dual of the
 * triangulation that vtkFFRegularTriangulationFilter gives. Without weights, it is the Voronoi
 * diagram. vtkFFPlanarAlgorithm says how to give weights. Cells of the input are ignored.
 *
 * The output has one polygon for each point whose region meets the inside of the box, by ascending
 * id. Neighbours share their corners, and points of one power circle meet in one corner. The choice
 * of the regions that meet is exact; the corners' coordinates are rounded. The input's point data
 * and vtkOriginalPointIds (a vtkIdTypeArray) are cell data, with marks for cells in vtkGhostType.
 *
 * Corners lie in the plane of the triangulation, as vtkFFPlanarAlgorithm says of centroids. There
 * the rounded cells are simple polygons, counter-clockwise, that fill the box edge to edge without
 * gap or overlap, exactly. They are convex except for rounding: a corner may turn the other way by
 * a few units in the last place. Cells that have no inside after rounding are missing. Corners
 * within a few units of each other may be merged if a cell would otherwise not be simple or convex.
 * (Fitted planes and transforms round the corners once more on the way back into space.)
 *
 * No point: empty. Points at one position: the region of one of them is the box. The reported
 * seconds and statistics are the triangulation's.
 *
 * @sa
 * vtkFFPlanarAlgorithm vtkFFRegularTriangulationFilter vtkVoronoi2D
 */

#ifndef vtkFFPowerDiagramFilter_h
#define vtkFFPowerDiagramFilter_h

#include "vtkFFMarks.h" // For VTK_MARSHALAUTO
#include "vtkFFPlanarAlgorithm.h"
#include "vtkFiltersFlipFlopModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFPowerDiagramFilter
  : public vtkFFPlanarAlgorithm
{
public:
  ///@{
  /// Standard methods for instantiation, type information and printing.
  static vtkFFPowerDiagramFilter* New();
  vtkTypeMacro(vtkFFPowerDiagramFilter, vtkFFPlanarAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /// The box to which the power diagram is clipped.
  enum PowerDiagramBoxModeType
  {
    BOX_OF_POINTS = 0,
    BOX_OF_BOUNDS = 1
  };

  ///@{
  /**
   * Set/Get the box of BOX_OF_BOUNDS, (xmin, xmax, ymin, ymax) in the plane: of x and y, of the
   * transformed points, or measured in the fitted plane. (0, 1, 0, 1) by default. One that is not
   * finite or has no inside is an error. SetPowerDiagramBounds() also sets that mode. The others do
   * not: they are for applications that set all properties, in any order, or whose users move a box
   * in space, by its least corner and its lengths; z does not count.
   */
  virtual void SetPowerDiagramBounds(double xmin, double xmax, double ymin, double ymax);
  virtual void SetPowerDiagramBounds(const double bounds[4]);
  void StorePowerDiagramBounds(double xmin, double xmax, double ymin, double ymax);
  void StorePowerDiagramCorner(double x, double y, double z);
  void StorePowerDiagramLengths(double x, double y, double z);
  vtkGetVector4Macro(PowerDiagramBounds, double);
  ///@}

  ///@{
  /**
   * Set/Get the box to which the power diagram is clipped: the bounds of the points in the plane
   * (BOX_OF_POINTS, the default), or PowerDiagramBounds (BOX_OF_BOUNDS). If the points have no
   * extent along x or y, the box has the extent of the other direction, half of it on either side.
   * A single position gets a box of side 1.
   */
  vtkSetClampMacro(PowerDiagramBoxMode, int, BOX_OF_POINTS, BOX_OF_BOUNDS);
  vtkGetMacro(PowerDiagramBoxMode, int);
  void SetPowerDiagramBoxModeToBoxOfPoints() { this->SetPowerDiagramBoxMode(BOX_OF_POINTS); }
  void SetPowerDiagramBoxModeToBoxOfBounds() { this->SetPowerDiagramBoxMode(BOX_OF_BOUNDS); }
  ///@}

protected:
  vtkFFPowerDiagramFilter() = default;
  ~vtkFFPowerDiagramFilter() override = default;

  void Execute(vtkDataObject* data, vtkInformationVector** inputVector,
    const std::vector<vtkDataObject*>& results, FFRun& run) override;
  const char* GetTitle() const override { return "Power diagram"; }

  int PowerDiagramBoxMode = BOX_OF_POINTS;
  double PowerDiagramBounds[4] = { 0.0, 1.0, 0.0, 1.0 };
  double PowerDiagramLengths[2] = { 1.0, 1.0 };

private:
  vtkFFPowerDiagramFilter(const vtkFFPowerDiagramFilter&) = delete;
  void operator=(const vtkFFPowerDiagramFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
