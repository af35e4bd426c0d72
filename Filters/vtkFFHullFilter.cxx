// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFHullFilter.h"

#include "FFBlocks.h"
#include "FFHullResult.h"
#include "FFInput.h"
#include "FFOutput.h"
#include "FFRun.h"

#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFHullFilter);

//------------------------------------------------------------------------------
vtkFFHullFilter::vtkFFHullFilter() = default;

//------------------------------------------------------------------------------
vtkFFHullFilter::~vtkFFHullFilter() = default;

//------------------------------------------------------------------------------
bool vtkFFHullFilter::IsJoined() const
{
  return this->CompositeMode == HULL_OF_ALL_BLOCKS || this->NumberOfStreamDivisions > 1;
}

//------------------------------------------------------------------------------
int vtkFFHullFilter::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int done = this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  if (this->NumberOfStreamDivisions > 1)
  {
    FFHullStream::RequestPiece(inputVector[0]->GetInformationObject(0),
      outputVector->GetInformationObject(0), this->NumberOfStreamDivisions, 0);
  }
  return done;
}

//------------------------------------------------------------------------------
int vtkFFHullFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->NumberOfStreamDivisions == 1)
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  FFRun run(this, this->GetTitle());
  vtkPolyData* const output = vtkPolyData::GetData(outputVector);
  FFOutput::RemoveReport(output->GetFieldData());
  FFHullResult hull;
  FFHullStream stream(
    this, inputVector[0]->GetInformationObject(0), outputVector->GetInformationObject(0), run);
  for (int number = 0; number < stream.GetCount() && !run.Failure; ++number)
  {
    stream.TakePiece(number, hull);
  }
  run.Do([&] { this->WriteHull(hull, output, run); });
  return run.Finish({ output });
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::Execute(vtkDataObject* data, vtkInformationVector**,
  const std::vector<vtkDataObject*>& results, FFRun& run)
{
  FFInput points;
  points.Take(FFBlocks::PiecesOf(data), this->SkipGhostPoints, run);
  FFHullResult hull(vtkPolyData::SafeDownCast(results[0]));
  hull.Take(points, this->PassPointData, run);
  this->WriteHull(hull, hull.Data, run);
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CompositeMode: " << this->CompositeMode << "\n";
  os << indent << "NumberOfStreamDivisions: " << this->NumberOfStreamDivisions << "\n";
}
VTK_ABI_NAMESPACE_END
