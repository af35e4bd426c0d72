// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The regular triangulation of disks, and which of them it hides: RegularTriangulation [disks.vtp]
#include <vtkDoubleArray.h>
#include <vtkFFRegularTriangulationFilter.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdlib>
#include <iostream>
#include <random>

int main(int argc, char* argv[])
{
  // Disks of many sizes; a weight is a squared length, here that of the radius.
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> coordinate(0.0, 1.0);
  std::exponential_distribution<double> size(500.0);
  vtkNew<vtkPoints> centres;
  centres->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("squared radius");
  for (int i = 0; i < 100000; ++i)
  {
    const double radius = size(generator);
    centres->InsertNextPoint(coordinate(generator), coordinate(generator), 0.0);
    weights->InsertNextValue(radius * radius);
  }
  vtkNew<vtkPolyData> disks;
  disks->SetPoints(centres);
  disks->GetPointData()->AddArray(weights);

  vtkNew<vtkFFRegularTriangulationFilter> triangulation;
  triangulation->SetInputData(disks);
  triangulation->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "squared radius"); // without: Delaunay
  triangulation->Update();

  vtkPolyData* shown = triangulation->GetOutput();
  vtkPolyData* hidden = triangulation->GetOutput(1);
  std::cout << "disks:     " << disks->GetNumberOfPoints() << "\n"
            << "shown:     " << shown->GetNumberOfPoints() << "\n"
            << "hidden:    " << hidden->GetNumberOfPoints() << "\n"
            << "triangles: " << shown->GetNumberOfPolys() << "\n";

  // Each point says which disk it is.
  auto* ids = vtkIdTypeArray::SafeDownCast(hidden->GetPointData()->GetArray("vtkOriginalPointIds"));
  if (ids->GetNumberOfValues() > 0)
  {
    std::cout << "the first hidden disk is number " << ids->GetValue(0) << "\n";
  }

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(triangulation->GetOutputPort());
  writer->SetFileName(argc > 1 ? argv[1] : "disks.vtp");
  const bool written = writer->Write() != 0;
  return written && shown->GetNumberOfPolys() > 0 && hidden->GetNumberOfPoints() > 0 ? EXIT_SUCCESS
                                                                                     : EXIT_FAILURE;
}
