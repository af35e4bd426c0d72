// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells with an edge longer than a limit are left out, and nothing else: points and hidden points
// stay. The engine's tests have the lengths.
#include "FFPlanar.h"

#include "vtkFFRegularTriangulationFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTransform.h"

#include <cmath>

using namespace fftest;

namespace
{

/// With the filter as it is set, so many of the triangles or squares of a lattice stay.
template <class FilterT>
void expectWithin(Watched<FilterT>& run, double limit, vtkIdType expected)
{
  run->SetMaximumEdgeLength(0.0);
  const auto all = copyOf(run.Run());
  const auto other = copyOf(run->GetOutput(1));
  FF_CHECK_EQUAL(run->GetNumberOfDroppedCells(), 0);
  run->SetMaximumEdgeLength(limit);
  const auto found = copyOf(run.Run());
  FF_CHECK_EQUAL(found->GetNumberOfCells(), expected);
  FF_CHECK_EQUAL(run->GetNumberOfDroppedCells(), all->GetNumberOfCells() - expected);
  FF_CHECK_EQUAL(run->GetDimension(), 2);
  found->SetPolys(all->GetPolys());
  FF_CHECK(isSame(found, all));
  FF_CHECK(isEmpty(other) ? isEmpty(run->GetOutput(1))
                          : isIdentical(run->GetOutput(1), other, "the other port"));
}

template <class FilterT>
void testLimits()
{
  auto points = gridOf(4, 3, 7.0); // 3 by 2 squares, at heights that do not matter
  points.push_back({ 9, 1, 0 });   // with longer edges, to the two or three on the right
  points.push_back(points[0]);     // hidden
  Watched<FilterT> run(makePoints(points));
  const double diagonal = std::sqrt(2.0); // rounded up
  expectWithin(run, 1.0, 0);
  expectWithin(run, diagonal, 12);
  expectWithin(run, std::nextafter(diagonal, 0.0), 0);
  expectWithin(run, infinity, 14);
  run->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS);
  expectWithin(run, 1.0, 6);
  expectWithin(run, std::nextafter(1.0, 0.0), 0);
  // In the plane of the triangulation: after the transform.
  vtkNew<vtkTransform> transform;
  transform->Scale(2.0, 0.5, 1.0);
  run->SetTransform(transform);
  expectWithin(run, 2.0, 6);
  expectWithin(run, 1.9, 0);

  // Lines are cells, too; a vertex has no edge.
  run->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::XY_PLANE);
  run->SetMaximumEdgeLength(2.0);
  vtkPolyData* output =
    run.RunWith(makePoints({ { 0, 0, 5 }, { 1, 0, 5 }, { 4, 0, 5 }, { 6, 0, 5 } }));
  FF_CHECK((cellsByOriginalIds(output, output->GetLines()) == Cells{ { 0, 1 }, { 2, 3 } }));
  FF_CHECK_EQUAL(run->GetNumberOfDroppedCells(), 1);
  FF_CHECK_EQUAL(run.RunWith(makePoints({ { 0, 0, 5 } }))->GetNumberOfVerts(), 1);
  FF_CHECK(isEmpty(run.RunWith(makePoints(std::vector<Point>{}))));

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makePoints({ { 0, 0, 5 }, { 1, 0, 5 }, { 4, 0, 5 } }));
  blocks->SetBlock(1, makePoints({ { 0, 0, 5 }, { 3, 0, 5 }, { 6, 0, 5 } }));
  Watched<FilterT> both(blocks);
  both->SetMaximumEdgeLength(2.0);
  both.Run();
  FF_CHECK_EQUAL(both->GetNumberOfDroppedCells(), 3);
}

}

int TestFFMaximumEdgeLength(int, char*[])
{
  testLimits<vtkFFRegularTriangulationFilter>();
  testLimits<vtkFFRegularTriangulationFilter>();
  return result();
}
