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
 * output is empty then, GetErrorCode() differs from vtkErrorCode::NoError, and the update fails: no
 * filter downstream is run. A run reports progress, and stops soon after it is asked to abort; its
 * output is empty then, too, but the update goes on.
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

#include "vtkFFMarks.h"               // For VTK_MARSHALAUTO
#include "vtkFiltersFlipFlopModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFAlgorithm : public vtkPolyDataAlgorithm
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
  const char* GetEngineReason();
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

protected:
  vtkFFAlgorithm();
  ~vtkFFAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  virtual int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector);
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * What the filters do and how they differ in that. It is a matter of this module and of
   * FlipFlop::FiltersParallelFlipFlop: no installed header defines it.
   */
  class vtkInternals;

  /**
   * What a subclass does its own way, in the place of what its superclass does.
   */
  void SetInternals(std::unique_ptr<vtkInternals> internals);

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

  std::unique_ptr<vtkInternals> Internals;

  int EngineUsed;
  int Dimension;

  vtkIdType NumberOfInputPoints;
  vtkIdType NumberOfNonFinitePoints;
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
};
VTK_ABI_NAMESPACE_END

#endif
