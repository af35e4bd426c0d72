// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Stream.h"

#include "Memory.h"

#include <atomic>
#include <chrono>
#include <utility>

namespace
{

/// Another one for each stream, the same in each run.
unsigned int nextSeed()
{
  static std::atomic<unsigned int> number{ 0 };
  return static_cast<unsigned int>(standin::setting("STANDIN_SEED", 1)) + 977 * number++;
}

}

CUstream_st::CUstream_st(int ofDevice)
  : device(ofDevice)
  , random(nextSeed())
  , thread([this] { this->run(); })
{
}

CUstream_st::~CUstream_st()
{
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    this->isOver = true;
  }
  this->given.notify_all();
  this->thread.join();
}

void CUstream_st::give(std::function<void()> work)
{
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    this->queue.push_back(std::move(work));
  }
  this->given.notify_all();
}

void CUstream_st::wait()
{
  std::unique_lock<std::mutex> lock(this->mutex);
  this->idle.wait(lock, [this] { return this->queue.empty() && !this->isBusy; });
}

void CUstream_st::run()
{
  static const auto most =
    static_cast<unsigned int>(standin::setting("STANDIN_LAG_MICROSECONDS", 20));
  std::unique_lock<std::mutex> lock(this->mutex);
  while (true)
  {
    this->given.wait(lock, [this] { return this->isOver || !this->queue.empty(); });
    if (this->queue.empty())
    {
      return;
    }
    const std::function<void()> work = std::move(this->queue.front());
    this->queue.pop_front();
    this->isBusy = true;
    lock.unlock();
    if (most > 0)
    {
      std::this_thread::sleep_for(std::chrono::microseconds(this->random() % most));
    }
    work();
    lock.lock();
    this->isBusy = false;
    if (this->queue.empty())
    {
      this->idle.notify_all();
    }
  }
}

void CUevent_st::record(CUstream_st& stream)
{
  long number = 0;
  {
    const std::lock_guard<std::mutex> lock(this->state->mutex);
    number = ++this->state->recorded;
  }
  stream.give(
    [own = this->state, number]
    {
      const std::lock_guard<std::mutex> lock(own->mutex);
      own->done = number;
      own->reached.notify_all();
    });
}

void CUevent_st::wait()
{
  const std::shared_ptr<State> own = this->state;
  std::unique_lock<std::mutex> lock(own->mutex);
  const long number = own->recorded;
  own->reached.wait(lock, [&] { return own->done >= number; });
}
