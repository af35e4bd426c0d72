// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFAlgorithm
 * @brief   what the Flip-Flop filters have in common
 *
 * vtkFFAlgorithm is the abstract superclass of the filters that run the Flip-Flop engine. It holds
 * the choices that all of them offer (which engine, how many threads, what to do with points that
 * are not finite, how facets are given, whether point data is passed), and what a run reports: the
 * dimension of the result, which engine ran and why, and the statistics that the paper gives for
 * its own runs.
 *
 * The filters are exact: every branch that decides the output is taken on the exact sign of a
 * determinant, so no tolerance exists and none can be set. The output is a function of the input
 * alone. It does not depend on the engine, nor on the number of threads.
 *
 * An error is reported with vtkErrorMacro, in a sentence that names what is wrong and where. The
 * output is empty then, and GetErrorCode() differs from vtkErrorCode::NoError. A run reports
 * progress, and stops soon after it is asked to abort; its output is empty then, too.
 *
 * The algorithm is that of
 *
 * Mingcen Gao, Thanh-Tung Cao, Tiow-Seng Tan and Zhiyong Huang: "Flip-Flop: Convex Hull
 * Construction via Star-Shaped Polyhedron in 3D". Proceedings of the ACM SIGGRAPH Symposium on
 * Interactive 3D Graphics and Games (I3D), 2013.
 *
 * Input is any vtkPointSet, and any vtkImageData or vtkRectilinearGrid, whose points are laid out
 * first, in double (in float, if all coordinates of a rectilinear grid are), 24 bytes each; or a
 * composite of these. vtkFFConvexifyFilter takes a vtkPolyData. Anything else, and no input at all,
 * is an error.
 *
 * Composite input (vtkMultiBlockDataSet, vtkPartitionedDataSetCollection and other
 * vtkDataObjectTrees) gives a result for each block, in a composite of the same structure on every
 * port (get it by GetOutputDataObject()). A vtkPartitionedDataSet is one block: its partitions are
 * pieces of one data set, appended in their order, and the result has a single partition.
 *
 * @sa
 * vtkFFHullAlgorithm vtkFFHullFilter vtkFFConvexifyFilter vtkFFRegularTriangulationFilter
 */

#ifndef vtkFFAlgorithm_h
#define vtkFFAlgorithm_h

#include "vtkFiltersFlipFlopModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For std::string

class vtkDataObject;
class vtkDataSetAttributes;
class vtkPointSet;

#ifndef __VTK_WRAP__
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <cstddef>    // For std::size_t
#include <functional> // For std::function
#include <memory>     // For std::unique_ptr
#include <vector>     // For std::vector

class vtkFFAheadRuns;
class vtkFFBlockWork;
struct vtkFFFailure;

namespace flipflop
{
class Error;
struct CellComplex;
struct EngineOptions;
struct EngineReport;
struct Options;
}
#endif

