// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What a filter reports of a run, and whether anything of it is left.
#include "FFTest.h"

#include "vtkFFHullAlgorithm.h"
#include "vtkFFQueryAlgorithm.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFFTerrainMeshFilter.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"

#include <cmath>
#include <iostream>
#include <sstream>

namespace fftest
{

//------------------------------------------------------------------------------
double reported(vtkDataObject* output, const std::string& name)
{
  vtkDataArray* array = output->GetFieldData()->GetArray(("FlipFlop" + name).c_str());
  return array && array->GetNumberOfValues() == 1 ? array->GetTuple1(0) : std::nan("");
}

//------------------------------------------------------------------------------
bool isEmpty(vtkDataObject* output)
{
  return output && output->GetNumberOfElements(vtkDataObject::POINT) == 0 &&
    output->GetNumberOfElements(vtkDataObject::CELL) == 0;
}

//------------------------------------------------------------------------------
std::string printedReport(vtkAlgorithm* algorithm)
{
  std::ostringstream report;
  report.precision(17);
  if (auto* const query = vtkFFQueryAlgorithm::SafeDownCast(algorithm))
  {
    report << "Dimension: " << query->GetDimension() << "\n";
  }
  if (auto* const filter = vtkFFAlgorithm::SafeDownCast(algorithm))
  {
    report << "EngineUsed: " << filter->GetEngineUsedAsString()
           << "\nEngineReason: " << filter->GetEngineReason()
           << "\nDimension: " << filter->GetDimension()
           << "\nNumberOfInputPoints: " << filter->GetNumberOfInputPoints()
           << "\nNumberOfNonFinitePoints: " << filter->GetNumberOfNonFinitePoints() << "\n";
  }
  if (auto* const hull = vtkFFHullAlgorithm::SafeDownCast(algorithm))
  {
    report << "Volume: " << hull->GetVolume() << "\nArea: " << hull->GetArea() << "\n";
  }
  if (auto* const planar = vtkFFPlanarAlgorithm::SafeDownCast(algorithm))
  {
    report << "NumberOfHiddenPoints: " << planar->GetNumberOfHiddenPoints()
           << "\nNumberOfDroppedCells: " << planar->GetNumberOfDroppedCells() << "\n";
  }
  if (auto* const triangulation = vtkFFRegularTriangulationFilter::SafeDownCast(algorithm))
  {
    report << "NumberOfSplitPoints: " << triangulation->GetNumberOfSplitPoints()
           << "\nNumberOfAddedPoints: " << triangulation->GetNumberOfAddedPoints()
           << "\nNumberOfHeightDifferences: " << triangulation->GetNumberOfHeightDifferences()
           << "\n";
  }
  if (auto* const terrain = vtkFFTerrainMeshFilter::SafeDownCast(algorithm))
  {
    report << "GreatestError: " << terrain->GetGreatestError()
           << "\nNumberOfPointsBeyond: " << terrain->GetNumberOfPointsBeyond()
           << "\nNumberOfUnreachablePoints: " << terrain->GetNumberOfUnreachablePoints()
           << "\nNumberOfSplitPoints: " << terrain->GetNumberOfSplitPoints()
           << "\nNumberOfAddedPoints: " << terrain->GetNumberOfAddedPoints()
           << "\nNumberOfHeightDifferences: " << terrain->GetNumberOfHeightDifferences() << "\n";
  }
  return report.str();
}

//------------------------------------------------------------------------------
bool hasForgotten(vtkFFAlgorithm* filter)
{
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    if (!isEmpty(output))
    {
      std::cerr << "output " << port << " is missing or not empty\n";
      return false;
    }
  }
  vtkSmartPointer<vtkFFAlgorithm> fresh;
  fresh.TakeReference(filter->NewInstance());
  // But for the count of points that are not finite.
  const auto ofResult = [](const std::string& report)
  {
    std::istringstream lines(report);
    std::string text;
    for (std::string line; std::getline(lines, line);)
    {
      text += line.find("NumberOfNonFinite") == 0 ? std::string() : line + "\n";
    }
    return text;
  };
  const std::string found = ofResult(printedReport(filter));
  const std::string expected = ofResult(printedReport(fresh));
  if (found != expected || found.find("NumberOfInputPoints: 0") == std::string::npos)
  {
    std::cerr << "the report is of a run:\n" << found;
    return false;
  }
  return true;
}

}
