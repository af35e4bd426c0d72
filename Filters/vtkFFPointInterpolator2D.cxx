// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFPointInterpolator2D.h"

#include "vtkFFPieces.h"
#include "vtkFFPointSource.h"
#include "vtkFFQueryInternals.h"
#include "vtkFFWeightSource.h"

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
#include <memory>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFPointInterpolator2D);

namespace
{

/// Of the progress, to prepare: the triangulation.
constexpr double shareOfTriangulation = 0.5;

/// So many points are asked about at once: their values are twice in memory.
constexpr std::int64_t pointsAtOnce = 1 << 18;

/// Attributes that stay what they are between the points.
constexpr std::array<int, 4> passedAttributes{ { vtkDataSetAttributes::SCALARS,
  vtkDataSetAttributes::VECTORS, vtkDataSetAttributes::TENSORS, vtkDataSetAttributes::TCOORDS } };

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
std::array<double, 2> placeOf(const flipflop::PointView& points, std::int64_t i)
{
  if (points.type == flipflop::ScalarType::Float32)
  {
    const float* xy = static_cast<const float*>(points.data) + i * points.stride;
    return { { xy[0], xy[1] } };
  }
  const double* xy = static_cast<const double*>(points.data) + i * points.stride;
  return { { xy[0], xy[1] } };
}

/// The engine is asked about some points at a time, but the error is about all.
void demandFinite(const flipflop::PointView& points)
{
  std::int64_t first = -1;
  std::int64_t count = 0;
  for (std::int64_t i = 0; i < points.count; ++i)
  {
    const auto place = placeOf(points, i);
    if (!std::isfinite(place[0]) || !std::isfinite(place[1]))
    {
      first = count++ == 0 ? i : first;
    }
  }
  if (count > 0)
  {
    throw flipflop::Error(flipflop::ErrorCode::NonFinite, first, count);
  }
}

}

//------------------------------------------------------------------------------
class vtkFFPointInterpolator2D::vtkInternals : public vtkFFQueryAlgorithm::vtkInternals
{
public:
  using vtkFFQueryAlgorithm::vtkInternals::vtkInternals;

  void Forget() override;
  std::string GetSecondName() override { return "source"; }
  int Prepare(const std::vector<vtkPointSet*>& pieces, const flipflop::Options& options) override;
  void Answer(const flipflop::PointView& points, const flipflop::Options& options,
    vtkDataSet* output) override;
  std::string DescribeError(const flipflop::Error& error) override;

protected:
  const char* GetProgressTitle() override { return "Point interpolation"; }

private:
  vtkFFPointInterpolator2D* GetInterpolator() const
  {
    return static_cast<vtkFFPointInterpolator2D*>(this->GetFilter());
  }

  /// An array that is interpolated: of which it is made anew, with its name; and where its values
  /// are in a point's.
  struct Field
  {
    vtkSmartPointer<vtkDataArray> Source;
    std::string Name;
    int Attribute; // -1: none
    std::size_t Begin;
    vtkSmartPointer<vtkDataArray> Output;
  };

  void TakeFields(vtkPointSet* source);
  void AddField(vtkDataArray* array, const std::string& name, int attribute);
  void MakeOutputs(vtkIdType count);
  void AskClosest(const flipflop::PointView& points, const flipflop::Options& options);

  std::unique_ptr<const flipflop::TriangulationQueries> Queries;
  std::vector<Field> Fields;
  flipflop::Buffer<double> Values;  // of each point of the source: its fields', and 1
  std::size_t Components = 0;       // of these, for a point
  flipflop::Buffer<double> Results; // the same of the points that are asked about; NaN for 1: null
  bool IsPreparing = false;         // the source's points, for errors
};

