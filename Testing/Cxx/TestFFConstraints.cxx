// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines and polygons of a second input are edges of the triangulation, which port 1 has, and
// polygons define what is inside.
#include "FFPieceSource.h"
#include "FFPlanar.h"

#include "FFInput.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFFTerrainMeshFilter.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

using namespace fftest;

namespace
{

using Filter = vtkFFRegularTriangulationFilter;

struct Run : Watched<Filter>
{
  Run(vtkDataObject* input, vtkPolyData* source)
    : Watched(input)
  {
    this->Filter->SetSourceData(source);
  }
  /// With these constraints: the triangles, from their lowest ids.
  Cells PolysWith(const Cells& lines, const Cells& polygons = {})
  {
    this->Filter->SetSourceData(makeConstraints(lines, polygons));
    return polysOf(this->Watched::Run());
  }
  /// Of port 1, each line with the id of its cell at the end.
  Cells Fixed()
  {
    vtkPolyData* output = this->Filter->GetOutput(3);
    auto* ids = vtkIdTypeArray::SafeDownCast(output->GetCellData()->GetArray("ConstraintCellIds"));
    Cells found = cellsOf(output->GetLines());
    FF_CHECK(ids && ids->GetNumberOfTuples() == output->GetNumberOfCells());
    FF_CHECK_EQUAL(output->GetNumberOfCells(), output->GetNumberOfLines());
    FF_CHECK(output->GetPoints() && output->GetPoints() == this->Filter->GetOutput()->GetPoints());
    FF_CHECK(originalIds(output) == originalIds(this->Filter->GetOutput()));
    for (std::size_t i = 0; ids && i < found.size(); ++i)
    {
      found[i].push_back(ids->GetValue(static_cast<vtkIdType>(i)));
    }
    return found;
  }
};

const std::vector<Point> kite = { { 0, -3, 7 }, { 1, 0, 0 }, { 0, 3, 0 }, { -1, 0, 5 } };
const Cells across = { { 0, 1, 2 }, { 0, 2, 3 } };

void testLines()
{
  Run run(makePoints(kite), nullptr);
  FF_CHECK((polysOf(run.Watched::Run()) == Cells{ { 0, 1, 3 }, { 1, 2, 3 } }));
  FF_CHECK(run.PolysWith({ { 0, 2 } }) == across);
  FF_CHECK((run.Fixed() == Cells{ { 0, 2, 0 } }));
  FF_CHECK(run->GetSource() != nullptr);
  FF_CHECK_EQUAL(std::string(run->GetEngineReason()), "constraints are the CPU's");
  FF_CHECK_EQUAL(run->GetNumberOfDroppedCells(), 0);
  // One edge of no length does not count.
  FF_CHECK(run.PolysWith({ { 2, 2, 0 } }) == across);
  FF_CHECK(run.PolysWith({}) != across);
  FF_CHECK(run.Fixed().empty());
  run->RemoveSource();
  FF_CHECK(run->GetSource() == nullptr);
  FF_CHECK(polysOf(run.Watched::Run()) != across);
  FF_CHECK(isEmpty(run->GetOutput(3)));
}

void testPlanesAndGhosts()
{
  // Upright, by a transform that lays it down.
  std::vector<Point> upright;
  for (const Point& p : kite)
  {
    upright.push_back({ p[0], 4.0, p[1] });
  }
  Run run(makePoints(upright), nullptr);
  vtkNew<vtkTransform> transform;
  transform->RotateX(-90);
  run->SetTransform(transform);
  FF_CHECK(run.PolysWith({ { 0, 2 } }) == across);

  // The first point is a ghost: ids stay those of the input.
  std::vector<Point> more = { { 9, 9, 9 } };
  more.insert(more.end(), kite.begin(), kite.end());
  const auto input = makePoints(more);
  addGhosts(input, { 0 });
  Run skipping(input, nullptr);
  FF_CHECK((skipping.PolysWith({ { 1, 3 } }) == Cells{ { 1, 2, 3 }, { 1, 3, 4 } }));
  FF_CHECK((skipping.Fixed() == Cells{ { 0, 2, 0 } })); // points of the output
  skipping->SetSourceData(makeConstraints({ { 1, 3 }, { 3, 0 } }));
  skipping.Fail("Point 0 of cell 1 of the source is a ghost point, which is left out. Turn off "
                "Skip Ghost Points, or take the cell away.",
    vtkFFErrorCode::InputError);

  // All are.
  const auto ghosts = makePoints(kite);
  addGhosts(ghosts, { 0, 1, 2, 3 });
  Run none(ghosts, makeConstraints({ { 1, 3 } }));
  none.Fail("Point 1 of cell 0 of the source is a ghost point, which is left out. Turn off Skip "
            "Ghost Points, or take the cell away.",
    vtkFFErrorCode::InputError);
}

/// Port 1: parts of a polyline at a point on it, and at a crossing that is split; with the ids of
/// cells of the source, which has a vertex before them.
void testFixedEdges()
{
  const auto source = makeConstraints({ { 0, 1, 2 }, { 3, 4 } }, { { 0, 5, 3 } });
  source->SetVerts(makeCells({ { 0 } }));
  Run run(makePoints({ { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 2, 0, 0 }, { 3, -3, 0 },
            { 2, -4, 0 }, { 0, 3, 0 } }),
    source);
  const Cells expected{ { 0, 3, 1 }, { 0, 5, 3 }, { 1, 2, 1 }, { 1, 3, 1 }, { 3, 4, 2 },
    { 3, 5, 3 } };
  run.Watched::Run();
  FF_CHECK(run.Fixed() == expected);
  // (6, 4) crosses (0, 1), along which is a side of the polygon, and another side, (5, 3).
  source->SetLines(makeCells({ { 0, 1, 2 }, { 6, 4 } }));
  run->SetSplitCrossingConstraints(true);
  run->Modified();
  run->Update();
  FF_CHECK_EQUAL(run->GetNumberOfSplitPoints(), 2);
  std::map<vtkIdType, int> pieces;
  for (const Ids& edge : run.Fixed())
  {
    ++pieces[edge[2]];
  }
  FF_CHECK((pieces == std::map<vtkIdType, int>{ { 1, 4 }, { 2, 3 }, { 3, 3 } }));
}

/// Rings in any direction, which nest: a square with a hole, and a part in the hole.
void testRules()
{
  const Cells rings = { { 0, 5, 35, 30 }, { 7, 25, 28, 10 }, { 14, 15, 21, 20 } };
  Run run(makePoints(gridOf(6, 6)), nullptr);
  Cells expected;
  for (int turned = 0; turned < 8; ++turned)
  {
    Cells given = rings;
    for (std::size_t i = 0; i < given.size(); ++i)
    {
      if (turned & (1 << i))
      {
        std::reverse(given[i].begin(), given[i].end());
      }
    }
    const Cells found = run.PolysWith({}, given);
    expected = turned == 0 ? found : expected;
    FF_CHECK(found == expected);
    FF_CHECK_EQUAL(found.size(), std::size_t(2 * (25 - 9 + 1)));
    FF_CHECK_EQUAL(run->GetNumberOfDroppedCells(), 2 * 8);
    FF_CHECK_EQUAL(run->GetOutput()->GetNumberOfPoints(), 36);
  }
  // As given, they also nest by direction.
  run->SetPolygonRule(vtkFFRegularTriangulationFilter::DIRECTION);
  FF_CHECK(run.PolysWith({}, rings) == expected);
  // A polygon alone, the other way round: the cells outside are what is left.
  const std::size_t inside = run.PolysWith({}, { { 7, 10, 28, 25 } }).size();
  FF_CHECK_EQUAL(run->GetNumberOfDroppedCells(), vtkIdType(50 - inside));
  FF_CHECK_EQUAL(run.PolysWith({}, { { 25, 28, 10, 7 } }).size(), 50 - inside);

  // Where nothing is left, a warning says so.
  Run none(makePoints(kite), makeConstraints({}, { { 0, 3, 2, 1 } }));
  FF_CHECK_EQUAL(none.Watched::Run()->GetNumberOfPolys(), 2);
  none->SetPolygonRule(vtkFFRegularTriangulationFilter::DIRECTION);
  none->Update();
  FF_CHECK_EQUAL(none->GetOutput()->GetNumberOfPolys(), 0);
  FF_CHECK_EQUAL(none->GetOutput()->GetNumberOfPoints(), 4);
  FF_CHECK_EQUAL(none.Errors->Messages.size(), std::size_t(1));
  FF_CHECK(none.Errors->Has("No cell is inside the polygons of the source"));
}

/// A source whose points are to be the input's: at the ids that its cells use, or it is an error.
void testPointsOfTheSource()
{
  const auto input = makePoints(kite);
  const auto with = [](const std::vector<Point>& points) {
    return makeConstraints({ { 0, 2 } }, {}, makePoints(points)->GetPoints());
  };
  const auto fail = [&](const std::vector<Point>& points, const std::string& words, int mode = 0)
  {
    Run run(input, with(points));
    run->SetProjectionPlaneMode(mode);
    run->SetSourcePoints(Filter::INPUT_POINTS);
    run.Fail(words, vtkFFErrorCode::InputError);
  };
  FF_CHECK(polysOf(Run(input, with(kite)).Watched::Run()) == across);
  // What no cell uses may be anything, and be missing; in the XY plane, so may z.
  std::vector<Point> others = kite;
  others[1] = { 9, 9, 9 };
  others[2][2] = 5;
  others.pop_back();
  FF_CHECK(polysOf(Run(input, with(others)).Watched::Run()) == across);
  fail(others,
    "Point 2 of cell 0 of the source is at (0, 3, 5), and point 2 of the input is at (0, 3, 0).",
    Filter::BEST_FITTING_PLANE);
  // A line of its own points, as in a file of breaklines, and off by one unit in the last place.
  fail({ { 0.5, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 } },
    "its 3 points must be those of the input, of which there are 4; or it has no points. If they "
    "are "
    "its own, set Source Points to Own Points.");
  fail({ kite[0], kite[1], { 0, std::nextafter(3.0, 4.0), 0 } },
    "is at (0, 3.0000000000000004, 0), and");
  fail({ kite[0] }, "Point 2 of cell 0 of the source is not there: the source has 1 point(s).");
  // Before the transform.
  vtkNew<vtkTransform> transform;
  transform->RotateZ(30);
  Run turned(input, with(kite));
  turned->SetTransform(transform);
  FF_CHECK(polysOf(turned.Watched::Run()) == across);
  // An array that became another after the points took it, whosever they are.
  for (const int whose : { Filter::AUTOMATIC_POINTS, Filter::INPUT_POINTS, Filter::OWN_POINTS })
  {
    const auto source = with(kite);
    source->GetPoints()->GetData()->SetNumberOfComponents(2);
    Run flat(input, source);
    flat->SetSourcePoints(whose);
    flat.Fail("The points of the source have 2 coordinates each; a point has 3.",
      vtkFFErrorCode::InputError);
  }
}

/// An image's points are those that the output has, to the last bit, also by a source.
template <class FilterT>
void testImages()
{
  vtkNew<vtkImageData> image;
  image->SetExtent(3, 40, -7, 30, 2, 2);
  image->SetOrigin(0.1, 1e5 / 3, 0.7);
  image->SetSpacing(1.0 / 3, 0.1, 1.0 / 7);
  Ids line(38);
  std::iota(line.begin(), line.end(), vtkIdType(38 * 20));
  for (const int whose : { Filter::INPUT_POINTS, Filter::AUTOMATIC_POINTS })
  {
    Watched<FilterT> run(image);
    const auto source = makeConstraints({ line });
    source->SetPoints(FFInput::PointsOf(image, "")->GetPoints());
    run->SetSourcePoints(whose);
    run->SetSourceData(source);
    run.Run();
    FF_CHECK_EQUAL(run->GetNumberOfAddedPoints(), 0);
  }
}

/// Of whatever piece of the input, all of the source is asked for.
template <class FilterT>
void testPieces()
{
  const auto source = makeConstraints({ { 0, 2 } });
  vtkNew<PieceSource> pieces;
  pieces->SetMaker([&](int, int) { return source; });
  Watched<FilterT> run(makePoints(kite));
  run->SetInputConnection(1, pieces->GetOutputPort());
  run->UpdatePiece(1, 2, 0);
  FF_CHECK(run.Errors->Messages.empty());
  FF_CHECK((pieces->Asked == std::vector<std::pair<int, int>>{ { 0, 1 } }));
}

/// The words are in Documentation/Messages.md, and TestMessages.py compares them.
void testErrors()
{
  const auto input = makePoints(kite);
  const auto line = makeConstraints({ { 0, 2 } });
  const auto fail = [](
                      vtkDataObject* points, vtkPolyData* source, const std::string& words,
                      unsigned long code, const std::function<void(Filter*)>& change = [](auto*) {})
  {
    Run run(points, source);
    change(run.Get());
    run.Fail(words, code);
  };
  // Cells are counted as the source has them: vertices, lines, polygons.
  const auto withVertex = makeConstraints({ { 0, 2 } }, { { 0, 1, 9 } });
  withVertex->SetVerts(makeCells({ { 0 } }));
  fail(
    input, withVertex, "Point 9 of cell 2 of the source is not there", vtkFFErrorCode::InputError);
  fail(input, makeConstraints({ { 0, 2 }, { 1, 3 } }),
    "An edge of cell 1 of the source crosses one of cell 0", vtkFFErrorCode::ConstraintError);
  // Where they are split, too.
  fail(makePoints(gridOf(4, 4)),
    makeConstraints({ { 0, 15 }, { 1, 4 } }, { { 0, 3, 15, 12 }, { 5, 6, 10, 9 } }),
    "Reverse cell 3 of the source, which disagrees with cell 2 of the source",
    vtkFFErrorCode::ConstraintError,
    [](Filter* filter)
    {
      filter->SetPolygonRule(vtkFFRegularTriangulationFilter::DIRECTION);
      filter->SetSplitCrossingConstraints(true);
    });
  fail(makeWeighted(kite, { 0, 1, 2, 3 }), line, "Constraints take no weights.",
    vtkFFErrorCode::SettingError, [](Filter* filter) { useWeights(filter); });

  // Ids name the points of one data set: one in a composite will do, several are an error each.
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, input);
  Run run(blocks, line);
  run.Watched::Run();
  auto* outputs = vtkMultiBlockDataSet::SafeDownCast(run->GetOutputDataObject(0));
  FF_CHECK(polysOf(vtkPolyData::SafeDownCast(outputs->GetBlock(0))) == across);
  blocks->SetBlock(1, input);
  run->Update();
  FF_CHECK_EQUAL(run.Errors->Messages.size(), std::size_t(2));
  FF_CHECK(run.Errors->Has("The source's lines are for one data set, and an input is a "
                           "composite. Take one data set, merge them, or take the source away."));
  FF_CHECK_EQUAL(run->GetErrorCode(), vtkFFErrorCode::SettingError);
  run->RemoveSource();
  run.Watched::Run();
}

}

int TestFFConstraints(int, char*[])
{
  testLines();
  testFixedEdges();
  testPlanesAndGhosts();
  testRules();
  testPointsOfTheSource();
  testImages<Filter>();
  testImages<vtkFFTerrainMeshFilter>();
  testPieces<Filter>();
  testPieces<vtkFFTerrainMeshFilter>();
  testErrors();
  return result();
}