class VTKFILTERSFLIPFLOP_EXPORT vtkFFAlgorithm : public vtkPolyDataAlgorithm
{
public:
  //@{
  /**
   * Standard methods for type information and printing.
   */
  vtkAbstractTypeMacro(vtkFFAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  //@}

  /**
   * The engines that can do the work. ENGINE_NONE is what GetEngineUsed() returns before a run.
   */
  enum EngineType
  {
    ENGINE_NONE = -1,
    ENGINE_AUTOMATIC = 0,
    ENGINE_CPU = 1,
    ENGINE_CUDA = 2
  };

  /**
   * How a flat facet of the result is given.
   */
  enum FacetModeType
  {
    FACETS_AS_TRIANGLES = 0,
    FACETS_AS_POLYGONS = 1
  };

  /**
   * What to do with points that have a NaN or infinite coordinate or weight.
   */
  enum NonFinitePointsType
  {
    NON_FINITE_ERROR = 0,
    NON_FINITE_IGNORE = 1
  };

  //@{
  /**
   * Set/Get the engine. Whatever engine runs, the output is the same, bit for bit.
   *
   * - ENGINE_AUTOMATIC (the default): the CUDA engine for inputs of
   *   CUDAThreshold points or more where IsCUDAAvailable(), else the
   *   CPU engine. Should the device fail, or its memory not suffice,
   *   the CPU engine does the work.
   * - ENGINE_CPU: the CPU engine.
   * - ENGINE_CUDA: the CUDA engine, for inputs of any size. It is an
   *   error, and gives an empty output, where it is not available,
   *   fails or lacks memory. Points that span too little for an engine
   *   to have work, and coordinates that only integers of any size can
   *   decide, are left to the CPU engine all the same.
   *
   * With VTK 9.6 or later, the CUDA engine reads a single array of float or double that lives on
   * the device (a vtkmDataArray can) in place; it must be the current device. The host reads it,
   * too.
   *
   * vtkFFConvexifyFilter runs on the CPU engine only: asking it for the CUDA engine is an error.
   */
  vtkSetClampMacro(Engine, int, ENGINE_AUTOMATIC, ENGINE_CUDA);
  vtkGetMacro(Engine, int);
  void SetEngineToAutomatic() { this->SetEngine(ENGINE_AUTOMATIC); }
  void SetEngineToCPU() { this->SetEngine(ENGINE_CPU); }
  void SetEngineToCUDA() { this->SetEngine(ENGINE_CUDA); }
  const char* GetEngineAsString();
  //@}

  //@{
  /**
   * Set/Get from how many points on ENGINE_AUTOMATIC takes the CUDA engine. From how many on it
   * pays is for a measurement to tell, and none has been made: the default is VTK_ID_MAX, which
   * leaves all inputs to the CPU engine, as anything from VTK_INT_MAX on does.
   */
  vtkSetClampMacro(CUDAThreshold, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(CUDAThreshold, vtkIdType);
  //@}

  //@{
  /**
   * Get whether this build has a CUDA engine and this machine a device that can run it; the
   * device's name (empty where there is none); and why there is none (empty where there is one).
   * Looks once, at the first call.
   */
  static bool IsCUDAAvailable();
  static const char* GetCUDADeviceName();
  static const char* GetCUDAProblem();
  //@}

  //@{
  /**
   * Get the engine of the last run (ENGINE_CPU or ENGINE_CUDA; ENGINE_NONE where none gave a
   * result), and why it was that one, in words. For several blocks with a result each: ENGINE_CUDA
   * if any block used it, and the reason of the last block that used the same engine.
   */
  vtkGetMacro(EngineUsed, int);
  const char* GetEngineUsedAsString();
  const char* GetEngineReason() { return this->EngineReason.c_str(); }
  //@}

  //@{
  /**
   * Set/Get the number of threads. 0 (the default) takes as many as vtkSMPTools would. The output
   * does not depend on it.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  //@}

  //@{
  /**
   * Set/Get how facets are given: as triangles (the default), where a facet of more than three
   * corners is a fan from the corner of lowest id, or as one polygon a facet.
   */
  vtkSetClampMacro(FacetMode, int, FACETS_AS_TRIANGLES, FACETS_AS_POLYGONS);
  vtkGetMacro(FacetMode, int);
  void SetFacetModeToTriangles() { this->SetFacetMode(FACETS_AS_TRIANGLES); }
  void SetFacetModeToPolygons() { this->SetFacetMode(FACETS_AS_POLYGONS); }
  const char* GetFacetModeAsString();
  //@}

  //@{
  /**
   * Set/Get what to do with points that have a NaN or infinite coordinate or weight: an error that
   * names the first one (the default), or leave them out and count them in
   * GetNumberOfNonFinitePoints().
   */
  vtkSetClampMacro(NonFinitePoints, int, NON_FINITE_ERROR, NON_FINITE_IGNORE);
  vtkGetMacro(NonFinitePoints, int);
  void SetNonFinitePointsToError() { this->SetNonFinitePoints(NON_FINITE_ERROR); }
  void SetNonFinitePointsToIgnore() { this->SetNonFinitePoints(NON_FINITE_IGNORE); }
  const char* GetNonFinitePointsAsString();
  //@}

  //@{
  /**
   * Set/Get whether ghost points are left out: those that the input's point array vtkGhostType
   * marks as another piece's (vtkDataSetAttributes::DUPLICATEPOINT) or as hidden (HIDDENPOINT:
   * blanked points of grids). On by default. They are on no output then and are not counted; the
   * others keep their ids. Off, they are points like all others. Marks of cells do not matter.
   *
   * vtkFFConvexifyFilter takes its surface whole, whatever is marked.
   */
  vtkSetMacro(SkipGhostPoints, bool);
  vtkGetMacro(SkipGhostPoints, bool);
  vtkBooleanMacro(SkipGhostPoints, bool);
  //@}

  //@{
  /**
   * Set/Get whether the input's point data arrays are passed to the output, in their full type and
   * precision. On by default. Attributes that tell of the input's own surface (normals, tangents,
   * edge flags) are plain arrays there: another surface would be shaded and drawn falsely by them.
   */
  vtkSetMacro(PassPointData, bool);
  vtkGetMacro(PassPointData, bool);
  vtkBooleanMacro(PassPointData, bool);
  //@}

  //@{
  /**
   * Set/Get whether the output's array vtkOriginalPointIds is given a second time under the name
   * OriginalPointIds: some applications hide the first name from their users. Off by default.
   */
  vtkSetMacro(VisiblePointIds, bool);
  vtkGetMacro(VisiblePointIds, bool);
  vtkBooleanMacro(VisiblePointIds, bool);
  //@}

  //@{
  /**
   * Set/Get whether what a run found is also given as field data of its output (of the first port,
   * in each block): some applications show their users nothing else. Off by default. The arrays, of
   * one value each, are FlipFlopDimension, FlipFlopInputPoints, FlipFlopNonFinitePoints,
   * FlipFlopEngine and FlipFlopEngineReason (strings), FlipFlopThreads and FlipFlopSeconds; of a
   * hull FlipFlopVolume and FlipFlopArea; of a triangulation FlipFlopHiddenPoints. An input's field
   * data is passed, but for arrays whose names begin with FlipFlop: they tell of another run.
   */
  vtkSetMacro(ReportAsFieldData, bool);
  vtkGetMacro(ReportAsFieldData, bool);
  vtkBooleanMacro(ReportAsFieldData, bool);
  //@}

  //@{
  /**
   * Set/Get whether the V-biased variant of the algorithm is run (the end of the paper's section
   * 2.3), which flips by the volume criterion alone as long as it can, and labels a vertex only
   * then. The output is the same; the statistics are not. On by default: where points lie along
   * curves, labels that come early cost very many flips.
   */
  vtkSetMacro(VBiased, bool);
  vtkGetMacro(VBiased, bool);
  vtkBooleanMacro(VBiased, bool);
  //@}

  /**
   * Get the dimension of what the last run's points span: -1 for no point, 0 for one position, 1
   * for collinear points, 2 for coplanar ones, else 3. For several blocks with a result each: the
   * greatest.
   */
  vtkGetMacro(Dimension, int);

  //@{
  /**
   * Get the statistics of the last run, in the paper's terms; sums for several blocks with a result
   * each. 0 before a run, and after one that failed or was aborted, whatever some blocks gave
   * before. Engines do the work in a different order, so from Culled points on the numbers differ
   * between them, where the output does not; between numbers of threads, too, where the CPU engine
   * inserts points one at a time (triangulations, hulls that most points are vertices of).
   *
   * - InputPoints: points given, without ghost points that are left out
   * - NonFinitePoints: points left out (or, after an error, found)
   *   with a NaN or infinite coordinate or weight
   * - CulledPoints: points found inside without being associated to a
   *   triangle (none by the CUDA engine)
   * - Insertions: vertices inserted while growing (1-3 flips), over
   *   all levels
   * - PointMoves: times that growing handed a point on to a child of
   *   its cone (none by the CUDA engine)
   * - Flips22, Flips31: 2-2 flips and 3-1 flips
   * - FlipsByVolume, FlipsByDegree: flips by the V-criterion (volume)
   *   and the D-criterion (degree)
   * - LabelledVertices: vertices labelled non-extreme
   * - RedundantVertices: vertices taken out of true facets and edges in
   *   the end, and duplicates
   * - EdgeChecks: edges examined for a flip
   * - ExactPredicates: predicates that the floating-point filter left
   *   undecided
   * - ThreadsUsed: CPU threads that the run was given
   */
  vtkGetMacro(NumberOfInputPoints, vtkIdType);
  vtkGetMacro(NumberOfNonFinitePoints, vtkIdType);
  vtkGetMacro(NumberOfCulledPoints, vtkIdType);
  vtkGetMacro(NumberOfInsertions, vtkIdType);
  vtkGetMacro(NumberOfPointMoves, vtkIdType);
  vtkGetMacro(NumberOfFlips22, vtkIdType);
  vtkGetMacro(NumberOfFlips31, vtkIdType);
  vtkGetMacro(NumberOfFlipsByVolume, vtkIdType);
  vtkGetMacro(NumberOfFlipsByDegree, vtkIdType);
  vtkGetMacro(NumberOfLabelledVertices, vtkIdType);
  vtkGetMacro(NumberOfRedundantVertices, vtkIdType);
  vtkGetMacro(NumberOfEdgeChecks, vtkIdType);
  vtkGetMacro(NumberOfExactPredicates, vtkIdType);
  vtkGetMacro(NumberOfThreadsUsed, int);
  //@}

  //@{
  /**
   * Get the seconds that the last run took, by stage; sums for several blocks with a result each,
   * whose runs may have been side by side. Scan, Locate, Finish and Total are wall time of a run;
   * Grow and Flip are summed over the threads; of the CUDA engine, and where points are inserted
   * and flipped at once, they are wall time.
   *
   * - Scan: ranges, points that are not finite, the first polyhedron
   * - Locate: culling, associating points to triangles. The CUDA
   *   engine does that while it grows; here it counts the time to
   *   bring its result back
   * - Grow: growing the star-shaped polyhedron (the paper's Algorithm
   *   2)
   * - Flip: flipping it to convexity (the paper's Algorithm 1)
   * - Finish: true facets and the canonical order
   * - Total: the whole run of the engine
   */
  vtkGetMacro(SecondsToScan, double);
  vtkGetMacro(SecondsToLocate, double);
  vtkGetMacro(SecondsToGrow, double);
  vtkGetMacro(SecondsToFlip, double);
  vtkGetMacro(SecondsToFinish, double);
  vtkGetMacro(SecondsTotal, double);
  //@}

  /**
   * The output's type follows the input's.
   */
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

#ifndef __VTK_WRAP__
  /**
   * A block of the input: a leaf, or a vtkPartitionedDataSet, whose partitions are the pieces of
   * one data set. Its pieces here, its flat index (0 where the input itself is the only block), and
   * its number of points, wherever they are.
   */
  struct Block
  {
    std::vector<vtkPointSet*> Pieces;
    unsigned int FlatIndex;
    vtkIdType NumberOfPoints;
  };
#endif

protected:
  vtkFFAlgorithm();
  ~vtkFFAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  virtual int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector);
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

#ifndef __VTK_WRAP__
  /**
   * What a subclass does: one result from the points of @p blocks (of a single one, unless
   * CombinesBlocks()), on all its ports. False when there was an error or an abort.
   */
  virtual bool Execute(
    const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs) = 0;

  /**
   * The work that Execute() would do on @p block alone, for small blocks to be run side by side.
   * Null (the default): nothing but Execute() does it.
   */
  virtual std::unique_ptr<vtkFFBlockWork> NewBlockWork(const Block& block);

  /**
   * Do all of some work here and now, guarded as RunEngine() is. False when there was an error or
   * an abort.
   */
  bool ExecuteWork(vtkFFBlockWork& work, const std::vector<vtkPolyData*>& outputs);

  /**
   * Whether one result is made of all blocks, which is no composite then.
   */
  virtual bool CombinesBlocks()
  {
    return false;
  }

  /**
   * The types of which a leaf of the input must be one; of vtkPointSet, vtkImageData and
   * vtkRectilinearGrid, or derived from these.
   */
  virtual std::vector<std::string> GetLeafTypes()
  {
    return { "vtkPointSet", "vtkImageData", "vtkRectilinearGrid" };
  }

  /**
   * It is a failure if the settings do not go together. None by default.
   */
  virtual void CheckSettings(vtkFFFailure&) {}

  /**
   * Leave the blocks that are to be worked on: by default, those with data. False where there is
   * a failure, here or already: it is reported.
   */
  virtual bool SelectBlocks(std::vector<Block>& blocks, vtkFFFailure& failure);

  /**
   * Forget what the last run reported. The first act of RequestData.
   */
  virtual void ResetReport();

  /**
   * Add a result to what this run reports; and to the output's field data, if that was asked for.
   */
  void AddToReport(
    const flipflop::CellComplex& cells, const flipflop::EngineReport& engine, vtkPolyData* output);

  /**
   * What a subclass has the engine do. Which engine ran, and why, goes into the report.
   */
  using EngineWork = std::function<void(
    const flipflop::Options&, const flipflop::EngineOptions&, flipflop::EngineReport&)>;

  /**
   * Run @p work with the options set here, guarded: whatever it throws becomes a failure. False
   * when it threw. No exception leaves this.
   */
  bool TryEngine(const EngineWork& work, vtkFFFailure& failure);

  /**
   * The same, and a failure becomes an error (an abort becomes none).
   */
  bool RunEngine(const EngineWork& work);

  /**
   * A failure becomes an error, unless it is an abort. Where it is not for this process to say it,
   * only the error code tells.
   */
  void ReportFailure(const vtkFFFailure& failure, bool aloud = true);

  /**
   * Report an error: the message, and the error code that tells callers of the failure.
   */
  void ReportError(const std::string& message);

  /**
   * Where progress of the next runs of the engine lies within what is being worked on, which is
   * one of the blocks: the whole by default.
   */
  void SetProgressPart(double begin, double end);

  /**
   * Whether somebody asked this filter to stop.
   */
  bool IsAbortRequested();

  /**
   * An abort, if somebody asked for one, is a failure; unless there is another.
   */
  void NoteAbort(vtkFFFailure& failure);

  /**
   * The place, among all points of CurrentBlocks, of the point that the engine counts as @p index:
   * the same, unless a subclass gave the engine only some of them.
   */
  virtual vtkIdType GetPlaceOfPoint(vtkIdType index)
  {
    return this->PlacesOfPoints.empty() ? index
                                        : this->PlacesOfPoints[static_cast<std::size_t>(index)];
  }

  /**
   * The points that count of some pieces: all, or those that are no ghosts, if these are to be
   * skipped. @p places becomes the ids that they have among all points, empty where all count.
   *
   * @throw std::runtime_error, flipflop::Error.
   */
  std::vector<vtkSmartPointer<vtkPointSet>> TakePoints(
    const std::vector<vtkPointSet*>& pieces, std::vector<vtkIdType>& places);

  /**
   * Where the points that the engine was given have their places among all points of CurrentBlocks:
   * empty where it was given all.
   */
  std::vector<vtkIdType> PlacesOfPoints;

  /**
   * Have the original ids of @p output, which count the points given to the engine, count all.
   */
  void RestoreIds(vtkDataSetAttributes* output);

  /**
   * How errors speak of a point of CurrentBlocks: "point 7 of the block of flat index 2".
   */
  std::string DescribePoint(vtkIdType place);

  /**
   * How they tell the one block that is worked on: " of the block of flat index 2", or nothing
   * where it is the whole input.
   */
  std::string OfBlock();

  /**
   * Which numbers are not finite, where first, and how many: the sentence before what helps.
   */
  std::string DescribeNonFinite(const std::string& what, const flipflop::Error& error);

  /**
   * What is wrong, where, how often, and what helps: an engine's error as a sentence.
   */
  virtual std::string DescribeError(const flipflop::Error& error);

  /**
   * What is being worked on.
   */
  std::vector<Block> CurrentBlocks;
#endif

  int Engine;
  vtkIdType CUDAThreshold;
  int NumberOfThreads;
  int FacetMode;
  int NonFinitePoints;
  bool SkipGhostPoints;
  bool PassPointData;
  bool VisiblePointIds;
  bool ReportAsFieldData;
  bool VBiased;

private:
  vtkFFAlgorithm(const vtkFFAlgorithm&) = delete;
  void operator=(const vtkFFAlgorithm&) = delete;

#ifndef __VTK_WRAP__
  void CollectBlocks(vtkDataObject* input, std::vector<Block>& blocks, vtkFFFailure& failure);
  void AddBlock(
    vtkDataObject* data, unsigned int flatIndex, std::vector<Block>& blocks, vtkFFFailure& failure);
  bool ExecuteEachBlock(const std::vector<Block>& blocks, vtkDataObject* input,
    const std::vector<vtkDataObject*>& outputs);
  bool RunAhead(const std::vector<Block>& blocks, std::size_t first, vtkFFAheadRuns& runs);
  void ReduceReportToFailure(); // blocks that went well before it are forgotten
  void SetProgressRange(double begin, double end);
  static bool ForwardProgress(double fraction, void* self);

  std::vector<vtkSmartPointer<vtkPointSet>> LaidOutPoints; // of blocks, while these are worked on
#endif

  int EngineUsed;
  std::string EngineReason;
  int Dimension;

  vtkIdType NumberOfInputPoints;
  vtkIdType NumberOfNonFinitePoints;
  vtkIdType NonFinitePointsOfFailure;
  vtkIdType NumberOfCulledPoints;
  vtkIdType NumberOfInsertions;
  vtkIdType NumberOfPointMoves;
  vtkIdType NumberOfFlips22;
  vtkIdType NumberOfFlips31;
  vtkIdType NumberOfFlipsByVolume;
  vtkIdType NumberOfFlipsByDegree;
  vtkIdType NumberOfLabelledVertices;
  vtkIdType NumberOfRedundantVertices;
  vtkIdType NumberOfEdgeChecks;
  vtkIdType NumberOfExactPredicates;
  int NumberOfThreadsUsed;

  double SecondsToScan;
  double SecondsToLocate;
  double SecondsToGrow;
  double SecondsToFlip;
  double SecondsToFinish;
  double SecondsTotal;

  double ProgressRange[2]; // of what is being worked on
  double ProgressPart[2];  // within that
  double ProgressReached;
};

#endif
