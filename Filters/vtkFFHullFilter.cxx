// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFHullFilter.h"

#include "Support/Threads.h"
#include "vtkFFHullResult.h"
#include "vtkFFHullStream.h"
#include "vtkFFInput.h"
#include "vtkFFOutput.h"
#include "vtkFFRun.h"
#include "vtkFFStamp.h"

#include <flipflop/Certificate.h>
#include <flipflop/Error.h>

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDataObjectTypes.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFHullFilter);

namespace
{

using Blocks = std::vector<vtkFFInput::PieceType>;

/// Whether a block is not worth a second thread, nor the device.
bool isSmall(const vtkFFInput::PieceType& block, const flipflop::EngineOptions& engine)
{
  const std::int64_t count = block.Data->GetNumberOfElements(vtkDataObject::POINT);
  return count <= flipflop::UsualPointsPerThread &&
    (engine.choice == flipflop::EngineChoice::CPU ||
      (engine.choice == flipflop::EngineChoice::Automatic && count < engine.cudaFrom));
}

/// Calls make(i, run) for each block, and then write(i, run), with a run of its own. Small blocks
/// are made side by side, some hundreds at a time. All are written in their order by the calling
/// thread, as their errors are reported. An abort ends it. A data set that is there several times
/// is read by one thread at a time: some change when they are read.
void runBlocks(const Blocks& blocks, vtkFFRun& run,
  const std::function<void(std::size_t, vtkFFRun&)>& make,
  const std::function<void(std::size_t, vtkFFRun&)>& write)
{
  constexpr std::size_t most = 256;
  constexpr std::int64_t worth = 512; // a block takes at least as long as so many points
  const std::size_t count = blocks.size();
  const auto setPart = [&](std::size_t i)
  {
    run.SetPart(static_cast<double>(i) / static_cast<double>(count),
      static_cast<double>(i + 1) / static_cast<double>(count));
  };
  std::size_t end = 0;
  for (std::size_t begin = 0; begin < count && !run.Failure; begin = end)
  {
    const bool areSmall = isSmall(blocks[begin], run.Engine);
    std::set<vtkDataObject*> data{ blocks[begin].Data };
    end = begin + 1;
    while (areSmall && end < std::min(count, begin + most) && isSmall(blocks[end], run.Engine) &&
      data.insert(blocks[end].Data).second)
    {
      ++end;
    }
    std::deque<vtkFFRun> runs;
    for (std::size_t i = begin; i < end; ++i)
    {
      runs.emplace_back(run, i, count);
    }
    const auto work = [&](std::size_t k) { runs[k].Do([&] { make(begin + k, runs[k]); }); };
    if (areSmall)
    {
      const std::int64_t points = worth * static_cast<std::int64_t>(runs.size());
      flipflop::runSideBySide(
        runs.size(), flipflop::threadCount(run.Options.threads, points), work);
    }
    else
    {
      runs[0].Options = run.Options;
      setPart(begin);
      work(0);
    }
    for (std::size_t i = begin; i < end && !run.Failure; ++i)
    {
      vtkFFRun& own = runs[i - begin];
      setPart(i);
      run.Do(
        [&]
        {
          vtkFFRun::Look(run.Options, 0.5);
          if (own.Failure.Kind == vtkFFFailure::Aborted)
          {
            throw flipflop::Error(flipflop::ErrorCode::Aborted);
          }
          write(i, own);
          own.Finish();
          vtkFFRun::Look(run.Options, 1.0);
        });
    }
  }
}

}

//------------------------------------------------------------------------------
/// The last hull, and what it was made of.
struct vtkFFHullFilter::KeptType
{
  vtkFFStamp Stamp;
  vtkFFHullResult Hull;
  std::vector<vtkFFRun::PartType> Parts;
  bool HasPointData = false;
};

//------------------------------------------------------------------------------
vtkFFHullFilter::vtkFFHullFilter() = default;

//------------------------------------------------------------------------------
vtkFFHullFilter::~vtkFFHullFilter() = default;

