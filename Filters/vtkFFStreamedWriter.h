// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFStreamedWriter
 * @brief   write the triangulation or the hull of more points than memory holds
 *
 * vtkFFStreamedWriter asks its input for one piece after another, and writes the triangulation in
 * the XY plane, or the convex hull, of the points of all pieces. Points wait in files, and the
 * result is written block by block. All blocks together have the cells of
 * vtkFFRegularTriangulationFilter or vtkFFHullFilter, bit for bit, whatever the pieces, the blocks,
 * the memory and the threads are.
 *
 * Input is any data set, or a composite, whose points are taken together. Readers and sources
 * upstream must deliver pieces (CAN_HANDLE_PIECE_REQUEST, or CAN_PRODUCE_SUB_EXTENT). If none does,
 * or the data was set (SetInputData()), it is one piece. Each piece must have the arrays of the
 * first piece that has a point, and its points the type of those, unless that is double.
 *
 * The file name.vtpd is a vtkPartitionedDataSet. Beside it, the folder name has a file name_k.vtp
 * for each block k: the block's cells, each in one block, and their points, with point data of
 * numbers. The point array vtkOriginalPointIds (a vtkIdTypeArray) has the place of each point among
 * all that are not left out as ghosts, piece after piece.
 *
 * Each file is whole or absent, and name.vtpd comes last. After an error or an abort, Write() goes
 * on where the last one ended, unless anything is another than before. GetErrorCode() is one of
 * vtkFFErrorCode, or of vtkErrorCode for a file: NoFileNameError, CannotOpenFileError,
 * OutOfDiskSpaceError. One process writes.
 *
 * @sa
 * vtkFFRegularTriangulationFilter vtkFFHullFilter vtkXMLPartitionedDataSetReader
 */

#ifndef vtkFFStreamedWriter_h
#define vtkFFStreamedWriter_h

#include "vtkFFMarks.h"               // For VTK_MARSHALAUTO
#include "vtkFFReport.h"              // For vtkFFReport
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
  void SetShapeToTriangulation() { this->SetShape(TRIANGULATION); }
  void SetShapeToHull() { this->SetShape(HULL); }
  ///@}

  ///@{
  /**
   * Set/Get what the values of the weights' array are, vtkFFPlanarAlgorithm::WEIGHTS (the default)
   * or RADII, and the factor of all, 1 by default: as in vtkFFPlanarAlgorithm.
   */
  vtkSetClampMacro(WeightMode, int, 0, 1);
  vtkGetMacro(WeightMode, int);
  void SetWeightModeToWeights() { this->SetWeightMode(0); }
  void SetWeightModeToRadii() { this->SetWeightMode(1); }
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
  void SetFacetModeToTriangles() { this->SetFacetMode(0); }
  void SetFacetModeToPolygons() { this->SetFacetMode(1); }
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
   * Set/Get the number of threads, each of which works on a block, as for
   * vtkFFAlgorithm::SetNumberOfThreads().
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
  void SetNonFinitePointsToError() { this->SetNonFinitePoints(0); }
  void SetNonFinitePointsToIgnore() { this->SetNonFinitePoints(1); }
  ///@}

  ///@{
  /**
   * Set/Get whether ghost points are left out: on by default, see
   * vtkFFAlgorithm::SetSkipGhostPoints(). Ids do not count them.
   */
  vtkSetMacro(SkipGhostPoints, bool);
  vtkGetMacro(SkipGhostPoints, bool);
  vtkBooleanMacro(SkipGhostPoints, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether the input's point data is passed. On by default.
   */
  vtkSetMacro(PassPointData, bool);
  vtkGetMacro(PassPointData, bool);
  vtkBooleanMacro(PassPointData, bool);
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
  vtkIdType GetNumberOfInputPoints() { return this->Report.NumberOfInputPoints; }
  vtkIdType GetNumberOfNonFinitePoints() { return this->Report.NumberOfNonFinitePoints; }
  vtkIdType GetNumberOfHiddenPoints() { return this->Report.NumberOfHiddenPoints; }
  vtkGetMacro(NumberOfCells, vtkIdType);
  vtkGetMacro(NumberOfBlocks, vtkIdType);
  int GetDimension() { return this->Report.Dimension; }
  double GetVolume() { return this->Report.Volume; }
  double GetArea() { return this->Report.Area; }
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

  vtkFFReport Report;
  vtkIdType NumberOfCells = 0;
  vtkIdType NumberOfBlocks = 0;
  bool IsTried = false;   ///< whether the executive came to RequestData()
  bool IsWritten = false; ///< by the last one
};
VTK_ABI_NAMESPACE_END

#endif
