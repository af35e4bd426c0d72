// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The point data of a source at other positions, by its triangulation.
 *
 * FFInterpolatedData has a triangulation that is ready for queries, and the values of its points.
 * It makes the arrays of vtkFFPointInterpolator2D and vtkFFPointsToImage.
 */

#ifndef FFInterpolatedData_h
#define FFInterpolatedData_h

#include "vtkFFMarks.h"
#include "vtkIndent.h"
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
   * The settings that both filters have. Modes and strategies are the enumerators of
   * vtkFFPointInterpolator2D.
   */
  struct SettingsType
  {
    template <class Filter>
    explicit SettingsType(Filter* filter)
      : Mode(filter->GetInterpolationMode())
      , NullPointsStrategy(filter->GetNullPointsStrategy())
      , NullValue(filter->GetNullValue())
      , MaskName(filter->GetValidPointsMaskArrayName())
      , InterpolateZ(filter->GetInterpolateZ())
      , ZName(filter->GetZArrayName())
    {
    }
    void PrintSelf(ostream& os, vtkIndent indent) const;

    int Mode;
    int NullPointsStrategy;
    double NullValue;
    std::string MaskName;
    bool InterpolateZ;
    std::string ZName;
  };

  ///@{
  /// Of a run's progress: until the triangulation is there, and until all is prepared.
  static constexpr double ShareOfTriangulation = 0.2;
  static constexpr double ShareOfPreparing = 0.4;
  ///@}

  /**
   * Copy the values of the points that were triangulated.
   *
   * @param data     theirs; null: none of it is interpolated
   * @param excluded names of arrays that are not
   */
  FFInterpolatedData(const SettingsType& settings, flipflop::TriangulationQueries&& queries,
    vtkPointSet* source, vtkPointData* data, const std::vector<std::string>& excluded = {});

  ///@{
  /**
   * Add the arrays of these points, or of the pixels of an image of so many slices, which have the
   * bits that they have as points, much sooner. Attributes of the source become the output's.
   *
   * @throw flipflop::Error as the queries; NonFinite, unless the run ignores such points;
   *        OutOfMemory also for arrays that do not fit.
   */
  void Interpolate(const flipflop::PointView& points, FFRun& run, vtkPointData* output) const;
  void Interpolate(
    const flipflop::ImageGrid& grid, std::int64_t slices, FFRun& run, vtkPointData* output) const;
  ///@}

private:
  /// An array that is interpolated.
  struct FieldType
  {
    vtkSmartPointer<vtkDataArray> Array;
    int Attribute; // that it is in the output; -1: none
  };

  /// What is given values: points, or the pixels of one slice of an image.
  struct TargetsType
  {
    std::int64_t Count;
    std::int64_t Slices; // that have the same values, one after the other
    std::int64_t AtOnce; // so many are asked about at once
    std::function<void(std::int64_t begin, std::int64_t end, double* results)> Query;
    std::function<std::array<double, 2>(std::int64_t i)> PositionOf;
  };

  using ArraysType = std::vector<vtkSmartPointer<vtkDataArray>>;

  void FindFields(vtkPointData* data, vtkIdType count, const std::vector<std::string>& excluded);
  ArraysType MakeArrays(vtkIdType count) const; // the last one is the mask
  void FindClosest(const TargetsType& targets, std::int64_t begin, std::int64_t end,
    const flipflop::Options& options, double* results) const;
  void Interpolate(const TargetsType& targets, FFRun& run, vtkPointData* output) const;

  const SettingsType Settings;
  const flipflop::TriangulationQueries Queries;
  std::vector<FieldType> Fields;
  std::size_t Components = 1;      // of all fields, and 1
  flipflop::Buffer<double> Values; // so many of each point
};
VTK_ABI_NAMESPACE_END

#endif
