// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFPointsToImage.h"

#include "FFConstraints.h"
#include "FFInput.h"
#include "FFInterpolatedData.h"
#include "FFPlanarInput.h"
#include "FFRun.h"
#include "vtkFFPointInterpolator2D.h"

#include <flipflop/Buffer.h>
#include <flipflop/CellComplex.h>
#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/PlaneFit.h>
#include <flipflop/PowerDiagram.h>
#include <flipflop/TriangulationQueries.h>

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFPointsToImage);

namespace
{

using Box = std::array<double, 4>; // of least x, greatest x, least y, greatest y

template <class T>
std::string pairOf(const T* numbers)
{
  std::ostringstream text;
  text << "(" << numbers[0] << ", " << numbers[1] << ")";
  return text.str();
}

/// Settings that no data make right.
void checkSettings(vtkFFPointsToImage* filter, bool hasSource)
{
  const int* const size = filter->GetDimensions();
  const double* const spacing = filter->GetSpacing();
  const bool isBySpacing = filter->GetSizeMode() == vtkFFPointsToImage::SIZE_BY_SPACING;
  if (!isBySpacing && (size[0] < 1 || size[1] < 1))
  {
    throw FFBadSetting("Dimensions are " + pairOf(size) + "; each must be 1 or more.");
  }
  const auto isLength = [](double length) { return std::isfinite(length) && length > 0.0; };
  if (isBySpacing && !(isLength(spacing[0]) && isLength(spacing[1])))
  {
    throw FFBadSetting("Spacing is " + pairOf(spacing) + "; it must be above 0 and finite.");
  }
  if (!filter->GetUseInputBounds())
  {
    FFPlanarInput::CheckBox(filter->GetSamplingBounds(), "The image's box");
  }
  if (hasSource &&
    (filter->GetInterpolationMode() == vtkFFPointsToImage::NATURAL_NEIGHBOR ||
      filter->GetNullPointsStrategy() == vtkFFPointsToImage::CLOSEST_POINT))
  {
    throw FFBadSetting("Natural neighbours and closest points do not know breaklines. Choose "
                       "another, or take the source away.");
  }
}

/// The pixels that cover a box, as the filter says.
flipflop::ImageGrid gridOf(vtkFFPointsToImage* filter, const double* box)
{
  flipflop::ImageGrid grid;
  for (int k = 0; k < 2; ++k)
  {
    const double length = box[2 * k + 1] - box[2 * k];
    double& step = grid.spacing[k];
    if (filter->GetSizeMode() == vtkFFPointsToImage::SIZE_BY_DIMENSIONS)
    {
      grid.size[k] = filter->GetDimensions()[k];
      step = length / static_cast<double>(grid.size[k]);
    }
    else
    {
      step = filter->GetSpacing()[k];
      const double count = std::ceil(length / step - 1e-6);
      if (!(count <= VTK_INT_MAX))
      {
        std::ostringstream message;
        message << "A Spacing of " << step << " makes too many pixels of a length of " << length
                << ".";
        throw FFBadSetting(message.str());
      }
      grid.size[k] = std::max<std::int64_t>(1, static_cast<std::int64_t>(count));
    }
    if (!std::isfinite(step) || !(step > 0.0))
    {
      std::ostringstream message;
      message << "A length of " << length << " cannot be divided into " << grid.size[k]
              << " pixels.";
      throw FFBadSetting(message.str());
    }
  }
  // Of whole pixels, the first row of an image is the lowest one; they begin at the top.
  grid.origin[0] = box[0] + grid.spacing[0] / 2.0;
  grid.origin[1] =
    box[3] - grid.spacing[1] / 2.0 - static_cast<double>(grid.size[1] - 1) * grid.spacing[1];
  return grid;
}

std::array<int, 6> extentOf(const flipflop::ImageGrid& grid)
{
  return { { 0, static_cast<int>(grid.size[0]) - 1, 0, static_cast<int>(grid.size[1]) - 1, 0,
    grid.size[0] > 0 ? 0 : -1 } };
}

/// Where the image of a plane is in space.
void setGeometry(const flipflop::ImageGrid& grid, const std::optional<flipflop::FittedPlane>& plane,
  vtkImageData* image)
{
  image->SetExtent(extentOf(grid).data());
  image->SetSpacing(grid.spacing[0], grid.spacing[1], 1.0);
  image->SetOrigin(grid.origin[0], grid.origin[1], 0.0);
  const std::array<double, 3> x = plane ? plane->first : std::array<double, 3>{ { 1, 0, 0 } };
  const std::array<double, 3> y = plane ? plane->second : std::array<double, 3>{ { 0, 1, 0 } };
  double z[3];
  vtkMath::Cross(x.data(), y.data(), z);
  image->SetDirectionMatrix(x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]);
  if (plane)
  {
    image->SetOrigin(flipflop::positionOf(*plane, grid.origin[0], grid.origin[1]).data());
  }
}