//------------------------------------------------------------------------------
int vtkFFHullFilter::FillInputPortInformation(int, vtkInformation* info)
{
  vtkFFInput::AcceptWhole(info);
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFHullFilter::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject"); // see RequestDataObject()
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkFFHullFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT())
    ? this->RequestDataObject(request, inputVector, outputVector)
    : this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkFFHullFilter::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const input = vtkDataObject::GetData(inputVector[0]);
  const bool hasEach = this->HasHullOfEach(input);
  const bool isLike = hasEach && input->IsA("vtkDataObjectTree");
  const std::string type = isLike ? input->GetClassName()
    : hasEach                     ? "vtkMultiBlockDataSet" // of an AMR
                                  : "vtkPolyData";
  vtkInformation* const info = outputVector->GetInformationObject(0);
  vtkDataObject* const output = vtkDataObject::GetData(info);
  if (!output || type != output->GetClassName())
  {
    vtkSmartPointer<vtkDataObject> made;
    made.TakeReference(
      isLike ? input->NewInstance() : vtkDataObjectTypes::NewDataObject(type.c_str()));
    info->Set(vtkDataObject::DATA_OBJECT(), made);
    this->GetOutputPortInformation(0)->Set(
      vtkDataObject::DATA_EXTENT_TYPE(), made->GetExtentType());
  }
  return 1;
}

//------------------------------------------------------------------------------
bool vtkFFHullFilter::HasHullOfEach(vtkDataObject* input) const
{
  return this->CompositeMode == HULL_OF_EACH_BLOCK && this->NumberOfStreamDivisions == 1 &&
    vtkCompositeDataSet::SafeDownCast(input);
}

//------------------------------------------------------------------------------
int vtkFFHullFilter::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int done = this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  if (this->NumberOfStreamDivisions > 1)
  {
    vtkFFHullStream::RequestPiece(inputVector[0]->GetInformationObject(0),
      outputVector->GetInformationObject(0), this->NumberOfStreamDivisions, 0);
  }
  return done;
}

