// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The weights of a VTK array as the engine reads them.
 *
 * FFWeightSource gives the engine an array of one component. An array of float or double is not
 * copied if it has the layout that the engine needs. Everything else is copied: float arrays of
 * another layout to floats, other arrays to doubles. If an array of float or double is on the CUDA
 * device, the view names that memory as well. A value that no double holds is an error.
 *
 * By a rule other than the default, flipflop::computeWeights() makes weights of the values.
 */

#ifndef FFWeightSource_h
#define FFWeightSource_h

#include "vtkFFMarks.h"

#include <flipflop/Buffer.h>
#include <flipflop/PointView.h>
#include <flipflop/Weights.h>

#include "vtkType.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkDataArray;
class vtkDataSet;

class FFWeightSource
{
public:
  /**
   * The weights by the values of @p array; null: no weights.
   *
   * @throw FFInexactValue, flipflop::Error as computeWeights(); FFBadSetting for a factor
   *        that is not finite.
   * @param noun what errors call a value
   */
  FFWeightSource(
    vtkDataArray* array, const flipflop::WeightRule& rule, const char* noun = "weight");

  FFWeightSource(const FFWeightSource&) = delete;
  void operator=(const FFWeightSource&) = delete;

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
   * @param noun   what they call a value
   * @throw std::runtime_error where it does not fit.
   */
  static vtkDataArray* FindArray(vtkAlgorithm* filter, vtkDataSet* points,
    const std::string& ofWhat, const std::string& owner, const std::string& noun = "weight");

private:
  template <class T>
  void Convert(vtkDataArray* array, const char* kind, flipflop::Buffer<T>& copy);

  flipflop::WeightView View;
  flipflop::Buffer<float> Floats;
  flipflop::Buffer<double> Doubles;
};
VTK_ABI_NAMESPACE_END

#endif
