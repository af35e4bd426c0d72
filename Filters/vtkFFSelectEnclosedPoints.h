// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFSelectEnclosedPoints
 * @brief   which points are in the convex hull of others, exactly
 *
 * vtkFFSelectEnclosedPoints tells of each point of its input whether it is inside the convex hull
 * of a surface's points, on it, or outside. It is used as vtkSelectEnclosedPoints is, but the
 * region is the convex hull of the points of the surface, whose cells are ignored.
 *
 * The answer is exact for all finite points: no tolerance decides anything. Points outside the
 * hull's box take a few comparisons, nearly all that are deep inside a look into a table. The
 * others take a short walk over the hull's triangles.
 *
 * The output is a shallow copy of the input with these point arrays:
 *
 * - SelectedPoints (vtkUnsignedCharArray), the active scalars: 1 for points that are selected, 0
 *   for others. Points inside the hull and on its surface are, but see the settings.
 * - FlipFlopSide (vtkSignedCharArray): 1 inside, 0 on the surface, -1 outside
 * - FlipFlopDistance (vtkDoubleArray): see SetGenerateDistances()
 *
 * A hull of dimension 2 or less has no inside: all of its points are on the surface. If there is no
 * point, all is outside, and infinitely far away. Points of the input that are not finite are an
 * error; if they are ignored, they are outside, and their distance is NaN. At most 2^32 - 2 points
 * can be given on either port, and in each data set of a composite.
 *
 * @sa
 * vtkFFQueryAlgorithm vtkFFHullFilter vtkSelectEnclosedPoints
 */

#ifndef vtkFFSelectEnclosedPoints_h
#define vtkFFSelectEnclosedPoints_h

#include "vtkFFMarks.h" // For VTK_MARSHALAUTO
#include "vtkFFQueryAlgorithm.h"
#include "vtkFiltersFlipFlopModule.h" // For export macro

#include <memory> // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithmOutput;
class vtkDataObject;
struct FFPreparedHull;

class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFSelectEnclosedPoints
  : public vtkFFQueryAlgorithm
{
public:
  ///@{
  /// Standard methods for instantiation, type information and printing.
  static vtkFFSelectEnclosedPoints* New();
  vtkTypeMacro(vtkFFSelectEnclosedPoints, vtkFFQueryAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Set/Get the surface (the input of port 1). The convex hull of its points is the region.
   */
  void SetSurfaceData(vtkDataObject* surface) { this->SetInputData(1, surface); }
  void SetSurfaceConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  vtkDataObject* GetSurface() { return this->GetSecondInput(); }
  ///@}

  ///@{
  /**
   * Set/Get whether points on the surface count as enclosed (on by default), and whether the points
   * that are not enclosed are selected instead (off by default).
   */
  vtkSetMacro(InsideOut, bool);
  vtkGetMacro(InsideOut, bool);
  vtkBooleanMacro(InsideOut, bool);
  vtkSetMacro(SelectPointsOnSurface, bool);
  vtkGetMacro(SelectPointsOnSurface, bool);
  vtkBooleanMacro(SelectPointsOnSurface, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether the output has the distance of each point from the surface, negative inside,
   * with the exact sign. Off by default. The value is off by no more than 1e-14 times the distance
   * to the farthest vertex.
   */
  vtkSetMacro(GenerateDistances, bool);
  vtkGetMacro(GenerateDistances, bool);
  vtkBooleanMacro(GenerateDistances, bool);
  ///@}

  /**
   * Whether the last run selected this point of the input (1) or not (0): what its output says, as
   * long as that is there. 0 also for a point that does not exist, and for a composite.
   */
  int IsInside(vtkIdType inputPointId);

  ///@{
  /**
   * Query single points. Initialize() prepares the hull of a surface's points, as a run does.
   * IsInsideSurface() then returns 1 for enclosed points (also those on the surface, unless
   * SelectPointsOnSurface is off), else 0; InsideOut does not matter. Complete() releases the
   * memory. No surface is an error. For many points, a run takes much less time.
   */
  void Initialize(vtkDataObject* surface);
  int IsInsideSurface(const double x[3]);
  int IsInsideSurface(double x, double y, double z)
  {
    const double point[3] = { x, y, z };
    return this->IsInsideSurface(point);
  }
  void Complete();
  ///@}

protected:
  vtkFFSelectEnclosedPoints();
  ~vtkFFSelectEnclosedPoints() override;

  double Prepare(vtkDataObject* surface, FFRun& run) override;
  void Execute(vtkDataObject* data, vtkDataSet* result, FFRun& run) override;
  const char* GetTitle() const override { return "Points in convex hull"; }

  bool InsideOut = false;
  bool SelectPointsOnSurface = true;
  bool GenerateDistances = false;

private:
  vtkFFSelectEnclosedPoints(const vtkFFSelectEnclosedPoints&) = delete;
  void operator=(const vtkFFSelectEnclosedPoints&) = delete;

  bool IsEnclosed(int side) const { return side >= (this->SelectPointsOnSurface ? 0 : 1); }

  std::unique_ptr<const FFPreparedHull> Prepared; ///< null: there is none
};
VTK_ABI_NAMESPACE_END

#endif
