// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterInputs.h"
#include "FilterRun.h"
#include "FilterSettings.h"

#include "vtkDataArray.h"
#include "vtkFFPointInterpolator2D.h"
#include "vtkFFSelectEnclosedPoints.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <algorithm>

namespace flipflop
{
namespace fuzz
{

namespace
{

vtkSmartPointer<vtkFFQueryAlgorithm> makeFilter(bool interpolates)
{
  vtkSmartPointer<vtkFFQueryAlgorithm> filter;
  if (interpolates)
  {
    filter = vtkSmartPointer<vtkFFPointInterpolator2D>::New();
  }
  else
  {
    filter = vtkSmartPointer<vtkFFSelectEnclosedPoints>::New();
  }
  return filter;
}

void demandFull(vtkDataSet* output, const std::string& name)
{
  vtkAbstractArray* array = output->GetPointData()->GetAbstractArray(name.c_str());
  demand(array && array->GetNumberOfTuples() == output->GetNumberOfPoints(),
    "not an answer for each point: " + name);
}

/// The answers of a run, beside those to single points.
void judgeSides(vtkFFSelectEnclosedPoints* filter, vtkDataSet* output)
{
  constexpr vtkIdType Some = 60;
  demandFull(output, "SelectedPoints");
  demandFull(output, "FlipFlopSide");
  vtkDataArray* sides = output->GetPointData()->GetArray("FlipFlopSide");
  for (vtkIdType i = 0; i < std::min(Some, output->GetNumberOfPoints()); ++i)
  {
    double x[3];
    output->GetPoint(i, x);
    if (vtkMath::IsFinite(x[0]) && vtkMath::IsFinite(x[1]) && vtkMath::IsFinite(x[2]))
    {
      const double side = sides->GetComponent(i, 0);
      const bool enclosed = side > 0 || (side == 0 && filter->GetSelectPointsOnSurface());
      demand(filter->IsInsideSurface(x) == int(enclosed), "a point alone has another side");
      demand(filter->IsInside(i) == int(enclosed != filter->GetInsideOut()), "another selection");
    }
  }
}

}

void queryFilters(Bytes& bytes, vtkDataObject* given, int mostPoints)
{
  const bool interpolates = bytes.flag();
  const auto filter = makeFilter(interpolates);
  const auto errors = fftest::ErrorObserver::Of(filter);
  vtkNew<Aborter> abort;
  filter->AddObserver(vtkCommand::ProgressEvent, abort);
  std::vector<Bytes> settings; // where each run's begin
  vtkSmartPointer<vtkDataObject> data[2];
  for (int runs = 1 + bytes.below(3); runs > 0; --runs)
  {
    settings.push_back(bytes);
    drawSettings(bytes, filter);
    abort->draw(bytes);
    for (int port = 0; port < 2; ++port)
    {
      if (!data[port] || bytes.flag())
      {
        data[port] = given && bytes.flag() ? given : drawDataObject(bytes, mostPoints).Get();
      }
      filter->SetInputDataObject(port, data[port]);
    }
    errors->Clear();
    filter->Modified();
    filter->Update();
    vtkDataObject* output = filter->GetOutputDataObject(0);
    const bool typed = data[1]->IsA("vtkDataSet") || data[1]->IsA("vtkCompositeDataSet");
    if (demandTold(filter, typed ? data[0] : nullptr, errors) || isCutShort(abort, output))
    {
      continue;
    }
    const auto again = makeFilter(interpolates);
    const auto errorsAgain = fftest::ErrorObserver::Of(again);
    for (Bytes once : settings)
    {
      drawSettings(once, again);
    }
    again->SetNumberOfThreads(filter->GetNumberOfThreads() == 1 ? 2 : 1);
    again->SetInputDataObject(0, data[0]);
    again->SetInputDataObject(1, data[1]);
    again->Update();
    demand(errorsAgain->Messages.size() == errors->Messages.size(),
      "another filter of the same settings fails");
    demand(again->GetDimension() == filter->GetDimension(), "of another dimension");
    demand(fftest::isIdentical(again->GetOutputDataObject(0), output, "on other threads"),
      "the answers are not the same on other threads");
    auto* answered = vtkDataSet::SafeDownCast(output);
    auto* enclosed = vtkFFSelectEnclosedPoints::SafeDownCast(filter);
    if (answered && enclosed)
    {
      judgeSides(enclosed, answered);
    }
    auto* interpolator = vtkFFPointInterpolator2D::SafeDownCast(filter);
    if (answered && interpolator &&
      interpolator->GetNullPointsStrategy() == vtkFFPointInterpolator2D::MASK_POINTS)
    {
      demandFull(answered, interpolator->GetValidPointsMaskArrayName());
    }
    demand(fftest::failures() == 0, "a check of the tests' own fails");
  }
}

}
}
