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
 * The second input has the breaklines, as vtkFFConstrainedDelaunayFilter takes them: lines and
 * polygons whose sides are edges of the mesh, parted where a vertex is on them. Of polygons, only
 * the sides count. Breaklines that cross between points are an error that names both cells.
 *
 * A height that is NaN or infinite is treated like a coordinate: see SetNonFinitePoints(). This
 * filter runs on the CPU engine; asking it for the CUDA engine is an error.
 *
 * @sa
 * vtkFFConstrainedDelaunayFilter vtkGreedyTerrainDecimation
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
  //@{
  /**
   * Standard methods for instantiation, type information and printing.
   */
  static vtkFFTerrainMeshFilter* New();
  vtkTypeMacro(vtkFFTerrainMeshFilter, vtkFFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  //@}

  //@{
  /**
   * Set/Get the second input, on port 1: the breaklines. None by default. Their point ids are those
   * of the input. The source has no points, or at the ids that its cells name the x and y of the
   * input's.
   */
  void SetSourceData(vtkPolyData* source);
  void SetSourceConnection(vtkAlgorithmOutput* output);
  void RemoveSource() { this->SetSourceConnection(nullptr); }
  vtkPolyData* GetSource();
  //@}

  //@{
  /**
   * Set/Get the greatest vertical distance of a point from the mesh, in the unit of heights. 0 by
   * default: all points are on the mesh. A negative number and NaN are errors.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  //@}

  //@{
  /**
   * Set/Get how many vertices the mesh may have: no point is inserted once there are so many. The
   * corners of the convex hull and the ends of the breaklines are there in any case. 0 by default:
   * no limit.
   */
  vtkSetClampMacro(MaximumNumberOfVertices, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfVertices, vtkIdType);
  //@}

  //@{
  /**
   * Get, of the last run, the greatest distance of a point from the mesh; how many points are
   * farther than the tolerance (0: it is met, exactly); and how many of these are at the position
   * of a vertex that has another height. For several blocks: the greatest distance, and the sums.
   */
  vtkGetMacro(GreatestError, double);
  vtkGetMacro(NumberOfPointsBeyond, vtkIdType);
  vtkGetMacro(NumberOfUnreachablePoints, vtkIdType);
  //@}

protected:
  vtkFFTerrainMeshFilter();
  ~vtkFFTerrainMeshFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void ForgetReport() override;

  double Tolerance = 0.0;
  vtkIdType MaximumNumberOfVertices = 0;
  double GreatestError = 0.0;
  vtkIdType NumberOfPointsBeyond = 0;
  vtkIdType NumberOfUnreachablePoints = 0;

private:
  vtkFFTerrainMeshFilter(const vtkFFTerrainMeshFilter&) = delete;
  void operator=(const vtkFFTerrainMeshFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
