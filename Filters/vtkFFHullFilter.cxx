// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFHullFilter.h"

#include "vtkFFOutput.h"
#include "vtkFFPointSource.h"

#include "Engines.h"

#include "vtkCompositeDataIterator.h"
#include "vtkDataObjectTree.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedIntArray.h"

#include <cstring>

vtkStandardNewMacro(vtkFFHullFilter);

//------------------------------------------------------------------------------
vtkFFHullFilter::vtkFFHullFilter()
  : CompositeMode(HULL_OF_EACH_BLOCK)
{
}

//------------------------------------------------------------------------------
vtkFFHullFilter::~vtkFFHullFilter() = default;

//------------------------------------------------------------------------------
int vtkFFHullFilter::FillInputPortInformation(int, vtkInformation* info)
{
  // The composite type comes first: it keeps the executive from running us block by block.
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFHullFilter::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkFFHullFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->RequestDataObject(request, inputVector, outputVector);
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkFFHullFilter::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* tree = vtkDataObjectTree::GetData(inputVector[0]);
  const bool eachBlock = tree && this->CompositeMode == HULL_OF_EACH_BLOCK;
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkDataObject* output = vtkDataObject::GetData(outInfo);
  const char* type = eachBlock ? tree->GetClassName() : "vtkPolyData";
  if (!output || strcmp(output->GetClassName(), type) != 0)
  {
    vtkSmartPointer<vtkDataObject> created;
    if (eachBlock)
    {
      created.TakeReference(tree->NewInstance());
    }
    else
    {
      created.TakeReference(vtkPolyData::New());
    }
    outInfo->Set(vtkDataObject::DATA_OBJECT(), created);
    this->GetOutputPortInformation(0)->Set(
      vtkDataObject::DATA_EXTENT_TYPE(), created->GetExtentType());
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFHullFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  this->ResetReport();

  std::vector<Block> blocks;
  bool done = this->CollectBlocks(input, blocks);
  if (auto* outputTree = vtkDataObjectTree::SafeDownCast(output))
  {
    auto* inputTree = vtkDataObjectTree::SafeDownCast(input);
    outputTree->CopyStructure(inputTree);

    double total = 1.0; // avoids 0 / 0 for blocks without a point
    for (const Block& block : blocks)
    {
      total += static_cast<double>(block.Points->GetNumberOfPoints());
    }
    vtkSmartPointer<vtkCompositeDataIterator> iterator;
    iterator.TakeReference(inputTree->NewIterator());
    double sum = 0.0;
    for (iterator->InitTraversal(); done && !iterator->IsDoneWithTraversal();
         iterator->GoToNextItem())
    {
      const Block block{ static_cast<vtkPointSet*>(iterator->GetCurrentDataObject()),
        iterator->GetCurrentFlatIndex() };
      const double begin = sum / total;
      sum += static_cast<double>(block.Points->GetNumberOfPoints());
      this->SetProgressRange(begin, sum / total);

      vtkNew<vtkPolyData> hull;
      hull->GetFieldData()->PassData(block.Points->GetFieldData());
      done = this->BuildHull({ block }, hull);
      outputTree->SetDataSet(iterator, hull);
    }
  }
  else if (done)
  {
    done = this->BuildHull(blocks, vtkPolyData::SafeDownCast(output));
  }
  if (!done)
  {
    output->Initialize();
  }
  return 1;
}

//------------------------------------------------------------------------------
bool vtkFFHullFilter::CollectBlocks(vtkDataObject* input, std::vector<Block>& blocks)
{
  if (auto* points = vtkPointSet::SafeDownCast(input))
  {
    blocks.push_back({ points, 0 });
    return true;
  }
  auto* tree = vtkDataObjectTree::SafeDownCast(input);
  if (!tree)
  {
    this->ReportError("The input is neither a vtkPointSet nor a vtkDataObjectTree.");
    return false;
  }
  vtkSmartPointer<vtkCompositeDataIterator> iterator;
  iterator.TakeReference(tree->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* leaf = iterator->GetCurrentDataObject();
    auto* points = vtkPointSet::SafeDownCast(leaf);
    if (!points)
    {
      this->ReportError("The block of flat index " +
        std::to_string(iterator->GetCurrentFlatIndex()) + " is a " + leaf->GetClassName() +
        ", which is not a vtkPointSet.");
      return false;
    }
    blocks.push_back({ points, iterator->GetCurrentFlatIndex() });
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkFFHullFilter::BuildHull(const std::vector<Block>& blocks, vtkPolyData* output)
{
  this->CurrentBlocks = blocks;
  const auto work = [&](const flipflop::Options& options, const flipflop::EngineOptions& engine,
                      flipflop::EngineReport& report)
  {
    std::vector<vtkDataArray*> arrays;
    for (const Block& block : blocks)
    {
      vtkPoints* points = block.Points->GetPoints();
      arrays.push_back(points ? points->GetData() : nullptr);
    }
    const vtkFFPointSource source(arrays);
    flipflop::Hull hull = flipflop::convexHull(source.GetView(), options, engine, report);
    this->AddToReport(hull);

    std::vector<vtkFFOutput::Source> data;
    if (this->PassPointData)
    {
      for (const Block& block : blocks)
      {
        data.push_back({ block.Points->GetPointData(), block.Points->GetNumberOfPoints() });
      }
    }
    const auto ids = vtkFFOutput::Adopt(hull, source, data, this->VisiblePointIds, output);
    const vtkIdType count = ids->GetNumberOfValues();
    const bool composite = blocks.size() != 1 || blocks[0].FlatIndex != 0;
    if (composite && this->CompositeMode == HULL_OF_ALL_BLOCKS)
    {
      vtkNew<vtkUnsignedIntArray> indices;
      indices->SetName("BlockIndex");
      indices->SetNumberOfValues(count);
      std::size_t block = 0;
      vtkIdType end = blocks.empty() ? 0 : blocks[0].Points->GetNumberOfPoints();
      for (vtkIdType i = 0; i < count; ++i)
      {
        while (ids->GetValue(i) >= end)
        {
          end += blocks[++block].Points->GetNumberOfPoints();
        }
        indices->SetValue(i, blocks[block].FlatIndex);
      }
      output->GetPointData()->AddArray(indices);
    }
  };
  const bool done = this->RunEngine(work);
  this->CurrentBlocks.clear();
  return done;
}

//------------------------------------------------------------------------------
std::string vtkFFHullFilter::DescribePoint(vtkIdType index)
{
  for (const Block& block : this->CurrentBlocks)
  {
    const vtkIdType count = block.Points->GetNumberOfPoints();
    if (index < count && block.FlatIndex != 0)
    {
      return this->Superclass::DescribePoint(index) + " of the block of flat index " +
        std::to_string(block.FlatIndex);
    }
    if (index < count)
    {
      break;
    }
    index -= count;
  }
  return this->Superclass::DescribePoint(index);
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
