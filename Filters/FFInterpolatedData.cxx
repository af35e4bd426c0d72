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
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

using Interpolator = vtkFFPointInterpolator2D;
static_assert(int(flipflop::Interpolation::Linear) == Interpolator::LINEAR &&
    int(flipflop::Interpolation::Natural) == Interpolator::NATURAL_NEIGHBOR &&
    int(flipflop::Interpolation::CloughTocher) == Interpolator::CLOUGH_TOCHER,
  "modes are the engine's");

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
  return { { FFNumberAt(points, i * points.stride), FFNumberAt(points, i * points.stride + 1) } };
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

/// What is 1 at all points, the last component, is NaN at null points alone.
bool isNull(const double* values, std::size_t stride)
{
  return std::isnan(values[stride - 1]);
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
void FFInterpolatedData::SettingsType::PrintSelf(ostream& os, vtkIndent indent) const
{
  os << indent << "InterpolationMode: " << this->Mode << "\n";
  os << indent << "NullPointsStrategy: " << this->NullPointsStrategy << "\n";
  os << indent << "NullValue: " << this->NullValue << "\n";
  os << indent << "ValidPointsMaskArrayName: " << this->MaskName << "\n";
  os << indent << "InterpolateZ: " << (this->InterpolateZ ? "On" : "Off") << "\n";
  os << indent << "ZArrayName: " << this->ZName << "\n";
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
FFInterpolatedData::FFInterpolatedData(const SettingsType& settings,
  flipflop::TriangulationQueries&& queries, vtkPointSet* source, vtkPointData* data,
  const std::vector<std::string>& excluded)
  : Settings(settings)
  , Queries(std::move(queries))
{
  const vtkIdType count = source->GetNumberOfPoints();
  if (data)
  {
    this->FindFields(data, count, excluded);
  }
  const char* const nameOfZ = settings.ZName.c_str();
  if (settings.InterpolateZ && source->GetPoints() && !(data && data->HasArray(nameOfZ)))
  {
    vtkDataArray* const positions = source->GetPoints()->GetData();
    const auto heights = makeLike(positions, nameOfZ, 1, count);
    heights->CopyComponent(0, positions, 2);
    this->Fields.push_back({ heights, -1 });
  }
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
void FFInterpolatedData::Interpolate(
  const flipflop::PointView& points, FFRun& run, vtkPointData* output) const
{
  if (run.Options.nonFinite == flipflop::NonFinitePolicy::Error)
  {
    demandFinite(points);
  }
  using Queries = flipflop::TriangulationQueries;
  constexpr decltype(&Queries::interpolateLinear) queries[] = { &Queries::interpolateLinear,
    &Queries::interpolateNatural, &Queries::interpolateCloughTocher };
  const auto query = queries[this->Settings.Mode];
  const TargetsType targets{ points.count, 1, pointsAtOnce,
    [&](std::int64_t begin, std::int64_t end, double* results)
    {
      (this->Queries.*query)(this->Values.data(), static_cast<std::int64_t>(this->Components),
        partOf(points, begin, end), results, run.Options);
    },
    [&](std::int64_t i) { return positionAt(points, i); } };
  this->Interpolate(targets, run, output);
}

//------------------------------------------------------------------------------
void FFInterpolatedData::Interpolate(
  const flipflop::ImageGrid& grid, std::int64_t slices, FFRun& run, vtkPointData* output) const
{
  // All rows at once, unless that takes much memory: each time, all triangles are passed.
  constexpr std::int64_t numbersAtOnce = 1 << 25;
  const auto components = static_cast<std::int64_t>(this->Components);
  const std::int64_t columns = grid.size[0];
  const auto method = static_cast<flipflop::Interpolation>(this->Settings.Mode);
  const TargetsType targets{ columns * grid.size[1], slices,
    columns * std::max<std::int64_t>(1, numbersAtOnce / (columns * components)),
    [&](std::int64_t begin, std::int64_t end, double* results)
    {
      flipflop::ImageGrid part = grid;
      part.firstIndex[1] += begin / columns;
      part.size[1] = (end - begin) / columns;
      this->Queries.interpolateImage(method, this->Values.data(), components, part,
        flipflop::ImageView(results), std::nan(""), run.Options);
    },
    [&](std::int64_t i) -> std::array<double, 2>
    {
      const auto at = [&](int k, std::int64_t index) {
        return grid.origin[k] + static_cast<double>(grid.firstIndex[k] + index) * grid.spacing[k];
      };
      return { { at(0, i % columns), at(1, i / columns) } };
    } };
  this->Interpolate(targets, run, output);
}

//------------------------------------------------------------------------------
FFInterpolatedData::ArraysType FFInterpolatedData::MakeArrays(vtkIdType count) const
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
  arrays.back()->SetName(this->Settings.MaskName.c_str());
  arrays.back()->SetNumberOfTuples(count);
  return arrays;
}

//------------------------------------------------------------------------------
void FFInterpolatedData::FindClosest(const TargetsType& targets, std::int64_t begin,
  std::int64_t end, const flipflop::Options& options, double* results) const
{
  const std::size_t stride = this->Components;
  std::vector<std::int64_t> nulls;
  std::vector<double> positions;
  for (std::int64_t i = begin; i < end; ++i)
  {
    if (isNull(results + static_cast<std::size_t>(i - begin) * stride, stride))
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
        results + static_cast<std::size_t>(nulls[k]) * stride);
    }
  }
}

//------------------------------------------------------------------------------
void FFInterpolatedData::Interpolate(
  const TargetsType& targets, FFRun& run, vtkPointData* output) const
{
  const int strategy = this->Settings.NullPointsStrategy;
  const std::size_t stride = this->Components;
  const ArraysType arrays =
    this->MakeArrays(static_cast<vtkIdType>(targets.Count * targets.Slices));
  flipflop::Buffer<double> results(
    stride * static_cast<std::size_t>(std::min(targets.Count, targets.AtOnce)));
  for (std::int64_t begin = 0; begin < targets.Count; begin += targets.AtOnce)
  {
    const std::int64_t end = std::min(targets.Count, begin + targets.AtOnce);
    const double share = 1.0 / static_cast<double>(targets.Count);
    run.SetPart(share * static_cast<double>(begin), share * static_cast<double>(end));
    targets.Query(begin, end, results.data());
    if (strategy == Interpolator::CLOSEST_POINT)
    {
      this->FindClosest(targets, begin, end, run.Options, results.data());
    }
    double* values = results.data();
    for (std::int64_t i = begin; i < end; ++i, values += stride)
    {
      const bool isValid = !isNull(values, stride);
      std::fill_n(values, isValid ? 0 : stride - 1, this->Settings.NullValue);
      values[stride - 1] = isValid ? 1.0 : 0.0; // the mask's
      for (std::int64_t slice = 0; slice < targets.Slices; ++slice)
      {
        const double* from = values;
        for (const auto& array : arrays)
        {
          array->SetTuple(static_cast<vtkIdType>(slice * targets.Count + i), from);
          from += array->GetNumberOfComponents();
        }
      }
    }
  }
  for (std::size_t k = 0; k < this->Fields.size(); ++k)
  {
    const int index = output->AddArray(arrays[k]);
    if (this->Fields[k].Attribute >= 0)
    {
      output->SetActiveAttribute(index, this->Fields[k].Attribute);
    }
  }
  if (strategy == Interpolator::MASK_POINTS)
  {
    output->AddArray(arrays.back());
  }
}
VTK_ABI_NAMESPACE_END
