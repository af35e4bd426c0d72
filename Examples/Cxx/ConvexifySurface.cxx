// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// A dented sphere to its convex hull, by flips: ConvexifySurface [convex.vtp]
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkFFConvexifyFilter.h>
#include <vtkFieldData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{

/// A figure of the filter's report.
double figure(vtkFFConvexifyFilter* filter, const char* name)
{
  return filter->GetOutput()->GetFieldData()->GetArray(name)->GetTuple1(0);
}

}

int main(int argc, char* argv[])
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(100);
  sphere->SetPhiResolution(100);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();

  // Waves in the radius: the surface stays star-shaped from the centre.
  vtkNew<vtkPolyData> dented;
  dented->DeepCopy(sphere->GetOutput());
  vtkPoints* points = dented->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    vtkMath::MultiplyScalar(p, 1.0 + 0.2 * std::sin(9.0 * p[0]) * std::cos(7.0 * p[2]));
    points->SetPoint(i, p);
  }

  vtkNew<vtkFFConvexifyFilter> convexify;
  convexify->SetInputData(dented);
  convexify->SetKernelPoint(0.0, 0.0, 0.0);
  convexify->UseKernelPointOn(); // without it, a kernel point is sought
  convexify->SetReportAsFieldData(true);
  convexify->Update();
  if (convexify->GetErrorCode() != vtkErrorCode::NoError)
  {
    return EXIT_FAILURE; // the filter has said what is wrong, and where
  }

  std::cout << "vertices:  " << dented->GetNumberOfPoints() << " -> "
            << convexify->GetOutput()->GetNumberOfPoints() << "\n"
            << "flips:     " << figure(convexify, "FlipFlopFlips22") << " 2-2, "
            << figure(convexify, "FlipFlopFlips31") << " 3-1\n"
            << "volume:    " << convexify->GetVolume() << "\n";

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(convexify->GetOutputPort());
  writer->SetFileName(argc > 1 ? argv[1] : "convex.vtp");
  const bool written = writer->Write() != 0;
  return written && convexify->GetVolume() > 0.0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