//------------------------------------------------------------------------------
vtkFFPointInterpolator2D::vtkFFPointInterpolator2D()
  : InterpolationMode(LINEAR)
  , WeightMode(WEIGHTS)
  , WeightFactor(1.0)
  , NullPointsStrategy(MASK_POINTS)
  , NullValue(0.0)
  , ValidPointsMaskArrayName("vtkValidPointMask")
  , InterpolateZ(true)
  , ZArrayName("Elevation")
  , PassPointArrays(true)
  , PassCellArrays(true)
  , PassFieldArrays(true)
{
  this->SetInternals(std::make_unique<vtkInternals>(this));
}

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
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkFFPointInterpolator2D::ClearExcludedArrays()
{
  this->ExcludedArrays.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkFFPointInterpolator2D::GetNumberOfExcludedArrays()
{
  return static_cast<int>(this->ExcludedArrays.size());
}

//------------------------------------------------------------------------------
const char* vtkFFPointInterpolator2D::GetExcludedArray(int index)
{
  return index >= 0 && index < this->GetNumberOfExcludedArrays()
    ? this->ExcludedArrays[static_cast<std::size_t>(index)].c_str()
    : nullptr;
}

//------------------------------------------------------------------------------
void vtkFFPointInterpolator2D::vtkInternals::Forget()
{
  this->Queries.reset();
  this->Fields.clear();
  this->Values = flipflop::Buffer<double>();
  this->Results = flipflop::Buffer<double>();
  this->Components = 0;
  this->IsPreparing = false;
}

//------------------------------------------------------------------------------
void vtkFFPointInterpolator2D::vtkInternals::AddField(
  vtkDataArray* array, const std::string& name, int attribute)
{
  this->Fields.push_back({ array, name, attribute, this->Components, nullptr });
  this->Components += static_cast<std::size_t>(array->GetNumberOfComponents());
}

//------------------------------------------------------------------------------
void vtkFFPointInterpolator2D::vtkInternals::TakeFields(vtkPointSet* source)
{
  const vtkFFPointInterpolator2D* filter = this->GetInterpolator();
  const auto& excluded = filter->ExcludedArrays;
  const vtkIdType count = source->GetNumberOfPoints();
  vtkPointData* data = source->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    const int attribute = data->IsArrayAnAttribute(i);
    const std::string name = array && array->GetName() ? array->GetName() : "";
    const bool isValue = array && array->GetNumberOfTuples() >= count &&
      name != vtkDataSetAttributes::GhostArrayName() &&
      attribute != vtkDataSetAttributes::GLOBALIDS &&
      attribute != vtkDataSetAttributes::PEDIGREEIDS &&
      std::find(excluded.begin(), excluded.end(), name) == excluded.end();
    if (isValue)
    {
      this->AddField(array, name, attribute);
    }
  }
  const bool withZ =
    filter->InterpolateZ && source->GetPoints() && !data->HasArray(filter->ZArrayName.c_str());
  if (withZ)
  {
    vtkDataArray* places = source->GetPoints()->GetData();
    vtkSmartPointer<vtkDataArray> heights;
    heights.TakeReference(
      vtkDataArray::CreateDataArray(places->GetDataType() == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE));
    heights->SetNumberOfTuples(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      heights->SetComponent(i, 0, places->GetComponent(i, 2));
    }
    this->AddField(heights, filter->ZArrayName, -1);
  }

  const std::size_t stride = ++this->Components;
  this->Values.allocate(stride * static_cast<std::size_t>(count));
  for (const Field& field : this->Fields)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      const std::size_t at = static_cast<std::size_t>(i) * stride + field.Begin;
      field.Source->GetTuple(i, &this->Values[at]);
    }
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    this->Values[static_cast<std::size_t>(i + 1) * stride - 1] = 1.0;
  }
}

