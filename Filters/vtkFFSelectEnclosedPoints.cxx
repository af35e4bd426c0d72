// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFSelectEnclosedPoints.h"

#include "vtkFFInput.h"
#include "vtkFFRun.h"
#include "vtkFFStamp.h"

#include <flipflop/ConvexHull.h>
#include <flipflop/HullQueries.h>

#include "vtkAlgorithmOutput.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkInformationVector.h"
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

/// The hull of a surface's points, ready for questions.
struct vtkFFPreparedHull
{
  vtkFFStamp Stamp;
  int Dimension;
  flipflop::HullQueries Queries;
};

namespace
{

constexpr double shareOfHull = 0.4; // of the progress of a run that makes one

std::unique_ptr<const vtkFFPreparedHull> prepare(
  vtkFFSelectEnclosedPoints* filter, vtkDataObject* surface, vtkFFRun& run)
{
  const vtkFFStamp stamp(filter, surface);
  vtkFFInput input;
  input.Take(vtkFFInput::PiecesOf(surface), filter->GetSkipGhostPoints(), run, " of the surface");
  run.SetPart(0.0, 0.8 * shareOfHull);
  const flipflop::Hull hull = flipflop::convexHull(input.GetView(), run.Options);
  run.SetPart(0.8 * shareOfHull, shareOfHull);
  flipflop::HullQueries queries(input.GetView(), hull, run.Options);
  run.Parts.clear(); // what errors are about from now on is the input
  run.Ids.clear();
  return std::unique_ptr<const vtkFFPreparedHull>(
    new vtkFFPreparedHull{ stamp, hull.dimension, std::move(queries) });
}

}

//------------------------------------------------------------------------------
vtkFFSelectEnclosedPoints::vtkFFSelectEnclosedPoints() = default;

//------------------------------------------------------------------------------
vtkFFSelectEnclosedPoints::~vtkFFSelectEnclosedPoints() = default;

//------------------------------------------------------------------------------
void vtkFFSelectEnclosedPoints::SetSurfaceData(vtkDataObject* surface)
{
  this->SetInputData(1, surface);
}

//------------------------------------------------------------------------------
void vtkFFSelectEnclosedPoints::SetSurfaceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
vtkDataObject* vtkFFSelectEnclosedPoints::GetSurface()
{
  return this->GetNumberOfInputConnections(1) > 0 ? this->GetExecutive()->GetInputData(1, 0)
                                                  : nullptr;
}

//------------------------------------------------------------------------------
int vtkFFSelectEnclosedPoints::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const points = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* const surface = vtkDataObject::GetData(inputVector[1]);
  vtkDataSet* const output = vtkDataSet::GetData(outputVector);
  vtkFFRun run(this, "Points in convex hull", outputVector);
  this->SelectedPoints = nullptr;
  if (this->IsSecondAtFault)
  {
    output->Initialize();
    return 1;
  }
  double begin = 0.0;
  run.Do(
    [&]
    {
      if (!this->Prepared || !(this->Prepared->Stamp == vtkFFStamp(this, surface)))
      {
        this->Prepared.reset();
        this->Prepared = prepare(this, surface, run);
        begin = shareOfHull;
      }
    });
  this->IsSecondAtFault = static_cast<bool>(run.Failure);
  run.Do(
    [&]
    {
      vtkFFInput input;
      const vtkIdType count = input.Take(vtkFFInput::PiecesOf(points), false, run);
      output->ShallowCopy(points);
      vtkNew<vtkSignedCharArray> sides;
      sides->SetName("FlipFlopSide");
      sides->SetNumberOfValues(count);
      static_assert(sizeof(signed char) == sizeof(std::int8_t), "the same type by two names");
      std::int8_t* const side = sides->GetPointer(0);
      const double end = this->GenerateDistances ? begin + 0.3 * (1.0 - begin) : 1.0;
      run.SetPart(begin, end);
      this->Prepared->Queries.contains(input.GetView(), side, run.Options);
      if (this->GenerateDistances)
      {
        vtkNew<vtkDoubleArray> distances;
        distances->SetName("FlipFlopDistance");
        distances->SetNumberOfValues(count);
        run.SetPart(end, 1.0);
        this->Prepared->Queries.distance(input.GetView(), distances->GetPointer(0), run.Options);
        output->GetPointData()->AddArray(distances);
      }
      vtkNew<vtkUnsignedCharArray> selected;
      selected->SetName("SelectedPoints");
      selected->SetNumberOfValues(count);
      std::transform(side, side + count, selected->GetPointer(0),
        [&](std::int8_t one)
        { return static_cast<unsigned char>(this->IsEnclosed(one) != this->InsideOut); });
      output->GetPointData()->AddArray(sides);
      // SetScalars() would remove the array that was active.
      const int index = output->GetPointData()->AddArray(selected);
      output->GetPointData()->SetActiveAttribute(index, vtkDataSetAttributes::SCALARS);
      this->SelectedPoints = run.IsInComposite() ? nullptr : selected.Get();
      this->Dimension = this->Prepared->Dimension;
    });
  return run.Finish();
}

//------------------------------------------------------------------------------
int vtkFFSelectEnclosedPoints::IsInside(vtkIdType inputPointId)
{
  return this->SelectedPoints && inputPointId >= 0 &&
      inputPointId < this->SelectedPoints->GetNumberOfValues()
    ? this->SelectedPoints->GetValue(inputPointId)
    : 0;
}

//------------------------------------------------------------------------------
void vtkFFSelectEnclosedPoints::Initialize(vtkDataObject* surface)
{
  this->Complete();
  this->Dimension = -1;
  this->SetErrorCode(vtkFFErrorCode::NoError);
  vtkFFRun run(this, "Points in convex hull", nullptr);
  run.Options.progress = nullptr; // it is no run of the pipeline's, which could be stopped
  run.Do(
    [&]
    {
      if (!surface)
      {
        throw std::runtime_error("There is no surface. Set one.");
      }
      this->Prepared = prepare(this, surface, run);
      this->Dimension = this->Prepared->Dimension;
    });
  run.Finish();
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
    this->SetErrorCode(vtkFFErrorCode::InputError);
    vtkErrorMacro(<< error.what());
    return 0;
  }
}

//------------------------------------------------------------------------------
int vtkFFSelectEnclosedPoints::IsInsideSurface(double x, double y, double z)
{
  const double point[3] = { x, y, z };
  return this->IsInsideSurface(point);
}

//------------------------------------------------------------------------------
void vtkFFSelectEnclosedPoints::Complete()
{
  this->Prepared.reset();
  this->SelectedPoints = nullptr;
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
