// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"

#include "DeviceInputs.h"
#include "Testing/Cuda/Rounds/EngineRuns.h"
#include <flipflop/Engines.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <exception>
#include <limits>
#include <set>
#include <thread>

namespace flipflop
{
namespace test
{

namespace
{

constexpr std::int64_t Mebibyte = 1 << 20;

/// Stops a run at one of its calls.
struct Stopper
{
  int stopAt = 0; ///< 0: never
  std::vector<double> fractions;

  /// So slowly that the monitor, which calls some 50 times a second, has time for it after every
  /// round.
  static bool see(double fraction, void* context)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(21));
    auto& self = *static_cast<Stopper*>(context);
    self.fractions.push_back(fraction);
    return static_cast<int>(self.fractions.size()) != self.stopAt;
  }
  Options options()
  {
    Options result;
    result.progress = see;
    result.progressContext = this;
    return result;
  }
};

/// Scan, growth, flips or finish.
int stageOf(double fraction)
{
  return fraction < 0.1 ? 0 : fraction < 0.5 ? 1 : fraction < 0.85 ? 2 : 3;
}

/// Of a run's calls, the first, one in the middle and the last of each stage.
std::set<int> placesToStop(const std::vector<double>& fractions)
{
  std::set<int> places;
  for (int stage = 0; stage < 4; ++stage)
  {
    std::vector<int> calls;
    for (std::size_t i = 0; i < fractions.size(); ++i)
    {
      if (stageOf(fractions[i]) == stage)
      {
        calls.push_back(static_cast<int>(i) + 1);
      }
    }
    require(!calls.empty(), "stage " + std::to_string(stage) + " tells no progress");
    places.insert({ calls.front(), calls[calls.size() / 2], calls.back() });
  }
  return places;
}

void requireBytes(RoundsRunner& runner, std::int64_t before)
{
  const std::int64_t after = runner.bytesHeld();
  require(
    after <= before + 8 * Mebibyte, std::to_string(after - before) + " bytes are not given back");
}

/// A run stops where it is told to, leaves nothing behind, and the next is right.
void checkAborts(const Sides& sides, const DeviceInput& input)
{
  const RunResult wanted = runOnCpu(input.view(), Options());
  Stopper whole;
  require(
    difference(sides.subject.run(input.view(), whole.options()), wanted).empty(), "another result");
  const std::int64_t before = sides.subject.bytesHeld();
  std::set<int> stages;
  for (const int place : placesToStop(whole.fractions))
  {
    Stopper stopper;
    stopper.stopAt = place;
    const int code = codeOf([&] { sides.subject.run(input.view(), stopper.options()); });
    const auto calls = static_cast<int>(stopper.fractions.size());
    require(calls <= place, "told of progress after the stop");
    if (calls == place) // else the run had one call less this time
    {
      require(code == static_cast<int>(ErrorCode::Aborted),
        "not the error Aborted at call " + std::to_string(place));
      stages.insert(stageOf(stopper.fractions.back()));
    }
  }
  require(stages.size() == 4, "not every stage was stopped");
  requireBytes(sides.subject, before);
  require(difference(sides.subject.run(input.view(), Options()), wanted).empty(),
    "another result after the aborts");
}

/// Too little memory is a typed error, or the CPU's work, and does no lasting harm.
void checkShortage(const Sides& sides, const DeviceInput& drawn)
{
  const RunInput input = drawn.view();
  const RunResult wanted = runOnCpu(input, Options());
  RunSeen seen;
  require(difference(sides.subject.run(input, Options(), RunWatch(), &seen), wanted).empty(),
    "another result");
  const std::int64_t before = sides.subject.bytesHeld();
  for (const int percent : { 5, 15, 30, 60, 90 })
  {
    const std::int64_t bytes = std::max(8 * Mebibyte, seen.mostBytes / 100 * percent);
    const std::string when =
      "with " + std::to_string(bytes) + " bytes of " + std::to_string(seen.mostBytes) + ": ";
    const Holding held = sides.subject.leaveOnly(bytes);
    RunResult found;
    const int code = codeOf([&] { found = sides.subject.run(input, Options()); });
    require(code == static_cast<int>(ErrorCode::DeviceMemory) || (code == -1 && percent > 30),
      when + "not the error DeviceMemory but " + std::to_string(code));
    require(code != -1 || difference(found, wanted).empty(), when + "another result");
    if (!sides.subject.isOnDevice() || code == -1)
    {
      continue;
    }
    EngineOptions engine;
    EngineReport report;
    engine.choice = EngineChoice::CUDA;
    const auto runHull = [&]
    {
      found = RunResult();
      found.hull = convexHull(input.points, Options(), engine, report);
    };
    require(
      codeOf(runHull) == static_cast<int>(ErrorCode::DeviceMemory), when + "CUDA: another error");
    engine.choice = EngineChoice::Automatic;
    engine.cudaFrom = 0;
    require(codeOf(runHull) == -1, when + "Automatic: an error");
    require(difference(found, wanted).empty(), when + "Automatic: another result");
    require(report.used == EngineChoice::CPU && std::strstr(report.reason, "gave up"),
      when + "Automatic: " + report.reason);
  }
  requireBytes(sides.subject, before);
  require(difference(sides.subject.run(input, Options()), wanted).empty(),
    "another result after the shortage");
}

/// Runs of several threads at a time.
void checkAtOnce(const Sides& sides)
{
  const DeviceInput inputs[] = { drawn("shell0", false, 20000), drawn("uniformHeavy", true, 50000),
    drawn("cube", false, 200000) };
  constexpr std::size_t Count = sizeof(inputs) / sizeof(inputs[0]);
  std::exception_ptr errors[Count];
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < Count; ++k)
  {
    threads.emplace_back(
      [&, k]
      {
        try
        {
          const RunResult wanted = runOnCpu(inputs[k].view(), Options());
          for (int i = 0; i < 5; ++i)
          {
            require(difference(sides.subject.run(inputs[k].view(), Options()), wanted).empty(),
              "another result beside other runs");
          }
        }
        catch (...)
        {
          errors[k] = std::current_exception();
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const std::exception_ptr& error : errors)
  {
    if (error)
    {
      std::rethrow_exception(error);
    }
  }
}

/// Points are sent as they are, if they are floats, else as doubles; and where they lie in the
/// executor's memory, they are read there.
template <class Scalar>
void checkInPlace(const Sides& sides, const DeviceInput& drawn, std::int64_t stride)
{
  const auto count = static_cast<std::int64_t>(drawn.xyz.size() / 3);
  const std::int64_t axes = std::min<std::int64_t>(stride, drawn.plane ? 2 : 3);
  // What is between the points is nobody's business.
  std::vector<Scalar> scalars(
    static_cast<std::size_t>(count * stride), std::numeric_limits<Scalar>::quiet_NaN());
  std::vector<Scalar> weights;
  for (std::int64_t i = 0; i < count; ++i)
  {
    for (std::int64_t axis = 0; axis < axes; ++axis)
    {
      scalars[static_cast<std::size_t>(i * stride + axis)] =
        static_cast<Scalar>(drawn.xyz[static_cast<std::size_t>(3 * i + axis)]);
    }
    weights.push_back(static_cast<Scalar>(drawn.xyz[static_cast<std::size_t>(3 * i + 2)]));
  }
  RunInput input;
  input.plane = drawn.plane;
  input.points = PointView(scalars.data(), count, stride);
  if (drawn.weighted)
  {
    input.weights = WeightView(weights.data(), count);
  }
  const RunResult wanted = runOnCpu(input, Options());
  RunWatch watch;
  watch.times = true;
  RunSeen sent;
  require(difference(sides.subject.run(input, Options(), watch, &sent), wanted).empty(),
    "another result of points on the host");
  if (sides.subject.isOnDevice())
  {
    const std::int64_t each = drawn.plane && !drawn.weighted ? 2 : 3;
    require(sent.launches.at("from the host").bytes ==
        count * each * static_cast<std::int64_t>(sizeof(Scalar)),
      "another number of bytes was sent");
  }
  const Holding placed = sides.subject.place(input);
  require(input.points.deviceData != nullptr, "not placed");
  RunSeen seen;
  const RunResult found = sides.subject.run(input, Options(), RunWatch(), &seen);
  const std::string text = difference(found, wanted);
  require(text.empty(), "stride " + std::to_string(stride) + ": other " + text);
  require(seen.launches.count("from the host") == 0, "the points were copied");
}

/// The device that is current for the thread does the work, and stays current; what another one has
/// is copied.
void checkDevices(const Sides& sides)
{
  const DeviceInput input = drawn("shell1e2", false, 2000);
  const RunResult wanted = runOnCpu(input.view(), Options());
  RunInput placed = input.view();
  const std::pair<int, int> before = sides.subject.device();
  const Holding held = sides.subject.place(placed);
  for (int number = 0; number < before.second; ++number)
  {
    sides.subject.setDevice(number);
    RunSeen seen;
    require(difference(sides.subject.run(placed, Options(), RunWatch(), &seen), wanted).empty(),
      "another result on device " + std::to_string(number));
    require(sides.subject.device().first == number, "another device is current");
    require(!sides.subject.isOnDevice() ||
        (seen.launches.count("from the host") == 0) == (number == before.first),
      "memory of another device is read, or this one's is not");
  }
  sides.subject.setDevice(before.first);
}

/// What a run keeps for the next is bounded; what it does not keep, and what the application has
/// set, is as it was.
void checkWhatStays(const Sides& sides)
{
  const DeviceInput input = drawn("shell0", false, 50000);
  const std::int64_t before = sides.subject.bytesHeld();
  const std::size_t limit = sides.subject.stackLimit();
  RunSeen seen;
  sides.subject.run(input.view(), Options(), RunWatch(), &seen);
  const std::pair<std::int64_t, std::int64_t> kept = sides.subject.bytesKept();
  require(kept.first <= kept.second / 8 + 2 * Mebibyte,
    std::to_string(kept.first) + " bytes are kept of " + std::to_string(kept.second) +
      ", after a run that took " + std::to_string(seen.mostBytes));
  require(sides.subject.stackLimit() == limit, "the stack's limit is another");
  requireBytes(sides.subject, before);
}

}

void addMemoryChecks(std::vector<Check>& checks)
{
  checks.push_back({ "devices", true, checkDevices });
  checks.push_back({ "what-stays", true, checkWhatStays });
  checks.push_back({ "probe", true,
    [](const Sides& sides)
    {
      const DeviceInput input = drawn("cube", false, 30);
      require(
        difference(sides.subject.run(input.view(), Options()), runOnCpu(input.view(), Options()))
          .empty(),
        "another result");
    } });
  checks.push_back({ "abort/small", true,
    [](const Sides& sides) { checkAborts(sides, drawn("ball", false, 200)); } });
  checks.push_back({ "abort/hull", false,
    [](const Sides& sides) { checkAborts(sides, drawn("shell1e2", false, 200000)); } });
  checks.push_back({ "abort/plane", false,
    [](const Sides& sides) { checkAborts(sides, drawn("uniformHeavy", true, 100000)); } });
  checks.push_back({ "shortage/hull", false,
    [](const Sides& sides) { checkShortage(sides, drawn("ball", false, 1000000)); } });
  checks.push_back({ "at-once", false, checkAtOnce });
  for (const bool small : { true, false })
  {
    const std::int64_t count = small ? 200 : 50000;
    checks.push_back({ std::string("in-place/hull") + (small ? "-small" : ""), small,
      [count](const Sides& sides)
      {
        const DeviceInput input = drawn("shell1e2", false, count);
        checkInPlace<double>(sides, input, 3);
        checkInPlace<double>(sides, input, 4);
        checkInPlace<float>(sides, input, 3);
        checkInPlace<float>(sides, input, 4);
      } });
    checks.push_back({ std::string("in-place/plane") + (small ? "-small" : ""), small,
      [count](const Sides& sides)
      {
        for (const char* label : { "uniformHeavy", "hundred-normals" })
        {
          const DeviceInput input = drawn(label, true, count);
          checkInPlace<double>(sides, input, 2);
          checkInPlace<double>(sides, input, 3);
          checkInPlace<float>(sides, input, 3);
          checkInPlace<float>(sides, input, 4);
        }
      } });
  }
}

}
}
