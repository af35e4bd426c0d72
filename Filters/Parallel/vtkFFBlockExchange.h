// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFBlockExchange
 * @brief   messages between the blocks of distributed data, by DIY
 *
 * vtkFFBlockExchange is the way by which the processes of a filter exchange bytes: each has one
 * block of DIY's, and any block may write to any other. An exchange is the same for all processes:
 * they come to it together, and leave it together. What they do between two exchanges is guarded.
 * The failure of one process is the failure of all before the next exchange begins: then there is
 * none, and nobody waits.
 */

#ifndef vtkFFBlockExchange_h
#define vtkFFBlockExchange_h

#include "vtkFFMarks.h"
#include "vtkFFParcel.h"
#include "vtkFFProcesses.h"

#include <cstddef>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <type_traits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkFFRun;
class vtkMultiProcessController;

/**
 * Thrown on all processes at the same step, where one of them has a failure. It is the run's.
 */
struct vtkFFSharedFailure
{
};

class vtkFFBlockExchange
{
public:
  /**
   * Messages to or from others (or to the own process), by the number of the process.
   */
  using Messages = std::map<int, std::vector<char>>;

  //@{
  /**
   * Plain values as bytes of a message: added to its end; and all that it holds. They are sent as
   * they are in memory, between machines of one kind.
   *
   * @throw vtkFFDamagedParcel for a message that is not a number of such values.
   */
  template <class T>
  static void Add(const T* values, std::size_t count, std::vector<char>& message)
  {
    static_assert(std::is_trivially_copyable<T>::value, "only plain values can be sent");
    const char* bytes = reinterpret_cast<const char*>(values);
    message.insert(message.end(), bytes, bytes + count * sizeof(T));
  }
  template <class T>
  static std::vector<T> Values(const std::vector<char>& message)
  {
    static_assert(std::is_trivially_copyable<T>::value, "only plain values can be sent");
    if (message.size() % sizeof(T) != 0)
    {
      throw vtkFFDamagedParcel();
    }
    std::vector<T> values(message.size() / sizeof(T));
    if (!values.empty())
    {
      std::memcpy(values.data(), message.data(), message.size());
    }
    return values;
  }
  //@}

  /**
   * Why DIY cannot exchange messages between the processes of a controller: a clause. Empty if it
   * can. It is the same on all processes.
   */
  static std::string FindObstacle(vtkMultiProcessController* controller);

  /**
   * The processes of a controller to which there is no obstacle. The failure is the run's.
   */
  vtkFFBlockExchange(vtkMultiProcessController* controller, vtkFFRun& run);
  ~vtkFFBlockExchange();
  vtkFFBlockExchange(const vtkFFBlockExchange&) = delete;
  void operator=(const vtkFFBlockExchange&) = delete;

  vtkFFProcesses& GetProcesses() { return this->Processes; }

  /**
   * Work that needs no other process. What it throws is this process's failure; after one, nothing
   * more is done.
   */
  void Do(const std::function<void()>& work);

  /**
   * Come to know whether another process has a failure. Collective, as is the next function.
   *
   * @throw vtkFFSharedFailure on all processes, if any has one.
   */
  void Agree();

  /**
   * Send all messages, and have those that others sent to this process instead.
   *
   * @throw vtkFFSharedFailure on all processes, if any has a failure: then nothing was sent.
   */
  void Exchange(Messages& messages);

  /**
   * How many messages all processes sent in the last exchange.
   */
  vtkIdType GetNumberOfMessages() const { return this->NumberOfMessages; }

private:
  class Blocks;

  vtkFFRun& Run;
  vtkFFProcesses Processes;
  std::unique_ptr<Blocks> Own;
  vtkIdType NumberOfMessages = 0;
};
VTK_ABI_NAMESPACE_END

#endif
