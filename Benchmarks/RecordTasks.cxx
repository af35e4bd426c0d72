// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Writes down the tasks of one run, for play-tasks.py. Documentation/TaskGraph.md tells how.
///
///     record-tasks hull|triangulation DISTRIBUTION POINTS THREADS FILE
#include "Distributions.h"
#include "HullContenders.h"
#include "MeasuredRun.h"
#include "TaskGraph/RecordFile.h"
#include "TriangulationContenders.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <stdexcept>

namespace
{

using namespace flipflop;

constexpr std::uint64_t Seed = 2013; // as the benchmarks'

/// Ours, and its tasks into a file.
class Recorded final : public Contender
{
public:
  Recorded(std::unique_ptr<Contender> ours, std::string runName, int threadCount, std::string path)
    : contender(std::move(ours))
    , what(std::move(runName))
    , threads(threadCount)
    , file(std::move(path))
    , recording(threadCount)
  {
  }

  void prepare(const Coordinates& xyz) override { this->contender->prepare(xyz); }
  void run() override
  {
    this->recording.begin();
    this->contender->run();
    this->recording.end();
  }
  /// Asked for of the measured run alone, not of the small one before it: so is the file.
  Outcome outcome() const override
  {
    std::ofstream stream(this->file);
    flipflop_tasks::write(stream, this->what, this->threads, this->recording.result());
    stream.close();
    if (!stream)
    {
      throw std::runtime_error("cannot write " + this->file);
    }
    return this->contender->outcome();
  }

private:
  const std::unique_ptr<Contender> contender;
  const std::string what;
  const int threads;
  const std::string file;
  flipflop_tasks::Recording recording;
};

void record(const std::string& what, const std::string& points, std::int64_t count, int threads,
  const std::string& file)
{
  const bool hull = what == "hull";
  if (count < 8 || threads < 1 || !(hull || what == "triangulation"))
  {
    throw std::invalid_argument("hull or triangulation, 8 points and 1 thread or more");
  }
  const Distribution distribution =
    Distribution::parse(points, hull ? Family::Space : Family::Plane);
  const Coordinates xyz = makePoints(distribution, count, Seed);
  const Coordinates few = makePoints(distribution, 1000, Seed);
  const std::string run =
    what + " " + distribution.label() + ", " + std::to_string(xyz.size() / 3) + " points";
  const Measurement measured = measure(
    xyz, few,
    [&]
    {
      return std::make_unique<Recorded>(
        hull ? makeFlipFlop(threads) : makeFlipFlopTriangulation(threads), run, threads, file);
    },
    0, false);
  if (!measured.done())
  {
    throw std::runtime_error(measured.message);
  }
}

}

int main(int argc, char** argv)
{
  if (argc != 6)
  {
    std::fprintf(
      stderr, "usage: %s hull|triangulation DISTRIBUTION POINTS THREADS FILE\n", argv[0]);
    return 2;
  }
  try
  {
    record(argv[1], argv[2], std::llround(std::atof(argv[3])), std::atoi(argv[4]), argv[5]);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
