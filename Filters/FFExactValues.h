// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The values of VTK arrays as the engine reads them, never rounded.
 *
 * A single array of float or double in plain memory is read in place. Everything else is copied:
 * float arrays of another layout, and several float arrays, to floats; other arrays to doubles. If
 * a single array of float or double is on the CUDA device, the view names that memory as well. A
 * value that no double holds (some 64-bit integers) is an error, so that all results are exact.
 */

#ifndef FFExactValues_h
#define FFExactValues_h

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <flipflop/Buffer.h>
#include <flipflop/PointView.h>
#include <flipflop/Weights.h>

#include <cstdint>
#include <exception>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractArray;
class vtkAlgorithm;
class vtkDataArray;
class vtkDataSet;
class vtkIdList;
class vtkPointSet;
class vtkPoints;

/// Thrown for a value that no double holds: what a value is, "coordinate", and which point's.
class FFInexactValue : public std::exception
{
public:
  FFInexactValue(const char* kind, vtkIdType index)
    : Kind(kind)
    , Index(index)
  {
  }
  const char* what() const noexcept override { return "a value that no double holds"; }
  /// The sentence for users; @p where is "point 3 of the source".
  std::string Describe(const std::string& where) const;
  vtkIdType GetIndex() const { return this->Index; }

private:
  const char* Kind;
  vtkIdType Index;
};

/// Copy tuples between arrays of one type. VTK's own copies round 64-bit integers of some layouts.
void FFCopyTuples(
  vtkAbstractArray* from, vtkIdList* fromIds, vtkAbstractArray* to, vtkIdList* toIds);

/// Number i of the memory of a view of points or weights.
template <class View>
double FFNumberAt(const View& view, std::int64_t i)
{
  return view.type == flipflop::ScalarType::Float32 ? static_cast<const float*>(view.data)[i]
                                                    : static_cast<const double*>(view.data)[i];
}

/// The values of arrays as a view of the engine's, with as many components as its stride.
template <class View>
class FFValueSource
{
public:
  FFValueSource() = default;
  FFValueSource(const FFValueSource&) = delete;
  void operator=(const FFValueSource&) = delete;

  /// All values; valid as long as this object and the arrays exist.
  const View& GetView() const { return this->Values; }

protected:
  /// @throw FFInexactValue, flipflop::Error OutOfMemory
  void Read(const std::vector<vtkDataArray*>& arrays, const char* kind);

  View Values;
  int Type = VTK_FLOAT; // of the arrays; double if they differ
  flipflop::Buffer<float> Floats;
  flipflop::Buffer<double> Doubles;
};

/// The points of an array, or of several data sets, one after another. Null arrays hold no point.
class FFPointSource : public FFValueSource<flipflop::PointView>
{
public:
  explicit FFPointSource(vtkDataArray* array);
  explicit FFPointSource(const std::vector<vtkPointSet*>& pieces);

  /// The points that @p ids names, in the type of the arrays, with their bits.
  vtkSmartPointer<vtkPoints> Gather(const std::int64_t* ids, vtkIdType count) const;
};

/// The weights by the values of an array of one component, or the values of another noun.
class FFWeightSource : public FFValueSource<flipflop::WeightView>
{
public:
  /**
   * @param array null: no weights, and the rule does not matter
   * @param noun  what errors call a value
   * @throw flipflop::Error as computeWeights(); FFBadSetting for a factor that is not finite.
   */
  FFWeightSource(
    vtkDataArray* array, const flipflop::WeightRule& rule, const char* noun = "weight");

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
};
VTK_ABI_NAMESPACE_END

#endif
