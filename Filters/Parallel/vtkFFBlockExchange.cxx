// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFBlockExchange.h"

#include "vtkFFRun.h"

#include <flipflop/Buffer.h>

#include "vtkMultiProcessController.h"

#if FLIPFLOP_USE_DIY
#include "vtkDIYUtilities.h"
#endif

#include <cstddef>
#include <numeric>
#include <string>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
#if FLIPFLOP_USE_DIY

//------------------------------------------------------------------------------
class vtkFFBlockExchange::Blocks
{
public:
  explicit Blocks(vtkMultiProcessController* controller)
    : Master(vtkDIYUtilities::GetCommunicator(controller))
  {
    // A block for each process. Messages go to any of them, so none has neighbours.
    this->Master.add(this->Master.communicator().rank(), this, new diy::Link);
  }

  /// Hand messages over.
  void Put(Messages& messages)
  {
    const auto sender = this->Master.proxy(0);
    for (auto& message : messages)
    {
      sender.enqueue(diy::BlockID{ message.first, message.first }, message.second);
      std::vector<char>().swap(message.second);
    }
  }

  /// Send what was put, and receive. Collective.
  void Exchange() { this->Master.exchange(true); }

  /// What was received.
  void Take(Messages& messages)
  {
    const auto receiver = this->Master.proxy(0);
    std::vector<int> senders;
    receiver.incoming(senders);
    for (const int from : senders)
    {
      receiver.dequeue(from, messages[from]);
      receiver.incoming(from).wipe();
    }
  }

private:
  diy::Master Master;
};

//------------------------------------------------------------------------------
std::string vtkFFBlockExchange::FindObstacle(vtkMultiProcessController* controller)
{
  // Others can send as well, but DIY does not know them.
  return controller->IsA("vtkMPIController")
    ? std::string()
    : std::string("only processes of MPI work together, and the controller is a ") +
      controller->GetClassName();
}

#else

//------------------------------------------------------------------------------
class vtkFFBlockExchange::Blocks // is never made, for the reason given below
{
public:
  explicit Blocks(vtkMultiProcessController*) {}
  void Put(Messages&) {}
  void Exchange() {}
  void Take(Messages&) {}
};

//------------------------------------------------------------------------------
std::string vtkFFBlockExchange::FindObstacle(vtkMultiProcessController*)
{
  return "only processes of MPI work together, and this build has none";
}

#endif

//------------------------------------------------------------------------------
vtkFFBlockExchange::vtkFFBlockExchange(vtkMultiProcessController* controller, vtkFFRun& run)
  : Run(run)
  , Processes(controller)
  , Own(std::make_unique<Blocks>(controller))
{
}

//------------------------------------------------------------------------------
vtkFFBlockExchange::~vtkFFBlockExchange() = default;

//------------------------------------------------------------------------------
void vtkFFBlockExchange::Do(const std::function<void()>& work)
{
  this->Run.Do(work);
}

//------------------------------------------------------------------------------
void vtkFFBlockExchange::Agree()
{
  this->Run.NoteAbort();
  if (!this->Processes.Share(this->Run.Failure))
  {
    throw vtkFFSharedFailure();
  }
}

//------------------------------------------------------------------------------
void vtkFFBlockExchange::Exchange(Messages& messages)
{
  // All know what is to come, and have the memory for it: if DIY had not, it would not tell the
  // others.
  std::vector<vtkIdType> sizes(static_cast<std::size_t>(this->Processes.GetCount()) + 1);
  if (!this->Run.Failure)
  {
    for (const auto& message : messages)
    {
      sizes[static_cast<std::size_t>(message.first)] +=
        static_cast<vtkIdType>(message.second.size());
      ++sizes.back();
    }
  }
  sizes = this->Processes.Sum(sizes);
  this->NumberOfMessages = sizes.back();
  this->Do(
    [&]
    {
      const auto own = static_cast<std::size_t>(this->Processes.GetRank());
      const flipflop::Buffer<char> room(static_cast<std::size_t>(sizes[own]));
      this->Own->Put(messages);
    });
  this->Agree();
  messages.clear();
  if (this->NumberOfMessages > 0)
  {
    this->Own->Exchange();
    this->Do([&] { this->Own->Take(messages); });
  }
}
VTK_ABI_NAMESPACE_END
