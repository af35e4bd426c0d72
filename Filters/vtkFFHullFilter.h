// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFHullFilter
 * @brief   the exact convex hull of points in 3D
 *
 * vtkFFHullFilter computes the convex hull of the points of any data set, as a vtkPolyData. Cells
 * of the input are ignored. The algorithm is ffHull of the paper named in vtkFFAlgorithm.
 *
 * The output is a function of the input alone. Its points are the strictly extreme points, by
 * ascending id, with the type and the bits of the input's points: none is inside a facet or an
 * edge, and the lowest id represents all points of one position. The cells are the true facets,
 * counter-clockwise from outside, as triangles or as one polygon a facet: see SetFacetMode(). Each
 * starts at its lowest id; all are in lexicographic order. The point array vtkOriginalPointIds (a
 * vtkIdTypeArray) has the id that each point has in the input.
 *
 * Every input has an answer:
 *
 * - no point: empty, dimension -1, no error
 * - one position: one vertex cell
 * - collinear points: one line cell between the two ends
 * - coplanar points: one polygon, once (or its triangles)
 * - a NaN or infinite coordinate: an error, or left out and counted
 * - too many points, no memory: an error
 *
 * Composite input gives a hull of each data set, or one hull of all: see SetCompositeMode(). Points
 * that do not fit in memory can be streamed: see SetNumberOfStreamDivisions(). At most 2^32 - 2
 * points can be given; when streaming, in each piece, and so many extreme points.
 *
 * @sa
 * vtkFFHullAlgorithm vtkPFFHullFilter vtkFFConvexifyFilter vtkDelaunay3D
 */

#ifndef vtkFFHullFilter_h
#define vtkFFHullFilter_h

#include "vtkFFHullAlgorithm.h"
#include "vtkFFMarks.h"               // For VTK_MARSHALAUTO
#include "vtkFiltersFlipFlopModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFHullFilter : public vtkFFHullAlgorithm
{
public:
  ///@{
  /// Standard methods for instantiation, type information and printing.
  static vtkFFHullFilter* New();
  vtkTypeMacro(vtkFFHullFilter, vtkFFHullAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /// What a composite input gives.
  enum CompositeModeType
  {
    HULL_OF_EACH_BLOCK = 0,
    HULL_OF_ALL_BLOCKS = 1
  };

  ///@{
  /**
   * Set/Get what a composite input gives: a hull of each data set in it (the default), or one hull
   * of the points of all. Then ids count the points of all data sets in order, and the point array
   * BlockIndex (a vtkUnsignedIntArray) has the flat index of each point's data set.
   */
  vtkSetClampMacro(CompositeMode, int, HULL_OF_EACH_BLOCK, HULL_OF_ALL_BLOCKS);
  vtkGetMacro(CompositeMode, int);
  void SetCompositeModeToHullOfEachBlock() { this->SetCompositeMode(HULL_OF_EACH_BLOCK); }
  void SetCompositeModeToHullOfAllBlocks() { this->SetCompositeMode(HULL_OF_ALL_BLOCKS); }
  ///@}

  ///@{
  /**
   * Set/Get the number of pieces that the input is streamed in. 1 by default: it is taken as a
   * whole. With more, the filter asks its input for one piece after another, as vtkPolyDataStreamer
   * does, and keeps the extreme points of those so far. The output is that of one run on all pieces
   * appended, bit for bit; ids count the points of all, and can be beyond 2^32. If the output
   * itself is asked for in pieces, each is divided.
   *
   * Something upstream must deliver pieces (CAN_HANDLE_PIECE_REQUEST, or CAN_PRODUCE_SUB_EXTENT);
   * otherwise the first one has all. A composite is streamed with HULL_OF_ALL_BLOCKS. An error in a
   * piece ends the run; of points that are not finite, it counts those so far.
   */
  vtkSetClampMacro(NumberOfStreamDivisions, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfStreamDivisions, int);
  ///@}

protected:
  vtkFFHullFilter();
  ~vtkFFHullFilter() override;

  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void Execute(vtkDataObject* data, vtkInformationVector** inputVector,
    const std::vector<vtkDataObject*>& results, FFRun& run) override;
  const char* GetTitle() const override { return "Convex hull"; }
  bool IsJoined() const override;

  int CompositeMode = HULL_OF_EACH_BLOCK;
  int NumberOfStreamDivisions = 1;

private:
  vtkFFHullFilter(const vtkFFHullFilter&) = delete;
  void operator=(const vtkFFHullFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
