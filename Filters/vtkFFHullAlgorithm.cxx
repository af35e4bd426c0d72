// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFHullAlgorithm.h"

#include "vtkFFHullInternals.h"
#include "vtkFFOutput.h"
#include <flipflop/Hull.h>

#include "vtkPolyData.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkFFHullAlgorithm::vtkFFHullAlgorithm()
  : Volume(0.0)
  , Area(0.0)
{
}

//------------------------------------------------------------------------------
vtkFFHullAlgorithm::~vtkFFHullAlgorithm() = default;

//------------------------------------------------------------------------------
void vtkFFHullAlgorithm::vtkInternals::ResetReport()
{
  auto* filter = static_cast<vtkFFHullAlgorithm*>(this->GetFilter());
  this->vtkFFAlgorithm::vtkInternals::ResetReport();
  filter->Volume = 0.0;
  filter->Area = 0.0;
}

//------------------------------------------------------------------------------
void vtkFFHullAlgorithm::vtkInternals::AddToReport(
  const flipflop::Hull& hull, const flipflop::EngineReport& engine, vtkPolyData* output)
{
  auto* filter = static_cast<vtkFFHullAlgorithm*>(this->GetFilter());
  this->vtkFFAlgorithm::vtkInternals::AddToReport(hull, engine, output);
  filter->Volume += hull.volume;
  filter->Area += hull.area;
  if (filter->ReportAsFieldData)
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
VTK_ABI_NAMESPACE_END
