// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFTerrainMeshFilter
 * @brief   a mesh of some of the points, within a vertical tolerance of all
 *
 * vtkFFTerrainMeshFilter makes a small mesh of a terrain: a constrained Delaunay triangulation, in
 * x and y, of some of the points, from which no other point is farther, vertically, than a
 * tolerance. Whether a point is, is decided exactly. The height of a point is z, or its value in
 * the point array that is set by SetInputArrayToProcess() at index 0. Cells of the input are
 * ignored.
 *
 * The mesh begins with the corners of the convex hull and the ends of the breaklines. Then the
 * point that is farthest from the surface becomes a vertex (of several, the one of the lowest id),
 * again and again, until all are within the tolerance, or there are as many vertices as are
 * allowed. The result is the same for any number of threads, and bit for bit the triangulation of
 * the points that are kept.
 *
 * - Port 0, the mesh: triangles, or lines where all points are on one
 *   line. SetFacetMode() has no effect.
 * - Port 1, a vertex for each point that was not kept, with the array
 *   TerrainError (a vtkDoubleArray): how far the point is above the
 *   mesh, the true number rounded to the nearest double. So the errors
 *   come with the points that have one: at a vertex it is 0.
 *
 * Both have the point data of their points. Of several points at one position, the one of the
 * lowest id is the vertex. Others there, whose heights differ by more than the tolerance, are
 * counted by GetNumberOfUnreachablePoints(): no vertex helps them.
 *
 * The second input has the breaklines, as vtkFFRegularTriangulationFilter takes them: lines and
 * polygons whose sides are edges of the mesh, parted where a vertex is on them. They name points of
 * the input, or have points of their own, which join the others: see SetSourcePoints(). Of
 * polygons, only the sides count. Breaklines that cross between points are an error that names both
 * cells. vtkFFRegularTriangulationFilter splits them: its outputs can be the inputs of this filter.
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
  /**
   * Standard methods for instantiation, type information and printing.
   */
  static vtkFFTerrainMeshFilter* New();
  vtkTypeMacro(vtkFFTerrainMeshFilter, vtkFFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * Whose points the source's cells name: as vtkFFRegularTriangulationFilter::SourcePointsType.
   */
  enum SourcePointsType
  {
    AUTOMATIC_POINTS = 0,
    INPUT_POINTS = 1,
    OWN_POINTS = 2
  };

  ///@{
  /**
   * Set/Get the second input, on port 1: the breaklines. None by default. SetSourcePoints() says
   * whose points they name.
   */
  void SetSourceData(vtkDataObject* source) { this->SetInputData(1, source); }
  void SetSourceConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void RemoveSource() { this->SetSourceConnection(nullptr); }
  vtkDataObject* GetSource() { return this->GetSecondInput(); }
  ///@}

  ///@{
  /**
   * Set/Get whose points the cells of the source name. AUTOMATIC_POINTS (the default), INPUT_POINTS
   * and OWN_POINTS are as in vtkFFRegularTriangulationFilter::SetSourcePoints(), and so are point
   * data and ids of own points that join the input's. INPUT_POINTS compares x and y alone.
   *
   * Own points that cells name are vertices of the mesh. At the x and y of a point of the input,
   * that point is the vertex, with its own height. The height of an own point is z; if an array of
   * heights is chosen, it is the value of the source's point array that the same choice finds. One
   * that is not finite is an error that names its cell.
   *
   * With own points, both outputs have the point arrays PointOrigin (a vtkUnsignedCharArray), 0 for
   * points of the input and 1 for those that the source adds, and HeightRange, a vtkDoubleArray of
   * two components: the lowest and the highest of all heights that are given for a point, by
   * itself, by points of the source at its position, and, at a vertex, by the lines through it.
   */
  vtkSetClampMacro(SourcePoints, int, AUTOMATIC_POINTS, OWN_POINTS);
  vtkGetMacro(SourcePoints, int);
  void SetSourcePointsToAutomaticPoints() { this->SetSourcePoints(AUTOMATIC_POINTS); }
  void SetSourcePointsToInputPoints() { this->SetSourcePoints(INPUT_POINTS); }
  void SetSourcePointsToOwnPoints() { this->SetSourcePoints(OWN_POINTS); }
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
   * Set/Get how many vertices the mesh may have: no point is inserted once there are so many. The
   * corners of the convex hull and the ends of the breaklines are there in any case. 0 by default:
   * no limit.
   */
  vtkSetClampMacro(MaximumNumberOfVertices, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfVertices, vtkIdType);
  ///@}

  ///@{
  /**
   * Get, of the last run, the greatest distance of a point from the mesh; how many points are
   * farther than the tolerance (0: it is met, exactly); and how many of these are at the position
   * of a vertex that has another height. For several blocks: the greatest distance, and the sums.
   */
  double GetGreatestError() { return this->Report.GreatestError; }
  vtkIdType GetNumberOfPointsBeyond() { return this->Report.NumberOfPointsBeyond; }
  vtkIdType GetNumberOfUnreachablePoints() { return this->Report.NumberOfUnreachablePoints; }
  ///@}

  ///@{
  /**
   * Get how many points of the source the last run added, and at how many points several heights
   * were given that differ.
   */
  vtkIdType GetNumberOfAddedPoints() { return this->Report.NumberOfAddedPoints; }
  vtkIdType GetNumberOfHeightDifferences() { return this->Report.NumberOfHeightDifferences; }
  ///@}

protected:
  vtkFFTerrainMeshFilter();
  ~vtkFFTerrainMeshFilter() override;

  void Execute(vtkDataObject* data, vtkInformationVector** inputVector,
    const std::vector<vtkDataObject*>& results, FFRun& run) override;
  const char* GetTitle() const override { return "Terrain mesh"; }

  int SourcePoints = AUTOMATIC_POINTS;
  double Tolerance = -1.0;
  vtkIdType MaximumNumberOfVertices = 0;

private:
  vtkFFTerrainMeshFilter(const vtkFFTerrainMeshFilter&) = delete;
  void operator=(const vtkFFTerrainMeshFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
