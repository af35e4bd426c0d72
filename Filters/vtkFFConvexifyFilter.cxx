// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFConvexifyFilter.h"

#include "FFHullResult.h"
#include "FFInput.h"
#include "FFOutput.h"
#include "FFRun.h"
#include "FFSurfaceCells.h"

#include "vtkDataObject.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <sstream>
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
    throw FFBadSetting(message.str());
  }
}

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
void vtkFFConvexifyFilter::Execute(vtkDataObject* data, vtkInformationVector**,
  const std::vector<vtkDataObject*>& results, FFRun& run)
{
  run.NonFiniteAdvice = "They are corners of the surface, which has to be mended.";
  run.Options.facets = flipflop::FacetMode::Polygons; // see WriteHull()
  run.UseCPU("this filter runs on the CPU");
  const double* const kernel = this->UseKernelPoint ? this->KernelPoint : nullptr;
  checkKernel(kernel);
  vtkPolyData* const surface = FFSurfaceCells::SurfaceOf(data, run.OfWhat());
  FFInput input;
  input.Take(FFBlocks::PiecesOf(surface), false, run);
  const FFSurfaceCells cells(surface, input.GetView(), run.Options);
  FFHullResult hull(vtkPolyData::SafeDownCast(results[0]));
  hull.Engine = run.EngineReport;
  if (cells.GetView().count > 0)
  {
    hull.Hull = cells.FlipFlop(input.GetView(), kernel, run.Options);
  }
  FFOutput::Adopt(hull.Hull, input.GetPoints(),
    this->PassPointData ? input.GetPointData() : std::vector<FFOutput::Source>(), hull.Data);
  this->WriteHull(hull, hull.Data, run);
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
