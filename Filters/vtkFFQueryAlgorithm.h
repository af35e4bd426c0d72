// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFQueryAlgorithm
 * @brief   what the filters have in common that query something at points
 *
 * vtkFFQueryAlgorithm is the abstract superclass of the Flip-Flop filters that query something at
 * each point of their input (port 0), about the points of a second input (port 1). The output is a
 * shallow copy of the input, of the same type, with further point arrays, and without the field
 * data in which a Flip-Flop filter reports a run.
 *
 * Either input is any vtkDataSet, or a composite of these. Composite input on port 0 gives a
 * composite of the same structure (get it with GetOutputDataObject()). The points of a composite on
 * port 1 count together. What is made of the second input is kept, until that input or a setting
 * changes. If its values were changed in place, call Modified().
 *
 * Errors and aborts are as vtkFFAlgorithm says. One of the second input is reported once, and the
 * output is empty.
 *
 * @sa
 * vtkFFSelectEnclosedPoints vtkFFPointInterpolator2D vtkFFAlgorithm
 */

#ifndef vtkFFQueryAlgorithm_h
#define vtkFFQueryAlgorithm_h

#include "vtkDataSetAlgorithm.h"
#include "vtkFFMarks.h"               // For VTK_MARSHALAUTO
#include "vtkFFReport.h"              // For vtkFFReport
#include "vtkFiltersFlipFlopModule.h" // For export macro
#include "vtkTimeStamp.h"             // For vtkTimeStamp

#include <vector> // For std::vector

VTK_ABI_NAMESPACE_BEGIN
class FFRun;

class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFQueryAlgorithm : public vtkDataSetAlgorithm
{
public:
  ///@{
  /// Standard methods for type information and printing.
  vtkAbstractTypeMacro(vtkFFQueryAlgorithm, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /// What to do with points that have a NaN or infinite coordinate or weight.
  enum NonFinitePointsType
  {
    NON_FINITE_ERROR = 0,
    NON_FINITE_IGNORE = 1
  };

  ///@{
  /**
   * Set/Get the number of threads, as for vtkFFAlgorithm.
   */
  vtkSetClampMacro(NumberOfThreads, int, -1, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * Set/Get what to do with points of either input that have a NaN or infinite coordinate or
   * weight: report an error that names the first one (the default), or go on. Then such a point of
   * the input has the answer of a point far outside, and one of the second input is left out.
   */
  vtkSetClampMacro(NonFinitePoints, int, NON_FINITE_ERROR, NON_FINITE_IGNORE);
  vtkGetMacro(NonFinitePoints, int);
  void SetNonFinitePointsToError() { this->SetNonFinitePoints(NON_FINITE_ERROR); }
  void SetNonFinitePointsToIgnore() { this->SetNonFinitePoints(NON_FINITE_IGNORE); }
  ///@}

  ///@{
  /**
   * Set/Get whether points of the second input that its array vtkGhostType marks as DUPLICATEPOINT
   * or HIDDENPOINT are left out. On by default. All points of the first input have an answer.
   */
  vtkSetMacro(SkipGhostPoints, bool);
  vtkGetMacro(SkipGhostPoints, bool);
  vtkBooleanMacro(SkipGhostPoints, bool);
  ///@}

  /**
   * Get the dimension of what the second input's points spanned in the last run: -1 for no point
   * or no result, 0 for one position, 1 for collinear points, 2 for coplanar points, otherwise 3.
   */
  int GetDimension() { return this->Report.Dimension; }

protected:
  vtkFFQueryAlgorithm();
  ~vtkFFQueryAlgorithm() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * Have ready what is made of the second input, if it is not. Returns the share of the progress
   * that this took.
   */
  virtual double Prepare(vtkDataObject* source, FFRun& run) = 0;

  /**
   * The queries at one data set: its result, a shallow copy, depends on settings, data and what was
   * prepared alone. Threads may call this at the same time.
   */
  virtual void Execute(vtkDataObject* data, vtkDataSet* result, FFRun& run) = 0;

  virtual const char* GetTitle() const = 0; ///< of a run, for the progress text

  ///@{
  /**
   * Whether what is prepared is of that source as it is, and of the settings as they are. If not,
   * it is to be prepared: say when it is.
   */
  bool IsPrepared(vtkDataObject* source);
  void SetPrepared(vtkDataObject* source);
  ///@}

  /**
   * The input of port 1; null: there is none.
   */
  vtkDataObject* GetSecondInput();

  int NumberOfThreads = 0;
  int NonFinitePoints = NON_FINITE_ERROR;
  bool SkipGhostPoints = true;

  vtkFFReport Report; ///< of the last run

private:
  vtkFFQueryAlgorithm(const vtkFFQueryAlgorithm&) = delete;
  void operator=(const vtkFFQueryAlgorithm&) = delete;

  friend class FFRun; // sets the report

  vtkTimeStamp PreparedTime;
  std::vector<const vtkDataObject*> PreparedData; ///< the source, and its blocks; may be gone
};
VTK_ABI_NAMESPACE_END

#endif
