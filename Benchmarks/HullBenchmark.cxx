// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Convex hulls by this engine, Qhull and CGAL, side by side in one run.
///
/// Absolute times drift from machine to machine and from minute to minute, so every round runs each
/// contender once, one after another, and ratios are taken within a round.
#include "Contender.h"
#include "MeasuredRun.h"
#include "Plan.h"
#include "Report.h"

#include <chrono>
#include <cstdio>
#include <exception>
#include <map>
#include <string>
#include <vector>

namespace
{

using namespace flipflop;

struct Entry
{
  std::string name;
  int threads;
  ContenderFactory factory;
  bool peer() const { return this->name != "flipflop"; }
};

std::vector<Entry> entries(const Plan& plan)
{
  std::vector<Entry> result;
  for (const int threads : plan.threads)
  {
    result.push_back({ "flipflop", threads, [threads] { return makeFlipFlop(threads); } });
  }
  if (plan.qhull)
  {
    result.push_back({ "qhull", 1, makeQhull });
  }
  if (plan.cgal)
  {
    result.push_back({ "cgal", 1, makeCgal });
  }
  return result;
}

/// Seconds a point that a peer took at the size before, by its name: what lets a case be skipped.
using Paces = std::map<std::string, double>;

void skipSlowPeers(Case& one, const Plan& plan, const Paces& paces)
{
  for (Row& row : one.rows)
  {
    const auto pace = paces.find(row.contender);
    if (plan.maxPeerSeconds > 0 && pace != paces.end() &&
      pace->second * static_cast<double>(one.points) > plan.maxPeerSeconds)
    {
      row.status = Status::Skipped;
      row.message = "too slow at the size before";
    }
  }
}

Case runCase(const Plan& plan, const std::vector<Entry>& contenders,
  const Distribution& distribution, std::int64_t size, const Paces& paces)
{
  const Coordinates points = makePoints(distribution, size, plan.seed);
  Case one;
  one.distribution = distribution;
  one.points = static_cast<std::int64_t>(points.size() / 3);
  for (const Entry& entry : contenders)
  {
    Row row;
    row.contender = entry.name;
    row.threads = entry.threads;
    one.rows.push_back(row);
  }
  skipSlowPeers(one, plan, paces);

  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  for (int round = 0; round < plan.repetitions; ++round)
  {
    const std::chrono::duration<double> passed = Clock::now() - start;
    if (round > 0 && plan.maxCaseSeconds > 0 && passed.count() > plan.maxCaseSeconds)
    {
      break;
    }
    for (std::size_t i = 0; i < contenders.size(); ++i)
    {
      const Entry& entry = contenders[i];
      if (one.rows[i].status == Status::Ok)
      {
        one.rows[i].add(measure(points, entry.factory, entry.peer() ? plan.maxPeerSeconds : 0,
          plan.validate && round == 0));
      }
    }
  }
  return one;
}

void notePaces(Paces& paces, const Case& one, const Plan& plan)
{
  for (const Row& row : one.rows)
  {
    if (row.contender == "flipflop")
    {
      continue;
    }
    double seconds = Summary::of(row.seconds).median;
    if (row.status == Status::Timeout)
    {
      seconds = plan.maxPeerSeconds;
    }
    if (row.status == Status::Ok || row.status == Status::Timeout)
    {
      paces[row.contender] = seconds / static_cast<double>(one.points);
    }
  }
}

bool writeFile(const std::string& path, const std::vector<Case>& cases, const Plan& plan, bool csv)
{
  if (path.empty())
  {
    return true;
  }
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (!file)
  {
    std::fprintf(stderr, "hull-benchmark: cannot write %s\n", path.c_str());
    return false;
  }
  if (csv)
  {
    writeCsv(file, cases);
  }
  else
  {
    writeJson(file, cases, plan);
  }
  return std::fclose(file) == 0;
}

/// Whether every run of ours ended well, and all with the same hull.
bool sound(const Case& one)
{
  const Outcome* first = nullptr;
  for (const Row& row : one.rows)
  {
    if (row.contender != "flipflop")
    {
      continue;
    }
    if (row.status != Status::Ok)
    {
      return false;
    }
    for (const Outcome& outcome : row.outcomes)
    {
      first = first ? first : &outcome;
      if (outcome.vertices != first->vertices || outcome.facets != first->facets)
      {
        std::fprintf(stderr, "hull-benchmark: two runs of ours differ\n");
        return false;
      }
    }
  }
  return true;
}

int run(const Plan& plan)
{
  const std::vector<Entry> contenders = entries(plan);
  std::vector<Case> cases;
  bool good = true;
  printHeader(stdout);
  for (const Distribution& distribution : plan.distributions)
  {
    Paces paces;
    for (const std::int64_t size : plan.sizes)
    {
      cases.push_back(runCase(plan, contenders, distribution, size, paces));
      notePaces(paces, cases.back(), plan);
      printCase(stdout, cases.back());
      good = sound(cases.back()) && good;
      // A long run that is stopped leaves what it has.
      good = writeFile(plan.csv, cases, plan, true) && good;
      good = writeFile(plan.json, cases, plan, false) && good;
    }
  }
  return good ? 0 : 1;
}

}

int main(int argc, char* argv[])
{
  try
  {
    const flipflop::Plan plan = flipflop::Plan::parse(argc, argv);
    if (plan.help)
    {
      std::fputs(flipflop::Plan::usage(), stdout);
      return 0;
    }
    return run(plan);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "hull-benchmark: %s\n(--help lists the options)\n", error.what());
    return 2;
  }
}
