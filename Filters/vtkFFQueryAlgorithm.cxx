// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFQueryAlgorithm.h"

#include "vtkFFBlockFailures.h"
#include "vtkFFGridPoints.h"
#include "vtkFFPieces.h"
#include "vtkFFPointSource.h"
#include "vtkFFQueryInternals.h"

#include <flipflop/Options.h>

#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// Of the progress: to make the second input ready.
constexpr double shareOfPreparing = 0.4;

const std::vector<std::string> leafTypes{ "vtkPointSet", "vtkImageData", "vtkRectilinearGrid" };

bool isLeaf(vtkDataObject* data)
{
  for (const std::string& type : leafTypes)
  {
    if (data->IsA(type.c_str()))
    {
      return true;
    }
  }
  return false;
}

}

//------------------------------------------------------------------------------
vtkFFQueryAlgorithm::vtkFFQueryAlgorithm()
  : NumberOfThreads(0)
  , NonFinitePoints(NON_FINITE_ERROR)
  , SkipGhostPoints(true)
  , Dimension(-1)
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkFFQueryAlgorithm::~vtkFFQueryAlgorithm() = default;

//------------------------------------------------------------------------------
void vtkFFQueryAlgorithm::SetInternals(std::unique_ptr<vtkInternals> internals)
{
  this->Internals = std::move(internals);
}

