// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFProcesses.h"

#include "FFRun.h"

#include <flipflop/Buffer.h>
#include <flipflop/Error.h>

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#if FLIPFLOP_USE_DIY
#include "vtkDIYUtilities.h"
#endif

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

#if FLIPFLOP_USE_DIY
void exchangeByDIY(vtkMultiProcessController* controller, FFProcesses::Messages& messages)
{
  diy::Master master(vtkDIYUtilities::GetCommunicator(controller));
  // A block for each process. Messages go to any of them, so none has neighbours.
  master.add(master.communicator().rank(), &messages, new diy::Link);
  const auto sender = master.proxy(0);
  for (const auto& message : messages)
  {
    sender.enqueue(diy::BlockID{ message.first, message.first }, message.second);
  }
  messages.clear();
  master.exchange(true);
  const auto receiver = master.proxy(0); // of the round that was exchanged
  std::vector<int> others;
  receiver.incoming(others);
  for (const int other : others)
  {
    receiver.dequeue(other, messages[other]);
    receiver.incoming(other).wipe();
  }
}
#else
void exchangeByDIY(vtkMultiProcessController*, FFProcesses::Messages&)
{
  // is never called: see FindObstacle()
}
#endif

template <class T>
std::vector<T> reduce(vtkMultiProcessController* controller, const std::vector<T>& values, int how)
{
  std::vector<T> results(values.size());
  controller->AllReduce(values.data(), results.data(), static_cast<vtkIdType>(values.size()), how);
  return results;
}

}

//------------------------------------------------------------------------------
bool FFProcesses::AreSeveral(vtkMultiProcessController* controller)
{
  return controller && controller->GetNumberOfProcesses() > 1;
}

//------------------------------------------------------------------------------
std::string FFProcesses::FindObstacle(vtkMultiProcessController* controller)
{
#if FLIPFLOP_USE_DIY
  return controller->IsA("vtkMPIController")
    ? std::string()
    : std::string("Several processes work together by MPI, and the controller is a ") +
      controller->GetClassName() + ". Set a vtkMPIController, or none.";
#else
  static_cast<void>(controller);
  return "Several processes work together by MPI, which this build of VTK lacks. Set no "
         "controller, or use a VTK with MPI.";
#endif
}

//------------------------------------------------------------------------------
FFProcesses::FFProcesses(vtkMultiProcessController* controller, FFRun& run)
  : Controller(controller)
  , Run(run)
  , Count(controller->GetNumberOfProcesses())
  , Rank(controller->GetLocalProcessId())
{
}

//------------------------------------------------------------------------------
void FFProcesses::Do(const std::function<void()>& work)
{
  bool isShared = false;
  this->Run.Do(
    [&]
    {
      try
      {
        work();
      }
      catch (const FFSharedFailure&)
      {
        isShared = true;
      }
    });
  if (!isShared)
  {
    this->Share();
  }
}

//------------------------------------------------------------------------------
void FFProcesses::Agree()
{
  if (!this->Share())
  {
    throw FFSharedFailure();
  }
}

//------------------------------------------------------------------------------
void FFProcesses::Fail(const std::string& message)
{
  this->Run.Failure.Say(message, vtkFFErrorCode::ProcessError);
  throw FFSharedFailure();
}

//------------------------------------------------------------------------------
bool FFProcesses::Share()
{
  FFFailure& failure = this->Run.Failure;
  this->Run.NoteAbort();
  using Values = std::array<vtkIdType, 5>;
  const Values own{ failure.Kind, failure.Point, failure.Count,
    static_cast<vtkIdType>(failure.Code), static_cast<vtkIdType>(failure.Message.size()) };
  std::vector<Values> all(static_cast<std::size_t>(this->Count));
  this->Controller->AllGather(own.data(), all[0].data(), static_cast<vtkIdType>(own.size()));
  FFFailure together;
  for (const Values& values : all)
  {
    together.Add({ static_cast<FFFailure::KindType>(values[0]), values[1], values[2],
      static_cast<unsigned long>(values[3]), {} });
  }
  if (together.Kind == FFFailure::Other)
  {
    const auto reporter = std::find_if(
      all.begin(), all.end(), [](const Values& values) { return values[0] == FFFailure::Other; });
    together.Message = failure.Message;
    together.Message.resize(static_cast<std::size_t>((*reporter)[4]));
    this->Broadcast(
      &together.Message[0], together.Message.size(), static_cast<int>(reporter - all.begin()));
  }
  failure = together;
  return !failure;
}

//------------------------------------------------------------------------------
vtkIdType FFProcesses::Exchange(Messages& messages)
{
  FFRun::Look(this->Run.Options);
  std::vector<vtkIdType> sizes(static_cast<std::size_t>(this->Count));
  for (const auto& message : messages)
  {
    sizes[static_cast<std::size_t>(message.first)] = static_cast<vtkIdType>(message.second.size());
  }
  sizes.push_back(static_cast<vtkIdType>(messages.size()));
  sizes = this->Sum(sizes);
  if (sizes.back() > 0)
  {
    // Where DIY lacks memory, the other processes would wait. So each tries it first.
    flipflop::Buffer<char>(static_cast<std::size_t>(sizes[static_cast<std::size_t>(this->Rank)]));
    this->Agree();
    exchangeByDIY(this->Controller, messages);
  }
  return sizes.back();
}

//------------------------------------------------------------------------------
vtkIdType FFProcesses::Query(
  Messages& messages, const std::function<Message(const Message&)>& reply)
{
  const vtkIdType count = this->Exchange(messages);
  for (auto& message : messages)
  {
    message.second = reply(message.second);
  }
  this->Exchange(messages);
  return count;
}

//------------------------------------------------------------------------------
std::vector<FFProcesses::Message> FFProcesses::GatherMessages(const Message& own)
{
  this->Agree();
  const auto size = static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> sizes(static_cast<std::size_t>(this->Count));
  this->Controller->AllGather(&size, sizes.data(), 1);
  std::vector<vtkIdType> begins{ 0 };
  std::partial_sum(sizes.begin(), sizes.end(), std::back_inserter(begins));
  if (begins.back() > VTK_INT_MAX) // of bytes, which MPI counts by ints
  {
    throw flipflop::Error(flipflop::ErrorCode::OutOfMemory, -1, begins.back());
  }
  Message all(static_cast<std::size_t>(begins.back()));
  this->Agree(); // all have the memory
  this->Controller->AllGatherV(own.data(), all.data(), size, sizes.data(), begins.data());
  std::vector<Message> messages;
  for (std::size_t process = 0; process < sizes.size(); ++process)
  {
    messages.emplace_back(all.begin() + begins[process], all.begin() + begins[process + 1]);
  }
  return messages;
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> FFProcesses::Sum(std::vector<vtkIdType> values)
{
  this->Agree();
  return reduce(this->Controller, values, vtkCommunicator::SUM_OP);
}

//------------------------------------------------------------------------------
std::vector<double> FFProcesses::Least(std::vector<double> values)
{
  this->Agree();
  return reduce(this->Controller, values, vtkCommunicator::MIN_OP);
}

//------------------------------------------------------------------------------
void FFProcesses::Broadcast(void* data, std::size_t size, int process)
{
  this->Controller->Broadcast(static_cast<char*>(data), static_cast<vtkIdType>(size), process);
}
VTK_ABI_NAMESPACE_END
