// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// A hull of true facets, which keeps the points' data: FacetPolygons [facets.vtp]
#include <vtkDoubleArray.h>
#include <vtkFFHullFilter.h>
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
  // A grid of 11 x 11 x 11 points, with a temperature at each.
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> temperature;
  temperature->SetName("temperature");
  for (int z = 0; z <= 10; ++z)
  {
    for (int y = 0; y <= 10; ++y)
    {
      for (int x = 0; x <= 10; ++x)
      {
        points->InsertNextPoint(x, y, z);
        temperature->InsertNextValue(20.0 + 0.5 * z);
      }
    }
  }
  vtkNew<vtkPolyData> grid;
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(temperature);

  // The hull is a cube: six polygons, eight points, however many points lie in its sides.
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(grid);
  hull->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS);
  hull->Update();

  vtkPolyData* cube = hull->GetOutput();
  auto* ids = vtkIdTypeArray::SafeDownCast(cube->GetPointData()->GetArray("vtkOriginalPointIds"));
  vtkDataArray* kept = cube->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < cube->GetNumberOfPoints(); ++i)
  {
    std::cout << "input point " << ids->GetValue(i) << ": " << kept->GetTuple1(i) << " degrees\n";
  }
  std::cout << cube->GetNumberOfPolys() << " facets\n";

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(hull->GetOutputPort());
  writer->SetFileName(argc > 1 ? argv[1] : "facets.vtp");
  const bool written = writer->Write() != 0;
  return written && cube->GetNumberOfPoints() == 8 && cube->GetNumberOfPolys() == 6 ? EXIT_SUCCESS
                                                                                    : EXIT_FAILURE;
}
