// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// A setting that concerns the output alone takes the hull or triangulation of the last run, and
// gives what a new filter gives, bit for bit. Whatever it depends on has the engine run again.
#include "FFPlanar.h"

#include "vtkFFHullFilter.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"

#include <cmath>
#include <functional>
#include <memory>

using namespace fftest;

namespace
{

using Hull = vtkFFHullFilter;
using Triangulation = vtkFFRegularTriangulationFilter;
using Diagram = vtkFFPowerDiagramFilter;

template <class FilterT>
struct Change
{
  const char* Name;
  bool Runs; ///< whether the engine has to run again
  std::function<void(FilterT*)> Make;
};

template <class FilterT>
double secondsOf(FilterT* filter)
{
  return reported(filter->GetOutput(), "SecondsTotal");
}

/// The report may be of a run for the other kind of facets.
vtkSmartPointer<vtkPolyData> withoutReport(vtkPolyData* output)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->ShallowCopy(output);
  vtkNew<vtkFieldData> none;
  data->SetFieldData(none);
  return data;
}

/// Makes one change after the other. After each, a filter to which all are made at once agrees.
template <class FilterT>
void testChanges(vtkDataObject* input, const char* weights,
  const std::vector<Change<FilterT>>& changes, bool joins = false)
{
  const auto set = [=](FilterT* filter)
  {
    filter->SetReportAsFieldData(true);
    if (auto* hull = vtkFFHullFilter::SafeDownCast(filter))
    {
      hull->SetCompositeMode(joins);
    }
  };
  Watched<FilterT> run(input, weights);
  set(run.Get());
  run.Run();
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    const double before = secondsOf(run.Get());
    changes[i].Make(run.Get());
    run.Run();
    FF_CHECK_EQUAL(std::string(changes[i].Name) +
        (secondsOf(run.Get()) != before ? ": has run" : ": has not run"),
      std::string(changes[i].Name) + (changes[i].Runs ? ": has run" : ": has not run"));

    // Not the input itself: it would have been generated again, for all that its users can know.
    vtkSmartPointer<vtkDataObject> same;
    same.TakeReference(input->NewInstance());
    same->ShallowCopy(input);
    Watched<FilterT> fresh(same, weights);
    set(fresh.Get());
    for (std::size_t k = 0; k <= i; ++k)
    {
      changes[k].Make(fresh.Get());
    }
    fresh.Run();
    FF_CHECK_EQUAL(printedReport(run.Get()), printedReport(fresh.Get()));
    for (int port = 0; port < run->GetNumberOfOutputPorts(); ++port)
    {
      FF_CHECK(isIdentical(withoutReport(run->GetOutput(port)),
        withoutReport(fresh->GetOutput(port)), changes[i].Name));
    }
  }
}

/// Points with weights, of which some are hidden, some are ghosts, and some lie on one circle.
vtkSmartPointer<vtkPolyData> makeInput()
{
  std::vector<Point> points = randomPoints(2000, 301);
  std::vector<double> weights;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    weights.push_back(i % 3 ? 0.0 : 0.001 * std::fabs(points[i][2]));
    points[i][0] = i % 2 ? std::floor(20 * points[i][0]) / 20 : points[i][0];
    points[i][1] = i % 2 ? std::floor(20 * points[i][1]) / 20 : points[i][1];
  }
  const auto input = makeWeighted(points, weights);
  addGhosts(input, { 0, 7, 500, 1999 });
  return input;
}

/// A change of data, made once for both filters.
std::function<void(void*)> once(const std::function<void()>& change)
{
  auto isMade = std::make_shared<bool>(false);
  return [=](void*)
  {
    if (!*isMade)
    {
      *isMade = true;
      change();
    }
  };
}

