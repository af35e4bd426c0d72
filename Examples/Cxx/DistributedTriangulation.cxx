// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// One triangulation of points that lie on several processes; each process writes its share:
// mpiexec -n 6 DistributedTriangulation [share-]
#include <vtkMPIController.h>
#include <vtkNew.h>
#include <vtkPFFRegularTriangulationFilter.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(
    controller); // the filter's, unless it is given another
  const int rank = controller->GetLocalProcessId();

  // This process's points, where chance wants them: half of them in a cluster.
  std::mt19937 random(static_cast<unsigned>(rank) + 1);
  const auto uniform = [&] { return std::ldexp(static_cast<double>(random()), -32); };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 150; ++i)
  {
    const double radius = 0.35 * uniform() * uniform();
    const double angle = 6.283185307 * uniform();
    const double x = uniform();
    const double y = uniform();
    i % 2 ? points->InsertNextPoint(1.5 * x, y, 0.0)
          : points->InsertNextPoint(
              0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle), 0.0);
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);

  vtkNew<vtkPFFRegularTriangulationFilter> triangulation;
  triangulation->SetInputData(cloud);
  triangulation->Update(); // on all processes

  // Each triangle is on one process, and all together are the triangulation of all points.
  vtkPolyData* share = triangulation->GetOutput();
  vtkIdType own = share->GetNumberOfCells(), all = 0;
  controller->AllReduce(&own, &all, 1, vtkCommunicator::SUM_OP);
  std::cout << "process " << rank << ": " << own << " of " << all << " triangles\n";

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(share);
  writer->SetFileName(((argc > 1 ? argv[1] : "share-") + std::to_string(rank) + ".vtp").c_str());
  const bool written = writer->Write() != 0;
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return written && own > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
