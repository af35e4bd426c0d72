// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFMeshFilter
 * @brief   a mesh of polygons and lines, without small angles, for finite elements
 *
 * vtkFFMeshFilter triangulates, by x and y, what is inside of the polygons of a vtkPolyData;
 * without polygons, what its lines enclose; where they enclose nothing, the convex hull of its
 * points. Lines inside become edges, and points inside vertices. Points are added until no triangle
 * has a smaller angle, or a larger area, than is asked for (J. Ruppert, 1995; L. P. Chew, 1993; A.
 * Uengoer, 2004). Angles and areas are compared exactly. Where sides and lines meet at less than 60
 * degrees, triangles between them may be as thin as that angle makes them.
 *
 * The mesh is bit for bit the constrained Delaunay triangulation of its points and edges. A point
 * that divides a side is rounded: the side bends there by the last bits. Its z and its point data
 * are interpolated along the side; those of a point inside, over a triangle of the input's points.
 * Added points have -1 in vtkOriginalPointIds.
 *
 * Port 0 has the triangles, and their points alone. Its cell arrays are Region (a vtkIdTypeArray),
 * MinimumAngle, in degrees, and Area (vtkDoubleArrays). Port 1 has a line for each edge of a
 * triangle that a line or a side runs along, with the points of port 0 and the cell array
 * ConstraintCellIds (a vtkIdTypeArray): the first such cell, -1 on the convex hull.
 *
 * SetInputArrayToProcess() sets at index 0 a point array of sizes: greatest areas, above 0; a
 * triangle has that at its centroid, linear between the input's points. By default there is none.
 * The CPU engine does the work; asking for the CUDA engine is an error.
 *
 * @sa
 * vtkFFRegularTriangulationFilter vtkDelaunay2D
 */

#ifndef vtkFFMeshFilter_h
#define vtkFFMeshFilter_h

#include "vtkFFAlgorithm.h"
#include "vtkFFMarks.h"               // For VTK_MARSHALAUTO
#include "vtkFiltersFlipFlopModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithmOutput;

class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFMeshFilter : public vtkFFAlgorithm
{
public:
  ///@{
  /// Standard methods for instantiation, type information and printing.
  static vtkFFMeshFilter* New();
  vtkTypeMacro(vtkFFMeshFilter, vtkFFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /// How the polygons define what is inside.
  enum PolygonRuleType
  {
    EVEN_ODD = 0,
    DIRECTION = 1
  };

  ///@{
  /**
   * Set/Get the least angle of a triangle, in degrees. 25 by default, 34 at most; up to 20.7 the
   * refinement is proven to end, to 30 it does in practice.
   */
  vtkSetMacro(MinimumAngle, double);
  vtkGetMacro(MinimumAngle, double);
  ///@}

  ///@{
  /**
   * Set/Get the greatest area of a triangle. 0 by default: any. A negative number and NaN are
   * errors.
   */
  vtkSetMacro(MaximumArea, double);
  vtkGetMacro(MaximumArea, double);
  ///@}

  ///@{
  /**
   * Set/Get how many points may be added; then the mesh is not finished, and a warning says so. 0
   * by default: ten million.
   */
  vtkSetClampMacro(MaximumNumberOfPoints, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfPoints, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get the second input, on port 1: a point in each region, a part that sides and lines
   * enclose. Its id is the region of the part's triangles; others have -1. The point array
   * MaximumArea, if it is there, has a region's greatest area, 0: that of all. None by default. A
   * composite on port 0 is an error then.
   */
  void SetSourceData(vtkDataObject* source) { this->SetInputData(1, source); }
  void SetSourceConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void RemoveSource() { this->SetSourceConnection(nullptr); }
  vtkDataObject* GetSource() { return this->GetSecondInput(); }
  ///@}

  ///@{
  /**
   * Set/Get whether lines and sides are split where they cross between points, how polygons define
   * what is inside, and whether closed lines are polygons, as vtkFFRegularTriangulationFilter does.
   * Off, EVEN_ODD and off by default.
   */
  vtkSetMacro(SplitCrossingConstraints, bool);
  vtkGetMacro(SplitCrossingConstraints, bool);
  vtkBooleanMacro(SplitCrossingConstraints, bool);
  vtkSetClampMacro(PolygonRule, int, EVEN_ODD, DIRECTION);
  vtkGetMacro(PolygonRule, int);
  void SetPolygonRuleToEvenOdd() { this->SetPolygonRule(EVEN_ODD); }
  void SetPolygonRuleToDirection() { this->SetPolygonRule(DIRECTION); }
  vtkSetMacro(ClosedLinesAsBorders, bool);
  vtkGetMacro(ClosedLinesAsBorders, bool);
  vtkBooleanMacro(ClosedLinesAsBorders, bool);
  ///@}

  ///@{
  /**
   * Get of the last run: how many points were added, and how many of these where constraints cross;
   * how many sides were too short to be divided, and how many triangles too near to a vertex. Of
   * several blocks: the sums.
   */
  vtkIdType GetNumberOfAddedPoints() { return this->Report.NumberOfAddedPoints; }
  vtkIdType GetNumberOfSplitPoints() { return this->Report.NumberOfSplitPoints; }
  vtkIdType GetNumberOfKeptSegments() { return this->Report.NumberOfKeptSegments; }
  vtkIdType GetNumberOfKeptTriangles() { return this->Report.NumberOfKeptTriangles; }
  ///@}

protected:
  vtkFFMeshFilter();
  ~vtkFFMeshFilter() override = default;

  void Execute(vtkDataObject* data, vtkInformationVector** inputVector,
    const std::vector<vtkDataObject*>& results, FFRun& run) override;
  const char* GetTitle() const override { return "Mesh"; }

  double MinimumAngle = 25.0;
  double MaximumArea = 0.0;
  vtkIdType MaximumNumberOfPoints = 0;
  bool SplitCrossingConstraints = false;
  int PolygonRule = EVEN_ODD;
  bool ClosedLinesAsBorders = false;

private:
  vtkFFMeshFilter(const vtkFFMeshFilter&) = delete;
  void operator=(const vtkFFMeshFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
