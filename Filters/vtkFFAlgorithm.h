// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFAlgorithm
 * @brief   what the Flip-Flop filters have in common
 *
 * vtkFFAlgorithm is the abstract superclass of the filters that run the Flip-Flop engine. It has
 * their common settings, and the report of the last run. A run depends on the settings and the
 * input alone, not on runs before it.
 *
 * The filters are exact: the exact sign of a determinant decides every branch that affects the
 * output, so there is no tolerance. The output does not depend on the engine, the number of threads
 * or the caller's floating-point environment, which observers of progress have.
 *
 * Input is any vtkDataSet. The points of images and rectilinear grids are first copied, as double
 * (float, if all coordinates of a rectilinear grid are). Composite input gives a result for each
 * data set, in a composite of the same structure on every port: get it with GetOutputDataObject().
 * Of small data sets (4,096 points or fewer), several are worked on at a time. What the filter
 * reports are sums.
 *
 * A setting keeps what it is given, but for modes and counts, which end at their range's ends. A
 * number that is not allowed is an error of the next Update(). An error is one message, of
 * vtkErrorMacro, that names what is wrong and where. After it, the output is empty, and
 * GetErrorCode() is one of vtkFFErrorCode. A data set of a composite at fault has an empty result
 * and one error, which counts the data sets from 0 on; all others have theirs. After an abort, the
 * output is empty, but for data sets of a composite that were done before.
 *
 * The algorithm is that of Mingcen Gao, Thanh-Tung Cao, Tiow-Seng Tan and Zhiyong Huang:
 * "Flip-Flop: Convex Hull Construction via Star-Shaped Polyhedron in 3D", I3D 2013.
 *
 * @sa
 * vtkFFHullFilter vtkFFConvexifyFilter vtkFFRegularTriangulationFilter vtkFFQueryAlgorithm
 */

#ifndef vtkFFAlgorithm_h
#define vtkFFAlgorithm_h

#include "vtkFFMarks.h"               // For VTK_MARSHALAUTO
#include "vtkFFReport.h"              // For vtkFFReport
#include "vtkFiltersFlipFlopModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <vector> // For std::vector

VTK_ABI_NAMESPACE_BEGIN
class FFRun;

