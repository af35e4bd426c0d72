// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFConvexifyFilter.h"

#include "vtkFFFailure.h"
#include "vtkFFHullInternals.h"
#include "vtkFFOutput.h"
#include "vtkFFPointSource.h"
#include "vtkFFSurfaceCells.h"

#include <flipflop/Engines.h>
#include <flipflop/Error.h>
#include <flipflop/Hull.h>

#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFConvexifyFilter);

//------------------------------------------------------------------------------
class vtkFFConvexifyFilter::vtkInternals : public vtkFFHullAlgorithm::vtkInternals
{
public:
  using vtkFFHullAlgorithm::vtkInternals::vtkInternals;

  std::vector<std::string> GetLeafTypes() override { return { "vtkPolyData" }; }
  void Execute(const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs,
    vtkFFFailure& failure) override;
  std::string DescribeError(const flipflop::Error& error) override;

protected:
  const char* GetProgressTitle() override { return "Convexify"; }

private:
  void Convexify(vtkPolyData* input, vtkPolyData* output, vtkFFFailure& failure);
};

//------------------------------------------------------------------------------
vtkFFConvexifyFilter::vtkFFConvexifyFilter()
  : KernelPoint{ 0.0, 0.0, 0.0 }
  , UseKernelPoint(false)
{
  this->SetInternals(std::make_unique<vtkInternals>(this));
}

//------------------------------------------------------------------------------
vtkFFConvexifyFilter::~vtkFFConvexifyFilter() = default;

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
void vtkFFConvexifyFilter::vtkInternals::Execute(
  const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs, vtkFFFailure& failure)
{
  vtkPolyData* input = vtkPolyData::SafeDownCast(blocks[0].Pieces.front());
  std::size_t count = 0;
  for (vtkPointSet* piece : blocks[0].Pieces)
  {
    if (piece->GetNumberOfCells() > 0)
    {
      input = vtkPolyData::SafeDownCast(piece);
      ++count;
    }
  }
  if (count == 0 && blocks[0].NumberOfPoints > 0)
  {
    failure.Say("The surface" + this->OfBlock() + " has no cells, but " +
      std::to_string(blocks[0].NumberOfPoints) +
      " point(s). It takes triangles, polygons and triangle strips; Convex Hull (vtkFFHullFilter) "
      "gives the hull of points.");
    return;
  }
  if (count > 1)
  {
    failure.Say("The surface" + this->OfBlock() + " is spread over " + std::to_string(count) +
      " partitions. Make one data set of them, such that they share the points where they meet: "
      "Append Geometry (vtkAppendPolyData) and Clean (vtkCleanPolyData) can do that.");
    return;
  }
  const std::string fault = vtkFFSurfaceCells::DescribeFault(input, this->OfBlock());
  if (!fault.empty())
  {
    failure.Say(fault);
    return;
  }
  this->Convexify(input, outputs[0], failure);
}

//------------------------------------------------------------------------------
void vtkFFConvexifyFilter::vtkInternals::Convexify(
  vtkPolyData* input, vtkPolyData* output, vtkFFFailure& failure)
{
  const auto* filter = static_cast<vtkFFConvexifyFilter*>(this->GetFilter());
  if (filter->Engine == ENGINE_CUDA)
  {
    failure.Say("The CUDA engine was asked for, but this filter runs on the CPU. Set Engine to "
                "Automatic or CPU.");
    return;
  }
  const double* kernel = filter->UseKernelPoint ? filter->KernelPoint : nullptr;
  if (kernel && !std::all_of(kernel, kernel + 3, [](double x) { return vtkMath::IsFinite(x); }))
  {
    std::ostringstream message;
    message << "The kernel point (" << kernel[0] << ", " << kernel[1] << ", " << kernel[2]
            << ") is not finite.";
    failure.Say(message.str());
    return;
  }

  const auto work = [&](const flipflop::Options& chosen, const flipflop::EngineOptions&,
                      flipflop::EngineReport& report)
  {
    report.used = flipflop::EngineChoice::CPU;
    std::snprintf(report.reason, sizeof(report.reason), "%s",
      filter->Engine == ENGINE_CPU ? "the CPU engine was asked for"
                                   : "this filter runs on the CPU");

    flipflop::Options options = chosen;
    options.nonFinite = flipflop::NonFinitePolicy::Error;

    vtkPoints* points = input->GetPoints();
    const vtkFFPointSource source(points ? points->GetData() : nullptr);
    const vtkFFSurfaceCells cells(input, source.GetView(), options);
    flipflop::Hull hull;
    if (cells.GetView().count > 0)
    {
      hull = cells.FlipFlop(source.GetView(), kernel, options);
    }
    std::vector<vtkFFOutput::Source> data;
    if (filter->PassPointData)
    {
      data.push_back({ input->GetPointData(), input->GetNumberOfPoints() });
    }
    vtkFFOutput::Adopt(hull, source, data, filter->VisiblePointIds, output);
    this->AddToReport(hull, report, output);
  };
  this->TryEngine(work, failure);
}

//------------------------------------------------------------------------------
std::string vtkFFConvexifyFilter::vtkInternals::DescribeError(const flipflop::Error& error)
{
  if (error.code() == flipflop::ErrorCode::NonFinite)
  {
    return this->DescribeNonFinite("A coordinate", error) +
      " They are corners of the surface, which has to be mended.";
  }
  return this->vtkFFHullAlgorithm::vtkInternals::DescribeError(error);
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
