// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFStreamedWriter
 * @brief   write the triangulation or the hull of more points than memory holds
 *
 * vtkFFStreamedWriter asks its input for one piece after another, and writes the triangulation in
 * the XY plane, or the convex hull, of the points of all pieces. Neither the points nor the result
 * are ever in memory as a whole: points wait in files, and the result is written block by block.
 * All blocks together have the cells of vtkFFRegularTriangulationFilter or vtkFFHullFilter, bit for
 * bit, whatever the pieces, the blocks, the memory and the threads are.
 *
 * Input is any vtkPointSet, vtkImageData or vtkRectilinearGrid, or a composite of these, whose
 * points are taken together. Readers and sources upstream must deliver pieces
 * (CAN_HANDLE_PIECE_REQUEST, or CAN_PRODUCE_SUB_EXTENT). If none does, or the data was set
 * (SetInputData()), it is one piece.
 *
 * The file name.vtpd is a vtkPartitionedDataSet, for vtkXMLPartitionedDataSetReader and ParaView.
 * Beside it, the folder name has a file name_k.vtp for each block k, compressed by LZ4:
 *
 * - The points are those of the block's cells. Points on the border of
 *   two blocks are in both. They have the type and the bits of the
 *   input's points.
 * - The cells are triangles or polygons (see SetFacetMode()), and where
 *   the points span less, lines or a vertex. Each is in one block.
 * - The point array vtkOriginalPointIds (a vtkIdTypeArray) has the place
 *   of each point among all that are not left out as ghosts, piece
 *   after piece. Joined by it, blocks are one surface.
 * - The input's point data is passed, unless PassPointData is off.
 *   Arrays that hold no numbers, or have no name, are left out, and a
 *   warning names them.
 *
 * Each piece must have the arrays of the first piece that has a point. Its points must have the
 * type of those, unless that is double.
 *
 * Each file is whole or absent, and name.vtpd comes last. After an error or an abort, Write() goes
 * on where the last one ended: it takes each piece again and compares it with what is stored. If
 * anything is another than before, it begins again. So does a Write() after one that succeeded.
 *
 * An error is one message, and GetErrorCode() is one of vtkFFErrorCode, or of vtkErrorCode for a
 * file: NoFileNameError, CannotOpenFileError, OutOfDiskSpaceError. An error in a piece names it.
 * Write() then returns 0, as after an abort.
 *
 * One process writes. ParaView does not offer the writer on a server of several ranks.
 *
 * Power diagrams, alpha complexes and terrain meshes are not streamed, nor planes other than XY.
 *
 * @sa
 * vtkFFRegularTriangulationFilter vtkFFHullFilter vtkXMLPartitionedDataSetReader
 */

#ifndef vtkFFStreamedWriter_h
#define vtkFFStreamedWriter_h

#include "vtkFFMarks.h"               // For VTK_MARSHALAUTO
#include "vtkFiltersFlipFlopModule.h" // For export macro
#include "vtkWriter.h"

#include <string> // For std::string
#include <vector> // For std::vector

namespace flipflop
{
struct StreamReport;
}

VTK_ABI_NAMESPACE_BEGIN
class FFRun;
class FFStreamedInput;

