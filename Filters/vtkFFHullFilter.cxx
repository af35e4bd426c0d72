// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFHullFilter.h"

#include "vtkFFBlockWork.h"
#include "vtkFFHullInternals.h"
#include "vtkFFInputPieces.h"
#include "vtkFFOutput.h"
#include "vtkFFPointSource.h"

#include <flipflop/Engines.h>

#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedIntArray.h"

#include <cstddef>
#include <optional>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFHullFilter);

namespace
{

/// The coordinates of each piece; null where it has none.
std::vector<vtkDataArray*> arraysOf(const std::vector<vtkPointSet*>& pieces)
{
  std::vector<vtkDataArray*> arrays;
  for (vtkPointSet* piece : pieces)
  {
    vtkPoints* points = piece->GetPoints();
    arrays.push_back(points ? points->GetData() : nullptr);
  }
  return arrays;
}

}

//------------------------------------------------------------------------------
vtkFFHullFilter::vtkFFHullFilter()
  : CompositeMode(HULL_OF_EACH_BLOCK)
  , NumberOfStreamDivisions(1)
{
  this->SetInternals(std::make_unique<vtkInternals>(this));
}

//------------------------------------------------------------------------------
vtkFFHullFilter::~vtkFFHullFilter() = default;

//------------------------------------------------------------------------------
const char* vtkFFHullFilter::vtkInternals::GetProgressTitle()
{
  return "Convex hull";
}

//------------------------------------------------------------------------------
vtkFFHullFilter* vtkFFHullFilter::vtkInternals::GetHullFilter()
{
  return static_cast<vtkFFHullFilter*>(this->GetFilter());
}

//------------------------------------------------------------------------------
bool vtkFFHullFilter::vtkInternals::CombinesBlocks()
{
  return this->GetHullFilter()->CompositeMode == HULL_OF_ALL_BLOCKS;
}

//------------------------------------------------------------------------------
vtkIdType vtkFFHullFilter::vtkInternals::GetPlaceOfPoint(vtkIdType index)
{
  return this->PlaceOfPiece + this->vtkFFAlgorithm::vtkInternals::GetPlaceOfPoint(index);
}

//------------------------------------------------------------------------------
class vtkFFHullFilter::vtkInternals::Work : public vtkFFBlockWork
{
public:
  Work(vtkInternals* filter, const std::vector<Block>& blocks)
    : Filter(filter)
  {
    for (const Block& block : blocks)
    {
      this->Pieces.insert(this->Pieces.end(), block.Pieces.begin(), block.Pieces.end());
    }
  }

  void Gather(const flipflop::Options&) override
  {
    this->Counted = this->Filter->TakePoints(this->Pieces, this->Filter->PlacesOfPoints);
    this->Pieces.assign(this->Counted.begin(), this->Counted.end());
    this->Points.emplace(arraysOf(this->Pieces));
  }

  void Run(const flipflop::Options& options, const flipflop::EngineOptions& engine,
    flipflop::EngineReport& report) override
  {
    this->Hull = flipflop::convexHull(this->Points->GetView(), options, engine, report);
  }

  void Write(const flipflop::Options&, const flipflop::EngineReport& report,
    const std::vector<vtkPolyData*>& outputs) override
  {
    this->Filter->AdoptHull(this->Hull, *this->Points, this->Pieces, outputs[0]);
    this->Filter->RestoreIds(outputs[0]->GetPointData());
    if (this->Filter->CombinesBlocks())
    {
      this->Filter->AddBlockIndex(outputs[0]);
    }
    this->Filter->AddToReport(this->Hull, report, outputs[0]);
  }

private:
  vtkInternals* Filter;
  std::vector<vtkPointSet*> Pieces;
  std::vector<vtkSmartPointer<vtkPointSet>> Counted;
  std::optional<vtkFFPointSource> Points;
  flipflop::Hull Hull;
};

//------------------------------------------------------------------------------
void vtkFFHullFilter::vtkInternals::Execute(
  const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs, vtkFFFailure& failure)
{
  Work work(this, blocks);
  this->ExecuteWork(work, outputs, failure);
}

//------------------------------------------------------------------------------
std::unique_ptr<vtkFFBlockWork> vtkFFHullFilter::vtkInternals::NewBlockWork(const Block& block)
{
  return std::make_unique<Work>(this, std::vector<Block>{ block });
}

//------------------------------------------------------------------------------
flipflop::Hull vtkFFHullFilter::vtkInternals::TakeHull(const std::vector<vtkPointSet*>& pieces,
  const flipflop::Options& options, const flipflop::EngineOptions& engine,
  flipflop::EngineReport& report, vtkPolyData* output)
{
  const vtkFFPointSource points(arraysOf(pieces));
  flipflop::Hull hull = flipflop::convexHull(points.GetView(), options, engine, report);
  this->AdoptHull(hull, points, pieces, output);
  return hull;
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::vtkInternals::AdoptHull(flipflop::Hull& hull, const vtkFFPointSource& points,
  const std::vector<vtkPointSet*>& pieces, vtkPolyData* output)
{
  std::vector<vtkFFOutput::Source> data;
  if (this->GetHullFilter()->PassPointData)
  {
    for (vtkPointSet* piece : pieces)
    {
      data.push_back({ piece->GetPointData(), piece->GetNumberOfPoints() });
    }
  }
  vtkFFOutput::Adopt(hull, points, data, this->GetHullFilter()->VisiblePointIds, output);
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::vtkInternals::AddBlockIndex(vtkPolyData* output)
{
  const std::vector<Block>& blocks = this->CurrentBlocks;
  if (blocks.size() == 1 && blocks[0].FlatIndex == 0)
  {
    return;
  }
  auto* ids = vtkIdTypeArray::SafeDownCast(output->GetPointData()->GetArray("vtkOriginalPointIds"));
  const vtkIdType count = output->GetNumberOfPoints();
  vtkNew<vtkUnsignedIntArray> indices;
  indices->SetName("BlockIndex");
  indices->SetNumberOfValues(count);
  std::size_t block = 0;
  vtkIdType end = blocks.empty() ? 0 : blocks[0].NumberOfPoints;
  for (vtkIdType i = 0; i < count; ++i)
  {
    while (ids->GetValue(i) >= end)
    {
      end += blocks[++block].NumberOfPoints;
    }
    indices->SetValue(i, blocks[block].FlatIndex);
  }
  output->GetPointData()->AddArray(indices);
}

//------------------------------------------------------------------------------
int vtkFFHullFilter::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int done = this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  if (vtkInformation* input = inputVector[0]->GetInformationObject(0))
  {
    vtkFFInputPieces pieces(
      input, outputVector->GetInformationObject(0), this->NumberOfStreamDivisions);
    if (pieces.AreStreamed())
    {
      pieces.Request(0);
    }
  }
  return done;
}

//------------------------------------------------------------------------------
const char* vtkFFHullFilter::GetCompositeModeAsString()
{
  return this->CompositeMode == HULL_OF_ALL_BLOCKS ? "AllBlocks" : "EachBlock";
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CompositeMode: " << this->GetCompositeModeAsString() << "\n";
  os << indent << "NumberOfStreamDivisions: " << this->NumberOfStreamDivisions << "\n";
}
VTK_ABI_NAMESPACE_END
