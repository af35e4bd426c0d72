// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFHullFilter
 * @brief   the exact convex hull of points in 3D
 *
 * vtkFFHullFilter computes the convex hull of the points of any vtkPointSet, vtkImageData or
 * vtkRectilinearGrid, as a vtkPolyData. Cells of the input are ignored. The hull is exact for
 * every finite input. No tolerance decides anything, also if the points are nearly coplanar, far
 * from the origin, or 1e300 apart.
 *
 * The algorithm is ffHull of the paper named in vtkFFAlgorithm. A tetrahedron grows into a
 * star-shaped polyhedron: each of its triangles inserts a point far outside it, and all triangles
 * can grow at the same time. Flip-Flop then turns the polyhedron into the convex hull by local
 * flips. An edge is flipped if that increases the volume (the V-criterion), or if it decreases the
 * degree of a vertex known not to be extreme (the D-criterion). Such a vertex is removed in the
 * end.
 *
 * The output is the canonical form of the hull, a function of the input alone:
 *
 * - The points are the strictly extreme points, by ascending id. Points
 *   inside a facet or an edge of the hull are not part of it. The
 *   lowest id represents all points of one position. The points have
 *   the type and the bits of the input's points (floats stay floats).
 * - The cells are the true facets, counter-clockwise from outside: as
 *   triangles, or as one polygon a facet (see SetFacetMode()). Each
 *   starts at its lowest id; all are in lexicographic order.
 * - The point array vtkOriginalPointIds (a vtkIdTypeArray) has the id
 *   that each point has in the input. The input's point data is passed,
 *   unless PassPointData is off.
 *
 * Every input has an answer:
 *
 * - no point: empty, dimension -1, no error
 * - one position: one vertex cell
 * - collinear points: one line cell between the two ends
 * - coplanar points: one polygon, once (or its triangles)
 * - duplicates: the lowest id represents all
 * - NaN or infinite coordinate: an error naming the first point and the
 *   count, and empty output
 * - NaN or infinity if NonFinitePoints is NON_FINITE_IGNORE: left
 *   out and counted
 * - ghost points: left out, unless SkipGhostPoints is off
 * - too many points, no memory: an error, and empty output
 *
 * Composite input gives a hull of each data set (see vtkFFAlgorithm), or one hull of all; see
 * SetCompositeMode(). For one hull, ids count the points of all data sets in order, and the point
 * array BlockIndex (a vtkUnsignedIntArray) has the flat index of each point's data set.
 *
 * A setting that concerns the output alone (facets, arrays, the report) does not compute the hull
 * again while the input is unchanged: the filter keeps the last one, in memory of its own. It keeps
 * none of composites that it does not join, and none if its release data flag is on.
 *
 * Of a composite, small data sets (4,096 points or fewer) run side by side, on a thread each.
 *
 * Points that do not fit in memory can be streamed: see SetNumberOfStreamDivisions().
 *
 * @warning
 * At most 2^32 - 2 points can be given; when streaming, in each piece, and so many extreme points.
 *
 * @sa
 * vtkFFHullAlgorithm vtkPFFHullFilter vtkFFConvexifyFilter vtkFFRegularTriangulationFilter
 * vtkDelaunay3D
 */

#ifndef vtkFFHullFilter_h
#define vtkFFHullFilter_h

#include "vtkFFHullAlgorithm.h"
#include "vtkFFMarks.h"               // For VTK_MARSHALAUTO
#include "vtkFiltersFlipFlopModule.h" // For export macro

#include <memory> // For std::shared_ptr

VTK_ABI_NAMESPACE_BEGIN
class vtkCompositeDataSet;
class vtkFFInput;

