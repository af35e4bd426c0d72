// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFInterpolatedData.h"

#include "FFPlanarInput.h"
#include "FFRun.h"
#include "vtkFFPointInterpolator2D.h"

#include <flipflop/Error.h>

#include "vtkCharArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// So many points are asked about at once: their values are twice in memory.
constexpr std::int64_t pointsAtOnce = 1 << 18;

/// Points @p begin to @p end of a view.
flipflop::PointView partOf(const flipflop::PointView& points, std::int64_t begin, std::int64_t end)
{
  flipflop::PointView part = points;
  const std::int64_t size = points.type == flipflop::ScalarType::Float32 ? 4 : 8;
  part.data = static_cast<const char*>(points.data) + begin * points.stride * size;
  part.count = end - begin;
  part.deviceData = nullptr;
  return part;
}

/// The x and y of a point.
std::array<double, 2> positionAt(const flipflop::PointView& points, std::int64_t i)
{
  return { { FFPlanarInput::NumberAt(points, i * points.stride),
    FFPlanarInput::NumberAt(points, i * points.stride + 1) } };
}

/// The engine is asked about some points at a time, but the error is about all.
void demandFinite(const flipflop::PointView& points)
{
  std::int64_t first = -1;
  std::int64_t count = 0;
  for (std::int64_t i = 0; i < points.count; ++i)
  {
    const auto position = positionAt(points, i);
    if (!std::isfinite(position[0]) || !std::isfinite(position[1]))
    {
      first = count++ == 0 ? i : first;
    }
  }
  if (count > 0)
  {
    throw flipflop::Error(flipflop::ErrorCode::NonFinite, first, count);
  }
}

/// An array of float, if the other is, or of double; of so many tuples.
vtkSmartPointer<vtkDataArray> makeLike(
  vtkDataArray* array, const char* name, int components, vtkIdType count)
{
  vtkSmartPointer<vtkDataArray> made;
  made.TakeReference(
    vtkDataArray::CreateDataArray(array->GetDataType() == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE));
  made->SetName(name && *name ? name : nullptr);
  made->SetNumberOfComponents(components);
  made->SetNumberOfTuples(count);
  return made;
}

/// The same with the other's name and components.
vtkSmartPointer<vtkDataArray> makeLike(vtkDataArray* array, vtkIdType count)
{
  auto made = makeLike(array, array->GetName(), array->GetNumberOfComponents(), count);
  made->CopyComponentNames(array);
  return made;
}

}

//------------------------------------------------------------------------------
void FFInterpolatedData::FindFields(
  vtkPointData* data, vtkIdType count, const std::vector<std::string>& excluded)
{
  // Of the attributes, these stay what they are between the points.
  constexpr std::array<int, 4> kept{ { vtkDataSetAttributes::SCALARS, vtkDataSetAttributes::VECTORS,
    vtkDataSetAttributes::TENSORS, vtkDataSetAttributes::TCOORDS } };
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = data->GetArray(i);
    const int attribute = data->IsArrayAnAttribute(i);
    const std::string name = array && array->GetName() ? array->GetName() : "";
    if (array && array->GetNumberOfTuples() >= count &&
      name != vtkDataSetAttributes::GhostArrayName() &&
      attribute != vtkDataSetAttributes::GLOBALIDS &&
      attribute != vtkDataSetAttributes::PEDIGREEIDS &&
      std::find(excluded.begin(), excluded.end(), name) == excluded.end())
    {
      const bool isKept = std::find(kept.begin(), kept.end(), attribute) != kept.end();
      this->Fields.push_back({ array, isKept ? attribute : -1 });
    }
  }
}

