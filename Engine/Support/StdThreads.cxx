// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/StdThreads.h"

#include "Support/FloatingPointEnvironment.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

// Whether each part of a loop takes its tasks by a fixed pattern. Else parts take the next that
// is left, which is fairer; but then the first thread to wake may take all, and ThreadSanitizer
// sees no race in what one thread does alone.
#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define FLIPFLOP_FIXED_TASKS 1
#endif
#endif
#if !defined(FLIPFLOP_FIXED_TASKS) && defined(__SANITIZE_THREAD__)
#define FLIPFLOP_FIXED_TASKS 1
#endif
#ifndef FLIPFLOP_FIXED_TASKS
#define FLIPFLOP_FIXED_TASKS 0
#endif

namespace flipflop
{

namespace stdThreads
{

namespace
{

/// A loop under way. Its atomics are relaxed on purpose: stronger ones would order the tasks'
/// memory accesses, and hide races from ThreadSanitizer.
class Fork
{
public:
  Fork(std::size_t calls, const std::function<void(std::size_t)>& called)
    : count(calls)
    , body(called)
  {
  }

  /// Before any part begins.
  void split(std::size_t number)
  {
    this->parts = number;
    this->next.store(number, std::memory_order_relaxed);
    this->pending = number - 1;
  }

  void run(std::size_t part) noexcept
  {
    try
    {
      for (std::size_t i = part; i < this->count && !this->failed.load(std::memory_order_relaxed);
           i = this->after(i))
      {
        this->body(i);
      }
    }
    catch (...)
    {
      this->failed.store(true, std::memory_order_relaxed);
      const std::lock_guard<std::mutex> lock(this->mutex);
      if (!this->error)
      {
        this->error = std::current_exception();
      }
    }
  }

  /// One of the parts that others run has ended. The lock is held to the last: as soon as it is
  /// free, the fork may be gone.
  void partEnded()
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    if (--this->pending == 0)
    {
      this->ended.notify_one();
    }
  }

  /// Waits for the parts that others run.
  void join()
  {
    std::unique_lock<std::mutex> lock(this->mutex);
    this->ended.wait(lock, [this] { return this->pending == 0; });
  }

  /// Throws what one of the tasks threw.
  void check() const
  {
    if (this->error)
    {
      std::rethrow_exception(this->error);
    }
  }

private:
  std::size_t after(std::size_t i)
  {
    return FLIPFLOP_FIXED_TASKS ? i + this->parts
                                : this->next.fetch_add(1, std::memory_order_relaxed);
  }

  const std::size_t count;
  const std::function<void(std::size_t)>& body;
  std::size_t parts = 1;
  std::atomic<std::size_t> next{ 1 };
  std::atomic<bool> failed{ false };
  std::mutex mutex;
  std::condition_variable ended;
  std::size_t pending = 0;
  std::exception_ptr error;
};

class Crew;

/// The crew of the arena that this thread works in.
Crew*& current()
{
  thread_local Crew* crew = nullptr;
  return crew;
}

/// A thread, started when it is first claimed.
class Worker
{
public:
  Worker() = default;
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker()
  {
    if (this->thread.joinable())
    {
      {
        const std::lock_guard<std::mutex> lock(this->mutex);
        this->ends = true;
      }
      this->assigned.notify_one();
      this->thread.join();
    }
  }

  /// @return false when it is another loop's, or there is no thread to be had. Else give() and,
  ///         when the loop has ended, release() have to follow.
  bool claim(Crew& crew)
  {
    if (this->busy.load(std::memory_order_relaxed) ||
      this->busy.exchange(true, std::memory_order_relaxed))
    {
      return false;
    }
    const std::lock_guard<std::mutex> lock(this->mutex);
    if (!this->thread.joinable())
    {
      try
      {
        this->thread = std::thread([this, &crew] { this->work(crew); });
      }
      catch (const std::exception&)
      {
        this->busy.store(false, std::memory_order_relaxed);
        return false;
      }
    }
    return true;
  }

  void assign(Fork& loop, std::size_t part)
  {
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      this->next = { &loop, part };
    }
    this->assigned.notify_one();
  }

  void release() { this->busy.store(false, std::memory_order_relaxed); }

private:
  struct Job
  {
    Fork* fork;
    std::size_t part;
  };

  void work(Crew& crew)
  {
    current() = &crew;
    const DefaultFloatingPointEnvironment environment;
    for (Job job = this->wait(); job.fork; job = this->wait())
    {
      job.fork->run(job.part);
      job.fork->partEnded();
    }
  }

  /// @return a fork; or none: it is over
  Job wait()
  {
    std::unique_lock<std::mutex> lock(this->mutex);
    this->assigned.wait(lock, [this] { return this->next.fork || this->ends; });
    return std::exchange(this->next, {});
  }

  std::atomic<bool> busy{ false };
  std::mutex mutex;
  std::condition_variable assigned;
  Job next = { nullptr, 0 };
  bool ends = false;
  std::thread thread;
};

/// The threads of an arena, without the one that entered it.
class Crew
{
public:
  explicit Crew(int threads)
    : workers(static_cast<std::size_t>(std::max(threads, 1) - 1))
  {
  }

  void run(std::size_t count, const std::function<void(std::size_t)>& body)
  {
    Fork loop(count, body);
    std::vector<Worker*> claimed;
    claimed.reserve(std::min(count - 1, this->workers.size()));
    for (auto worker = this->workers.begin();
         worker != this->workers.end() && claimed.size() + 1 < count; ++worker)
    {
      if (worker->claim(*this))
      {
        claimed.push_back(&*worker);
      }
    }
    loop.split(claimed.size() + 1);
    for (std::size_t i = 0; i < claimed.size(); ++i)
    {
      claimed[i]->assign(loop, i + 1);
    }
    loop.run(0);
    loop.join();
    // Only now: if a thread went on to another loop before the end of this one, ThreadSanitizer
    // would take the two loops for ordered.
    for (Worker* const worker : claimed)
    {
      worker->release();
    }
    loop.check();
  }

private:
  std::vector<Worker> workers;
};

/// As many threads as the machine has, but for an Allowance.
std::atomic<int>& limit()
{
  static std::atomic<int> threads{ std::max(
    1, static_cast<int>(std::thread::hardware_concurrency())) };
  return threads;
}

}

void Arena::run(const std::function<void()>& body) const
{
  struct Enter
  {
    explicit Enter(int threads)
      : crew(threads)
      , before(std::exchange(current(), &this->crew))
    {
    }
    ~Enter() { current() = this->before; }

    Crew crew;
    Crew* const before;
  };
  const Enter enter(this->threads);
  body();
}

int allowed()
{
  return limit().load();
}

Allowance::Allowance(int threads)
  : before(limit().exchange(std::max(1, threads)))
{
}

Allowance::~Allowance()
{
  limit().store(this->before);
}

void fork(std::size_t count, const std::function<void(std::size_t)>& body)
{
  if (count == 0)
  {
    return;
  }
  if (Crew* const crew = current())
  {
    crew->run(count, body);
    return;
  }
  Arena(allowed()).execute([&] { fork(count, body); });
}

}

}