template <class FilterT>
std::vector<Change<FilterT>> changesOfAll(vtkPolyData* input, vtkTransform* transform)
{
  return {
    { "report", false,
      [](FilterT* f) { f->SetReportAsFieldData(false), f->SetReportAsFieldData(true); } },
    { "measures", false, [](FilterT* f) { f->SetGenerateCellMeasures(true); } },
    { "visible ids", false, [](FilterT* f) { f->SetVisiblePointIds(true); } },
    { "no point data", false, [](FilterT* f) { f->SetPassPointData(false); } },
    { "unused transform", false, [=](FilterT* f) { f->StoreTransform(transform); } },
    { "weight factor", true, [](FilterT* f) { f->SetWeightFactor(0.5); } },
    { "weight mode", true, [](FilterT* f) { f->SetWeightMode(vtkFFPlanarAlgorithm::RADII); } },
    { "a weight", true,
      once(
        [=]
        {
          input->GetPointData()->GetArray("weights")->SetTuple1(40, 0.3);
          input->GetPointData()->GetArray("weights")->Modified();
        }) },
    { "a point", true,
      once(
        [=]
        {
          input->GetPoints()->SetPoint(50, 3, 4, 5);
          input->GetPoints()->Modified();
        }) },
    { "in place", true,
      [change = once([=] { input->GetPoints()->SetPoint(51, 3, 5, 4); })](FilterT* f)
      {
        change(f); // which nobody else can know
        f->Modified();
      } },
    { "other points", true,
      once([=] { input->SetPoints(makePoints(randomPoints(2000, 302))->GetPoints()); }) },
    { "ghosts", true, [](FilterT* f) { f->SetSkipGhostPoints(false); } },
    { "fitted plane", true,
      [](FilterT* f) { f->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::BEST_FITTING_PLANE); } },
    { "transformed", true,
      [](FilterT* f) { f->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::TRANSFORM_PLANE); } },
    { "point data", false, [](FilterT* f) { f->SetPassPointData(true); } },
    { "the transform", true, once([=] { transform->RotateX(20.0); }) },
    { "variant", true, [](FilterT* f) { f->SetVBiased(false); } },
    { "policy", true,
      [](FilterT* f) { f->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE); } },
    { "no weights", true, [](FilterT* f) { useWeights(f, ""); } },
    { "unused factor", false, [](FilterT* f) { f->SetWeightFactor(7.0); } },
  };
}

void testTriangulation()
{
  const auto input = makeInput();
  std::vector<Change<Triangulation>> changes{
    { "alpha", false, [](Triangulation* f) { f->SetAlpha(0.05); } },
    { "less alpha", false, [](Triangulation* f) { f->SetAlpha(0.02); } },
    { "lines", false, [](Triangulation* f) { f->SetAlphaLines(true); } },
    { "vertices", false, [](Triangulation* f) { f->SetAlphaVerts(true); } },
    { "alphas", false, [](Triangulation* f) { f->SetGenerateAlphas(true); } },
    { "border", false, [](Triangulation* f) { f->SetGenerateBoundary(true); } },
    { "certificate", false, [](Triangulation* f) { f->SetGenerateCertificate(true); } },
    { "length", false, [](Triangulation* f) { f->SetMaximumEdgeLength(0.06); } },
    { "no alpha", false, [](Triangulation* f) { f->SetAlpha(0.0); } },
    { "polygons", true,
      [](Triangulation* f) { f->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS); } },
    { "triangles", false,
      [](Triangulation* f) { f->SetFacetMode(vtkFFAlgorithm::FACETS_AS_TRIANGLES); } },
    { "polygons again", false,
      [](Triangulation* f) { f->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS); } },
    { "any length", false, [](Triangulation* f) { f->SetMaximumEdgeLength(0.0); } },
  };
  vtkNew<vtkTransform> transform;
  const auto further = changesOfAll<Triangulation>(input, transform);
  changes.insert(changes.end(), further.begin(), further.end());
  testChanges(input, "weights", changes);
}

void testDiagram()
{
  const auto input = makeInput();
  std::vector<Change<Diagram>> changes{
    { "box", false, [](Diagram* f) { f->SetPowerDiagramBounds(-0.5, 0.25, -2, 3); } },
    { "other box", false, [](Diagram* f) { f->StorePowerDiagramCorner(0.1, 0.2, 0); } },
    { "box of points", false,
      [](Diagram* f) { f->SetPowerDiagramBoxMode(vtkFFPowerDiagramFilter::BOX_OF_POINTS); } },
    { "facets", false, [](Diagram* f) { f->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS); } },
  };
  vtkNew<vtkTransform> transform;
  const auto further = changesOfAll<Diagram>(input, transform);
  changes.insert(changes.end(), further.begin(), further.end());
  testChanges(input, "weights", changes);
}

