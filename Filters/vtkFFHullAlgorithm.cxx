// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFHullAlgorithm.h"

#include "vtkFFOutput.h"
#include <flipflop/Hull.h>

#include "vtkPolyData.h"

//------------------------------------------------------------------------------
vtkFFHullAlgorithm::vtkFFHullAlgorithm()
  : Volume(0.0)
  , Area(0.0)
{
}

//------------------------------------------------------------------------------
vtkFFHullAlgorithm::~vtkFFHullAlgorithm() = default;

//------------------------------------------------------------------------------
void vtkFFHullAlgorithm::ResetReport()
{
  this->Superclass::ResetReport();
  this->Volume = 0.0;
  this->Area = 0.0;
}

//------------------------------------------------------------------------------
void vtkFFHullAlgorithm::AddToReport(
  const flipflop::Hull& hull, const flipflop::EngineReport& engine, vtkPolyData* output)
{
  this->Superclass::AddToReport(hull, engine, output);
  this->Volume += hull.volume;
  this->Area += hull.area;
  if (this->ReportAsFieldData)
  {
    vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopVolume", hull.volume);
    vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopArea", hull.area);
  }
}

//------------------------------------------------------------------------------
void vtkFFHullAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Volume: " << this->Volume << "\n";
  os << indent << "Area: " << this->Area << "\n";
}
