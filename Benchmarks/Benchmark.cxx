// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Algorithms side by side in one run.
///
/// Absolute times drift from machine to machine and from minute to minute, so every round runs each
/// contender once, one after another, and ratios are taken within a round.
#include "MeasuredRun.h"
#include "Plan.h"
#include "Report.h"
#include "Suite.h"

#include <chrono>
#include <cstdio>
#include <exception>
#include <map>
#include <string>
#include <vector>

namespace flipflop
{
namespace
{

struct Entry
{
  std::string name;
  int threads;
  ContenderFactory factory;
  bool peer() const { return this->name != "flipflop"; }
};

std::vector<Entry> entries(const Suite& suite, const Plan& plan, const Distribution& distribution)
{
  std::vector<Entry> result;
  for (const int threads : plan.threads)
  {
    result.push_back({ "flipflop", threads, [&suite, threads] { return suite.ours(threads); } });
  }
  for (const Peer& peer : plan.peers)
  {
    if (peer.weighted || !distribution.isWeighted())
    {
      result.push_back({ peer.name, peer.threads, peer.factory });
    }
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

Case runCase(const Suite& suite, const Plan& plan, const Distribution& distribution,
  std::int64_t size, const Paces& paces)
{
  const std::vector<Entry> contenders = entries(suite, plan, distribution);
  const Coordinates few = makePoints(suite.warmUp, 1000, 1);
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
  double judging = 0;
  for (int round = 0; round < plan.repetitions; ++round)
  {
    const std::chrono::duration<double> passed = Clock::now() - start;
    if (round > 0 && plan.maxCaseSeconds > 0 && passed.count() - judging > plan.maxCaseSeconds)
    {
      break;
    }
    for (std::size_t i = 0; i < contenders.size(); ++i)
    {
      const Entry& entry = contenders[i];
      if (one.rows[i].goesOn())
      {
        const Measurement measurement = measure(points, few, entry.factory,
          entry.peer() ? plan.maxPeerSeconds : 0, plan.validate && round == 0);
        judging += measurement.judgingSeconds;
        one.rows[i].add(measurement);
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
    if (row.goesOn() || row.status == Status::Timeout)
    {
      paces[row.contender] = seconds / static_cast<double>(one.points);
    }
  }
}

bool writeFile(const Suite& suite, const std::string& path, const std::vector<Case>& cases,
  const Plan& plan, bool csv)
{
  if (path.empty())
  {
    return true;
  }
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (!file)
  {
    std::fprintf(stderr, "%s: cannot write %s\n", suite.program.c_str(), path.c_str());
    return false;
  }
  if (csv)
  {
    writeCsv(file, suite, cases);
  }
  else
  {
    writeJson(file, suite, cases, plan);
  }
  return std::fclose(file) == 0;
}

/// Whether every run of ours ended well, all with the same result, and with as many vertices as
/// every exact peer.
bool sound(const Suite& suite, const Case& one)
{
  const Outcome* first = nullptr;
  for (const Row& row : one.rows)
  {
    const bool ours = row.contender == "flipflop";
    const Peer* peer = suite.find(row.contender);
    if (ours && row.status != Status::Ok)
    {
      return false;
    }
    if (!ours && !(peer && peer->exact))
    {
      continue;
    }
    for (const Outcome& outcome : row.outcomes)
    {
      first = first ? first : &outcome;
      if (outcome.vertices != first->vertices || (ours && outcome.facets != first->facets))
      {
        std::fprintf(stderr, "%s: %s differs\n", suite.program.c_str(),
          ours ? "a run of ours" : peer->title.c_str());
        return false;
      }
    }
  }
  return true;
}

int run(const Suite& suite, const Plan& plan)
{
  std::vector<Case> cases;
  bool good = true;
  printHeader(stdout, suite);
  for (const Distribution& distribution : plan.distributions)
  {
    Paces paces;
    // What comes from a file has one size.
    const std::vector<std::int64_t> whole = { 0 };
    for (const std::int64_t size : distribution.file.empty() ? plan.sizes : whole)
    {
      cases.push_back(runCase(suite, plan, distribution, size, paces));
      notePaces(paces, cases.back(), plan);
      printCase(stdout, suite, cases.back());
      good = sound(suite, cases.back()) && good;
      // A long run that is stopped leaves what it has.
      good = writeFile(suite, plan.csv, cases, plan, true) && good;
      good = writeFile(suite, plan.json, cases, plan, false) && good;
    }
  }
  return good ? 0 : 1;
}

}

int runBenchmark(const Suite& suite, int argc, const char* const* argv)
{
  try
  {
    const Plan plan = Plan::parse(suite, argc, argv);
    if (plan.help)
    {
      std::fputs(Plan::usage(suite).c_str(), stdout);
      return 0;
    }
    return run(suite, plan);
  }
  catch (const std::exception& error)
  {
    std::fprintf(
      stderr, "%s: %s\n(--help lists the options)\n", suite.program.c_str(), error.what());
    return 2;
  }
}

}
