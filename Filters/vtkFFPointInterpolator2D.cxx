// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFPointInterpolator2D.h"

#include "vtkFFInput.h"
#include "vtkFFOutput.h"
#include "vtkFFPlanarInput.h"
#include "vtkFFPointSource.h"
#include "vtkFFRun.h"
#include "vtkFFStamp.h"
#include "vtkFFWeightSource.h"

#include <flipflop/Error.h>
#include <flipflop/RegularTriangulation.h>
#include <flipflop/TriangulationQueries.h>

#include "vtkAlgorithmOutput.h"
#include "vtkCellData.h"
#include "vtkCharArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFPointInterpolator2D);

namespace
{

/// Of the progress of a run that prepares its source: until the triangulation is there, and until
/// all is.
constexpr double shareOfTriangulation = 0.2;
constexpr double shareOfPreparing = 0.4;

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
  return { { vtkFFPlanarInput::NumberAt(points, i * points.stride),
    vtkFFPlanarInput::NumberAt(points, i * points.stride + 1) } };
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

/// An array that is interpolated.
struct Field
{
  vtkSmartPointer<vtkDataArray> Array;
  int Attribute; // that it is in the output; -1: none
};

}

/// The triangulation of a source's points, ready for questions, with their values.
struct vtkFFPreparedSource
{
  vtkFFStamp Stamp;       // of the triangulation
  vtkFFStamp WeightStamp; // how weights are computed
  bool IsWeighted;        // else they are not
  int Dimension;
  flipflop::TriangulationQueries Queries;

  vtkFFStamp ValueStamp{}; // how values are chosen
  std::vector<Field> Fields{};
  std::size_t Components = 1;        // of all fields, and 1
  flipflop::Buffer<double> Values{}; // so many of each point
};

namespace
{

std::unique_ptr<vtkFFPreparedSource> triangulate(vtkFFPointInterpolator2D* filter,
  const vtkFFStamp& stamp, const vtkFFStamp& weightStamp, vtkPointSet* source, vtkFFRun& run)
{
  vtkPoints* const positions = source->GetPoints();
  const vtkFFPointSource points(positions ? positions->GetData() : nullptr);
  const vtkFFWeightSource weights(
    vtkFFWeightSource::FindArray(filter, source, run.OfWhat(), "source"),
    flipflop::WeightRule{
      filter->GetWeightMode() == vtkFFPointInterpolator2D::RADII, filter->GetWeightFactor() });
  run.SetPart(0.0, shareOfTriangulation);
  const flipflop::Triangulation triangulation =
    flipflop::regularTriangulation(points.GetView(), weights.GetView(), run.Options);
  run.SetPart(shareOfTriangulation, shareOfPreparing);
  flipflop::TriangulationQueries queries(
    points.GetView(), weights.GetView(), triangulation, run.Options);
  return std::unique_ptr<vtkFFPreparedSource>(new vtkFFPreparedSource{ stamp, weightStamp,
    weights.GetView().data != nullptr, triangulation.dimension, std::move(queries) });
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

/// The arrays of the source that are interpolated, also z if it is.
std::vector<Field> fieldsOf(
  vtkFFPointInterpolator2D* filter, const std::vector<std::string>& excluded, vtkPointSet* source)
{
  // Of the attributes, these stay what they are between the points.
  constexpr std::array<int, 4> kept{ { vtkDataSetAttributes::SCALARS, vtkDataSetAttributes::VECTORS,
    vtkDataSetAttributes::TENSORS, vtkDataSetAttributes::TCOORDS } };
  const vtkIdType count = source->GetNumberOfPoints();
  vtkPointData* const data = source->GetPointData();
  std::vector<Field> fields;
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
      fields.push_back({ array, isKept ? attribute : -1 });
    }
  }
  const std::string nameOfZ = filter->GetZArrayName();
  if (filter->GetInterpolateZ() && source->GetPoints() && !data->HasArray(nameOfZ.c_str()))
  {
    vtkDataArray* const positions = source->GetPoints()->GetData();
    const auto heights = makeLike(positions, nameOfZ.c_str(), 1, count);
    heights->CopyComponent(0, positions, 2);
    fields.push_back({ heights, -1 });
  }
  return fields;
}

