// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFConvexifyFilter.h"

#include "vtkFFHullInternals.h"
#include "vtkFFOutput.h"
#include "vtkFFPointSource.h"

#include <flipflop/Engines.h>
#include <flipflop/FlipFlop.h>

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
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

namespace
{

/// Where the first cell's corners begin: VTK takes any place for it.
vtkIdType firstCornerOf(vtkCellArray* cells)
{
  return cells->GetNumberOfCells() > 0
    ? static_cast<vtkIdType>(cells->GetOffsetsArray()->GetComponent(0, 0))
    : 0;
}

/// The corners of cells that all are triangles; copied only when they are not 64-bit integers.
/// Cells may leave out corners before the first one's, and after the last one's.
class Triangles
{
public:
  explicit Triangles(vtkCellArray* cells)
  {
    this->View.count = cells->GetNumberOfCells();
    if (this->View.count == 0)
    {
      return;
    }
    vtkDataArray* corners = cells->GetConnectivityArray();
    const vtkIdType first = firstCornerOf(cells);
    if (auto* wide = vtkAOSDataArrayTemplate<vtkTypeInt64>::FastDownCast(corners))
    {
      static_assert(sizeof(vtkTypeInt64) == sizeof(std::int64_t), "the same type by two names");
      this->View.corners = reinterpret_cast<const std::int64_t*>(wide->GetPointer(first));
      return;
    }
    const vtkIdType size = 3 * static_cast<vtkIdType>(this->View.count);
    this->Copy.allocate(static_cast<std::size_t>(size));
    auto* narrow = vtkAOSDataArrayTemplate<vtkTypeInt32>::FastDownCast(corners);
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->Copy[static_cast<std::size_t>(i)] = narrow
        ? static_cast<std::int64_t>(narrow->GetValue(first + i))
        : static_cast<std::int64_t>(corners->GetComponent(first + i, 0));
    }
    this->View.corners = this->Copy.data();
  }

  const flipflop::TriangleView& GetView() const { return this->View; }

private:
  flipflop::TriangleView View;
  flipflop::Buffer<std::int64_t> Copy;
};

}

//------------------------------------------------------------------------------
class vtkFFConvexifyFilter::vtkInternals : public vtkFFHullAlgorithm::vtkInternals
{
public:
  using vtkFFHullAlgorithm::vtkInternals::vtkInternals;

  std::vector<std::string> GetLeafTypes() override { return { "vtkPolyData" }; }
  bool Execute(const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs) override;
  std::string DescribeError(const flipflop::Error& error) override;

private:
  bool CheckCells(vtkPolyData* input);
  bool Convexify(vtkPolyData* input, vtkPolyData* output);
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
bool vtkFFConvexifyFilter::vtkInternals::Execute(
  const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs)
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
    this->ReportError("The surface" + this->OfBlock() + " has no cells, but " +
      std::to_string(blocks[0].NumberOfPoints) +
      " point(s). It takes triangles; vtkFFHullFilter gives the hull of points.");
    return false;
  }
  if (count > 1)
  {
    this->ReportError("The surface is spread over " + std::to_string(count) +
      " partitions. Make one data set of them, such that they share the points where they meet: "
      "vtkAppendPolyData and vtkCleanPolyData can do that.");
    return false;
  }
  return this->CheckCells(input) && this->Convexify(input, outputs[0]);
}

//------------------------------------------------------------------------------
bool vtkFFConvexifyFilter::vtkInternals::CheckCells(vtkPolyData* input)
{
  // Cells are counted as vtkPolyData does: vertices, lines, polygons, strips.
  const char* kind = nullptr;
  vtkIdType cell = 0;
  vtkCellArray* polys = input->GetPolys();
  if (input->GetNumberOfVerts() > 0)
  {
    kind = "a vertex cell";
  }
  else if (input->GetNumberOfLines() > 0)
  {
    kind = "a line cell";
  }
  else
  {
    const vtkIdType count = polys->GetNumberOfCells();
    if (polys->IsHomogeneous() != 3)
    {
      while (cell < count && polys->GetCellSize(cell) == 3)
      {
        ++cell;
      }
    }
    else
    {
      cell = count;
    }
    kind = cell < count                ? "a polygon"
      : input->GetNumberOfStrips() > 0 ? "a triangle strip"
                                       : nullptr;
  }
  if (kind)
  {
    std::ostringstream message;
    message << "Every cell of the input must be a triangle, but cell " << cell << this->OfBlock()
            << " is " << kind;
    if (cell < polys->GetNumberOfCells() && input->GetNumberOfVerts() == 0 &&
      input->GetNumberOfLines() == 0)
    {
      message << " of " << polys->GetCellSize(cell) << " points";
    }
    message << ". vtkTriangleFilter makes triangles of polygons and strips.";
    this->ReportError(message.str());
    return false;
  }

  const vtkIdType first = firstCornerOf(polys);
  const vtkIdType size = 3 * polys->GetNumberOfCells();
  const vtkIdType given = polys->GetConnectivityArray()->GetNumberOfTuples();
  if (first < 0 || first > given - size)
  {
    std::ostringstream message;
    message << "The input's cells" << this->OfBlock()
            << " are not valid: their offsets name corners " << first << " to " << first + size - 1
            << ", and the connectivity has " << given << ".";
    this->ReportError(message.str());
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkFFConvexifyFilter::vtkInternals::Convexify(vtkPolyData* input, vtkPolyData* output)
{
  const auto* filter = static_cast<vtkFFConvexifyFilter*>(this->GetFilter());
  if (filter->Engine == ENGINE_CUDA)
  {
    this->ReportError("The CUDA engine was asked for, but this filter runs on the CPU. Use "
                      "SetEngineToAutomatic() or SetEngineToCPU().");
    return false;
  }
  const double* kernel = filter->UseKernelPoint ? filter->KernelPoint : nullptr;
  if (kernel && !std::all_of(kernel, kernel + 3, [](double x) { return vtkMath::IsFinite(x); }))
  {
    std::ostringstream message;
    message << "The kernel point (" << kernel[0] << ", " << kernel[1] << ", " << kernel[2]
            << ") is not finite.";
    this->ReportError(message.str());
    return false;
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
    const Triangles triangles(input->GetPolys());
    flipflop::Hull hull;
    if (triangles.GetView().count > 0)
    {
      hull = flipflop::flipFlop(source.GetView(), triangles.GetView(), kernel, options);
    }
    this->AddToReport(hull, report, output);

    std::vector<vtkFFOutput::Source> data;
    if (filter->PassPointData)
    {
      data.push_back({ input->GetPointData(), input->GetNumberOfPoints() });
    }
    vtkFFOutput::Adopt(hull, source, data, filter->VisiblePointIds, output);
  };
  return this->RunEngine(work);
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
