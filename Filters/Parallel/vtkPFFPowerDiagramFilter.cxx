// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFPowerDiagramFilter.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// Where there are ids, they are what an application colours cells by.
void activateIds(vtkDataObject* data)
{
  if (auto* diagram = vtkPolyData::SafeDownCast(data))
  {
    diagram->GetCellData()->SetActiveScalars("OriginalPointIds");
  }
}

}

vtkStandardNewMacro(vtkPFFPowerDiagramFilter);

//------------------------------------------------------------------------------
vtkPFFPowerDiagramFilter::vtkPFFPowerDiagramFilter()
{
  this->SetNumberOfOutputPorts(1);
  this->GeneratePowerDiagram = true;
}

//------------------------------------------------------------------------------
vtkPFFPowerDiagramFilter::~vtkPFFPowerDiagramFilter() = default;

//------------------------------------------------------------------------------
int vtkPFFPowerDiagramFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int done = this->RequestDataOfOneOutput(2, request, inputVector, outputVector);
  if (done && this->VisiblePointIds)
  {
    vtkDataObject* output = vtkDataObject::GetData(outputVector);
    activateIds(output);
    if (auto* blocks = vtkDataObjectTree::SafeDownCast(output))
    {
      vtkSmartPointer<vtkDataObjectTreeIterator> leaves;
      leaves.TakeReference(blocks->NewTreeIterator());
      for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
      {
        activateIds(leaves->GetCurrentDataObject());
      }
    }
  }
  return done;
}
VTK_ABI_NAMESPACE_END
