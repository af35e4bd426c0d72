// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFQueryAlgorithm
 * @brief   what the filters have in common that answer questions at points
 *
 * vtkFFQueryAlgorithm is the abstract superclass of the Flip-Flop filters that ask something at
 * each point of their input (port 0), about the points of a second input (port 1). The output is a
 * shallow copy of the input, of the same type, with the answers as further point arrays.
 *
 * Either input is any vtkDataSet, or a composite of these. Composite input on port 0 gives answers
 * for each data set in it, in a composite of the same structure (get it with
 * GetOutputDataObject()). The points of a composite on port 1 count together.
 *
 * What is made of the second input is kept. The next run uses it again if neither that input nor a
 * setting that concerns it has changed.
 *
 * The points of images and rectilinear grids are first copied to an array of double, 24 bytes each
 * (of float, if all coordinates of a rectilinear grid are float).
 *
 * An error is one message, of vtkErrorMacro: a sentence that names what is wrong and where. After
 * it, the output is empty, and GetErrorCode() is one of vtkFFErrorCode. A data set of a composite
 * on port 0 that is at fault has an empty result and one error, which counts the data sets from 0
 * on; all others have theirs. A run reports progress. It stops soon after a request to abort; its
 * output is then empty, too.
 *
 * @sa
 * vtkFFSelectEnclosedPoints vtkFFPointInterpolator2D vtkFFAlgorithm
 */

#ifndef vtkFFQueryAlgorithm_h
#define vtkFFQueryAlgorithm_h

#include "vtkDataSetAlgorithm.h"
#include "vtkFFMarks.h"               // For VTK_MARSHALAUTO
#include "vtkFiltersFlipFlopModule.h" // For export macro
#include "vtkMath.h"                  // For vtkMath::ClampValue
#include "vtkTimeStamp.h"             // For vtkTimeStamp

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFQueryAlgorithm : public vtkDataSetAlgorithm
{
public:
  //@{
  /**
   * Standard methods for type information and printing.
   */
  vtkAbstractTypeMacro(vtkFFQueryAlgorithm, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  //@}

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
   * Set/Get the number of threads. 0 (the default) means as many as vtkSMPTools uses: one, if its
   * backend is Sequential, as in Debian's ParaView and the wheels of VTK. -1 means all that the
   * machine has. The output does not depend on it.
   */
  virtual void SetNumberOfThreads(int count)
  {
    this->ChangeOutput(this->NumberOfThreads, vtkMath::ClampValue<int>(count, -1, VTK_INT_MAX));
  }
  vtkGetMacro(NumberOfThreads, int);
  //@}

  //@{
  /**
   * Set/Get what to do with points of either input that have a NaN or infinite coordinate or
   * weight: report an error that names the first one (the default), or go on. Then such a point of
   * the input has the answer of a point far outside, and one of the second input is left out.
   */
  vtkSetClampMacro(NonFinitePoints, int, NON_FINITE_ERROR, NON_FINITE_IGNORE);
  vtkGetMacro(NonFinitePoints, int);
  //@}

  //@{
  /**
   * Set/Get whether ghost points of the second input are left out. On by default. Ghost points are
   * those that the point array vtkGhostType marks as another piece's
   * (vtkDataSetAttributes::DUPLICATEPOINT) or as hidden (HIDDENPOINT: blanked points of grids). All
   * points of the first input have an answer, whatever their marks.
   */
  vtkSetMacro(SkipGhostPoints, bool);
  vtkGetMacro(SkipGhostPoints, bool);
  //@}

  /**
   * Get the dimension of what the second input's points spanned in the last run: -1 for no point
   * or no result, 0 for one position, 1 for collinear points, 2 for coplanar points, otherwise 3.
   */
  vtkGetMacro(Dimension, int);

  /**
   * Have the next Update() work on the second input again, even if that looks unchanged: its values
   * may have been changed in place. Settings that do not concern it do not call this.
   */
  void Modified() override;

protected:
  vtkFFQueryAlgorithm();
  ~vtkFFQueryAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * Change a setting that leaves valid what is kept of the second input, as Modified() does not.
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

  int NumberOfThreads = 0;
  int NonFinitePoints = NON_FINITE_ERROR;
  bool SkipGhostPoints = true;
  int Dimension = -1;
  bool IsSecondAtFault = false; ///< an error has said so, in the run of a composite's data sets

private:
  vtkFFQueryAlgorithm(const vtkFFQueryAlgorithm&) = delete;
  void operator=(const vtkFFQueryAlgorithm&) = delete;

  friend class vtkFFRun; // sets what the last run reports
  friend class vtkFFStamp;

  vtkTimeStamp ResultTime; ///< of the last Modified(): what was kept before is not valid

  vtkIdType DataSet = -1; ///< of a composite, that the executive has come to
  vtkIdType NumberOfDataSets = 0;
  bool IsAborted = false;
};
VTK_ABI_NAMESPACE_END

#endif
