// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The MPI processes of a distributed filter: messages, sums, one failure for all.
 *
 * The methods are collective, unless stated otherwise: every process calls them, in the same order,
 * within Do(). Each begins with Agree(). So any process may throw anywhere in Do(): it stops the
 * others at their next collective call, and none waits for another.
 *
 * Numbers are sent as they are in memory, between machines of one kind. DIY carries the messages.
 */

#ifndef FFProcesses_h
#define FFProcesses_h

#include "vtkFFMarks.h"
#include "vtkType.h"

#include <cstddef>
#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class FFRun;
class vtkMultiProcessController;

/**
 * Thrown on all processes at the same step, where the run of each has the failure of all.
 */
struct FFSharedFailure
{
};

class FFProcesses
{
public:
  /**
   * A message, and messages to or from processes, this one too, by their ranks.
   */
  using Message = std::vector<char>;
  using Messages = std::map<int, Message>;

  ///@{
  /**
   * Append plain values to a message; get all values of a message.
   */
  template <class T>
  static void Append(const T* values, std::size_t count, Message& message)
  {
    static_assert(std::is_trivially_copyable<T>::value, "only plain values can be sent");
    const char* bytes = reinterpret_cast<const char*>(values);
    message.insert(message.end(), bytes, bytes + count * sizeof(T));
  }
  template <class T>
  static std::vector<T> ValuesOf(const Message& message)
  {
    static_assert(std::is_trivially_copyable<T>::value, "only plain values can be sent");
    std::vector<T> values(message.size() / sizeof(T));
    if (!values.empty())
    {
      std::memcpy(values.data(), message.data(), values.size() * sizeof(T));
    }
    return values;
  }
  ///@}

  ///@{
  /**
   * Whether a controller, which may be null, has several processes; and why these cannot exchange
   * messages, as an error says it (empty: they can). Not collective.
   */
  static bool AreSeveral(vtkMultiProcessController* controller);
  static std::string FindObstacle(vtkMultiProcessController* controller);
  ///@}

  /**
   * Several processes without an obstacle. The run gets their failure.
   */
  FFProcesses(vtkMultiProcessController* controller, FFRun& run);

  ///@{
  /**
   * How many processes there are, which this is, and its run. Not collective.
   */
  int GetCount() const { return this->Count; }
  int GetRank() const { return this->Rank; }
  FFRun& GetRun() const { return this->Run; }
  ///@}

  /**
   * Run work with collective steps. What it throws on any process is the failure of all.
   */
  void Do(const std::function<void()>& work);

  /**
   * Share the failures, and requests to abort, of all processes.
   *
   * @throw FFSharedFailure if there is any; so do all collective methods that follow.
   */
  void Agree();

  /**
   * Fail for a reason that all processes see. Not collective.
   *
   * @throw FFSharedFailure
   */
  void Fail(const std::string& message);

  /**
   * Send all messages; they become those that other processes sent to this one. Returns how many
   * all processes sent.
   */
  vtkIdType Exchange(Messages& messages);

  /**
   * The same, and each is answered at once: they become the replies of those that received them.
   */
  vtkIdType Query(Messages& messages, const std::function<Message(const Message&)>& reply);

  /**
   * The values of each process, which may differ in number.
   */
  template <class T>
  std::vector<std::vector<T>> Gather(const std::vector<T>& values)
  {
    Message own;
    Append(values.data(), values.size(), own);
    std::vector<std::vector<T>> lists;
    for (const Message& message : this->GatherMessages(own))
    {
      lists.push_back(ValuesOf<T>(message));
    }
    return lists;
  }

  ///@{
  /**
   * The sums, or the least, of all processes' values, which are as many on each.
   */
  std::vector<vtkIdType> Sum(std::vector<vtkIdType> values);
  vtkIdType Sum(vtkIdType value) { return this->Sum(std::vector<vtkIdType>{ value })[0]; }
  std::vector<double> Least(std::vector<double> values);
  ///@}

  /**
   * One process after another changes a plain value that the one before it leaves. All get that of
   * the last one.
   */
  template <class T>
  void PassOn(T& value, const std::function<void()>& change)
  {
    static_assert(std::is_trivially_copyable<T>::value, "only plain values can be sent");
    for (int process = 0; process < this->Count; ++process)
    {
      if (process == this->Rank)
      {
        change();
      }
      this->Agree();
      this->Broadcast(&value, sizeof(T), process);
    }
  }

private:
  bool Share();
  std::vector<Message> GatherMessages(const Message& own);
  void Broadcast(void* data, std::size_t size, int process);

  vtkMultiProcessController* const Controller;
  FFRun& Run;
  const int Count;
  const int Rank;
};
VTK_ABI_NAMESPACE_END

#endif
