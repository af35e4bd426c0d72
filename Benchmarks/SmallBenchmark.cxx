// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// small-benchmark: triangulations of few points by this engine and CGAL.
///
///     small-benchmark [rounds = 31] [distributions] [sizes = 8,20,50,100,200,500,1000]
///
/// Each measurement is a program started for it: its first run is timed ("first"), then further
/// ones on other points ("next"), of which the median counts. The start of the program is not
/// timed. In each round, the contenders run one after another; of times and ratios, the median of
/// the rounds is printed.
#include "Distributions.h"
#include "TriangulationContenders.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace flipflop
{
namespace
{

/// Of one run, in microseconds.
struct Times
{
  double first = 0;
  double next = 0;
};

template <class Value>
Value medianOf(std::vector<Value> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::unique_ptr<Contender> make(const std::string& name)
{
  return name == "flipflop"  ? makeFlipFlopTriangulation(0)
    : name == "cgal-regular" ? makeCgalRegular()
                             : makeCgalDelaunay();
}

double timeOfRun(const std::string& name, const Coordinates& points)
{
  const std::unique_ptr<Contender> contender = make(name);
  contender->prepare(points);
  const auto begin = std::chrono::steady_clock::now();
  contender->run();
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin)
    .count();
}

/// What the started program does: times of one contender.
int measureHere(const char* const* arguments)
{
  const std::string name = arguments[0];
  const Distribution distribution = Distribution::parse(arguments[1], Family::Plane);
  const std::int64_t size = std::stoll(arguments[2]);
  Times times;
  times.first = timeOfRun(name, makePoints(distribution, size, 1));
  std::vector<double> next;
  for (std::uint64_t seed = 2; seed < 200; ++seed)
  {
    next.push_back(timeOfRun(name, makePoints(distribution, size, seed)));
  }
  std::printf("%.9g %.9g\n", times.first, medianOf(next));
  return EXIT_SUCCESS;
}

/// Start this program for it.
Times measure(const std::string& program, const std::string& name, const std::string& distribution,
  const std::string& size)
{
  const std::string command =
    "'" + program + "' --measure " + name + " " + distribution + " " + size;
  Times times;
  std::FILE* const pipe = popen(command.c_str(), "r");
  const bool read = pipe && std::fscanf(pipe, "%lf %lf", &times.first, &times.next) == 2;
  if (!pipe || pclose(pipe) != 0 || !read)
  {
    throw std::runtime_error("no result: " + command);
  }
  return times;
}

std::vector<std::string> split(const std::string& text)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');)
  {
    parts.push_back(part);
  }
  return parts;
}

void compare(
  const std::string& program, const std::string& distribution, const std::string& size, int rounds)
{
  const bool isWeighted = Distribution::parse(distribution, Family::Plane).isWeighted();
  const std::string peer = isWeighted ? "cgal-regular" : "cgal-delaunay";
  std::vector<double> times[4], ratios[2];
  for (int round = 0; round < rounds; ++round)
  {
    const Times our = measure(program, "flipflop", distribution, size);
    const Times other = measure(program, peer, distribution, size);
    const double all[4] = { our.first, other.first, our.next, other.next };
    for (int i = 0; i < 4; ++i)
    {
      times[i].push_back(all[i]);
    }
    ratios[0].push_back(other.first / our.first);
    ratios[1].push_back(other.next / our.next);
  }
  std::printf("%-14s %6s %9.1f %9.1f %6.2f %9.1f %9.1f %6.2f\n", distribution.c_str(), size.c_str(),
    medianOf(times[0]), medianOf(times[1]), medianOf(ratios[0]), medianOf(times[2]),
    medianOf(times[3]), medianOf(ratios[1]));
  std::fflush(stdout);
}

int run(int argc, const char* const* argv)
{
  if (argc == 5 && std::strcmp(argv[1], "--measure") == 0)
  {
    return measureHere(argv + 2);
  }
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 31;
  const std::string distributions =
    argc > 2 ? argv[2] : "uniform,square-grid,circle,collinear,uniform:1,uniform:27,weighted-grid";
  const std::string sizes = argc > 3 ? argv[3] : "8,20,50,100,200,500,1000";
  if (rounds < 1 || argc > 4)
  {
    std::fprintf(stderr, "usage: %s [rounds = 31] [distributions] [sizes]\n", argv[0]);
    return 2;
  }
  std::printf("microseconds; ratio: CGAL's over ours\n%-14s %6s %9s %9s %6s %9s %9s %6s\n",
    "points", "number", "first", "CGAL", "ratio", "next", "CGAL", "ratio");
  for (const std::string& distribution : split(distributions))
  {
    for (const std::string& size : split(sizes))
    {
      compare(argv[0], distribution, size, rounds);
    }
  }
  return EXIT_SUCCESS;
}

}
}

int main(int argc, char* argv[])
{
  try
  {
    return flipflop::run(argc, argv);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
  }
}