/// The values of the source's points, each point's together, and 1.
void takeValues(vtkIdType count, vtkFFPreparedSource& prepared)
{
  std::size_t stride = 1;
  for (const Field& field : prepared.Fields)
  {
    stride += static_cast<std::size_t>(field.Array->GetNumberOfComponents());
  }
  prepared.Components = stride;
  prepared.Values.allocate(stride * static_cast<std::size_t>(count));
  double* values = prepared.Values.data();
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (const Field& field : prepared.Fields)
    {
      field.Array->GetTuple(i, values);
      values += field.Array->GetNumberOfComponents();
    }
    *values++ = 1.0;
  }
  for (Field& field : prepared.Fields)
  {
    field.Array = makeLike(field.Array, 0); // the source's own may go
  }
}

/// What is given values: points, or the pixels of one slice of an image.
struct Targets
{
  std::int64_t Count = 0;
  std::int64_t Slices = 1; // that have the same values, one after the other
  std::int64_t AtOnce = 1; // so many are asked about at once
  std::function<void(std::int64_t begin, std::int64_t end, double* results)> Query;
  std::function<std::array<double, 2>(std::int64_t i)> PositionOf;
};

Targets targetsOf(
  const flipflop::PointView& points, int mode, const vtkFFPreparedSource& source, vtkFFRun& run)
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
    [points, query, &source, &run](std::int64_t begin, std::int64_t end, double* results)
    {
      (source.Queries.*query)(source.Values.data(), static_cast<std::int64_t>(source.Components),
        partOf(points, begin, end), results, run.Options);
    },
    [points](std::int64_t i) { return positionAt(points, i); } };
}

/// Where the pixels of an image's slices are. False: they are not along the axes, not finite, or
/// none.
bool takeGrid(vtkImageData* image, flipflop::ImageGrid& grid)
{
  bool isGrid =
    image && image->GetNumberOfPoints() > 0 && image->GetDirectionMatrix()->IsIdentity();
  for (int i = 0; isGrid && i < 2; ++i)
  {
    grid.origin[i] = image->GetOrigin()[i];
    grid.spacing[i] = image->GetSpacing()[i];
    grid.size[i] = image->GetDimensions()[i];
    grid.firstIndex[i] = image->GetExtent()[2 * i];
    isGrid = std::isfinite(grid.origin[i]) && std::isfinite(grid.spacing[i]) &&
      std::isfinite(grid.origin[i] + image->GetExtent()[2 * i] * grid.spacing[i]) &&
      std::isfinite(grid.origin[i] + image->GetExtent()[2 * i + 1] * grid.spacing[i]);
  }
  return isGrid;
}