class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFAlgorithm : public vtkPolyDataAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for type information and printing.
   */
  vtkAbstractTypeMacro(vtkFFAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

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

  ///@{
  /**
   * Set/Get the engine. Whatever engine runs, the output is the same, bit for bit.
   *
   * - ENGINE_AUTOMATIC (the default): the CUDA engine for inputs of
   *   CUDAThreshold points or more if IsCUDAAvailable(), otherwise the
   *   CPU engine. If the device fails, or has too little memory, the
   *   CPU engine does the work.
   * - ENGINE_CPU: the CPU engine.
   * - ENGINE_CUDA: the CUDA engine, for inputs of any size. If it is
   *   not available, fails or lacks memory, that is an error, and the
   *   output is empty. The CPU engine still does two kinds of input:
   *   points that span too little to give an engine work, and
   *   coordinates that only integers of any size can decide.
   *
   * With VTK 9.6 or later, the CUDA engine reads a single array of float or double in place if the
   * array is on the device (a vtkmDataArray can be). The device must be the current one. The host
   * reads the array, too.
   */
  vtkSetClampMacro(Engine, int, ENGINE_AUTOMATIC, ENGINE_CUDA);
  vtkGetMacro(Engine, int);
  void SetEngineToAutomatic() { this->SetEngine(ENGINE_AUTOMATIC); }
  void SetEngineToCPU() { this->SetEngine(ENGINE_CPU); }
  void SetEngineToCUDA() { this->SetEngine(ENGINE_CUDA); }
  ///@}

  ///@{
  /**
   * Set/Get the number of points from which on ENGINE_AUTOMATIC uses the CUDA engine. The crossover
   * has not been measured. The default is VTK_ID_MAX: the CPU engine does all inputs. Every value
   * from VTK_INT_MAX on means the same.
   */
  vtkSetClampMacro(CUDAThreshold, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(CUDAThreshold, vtkIdType);
  ///@}

  ///@{
  /**
   * Get whether this build has a CUDA engine and this machine has a device that can run it; the
   * device's name (empty if there is none); and why there is none (empty if there is one). It
   * checks at the first call, and again where the device only failed for a moment.
   */
  static bool IsCUDAAvailable();
  static const char* GetCUDADeviceName();
  static const char* GetCUDAProblem();
  ///@}

  ///@{
  /**
   * Get the engine of the last run (ENGINE_CPU or ENGINE_CUDA; ENGINE_NONE if there was no result),
   * and the reason for it, in words. For several blocks with a result each: ENGINE_CUDA if any
   * block used it, and the reason of the last block that used the same engine.
   */
  int GetEngineUsed() { return this->Report.EngineUsed; }
  const char* GetEngineUsedAsString();
  const char* GetEngineReason();
  ///@}

  ///@{
  /**
   * Set/Get the number of threads. 0 (the default) means as many as vtkSMPTools uses: one, if its
   * backend is Sequential, as in Debian's ParaView and the wheels of VTK. -1 means all that the
   * machine has. The output does not depend on it.
   */
  vtkSetClampMacro(NumberOfThreads, int, -1, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * Set/Get how facets are given: as triangles (the default), or as one polygon a facet. As
   * triangles, a facet of more than three corners is a fan from the corner of lowest id.
   */
  vtkSetClampMacro(FacetMode, int, FACETS_AS_TRIANGLES, FACETS_AS_POLYGONS);
  vtkGetMacro(FacetMode, int);
  void SetFacetModeToTriangles() { this->SetFacetMode(FACETS_AS_TRIANGLES); }
  void SetFacetModeToPolygons() { this->SetFacetMode(FACETS_AS_POLYGONS); }
  ///@}

  ///@{
  /**
   * Set/Get what to do with points that have a NaN or infinite coordinate or weight: report an
   * error that names the first one (the default), or leave them out and count them in
   * GetNumberOfNonFinitePoints().
   */
  vtkSetClampMacro(NonFinitePoints, int, NON_FINITE_ERROR, NON_FINITE_IGNORE);
  vtkGetMacro(NonFinitePoints, int);
  void SetNonFinitePointsToError() { this->SetNonFinitePoints(NON_FINITE_ERROR); }
  void SetNonFinitePointsToIgnore() { this->SetNonFinitePoints(NON_FINITE_IGNORE); }
  ///@}

  ///@{
  /**
   * Set/Get whether ghost points are left out. On by default. Ghost points are those that the
   * input's point array vtkGhostType marks as another piece's
   * (vtkDataSetAttributes::DUPLICATEPOINT) or as hidden (HIDDENPOINT: blanked points of grids). If
   * on, they are on no output and are not counted; the other points keep their ids. If off, ghost
   * points are points like all others. Marks of cells do not matter.
   *
   * vtkFFConvexifyFilter uses its whole surface and ignores the marks.
   */
  vtkSetMacro(SkipGhostPoints, bool);
  vtkGetMacro(SkipGhostPoints, bool);
  vtkBooleanMacro(SkipGhostPoints, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether the input's point data arrays are passed to the output, in their full type and
   * precision. On by default. Attributes that describe the input's own surface (normals, tangents,
   * edge flags) become plain arrays: they would shade and draw another surface falsely.
   */
  vtkSetMacro(PassPointData, bool);
  vtkGetMacro(PassPointData, bool);
  vtkBooleanMacro(PassPointData, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether the output's array vtkOriginalPointIds is given a second time under the name
   * OriginalPointIds: some applications hide the first name from their users. Off by default.
   */
  vtkSetMacro(VisiblePointIds, bool);
  vtkGetMacro(VisiblePointIds, bool);
  vtkBooleanMacro(VisiblePointIds, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether the figures of a run are also given as field data of its output (of the first
   * port, in each block). Off by default. The arrays have one value each. An input's field data is
   * passed, except arrays whose names begin with FlipFlop, since they describe another run.
   *
   * - FlipFlopDimension, FlipFlopEngine, FlipFlopEngineReason (the
   *   latter two are strings): as of the Get functions
   * - FlipFlopVolume, FlipFlopArea of a hull; FlipFlopHiddenPoints,
   *   FlipFlopDroppedCells of a triangulation
   * - the paper's statistics, an array for each member of
   *   flipflop::Statistics: FlipFlopPoints, FlipFlopFlips22,
   *   FlipFlopSecondsTotal and so on. Documentation/Statistics.md says
   *   how to read them
   */
  vtkSetMacro(ReportAsFieldData, bool);
  vtkGetMacro(ReportAsFieldData, bool);
  vtkBooleanMacro(ReportAsFieldData, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether the V-biased variant of the algorithm is run (the end of the paper's section
   * 2.3). It flips by the volume criterion alone as long as it can, and only then labels a vertex.
   * The output is the same; the statistics differ. On by default: if points lie along curves, early
   * labels cost very many flips.
   */
  vtkSetMacro(VBiased, bool);
  vtkGetMacro(VBiased, bool);
  vtkBooleanMacro(VBiased, bool);
  ///@}

  /**
   * Get the dimension of what the last run's points span: -1 for no point, 0 for one position, 1
   * for collinear points, 2 for coplanar points, otherwise 3. For several blocks with a result
   * each: the greatest dimension.
   */
  int GetDimension() { return this->Report.Dimension; }

  ///@{
  /**
   * Get the number of points that the last run was given, without ghosts that are left out; and of
   * those, how many have a NaN or infinite coordinate or weight.
   */
  vtkIdType GetNumberOfInputPoints() { return this->Report.NumberOfInputPoints; }
  vtkIdType GetNumberOfNonFinitePoints() { return this->Report.NumberOfNonFinitePoints; }
  ///@}

protected:
  vtkFFAlgorithm();
  ~vtkFFAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * The work on one data set, or on the whole input: its results, one for each port, and its report
   * depend on settings and data alone. Threads may call this at the same time.
   */
  virtual void Execute(vtkDataObject* data, vtkInformationVector** inputVector,
    const std::vector<vtkDataObject*>& results, FFRun& run);

  /**
   * What a run makes, for the progress text: "Convex hull"; the class of each result; whether the
   * data sets of a composite are one input; whether Execute() can be called by several threads.
   */
  virtual const char* GetTitle() const { return this->GetClassName(); }
  virtual const char* GetResultType() const { return "vtkPolyData"; }
  virtual bool IsJoined() const { return false; }
  virtual bool IsConcurrent() const { return true; }

  vtkDataObject* GetSecondInput(); ///< of port 1; null: there is none

  int Engine = ENGINE_AUTOMATIC;
  vtkIdType CUDAThreshold; ///< VTK 9.1 cannot wrap this default: see the constructor
  int NumberOfThreads = 0;
  int FacetMode = FACETS_AS_TRIANGLES;
  int NonFinitePoints = NON_FINITE_ERROR;
  bool SkipGhostPoints = true;
  bool PassPointData = true;
  bool VisiblePointIds = false;
  bool ReportAsFieldData = false;
  bool VBiased = true;

  vtkFFReport Report; ///< of the last run

private:
  vtkFFAlgorithm(const vtkFFAlgorithm&) = delete;
  void operator=(const vtkFFAlgorithm&) = delete;

  friend class FFRun; // sets the report
};
VTK_ABI_NAMESPACE_END

#endif
