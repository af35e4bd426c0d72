// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFAlgorithm
 * @brief   what the Flip-Flop filters have in common
 *
 * vtkFFAlgorithm is the abstract superclass of the filters that run the Flip-Flop engine. It has
 * the properties that all of them share, and the figures that a run reports.
 *
 * The filters are exact: the exact sign of a determinant decides every branch that affects the
 * output. So there is no tolerance, and none can be set. The output is a function of the input
 * alone. It does not depend on the engine, nor on the number of threads, nor on the caller's
 * floating-point environment, which observers of progress have.
 *
 * A setting keeps what it is given, but for modes and counts, which end at their range's ends. A
 * number that is not allowed is an error of the next Update().
 *
 * An error is one message, of vtkErrorMacro: a sentence that names what is wrong and where. After
 * it, the output is empty, and GetErrorCode() is one of vtkFFErrorCode. A run reports progress. It
 * stops soon after a request to abort; its output is then empty, too, but for the data sets of a
 * composite that were done before.
 *
 * The algorithm is that of
 *
 * Mingcen Gao, Thanh-Tung Cao, Tiow-Seng Tan and Zhiyong Huang: "Flip-Flop: Convex Hull
 * Construction via Star-Shaped Polyhedron in 3D". Proceedings of the ACM SIGGRAPH Symposium on
 * Interactive 3D Graphics and Games (I3D), 2013.
 *
 * Input is any vtkDataSet. The points of a vtkImageData or a vtkRectilinearGrid are first copied to
 * an array of double, 24 bytes each (of float, if all coordinates of a rectilinear grid are float).
 * vtkFFConvexifyFilter accepts a vtkPolyData.
 *
 * Composite input gives a result for each data set in it, in a composite of the same structure on
 * every port (get it with GetOutputDataObject()), as with VTK's own filters. A data set at fault
 * has an empty result and one error, which counts the data sets from 0 on; all others have theirs.
 * GetErrorCode() is that of the last one at fault, and what the filter reports are sums.
 *
 * @sa
 * vtkFFHullAlgorithm vtkFFHullFilter vtkFFConvexifyFilter vtkFFRegularTriangulationFilter
 */

#ifndef vtkFFAlgorithm_h
#define vtkFFAlgorithm_h

#include "vtkFFMarks.h"               // For VTK_MARSHALAUTO
#include "vtkFiltersFlipFlopModule.h" // For export macro
#include "vtkMath.h"                  // For vtkMath::ClampValue
#include "vtkPolyDataAlgorithm.h"
#include "vtkTimeStamp.h" // For vtkTimeStamp