/// The same bits as by its points, much sooner.
Targets targetsOf(const flipflop::ImageGrid& grid, std::int64_t slices, int mode,
  const vtkFFPreparedSource& source, vtkFFRun& run)
{
  // All rows at once, unless that takes much memory: each time, all triangles are passed.
  constexpr std::int64_t numbersAtOnce = 1 << 25;
  const auto components = static_cast<std::int64_t>(source.Components);
  const std::int64_t columns = grid.size[0];
  using flipflop::Interpolation;
  const auto method = mode == vtkFFPointInterpolator2D::NATURAL_NEIGHBOR ? Interpolation::Natural
    : mode == vtkFFPointInterpolator2D::CLOUGH_TOCHER ? Interpolation::CloughTocher
                                                      : Interpolation::Linear;
  return { columns * grid.size[1], slices,
    columns * std::max<std::int64_t>(1, numbersAtOnce / (columns * components)),
    [=, &source, &run](std::int64_t begin, std::int64_t end, double* results)
    {
      flipflop::ImageGrid part = grid;
      part.firstIndex[1] += begin / columns;
      part.size[1] = (end - begin) / columns;
      source.Queries.interpolateImage(method, source.Values.data(), components, part,
        flipflop::ImageView(results), std::nan(""), run.Options);
    },
    [=](std::int64_t i) -> std::array<double, 2>
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

/// Null points get the values of the closest point.
void findClosest(const vtkFFPreparedSource& source, const Targets& targets, std::int64_t begin,
  std::int64_t end, const flipflop::Options& options, flipflop::Buffer<double>& results)
{
  const std::size_t stride = source.Components;
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
  source.Queries.nearest(flipflop::PointView(positions.data(), count, 2), ids.data(), options);
  for (std::size_t k = 0; k < nulls.size(); ++k)
  {
    if (ids[k] >= 0)
    {
      std::copy_n(source.Values.data() + static_cast<std::size_t>(ids[k]) * stride, stride,
        results.data() + static_cast<std::size_t>(nulls[k]) * stride);
    }
  }
}

/// Interpolates at all points: the values of the fields. The last array that is returned marks the
/// points that have values; the engine's value of 1 is NaN at the others.
std::vector<vtkSmartPointer<vtkDataArray>> interpolate(vtkFFPointInterpolator2D* filter,
  const vtkFFPreparedSource& source, const Targets& targets, double progress, vtkFFRun& run)
{
  const auto count = static_cast<vtkIdType>(targets.Count * targets.Slices);
  std::vector<vtkSmartPointer<vtkDataArray>> arrays;
  for (const Field& field : source.Fields)
  {
    arrays.push_back(makeLike(field.Array, count));
  }
  vtkNew<vtkCharArray> mask;
  mask->SetName(filter->GetValidPointsMaskArrayName().c_str());
  mask->SetNumberOfValues(count);

  const std::size_t stride = source.Components;
  flipflop::Buffer<double> results(
    stride * static_cast<std::size_t>(std::min(targets.Count, targets.AtOnce)));
  for (std::int64_t begin = 0; begin < targets.Count; begin += targets.AtOnce)
  {
    const std::int64_t end = std::min(targets.Count, begin + targets.AtOnce);
    const double share = (1.0 - progress) / static_cast<double>(targets.Count);
    run.SetPart(
      progress + share * static_cast<double>(begin), progress + share * static_cast<double>(end));
    targets.Query(begin, end, results.data());
    if (filter->GetNullPointsStrategy() == vtkFFPointInterpolator2D::CLOSEST_POINT)
    {
      findClosest(source, targets, begin, end, run.Options, results);
    }
    double* values = results.data();
    for (auto i = static_cast<vtkIdType>(begin); i < end; ++i)
    {
      const bool isNull = std::isnan(values[stride - 1]);
      if (isNull)
      {
        std::fill_n(values, stride, filter->GetNullValue());
      }
      for (std::int64_t slice = 0; slice < targets.Slices; ++slice)
      {
        const auto point = static_cast<vtkIdType>(slice * targets.Count + i);
        const double* from = values;
        mask->SetValue(point, isNull ? 0 : 1);
        for (vtkDataArray* const array : arrays)
        {
          array->SetTuple(point, from);
          from += array->GetNumberOfComponents();
        }
      }
      values += stride; // the last one was 1
    }
  }
  arrays.emplace_back(mask);
  return arrays;
}

}

//------------------------------------------------------------------------------
vtkFFPointInterpolator2D::vtkFFPointInterpolator2D() = default;

//------------------------------------------------------------------------------
vtkFFPointInterpolator2D::~vtkFFPointInterpolator2D() = default;

//------------------------------------------------------------------------------
void vtkFFPointInterpolator2D::SetSourceData(vtkDataObject* source)
{
  this->SetInputData(1, source);
}

//------------------------------------------------------------------------------
void vtkFFPointInterpolator2D::SetSourceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
vtkDataObject* vtkFFPointInterpolator2D::GetSource()
{
  return this->GetNumberOfInputConnections(1) > 0 ? this->GetExecutive()->GetInputData(1, 0)
                                                  : nullptr;
}

//------------------------------------------------------------------------------
void vtkFFPointInterpolator2D::AddExcludedArray(const char* name)
{
  this->ExcludedArrays.emplace_back(name ? name : "");
  this->OutputModified();
}

//------------------------------------------------------------------------------
void vtkFFPointInterpolator2D::ClearExcludedArrays()
{
  this->ExcludedArrays.clear();
  this->OutputModified();
}

//------------------------------------------------------------------------------
double vtkFFPointInterpolator2D::Prepare(vtkDataObject* data, vtkFFRun& run)
{
  const vtkFFStamp stamp(this, data);
  vtkFFStamp weightStamp;
  weightStamp.Add(this->WeightMode);
  weightStamp.Add(this->WeightFactor);
  vtkFFStamp valueStamp;
  valueStamp.Add(this->InterpolateZ);
  valueStamp.Add(this->ZArrayName);
  for (const std::string& name : this->ExcludedArrays)
  {
    valueStamp.Add(name);
  }
  const bool isTriangulated = this->Prepared && this->Prepared->Stamp == stamp &&
    (this->Prepared->WeightStamp == weightStamp ||
      (!this->Prepared->IsWeighted && std::isfinite(this->WeightFactor)));
  if (isTriangulated && this->Prepared->ValueStamp == valueStamp)
  {
    return 0.0;
  }
  run.NonFiniteWhat = "A coordinate or a weight";
  vtkFFInput input;
  input.Take(vtkFFInput::PiecesOf(data), this->SkipGhostPoints, run, " of the source");
  const std::vector<vtkPointSet*> pieces(input.GetPieces().begin(), input.GetPieces().end());
  vtkSmartPointer<vtkPointSet> source = vtkSmartPointer<vtkPolyData>::New();
  if (!pieces.empty())
  {
    source = vtkFFOutput::Append(pieces);
  }
  if (!isTriangulated)
  {
    this->Prepared.reset();
    this->Prepared = triangulate(this, stamp, weightStamp, source, run);
  }
  this->Prepared->Fields = fieldsOf(this, this->ExcludedArrays, source);
  takeValues(source->GetNumberOfPoints(), *this->Prepared);
  this->Prepared->ValueStamp = valueStamp;
  run.NonFiniteWhat = "A coordinate";
  run.Parts.clear(); // what errors are about from now on is the input
  run.Ids.clear();
  return isTriangulated ? 0.0 : shareOfPreparing;
}

//------------------------------------------------------------------------------
int vtkFFPointInterpolator2D::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const points = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* const source = vtkDataObject::GetData(inputVector[1]);
  vtkDataSet* const output = vtkDataSet::GetData(outputVector);
  vtkFFRun run(this, "Point interpolation", outputVector);
  if (this->IsSecondAtFault)
  {
    output->Initialize();
    return 1;
  }
  double progress = 0.0;
  if (!run.Do([&] { progress = this->Prepare(source, run); }))
  {
    this->IsSecondAtFault = true;
    this->Prepared.reset();
  }
  run.Do(
    [&]
    {
      vtkFFInput input;
      Targets targets;
      flipflop::ImageGrid grid;
      auto* const image = vtkImageData::SafeDownCast(points);
      if (takeGrid(image, grid))
      {
        targets =
          targetsOf(grid, image->GetDimensions()[2], this->InterpolationMode, *this->Prepared, run);
      }
      else
      {
        input.Take(vtkFFInput::PiecesOf(points), false, run);
        targets = targetsOf(input.GetView(), this->InterpolationMode, *this->Prepared, run);
      }
      auto arrays = interpolate(this, *this->Prepared, targets, progress, run);
      output->ShallowCopy(points);
      vtkPointData* const data = output->GetPointData();
      const std::pair<bool, vtkFieldData*> passed[] = { { this->PassPointArrays, data },
        { this->PassCellArrays, output->GetCellData() },
        { this->PassFieldArrays, output->GetFieldData() } };
      for (const auto& one : passed)
      {
        if (!one.first)
        {
          one.second->Initialize();
        }
      }
      for (std::size_t k = 0; k < this->Prepared->Fields.size(); ++k)
      {
        const int index = data->AddArray(arrays[k]);
        if (this->Prepared->Fields[k].Attribute >= 0)
        {
          data->SetActiveAttribute(index, this->Prepared->Fields[k].Attribute);
        }
      }
      if (this->NullPointsStrategy == MASK_POINTS)
      {
        data->AddArray(arrays.back());
      }
      this->Dimension = this->Prepared->Dimension;
    });
  return run.Finish();
}