/// The triangulation of points, ready for queries; with breaklines, if there are some. It becomes
/// part of the report.
flipflop::TriangulationQueries queriesOf(const FFPlanarInput& input, vtkPointSet* whole,
  vtkPolyData* source, std::optional<Box>& bounds, vtkDataObject* output, FFRun& run)
{
  run.SetPart(0.0, FFInterpolatedData::ShareOfTriangulation);
  flipflop::ConstrainedTriangulation triangulation;
  flipflop::Buffer<std::uint8_t> inside;
  if (source)
  {
    run.UseCPU("constraints are the CPU's");
    input.CheckUnweighted();
    FFConstraints::SettingsType settings;
    settings.Dimensions = input.IsXYPlane() ? 2 : 3;
    const std::optional<FFConstraints> constraints(std::in_place, settings, source, whole, run.Ids);
    const auto work = [&]
    {
      const flipflop::ConstraintView view = constraints->GetView();
      triangulation = flipflop::constrainedTriangulation(input.GetPlane(), view, run.Options);
      if (view.sides > 0)
      {
        inside.allocate(static_cast<std::size_t>(triangulation.cellCount()));
        flipflop::cellsInside(triangulation, inside.data(), run.Options);
      }
    };
    FFConstraints::Do(constraints, run, work);
  }
  else
  {
    static_cast<flipflop::Triangulation&>(triangulation) = flipflop::regularTriangulation(
      input.GetPlane(), input.GetWeights(), run.Options, run.Engine, run.EngineReport);
  }
  input.LookForVerticalPlane(triangulation);
  if (triangulation.dimension >= 0)
  {
    bounds = flipflop::powerDiagramBox(input.GetPlane(), triangulation);
  }
  input.Report(
    triangulation, static_cast<std::int64_t>(triangulation.hiddenIds.size()), std::nullopt, output);
  run.SetPart(FFInterpolatedData::ShareOfTriangulation, FFInterpolatedData::ShareOfPreparing);
  return source
    ? flipflop::TriangulationQueries(input.GetPlane(), triangulation, inside.data(), run.Options)
    : flipflop::TriangulationQueries(
        input.GetPlane(), input.GetWeights(), triangulation, run.Options);
}
}

//------------------------------------------------------------------------------
vtkFFPointsToImage::vtkFFPointsToImage()
  : NullValue(vtkMath::Nan())
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkImageData* vtkFFPointsToImage::GetOutput(int port)
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(port));
}

