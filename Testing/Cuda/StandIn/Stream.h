// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The stand-in's streams and events. A stream is a thread that lags behind by a random time, so
/// who does not wait for it sees what was there before.
#ifndef flipflop_standin_Stream_h
#define flipflop_standin_Stream_h

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <random>
#include <thread>

/// The names that cuda_runtime.h has for what the handles point at.
struct CUstream_st
{
public:
  explicit CUstream_st(int ofDevice);
  ~CUstream_st();
  CUstream_st(const CUstream_st&) = delete;
  CUstream_st& operator=(const CUstream_st&) = delete;

  const int device;

  /// To be done after all that was given before.
  void give(std::function<void()> work);
  /// Wait until nothing is left to do.
  void wait();

private:
  void run();

  std::mutex mutex;
  std::condition_variable given;
  std::condition_variable idle;
  std::deque<std::function<void()>> queue;
  bool isBusy = false;
  bool isOver = false;
  std::mt19937 random;
  std::thread thread;
};

struct CUevent_st
{
public:
  void record(CUstream_st& stream);
  /// Until the last record is reached; at once where there is none.
  void wait();

private:
  /// It outlives an event that is destroyed before its record is reached.
  struct State
  {
    std::mutex mutex;
    std::condition_variable reached;
    long recorded = 0;
    long done = 0;
  };
  std::shared_ptr<State> state = std::make_shared<State>();
};

#endif
