// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a benchmark is made of: a problem has an input and programs that solve it, ours and peers.
///
/// A new problem is one file that defines a Problem, and a line in Problems.cxx.
#ifndef flipflop_Program_h
#define flipflop_Program_h

#include "Coordinates.h"
#include <flipflop/Options.h>
#include <flipflop/PointView.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace flipflop
{

/// The points of one case; in the plane, z is the weight.
struct Input
{
  std::string family;
  std::int64_t plannedCount = 0; ///< number of points, as the plan has it
  std::uint64_t seed = 0;
  bool isPlane = false;
  bool isWeighted = false; ///< some weight is not zero
  Coordinates xyz;
  std::vector<std::int64_t> ends; ///< two ids of each constraint
  bool hasCrossings = false;      ///< constraints cross between points

  std::int64_t count() const { return static_cast<std::int64_t>(this->xyz.size() / 3); }
  PointView points() const { return PointView(this->xyz.data(), this->count()); }
  WeightView weights() const
  {
    return this->isWeighted ? WeightView(this->xyz.data() + 2, this->count(), 3) : WeightView();
  }
};

/// A function of its arguments alone.
/// @param family "file:PATH": all points of a file, x y z of each, float (.f32) or double (.f64);
///               else a name of makeCloud(), Testing/Engine/Inputs/InputsInUse.h
/// @throw std::exception
Input makeInput(const std::string& family, bool isPlane, std::int64_t count, std::uint64_t seed);

/// The same in a process of its own, so that this one's heap stays as it is.
/// @return points, weights and constraints; the caller sets the other fields
Input makeApart(const std::function<Input()>& make);

/// What a run found, by name: numbers of vertices and cells, statistics, seconds of its stages.
using Metrics = std::vector<std::pair<std::string, double>>;

struct CheckResult
{
  bool isRight = true;
  std::string text; ///< what is wrong; empty if nothing was checked
};

/// One algorithm of one library. An error is an exception.
class Program
{
public:
  virtual ~Program() = default;

  /// Convert the input to the form that the library takes. Not timed; its memory is input.
  virtual void prepare(const Input& input) = 0;

  /// The complete result. This alone is timed.
  virtual void run() = 0;

  /// Not timed.
  /// "seconds" and "peak_bytes" replace those measured around run().
  virtual Metrics metrics() const = 0;

  /// CheckResult the result exactly. Not timed.
  virtual CheckResult check() const { return {}; }
};

struct Settings
{
  int threads = 1;
  int parts = 0; ///< blocks or points of a set, where the problem has such
};

struct ProgramKind
{
  using Make = std::function<std::unique_ptr<Program>(const Settings&)>;

  std::string name; ///< in the plan and in the results
  Make make;
  bool isOurs = false;     ///< must be right; never stopped at a limit
  bool hasThreads = false; ///< runs once for each number of threads
  bool isExact = true;     ///< must agree with ours
  bool hasWeights = true;  ///< takes weighted sites

  static ProgramKind ours(const std::string& name, const Make& make)
  {
    return { name, make, true, true, true, true };
  }
  static ProgramKind exactPeer(const std::string& name, const Make& make)
  {
    return { name, make, false, false, true, true };
  }
  /// One that drops vertices within a tolerance.
  static ProgramKind peer(const std::string& name, const Make& make)
  {
    return { name, make, false, false, false, true };
  }
  ProgramKind withoutWeights() const
  {
    return { this->name, this->make, this->isOurs, this->hasThreads, this->isExact, false };
  }
  ProgramKind withoutThreads() const
  {
    return { this->name, this->make, this->isOurs, false, this->isExact, this->hasWeights };
  }
};

struct Problem
{
  std::string name;
  bool isPlane = false;
  /// Metrics in which all exact programs must agree.
  std::vector<std::string> agreed;
  std::vector<ProgramKind> programs;
  /// The family on which a process runs a program before the measured run, to bind libraries and
  /// start threads; empty for none.
  std::string warmUp;
  /// Null for makeInput().
  std::function<Input(const std::string& family, std::int64_t count, std::uint64_t seed)> input;

  /// @throw std::invalid_argument if there is none: the message names the others
  const ProgramKind& find(const std::string& program) const;
};

/// All problems that this build has.
const std::vector<Problem>& problems();

/// @throw std::invalid_argument if there is none: the message names the others
const Problem& findProblem(const std::string& name);

/// Versions of the libraries and of the machine, for the head of the results.
std::vector<std::pair<std::string, std::string>> facts();

/// The device and its driver, if this build has one: starts CUDA in this process.
std::vector<std::pair<std::string, std::string>> deviceFacts();

inline Options optionsOf(const Settings& settings)
{
  Options options;
  options.threads = settings.threads;
  return options;
}

}

#endif
