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
 * Either input is any vtkPointSet, vtkImageData or vtkRectilinearGrid, or a composite of these
 * (vtkMultiBlockDataSet, vtkPartitionedDataSetCollection and other vtkDataObjectTrees). A composite
 * on port 0 gives a composite of the same structure. The points of a composite on port 1 count
 * together. The points of images and rectilinear grids are first copied to an array of double, 24
 * bytes each (of float, if all coordinates of a rectilinear grid are float).
 *
 * Errors are reported with vtkErrorMacro, in a sentence that names what is wrong and where. After
 * an error, the output is empty, GetErrorCode() differs from vtkErrorCode::NoError, and the update
 * fails, so no filter downstream runs. A run reports progress. It stops soon after a request to
 * abort; its output is then empty, too, but the update goes on.
 *
 * A leaf of a composite on port 0 that is at fault has no result (its place stays empty), and all
 * others have theirs. One error then describes the first such leaf, and names up to eight by their
 * flat indices. GetErrorCode() differs from vtkErrorCode::NoError, and what is downstream runs. The
 * update fails only where no leaf has a result, and after a fault of port 1.
 *
 * @sa
 * vtkFFSelectEnclosedPoints vtkFFPointInterpolator2D vtkFFAlgorithm
 */

#ifndef vtkFFQueryAlgorithm_h
#define vtkFFQueryAlgorithm_h

#include "vtkFFMarks.h"               // For VTK_MARSHALAUTO
#include "vtkFiltersFlipFlopModule.h" // For export macro
#include "vtkPassInputTypeAlgorithm.h"

#include <memory> // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFQueryAlgorithm
  : public vtkPassInputTypeAlgorithm
{
public:
  //@{
  /**
   * Standard methods for type information and printing.
   */
  vtkAbstractTypeMacro(vtkFFQueryAlgorithm, vtkPassInputTypeAlgorithm);
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
   * Set/Get the number of threads. 0 (the default) means as many as vtkSMPTools would use. If its
   * backend is Sequential, as in Debian's ParaView and the wheels of VTK, 0 means all that the
   * machine has. The output does not depend on it.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
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
  void SetNonFinitePointsToError() { this->SetNonFinitePoints(NON_FINITE_ERROR); }
  void SetNonFinitePointsToIgnore() { this->SetNonFinitePoints(NON_FINITE_IGNORE); }
  const char* GetNonFinitePointsAsString();
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
  vtkBooleanMacro(SkipGhostPoints, bool);
  //@}

  /**
   * Get the dimension of what the second input's points spanned in the last run: -1 for no point, 0
   * for one position, 1 for collinear points, 2 for coplanar points, otherwise 3.
   */
  vtkGetMacro(Dimension, int);

protected:
  vtkFFQueryAlgorithm();
  ~vtkFFQueryAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * What the filters do and how they differ in that. No installed header defines it.
   */
  class vtkInternals;

  /**
   * What a subclass does its own way.
   */
  void SetInternals(std::unique_ptr<vtkInternals> internals);
  vtkInternals* GetInternals() { return this->Internals.get(); }

  int NumberOfThreads;
  int NonFinitePoints;
  bool SkipGhostPoints;

private:
  vtkFFQueryAlgorithm(const vtkFFQueryAlgorithm&) = delete;
  void operator=(const vtkFFQueryAlgorithm&) = delete;

  std::unique_ptr<vtkInternals> Internals;

  int Dimension;
};
VTK_ABI_NAMESPACE_END

#endif
