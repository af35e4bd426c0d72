// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFPointInterpolator2D.h"

#include "vtkFFInput.h"
#include "vtkFFInterpolatedData.h"
#include "vtkFFOutput.h"
#include "vtkFFPointSource.h"
#include "vtkFFRun.h"
#include "vtkFFStamp.h"
#include "vtkFFWeightSource.h"

#include <flipflop/RegularTriangulation.h>
#include <flipflop/TriangulationQueries.h>

#include "vtkAlgorithmOutput.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFPointInterpolator2D);

namespace
{

/// Of the progress of a run that prepares its source: until the triangulation is there, and until
/// all is.
constexpr double shareOfTriangulation = 0.2;
constexpr double shareOfPreparing = 0.4;

}

/// The triangulation of a source's points, ready for questions, with their values.
struct vtkFFPreparedSource
{
  vtkFFStamp Stamp;       // of the triangulation
  vtkFFStamp WeightStamp; // how weights are computed
  bool IsWeighted;        // else they are not
  int Dimension;
  vtkFFInterpolatedData Data;
  vtkFFStamp ValueStamp{}; // how values are chosen
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
  return std::unique_ptr<vtkFFPreparedSource>(
    new vtkFFPreparedSource{ stamp, weightStamp, weights.GetView().data != nullptr,
      triangulation.dimension, vtkFFInterpolatedData(std::move(queries)) });
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
  this->Prepared->Data.SetValues(source, source->GetPointData(), this->ExcludedArrays,
    this->InterpolateZ ? this->ZArrayName.c_str() : nullptr);
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
      const vtkFFInterpolatedData& prepared = this->Prepared->Data;
      const vtkFFInterpolatedData::NullsType nulls{ this->NullPointsStrategy, this->NullValue,
        this->ValidPointsMaskArrayName };
      vtkFFInput input;
      vtkFFInterpolatedData::TargetsType targets;
      flipflop::ImageGrid grid;
      auto* const image = vtkImageData::SafeDownCast(points);
      if (takeGrid(image, grid))
      {
        targets =
          prepared.GetTargets(grid, image->GetDimensions()[2], this->InterpolationMode, run);
      }
      else
      {
        input.Take(vtkFFInput::PiecesOf(points), false, run);
        targets = prepared.GetTargets(input.GetView(), this->InterpolationMode, run);
      }
      const auto arrays = prepared.Interpolate(targets, nulls, progress, run);
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
      prepared.AddArrays(arrays, nulls, data);
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