//------------------------------------------------------------------------------
int vtkFFHullFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkFFRun run(this, "Convex hull", outputVector);
  vtkInformation* const inputInfo = inputVector[0]->GetInformationObject(0);
  vtkInformation* const outputInfo = outputVector->GetInformationObject(0);
  vtkDataObject* const input = vtkDataObject::GetData(inputInfo);
  if (this->HasHullOfEach(input))
  {
    this->Kept.reset();
    this->WriteHulls(
      vtkCompositeDataSet::SafeDownCast(input), run, vtkCompositeDataSet::GetData(outputVector));
    return run.Finish();
  }
  const bool isStreamed = this->NumberOfStreamDivisions > 1;
  const bool keeps = !isStreamed && !this->GetReleaseDataFlag();
  const vtkFFStamp stamp = keeps ? vtkFFStamp(this, input) : vtkFFStamp();
  const bool isKept =
    this->Kept && this->Kept->Stamp == stamp && (this->Kept->HasPointData || !this->PassPointData);
  if (!isKept)
  {
    this->Kept = std::make_shared<KeptType>();
    vtkFFHullResult& hull = this->Kept->Hull;
    if (isStreamed)
    {
      vtkFFHullStream stream(this, inputInfo, outputInfo, run);
      for (int number = 0; number < stream.GetCount() && !run.Failure; ++number)
      {
        stream.TakePiece(number, hull);
      }
    }
    else
    {
      run.Do(
        [&]
        {
          vtkFFInput points;
          points.Take(vtkFFInput::PiecesOf(input), this->SkipGhostPoints, run);
          hull.Take(points, this->PassPointData, run);
        });
    }
    this->Kept->Parts = run.Parts;
    this->Kept->HasPointData = this->PassPointData;
    this->Kept->Stamp = stamp;
    hull.IsKept = keeps;
  }
  run.Parts = this->Kept->Parts;
  vtkPolyData* const output = vtkPolyData::GetData(outputVector);
  run.Do(
    [&]
    {
      this->WriteHull(this->Kept->Hull, run, output);
      if (this->GenerateCertificate)
      {
        run.Parts.clear();
        vtkFFInput points;
        const vtkIdType count =
          points.Take(vtkFFInput::PiecesOf(input), this->SkipGhostPoints, run);
        this->AddCertificate(points, count, this->Kept->Hull, run, output);
      }
      this->ReportHull(this->Kept->Hull, run, output);
    });
  if (!keeps || run.Failure)
  {
    this->Kept.reset();
  }
  return run.Finish();
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::WriteHulls(
  vtkCompositeDataSet* input, vtkFFRun& run, vtkCompositeDataSet* output)
{
  output->CopyStructure(input);
  const std::vector<vtkFFInput::PieceType> blocks = vtkFFInput::PiecesOf(input);
  std::vector<std::unique_ptr<vtkFFHullResult>> hulls(blocks.size());
  const auto make = [&](std::size_t i, vtkFFRun& own)
  {
    auto hull = std::make_unique<vtkFFHullResult>();
    vtkFFInput points;
    const vtkIdType size = points.Take({ { blocks[i].Data, 0 } }, this->SkipGhostPoints, own);
    hull->Take(points, this->PassPointData, own);
    vtkFFOutput::PassFieldData(blocks[i].Data, hull->Data);
    vtkFFOutput::RemoveReport(hull->Data->GetFieldData());
    this->WriteHull(*hull, own, hull->Data);
    if (this->GenerateCertificate)
    {
      this->AddCertificate(points, size, *hull, own, hull->Data);
    }
    hulls[i] = std::move(hull);
  };
  vtkSmartPointer<vtkCompositeDataIterator> leaf;
  leaf.TakeReference(input->NewIterator());
  leaf->InitTraversal();
  const auto write = [&](std::size_t i, vtkFFRun& own)
  {
    if (hulls[i])
    {
      this->ReportHull(*hulls[i], own, hulls[i]->Data);
    }
    output->SetDataSet(leaf, hulls[i] ? hulls[i]->Data : vtkSmartPointer<vtkPolyData>::New());
    leaf->GoToNextItem();
    hulls[i].reset();
  };
  runBlocks(blocks, run, make, write);
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::AddCertificate(const vtkFFInput& points, vtkIdType count,
  const vtkFFHullResult& hull, const vtkFFRun& run, vtkPolyData* output) const
{
  // The output's cells, over the points as the engine has them: those ids and these both ascend.
  flipflop::Hull cells;
  cells.dimension = hull.Hull.dimension;
  auto* ids =
    vtkIdTypeArray::SafeDownCast(output->GetPointData()->GetAbstractArray("vtkOriginalPointIds"));
  cells.pointIds.allocate(static_cast<std::size_t>(ids ? ids->GetNumberOfValues() : 0));
  vtkIdType index = 0;
  for (std::size_t i = 0; i < cells.pointIds.size(); ++i)
  {
    while (run.GetId(index) != ids->GetValue(static_cast<vtkIdType>(i)))
    {
      ++index;
    }
    cells.pointIds[i] = index;
  }
  vtkFFOutput::CopyCells(cells.dimension <= 0 ? output->GetVerts()
      : cells.dimension == 1                  ? output->GetLines()
                                              : output->GetPolys(),
    cells);
  const flipflop::Certificate certificate =
    flipflop::certificate(points.GetView(), cells, run.Options);
  vtkFFOutput::AddCertificate(
    output->GetFieldData(), certificate, count, [&](vtkIdType id) { return run.GetId(id); });
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CompositeMode: " << this->CompositeMode << "\n";
  os << indent << "NumberOfStreamDivisions: " << this->NumberOfStreamDivisions << "\n";
  os << indent << "GenerateCertificate: " << (this->GenerateCertificate ? "On" : "Off") << "\n";
}
VTK_ABI_NAMESPACE_END
