// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFPieceSource.h"

#include "FFTest.h"

#include "vtkCallbackCommand.h"
#include "vtkDataObjectTypes.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cstring>

namespace fftest
{

vtkStandardNewMacro(PieceSource);

//------------------------------------------------------------------------------
PieceSource::PieceSource()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(1);
}

//------------------------------------------------------------------------------
void PieceSource::SetMaker(Maker make, const char* type)
{
  this->Make = std::move(make);
  this->Type = type;
  this->Modified();
}

//------------------------------------------------------------------------------
void PieceSource::SetWhole(vtkPolyData* whole)
{
  const vtkSmartPointer<vtkPolyData> all = whole;
  this->SetMaker(
    [all](int k, int n)
    {
      const vtkIdType count = all->GetNumberOfPoints();
      return cut(all, count * k / n, count * (k + 1) / n);
    });
}

//------------------------------------------------------------------------------
void PieceSource::SetPieces(std::vector<vtkSmartPointer<vtkDataObject>> pieces)
{
  const char* type = pieces[0]->GetClassName();
  this->SetMaker(
    [pieces](int k, int)
    {
      vtkDataObject* given = pieces[std::min(static_cast<std::size_t>(k), pieces.size() - 1)];
      vtkSmartPointer<vtkDataObject> made;
      made.TakeReference(given->NewInstance());
      auto* set = vtkPointSet::SafeDownCast(given);
      const bool hasPoints = !set || set->GetPoints(); // a deep copy always has
      if (static_cast<std::size_t>(k) < pieces.size() && hasPoints)
      {
        made->DeepCopy(given);
      }
      return made;
    },
    type);
}

//------------------------------------------------------------------------------
int PieceSource::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
void PieceSource::Watch(vtkDataObject* data)
{
  auto* set = vtkPointSet::SafeDownCast(data);
  if (!set || !set->GetPoints())
  {
    return;
  }
  struct Grave
  {
    std::shared_ptr<Lives> Points; // the source would hold itself
    vtkIdType Count;
  };
  const vtkIdType count = set->GetNumberOfPoints();
  this->Points->Now += count;
  this->Points->Most = std::max(this->Points->Most, this->Points->Now);
  this->Points->Largest = std::max(this->Points->Largest, count);
  vtkNew<vtkCallbackCommand> death;
  death->SetClientData(new Grave{ this->Points, count });
  death->SetClientDataDeleteCallback([](void* grave) { delete static_cast<Grave*>(grave); });
  death->SetCallback([](vtkObject*, unsigned long, void* grave, void*)
    { static_cast<Grave*>(grave)->Points->Now -= static_cast<Grave*>(grave)->Count; });
  // Of the coordinates themselves: whoever holds them holds the points.
  set->GetPoints()->GetData()->AddObserver(vtkCommand::DeleteEvent, death);
}

//------------------------------------------------------------------------------
vtkTypeBool PieceSource::ProcessRequest(
  vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkDataObject* output = vtkDataObject::GetData(info);
  if (request->Has(Pipeline::REQUEST_DATA_OBJECT()))
  {
    if (!output || this->Type != output->GetClassName())
    {
      vtkSmartPointer<vtkDataObject> created;
      created.TakeReference(vtkDataObjectTypes::NewDataObject(this->Type.c_str()));
      info->Set(vtkDataObject::DATA_OBJECT(), created);
    }
  }
  else if (request->Has(Pipeline::REQUEST_INFORMATION()))
  {
    // So that no image is cropped.
    constexpr int everything[6] = { 0, 1000, 0, 1000, 0, 1000 };
    info->Set(Pipeline::WHOLE_EXTENT(), everything, 6);
    info->Remove(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST());
    if (this->CanHandlePieces)
    {
      info->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
    }
  }
  else if (request->Has(Pipeline::REQUEST_DATA()))
  {
    const int piece = info->Get(Pipeline::UPDATE_PIECE_NUMBER());
    const int count = info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES());
    this->Asked.emplace_back(piece, count);
    const auto made = this->CanHandlePieces ? this->Make(piece, count) : this->Make(0, 1);
    if (!made)
    {
      vtkErrorMacro("This piece cannot be read.");
      return 0;
    }
    this->Watch(made);
    output->ShallowCopy(made);
  }
  return 1;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> cut(vtkPolyData* whole, vtkIdType begin, vtkIdType end)
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(whole->GetPoints()->GetDataType());
  points->SetNumberOfPoints(end - begin);
  points->GetData()->InsertTuples(0, end - begin, begin, whole->GetPoints()->GetData());
  part->SetPoints(points);
  part->GetPointData()->CopyAllOn();
  part->GetPointData()->CopyAllocate(whole->GetPointData(), end - begin);
  for (vtkIdType i = begin; i < end; ++i)
  {
    part->GetPointData()->CopyData(whole->GetPointData(), i, i - begin);
  }
  return part;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> makeDecorated(
  const std::vector<std::array<double, 3>>& points, int type, int number)
{
  auto data = makePoints(points, type);
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("temperature");
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("velocity");
  vectors->SetNumberOfComponents(3);
  vtkNew<vtkStringArray> names;
  names->SetName("names");
  vtkNew<vtkIdTypeArray> globals;
  globals->SetName("global");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double value = 1000.0 * number + 1.0 / (3.0 + static_cast<double>(i));
    scalars->InsertNextValue(value);
    vectors->InsertNextTuple3(value, -value, 0.5);
    names->InsertNextValue(std::to_string(number) + " " + std::to_string(i));
    globals->InsertNextValue(1000000 * number + i);
  }
  data->GetPointData()->SetScalars(scalars);
  data->GetPointData()->AddArray(names);
  data->GetPointData()->SetVectors(vectors);
  data->GetPointData()->SetGlobalIds(globals);
  return data;
}

}
