// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What one thread does, as the tasks that several threads would share: a tree of forks and joins.
///
/// RecordedThreads.h stands in for a library of threads. It runs every task here and now, one after
/// another, and tells it to the Recording under way. Where there is none, it runs the tasks alone.
#ifndef flipflop_tasks_Recording_h
#define flipflop_tasks_Recording_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <vector>

namespace flipflop_tasks
{

struct Fork;

/// What runs in one go but for its forks: a stretch of time, a fork, a stretch, ..., a stretch.
struct Task
{
  std::vector<std::int64_t> stretches{ 0 }; ///< nanoseconds; one more than forks
  std::vector<Fork> forks;
};

/// A parallel call.
struct Place
{
  const char* kind; ///< "for", "invoke" or "sort"
  const char* file;
  int line;
  const char* function;
  const char* body; ///< its type's name: it tells who called a function that only passes bodies on
};

/// Tasks that may run at the same time; what follows waits for all of them.
struct Fork
{
  Place place;
  std::size_t calls; ///< of a loop's body; elements sorted
  std::vector<Task> tasks;
};

/// Records what its thread does from begin() to end(). One at a time in a thread.
class Recording
{
public:
  /// @param threads how many threads the program is told that it has
  explicit Recording(int threads)
    : threads(threads)
  {
  }
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  ~Recording() { this->end(); }

  void begin()
  {
    this->run = Task();
    this->task = &this->run;
    current() = this;
    allowed() = this->threads;
    this->since = now();
  }

  void end()
  {
    if (current() == this)
    {
      this->lap();
      current() = nullptr;
      allowed() = 1;
    }
  }

  const Task& result() const { return this->run; }

  /// This thread's, or null.
  static Recording*& current()
  {
    thread_local Recording* recording = nullptr;
    return recording;
  }

  /// How many threads the arena has that this thread works in.
  static int& allowed()
  {
    thread_local int threads = 1;
    return threads;
  }

  /// body(0), ..., body(count - 1), each recorded as a task.
  template <class Body>
  void fork(const Place& place, std::size_t calls, std::size_t count, const Body& body)
  {
    this->lap();
    Task& parent = *this->task;
    parent.forks.push_back({ place, calls, {} });
    std::vector<Task>& tasks = parent.forks.back().tasks;
    tasks.reserve(count); // tasks stay where they are
    const Back back = { *this, parent };
    for (std::size_t i = 0; i < count; ++i)
    {
      tasks.emplace_back();
      this->task = &tasks.back();
      body(i);
      this->lap();
    }
  }

private:
  /// The fork ends, be it by an exception, and its task goes on.
  struct Back
  {
    Recording& recording;
    Task& parent;
    ~Back()
    {
      this->recording.lap();
      this->parent.stretches.push_back(0);
      this->recording.task = &this->parent;
    }
  };

  /// This thread's own time: what others do to the machine meanwhile is not the program's.
  static std::int64_t now()
  {
    std::timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<std::int64_t>(time.tv_sec) * 1000000000 + time.tv_nsec;
  }

  /// The time since the last lap is the current task's.
  void lap()
  {
    const std::int64_t time = now();
    this->task->stretches.back() += time - this->since;
    this->since = time;
  }

  const int threads;
  Task run;
  Task* task = nullptr;
  std::int64_t since = 0;
};

/// run(0), ..., run(count - 1): tasks where there are threads for them, and a Recording to tell.
template <class Run>
void fork(const Place& place, std::size_t calls, std::size_t count, const Run& run)
{
  Recording* const recording = Recording::current();
  if (recording && Recording::allowed() > 1 && count > 0)
  {
    recording->fork(place, calls, count, run);
    return;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    run(i);
  }
}

/// Into how many tasks so many calls of a loop's body are cut. oneTBB begins with four a thread and
/// cuts on where others have nothing left to do; twice as many stand for that.
inline std::size_t tasksOf(std::size_t calls)
{
  return std::min(calls, 8 * static_cast<std::size_t>(Recording::allowed()));
}

}

#endif
