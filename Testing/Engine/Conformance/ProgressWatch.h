// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A progress function that remembers what it was told, and asks to stop when told to.
#ifndef flipflop_test_ProgressWatch_h
#define flipflop_test_ProgressWatch_h

#include <flipflop/Error.h>
#include <flipflop/Options.h>

#include <gtest/gtest.h>

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

  static bool see(double fraction, void* context)
  {
    Watch& watch = *static_cast<Watch*>(context);
    watch.elsewhere = watch.elsewhere || std::this_thread::get_id() != watch.caller;
    watch.fractions.push_back(fraction);
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

/// A run reports in order, so often at least; stopped at any of its reports, it ends there.
/// @param run void (const Options&)
template <class Run>
void expectProgress(const Run& run, int threads, std::size_t least = 1)
{
  SCOPED_TRACE(std::to_string(threads) + " threads");
  Watch whole;
  run(whole.options(threads));
  whole.expectOrder();
  ASSERT_GE(whole.fractions.size(), least);
  const int reports = static_cast<int>(whole.fractions.size());
  for (const int stopAt : { 1, 2, 5, reports / 2, reports })
  {
    Watch watch;
    watch.stopAt = stopAt;
    bool aborted = false;
    try
    {
      run(watch.options(threads));
    }
    catch (const Error& error)
    {
      ASSERT_EQ(error.code(), ErrorCode::Aborted) << error.what();
      aborted = true;
    }
    // Time passes between reports, so their number varies from run to run.
    const int seen = static_cast<int>(watch.fractions.size());
    EXPECT_EQ(aborted, stopAt > 0 && seen >= stopAt) << "stop at " << stopAt;
    EXPECT_TRUE(!aborted || seen == stopAt) << "called after the stop";
    EXPECT_TRUE(aborted || stopAt != 1 || reports == 0) << "the first report may stop it";
    watch.expectOrder();
  }
}

}
}

#endif
