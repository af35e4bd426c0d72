// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFConvexifyFilter.h"

#include "vtkFFHullResult.h"
#include "vtkFFInput.h"
#include "vtkFFOutput.h"
#include "vtkFFRun.h"
#include "vtkFFSurfaceCells.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFConvexifyFilter);

namespace
{

void checkSettings(int engine, const double* kernel)
{
  if (engine == vtkFFAlgorithm::ENGINE_CUDA)
  {
    throw vtkFFBadSetting("The CUDA engine was asked for, but this filter runs on the CPU. Set "
                          "Engine to Automatic or CPU.");
  }
  if (kernel && !std::all_of(kernel, kernel + 3, [](double x) { return vtkMath::IsFinite(x); }))
  {
    std::ostringstream message;
    message << "The kernel point (" << kernel[0] << ", " << kernel[1] << ", " << kernel[2]
            << ") is not finite.";
    throw vtkFFBadSetting(message.str());
  }
}

/// The input as a surface that has cells, and no others than a surface's.
vtkPolyData* surfaceOf(vtkDataObject* input, const std::string& ofWhat)
{
  auto* const surface = vtkPolyData::SafeDownCast(input);
  if (!surface) // in a composite, VTK does not check types
  {
    throw std::runtime_error(
      "The data" + ofWhat + " is a " + input->GetClassName() + ". It must be a vtkPolyData.");
  }
  if (surface->GetNumberOfCells() == 0 && surface->GetNumberOfPoints() > 0)
  {
    throw std::runtime_error("The surface" + ofWhat + " has no cells, but " +
      std::to_string(surface->GetNumberOfPoints()) +
      " point(s). It takes triangles, polygons and triangle strips; Convex Hull (vtkFFHullFilter) "
      "gives the hull of points.");
  }
  const std::string fault = vtkFFSurfaceCells::DescribeFault(surface, ofWhat);
  if (!fault.empty())
  {
    throw std::runtime_error(fault);
  }
  return surface;
}

}

//------------------------------------------------------------------------------
vtkFFConvexifyFilter::vtkFFConvexifyFilter() = default;

//------------------------------------------------------------------------------
vtkFFConvexifyFilter::~vtkFFConvexifyFilter() = default;

//------------------------------------------------------------------------------
int vtkFFConvexifyFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
void vtkFFConvexifyFilter::SetKernelPoint(double x, double y, double z)
{
  this->StoreKernelPoint(x, y, z);
  this->SetUseKernelPoint(true);
}

//------------------------------------------------------------------------------
void vtkFFConvexifyFilter::SetKernelPoint(const double point[3])
{
  this->SetKernelPoint(point[0], point[1], point[2]);
}

//------------------------------------------------------------------------------
void vtkFFConvexifyFilter::StoreKernelPoint(double x, double y, double z)
{
  const double point[3] = { x, y, z };
  if (!std::equal(point, point + 3, this->KernelPoint))
  {
    std::copy(point, point + 3, this->KernelPoint);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkFFConvexifyFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkFFRun run(this, "Convexify", outputVector);
  run.NonFiniteAdvice = "They are corners of the surface, which has to be mended.";
  run.Options.facets = flipflop::FacetMode::Polygons; // see WriteHull()
  run.Report.used = flipflop::EngineChoice::CPU;
  std::snprintf(run.Report.reason, sizeof(run.Report.reason), "%s",
    this->Engine == ENGINE_CPU ? "the CPU engine was asked for" : "this filter runs on the CPU");
  run.Do(
    [&]
    {
      const double* const kernel = this->UseKernelPoint ? this->KernelPoint : nullptr;
      checkSettings(this->Engine, kernel);
      vtkPolyData* const surface = surfaceOf(vtkDataObject::GetData(inputVector[0]), run.OfWhat());
      vtkFFInput input;
      input.Take(vtkFFInput::PiecesOf(surface), false, run);
      const vtkFFSurfaceCells cells(surface, input.GetView(), run.Options);
      vtkFFHullResult result;
      result.Engine = run.Report;
      if (cells.GetView().count > 0)
      {
        result.Hull = cells.FlipFlop(input.GetView(), kernel, run.Options);
      }
      vtkFFOutput::Adopt(result.Hull, input.GetPoints(),
        this->PassPointData ? input.GetPointData() : std::vector<vtkFFOutput::Source>(),
        result.Data);
      this->WriteHull(result, run, vtkPolyData::GetData(outputVector));
    });
  return run.Finish();
}

//------------------------------------------------------------------------------
void vtkFFConvexifyFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "KernelPoint: (" << this->KernelPoint[0] << ", " << this->KernelPoint[1] << ", "
     << this->KernelPoint[2] << ")\n";
  os << indent << "UseKernelPoint: " << (this->UseKernelPoint ? "On" : "Off") << "\n";
}
VTK_ABI_NAMESPACE_END
