// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFSelectEnclosedPoints.h"

#include "FFBlocks.h"
#include "FFInput.h"
#include "FFRun.h"

#include <flipflop/ConvexHull.h>
#include <flipflop/HullQueries.h>

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSignedCharArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <stdexcept>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFSelectEnclosedPoints);

/// The hull of a surface's points, ready for queries.
struct FFPreparedHull
{
  int Dimension;
  flipflop::HullQueries Queries;
};

namespace
{

constexpr double shareOfHull = 0.4; // of the progress of a run that makes one

}

//------------------------------------------------------------------------------
vtkFFSelectEnclosedPoints::vtkFFSelectEnclosedPoints() = default;

//------------------------------------------------------------------------------
vtkFFSelectEnclosedPoints::~vtkFFSelectEnclosedPoints() = default;

//------------------------------------------------------------------------------
double vtkFFSelectEnclosedPoints::Prepare(vtkDataObject* surface, FFRun& run)
{
  if (this->IsPrepared(surface) && this->Prepared)
  {
    return 0.0;
  }
  this->Prepared.reset();
  FFInput input;
  input.Take(FFBlocks::PiecesOf(surface), this->SkipGhostPoints, run, " of the surface");
  run.SetPart(0.0, 0.8 * shareOfHull);
  const flipflop::Hull hull = flipflop::convexHull(input.GetView(), run.Options);
  run.SetPart(0.8 * shareOfHull, shareOfHull);
  flipflop::HullQueries queries(input.GetView(), hull, run.Options);
  this->Prepared.reset(new FFPreparedHull{ hull.dimension, std::move(queries) });
  this->SetPrepared(surface);
  return shareOfHull;
}

//------------------------------------------------------------------------------
void vtkFFSelectEnclosedPoints::Execute(vtkDataObject* data, vtkDataSet* result, FFRun& run)
{
  FFInput input;
  const vtkIdType count = input.Take(FFBlocks::PiecesOf(data), false, run);
  vtkNew<vtkSignedCharArray> sides;
  sides->SetName("FlipFlopSide");
  sides->SetNumberOfValues(count);
  static_assert(sizeof(signed char) == sizeof(std::int8_t), "the same type by two names");
  std::int8_t* const side = sides->GetPointer(0);
  const double end = this->GenerateDistances ? 0.3 : 1.0;
  run.SetPart(0.0, end);
  this->Prepared->Queries.contains(input.GetView(), side, run.Options);
  vtkPointData* const arrays = result->GetPointData();
  if (this->GenerateDistances)
  {
    vtkNew<vtkDoubleArray> distances;
    distances->SetName("FlipFlopDistance");
    distances->SetNumberOfValues(count);
    run.SetPart(end, 1.0);
    this->Prepared->Queries.distance(input.GetView(), distances->GetPointer(0), run.Options);
    arrays->AddArray(distances);
  }
  vtkNew<vtkUnsignedCharArray> selected;
  selected->SetName("SelectedPoints");
  selected->SetNumberOfValues(count);
  std::transform(side, side + count, selected->GetPointer(0),
    [&](std::int8_t one)
    { return static_cast<unsigned char>(this->IsEnclosed(one) != this->InsideOut); });
  arrays->AddArray(sides);
  // SetScalars() would remove the array that was active.
  arrays->SetActiveAttribute(arrays->AddArray(selected), vtkDataSetAttributes::SCALARS);
  run.Report.Dimension = this->Prepared->Dimension;
}

//------------------------------------------------------------------------------
int vtkFFSelectEnclosedPoints::IsInside(vtkIdType inputPointId)
{
  vtkDataSet* const output = vtkDataSet::GetData(this->GetOutputInformation(0));
  auto* const selected = output
    ? vtkUnsignedCharArray::SafeDownCast(output->GetPointData()->GetAbstractArray("SelectedPoints"))
    : nullptr;
  return selected && inputPointId >= 0 && inputPointId < selected->GetNumberOfValues()
    ? selected->GetValue(inputPointId)
    : 0;
}

//------------------------------------------------------------------------------
void vtkFFSelectEnclosedPoints::Initialize(vtkDataObject* surface)
{
  this->Complete();
  FFRun run(this, nullptr);
  run.Do(
    [&]
    {
      if (!surface)
      {
        throw std::runtime_error("There is no surface. Set one.");
      }
      this->Prepare(surface, run);
      run.Report.Dimension = this->Prepared->Dimension;
    });
  run.Finish({});
}

//------------------------------------------------------------------------------
int vtkFFSelectEnclosedPoints::IsInsideSurface(const double x[3])
{
  try
  {
    if (!this->Prepared)
    {
      throw std::runtime_error(
        "There is no surface to ask about: call Initialize() or update the filter first.");
    }
    flipflop::Options options;
    options.threads = 1;
    options.nonFinite = flipflop::NonFinitePolicy::Ignore;
    std::int8_t side = -1;
    this->Prepared->Queries.contains(flipflop::PointView(x, 1), &side, options);
    return this->IsEnclosed(side) ? 1 : 0;
  }
  catch (const std::exception& error)
  {
    this->ErrorCode = vtkFFErrorCode::InputError; // which is no change of the filter
    vtkErrorMacro(<< error.what());
    return 0;
  }
}

//------------------------------------------------------------------------------
void vtkFFSelectEnclosedPoints::Complete()
{
  this->Prepared.reset();
}

//------------------------------------------------------------------------------
void vtkFFSelectEnclosedPoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto onOff = [](bool flag) { return flag ? "On" : "Off"; };
  os << indent << "InsideOut: " << onOff(this->InsideOut) << "\n";
  os << indent << "SelectPointsOnSurface: " << onOff(this->SelectPointsOnSurface) << "\n";
  os << indent << "GenerateDistances: " << onOff(this->GenerateDistances) << "\n";
}
VTK_ABI_NAMESPACE_END
