// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The power diagram of a few shops, where a weight makes a shop's district grow:
// PowerDiagram [districts.vtp]
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFFPowerDiagramFilter.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  const double shops[6][3] = { // x, y, weight
    { 1.0, 1.0, 0.0 }, { 4.0, 1.0, 2.0 }, { 7.0, 2.0, 0.0 }, { 2.0, 4.0, 0.0 }, { 5.0, 4.0, 1.0 },
    { 4.5, 1.2, -9.0 }
  };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("weight");
  for (const auto& shop : shops)
  {
    points->InsertNextPoint(shop[0], shop[1], 0.0);
    weights->InsertNextValue(shop[2]);
  }
  vtkNew<vtkPolyData> map;
  map->SetPoints(points);
  map->GetPointData()->AddArray(weights);

  vtkNew<vtkFFPowerDiagramFilter> diagram;
  diagram->SetInputData(map);
  diagram->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "weight"); // without: Voronoi
  diagram->SetPowerDiagramBounds(0.0, 8.0, 0.0, 5.0); // the town; or the points' own bounds
  diagram->SetPowerDiagramBoxMode(vtkFFPowerDiagramFilter::BOX_OF_BOUNDS);
  diagram->Update();

  // Each district carries its shop's data, and says which one it is.
  vtkPolyData* districts = diagram->GetOutput();
  vtkCellData* data = districts->GetCellData();
  auto* ids = vtkIdTypeArray::SafeDownCast(data->GetArray("vtkOriginalPointIds"));
  for (vtkIdType i = 0; i < districts->GetNumberOfCells(); ++i)
  {
    std::cout << "shop " << ids->GetValue(i) << ", weight "
              << data->GetArray("weight")->GetTuple1(i) << ": a polygon of "
              << districts->GetCell(i)->GetNumberOfPoints() << " corners\n";
  }
  std::cout << diagram->GetNumberOfHiddenPoints() << " shop without a district\n";

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(diagram->GetOutputPort());
  writer->SetFileName(argc > 1 ? argv[1] : "districts.vtp");
  const bool written = writer->Write() != 0;
  return written && districts->GetNumberOfCells() == 5 ? EXIT_SUCCESS : EXIT_FAILURE;
}
