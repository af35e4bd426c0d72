// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The convex hull of a million points, written to a file: HullOfPoints [hull.vtp]
#include <vtkFFHullFilter.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdlib>
#include <iostream>
#include <random>

int main(int argc, char* argv[])
{
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 1000000; ++i)
  {
    points->InsertNextPoint(normal(generator), normal(generator), normal(generator));
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);

  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(cloud);
  hull->Update();

  std::cout << "points:    " << cloud->GetNumberOfPoints() << "\n"
            << "vertices:  " << hull->GetOutput()->GetNumberOfPoints() << "\n"
            << "triangles: " << hull->GetOutput()->GetNumberOfPolys() << "\n"
            << "volume:    " << hull->GetVolume() << "\n"
            << "engine:    " << hull->GetEngineUsedAsString() << ", since "
            << hull->GetEngineReason() << "\n";

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(hull->GetOutputPort());
  writer->SetFileName(argc > 1 ? argv[1] : "hull.vtp");
  const bool written = writer->Write() != 0;
  return written && hull->GetVolume() > 0.0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
