// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFHullFilter.h"

#include "vtkFFOutput.h"
#include "vtkFFPointSource.h"

#include "Engines.h"

#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedIntArray.h"

#include <cstddef>

vtkStandardNewMacro(vtkFFHullFilter);

//------------------------------------------------------------------------------
vtkFFHullFilter::vtkFFHullFilter()
  : CompositeMode(HULL_OF_EACH_BLOCK)
{
}

//------------------------------------------------------------------------------
vtkFFHullFilter::~vtkFFHullFilter() = default;

//------------------------------------------------------------------------------
bool vtkFFHullFilter::Execute(
  const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs)
{
  return this->RunEngine(
    [&](const flipflop::Options& options, const flipflop::EngineOptions& engine,
      flipflop::EngineReport& report)
    {
      std::vector<vtkPointSet*> pieces;
      for (const Block& block : blocks)
      {
        pieces.insert(pieces.end(), block.Pieces.begin(), block.Pieces.end());
      }
      const auto counted = this->TakePoints(pieces, this->PlacesOfPoints);
      const flipflop::Hull hull =
        this->TakeHull({ counted.begin(), counted.end() }, options, engine, report, outputs[0]);
      this->RestoreIds(outputs[0]->GetPointData());
      if (this->CombinesBlocks())
      {
        this->AddBlockIndex(outputs[0]);
      }
      this->AddToReport(hull, report, outputs[0]);
    });
}

//------------------------------------------------------------------------------
flipflop::Hull vtkFFHullFilter::TakeHull(const std::vector<vtkPointSet*>& pieces,
  const flipflop::Options& options, const flipflop::EngineOptions& engine,
  flipflop::EngineReport& report, vtkPolyData* output)
{
  std::vector<vtkDataArray*> arrays;
  std::vector<vtkFFOutput::Source> data;
  for (vtkPointSet* piece : pieces)
  {
    vtkPoints* points = piece->GetPoints();
    arrays.push_back(points ? points->GetData() : nullptr);
    if (this->PassPointData)
    {
      data.push_back({ piece->GetPointData(), piece->GetNumberOfPoints() });
    }
  }
  const vtkFFPointSource source(arrays);
  flipflop::Hull hull = flipflop::convexHull(source.GetView(), options, engine, report);
  vtkFFOutput::Adopt(hull, source, data, this->VisiblePointIds, output);
  return hull;
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::AddBlockIndex(vtkPolyData* output)
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
const char* vtkFFHullFilter::GetCompositeModeAsString()
{
  return this->CompositeMode == HULL_OF_ALL_BLOCKS ? "AllBlocks" : "EachBlock";
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CompositeMode: " << this->GetCompositeModeAsString() << "\n";
}