//------------------------------------------------------------------------------
int vtkFFPointsToImage::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* const info = outputVector->GetInformationObject(0);
  flipflop::ImageGrid grid;              // of no pixel
  info->Remove(vtkDataObject::ORIGIN()); // of other settings, or of an image that is the input
  info->Remove(vtkDataObject::SPACING());
  try
  {
    checkSettings(this, false);
    if (!this->UseInputBounds)
    {
      grid = gridOf(this, this->SamplingBounds);
      if (this->ProjectionPlaneMode != BEST_FITTING_PLANE)
      {
        const double origin[] = { grid.origin[0], grid.origin[1], 0.0 };
        const double spacing[] = { grid.spacing[0], grid.spacing[1], 1.0 };
        info->Set(vtkDataObject::ORIGIN(), origin, 3);
        info->Set(vtkDataObject::SPACING(), spacing, 3);
      }
    }
    else if (this->SizeMode == SIZE_BY_DIMENSIONS)
    {
      std::copy_n(this->Dimensions, 2, grid.size);
    }
  }
  catch (const FFBadSetting&)
  {
    // RequestData() says so.
  }
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extentOf(grid).data(), 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFPointsToImage::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    FFInput::RequestAll(inputVector[port]->GetInformationObject(0));
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkFFPointsToImage::Execute(vtkDataObject* data, vtkInformationVector** inputVector,
  const std::vector<vtkDataObject*>& results, FFRun& run)
{
  static_assert(int(NATURAL_NEIGHBOR) == int(vtkFFPointInterpolator2D::NATURAL_NEIGHBOR) &&
      int(CLOUGH_TOCHER) == int(vtkFFPointInterpolator2D::CLOUGH_TOCHER) &&
      int(MASK_POINTS) == int(vtkFFPointInterpolator2D::MASK_POINTS) &&
      int(CLOSEST_POINT) == int(vtkFFPointInterpolator2D::CLOSEST_POINT),
    "these are the values of FFInterpolatedData");
  auto* const output = vtkImageData::SafeDownCast(results[0]);
  // Values by natural neighbours have other last bits over polygons.
  run.Options.facets = flipflop::FacetMode::Triangles;
  vtkPolyData* const source = FFConstraints::SourceOf(inputVector, run);
  checkSettings(this, source != nullptr);
  FFPlanarInput input(this, run);
  const vtkSmartPointer<vtkPointSet> whole = input.Take(data);
  vtkPointSet* const points = input.GetPoints();
  std::optional<Box> bounds; // none: there is no point
  const FFInterpolatedData values(FFInterpolatedData::SettingsType(this),
    queriesOf(input, whole, source, bounds, output, run), points,
    this->PassPointData ? points->GetPointData() : nullptr);
  const double* const given = bounds ? bounds->data() : nullptr;
  if (const double* const box = this->UseInputBounds ? given : this->SamplingBounds)
  {
    const flipflop::ImageGrid grid = gridOf(this, box);
    run.SetBegin(FFInterpolatedData::ShareOfPreparing);
    values.Interpolate(grid, 1, run, output->GetPointData());
    setGeometry(grid, input.GetFittedPlane(), output);
  }
}

//------------------------------------------------------------------------------
int vtkFFPointsToImage::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* const output = vtkImageData::GetData(outputVector);
  if (!output) // a composite
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  // The executive leaves the last run's scalars and geometry.
  output->GetPointData()->Initialize();
  setGeometry(flipflop::ImageGrid(), std::nullopt, output);
  this->Superclass::RequestData(request, inputVector, outputVector);
  // Else the executive would take an image that is smaller than announced for none.
  int extent[6];
  output->GetExtent(extent);
  vtkInformation* const info = outputVector->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
  return 1;
}

//------------------------------------------------------------------------------
void vtkFFPointsToImage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SizeMode: " << this->SizeMode << "\n";
  os << indent << "Dimensions: " << pairOf(this->Dimensions) << "\n";
  os << indent << "Spacing: " << pairOf(this->Spacing) << "\n";
  os << indent << "UseInputBounds: " << (this->UseInputBounds ? "On" : "Off") << "\n";
  FFInterpolatedData::SettingsType(this).PrintSelf(os, indent);
  const double* const box = this->SamplingBounds;
  os << indent << "SamplingBounds: (" << box[0] << ", " << box[1] << ", " << box[2] << ", "
     << box[3] << ")\n";
}
VTK_ABI_NAMESPACE_END
