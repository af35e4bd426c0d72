// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// A surface that vtkFFConvexifyFilter cannot take is refused by the place in its own cells.
// Documentation/Messages.md has the words of each error, and TestMessages.py compares them.
#include "FFTest.h"

#include "vtkCellArray.h"
#include "vtkFFConvexifyFilter.h"
#include "vtkFFErrorCode.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <cmath>
#include <limits>

using namespace fftest;

namespace
{

using Cells = std::vector<std::vector<vtkIdType>>;
using Parts = std::vector<std::string>;

/// The filter fails with one message that has all the parts, and works again.
void refuses(vtkPolyData* input, const Parts& parts, const double* kernel = nullptr,
  unsigned long code = vtkFFErrorCode::SurfaceError)
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
void refusesInput(vtkPolyData* input, const Parts& parts)
{
  refuses(input, parts, nullptr, vtkFFErrorCode::InputError);
}

const std::vector<Point> corners{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
const Cells tetrahedron{ { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
const Cells quads{ { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 },
  { 1, 3, 7, 5 } };

/// The cells with one of them replaced; without it, if there is no other.
Cells with(Cells cells, std::size_t which, const std::vector<vtkIdType>& other)
{
  if (other.empty())
  {
    cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(which));
  }
  else
  {
    cells[which] = other;
  }
  return cells;
}

vtkSmartPointer<vtkCellArray> makeCellArray(const Cells& cells)
{
  return makeSurface({}, cells)->GetPolys();
}

/// Cells that are none of a surface's.
void testCells()
{
  refusesInput(makeSurface(corners, with(tetrahedron, 1, { 0, 1 })), { "cell 1", "polygon of 2." });
  auto input = makeSurface(corners, tetrahedron);
  input->SetStrips(makeCellArray({ { 0, 1, 2 }, { 0, 1 } }));
  refusesInput(input, { "cell 5", "strip of 2." });
  input = makePoints(corners);
  input->SetVerts(makeCellArray({ { 0 } }));
  input->SetLines(makeCellArray({ { 0, 1 } }));
  refusesInput(input, { "its cells are vertices and lines. " });
}

/// Faults of polygons and strips are those of the input's cells, not of triangles.
void testPolygons()
{
  const auto cube = cubeCorners();
  const double below[3] = { 0.5, 0.5, -1.0 };
  const double right[3] = { 2.0, 0.5, 0.5 };
  const auto surface = [&](std::size_t which, const std::vector<vtkIdType>& other)
  { return makeSurface(cube, with(quads, which, other)); };
  refuses(surface(4, { 0, 6, 4, 2 }), { "crosses or touches itself", "cell 4,", "1 such polygon" });
  refuses(surface(3, { 2, 6, 8, 3 }), { "cell 3,", "1 such cell", "does not exist" });
  refuses(surface(3, { 2, 6, 2, 3 }), { "cell 3,", "1 such cell", "twice" });
  refuses(surface(5, {}), { "not closed", "cell 0", "4 such edge" });
  refuses(surface(5, { 5, 7, 3, 1 }), { "not oriented", "cell 0" });
  refuses(makeSurface(cube, quads), { "does not see", "cell 0", "2 such triangle" }, below);
  const auto input = makeSurface(cube, Cells(quads.begin(), quads.begin() + 4));
  input->SetStrips(makeCellArray({ { 0, 4, 2, 6 }, { 1, 3, 5, 7 } }));
  refuses(input, { "does not see", "cell 5", "2 such triangle" }, right);
}

/// The tetrahedron's cells in arrays of one's own: corners before and after those that cells take.
template <class ArrayT>
vtkSmartPointer<vtkPolyData> makeCells(int before, int after, int missing = 0)
{
  using Value = typename ArrayT::ValueType;
  vtkNew<ArrayT> offsets;
  vtkNew<ArrayT> connectivity;
  const auto fill = [&](int count)
  {
    for (int i = 0; i < count; ++i)
    {
      connectivity->InsertNextValue(-7);
    }
  };
  const auto addOffset = [&]
  { offsets->InsertNextValue(static_cast<Value>(connectivity->GetNumberOfValues())); };
  fill(before);
  for (const auto& triangle : tetrahedron)
  {
    addOffset();
    for (const vtkIdType corner : triangle)
    {
      connectivity->InsertNextValue(static_cast<Value>(corner));
    }
  }
  addOffset();
  fill(after);
  connectivity->SetNumberOfValues(connectivity->GetNumberOfValues() - missing);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets.Get(), connectivity.Get());
  auto data = makePoints(corners);
  data->SetPolys(cells);
  return data;
}

/// Of a connectivity, only what the offsets name counts; all of that has to be there.
template <class ArrayT>
void testCellArrays()
{
  vtkNew<vtkFFConvexifyFilter> convexify;
  for (const int before : { 0, 3 })
  {
    for (const int after : { 0, 50000 })
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

void testNumbers()
{
  const double bad[3] = { 0.5, NAN, 0.5 };
  refuses(makeVoxels({ { 0, 0, 0 } }), { "kernel point (0.5, nan, 0.5) is not finite" }, bad,
    vtkFFErrorCode::SettingError);
  refuses(
    makeSurface(corners, with(tetrahedron, 3, { 1, 2, std::numeric_limits<vtkIdType>::max() })),
    { "cell 3", "does not exist", "1 such cell" });

  // Leaving points out is no way here.
  auto points = cubeCorners();
  points[2][1] = HUGE_VAL;
  vtkNew<vtkFFConvexifyFilter> convexify;
  for (const Cells& cells : { quads, tetrahedron })
  {
    convexify->SetInputData(makeSurface(points, cells));
    for (const int policy : { 0, 1 })
    {
      convexify->SetNonFinitePoints(policy);
      FF_CHECK(fails(convexify, vtkFFErrorCode::NonFiniteError,
        { "is NaN or infinite: first at point 2, 1 such point(s) in all. They are corners of the "
          "surface, which has to be mended.\n" }));
    }
  }
}

}

int TestFFConvexifyFilterErrors(int, char*[])
{
  testCells();
  testPolygons();
  testCellArrays<vtkTypeInt32Array>();
  testCellArrays<vtkTypeInt64Array>();
  testNumbers();
  return result();
}
