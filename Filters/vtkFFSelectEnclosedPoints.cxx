// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFSelectEnclosedPoints.h"

#include "vtkFFPointSource.h"
#include "vtkFFQueryInternals.h"

#include <flipflop/ConvexHull.h>
#include <flipflop/HullQueries.h>

#include "vtkAlgorithmOutput.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSignedCharArray.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdint>
#include <memory>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFSelectEnclosedPoints);

//------------------------------------------------------------------------------
class vtkFFSelectEnclosedPoints::vtkInternals : public vtkFFQueryAlgorithm::vtkInternals
{
public:
  using vtkFFQueryAlgorithm::vtkInternals::vtkInternals;

  void Forget() override;
  bool KeepsPrepared() override { return true; }
  std::string GetSecondName() override { return "surface"; }
  int Prepare(const std::vector<vtkPointSet*>& pieces, const flipflop::Options& options) override;
  void Answer(const flipflop::PointView& points, const flipflop::Options& options,
    vtkDataSet* output) override;

  const char* GetProgressTitle() override { return "Points in convex hull"; }
  vtkFFSelectEnclosedPoints* GetSelection() const
  {
    return static_cast<vtkFFSelectEnclosedPoints*>(this->GetFilter());
  }
  bool IsEnclosed(std::int8_t side) const
  {
    return side >= (this->GetSelection()->SelectPointsOnSurface ? 0 : 1);
  }

  std::unique_ptr<const flipflop::HullQueries> Hull;    // null: none is prepared
  vtkSmartPointer<vtkUnsignedCharArray> SelectedPoints; // of the last run
};

//------------------------------------------------------------------------------
vtkFFSelectEnclosedPoints::vtkFFSelectEnclosedPoints()
  : InsideOut(false)
  , SelectPointsOnSurface(true)
  , GenerateDistances(false)
{
  this->SetInternals(std::make_unique<vtkInternals>(this));
}

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
void vtkFFSelectEnclosedPoints::vtkInternals::Forget()
{
  this->Hull.reset();
  this->SelectedPoints = nullptr;
}

//------------------------------------------------------------------------------
int vtkFFSelectEnclosedPoints::vtkInternals::Prepare(
  const std::vector<vtkPointSet*>& pieces, const flipflop::Options& options)
{
  const vtkFFPointSource points(ArraysOf(pieces));
  this->SetProgressPart(0.0, 0.8);
  const flipflop::Hull hull = flipflop::convexHull(points.GetView(), options);
  this->SetProgressPart(0.8, 1.0);
  this->Hull = std::make_unique<flipflop::HullQueries>(points.GetView(), hull, options);
  return hull.dimension;
}

//------------------------------------------------------------------------------
void vtkFFSelectEnclosedPoints::vtkInternals::Answer(
  const flipflop::PointView& points, const flipflop::Options& options, vtkDataSet* output)
{
  const vtkFFSelectEnclosedPoints* filter = this->GetSelection();
  const auto count = static_cast<vtkIdType>(points.count);
  vtkNew<vtkSignedCharArray> sides;
  sides->SetName("FlipFlopSide");
  sides->SetNumberOfValues(count);
  static_assert(sizeof(signed char) == sizeof(std::int8_t), "the same type by two names");
  std::int8_t* const side = sides->GetPointer(0);
  this->SetProgressPart(0.0, filter->GenerateDistances ? 0.3 : 1.0);
  this->Hull->contains(points, side, options);
  if (filter->GenerateDistances)
  {
    vtkNew<vtkDoubleArray> distances;
    distances->SetName("FlipFlopDistance");
    distances->SetNumberOfValues(count);
    this->SetProgressPart(0.3, 1.0);
    this->Hull->distance(points, distances->GetPointer(0), options);
    output->GetPointData()->AddArray(distances);
  }

  vtkNew<vtkUnsignedCharArray> selected;
  selected->SetName("SelectedPoints");
  selected->SetNumberOfValues(count);
  std::transform(side, side + count, selected->GetPointer(0),
    [&](std::int8_t one)
    { return static_cast<unsigned char>(this->IsEnclosed(one) != filter->InsideOut); });
  output->GetPointData()->AddArray(sides);
  // SetScalars() would remove the array that was active.
  const int index = output->GetPointData()->AddArray(selected);
  output->GetPointData()->SetActiveAttribute(index, vtkDataSetAttributes::SCALARS);
  this->SelectedPoints =
    output == this->GetFilter()->GetOutputDataObject(0) ? selected.Get() : nullptr;
}

//------------------------------------------------------------------------------
int vtkFFSelectEnclosedPoints::IsInside(vtkIdType inputPointId)
{
  vtkUnsignedCharArray* selected = static_cast<vtkInternals*>(this->GetInternals())->SelectedPoints;
  return selected && inputPointId >= 0 && inputPointId < selected->GetNumberOfValues()
    ? selected->GetValue(inputPointId)
    : 0;
}

//------------------------------------------------------------------------------
void vtkFFSelectEnclosedPoints::Initialize(vtkDataObject* surface)
{
  this->GetInternals()->RunPrepare(surface);
}

//------------------------------------------------------------------------------
int vtkFFSelectEnclosedPoints::IsInsideSurface(const double x[3])
{
  auto* internals = static_cast<vtkInternals*>(this->GetInternals());
  if (!internals->Hull)
  {
    internals->ReportError(
      "There is no surface to ask about: call Initialize() or update the filter first.");
    return 0;
  }
  flipflop::Options options;
  options.threads = 1;
  options.nonFinite = flipflop::NonFinitePolicy::Ignore;
  std::int8_t side = -1;
  internals->Ask([&] { internals->Hull->contains(flipflop::PointView(x, 1), &side, options); });
  return internals->IsEnclosed(side) ? 1 : 0;
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
  this->GetInternals()->Forget();
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