//------------------------------------------------------------------------------
void vtkFFPointInterpolator2D::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto onOff = [](bool flag) { return flag ? "On" : "Off"; };
  os << indent << "InterpolationMode: " << this->InterpolationMode << "\n";
  os << indent << "WeightMode: " << this->WeightMode << "\n";
  os << indent << "WeightFactor: " << this->WeightFactor << "\n";
  os << indent << "NullPointsStrategy: " << this->NullPointsStrategy << "\n";
  os << indent << "NullValue: " << this->NullValue << "\n";
  os << indent << "ValidPointsMaskArrayName: " << this->ValidPointsMaskArrayName << "\n";
  os << indent << "InterpolateZ: " << onOff(this->InterpolateZ) << "\n";
  os << indent << "ZArrayName: " << this->ZArrayName << "\n";
  os << indent << "ExcludedArrays: " << this->ExcludedArrays.size() << "\n";
  for (const std::string& name : this->ExcludedArrays)
  {
    os << indent.GetNextIndent() << name << "\n";
  }
  os << indent << "PassPointArrays: " << onOff(this->PassPointArrays) << "\n";
  os << indent << "PassCellArrays: " << onOff(this->PassCellArrays) << "\n";
  os << indent << "PassFieldArrays: " << onOff(this->PassFieldArrays) << "\n";
}
VTK_ABI_NAMESPACE_END
