// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFWeightSource
 * @brief   the weights of a VTK array as the engine reads them
 *
 * vtkFFWeightSource gives the engine an array of one component. An array of float or double is not
 * copied if it has the layout that the engine needs. Everything else is copied: float arrays of
 * another layout to floats, other arrays to doubles. If an array of float or double is on the CUDA
 * device, the view names that memory as well. A value that no double holds is an error.
 *
 * With a Rule other than the default, the weights are computed from the values: in double, each
 * step rounded once.
 */

#ifndef vtkFFWeightSource_h
#define vtkFFWeightSource_h

#include "vtkFFMarks.h"

#include <flipflop/Buffer.h>
#include <flipflop/PointView.h>

#include "vtkType.h"

#include <exception>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkDataArray;
class vtkDataSet;

/**
 * Thrown for a value of which no weight can be made.
 */
class vtkFFBadWeight : public std::exception
{
public:
  vtkFFBadWeight(const char* sentence, vtkIdType index, const char* advice)
    : Sentence(sentence)
    , Index(index)
    , Advice(advice)
  {
  }
  const char* what() const noexcept override { return this->Sentence; }

  /// Which point it belongs to.
  vtkIdType GetIndex() const { return this->Index; }

  /// What helps, in a sentence.
  const char* GetAdvice() const { return this->Advice; }

private:
  const char* Sentence;
  vtkIdType Index;
  const char* Advice;
};

class vtkFFWeightSource
{
public:
  /**
   * What makes weights of the array's values: factor * value, or the square of factor * radius.
   */
  struct Rule
  {
    bool AreRadii = false;
    double Factor = 1.0;
  };

  /**
   * The weights by the values of @p array; null: no weights.
   *
   * @throw vtkFFInexactValue, vtkFFBadWeight, flipflop::Error OutOfMemory; vtkFFBadSetting for a
   *        factor that is not finite.
   */
  vtkFFWeightSource(vtkDataArray* array, const Rule& rule);

  vtkFFWeightSource(const vtkFFWeightSource&) = delete;
  void operator=(const vtkFFWeightSource&) = delete;

  /**
   * All weights; valid as long as this object and the array exist.
   */
  const flipflop::WeightView& GetView() const { return this->View; }

  /**
   * The point array that was chosen as the filter's array 0 to process; null: none was. It fits the
   * points.
   *
   * @param points those that are weighted, with their data
   * @param ofWhat how errors name them: " of the block of flat index 2"
   * @param owner  how they name the filter's input: "input"
   * @throw std::runtime_error where it does not fit.
   */
  static vtkDataArray* FindArray(
    vtkAlgorithm* filter, vtkDataSet* points, const std::string& ofWhat, const std::string& owner);

private:
  template <class T>
  void Convert(vtkDataArray* array, flipflop::Buffer<T>& copy);
  void Compute(vtkDataArray* array, const Rule& rule);

  flipflop::WeightView View;
  flipflop::Buffer<float> Floats;
  flipflop::Buffer<double> Doubles;
};
VTK_ABI_NAMESPACE_END

#endif