class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFHullFilter : public vtkFFHullAlgorithm
{
public:
  //@{
  /**
   * Standard methods for instantiation, type information and printing.
   */
  static vtkFFHullFilter* New();
  vtkTypeMacro(vtkFFHullFilter, vtkFFHullAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  //@}

  /**
   * What a composite input gives.
   */
  enum CompositeModeType
  {
    HULL_OF_EACH_BLOCK = 0,
    HULL_OF_ALL_BLOCKS = 1
  };

  //@{
  /**
   * Set/Get what a composite input gives: a hull of each data set in it (the default), or one hull
   * of the points of all. It has no effect on other inputs.
   */
  vtkSetClampMacro(CompositeMode, int, HULL_OF_EACH_BLOCK, HULL_OF_ALL_BLOCKS);
  vtkGetMacro(CompositeMode, int);
  //@}

  //@{
  /**
   * Set/Get the number of pieces that the input is streamed in. The default is 1: the input is
   * taken as a whole. With more, the filter asks its input for one piece after another, as
   * vtkPolyDataStreamer does, and keeps the extreme points of those so far: the hull of hulls is
   * the hull. The output is that of one run on all pieces appended in their order (or given as the
   * partitions of a vtkPartitionedDataSet), bit for bit.
   *
   * - In memory are one piece and the extreme points so far, which are
   *   there twice while a piece's are joined to them: few for a solid,
   *   nearly all for points on a thin shell.
   * - Upstream, readers and sources must deliver pieces
   *   (CAN_HANDLE_PIECE_REQUEST, or CAN_PRODUCE_SUB_EXTENT). If none
   *   does, or the data was set (SetInputData()), the first piece has
   *   all, and no other is asked for.
   * - A composite can be streamed if it has one hull: see
   *   SetCompositeMode().
   * - Ids count the points of all pieces, piece after piece. They and
   *   the numbers of points can be beyond 2^32.
   * - An error in a piece ends the run: no further one is asked for. Of
   *   points that are not finite, it names the first, and counts those
   *   so far.
   * - Dimension, volume, area and the numbers of points are of all
   *   pieces. The other statistics are sums over the runs.
   *
   * If the output itself is asked for in pieces, each is divided. Several processes stream with
   * vtkPFFHullFilter.
   */
  vtkSetClampMacro(NumberOfStreamDivisions, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfStreamDivisions, int);
  //@}

  //@{
  /**
   * Set/Get whether the output has a certificate as field data. Off by default. With it, a program
   * that shares nothing with this one checks the hull in linear time: Checker/check_result.py.
   *
   * - FlipFlopCertificate (vtkIdTypeArray): for each point of the
   *   input, ghosts included, the cell of the output whose cone from
   *   the apex holds it. Below dimension 3, the cell that holds it. -1
   *   for a point that was left out.
   * - FlipFlopApex (vtkDoubleArray of three components), in dimension
   *   3: one position, or four. Their exact mean is the apex, inside
   *   the hull.
   *
   * It needs all points at once: a streamed input, and several processes, are errors.
   */
  virtual void SetGenerateCertificate(bool on)
  {
    this->ChangeOutput(this->GenerateCertificate, on);
  }
  vtkGetMacro(GenerateCertificate, bool);
  //@}

protected:
  vtkFFHullFilter();
  ~vtkFFHullFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector);
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int CompositeMode = HULL_OF_EACH_BLOCK;
  int NumberOfStreamDivisions = 1;
  bool GenerateCertificate = false;

private:
  /// Whether the output is a composite like this input.
  bool HasHullOfEach(vtkDataObject* input) const;

  /// A hull of each data set in a composite. VTK's executive would make one after another.
  void WriteHulls(vtkCompositeDataSet* input, vtkFFRun& run, vtkCompositeDataSet* output);

  /// Adds the certificate, if it is wanted. The points and their number, with ghosts.
  void AddCertificate(const vtkFFInput& points, vtkIdType count, const vtkFFHullResult& hull,
    const vtkFFRun& run, vtkPolyData* output) const;

  struct KeptType;
  std::shared_ptr<KeptType> Kept;

  vtkFFHullFilter(const vtkFFHullFilter&) = delete;
  void operator=(const vtkFFHullFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
