// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The point data of a source at other positions, by its triangulation.
 *
 * FFInterpolatedData has a triangulation that is ready for queries, and the values of its
 * points. It makes the arrays of vtkFFPointInterpolator2D and vtkFFPointsToImage. Modes and
 * strategies are the enumerators of the former.
 */

#ifndef FFInterpolatedData_h
#define FFInterpolatedData_h

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <flipflop/Buffer.h>
#include <flipflop/PointView.h>
#include <flipflop/TriangulationQueries.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class FFRun;
class vtkPointData;
class vtkPointSet;

class FFInterpolatedData
{
public:
  /**
   * What is given values: points, or the pixels of one slice of an image.
   */
  struct TargetsType
  {
    std::int64_t Count = 0;
    std::int64_t Slices = 1; ///< that have the same values, one after the other
    std::int64_t AtOnce = 1; ///< so many are asked about at once
    std::function<void(std::int64_t begin, std::int64_t end, double* results)> Query;
    std::function<std::array<double, 2>(std::int64_t i)> PositionOf;
  };

  /**
   * What targets get where nothing can be interpolated.
   */
  struct NullsType
  {
    int Strategy;
    double Value;
    std::string MaskName;
  };

  explicit FFInterpolatedData(flipflop::TriangulationQueries&& queries)
    : Queries(std::move(queries))
  {
  }

  /**
   * Copy the values of the points that were triangulated.
   *
   * @param data     theirs; null: none of it is interpolated
   * @param excluded names of arrays that are not
   * @param nameOfZ  of the array of z; null: z is not interpolated, nor if an array has that name
   */
  void SetValues(vtkPointSet* source, vtkPointData* data, const std::vector<std::string>& excluded,
    const char* nameOfZ);

  ///@{
  /**
   * The targets at these points, or at the pixels of these slices: those have the bits that they
   * have as points, much sooner. Valid as long as all arguments and this object exist.
   *
   * @throw flipflop::Error NonFinite, unless the run ignores such points.
   */
  TargetsType GetTargets(const flipflop::PointView& points, int mode, FFRun& run) const;
  TargetsType GetTargets(
    const flipflop::ImageGrid& grid, std::int64_t slices, int mode, FFRun& run) const;
  ///@}

  using ArraysType = std::vector<vtkSmartPointer<vtkDataArray>>;

  /**
   * The arrays of the targets. The last one marks those that have values.
   *
   * @throw flipflop::Error as the queries; OutOfMemory also for arrays that do not fit.
   */
  ArraysType Interpolate(const TargetsType& targets, const NullsType& nulls, FFRun& run) const;

  /**
   * Add them to an output. Attributes of the source are the output's; the mask is added by
   * MASK_POINTS alone.
   */
  void AddArrays(const ArraysType& arrays, const NullsType& nulls, vtkPointData* output) const;

private:
  /// An array that is interpolated.
  struct FieldType
  {
    vtkSmartPointer<vtkDataArray> Array;
    int Attribute; // that it is in the output; -1: none
  };

  void FindFields(vtkPointData* data, vtkIdType count, const std::vector<std::string>& excluded);
  ArraysType MakeArrays(vtkIdType count, const std::string& maskName) const;
  void FindClosest(const TargetsType& targets, std::int64_t begin, std::int64_t end,
    const flipflop::Options& options, flipflop::Buffer<double>& results) const;

  flipflop::TriangulationQueries Queries;
  std::vector<FieldType> Fields;
  std::size_t Components = 1;      // of all fields, and 1
  flipflop::Buffer<double> Values; // so many of each point
};
VTK_ABI_NAMESPACE_END

#endif
