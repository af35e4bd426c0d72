// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A progress function that remembers what it was told, and asks to stop when told to.
#ifndef flipflop_test_ProgressWatch_h
#define flipflop_test_ProgressWatch_h

#include <flipflop/Options.h>

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace flipflop
{
namespace test
{

/// What the progress function saw. It runs on the calling thread alone, so plain values do:
/// TSan would tell otherwise.
struct Watch
{
  std::thread::id caller = std::this_thread::get_id();
  std::vector<double> fractions;
  std::vector<std::string> steps;
  bool elsewhere = false;
  int stopAt = 0; ///< the call that asks to stop; 0: none
  std::chrono::steady_clock::time_point stopped;

  static bool see(double fraction, void* context)
  {
    Watch& watch = *static_cast<Watch*>(context);
    watch.elsewhere = watch.elsewhere || std::this_thread::get_id() != watch.caller;
    watch.fractions.push_back(fraction);
    watch.stopped = std::chrono::steady_clock::now();
    return static_cast<int>(watch.fractions.size()) != watch.stopAt;
  }

  static void enter(const char* name, void* context)
  {
    Watch& watch = *static_cast<Watch*>(context);
    watch.elsewhere = watch.elsewhere || std::this_thread::get_id() != watch.caller;
    watch.steps.emplace_back(name);
  }

  Options options(int threads)
  {
    Options result;
    result.threads = threads;
    result.progress = see;
    result.progressContext = this;
    result.step = enter;
    return result;
  }

  void expectOrder() const
  {
    EXPECT_FALSE(this->elsewhere) << "called on another thread";
    double last = 0;
    for (double fraction : this->fractions)
    {
      EXPECT_GE(fraction, last);
      EXPECT_LE(fraction, 1);
      last = fraction;
    }
  }
};

}
}

#endif
