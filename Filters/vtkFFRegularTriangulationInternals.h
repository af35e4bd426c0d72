// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFRegularTriangulationFilter::vtkInternals
 * @brief   what vtkFFRegularTriangulationFilter does
 *
 * It finds the weights, has the points projected, and gives the triangulation, the hidden points
 * and the power diagram.
 */

#ifndef vtkFFRegularTriangulationInternals_h
#define vtkFFRegularTriangulationInternals_h

#include "vtkFFAlgorithmInternals.h"
#include "vtkFFMarks.h"
#include "vtkFFRegularTriangulationFilter.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkFFConstraints;
class vtkFFPointSource;
class vtkFFProjection;
class vtkPointSet;

class VTKFILTERSFLIPFLOP_EXPORT vtkFFRegularTriangulationFilter::vtkInternals
  : public vtkFFAlgorithm::vtkInternals
{
public:
  using vtkFFAlgorithm::vtkInternals::vtkInternals;

  void CheckSettings(vtkFFFailure& failure) override;
  void SelectBlocks(std::vector<Block>& blocks, vtkFFFailure& failure) override;
  void Execute(const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs,
    vtkFFFailure& failure) override;
  std::unique_ptr<vtkFFBlockWork> NewBlockWork(const Block& block) override;
  void ResetReport() override;
  std::string DescribeError(const flipflop::Error& error) override;

  /**
   * Whether there is a second input.
   */
  bool HasSource();

  /**
   * It is a failure if the input has several parts (blocks, processes) and there is a source.
   */
  void CheckParts(vtkIdType count, vtkFFFailure& failure);

protected:
  const char* GetProgressTitle() override;

  class Work;

  /**
   * Say, once an update, that the points, whose x and y are on a line, are in one vertical plane.
   */
  void WarnOfVerticalPlane();

  /**
   * The array of weights that was chosen; null: none was.
   *
   * @throw std::runtime_error where it does not fit.
   */
  vtkDataArray* FindWeights(vtkPointSet* input);

  void CheckSource(vtkFFFailure& failure);
  void Project(const vtkFFPointSource& points, vtkFFProjection& projection);

private:
  vtkFFRegularTriangulationFilter* GetTriangulationFilter();

  bool HasWarnedOfVerticalPlane = false;
  const vtkFFConstraints* Constraints = nullptr; // while there are some
};
VTK_ABI_NAMESPACE_END

#endif