//------------------------------------------------------------------------------
int vtkFFQueryAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  // The composite type comes first: it keeps the executive from running us block by block. Any type
  // comes last, and none will do: we say ourselves what is wrong with an input.
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFQueryAlgorithm::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFQueryAlgorithm::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkDataObject* output = vtkDataObject::GetData(outInfo);
  const char* type = input ? input->GetClassName() : "vtkPolyData";
  if (!output || std::strcmp(output->GetClassName(), type) != 0)
  {
    vtkSmartPointer<vtkDataObject> created;
    if (input)
    {
      created.TakeReference(input->NewInstance());
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
int vtkFFQueryAlgorithm::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // All of the second input, whatever part of the first one is asked for.
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* second = inputVector[1]->GetInformationObject(0);
  if (second)
  {
    second->Remove(Pipeline::UPDATE_EXTENT());
    if (second->Has(Pipeline::WHOLE_EXTENT()))
    {
      second->Set(Pipeline::UPDATE_EXTENT(), second->Get(Pipeline::WHOLE_EXTENT()), 6);
    }
    second->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    second->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    second->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFQueryAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* second = vtkDataObject::GetData(inputVector[1]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  // What is downstream does not run after an error, but with the empty output of an abort it does.
  if (this->Internals->RunFilter(input, second, output) ||
    this->GetErrorCode() == vtkErrorCode::NoError)
  {
    return 1;
  }
  vtkFFGuard::ForgetExtents(outputVector);
  return 0;
}

//------------------------------------------------------------------------------
vtkFFQueryAlgorithm::vtkInternals::vtkInternals(vtkFFQueryAlgorithm* filter)
  : vtkFFGuard(filter)
  , Filter(filter)
{
}

//------------------------------------------------------------------------------
void vtkFFQueryAlgorithm::vtkInternals::SetErrorCode(unsigned long code)
{
  this->Filter->SetErrorCode(code);
}

//------------------------------------------------------------------------------
void vtkFFQueryAlgorithm::vtkInternals::MarkAborted()
{
#if VTK_FF_HAS_CHECK_ABORT
  this->Filter->SetAbortOutput(true);
#endif
}

//------------------------------------------------------------------------------
flipflop::Options vtkFFQueryAlgorithm::vtkInternals::GetOptions()
{
  flipflop::Options options = this->MakeOptions(this->Filter->NumberOfThreads);
  options.nonFinite = this->Filter->NonFinitePoints == NON_FINITE_IGNORE
    ? flipflop::NonFinitePolicy::Ignore
    : flipflop::NonFinitePolicy::Error;
  options.progress = this->Watched ? options.progress : nullptr;
  return options;
}

//------------------------------------------------------------------------------
vtkIdType vtkFFQueryAlgorithm::vtkInternals::GetPlaceOfPoint(vtkIdType index)
{
  return this->PlacesOfPoints.empty() ? index
                                      : this->PlacesOfPoints[static_cast<std::size_t>(index)];
}

//------------------------------------------------------------------------------
std::string vtkFFQueryAlgorithm::vtkInternals::DescribePoint(vtkIdType place)
{
  for (const Leaf& leaf : this->Current)
  {
    if (place < leaf.Points->GetNumberOfPoints())
    {
      return "point " + std::to_string(place) + leaf.OfWhat;
    }
    place -= leaf.Points->GetNumberOfPoints();
  }
  return "point " + std::to_string(place);
}

//------------------------------------------------------------------------------
std::string vtkFFQueryAlgorithm::vtkInternals::OfBlock()
{
  return this->Current.size() == 1 ? this->Current[0].OfWhat : std::string();
}

//------------------------------------------------------------------------------
std::vector<vtkDataArray*> vtkFFQueryAlgorithm::vtkInternals::ArraysOf(
  const std::vector<vtkPointSet*>& pieces)
{
  std::vector<vtkDataArray*> arrays;
  for (vtkPointSet* piece : pieces)
  {
    vtkPoints* points = piece->GetPoints();
    arrays.push_back(points ? points->GetData() : nullptr);
  }
  return arrays;
}

//------------------------------------------------------------------------------
vtkFFQueryAlgorithm::vtkInternals::Leaf vtkFFQueryAlgorithm::vtkInternals::MakeLeaf(
  vtkDataObject* data, unsigned int flatIndex, const std::string& name)
{
  const std::string ofName = name == "input" ? "" : " of the " + name;
  Leaf leaf{ vtkDataSet::SafeDownCast(data), OfBlockAt(flatIndex) + ofName, flatIndex };
  this->Try([&] { this->TakePoints(data, name, leaf); }, leaf.Failure);
  return leaf;
}

//------------------------------------------------------------------------------
void vtkFFQueryAlgorithm::vtkInternals::TakePoints(
  vtkDataObject* data, const std::string& name, Leaf& leaf)
{
  if (!isLeaf(data))
  {
    const std::string what = leaf.FlatIndex ? leaf.OfWhat.substr(std::strlen(" of the ")) : name;
    throw std::runtime_error("The " + what + " is a " + data->GetClassName() + ". It must be a " +
      List(leafTypes) + (leaf.FlatIndex ? "." : ", or a composite of such (vtkDataObjectTree)."));
  }
  leaf.Points = vtkFFGridPoints::PointsOf(data, leaf.OfWhat);
  vtkPoints* points = leaf.Points->GetPoints();
  const int size = points ? points->GetData()->GetNumberOfComponents() : 3;
  if (size != 3)
  {
    throw std::runtime_error("The points" + leaf.OfWhat + " have " + std::to_string(size) +
      " coordinates each; a point has 3.");
  }
}

//------------------------------------------------------------------------------
std::vector<vtkFFQueryAlgorithm::vtkInternals::Leaf> vtkFFQueryAlgorithm::vtkInternals::LeavesOf(
  vtkDataObject* data, const std::string& name)
{
  if (!data)
  {
    throw std::runtime_error("There is no " + name + ". Set one.");
  }
  std::vector<Leaf> leaves;
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
  {
    leaves.push_back(this->MakeLeaf(data, 0, name));
    return leaves;
  }
  vtkSmartPointer<vtkDataObjectTreeIterator> nodes;
  nodes.TakeReference(tree->NewTreeIterator());
  for (nodes->InitTraversal(); !nodes->IsDoneWithTraversal(); nodes->GoToNextItem())
  {
    leaves.push_back(
      this->MakeLeaf(nodes->GetCurrentDataObject(), nodes->GetCurrentFlatIndex(), name));
  }
  return leaves;
}

//------------------------------------------------------------------------------
void vtkFFQueryAlgorithm::vtkInternals::TakeSecond(vtkDataObject* second)
{
  this->Current = this->LeavesOf(second, this->GetSecondName());
  std::vector<vtkPointSet*> pieces;
  for (const Leaf& leaf : this->Current)
  {
    if (leaf.Failure.Kind != vtkFFFailure::None)
    {
      throw std::runtime_error(this->DescribeFailure(leaf.Failure));
    }
    pieces.push_back(leaf.Points);
  }
  std::vector<vtkSmartPointer<vtkPointSet>> counted;
  if (this->Filter->SkipGhostPoints)
  {
    counted = vtkFFPieces::SkipGhosts(pieces, this->PlacesOfPoints);
    pieces.assign(counted.begin(), counted.end());
  }
  this->Filter->Dimension = this->Prepare(pieces, this->GetOptions());
  this->PlacesOfPoints.clear();
}

//------------------------------------------------------------------------------
bool vtkFFQueryAlgorithm::vtkInternals::AnswerAll(
  vtkDataObject* input, vtkDataObject* output, vtkFFFailure& failure)
{
  std::vector<Leaf> leaves = this->LeavesOf(input, "input");
  double total = 1.0; // avoids 0 / 0
  for (const Leaf& leaf : leaves)
  {
    total += static_cast<double>(leaf.GetNumberOfPoints());
  }

  auto* tree = vtkDataObjectTree::SafeDownCast(input);
  vtkSmartPointer<vtkDataObjectTreeIterator> nodes;
  if (tree)
  {
    vtkDataObjectTree::SafeDownCast(output)->CopyStructure(tree);
    output->GetFieldData()->PassData(input->GetFieldData());
    nodes.TakeReference(tree->NewTreeIterator());
    nodes->InitTraversal();
  }
  double sum = 0.0;
  vtkFFBlockFailures failures(*this);
  for (Leaf& leaf : leaves)
  {
    const double begin = sum / total;
    sum += static_cast<double>(leaf.GetNumberOfPoints());
    this->SetProgressRange(shareOfPreparing + (1.0 - shareOfPreparing) * begin,
      shareOfPreparing + (1.0 - shareOfPreparing) * sum / total);
    vtkSmartPointer<vtkDataSet> result = vtkDataSet::SafeDownCast(output);
    if (tree && leaf.Data)
    {
      result.TakeReference(leaf.Data->NewInstance());
    }
    this->AnswerLeaf(leaf, result);
    if (tree)
    {
      if (leaf.Failure.Kind == vtkFFFailure::None)
      {
        vtkDataObjectTree::SafeDownCast(output)->SetDataSet(nodes, result);
      }
      nodes->GoToNextItem();
    }
    failures.Add(leaf.FlatIndex, leaf.Failure);
    if (failures.IsAborted())
    {
      break;
    }
  }
  return failures.Join(leaves.size(), failure);
}

//------------------------------------------------------------------------------
void vtkFFQueryAlgorithm::vtkInternals::AnswerLeaf(Leaf& leaf, vtkDataSet* result)
{
  if (leaf.Failure.Kind != vtkFFFailure::None)
  {
    return;
  }
  this->Current = { leaf };
  this->Try(
    [&]
    {
      result->ShallowCopy(leaf.Data);
      const vtkFFPointSource points(ArraysOf({ leaf.Points }));
      this->Answer(points.GetView(), this->GetOptions(), result);
    },
    leaf.Failure);
}

//------------------------------------------------------------------------------
bool vtkFFQueryAlgorithm::vtkInternals::Run(const std::function<bool(vtkFFFailure&)>& work)
{
  this->Forget();
  this->Filter->Dimension = -1;
  this->Filter->SetErrorCode(vtkErrorCode::NoError);
  vtkFFFailure failure;
  bool done = false;
  this->Try([&] { done = work(failure); }, failure);
  this->ReportFailure(failure);
  this->Current.clear();
  this->PlacesOfPoints.clear();
  this->SetProgressRange(0.0, 1.0);
  if (!done)
  {
    this->Forget();
    this->Filter->Dimension = -1;
  }
  return done;
}

//------------------------------------------------------------------------------
void vtkFFQueryAlgorithm::vtkInternals::Ask(const std::function<void()>& question)
{
  vtkFFFailure failure;
  this->Try(question, failure);
  this->ReportFailure(failure);
}

//------------------------------------------------------------------------------
bool vtkFFQueryAlgorithm::vtkInternals::RunPrepare(vtkDataObject* second)
{
  this->Watched = false;
  const auto work = [&](vtkFFFailure&)
  {
    this->TakeSecond(second);
    return true;
  };
  const bool done = this->Run(work);
  this->Watched = true;
  return done;
}

//------------------------------------------------------------------------------
bool vtkFFQueryAlgorithm::vtkInternals::RunFilter(
  vtkDataObject* input, vtkDataObject* second, vtkDataObject* output)
{
  const auto work = [&](vtkFFFailure& failure)
  {
    if (!input)
    {
      this->LeavesOf(nullptr, "input");
    }
    this->SetProgressRange(0.0, shareOfPreparing);
    this->TakeSecond(second);
    return this->AnswerAll(input, output, failure);
  };
  const bool done = this->Run(work);
  if (!done)
  {
    output->Initialize();
  }
  else if (!this->KeepsPrepared())
  {
    this->Forget();
  }
  return done;
}

//------------------------------------------------------------------------------
const char* vtkFFQueryAlgorithm::GetNonFinitePointsAsString()
{
  return this->NonFinitePoints == NON_FINITE_IGNORE ? "Ignore" : "Error";
}

//------------------------------------------------------------------------------
void vtkFFQueryAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "NonFinitePoints: " << this->GetNonFinitePointsAsString() << "\n";
  os << indent << "SkipGhostPoints: " << (this->SkipGhostPoints ? "On" : "Off") << "\n";
  os << indent << "Dimension: " << this->Dimension << "\n";
}
VTK_ABI_NAMESPACE_END
