// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Each surface that vtkFFConvexifyFilter cannot take is refused by name and place.
#include "FFTest.h"

#include "vtkCellArray.h"
#include "vtkFFConvexifyFilter.h"
#include "vtkFFErrorCode.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace fftest;

namespace
{

using Triangles = std::vector<std::vector<vtkIdType>>;

/// The filter fails with one message that has all the parts, and works again.
void refuses(vtkPolyData* input, const std::vector<std::string>& parts,
  const double* kernel = nullptr, unsigned long code = vtkFFErrorCode::SurfaceError)
{
  vtkNew<vtkFFConvexifyFilter> convexify;
  if (kernel)
  {
    convexify->SetKernelPoint(kernel);
  }
  convexify->SetInputData(input);
  FF_CHECK(fails(convexify, code, parts));
  convexify->SetInputData(makeVoxels({ { 0, 0, 0 } }));
  convexify->UseKernelPointOff();
  FF_CHECK(succeeds(convexify));
  FF_CHECK_EQUAL(convexify->GetVolume(), 1.0);
}

/// Of cells that are none of a surface's.
void refusesInput(vtkPolyData* input, const std::vector<std::string>& parts)
{
  refuses(input, parts, nullptr, vtkFFErrorCode::InputError);
}

const std::vector<Point> tetrahedronPoints{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
const Triangles tetrahedron{ { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };

/// Points alone are no surface.
void testNoCells()
{
  refusesInput(makeSurface(tetrahedronPoints, {}),
    { "The surface has no cells, but 4 point(s)", "vtkFFHullFilter" });
}

void testCells()
{
  auto cells = tetrahedron;
  cells[1] = { 0, 1 };
  refusesInput(makeSurface(tetrahedronPoints, cells), { "cell 1", "polygon of 2." });

  vtkNew<vtkCellArray> one;
  const vtkIdType ids[4] = { 0, 1, 2, 3 };

  auto input = makeSurface(tetrahedronPoints, tetrahedron);
  one->InsertNextCell(1, ids);
  input->SetVerts(one);
  refusesInput(input, { "cell 0", "vertex" });

  input = makeSurface(tetrahedronPoints, tetrahedron);
  one->Reset();
  one->InsertNextCell(2, ids);
  input->SetLines(one);
  refusesInput(input, { "cell 0", "line" });

  input = makeSurface(tetrahedronPoints, tetrahedron);
  one->Reset();
  one->InsertNextCell(4, ids);
  input->SetStrips(one);
  refuses(input, { "not a manifold" });
  one->Reset();
  one->InsertNextCell(3, ids);
  one->InsertNextCell(2, ids);
  input->SetStrips(one);
  refusesInput(input, { "cell 5", "strip of 2." });

  // Nothing but these.
  input = makePoints(tetrahedronPoints);
  one->Reset();
  one->InsertNextCell(1, ids);
  input->SetVerts(one);
  refusesInput(
    input, { "The surface has no polygons: its cells are vertices. ", "vtkFFHullFilter" });
  vtkNew<vtkCellArray> two;
  two->InsertNextCell(2, ids);
  input->SetLines(two);
  refusesInput(input, { "its cells are vertices and lines. " });
  input->SetVerts(nullptr);
  refusesInput(input, { "its cells are lines. " });
}

/// Faults of polygons and strips are those of the input's cells, not of triangles.
void testPolygons()
{
  const auto cube = cubeCorners();
  const Triangles quads{ { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  auto cells = quads;
  std::swap(cells[4][1], cells[4][2]);
  refuses(makeSurface(cube, cells), { "crosses or touches itself", "cell 4,", "1 such polygon" });
  cells = quads;
  cells[3][2] = 8;
  refuses(makeSurface(cube, cells), { "cell 3,", "1 such cell", "does not exist" });
  cells[3][2] = cells[3][0];
  refuses(makeSurface(cube, cells), { "cell 3,", "1 such cell", "twice" });
  cells = quads;
  cells.pop_back();
  refuses(makeSurface(cube, cells), { "not closed", "cell 0", "4 such edge" });
  cells = quads;
  std::reverse(cells[5].begin(), cells[5].end());
  refuses(makeSurface(cube, cells), { "not oriented", "cell 0" });
  cells.erase(cells.begin());
  cells.push_back(quads[0]);
  const double outside[3] = { 0.5, 0.5, -1.0 };
  refuses(makeSurface(cube, quads), { "does not see", "cell 0", "2 such triangle" }, outside);
  const double above[3] = { 0.5, 0.5, 2.0 };
  refuses(makeSurface(cube, quads), { "does not see", "cell 1", "2 such triangle" }, above);

  // The last two polygons as strips.
  auto input = makeSurface(cube, { quads[0], quads[1], quads[2], quads[3] });
  vtkNew<vtkCellArray> strips;
  const vtkIdType first[4] = { 0, 4, 2, 6 };
  const vtkIdType last[4] = { 1, 3, 5, 7 };
  strips->InsertNextCell(4, first);
  strips->InsertNextCell(4, last);
  input->SetStrips(strips);
  const double right[3] = { 2.0, 0.5, 0.5 };
  refuses(input, { "does not see", "cell 5", "2 such triangle" }, right);

  auto bad = cube;
  bad[6][0] = std::numeric_limits<double>::infinity();
  refuses(makeSurface(bad, quads), { "point 6,", "1 such point", "NaN or infinite" }, nullptr,
    vtkFFErrorCode::NonFiniteError);
}

/// The tetrahedron's cells in arrays of one's own: corners before and after those that cells take.
template <class ArrayT>
vtkSmartPointer<vtkPolyData> makeCells(int before, int after, int missing = 0)
{
  using Value = typename ArrayT::ValueType;
  vtkNew<ArrayT> offsets;
  vtkNew<ArrayT> corners;
  for (int i = 0; i < before; ++i)
  {
    corners->InsertNextValue(-7);
  }
  for (const auto& triangle : tetrahedron)
  {
    offsets->InsertNextValue(static_cast<Value>(corners->GetNumberOfValues()));
    for (const vtkIdType corner : triangle)
    {
      corners->InsertNextValue(static_cast<Value>(corner));
    }
  }
  offsets->InsertNextValue(static_cast<Value>(corners->GetNumberOfValues()));
  for (int i = 0; i < after; ++i)
  {
    corners->InsertNextValue(-7);
  }
  corners->SetNumberOfValues(corners->GetNumberOfValues() - missing);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets.Get(), corners.Get());
  auto data = makePoints(tetrahedronPoints);
  data->SetPolys(cells);
  return data;
}

/// Of a connectivity, only what the offsets name counts; all of that has to be there.
template <class ArrayT>
void testCellArrays()
{
  vtkNew<vtkFFConvexifyFilter> convexify;
  for (const int before : { 0, 1, 3 })
  {
    for (const int after : { 0, 1, 50000 })
    {
      convexify->SetInputData(makeCells<ArrayT>(before, after));
      FF_CHECK(succeeds(convexify));
      FF_CHECK_EQUAL(convexify->GetVolume(), 1.0 / 6.0);
    }
  }
  refusesInput(makeCells<ArrayT>(0, 0, 1), { "not valid", "corners 0 to 11", "has 11" });
  refusesInput(makeCells<ArrayT>(2, 0, 14), { "not valid", "corners 2 to 13", "has 0" });
  const auto input = makeCells<ArrayT>(0, 0);
  for (vtkIdType i = 0; i < 5; ++i)
  {
    vtkDataArray* offsets = input->GetPolys()->GetOffsetsArray();
    offsets->SetComponent(i, 0, offsets->GetComponent(i, 0) - 3.0);
  }
  refusesInput(input, { "not valid", "corners -3 to 8" });
}

void testBadTriangles()
{
  auto cells = tetrahedron;
  cells[3] = { 1, 2, 4 };
  refuses(makeSurface(tetrahedronPoints, cells), { "cell 3", "1 such cell" });
  cells[3] = { 1, 2, -1 };
  refuses(makeSurface(tetrahedronPoints, cells), { "cell 3", "does not exist" });
  cells[3] = { 1, 2, std::numeric_limits<vtkIdType>::max() };
  refuses(makeSurface(tetrahedronPoints, cells), { "cell 3" });
  cells[3] = { 1, 2, 1 };
  cells[1] = { 3, 3, 3 };
  refuses(makeSurface(tetrahedronPoints, cells), { "cell 1", "2 such cell" });
  refuses(makeSurface({}, tetrahedron), { "cell 0", "4 such cell" });
}

void testNotClosed()
{
  auto cells = tetrahedron;
  cells.erase(cells.begin() + 3);
  refuses(makeSurface(tetrahedronPoints, cells), { "not closed", "cell 0", "3 such edge" });

  // A cube of which one triangle, the last, is missing: its neighbours have the open edges.
  const auto cube = makeVoxels({ { 0, 0, 0 } });
  vtkNew<vtkCellArray> fewer;
  for (vtkIdType i = 0; i < 11; ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cube->GetPolys()->GetCellAtId(i, size, corners);
    fewer->InsertNextCell(size, corners);
  }
  cube->SetPolys(fewer);
  refuses(cube, { "not closed", "3 such edge" });
}

void testNotManifold()
{
  // A fin on the edge of triangles 0 and 1, with both its sides.
  auto points = tetrahedronPoints;
  points.push_back({ 0.5, -1, -1 });
  auto cells = tetrahedron;
  cells.push_back({ 0, 1, 4 });
  cells.push_back({ 1, 0, 4 });
  refuses(makeSurface(points, cells), { "not a manifold", "cell 0" });

  // Two tetrahedra that share a corner, 3: two fans there.
  points = tetrahedronPoints;
  points.push_back({ 0, 0, 2 });
  points.push_back({ 1, 0, 2 });
  points.push_back({ 0, 1, 2 });
  cells = tetrahedron;
  cells.insert(cells.end(), { { 4, 5, 6 }, { 4, 3, 5 }, { 4, 6, 3 }, { 5, 3, 6 } });
  refuses(makeSurface(points, cells), { "not a manifold", "cell 1", "1 such edge" });
}

void testNotOriented()
{
  auto cells = tetrahedron;
  cells[3] = { 2, 1, 3 };
  refuses(makeSurface(tetrahedronPoints, cells), { "not oriented", "cell 0" });

  // Of a cube's triangles, one turned over: it and its neighbours are at odds.
  const auto cube = makeVoxels({ { 0, 0, 0 } });
  cube->ReverseCell(7);
  refuses(cube, { "not oriented", "cell" });
}

void testNotStarShaped()
{
  // A U: no point sees the inside of both its arms' inner walls.
  const auto u = makeVoxels({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { 2, 1, 0 } });
  refuses(u, { "Use Kernel Point" });
  const double inTheBase[3] = { 1.5, 0.5, 0.5 };
  refuses(u, { "not star-shaped", "does not see", "cell" }, inTheBase);

  const auto cube = makeVoxels({ { 0, 0, 0 } });
  const double outside[3] = { 2.0, 0.5, 0.5 };
  refuses(cube, { "not star-shaped", "2 such triangle" }, outside);
  const double onAFacet[3] = { 1.0, 0.5, 0.5 };
  refuses(cube, { "not star-shaped", "2 such triangle" }, onAFacet);
  const double onACorner[3] = { 0.0, 0.0, 0.0 };
  refuses(cube, { "not star-shaped", "cell 0", "6 such triangle" }, onACorner);
  const double justOutside[3] = { 0.5, 0.5, std::nextafter(1.0, 2.0) };
  refuses(cube, { "not star-shaped", "2 such triangle" }, justOutside);

  // Flat: closed and oriented, but without an inside.
  refuses(makeSurface({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } }, tetrahedron),
    { "star-shaped" });
}

void testNumbers()
{
  const auto cube = makeVoxels({ { 0, 0, 0 } });
  const double bad[3] = { 0.5, std::numeric_limits<double>::quiet_NaN(), 0.5 };
  refuses(
    cube, { "kernel point (0.5, nan, 0.5) is not finite" }, bad, vtkFFErrorCode::SettingError);

  auto points = tetrahedronPoints;
  points[2][1] = std::numeric_limits<double>::infinity();
  // Leaving it out is no way here.
  vtkNew<vtkFFConvexifyFilter> convexify;
  convexify->SetInputData(makeSurface(points, tetrahedron));
  for (const int policy : { 0, 1 })
  {
    convexify->SetNonFinitePoints(policy);
    FF_CHECK(fails(convexify, vtkFFErrorCode::NonFiniteError,
      { "is NaN or infinite: first at point 2, 1 such point(s) in all. They are corners of the "
        "surface, which has to be mended.\n" }));
  }
}

}

int TestFFConvexifyFilterErrors(int, char*[])
{
  testNoCells();
  testCells();
  testPolygons();
  testCellArrays<vtkTypeInt32Array>();
  testCellArrays<vtkTypeInt64Array>();
  testBadTriangles();
  testNotClosed();
  testNotManifold();
  testNotOriented();
  testNotStarShaped();
  testNumbers();
  return result();
}
