// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The installed filters for distributed data: here, of a single process.
#include "vtkPFFHullFilter.h"

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstdlib>

int main()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0, 1, 0);
  points->InsertNextPoint(0, 0, 1);
  points->InsertNextPoint(0.25, 0.25, 0.25);
  vtkNew<vtkPolyData> input;
  input->SetPoints(points);
  vtkNew<vtkPFFHullFilter> hull;
  hull->SetInputData(input);
  hull->Update();
  vtkPolyData* output = hull->GetOutput();
  const bool right = output->GetNumberOfPoints() == 4 && output->GetNumberOfPolys() == 4;
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
