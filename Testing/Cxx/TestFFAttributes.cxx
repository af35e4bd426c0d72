// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Which of the input's active attributes stay active. Those that speak of the input's own surface,
// its normals first, would shade and draw another surface falsely: their arrays go along, no more.
#include "FFTest.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFFConvexifyFilter.h"
#include "vtkFFHullFilter.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <string>

using namespace fftest;

namespace
{

template <class ArrayT>
void addAttribute(vtkPointData* data, int attribute, int components, vtkIdType count)
{
  vtkNew<ArrayT> array;
  array->SetName(vtkDataSetAttributes::GetAttributeTypeAsString(attribute));
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  array->Fill(1.0);
  FF_CHECK(data->SetActiveAttribute(data->AddArray(array), attribute) >= 0);
}

/// Gives the points every attribute that VTK 9.1 knows, in an array of the attribute's name.
void addAttributes(vtkPolyData* surface)
{
  vtkPointData* data = surface->GetPointData();
  const vtkIdType count = surface->GetNumberOfPoints();
  addAttribute<vtkDoubleArray>(data, vtkDataSetAttributes::SCALARS, 1, count);
  addAttribute<vtkDoubleArray>(data, vtkDataSetAttributes::VECTORS, 3, count);
  addAttribute<vtkDoubleArray>(data, vtkDataSetAttributes::NORMALS, 3, count);
  addAttribute<vtkDoubleArray>(data, vtkDataSetAttributes::TCOORDS, 2, count);
  addAttribute<vtkDoubleArray>(data, vtkDataSetAttributes::TENSORS, 9, count);
  addAttribute<vtkIdTypeArray>(data, vtkDataSetAttributes::GLOBALIDS, 1, count);
  addAttribute<vtkIdTypeArray>(data, vtkDataSetAttributes::PEDIGREEIDS, 1, count);
  addAttribute<vtkUnsignedCharArray>(data, vtkDataSetAttributes::EDGEFLAG, 1, count);
  addAttribute<vtkDoubleArray>(data, vtkDataSetAttributes::TANGENTS, 3, count);
  addAttribute<vtkDoubleArray>(data, vtkDataSetAttributes::RATIONALWEIGHTS, 1, count);
  addAttribute<vtkDoubleArray>(data, vtkDataSetAttributes::HIGHERORDERDEGREES, 3, count);
}

void checkAttributes(vtkDataSetAttributes* data, const std::string& where)
{
  FF_CHECK_EQUAL(where + ": " + std::to_string(data->GetNumberOfArrays()), where + ": 12");
  for (int attribute = 0; attribute <= vtkDataSetAttributes::HIGHERORDERDEGREES; ++attribute)
  {
    const char* name = vtkDataSetAttributes::GetAttributeTypeAsString(attribute);
    const bool ofSurface = attribute == vtkDataSetAttributes::NORMALS ||
      attribute == vtkDataSetAttributes::EDGEFLAG || attribute == vtkDataSetAttributes::TANGENTS ||
      attribute == vtkDataSetAttributes::RATIONALWEIGHTS ||
      attribute == vtkDataSetAttributes::HIGHERORDERDEGREES;
    vtkAbstractArray* array = data->GetAbstractArray(name);
    vtkAbstractArray* active = data->GetAbstractAttribute(attribute);
    const std::string what = where + ", " + name + ": ";
    FF_CHECK_EQUAL(what + (array ? "kept" : "lost"), what + "kept");
    FF_CHECK_EQUAL(what + (active ? "active" : "idle"), what + (ofSurface ? "idle" : "active"));
    FF_CHECK(!active || active == array);
  }
}

/// A closed surface with all attributes.
vtkSmartPointer<vtkPolyData> makeInput()
{
  auto surface = makeVoxels({ { 0, 0, 0 }, { 1, 0, 0 } });
  addAttributes(surface);
  return surface;
}

/// On every port, with points, or with the cells of a power diagram.
void testFilter(vtkFFAlgorithm* filter, vtkDataObject* input)
{
  filter->SetInputDataObject(input);
  FF_CHECK(succeeds(filter));
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkPolyData* const output = filter->GetOutput(port);
    FF_CHECK(output && output->GetNumberOfCells() > 0);
    const std::string where =
      std::string(filter->GetClassName()) + ", port " + std::to_string(port);
    if (filter->IsA("vtkFFPowerDiagramFilter"))
    {
      checkAttributes(output->GetCellData(), where);
    }
    else
    {
      checkAttributes(output->GetPointData(), where);
    }
  }
}

}

int TestFFAttributes(int, char*[])
{
  const auto input = makeInput();
  testFilter(vtkNew<vtkFFHullFilter>(), input);
  testFilter(vtkNew<vtkFFConvexifyFilter>(), input);
  testFilter(vtkNew<vtkFFPowerDiagramFilter>(), input);
  vtkNew<vtkFFRegularTriangulationFilter> triangulation;
  triangulation->GenerateBoundaryOn();
  testFilter(triangulation, input);

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, input);
  blocks->SetBlock(1, input);
  vtkNew<vtkFFHullFilter> all;
  all->SetCompositeModeToAllBlocks();
  all->SetInputData(blocks);
  FF_CHECK(succeeds(all));
  all->GetOutput()->GetPointData()->RemoveArray("BlockIndex");
  checkAttributes(all->GetOutput()->GetPointData(), "all blocks");
  return result();
}
