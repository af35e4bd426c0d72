// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFQueryAlgorithm::vtkInternals
 * @brief   what the filters do that answer questions at points
 *
 * That of vtkFFQueryAlgorithm takes both inputs apart, makes the output, and says what went wrong;
 * that of a filter prepares the second input's points, and answers at points of the first.
 */

#ifndef vtkFFQueryInternals_h
#define vtkFFQueryInternals_h

#include "vtkFFFailure.h"
#include "vtkFFGuard.h"
#include "vtkFFMarks.h"
#include "vtkFFQueryAlgorithm.h"
#include "vtkPointSet.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

namespace flipflop
{
struct PointView;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataObject;
class vtkDataSet;
class vtkPointSet;

class vtkFFQueryAlgorithm::vtkInternals : public vtkFFGuard
{
public:
  explicit vtkInternals(vtkFFQueryAlgorithm* filter);

  vtkFFQueryAlgorithm* GetFilter() const { return this->Filter; }

  /**
   * A whole run. False when nothing has a result, after an error or an abort: the output is empty
   * then.
   */
  bool RunFilter(vtkDataObject* input, vtkDataObject* second, vtkDataObject* output);

  /**
   * Only its first half, outside the pipeline: the second input's points are made ready.
   */
  bool RunPrepare(vtkDataObject* second);

  /**
   * A question outside the pipeline, guarded: what went wrong is an error.
   */
  void Ask(const std::function<void()>& question);

  /**
   * What was prepared goes.
   */
  virtual void Forget() = 0;

  /**
   * Whether what was prepared stays after a run, for single questions.
   */
  virtual bool KeepsPrepared() { return false; }

  /**
   * What this filter calls its second input, in a word: "surface". Its setters have that name.
   */
  virtual std::string GetSecondName() = 0;

  /**
   * Make the points of some pieces, ghosts left out, ready for questions.
   *
   * @return their dimension
   * @throw vtkFFInexactValue, std::exception, flipflop::Error: also in the next function.
   */
  virtual int Prepare(
    const std::vector<vtkPointSet*>& pieces, const flipflop::Options& options) = 0;

  /**
   * Answer at each of the points, which are @p output's: as point arrays of it.
   */
  virtual void Answer(
    const flipflop::PointView& points, const flipflop::Options& options, vtkDataSet* output) = 0;

  /**
   * The coordinates of each piece; null where it has none.
   */
  static std::vector<vtkDataArray*> ArraysOf(const std::vector<vtkPointSet*>& pieces);

  /**
   * The options of a run, as they are set here.
   */
  flipflop::Options GetOptions();

  vtkIdType GetPlaceOfPoint(vtkIdType index) override;
  std::string DescribePoint(vtkIdType place) override;

  /**
   * How errors name the one data set that is worked on: " of the source"; nothing where there are
   * several.
   */
  std::string OfBlock() override;

protected:
  void SetErrorCode(unsigned long code) override;
  void MarkAborted() override;

private:
  /// A data set of an input.
  struct Leaf
  {
    vtkDataSet* Data;
    std::string OfWhat; // " of the block of flat index 2 of the surface"
    unsigned int FlatIndex;
    vtkSmartPointer<vtkPointSet> Points{}; // null: there is a failure
    vtkFFFailure Failure{};

    vtkIdType GetNumberOfPoints() const
    {
      return this->Points ? this->Points->GetNumberOfPoints() : 0;
    }
  };

  /// Calls work() guarded, and reports what went wrong. Returns what work() returns, or false.
  bool Run(const std::function<bool(vtkFFFailure&)>& work);

  void TakeSecond(vtkDataObject* second);
  bool AnswerAll(vtkDataObject* input, vtkDataObject* output, vtkFFFailure& failure);
  void AnswerLeaf(Leaf& leaf, vtkDataSet* result);
  Leaf MakeLeaf(vtkDataObject* data, unsigned int flatIndex, const std::string& name);
  void TakePoints(vtkDataObject* data, const std::string& name, Leaf& leaf);
  std::vector<Leaf> LeavesOf(vtkDataObject* data, const std::string& name);

  /// What is being worked on, for errors: points of these leaves, one after another.
  std::vector<Leaf> Current;
  std::vector<vtkIdType> PlacesOfPoints; // among them, of those that the engine has; empty: all
  bool Watched = true;                   // as the pipeline's runs are: by progress and abort

  vtkFFQueryAlgorithm* const Filter;
};
VTK_ABI_NAMESPACE_END

#endif
