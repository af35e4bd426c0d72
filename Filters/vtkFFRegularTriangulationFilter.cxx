// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFRegularTriangulationFilter.h"

#include "vtkFFKeptTriangulation.h"
#include "vtkFFOutput.h"
#include "vtkFFPlanarInput.h"
#include "vtkFFRun.h"
#include "vtkFFTriangulationOutput.h"

#include <flipflop/Certificate.h>

#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cstdint>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFRegularTriangulationFilter);

//------------------------------------------------------------------------------
vtkFFRegularTriangulationFilter::vtkFFRegularTriangulationFilter()
{
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
vtkFFRegularTriangulationFilter::~vtkFFRegularTriangulationFilter() = default;

//------------------------------------------------------------------------------
int vtkFFRegularTriangulationFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkFFRun run(this, "Regular triangulation", outputVector);
  run.Do(
    [&]
    {
      vtkFFTriangulationOutput outputs(this, run);
      vtkFFPlanarInput input(this, run);
      input.Take(vtkDataObject::GetData(inputVector[0]));
      flipflop::Triangulation triangulation =
        vtkFFKeptTriangulation::Triangulate(this, input, run, this->Kept);
      input.LookForVerticalPlane(triangulation);
      if (this->GenerateCellMeasures)
      {
        input.SetHeight(triangulation);
      }

      vtkPolyData* const output = vtkPolyData::GetData(outputVector, 0);
      flipflop::Certificate certificate;
      if (this->GenerateCertificate)
      {
        certificate =
          flipflop::certificate(input.GetPlane(), input.GetWeights(), triangulation, run.Options);
      }
      const std::int64_t dropped =
        outputs.DropCells(input.GetPlane(), input.GetWeights(), triangulation);
      const auto hidden = static_cast<std::int64_t>(triangulation.hiddenIds.size());
      outputs.Write(input, triangulation, output, vtkPolyData::GetData(outputVector, 1),
        vtkPolyData::GetData(outputVector, 2));
      input.Report(triangulation, hidden, dropped, output);
      if (this->GenerateCertificate)
      {
        const vtkIdType count = vtkDataSet::GetData(inputVector[0])->GetNumberOfPoints();
        vtkFFOutput::AddCertificate(
          output->GetFieldData(), certificate, count, [&](vtkIdType id) { return run.GetId(id); });
      }
    });
  return run.Finish();
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Alpha: " << this->Alpha << "\n";
  os << indent << "AlphaLines: " << (this->AlphaLines ? "On" : "Off") << "\n";
  os << indent << "AlphaVerts: " << (this->AlphaVerts ? "On" : "Off") << "\n";
  os << indent << "GenerateAlphas: " << (this->GenerateAlphas ? "On" : "Off") << "\n";
  os << indent << "GenerateBoundary: " << (this->GenerateBoundary ? "On" : "Off") << "\n";
  os << indent << "GenerateCertificate: " << (this->GenerateCertificate ? "On" : "Off") << "\n";
  os << indent << "MaximumEdgeLength: " << this->MaximumEdgeLength << "\n";
}
VTK_ABI_NAMESPACE_END