//------------------------------------------------------------------------------
int vtkFFPointInterpolator2D::vtkInternals::Prepare(
  const std::vector<vtkPointSet*>& pieces, const flipflop::Options& options)
{
  this->IsPreparing = true;
  vtkSmartPointer<vtkPointSet> source;
  if (pieces.empty())
  {
    source = vtkSmartPointer<vtkPolyData>::New();
  }
  else
  {
    source = vtkFFPieces::Append(pieces);
  }
  vtkPoints* places = source->GetPoints();
  const vtkFFPointSource points(places ? places->GetData() : nullptr);
  const vtkFFPointInterpolator2D* filter = this->GetInterpolator();
  const vtkFFWeightSource weights(
    vtkFFWeightSource::FindArray(this->GetFilter(), source, this->OfBlock(), "source"),
    vtkFFWeightSource::Rule{ filter->WeightMode == RADII, filter->WeightFactor });
  this->SetProgressPart(0.0, shareOfTriangulation);
  const flipflop::Triangulation triangulation =
    flipflop::regularTriangulation(points.GetView(), weights.GetView(), options);
  this->SetProgressPart(shareOfTriangulation, 1.0);
  this->Queries = std::make_unique<flipflop::TriangulationQueries>(
    points.GetView(), weights.GetView(), triangulation, options);
  this->TakeFields(source);
  this->IsPreparing = false;
  return triangulation.dimension;
}

//------------------------------------------------------------------------------
void vtkFFPointInterpolator2D::vtkInternals::MakeOutputs(vtkIdType count)
{
  for (Field& field : this->Fields)
  {
    field.Output.TakeReference(vtkDataArray::CreateDataArray(
      field.Source->GetDataType() == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE));
    field.Output->SetName(field.Name.empty() ? nullptr : field.Name.c_str());
    field.Output->SetNumberOfComponents(field.Source->GetNumberOfComponents());
    field.Output->CopyComponentNames(field.Source);
    field.Output->SetNumberOfTuples(count);
  }
}

//------------------------------------------------------------------------------
void vtkFFPointInterpolator2D::vtkInternals::AskClosest(
  const flipflop::PointView& points, const flipflop::Options& options)
{
  const std::size_t stride = this->Components;
  std::vector<std::int64_t> nulls;
  std::vector<double> places;
  for (std::int64_t i = 0; i < points.count; ++i)
  {
    if (std::isnan(this->Results[static_cast<std::size_t>(i + 1) * stride - 1]))
    {
      const auto place = placeOf(points, i);
      nulls.push_back(i);
      places.insert(places.end(), place.begin(), place.end());
    }
  }
  if (nulls.empty())
  {
    return;
  }
  std::vector<std::int64_t> ids(nulls.size());
  const auto count = static_cast<std::int64_t>(nulls.size());
  this->Queries->nearest(flipflop::PointView(places.data(), count, 2), ids.data(), options);
  for (std::size_t k = 0; k < nulls.size(); ++k)
  {
    if (ids[k] >= 0)
    {
      std::copy_n(this->Values.data() + static_cast<std::size_t>(ids[k]) * stride, stride,
        this->Results.data() + static_cast<std::size_t>(nulls[k]) * stride);
    }
  }
}

