// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// A filter of a user's own, with the settings of the installed ones: it removes what is inside the
// hull.
#include "vtkFFAlgorithm.h"
#include "vtkFFErrorCode.h"
#include "vtkFFHullFilter.h"

#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstdlib>
#include <iostream>

class ExtremePoints : public vtkFFAlgorithm
{
public:
  static ExtremePoints* New();
  vtkTypeMacro(ExtremePoints, vtkFFAlgorithm);

protected:
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    vtkNew<vtkFFHullFilter> hull;
    hull->SetNonFinitePoints(this->NonFinitePoints);
    hull->SetNumberOfThreads(this->NumberOfThreads);
    hull->SetInputData(vtkDataSet::GetData(inputs[0]));
    hull->Update();
    this->SetErrorCode(hull->GetErrorCode());
    vtkPolyData::GetData(outputs)->SetPoints(hull->GetOutput()->GetPoints());
    return 1;
  }
};
vtkStandardNewMacro(ExtremePoints);

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
  vtkNew<ExtremePoints> filter;
  filter->SetInputData(input);
  filter->Update();
  filter->Print(std::cout);
  const bool right = filter->GetOutput()->GetNumberOfPoints() == 4 &&
    filter->GetErrorCode() == vtkFFErrorCode::NoError;
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