/// Of points, and of the blocks of a composite that have one hull.
void testHull(bool joins)
{
  const auto points = makeInput();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makePoints(gridOf(5, 5)));
  blocks->SetBlock(1, points);
  // A composite does not know that its data changed, so a setting of the output changes as well.
  const auto move = [=](double x, const std::function<void(Hull*)>& set)
  {
    const auto change = once(
      [=]
      {
        points->GetPoints()->SetPoint(8, x, x, x);
        points->GetPoints()->Modified();
      });
    return [=](Hull* f)
    {
      change(f);
      set(f);
    };
  };
  testChanges<Hull>(joins ? static_cast<vtkDataObject*>(blocks) : points.Get(), nullptr,
    {
      { "polygons", false, [](Hull* f) { f->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS); } },
      { "visible ids", false, [](Hull* f) { f->SetVisiblePointIds(true); } },
      { "no point data", false, [](Hull* f) { f->SetPassPointData(false); } },
      { "triangles", false, [](Hull* f) { f->SetFacetMode(vtkFFAlgorithm::FACETS_AS_TRIANGLES); } },
      { "point data", false, [](Hull* f) { f->SetPassPointData(true); } },
      { "policy", true, [](Hull* f) { f->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE); } },
      { "ghosts", true, [](Hull* f) { f->SetSkipGhostPoints(false); } },
      { "variant", true, [](Hull* f) { f->SetVBiased(false); } },
      { "a point", true, move(9.0, [](Hull* f) { f->SetFacetMode(1); }) },
      { "back", true, move(0.0, [](Hull* f) { f->SetFacetMode(0); }) },
      { "no point data, of a new point", true,
        move(8.0, [](Hull* f) { f->SetPassPointData(false); }) },
      { "point data, of which nothing is kept", true, [](Hull* f) { f->SetPassPointData(true); } },
    },
    joins);
}

/// What somebody does to the output of a hull stays there.
void testChangedOutput()
{
  Watched<Hull> run(makeInput());
  const auto expected = copyOf(run.Run());
  run->GetOutput()->GetPoints()->SetPoint(0, 7.0, 7.0, 7.0);
  run->GetOutput()->GetPointData()->GetArray("vtkOriginalPointIds")->SetTuple1(0, -5.0);
  run->GetOutput()->GetPolys()->ReverseCellAtId(0);
  run->SetVisiblePointIds(true);
  run.Run();
  run->SetVisiblePointIds(false);
  FF_CHECK(isIdentical(run.Run(), expected, "after a change of the output"));
}

/// After a failure, an abort, another input and a change upstream.
void testOtherRuns()
{
  const auto input = makeInput();
  Watched<Triangulation> run(input);
  run->SetReportAsFieldData(true);
  const auto expected = copyOf(run.Run());
  run->SetInputData(makePoints({ { notANumber, 0, 0 } }));
  run.Fail("NaN or infinite", vtkFFErrorCode::NonFiniteError);
  FF_CHECK(isIdentical(run.RunWith(input), expected, "after a failure"));

  vtkNew<ProgressObserver> progress;
  progress->AbortAt = 0.0;
  const unsigned long tag = run->AddObserver(vtkCommand::ProgressEvent, progress);
  FF_CHECK(isEmpty(run.RunWith(makeInput())));
  run->RemoveObserver(tag);
  run->SetAbortExecute(0);
  FF_CHECK(isIdentical(run.RunWith(input), expected, "after an abort"));

  vtkNew<vtkSphereSource> sphere;
  run->SetInputConnection(sphere->GetOutputPort());
  const vtkIdType points = run.Run()->GetNumberOfPoints();
  sphere->SetThetaResolution(20);
  FF_CHECK(run.Run()->GetNumberOfPoints() > points);

  // What is set as it was does not even make an output again.
  const vtkMTimeType time = run->GetMTime();
  run->SetTransform(nullptr);
  run->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::XY_PLANE);
  run->SetWeightFactor(1.0);
  run->SetAlpha(0.0);
  FF_CHECK_EQUAL(run->GetMTime(), time);
}

/// Nothing is kept of a composite, nor where memory is to be released.
void testNotKept()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeInput());
  blocks->SetBlock(1, makePoints(randomPoints(3000, 303)));
  Watched<Triangulation> run(blocks);
  run->SetReportAsFieldData(true);
  const auto blockOf = [](Triangulation* filter, unsigned int block)
  {
    auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    return vtkPolyData::SafeDownCast(output->GetBlock(block));
  };
  run.Run();
  const double before = reported(blockOf(run.Get(), 1), "SecondsTotal");
  run->SetAlpha(0.1);
  run.Run();
  FF_CHECK(reported(blockOf(run.Get(), 1), "SecondsTotal") != before);
  Watched<Triangulation> fresh(blocks);
  fresh->SetReportAsFieldData(true);
  fresh->SetAlpha(0.1);
  fresh.Run();
  for (const unsigned int block : { 0U, 1U })
  {
    FF_CHECK(isIdentical(blockOf(run.Get(), block), blockOf(fresh.Get(), block), "block"));
  }

  const auto input = makeInput();
  testChanges<Triangulation>(input, "weights",
    { { "release", true,
        [](Triangulation* f)
        {
          f->ReleaseDataFlagOn();
          f->SetAlpha(0.1);
        } },
      { "alpha", true, [](Triangulation* f) { f->SetAlpha(0.05); } } });
}

}

int TestFFKept(int, char*[])
{
  testTriangulation();
  testDiagram();
  testHull(false);
  testHull(true);
  testChangedOutput();
  testOtherRuns();
  testNotKept();
  return result();
}
