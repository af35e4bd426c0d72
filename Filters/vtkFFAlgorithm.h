// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFAlgorithm
 * @brief   what the Flip-Flop filters have in common
 *
 * vtkFFAlgorithm is the abstract superclass of the filters that run the Flip-Flop engine. It has
 * their common settings, and the report of the last run. A run depends on the settings and the
 * input alone. It is exact: the sign of a determinant decides every branch that affects the output,
 * without a tolerance. The output does not depend on the engine, the number of threads or the
 * caller's floating-point environment, which observers of progress have.
 *
 * Input is any vtkDataSet. The points of images and rectilinear grids are first copied, as double
 * (float, if all coordinates of a rectilinear grid are). Composite input gives a result for each
 * data set, in a composite of the same structure on every port: get it with GetOutputDataObject().
 * Data sets of 4,096 points or fewer run side by side. What the filter reports are sums.
 *
 * Modes and counts end at their range's ends. Another number that is not allowed is an error of the
 * next Update(). An error is one message, of vtkErrorMacro, that names what is wrong and where;
 * GetErrorCode() is one of vtkFFErrorCode, and the output is empty. A data set of a composite at
 * fault has an empty result and an error, which counts the data sets from 0 on. After an abort, the
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
  /// Standard methods for type information and printing.
  vtkAbstractTypeMacro(vtkFFAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /// The engines. ENGINE_NONE is what GetEngineUsed() returns before a run.
  enum EngineType
  {
    ENGINE_NONE = -1,
    ENGINE_AUTOMATIC = 0,
    ENGINE_CPU = 1,
    ENGINE_CUDA = 2
  };

  /// How a flat facet of the result is given.
  enum FacetModeType
  {
    FACETS_AS_TRIANGLES = 0,
    FACETS_AS_POLYGONS = 1
  };

  /// What to do with points that have a NaN or infinite coordinate or weight.
  enum NonFinitePointsType
  {
    NON_FINITE_ERROR = 0,
    NON_FINITE_IGNORE = 1
  };

  /// Whose points the cells of a second input name, of filters that have such a source.
  enum SourcePointsType
  {
    AUTOMATIC_POINTS = 0,
    INPUT_POINTS = 1,
    OWN_POINTS = 2
  };

  ///@{
  /**
   * Set/Get the engine, which changes no bit of the output.
   *
   * - ENGINE_AUTOMATIC (the default): CUDA for CUDAThreshold points or
   *   more if IsCUDAAvailable(); otherwise, or if the device fails, CPU.
   *   The threshold is VTK_ID_MAX by default, since the crossover has
   *   not been measured: never, as every value from VTK_INT_MAX on.
   * - ENGINE_CPU: the CPU engine.
   * - ENGINE_CUDA: CUDA for any size; if it is not available or fails,
   *   that is an error. The CPU engine still does points that span too
   *   little, and coordinates that only large integers decide.
   *
   * With VTK 9.6 or later, CUDA reads a single array of float or double in place if it is on the
   * current device (a vtkmDataArray can be). The host reads the array, too.
   */
  vtkSetClampMacro(Engine, int, ENGINE_AUTOMATIC, ENGINE_CUDA);
  vtkGetMacro(Engine, int);
  void SetEngineToAutomatic() { this->SetEngine(ENGINE_AUTOMATIC); }
  void SetEngineToCPU() { this->SetEngine(ENGINE_CPU); }
  void SetEngineToCUDA() { this->SetEngine(ENGINE_CUDA); }
  vtkSetClampMacro(CUDAThreshold, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(CUDAThreshold, vtkIdType);
  ///@}

  ///@{
  /**
   * Get whether this build has a CUDA engine and this machine a device that can run it; the
   * device's name (empty: there is none); and why there is none (empty: there is one).
   */
  static bool IsCUDAAvailable();
  static const char* GetCUDADeviceName();
  static const char* GetCUDAProblem();
  ///@}

  ///@{
  /**
   * Get the engine of the last run (ENGINE_NONE: there was no result) and the reason for it, in
   * words. Of several blocks: ENGINE_CUDA if any used it, and the last such block's reason.
   */
  int GetEngineUsed() { return this->Report.EngineUsed; }
  const char* GetEngineUsedAsString();
  const char* GetEngineReason();
  ///@}

  ///@{
  /**
   * Set/Get the number of threads. 0 (the default): as many as vtkSMPTools uses; all of the
   * machine's where VTK has no threads of its own (the backend Sequential, as in Debian's
   * ParaView), and has not been told to have none. -1: all.
   */
  vtkSetClampMacro(NumberOfThreads, int, -1, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * Set/Get how facets are given: as triangles (the default; a facet of more than three corners is
   * a fan from the one of lowest id), or as one polygon a facet.
   */
  vtkSetClampMacro(FacetMode, int, FACETS_AS_TRIANGLES, FACETS_AS_POLYGONS);
  vtkGetMacro(FacetMode, int);
  void SetFacetModeToTriangles() { this->SetFacetMode(FACETS_AS_TRIANGLES); }
  void SetFacetModeToPolygons() { this->SetFacetMode(FACETS_AS_POLYGONS); }
  ///@}

  ///@{
  /**
   * Set/Get what to do with points that have a NaN or infinite coordinate or weight: report an
   * error that names the first one (the default), or leave them out and count them.
   */
  vtkSetClampMacro(NonFinitePoints, int, NON_FINITE_ERROR, NON_FINITE_IGNORE);
  vtkGetMacro(NonFinitePoints, int);
  void SetNonFinitePointsToError() { this->SetNonFinitePoints(NON_FINITE_ERROR); }
  void SetNonFinitePointsToIgnore() { this->SetNonFinitePoints(NON_FINITE_IGNORE); }
  ///@}

  ///@{
  /**
   * Set/Get whether points that the input's array vtkGhostType marks as DUPLICATEPOINT or
   * HIDDENPOINT are left out: on no output, and not counted. The others keep their ids. On by
   * default. vtkFFConvexifyFilter ignores the marks.
   */
  vtkSetMacro(SkipGhostPoints, bool);
  vtkGetMacro(SkipGhostPoints, bool);
  vtkBooleanMacro(SkipGhostPoints, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether the input's point data is passed, in full type and precision (on by default;
   * normals, tangents and edge flags become plain arrays: they describe another surface); and
   * whether the output's array vtkOriginalPointIds is given again as OriginalPointIds, since some
   * applications hide the first name (off by default).
   */
  vtkSetMacro(PassPointData, bool);
  vtkGetMacro(PassPointData, bool);
  vtkBooleanMacro(PassPointData, bool);
  vtkSetMacro(VisiblePointIds, bool);
  vtkGetMacro(VisiblePointIds, bool);
  vtkBooleanMacro(VisiblePointIds, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether what a run reports is also field data of its output (of port 0, in each block),
   * in arrays of one value: FlipFlopDimension, FlipFlopEngine and so on.
   * Documentation/Statistics.md has them all. Off by default. Such arrays of an input are never
   * passed.
   */
  vtkSetMacro(ReportAsFieldData, bool);
  vtkGetMacro(ReportAsFieldData, bool);
  vtkBooleanMacro(ReportAsFieldData, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether vertices are labelled only where no other flip remains (the V-biased variant,
   * the end of the paper's section 2.3). The output is the same. On by default: if points lie along
   * curves, early labels cost very many flips.
   */
  vtkSetMacro(VBiased, bool);
  vtkGetMacro(VBiased, bool);
  vtkBooleanMacro(VBiased, bool);
  ///@}

  ///@{
  /**
   * Get of the last run: the dimension of what its points span, from -1 for no point over 0 for one
   * position to 3 (of several blocks: the greatest); how many points it was given, without ghosts
   * that are left out; and how many of these have a NaN or infinite coordinate or weight. After an
   * error, -1 and 0; but of points that are not finite, those that it counts.
   */
  int GetDimension() { return this->Report.Dimension; }
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
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override; ///< of further inputs, all
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
