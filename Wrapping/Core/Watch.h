// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a run of the engine and Python owe each other: the run gives the interpreter free, reports
/// its progress to a callable, and stops at Ctrl-C or at the callable's word. What the callable
/// raises is what the call raises.
#ifndef flipflop_Watch_h
#define flipflop_Watch_h

#include <flipflop/Error.h>
#include <flipflop/Options.h>

#include <nanobind/nanobind.h>

#include <chrono>
#include <optional>
#include <utility>

namespace flipflop
{

/// Watches one run. Made and destroyed by a thread that holds the interpreter.
class Watch
{
public:
  /// @param toReport a callable of the fraction that is done, 0 to 1, which stops the run by
  /// returning False; or None
  explicit Watch(nanobind::object toReport)
    : report(std::move(toReport))
  {
  }

  /// Does the work with these options, and the interpreter free.
  /// @param options whose progress function is this watch's
  /// @throw Error   the engine's; nanobind::python_error if it was raised while the run was watched
  template <class Work>
  auto run(Options options, Work&& work)
  {
    options.progress = [](double fraction, void* self)
    { return static_cast<Watch*>(self)->goesOn(fraction); };
    options.progressContext = this;
    try
    {
      const nanobind::gil_scoped_release free;
      return work(options);
    }
    catch (const Error& error)
    {
      if (error.code() == ErrorCode::Aborted && this->raised)
      {
        throw std::move(*this->raised);
      }
      throw;
    }
  }

private:
  /// Python's False or NumPy's. Other callables return what they like: list.append() None, write()
  /// 0.
  static bool isFalse(const nanobind::object& result)
  {
    return result.is(Py_False) ||
      (nanobind::isinstance(result, nanobind::module_::import_("numpy").attr("bool_")) &&
        !nanobind::cast<bool>(nanobind::bool_(result)));
  }

  /// Taking the interpreter costs more than a small run.
  static constexpr std::chrono::milliseconds Between{ 20 };

  bool goesOn(double fraction)
  {
    const auto now = std::chrono::steady_clock::now();
    if (now - this->last < Between)
    {
      return true;
    }
    const nanobind::gil_scoped_acquire held;
    this->last = now;
    try
    {
      if (PyErr_CheckSignals() != 0)
      {
        throw nanobind::python_error();
      }
      return this->report.is_none() || !isFalse(this->report(fraction));
    }
    catch (nanobind::python_error& error)
    {
      this->raised.emplace(std::move(error));
      return false;
    }
  }

  nanobind::object report;
  std::chrono::steady_clock::time_point last = std::chrono::steady_clock::now();
  std::optional<nanobind::python_error> raised;
};

}

#endif
