// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFPointInterpolator2D.h"

#include "FFBlocks.h"
#include "FFExactValues.h"
#include "FFInput.h"
#include "FFInterpolatedData.h"
#include "FFOutput.h"
#include "FFRun.h"

#include <flipflop/RegularTriangulation.h>
#include <flipflop/TriangulationQueries.h>

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFPointInterpolator2D);

namespace
{

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
double vtkFFPointInterpolator2D::Prepare(vtkDataObject* data, FFRun& run)
{
  if (this->IsPrepared(data) && this->Prepared)
  {
    return 0.0;
  }
  this->Prepared.reset();
  run.NonFiniteWhat = "A coordinate or a weight";
  FFInput input;
  const std::vector<FFInput::PieceType> blocks = FFBlocks::PiecesOf(data);
  for (const FFInput::PieceType& block : blocks) // as FFPlanarInput::Take()
  {
    if (auto* const raw = vtkDataSet::SafeDownCast(block.Data))
    {
      FFWeightSource::FindArray(this, raw, FFInput::NameOf(block, run, " of the source"), "source");
    }
  }
  input.Take(blocks, this->SkipGhostPoints, run, " of the source");
  const std::vector<vtkPointSet*> pieces(input.GetPieces().begin(), input.GetPieces().end());
  vtkSmartPointer<vtkPointSet> source = vtkSmartPointer<vtkPolyData>::New();
  if (!pieces.empty())
  {
    source = FFOutput::Append(pieces);
  }
  vtkPoints* const positions = source->GetPoints();
  const FFPointSource points(positions ? positions->GetData() : nullptr);
  const FFWeightSource weights(FFWeightSource::FindArray(this, source, run.OfWhat(), "source"),
    { this->WeightMode == RADII, this->WeightFactor });
  run.SetPart(0.0, FFInterpolatedData::ShareOfTriangulation);
  const flipflop::Triangulation triangulation =
    flipflop::regularTriangulation(points.GetView(), weights.GetView(), run.Options);
  run.SetPart(FFInterpolatedData::ShareOfTriangulation, FFInterpolatedData::ShareOfPreparing);
  flipflop::TriangulationQueries queries(
    points.GetView(), weights.GetView(), triangulation, run.Options);
  this->Prepared =
    std::make_unique<const FFInterpolatedData>(FFInterpolatedData::SettingsType(this),
      std::move(queries), source, source->GetPointData(), this->ExcludedArrays);
  this->PreparedDimension = triangulation.dimension;
  this->SetPrepared(data);
  run.NonFiniteWhat = "A coordinate";
  return FFInterpolatedData::ShareOfPreparing;
}

//------------------------------------------------------------------------------
void vtkFFPointInterpolator2D::Execute(vtkDataObject* data, vtkDataSet* result, FFRun& run)
{
  vtkPointData* const output = result->GetPointData();
  const std::pair<bool, vtkFieldData*> passed[] = { { this->PassPointArrays, output },
    { this->PassCellArrays, result->GetCellData() },
    { this->PassFieldArrays, result->GetFieldData() } };
  for (const auto& one : passed)
  {
    if (!one.first && one.second)
    {
      one.second->Initialize();
    }
  }
  flipflop::ImageGrid grid;
  auto* const image = vtkImageData::SafeDownCast(data);
  if (takeGrid(image, grid))
  {
    this->Prepared->Interpolate(grid, image->GetDimensions()[2], run, output);
  }
  else
  {
    FFInput input;
    input.Take(FFBlocks::PiecesOf(data), false, run);
    this->Prepared->Interpolate(input.GetView(), run, output);
  }
  run.Report.Dimension = this->PreparedDimension;
}

//------------------------------------------------------------------------------
void vtkFFPointInterpolator2D::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto onOff = [](bool flag) { return flag ? "On" : "Off"; };
  FFInterpolatedData::SettingsType(this).PrintSelf(os, indent);
  os << indent << "WeightMode: " << this->WeightMode << "\n";
  os << indent << "WeightFactor: " << this->WeightFactor << "\n";
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
