// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangulation filter gives what the engine gives: of each dimension, with hidden points on
// port 1, in both facet modes, on any number of threads. The power diagram has an answer where it
// has one, and without a source the constrained triangulation is the same. The engine's tests have
// the geometry.
#include "FFPlanar.h"

#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkPoints.h"

using namespace fftest;

namespace
{

struct Row
{
  std::vector<Point> Points;
  std::vector<double> Weights;
  int Dimension;
  Cells Triangles; ///< or lines, or vertices, by ids of the input
  Cells Polygons;
  Ids Hidden;
};

Cells cellsOfAnyKind(vtkPolyData* output)
{
  Cells all;
  for (vtkCellArray* cells : { output->GetVerts(), output->GetLines(), output->GetPolys() })
  {
    const Cells some = cellsByOriginalIds(output, cells);
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

/// The rows of the table in the documentation of vtkFFRegularTriangulationFilter.
void testDimensions()
{
  const std::vector<Point> square{ { 2, 2, 1 }, { 0, 2, 2 }, { 1, 1, 3 }, { 0, 0, 4 },
    { 2, 0, 5 } };
  const Cells star{ { 0, 1, 2 }, { 0, 2, 4 }, { 1, 3, 2 }, { 2, 3, 4 } };
  // Not in a vertical plane. Sorted along the line it is 1 2 4 0 3.
  const std::vector<Point> line{ { 2, 4, 2 }, { -3, -6, -3 }, { 0, 0, 0 }, { 5, 10, 5 },
    { 1, 2, 1 }, { 5, 10, 5 } };
  const Row rows[] = {
    { {}, {}, -1, {}, {}, {} },
    { { { 1, 2, 0 }, { 1, 2, 5 }, { 1, 2, 9 } }, { -3, -1, -3 }, 0, { { 1 } }, { { 1 } },
      { 0, 2 } },
    { line, {}, 1, { { 0, 3 }, { 0, 4 }, { 1, 2 }, { 2, 4 } },
      { { 0, 3 }, { 0, 4 }, { 1, 2 }, { 2, 4 } }, { 5 } },
    { line, { 0, 0, 0, 0, 1000, 0.5 }, 1, { { 1, 4 }, { 4, 5 } }, { { 1, 4 }, { 4, 5 } },
      { 0, 2, 3 } },
    { square, {}, 2, star, star, {} },
    // The centre's power distance from the square's circle is -2 - w: at w = -2 it is a tie.
    { square, { 0, 0, -1.9999999, 0, 0 }, 2, star, star, {} },
    { square, { 0, 0, -2, 0, 0 }, 2, { { 0, 1, 3 }, { 0, 3, 4 } }, { { 0, 1, 3, 4 } }, { 2 } },
  };
  for (const Row& row : rows)
  {
    const char* const weights = row.Weights.empty() ? nullptr : "weights";
    const auto input = weights ? makeWeighted(row.Points, row.Weights) : makePoints(row.Points);
    Watched<vtkFFRegularTriangulationFilter> run(input, weights);
    for (const bool polygons : { false, true })
    {
      run->SetFacetMode(polygons);
      vtkPolyData* const output = run.Run();
      FF_CHECK(cellsOfAnyKind(output) == (polygons ? row.Polygons : row.Triangles));
      FF_CHECK(originalIds(run->GetOutput(1)) == row.Hidden);
      FF_CHECK_EQUAL(run->GetNumberOfHiddenPoints(), vtkIdType(row.Hidden.size()));
      FF_CHECK_EQUAL(run->GetDimension(), row.Dimension);
      FF_CHECK(row.Dimension < 0 || isTriangulationOf(input, weights, run.Get(), row.Dimension));
    }
    Watched<vtkFFPowerDiagramFilter> diagram(input, weights);
    FF_CHECK((diagram.Run()->GetNumberOfPolys() > 0) == (row.Dimension >= 0));
    FF_CHECK_EQUAL(diagram->GetDimension(), row.Dimension);
    FF_CHECK_EQUAL(diagram->GetNumberOfHiddenPoints(), vtkIdType(row.Hidden.size()));
  }
  Watched<vtkFFRegularTriangulationFilter> none(
    vtkSmartPointer<vtkPolyData>::New()); // not even a vtkPoints
  FF_CHECK(isEmpty(none.Run()) && isEmpty(none->GetOutput(1)) && isEmpty(none->GetOutput(2)));
  FF_CHECK_EQUAL(none.RunWith(makePoints({}, VTK_INT))->GetPoints()->GetDataType(), VTK_INT);
}

/// One output, whatever the threads and the variant.
void testThreads()
{
  const auto input = randomWeighted(30000, 5);
  Watched<vtkFFRegularTriangulationFilter> run(input, "weights");
  run->SetNumberOfThreads(1);
  const auto expected = copyOf(run.Run());
  const auto hidden = originalIds(run->GetOutput(1));
  FF_CHECK(!hidden.empty() && isTriangulationOf(input, "weights", run.Get()));
  for (const int threads : { 2, -1 })
  {
    run->SetNumberOfThreads(threads);
    run->SetVBiased(threads < 0);
    FF_CHECK(isSame(run.Run(), expected));
    FF_CHECK(originalIds(run->GetOutput(1)) == hidden);
  }
  Watched<vtkFFRegularTriangulationFilter> delaunay(input);
  Watched<vtkFFRegularTriangulationFilter> constrained(input);
  FF_CHECK(isIdentical(constrained.Run(), delaunay.Run(), "no source"));
  FF_CHECK(isEmpty(constrained->GetOutput(1)));
}

}

int TestFFRegularTriangulationFilter(int, char*[])
{
  testDimensions();
  testThreads();
  return result();
}