//------------------------------------------------------------------------------
void vtkFFPointInterpolator2D::vtkInternals::Answer(
  const flipflop::PointView& points, const flipflop::Options& options, vtkDataSet* output)
{
  const vtkFFPointInterpolator2D* filter = this->GetInterpolator();
  if (options.nonFinite == flipflop::NonFinitePolicy::Error)
  {
    demandFinite(points);
  }
  this->MakeOutputs(static_cast<vtkIdType>(points.count));
  vtkNew<vtkCharArray> mask;
  mask->SetName(filter->ValidPointsMaskArrayName.c_str());
  mask->SetNumberOfValues(static_cast<vtkIdType>(points.count));

  const std::size_t stride = this->Components;
  const auto components = static_cast<std::int64_t>(stride);
  this->Results.allocate(stride * static_cast<std::size_t>(std::min(points.count, pointsAtOnce)));
  for (std::int64_t begin = 0; begin < points.count; begin += pointsAtOnce)
  {
    const std::int64_t end = std::min(points.count, begin + pointsAtOnce);
    const double total = static_cast<double>(points.count);
    this->SetProgressPart(static_cast<double>(begin) / total, static_cast<double>(end) / total);
    const flipflop::PointView part = partOf(points, begin, end);
    if (filter->InterpolationMode == NATURAL_NEIGHBOR)
    {
      this->Queries->interpolateNatural(
        this->Values.data(), components, part, this->Results.data(), options);
    }
    else
    {
      this->Queries->interpolateLinear(
        this->Values.data(), components, part, this->Results.data(), options);
    }
    if (filter->NullPointsStrategy == CLOSEST_POINT)
    {
      this->AskClosest(part, options);
    }
    for (std::int64_t i = begin; i < end; ++i)
    {
      double* values = this->Results.data() + static_cast<std::size_t>(i - begin) * stride;
      const bool isNull = std::isnan(values[stride - 1]);
      if (isNull)
      {
        std::fill_n(values, stride, filter->NullValue);
      }
      mask->SetValue(static_cast<vtkIdType>(i), isNull ? 0 : 1);
      for (const Field& field : this->Fields)
      {
        field.Output->SetTuple(static_cast<vtkIdType>(i), values + field.Begin);
      }
    }
  }

  if (!filter->PassPointArrays)
  {
    output->GetPointData()->Initialize();
  }
  if (!filter->PassCellArrays)
  {
    output->GetCellData()->Initialize();
  }
  if (!filter->PassFieldArrays)
  {
    output->GetFieldData()->Initialize();
  }
  for (Field& field : this->Fields)
  {
    const int index = output->GetPointData()->AddArray(field.Output);
    if (std::find(passedAttributes.begin(), passedAttributes.end(), field.Attribute) !=
      passedAttributes.end())
    {
      output->GetPointData()->SetActiveAttribute(index, field.Attribute);
    }
    field.Output = nullptr;
  }
  if (filter->NullPointsStrategy == MASK_POINTS)
  {
    output->GetPointData()->AddArray(mask);
  }
}

//------------------------------------------------------------------------------
std::string vtkFFPointInterpolator2D::vtkInternals::DescribeError(const flipflop::Error& error)
{
  if (error.code() == flipflop::ErrorCode::NonFinite && this->IsPreparing)
  {
    return this->DescribeNonFinite("A coordinate or a weight", error) +
      " Remove them, or set Non Finite Points to Ignore.";
  }
  return this->vtkFFQueryAlgorithm::vtkInternals::DescribeError(error);
}

//------------------------------------------------------------------------------
const char* vtkFFPointInterpolator2D::GetInterpolationModeAsString()
{
  return this->InterpolationMode == NATURAL_NEIGHBOR ? "NaturalNeighbor" : "Linear";
}

//------------------------------------------------------------------------------
const char* vtkFFPointInterpolator2D::GetWeightModeAsString()
{
  return this->WeightMode == RADII ? "Radii" : "Weights";
}

//------------------------------------------------------------------------------
const char* vtkFFPointInterpolator2D::GetNullPointsStrategyAsString()
{
  return this->NullPointsStrategy == CLOSEST_POINT ? "ClosestPoint"
    : this->NullPointsStrategy == NULL_VALUE       ? "NullValue"
                                                   : "MaskPoints";
}

//------------------------------------------------------------------------------
void vtkFFPointInterpolator2D::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto onOff = [](bool flag) { return flag ? "On" : "Off"; };
  os << indent << "InterpolationMode: " << this->GetInterpolationModeAsString() << "\n";
  os << indent << "WeightMode: " << this->GetWeightModeAsString() << "\n";
  os << indent << "WeightFactor: " << this->WeightFactor << "\n";
  os << indent << "NullPointsStrategy: " << this->GetNullPointsStrategyAsString() << "\n";
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