//------------------------------------------------------------------------------
void FFInterpolatedData::SetValues(vtkPointSet* source, vtkPointData* data,
  const std::vector<std::string>& excluded, const char* nameOfZ)
{
  const vtkIdType count = source->GetNumberOfPoints();
  this->Fields.clear();
  if (data)
  {
    this->FindFields(data, count, excluded);
  }
  if (nameOfZ && source->GetPoints() && !(data && data->HasArray(nameOfZ)))
  {
    vtkDataArray* const positions = source->GetPoints()->GetData();
    const auto heights = makeLike(positions, nameOfZ, 1, count);
    heights->CopyComponent(0, positions, 2);
    this->Fields.push_back({ heights, -1 });
  }
  this->Components = 1;
  for (const FieldType& field : this->Fields)
  {
    this->Components += static_cast<std::size_t>(field.Array->GetNumberOfComponents());
  }
  this->Values.allocate(this->Components * static_cast<std::size_t>(count));
  double* values = this->Values.data();
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (const FieldType& field : this->Fields)
    {
      field.Array->GetTuple(i, values);
      values += field.Array->GetNumberOfComponents();
    }
    *values++ = 1.0;
  }
  for (FieldType& field : this->Fields)
  {
    field.Array = makeLike(field.Array, 0); // the source's own may go
  }
}

//------------------------------------------------------------------------------
FFInterpolatedData::TargetsType FFInterpolatedData::GetTargets(
  const flipflop::PointView& points, int mode, FFRun& run) const
{
  if (run.Options.nonFinite == flipflop::NonFinitePolicy::Error)
  {
    demandFinite(points);
  }
  using Queries = flipflop::TriangulationQueries;
  const auto query = mode == vtkFFPointInterpolator2D::NATURAL_NEIGHBOR
    ? &Queries::interpolateNatural
    : mode == vtkFFPointInterpolator2D::CLOUGH_TOCHER ? &Queries::interpolateCloughTocher
                                                      : &Queries::interpolateLinear;
  return { points.count, 1, pointsAtOnce,
    [this, points, query, &run](std::int64_t begin, std::int64_t end, double* results)
    {
      (this->Queries.*query)(this->Values.data(), static_cast<std::int64_t>(this->Components),
        partOf(points, begin, end), results, run.Options);
    },
    [points](std::int64_t i) { return positionAt(points, i); } };
}

//------------------------------------------------------------------------------
FFInterpolatedData::TargetsType FFInterpolatedData::GetTargets(
  const flipflop::ImageGrid& grid, std::int64_t slices, int mode, FFRun& run) const
{
  // All rows at once, unless that takes much memory: each time, all triangles are passed.
  constexpr std::int64_t numbersAtOnce = 1 << 25;
  const auto components = static_cast<std::int64_t>(this->Components);
  const std::int64_t columns = grid.size[0];
  using flipflop::Interpolation;
  const auto method = mode == vtkFFPointInterpolator2D::NATURAL_NEIGHBOR ? Interpolation::Natural
    : mode == vtkFFPointInterpolator2D::CLOUGH_TOCHER ? Interpolation::CloughTocher
                                                      : Interpolation::Linear;
  return { columns * grid.size[1], slices,
    columns * std::max<std::int64_t>(1, numbersAtOnce / (columns * components)),
    [this, method, components, columns, grid, &run](
      std::int64_t begin, std::int64_t end, double* results)
    {
      flipflop::ImageGrid part = grid;
      part.firstIndex[1] += begin / columns;
      part.size[1] = (end - begin) / columns;
      this->Queries.interpolateImage(method, this->Values.data(), components, part,
        flipflop::ImageView(results), std::nan(""), run.Options);
    },
    [columns, grid](std::int64_t i) -> std::array<double, 2>
    {
      const std::int64_t index[] = { i % columns, i / columns };
      std::array<double, 2> position;
      for (std::size_t k = 0; k < 2; ++k)
      {
        position[k] =
          grid.origin[k] + static_cast<double>(grid.firstIndex[k] + index[k]) * grid.spacing[k];
      }
      return position;
    } };
}

//------------------------------------------------------------------------------
FFInterpolatedData::ArraysType FFInterpolatedData::MakeArrays(
  vtkIdType count, const std::string& maskName) const
{
  // VTK's arrays would report a lack of memory by themselves.
  std::int64_t bytes = 1;
  for (const FieldType& field : this->Fields)
  {
    bytes += field.Array->GetNumberOfComponents() * field.Array->GetDataTypeSize();
  }
  if (count > std::numeric_limits<std::int64_t>::max() / bytes)
  {
    throw flipflop::Error(
      flipflop::ErrorCode::OutOfMemory, -1, std::numeric_limits<std::int64_t>::max());
  }
  flipflop::Buffer<char>(static_cast<std::size_t>(count * bytes));

  ArraysType arrays;
  for (const FieldType& field : this->Fields)
  {
    arrays.push_back(makeLike(field.Array, count));
  }
  arrays.push_back(vtkSmartPointer<vtkCharArray>::New());
  arrays.back()->SetName(maskName.c_str());
  arrays.back()->SetNumberOfTuples(count);
  return arrays;
}

