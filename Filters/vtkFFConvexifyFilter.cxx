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
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFConvexifyFilter);

namespace
{

void checkKernel(const double* kernel)
{
  if (kernel && !std::all_of(kernel, kernel + 3, [](double x) { return vtkMath::IsFinite(x); }))
  {
    std::ostringstream message;
    message << "The kernel point (" << kernel[0] << ", " << kernel[1] << ", " << kernel[2]
            << ") is not finite.";
    throw vtkFFBadSetting(message.str());
  }
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
void vtkFFConvexifyFilter::SetEngine(int engine)
{
  this->Superclass::SetEngine(std::min<int>(engine, ENGINE_CPU));
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
      checkKernel(kernel);
      vtkPolyData* const surface =
        vtkFFSurfaceCells::SurfaceOf(vtkDataObject::GetData(inputVector[0]), run.OfWhat());
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
      vtkPolyData* const output = vtkPolyData::GetData(outputVector);
      this->WriteHull(result, run, output);
      this->ReportHull(result, run, output);
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
