// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFProcesses.h"

#include "vtkFFFailure.h"
#include "vtkFFOutput.h"
#include "vtkFFParcel.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <map>
#include <new>
#include <string>

namespace
{

constexpr int tagOfSize = 7701;
constexpr int tagOfData = 7702;

/// Runs work; what it throws becomes a failure.
template <class Work>
void guard(vtkFFFailure& failure, const char* what, Work&& work)
{
  try
  {
    work();
  }
  catch (const std::exception&)
  {
    failure.Say(std::string("There is not enough memory to ") + what + ".");
  }
}

}

//------------------------------------------------------------------------------
vtkFFProcesses::vtkFFProcesses(vtkMultiProcessController* controller)
  : Controller(controller)
  , Count(controller ? controller->GetNumberOfProcesses() : 1)
  , Rank(controller ? controller->GetLocalProcessId() : 0)
{
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> vtkFFProcesses::Gather(const std::vector<vtkIdType>& values)
{
  if (this->Count == 1)
  {
    return values;
  }
  std::vector<vtkIdType> all(values.size() * static_cast<std::size_t>(this->Count));
  this->Controller->AllGather(values.data(), all.data(), static_cast<vtkIdType>(values.size()));
  return all;
}

//------------------------------------------------------------------------------
std::vector<std::vector<vtkIdType>> vtkFFProcesses::GatherLists(
  const std::vector<vtkIdType>& values)
{
  const std::vector<vtkIdType> sizes = this->Gather({ static_cast<vtkIdType>(values.size()) });
  const auto most = static_cast<std::size_t>(*std::max_element(sizes.begin(), sizes.end()));
  std::vector<vtkIdType> padded = values;
  padded.resize(most);
  const std::vector<vtkIdType> all = this->Gather(padded);
  std::vector<std::vector<vtkIdType>> lists;
  for (std::size_t k = 0; k < sizes.size(); ++k)
  {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(k * most);
    lists.emplace_back(begin, begin + sizes[k]);
  }
  return lists;
}

//------------------------------------------------------------------------------
bool vtkFFProcesses::Share(vtkFFFailure& failure)
{
  const std::vector<std::vector<vtkIdType>> all = this->GatherLists(
    { failure.Kind, failure.Place, failure.Count, static_cast<vtkIdType>(failure.Message.size()) });
  vtkFFFailure together;
  int speaker = 0; // the process whose failure it is
  for (int process = 0; process < this->Count; ++process)
  {
    const std::vector<vtkIdType>& given = all[static_cast<std::size_t>(process)];
    const vtkFFFailure::KindType before = together.Kind;
    together.Add({ static_cast<vtkFFFailure::KindType>(given[0]), given[1], given[2], {} });
    speaker = together.Kind == before ? speaker : process;
  }
  if (together.Kind == vtkFFFailure::Other)
  {
    together.Message = failure.Message;
    together.Message.resize(static_cast<std::size_t>(all[static_cast<std::size_t>(speaker)][3]));
    this->Controller->Broadcast(
      &together.Message[0], static_cast<vtkIdType>(together.Message.size()), speaker);
  }
  failure = together;
  return failure.Kind == vtkFFFailure::None;
}

//------------------------------------------------------------------------------
bool vtkFFProcesses::SelectBlocks(
  bool alike, std::vector<vtkFFAlgorithm::Block>& blocks, vtkFFFailure& failure)
{
  if (!this->Share(failure))
  {
    return false;
  }
  std::vector<vtkIdType> named;
  std::vector<vtkIdType> filled;
  for (const vtkFFAlgorithm::Block& block : blocks)
  {
    named.push_back(block.FlatIndex);
    if (block.Points)
    {
      filled.push_back(block.FlatIndex);
    }
  }
  const std::vector<std::vector<vtkIdType>> all = this->GatherLists(named);
  for (std::size_t process = 1; alike && process < all.size(); ++process)
  {
    if (all[process] != all[0])
    {
      failure.Say("The input's blocks are not the same on all processes: process 0 has " +
        std::to_string(all[0].size()) + " leaves, process " + std::to_string(process) + " has " +
        std::to_string(all[process].size()) + ", or they have other places in the composite.");
      return false;
    }
  }

  std::map<vtkIdType, vtkPointSet*> present;
  for (const std::vector<vtkIdType>& list : this->GatherLists(filled))
  {
    for (const vtkIdType flatIndex : list)
    {
      present[flatIndex] = nullptr;
    }
  }
  for (const vtkFFAlgorithm::Block& block : blocks)
  {
    if (block.Points)
    {
      present[block.FlatIndex] = block.Points;
    }
  }
  blocks.clear();
  for (const auto& entry : present)
  {
    blocks.push_back({ entry.second, static_cast<unsigned int>(entry.first),
      entry.second ? entry.second->GetNumberOfPoints() : 0 });
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkFFProcesses::Send(vtkPointSet* data, int from, int to,
  vtkSmartPointer<vtkPolyData>& received, vtkFFFailure& failure)
{
  std::string parcel;
  if (from == this->Rank)
  {
    guard(failure, "send points to another process", [&] { parcel = vtkFFParcel::Pack(data); });
  }
  if (!this->Share(failure))
  {
    return false;
  }

  // What comes in has its memory before it comes.
  vtkIdType size = static_cast<vtkIdType>(parcel.size());
  if (from == this->Rank)
  {
    this->Controller->Send(&size, 1, to, tagOfSize);
  }
  else if (to == this->Rank)
  {
    this->Controller->Receive(&size, 1, from, tagOfSize);
    guard(failure, "receive points of another process",
      [&] { parcel.resize(static_cast<std::size_t>(size)); });
  }
  if (!this->Share(failure))
  {
    return false;
  }

  if (from == this->Rank)
  {
    this->Controller->Send(parcel.data(), size, to, tagOfData);
  }
  else if (to == this->Rank)
  {
    this->Controller->Receive(&parcel[0], size, from, tagOfData);
    guard(failure, "receive points of another process",
      [&] { received = vtkFFParcel::Unpack(parcel); });
  }
  return this->Share(failure);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> vtkFFProcesses::OwnPoints(vtkPointSet* points)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  if (!points)
  {
    return result;
  }
  vtkUnsignedCharArray* ghosts = points->GetPointGhostArray();
  const vtkIdType count = ghosts ? points->GetNumberOfPoints() : 0;
  vtkNew<vtkIdTypeArray> own;
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (!(ghosts->GetValue(i) & vtkDataSetAttributes::DUPLICATEPOINT))
    {
      own->InsertNextValue(i);
    }
  }
  if (own->GetNumberOfValues() == count)
  {
    return points;
  }

  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(own->GetNumberOfValues());
  std::copy_n(own->GetPointer(0), own->GetNumberOfValues(), ids->GetPointer(0));
  vtkNew<vtkPoints> places;
  places->SetDataType(points->GetPoints()->GetDataType());
  points->GetPoints()->GetPoints(ids, places);
  result->SetPoints(places);
  vtkFFOutput::CopyPointData({ { points->GetPointData(), count } }, own, result->GetPointData());
  return result;
}
