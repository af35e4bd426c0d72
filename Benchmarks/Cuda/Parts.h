// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The parts of cuda-benchmark: whole runs, kernel by kernel, and from where on the device pays.
#ifndef flipflop_Parts_h
#define flipflop_Parts_h

#include "Csv.h"
#include "Distributions.h"
#include "RoundsRunner.h"

#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace flipflop
{

/// Seconds left of those granted.
class Allowance
{
public:
  explicit Allowance(double granted)
    : seconds(granted)
  {
  }
  double left() const
  {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - this->begin;
    return this->seconds - passed.count();
  }

private:
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
  double seconds;
};

struct Settings
{
  bool host = false;
  std::string folder = ".";
  std::vector<std::int64_t> sizes = { 100000, 1000000, 10000000 };
  std::string only;        ///< the label of the one subject to measure; empty: all
  bool deviceOnly = false; ///< no run of another engine
  int repetitions = 5;
  std::string parts = "floors,crossover,engines,kernels"; ///< what to measure on a device

  bool measures(const std::string& part) const
  {
    return ("," + this->parts + ",").find("," + part + ",") != std::string::npos;
  }

  double qhullSeconds = 60; ///< in all
  std::uint64_t seed = 2013;
  Facts facts;
};

/// A distribution in its family.
struct Subject
{
  Distribution distribution;
  bool plane;

  std::string label() const { return this->distribution.label(); }
};

/// Points of a subject, and a view of them.
struct Points
{
  Coordinates xyz;
  bool plane;
  bool weighted;

  Points(const Subject& subject, std::int64_t count, std::uint64_t seed);
  RunInput view() const;
  std::int64_t count() const { return static_cast<std::int64_t>(this->xyz.size() / 3); }
};

/// What is measured in all parts, or settings.only of it; crossoverSubjects is a selection.
std::vector<Subject> subjects(const Settings& settings);
std::vector<Subject> crossoverSubjects();

/// One run of several, that of median time.
struct Timed
{
  int runs = 0;
  double median = 0, least = 0, greatest = 0;
  Statistics statistics; ///< of the run of median time
  std::int64_t vertices = 0, cells = 0;
};

/// Repeat a run, but not for longer than about 4 seconds. What is quick is run once before, so that
/// memory is there and libraries are bound.
Timed timed(const Settings& settings, const std::function<RunResult()>& run);

/// Whole runs by all contenders, size by size.
class EngineRows
{
public:
  EngineRows(const Settings& settings, RoundsRunner& runner);
  void measure(const Subject& subject, const Points& points, const Allowance& allowance);

private:
  void measureQhull(
    const Subject& subject, const Points& points, double cpuSeconds, const Allowance& allowance);
  void add(const Subject& subject, const Points& points, const std::string& contender, int threads,
    const Timed& result, const RunSeen& seen, double cpuSeconds);

  const Settings& settings;
  RoundsRunner& runner;
  Csv csv;
  double qhullLeft;
  std::map<std::string, double> qhullPerPoint; ///< by subject, at the size before
};

/// Launch by launch on the device; on the host only counts.
class KernelRows
{
public:
  KernelRows(const Settings& settings, RoundsRunner& runner);
  void measure(const Subject& subject, const Points& points);

private:
  RoundsRunner& runner;
  Csv csv;
};

/// From how many points on the device is faster.
void measureCrossover(const Settings& settings, RoundsRunner& runner, const Allowance& allowance);

}

#endif