//------------------------------------------------------------------------------
void FFInterpolatedData::FindClosest(const TargetsType& targets, std::int64_t begin,
  std::int64_t end, const flipflop::Options& options, flipflop::Buffer<double>& results) const
{
  const std::size_t stride = this->Components;
  std::vector<std::int64_t> nulls;
  std::vector<double> positions;
  for (std::int64_t i = begin; i < end; ++i)
  {
    if (std::isnan(results[static_cast<std::size_t>(i - begin + 1) * stride - 1]))
    {
      const auto position = targets.PositionOf(i);
      nulls.push_back(i - begin);
      positions.insert(positions.end(), position.begin(), position.end());
    }
  }
  if (nulls.empty())
  {
    return;
  }
  std::vector<std::int64_t> ids(nulls.size());
  const auto count = static_cast<std::int64_t>(nulls.size());
  this->Queries.nearest(flipflop::PointView(positions.data(), count, 2), ids.data(), options);
  for (std::size_t k = 0; k < nulls.size(); ++k)
  {
    if (ids[k] >= 0)
    {
      std::copy_n(this->Values.data() + static_cast<std::size_t>(ids[k]) * stride, stride,
        results.data() + static_cast<std::size_t>(nulls[k]) * stride);
    }
  }
}

//------------------------------------------------------------------------------
FFInterpolatedData::ArraysType FFInterpolatedData::Interpolate(
  const TargetsType& targets, const NullsType& nulls, FFRun& run) const
{
  ArraysType arrays =
    this->MakeArrays(static_cast<vtkIdType>(targets.Count * targets.Slices), nulls.MaskName);
  auto* const mask = vtkCharArray::SafeDownCast(arrays.back());
  const std::size_t stride = this->Components;
  flipflop::Buffer<double> results(
    stride * static_cast<std::size_t>(std::min(targets.Count, targets.AtOnce)));
  for (std::int64_t begin = 0; begin < targets.Count; begin += targets.AtOnce)
  {
    const std::int64_t end = std::min(targets.Count, begin + targets.AtOnce);
    const double share = 1.0 / static_cast<double>(targets.Count);
    run.SetPart(share * static_cast<double>(begin), share * static_cast<double>(end));
    targets.Query(begin, end, results.data());
    if (nulls.Strategy == vtkFFPointInterpolator2D::CLOSEST_POINT)
    {
      this->FindClosest(targets, begin, end, run.Options, results);
    }
    double* values = results.data();
    for (auto i = static_cast<vtkIdType>(begin); i < end; ++i)
    {
      // What is 1 at all points is NaN at null points alone.
      const bool isNull = std::isnan(values[stride - 1]);
      if (isNull)
      {
        std::fill_n(values, stride, nulls.Value);
      }
      for (std::int64_t slice = 0; slice < targets.Slices; ++slice)
      {
        const auto point = static_cast<vtkIdType>(slice * targets.Count + i);
        const double* from = values;
        mask->SetValue(point, isNull ? 0 : 1);
        for (std::size_t k = 0; k < this->Fields.size(); ++k)
        {
          arrays[k]->SetTuple(point, from);
          from += arrays[k]->GetNumberOfComponents();
        }
      }
      values += stride;
    }
  }
  return arrays;
}

//------------------------------------------------------------------------------
void FFInterpolatedData::AddArrays(
  const ArraysType& arrays, const NullsType& nulls, vtkPointData* output) const
{
  for (std::size_t k = 0; k < this->Fields.size(); ++k)
  {
    const int index = output->AddArray(arrays[k]);
    if (this->Fields[k].Attribute >= 0)
    {
      output->SetActiveAttribute(index, this->Fields[k].Attribute);
    }
  }
  if (nulls.Strategy == vtkFFPointInterpolator2D::MASK_POINTS)
  {
    output->AddArray(arrays.back());
  }
}
VTK_ABI_NAMESPACE_END