#include <string> // For std::string

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
  //@}

  //@{
  /**
   * Set/Get the number of points from which on ENGINE_AUTOMATIC uses the CUDA engine. The crossover
   * has not been measured. The default is VTK_ID_MAX: the CPU engine does all inputs. Every value
   * from VTK_INT_MAX on means the same.
   */
  vtkSetClampMacro(CUDAThreshold, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(CUDAThreshold, vtkIdType);
  //@}

  //@{
  /**
   * Get whether this build has a CUDA engine and this machine has a device that can run it; the
   * device's name (empty if there is none); and why there is none (empty if there is one). It
   * checks at the first call, and again where the device only failed for a moment.
   */
  static bool IsCUDAAvailable();
  static const char* GetCUDADeviceName();
  static const char* GetCUDAProblem();
  //@}

  //@{
  /**
   * Get the engine of the last run (ENGINE_CPU or ENGINE_CUDA; ENGINE_NONE if there was no result),
   * and the reason for it, in words. For several blocks with a result each: ENGINE_CUDA if any
   * block used it, and the reason of the last block that used the same engine.
   */
  vtkGetMacro(EngineUsed, int);
  const char* GetEngineUsedAsString();
  const char* GetEngineReason() { return this->EngineReason.c_str(); }
  //@}

  //@{
  /**
   * Set/Get the number of threads. 0 (the default) means as many as vtkSMPTools uses: one, if its
   * backend is Sequential, as in Debian's ParaView and the wheels of VTK. -1 means all that the
   * machine has. The output does not depend on it.
   */
  vtkSetClampMacro(NumberOfThreads, int, -1, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  //@}

  //@{
  /**
   * Set/Get how facets are given: as triangles (the default), or as one polygon a facet. As
   * triangles, a facet of more than three corners is a fan from the corner of lowest id.
   */
  virtual void SetFacetMode(int mode)
  {
    this->ChangeOutput(
      this->FacetMode, vtkMath::ClampValue<int>(mode, FACETS_AS_TRIANGLES, FACETS_AS_POLYGONS));
  }
  vtkGetMacro(FacetMode, int);
  //@}

  //@{
  /**
   * Set/Get what to do with points that have a NaN or infinite coordinate or weight: report an
   * error that names the first one (the default), or leave them out and count them in
   * GetNumberOfNonFinitePoints().
   */
  vtkSetClampMacro(NonFinitePoints, int, NON_FINITE_ERROR, NON_FINITE_IGNORE);
  vtkGetMacro(NonFinitePoints, int);
  //@}

  //@{
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
  //@}

  //@{
  /**
   * Set/Get whether the input's point data arrays are passed to the output, in their full type and
   * precision. On by default. Attributes that describe the input's own surface (normals, tangents,
   * edge flags) become plain arrays: they would shade and draw another surface falsely.
   */
  virtual void SetPassPointData(bool on) { this->ChangeOutput(this->PassPointData, on); }
  vtkGetMacro(PassPointData, bool);
  //@}

  //@{
  /**
   * Set/Get whether the output's array vtkOriginalPointIds is given a second time under the name
   * OriginalPointIds: some applications hide the first name from their users. Off by default.
   */
  virtual void SetVisiblePointIds(bool on) { this->ChangeOutput(this->VisiblePointIds, on); }
  vtkGetMacro(VisiblePointIds, bool);
  //@}

  //@{
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
  virtual void SetReportAsFieldData(bool on) { this->ChangeOutput(this->ReportAsFieldData, on); }
  vtkGetMacro(ReportAsFieldData, bool);
  //@}

  //@{
  /**
   * Set/Get whether the V-biased variant of the algorithm is run (the end of the paper's section
   * 2.3). It flips by the volume criterion alone as long as it can, and only then labels a vertex.
   * The output is the same; the statistics differ. On by default: if points lie along curves, early
   * labels cost very many flips.
   */
  vtkSetMacro(VBiased, bool);
  vtkGetMacro(VBiased, bool);
  //@}

  /**
   * Get the dimension of what the last run's points span: -1 for no point, 0 for one position, 1
   * for collinear points, 2 for coplanar points, otherwise 3. For several blocks with a result
   * each: the greatest dimension.
   */
  vtkGetMacro(Dimension, int);

  //@{
  /**
   * Get the number of points that the last run was given, without ghosts that are left out; and of
   * those, how many have a NaN or infinite coordinate or weight.
   */
  vtkGetMacro(NumberOfInputPoints, vtkIdType);
  vtkGetMacro(NumberOfNonFinitePoints, vtkIdType);
  //@}

  /**
   * Have the next Update() work on the input again, even if that looks unchanged: its values may
   * have been changed in place. Settings that concern the output alone do not call this, so that
   * what the filter keeps of its last run serves them.
   */
  void Modified() override;

protected:
  vtkFFAlgorithm();
  ~vtkFFAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * Change a setting that leaves valid what is kept of the last run, as Modified() does not.
   */
  template <class T>
  void ChangeOutput(T& setting, T value)
  {
    if (setting != value)
    {
      setting = value;
      this->OutputModified();
    }
  }
  void OutputModified() { this->Superclass::Modified(); }

  /**
   * Forget what the last run reported: before each run, and before the first data set of a
   * composite, of which there may be none. A subclass adds what is its own.
   */
  virtual void ForgetReport();

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

private:
  vtkFFAlgorithm(const vtkFFAlgorithm&) = delete;
  void operator=(const vtkFFAlgorithm&) = delete;

  friend class vtkFFRun;
  friend class vtkFFStamp;

  vtkTimeStamp ResultTime; ///< of the last Modified(): a result that was kept before is not valid
  int EngineUsed = ENGINE_NONE;
  std::string EngineReason = "no engine has run";
  int Dimension = -1;
  vtkIdType NumberOfInputPoints = 0;
  vtkIdType NumberOfNonFinitePoints = 0;
  vtkIdType DataSet = -1; ///< of a composite, that the executive has come to
  vtkIdType NumberOfDataSets = 0;
  bool IsAborted = false;
};
VTK_ABI_NAMESPACE_END

#endif
