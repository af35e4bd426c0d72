// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFProcesses.h"

#include "FFRun.h"

#include <flipflop/Buffer.h>

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#if FLIPFLOP_USE_DIY
#include "vtkDIYUtilities.h"
#endif

#include <exception>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

constexpr int tagOfValues = 7701;

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
bool FFProcesses::Do(const std::function<void()>& work)
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
  return !isShared && this->Share();
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
bool FFProcesses::Share()
{
  FFFailure& failure = this->Run.Failure;
  this->Run.NoteAbort();
  constexpr std::size_t size = 5;
  const vtkIdType own[size] = { failure.Kind, failure.Point, failure.Count,
    static_cast<vtkIdType>(failure.Code), static_cast<vtkIdType>(failure.Message.size()) };
  std::vector<vtkIdType> all(size * static_cast<std::size_t>(this->Count));
  this->Controller->AllGather(own, all.data(), size);
  FFFailure together;
  int reporter = 0; // the process whose message it is
  vtkIdType length = 0;
  for (int process = 0; process < this->Count; ++process)
  {
    const vtkIdType* const values = all.data() + size * static_cast<std::size_t>(process);
    const FFFailure::KindType before = together.Kind;
    together.Add({ static_cast<FFFailure::KindType>(values[0]), values[1], values[2],
      static_cast<unsigned long>(values[3]), {} });
    if (together.Kind != before)
    {
      reporter = process;
      length = values[4];
    }
  }
  if (together.Kind == FFFailure::Other)
  {
    together.Message = failure.Message;
    together.Message.resize(static_cast<std::size_t>(length));
    this->Controller->Broadcast(&together.Message[0], length, reporter);
  }
  failure = together;
  return !failure;
}

//------------------------------------------------------------------------------
void FFProcesses::Exchange(Messages& messages)
{
  FFRun::Look(this->Run.Options);
  std::vector<vtkIdType> sizes(static_cast<std::size_t>(this->Count));
  for (const auto& message : messages)
  {
    sizes[static_cast<std::size_t>(message.first)] = static_cast<vtkIdType>(message.second.size());
  }
  sizes.push_back(static_cast<vtkIdType>(messages.size()));
  sizes = this->Sum(sizes);
  this->NumberOfMessages = sizes.back();
  if (this->NumberOfMessages == 0)
  {
    return;
  }
  // Where DIY lacks memory, the other processes would wait. So each tries it first.
  flipflop::Buffer<char>(static_cast<std::size_t>(sizes[static_cast<std::size_t>(this->Rank)]));
  this->Agree();
  exchangeByDIY(this->Controller, messages);
}

//------------------------------------------------------------------------------
std::vector<std::vector<vtkIdType>> FFProcesses::Gather(const std::vector<vtkIdType>& values)
{
  this->Agree();
  const auto count = static_cast<std::size_t>(this->Count);
  const auto size = static_cast<vtkIdType>(values.size());
  std::vector<vtkIdType> sizes(count);
  this->Controller->AllGather(&size, sizes.data(), 1);
  std::vector<vtkIdType> begins{ 0 };
  for (const vtkIdType other : sizes)
  {
    begins.push_back(begins.back() + other);
  }
  std::vector<vtkIdType> all(static_cast<std::size_t>(begins.back()));
  this->Controller->AllGatherV(values.data(), all.data(), size, sizes.data(), begins.data());
  std::vector<std::vector<vtkIdType>> lists;
  for (std::size_t process = 0; process < count; ++process)
  {
    lists.emplace_back(all.begin() + begins[process], all.begin() + begins[process + 1]);
  }
  return lists;
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> FFProcesses::Sum(std::vector<vtkIdType> values)
{
  this->Agree();
  return reduce(this->Controller, values, vtkCommunicator::SUM_OP);
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> FFProcesses::Least(std::vector<vtkIdType> values)
{
  this->Agree();
  return reduce(this->Controller, values, vtkCommunicator::MIN_OP);
}

//------------------------------------------------------------------------------
std::vector<double> FFProcesses::Least(std::vector<double> values)
{
  this->Agree();
  return reduce(this->Controller, values, vtkCommunicator::MIN_OP);
}

//------------------------------------------------------------------------------
void FFProcesses::PassOn(std::vector<double>& values, const std::function<void()>& change)
{
  this->Agree();
  const auto size = static_cast<vtkIdType>(values.size());
  if (this->Rank > 0)
  {
    this->Controller->Receive(values.data(), size, this->Rank - 1, tagOfValues);
  }
  std::exception_ptr error; // is thrown when nobody waits any more
  try
  {
    change();
  }
  catch (...)
  {
    error = std::current_exception();
  }
  if (this->Rank + 1 < this->Count)
  {
    this->Controller->Send(values.data(), size, this->Rank + 1, tagOfValues);
  }
  this->Controller->Broadcast(values.data(), size, this->Count - 1);
  if (error)
  {
    std::rethrow_exception(error);
  }
}
VTK_ABI_NAMESPACE_END
