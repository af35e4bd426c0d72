// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFTerrainMeshFilter
 * @brief   a mesh of some of the points, within a vertical tolerance of all
 *
 * vtkFFTerrainMeshFilter makes a small mesh of a terrain: a constrained Delaunay triangulation, in
 * x and y, of some of the points, from which no other point is farther, vertically, than a
 * tolerance. Whether a point is, is decided exactly. The height of a point is z, or its value in
 * the point array that SetInputArrayToProcess() sets at index 0. Cells of the input are ignored.
 *
 * The mesh begins with the corners of the convex hull and the ends of the breaklines. Then the
 * point that is farthest from the surface becomes a vertex (of several, the one of the lowest id),
 * again and again, until all are within the tolerance, or there are as many vertices as are allowed
 * (M. Garland, P. S. Heckbert, "Fast polygonal approximation of terrains and height fields", 1995).
 * The result is bit for bit the triangulation of the points that are kept.
 *
 * Port 0, the mesh, has triangles, or lines where all points are on one line. SetFacetMode() has no
 * effect. Port 1 has a vertex for each point that was not kept, with the array TerrainError (a
 * vtkDoubleArray): how far it is above the mesh, the true number rounded to the nearest double.
 * Both have the point data of their points. Of several points at one position, the one of the
 * lowest id is the vertex. Others there, whose heights differ by more than the tolerance, are
 * counted by GetNumberOfUnreachablePoints(): no vertex helps them.
 *
 * A height that is NaN or infinite is treated like a coordinate: see SetNonFinitePoints(). This
 * filter runs on the CPU engine; asking it for the CUDA engine is an error.
 *
 * @sa
 * vtkFFRegularTriangulationFilter vtkGreedyTerrainDecimation
 */

#ifndef vtkFFTerrainMeshFilter_h
#define vtkFFTerrainMeshFilter_h

#include "vtkFFAlgorithm.h"
#include "vtkFFMarks.h"               // For VTK_MARSHALAUTO
#include "vtkFiltersFlipFlopModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithmOutput;

class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFTerrainMeshFilter : public vtkFFAlgorithm
{
public:
  ///@{
  /// Standard methods for instantiation, type information and printing.
  static vtkFFTerrainMeshFilter* New();
  vtkTypeMacro(vtkFFTerrainMeshFilter, vtkFFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Set/Get the second input, on port 1: breaklines, as vtkFFRegularTriangulationFilter takes its
   * constraints. None by default. Sides of polygons are lines. All are edges of the mesh, parted
   * where a vertex is on them.
   */
  void SetSourceData(vtkDataObject* source) { this->SetInputData(1, source); }
  void SetSourceConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void RemoveSource() { this->SetSourceConnection(nullptr); }
  vtkDataObject* GetSource() { return this->GetSecondInput(); }
  ///@}

  ///@{
  /**
   * Set/Get whose points the cells of the source name, as vtkFFRegularTriangulationFilter says for
   * XY_PLANE, with the same point data, ids and arrays PointOrigin and HeightRange (of heights, at
   * a vertex also by the lines through it). AUTOMATIC_POINTS by default.
   *
   * Own points that cells name are vertices of the mesh, but where a point of the input is, with
   * its own height. Their heights are z, or the values of the source's point array that the choice
   * of heights finds. One that is not finite is an error that names its cell.
   */
  vtkSetClampMacro(SourcePoints, int, AUTOMATIC_POINTS, OWN_POINTS);
  vtkGetMacro(SourcePoints, int);
  void SetSourcePointsToAutomaticPoints() { this->SetSourcePoints(AUTOMATIC_POINTS); }
  void SetSourcePointsToInputPoints() { this->SetSourcePoints(INPUT_POINTS); }
  void SetSourcePointsToOwnPoints() { this->SetSourcePoints(OWN_POINTS); }
  ///@}

  ///@{
  /**
   * Set/Get whether breaklines are split where they cross between points, as
   * vtkFFRegularTriangulationFilter does: a vertex is there, at the height of the first of them.
   * Off by default: they are an error that names both cells.
   */
  vtkSetMacro(SplitCrossingConstraints, bool);
  vtkGetMacro(SplitCrossingConstraints, bool);
  vtkBooleanMacro(SplitCrossingConstraints, bool);
  ///@}

  ///@{
  /**
   * Set/Get the greatest vertical distance of a point from the mesh, in the unit of heights. 0: all
   * points are on the mesh. -1 (the default): a hundredth of the range of the heights, the highest
   * less the lowest. Another negative number and NaN are errors.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Set/Get how many vertices the mesh may have: no point is inserted once there are so many,
   * beyond those that it begins with. 0 by default: no limit.
   */
  vtkSetClampMacro(MaximumNumberOfVertices, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfVertices, vtkIdType);
  ///@}

  ///@{
  /**
   * Get of the last run: the greatest distance of a point from the mesh; how many points are
   * farther than the tolerance (0: it is met, exactly); how many of these are at the position of a
   * vertex that has another height; how many points were added, where breaklines cross and of the
   * source; and at how many points several heights were given that differ. Of several blocks: the
   * greatest distance, and the sums.
   */
  double GetGreatestError() { return this->Report.GreatestError; }
  vtkIdType GetNumberOfPointsBeyond() { return this->Report.NumberOfPointsBeyond; }
  vtkIdType GetNumberOfUnreachablePoints() { return this->Report.NumberOfUnreachablePoints; }
  vtkIdType GetNumberOfSplitPoints() { return this->Report.NumberOfSplitPoints; }
  vtkIdType GetNumberOfAddedPoints() { return this->Report.NumberOfAddedPoints; }
  vtkIdType GetNumberOfHeightDifferences() { return this->Report.NumberOfHeightDifferences; }
  ///@}

protected:
  vtkFFTerrainMeshFilter();
  ~vtkFFTerrainMeshFilter() override = default;

  void Execute(vtkDataObject* data, vtkInformationVector** inputVector,
    const std::vector<vtkDataObject*>& results, FFRun& run) override;
  const char* GetTitle() const override { return "Terrain mesh"; }

  int SourcePoints = AUTOMATIC_POINTS;
  bool SplitCrossingConstraints = false;
  double Tolerance = -1.0;
  vtkIdType MaximumNumberOfVertices = 0;

private:
  vtkFFTerrainMeshFilter(const vtkFFTerrainMeshFilter&) = delete;
  void operator=(const vtkFFTerrainMeshFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
