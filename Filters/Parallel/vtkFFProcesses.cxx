// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFProcesses.h"

#include "vtkFFErrorCode.h"
#include "vtkFFFailure.h"
#include "vtkFFParcel.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <new>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

constexpr int tagOfSize = 7701;
constexpr int tagOfData = 7702;
constexpr int tagOfValues = 7703;

/// Runs work; what it throws becomes a failure.
template <class Work>
void guard(vtkFFFailure& failure, const char* what, Work&& work)
{
  try
  {
    work();
  }
  catch (const vtkFFDamagedParcel& error)
  {
    failure.Say(error.what(), vtkFFErrorCode::ProcessError);
  }
  catch (const std::exception&)
  {
    failure.Say(
      std::string("There is not enough memory to ") + what + ".", vtkFFErrorCode::MemoryError);
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
vtkIdType vtkFFProcesses::Sum(vtkIdType value)
{
  return this->Sum(std::vector<vtkIdType>{ value })[0];
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> vtkFFProcesses::Sum(const std::vector<vtkIdType>& values)
{
  std::vector<vtkIdType> sums = values;
  if (this->Count > 1)
  {
    this->Controller->AllReduce(
      values.data(), sums.data(), static_cast<vtkIdType>(values.size()), vtkCommunicator::SUM_OP);
  }
  return sums;
}

//------------------------------------------------------------------------------
double vtkFFProcesses::Least(double value)
{
  double least = value;
  if (this->Count > 1)
  {
    this->Controller->AllReduce(&value, &least, 1, vtkCommunicator::MIN_OP);
  }
  return least;
}

//------------------------------------------------------------------------------
void vtkFFProcesses::PassOn(std::vector<double>& values, const std::function<void()>& work)
{
  const auto size = static_cast<vtkIdType>(values.size());
  if (this->Rank > 0)
  {
    this->Controller->Receive(values.data(), size, this->Rank - 1, tagOfValues);
  }
  work();
  if (this->Rank + 1 < this->Count)
  {
    this->Controller->Send(values.data(), size, this->Rank + 1, tagOfValues);
  }
  if (this->Count > 1)
  {
    this->Controller->Broadcast(values.data(), size, this->Count - 1);
  }
}

//------------------------------------------------------------------------------
bool vtkFFProcesses::Share(vtkFFFailure& failure)
{
  if (this->Count == 1)
  {
    return !failure;
  }
  const std::vector<std::vector<vtkIdType>> all =
    this->GatherLists({ failure.Kind, failure.Place, failure.Count,
      static_cast<vtkIdType>(failure.Code), static_cast<vtkIdType>(failure.Message.size()) });
  vtkFFFailure together;
  int speaker = 0; // the process whose failure it is
  for (int process = 0; process < this->Count; ++process)
  {
    const std::vector<vtkIdType>& given = all[static_cast<std::size_t>(process)];
    const vtkFFFailure::KindType before = together.Kind;
    together.Add({ static_cast<vtkFFFailure::KindType>(given[0]), given[1], given[2],
      static_cast<unsigned long>(given[3]), {} });
    speaker = together.Kind == before ? speaker : process;
  }
  if (together.Kind == vtkFFFailure::Other)
  {
    together.Message = failure.Message;
    together.Message.resize(static_cast<std::size_t>(all[static_cast<std::size_t>(speaker)][4]));
    this->Controller->Broadcast(
      &together.Message[0], static_cast<vtkIdType>(together.Message.size()), speaker);
  }
  failure = together;
  return !failure;
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
VTK_ABI_NAMESPACE_END