class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFStreamedWriter : public vtkWriter
{
public:
  ///@{
  /**
   * Standard methods for instantiation, type information and printing.
   */
  static vtkFFStreamedWriter* New();
  vtkTypeMacro(vtkFFStreamedWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * What is written.
   */
  enum ShapeType
  {
    TRIANGULATION = 0,
    HULL = 1
  };

  ///@{
  /**
   * Set/Get the name of the file, which ends with .vtpd. Its folder must exist.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * The ending of the file's name, and what it holds.
   */
  const char* GetDefaultFileExtension() { return "vtpd"; }

  ///@{
  /**
   * Set/Get what is written: TRIANGULATION (the default) is the regular triangulation in the XY
   * plane, HULL the convex hull. Weights come from a point array, as vtkFFPlanarAlgorithm says:
   *
   *     writer->SetInputArrayToProcess(
   *       0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "weights");
   *
   * By default there is no array, and the triangulation is Delaunay's. A hull has no weights.
   */
  vtkSetClampMacro(Shape, int, TRIANGULATION, HULL);
  vtkGetMacro(Shape, int);
  ///@}

  ///@{
  /**
   * Set/Get what the values of the weights' array are, vtkFFPlanarAlgorithm::WEIGHTS (the default)
   * or RADII, and the factor of all, 1 by default: as in vtkFFPlanarAlgorithm.
   */
  vtkSetClampMacro(WeightMode, int, 0, 1);
  vtkGetMacro(WeightMode, int);
  vtkSetMacro(WeightFactor, double);
  vtkGetMacro(WeightFactor, double);
  ///@}

  ///@{
  /**
   * Set/Get the length of the longest edge that the cells of a triangulation may have, as in
   * vtkFFRegularTriangulationFilter. 0 by default: any. A negative number and NaN are an error of
   * Write(). A hull is written whole.
   */
  vtkSetMacro(MaximumEdgeLength, double);
  vtkGetMacro(MaximumEdgeLength, double);
  ///@}

  ///@{
  /**
   * Set/Get how facets are given: vtkFFAlgorithm::FACETS_AS_TRIANGLES (the default) or
   * FACETS_AS_POLYGONS.
   */
  vtkSetClampMacro(FacetMode, int, 0, 1);
  vtkGetMacro(FacetMode, int);
  ///@}

  ///@{
  /**
   * Set/Get the number of pieces that the input is asked for. The default is 1. One piece must fit
   * in memory, some times over.
   */
  vtkSetClampMacro(NumberOfPieces, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfPieces, int);
  ///@}

  ///@{
  /**
   * Set/Get the memory that the work may take, about, in kibibytes, beside a piece and a block's
   * result. The default is 1048576, one gibibyte; 1024 is the least.
   */
  vtkSetClampMacro(MemoryLimit, vtkIdType, 1024, VTK_ID_MAX / 1024);
  vtkGetMacro(MemoryLimit, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get about how many points a block has. 0 (the default): as many as MemoryLimit lets each
   * thread have.
   */
  vtkSetClampMacro(PointsPerBlock, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(PointsPerBlock, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get the number of threads, each of which works on a block. 0 (the default) means as many as
   * vtkSMPTools uses, -1 all that the machine has.
   */
  vtkSetClampMacro(NumberOfThreads, int, -1, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * Set/Get what to do with points that have a NaN or infinite coordinate or weight:
   * vtkFFAlgorithm::NON_FINITE_ERROR (the default) names the first one of a piece,
   * NON_FINITE_IGNORE leaves them out and counts them.
   */
  vtkSetClampMacro(NonFinitePoints, int, 0, 1);
  vtkGetMacro(NonFinitePoints, int);
  ///@}

  ///@{
  /**
   * Set/Get whether ghost points are left out: on by default, see
   * vtkFFAlgorithm::SetSkipGhostPoints(). Ids do not count them.
   */
  vtkSetMacro(SkipGhostPoints, bool);
  vtkGetMacro(SkipGhostPoints, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether the input's point data is passed. On by default.
   */
  vtkSetMacro(PassPointData, bool);
  vtkGetMacro(PassPointData, bool);
  ///@}

  ///@{
  /**
   * Set/Get the folder where points wait: 100 to 200 bytes for each, and twice its data. None by
   * default: a folder name.work beside the file name.vtpd. It is made if it is not there, and is of
   * one Write() at a time. It is removed in the end, and stays after an error or an abort.
   */
  vtkSetFilePathMacro(WorkFolder);
  vtkGetFilePathMacro(WorkFolder);
  ///@}

  ///@{
  /**
   * Get what the last Write() found: how many points all pieces have, without ghosts that are left
   * out, and how many of these are not finite, and hidden (of a hull: not strictly extreme); the
   * number of cells, before MaximumEdgeLength leaves some out, and of blocks; the dimension of what
   * the points span; volume and area of a hull. Before a Write(), and after an error: 0, and -1 for
   * the dimension.
   */
  vtkGetMacro(NumberOfInputPoints, vtkIdType);
  vtkGetMacro(NumberOfNonFinitePoints, vtkIdType);
  vtkGetMacro(NumberOfHiddenPoints, vtkIdType);
  vtkGetMacro(NumberOfCells, vtkIdType);
  vtkGetMacro(NumberOfBlocks, vtkIdType);
  vtkGetMacro(Dimension, int);
  vtkGetMacro(Volume, double);
  vtkGetMacro(Area, double);
  ///@}

  /**
   * Write the file. Returns 1 if it is there, and 0 after an error or an abort.
   */
  int Write() override;

protected:
  vtkFFStreamedWriter();
  ~vtkFFStreamedWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void WriteData() override;

  char* FileName = nullptr;
  char* WorkFolder = nullptr;
  int Shape = TRIANGULATION;
  int WeightMode = 0;
  double WeightFactor = 1.0;
  double MaximumEdgeLength = 0.0;
  int FacetMode = 0;
  int NumberOfPieces = 1;
  vtkIdType MemoryLimit = 1048576;
  vtkIdType PointsPerBlock = 0;
  int NumberOfThreads = 0;
  int NonFinitePoints = 0;
  bool SkipGhostPoints = true;
  bool PassPointData = true;

private:
  vtkFFStreamedWriter(const vtkFFStreamedWriter&) = delete;
  void operator=(const vtkFFStreamedWriter&) = delete;

  void ForgetReport();
  void WarnOfLeftOut(const std::vector<std::string>& names);
  flipflop::StreamReport WriteFiles(FFStreamedInput& input, FFRun& run);

  vtkIdType NumberOfInputPoints = 0;
  vtkIdType NumberOfNonFinitePoints = 0;
  vtkIdType NumberOfHiddenPoints = 0;
  vtkIdType NumberOfCells = 0;
  vtkIdType NumberOfBlocks = 0;
  int Dimension = -1;
  double Volume = 0.0;
  double Area = 0.0;
  bool IsTried = false;   ///< whether the executive came to RequestData()
  bool IsWritten = false; ///< by the last one
};
VTK_ABI_NAMESPACE_END

#endif
