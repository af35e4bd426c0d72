// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// flipflop-benchmark: programs side by side on the cases of a plan.
///
/// Times drift from machine to machine and from minute to minute. So every round runs each program
/// once, one after another, and ratios are taken within a round.
#include "Plan.h"
#include "Results.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <map>

namespace flipflop
{
namespace
{

using Facts = std::vector<std::pair<std::string, std::string>>;

class Stopwatch
{
public:
  double seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->start).count();
  }

private:
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

/// Seconds a point that a peer took at the count before, by its name.
using Paces = std::map<std::string, double>;

Input makeCase(const Plan& plan, const std::string& family, std::int64_t count, std::uint64_t seed)
{
  const auto make = [&]
  {
    return plan.problem->input ? plan.problem->input(family, count, seed)
                               : makeInput(family, plan.problem->isPlane, count, seed);
  };
  Input input = plan.isolate ? makeApart(make) : make();
  input.family = family;
  input.plannedCount = count;
  input.seed = seed;
  input.isPlane = plan.problem->isPlane;
  return input;
}

std::vector<Entry> makeEntries(const Plan& plan, const Input& input, const Paces& paces)
{
  std::vector<Entry> entries;
  for (const ProgramKind* kind : plan.programs)
  {
    if (input.isWeighted && !kind->hasWeights)
    {
      continue;
    }
    for (const int threads : kind->hasThreads ? plan.threads : std::vector<int>{ 1 })
    {
      for (const int parts : plan.parts)
      {
        Entry entry;
        entry.kind = kind;
        entry.settings = { threads, parts };
        const auto pace = paces.find(kind->name);
        if (!kind->isOurs && plan.maxPeerSeconds > 0 && pace != paces.end() &&
          pace->second * static_cast<double>(input.count()) > plan.maxPeerSeconds)
        {
          entry.rounds.emplace_back();
          entry.rounds.back().status = Status::Skipped;
          entry.rounds.back().message = "too slow at the count before";
        }
        entries.push_back(entry);
      }
    }
  }
  return entries;
}

Case runCase(const Plan& plan, const Input& input, const Input& warmUp, const Paces& paces)
{
  Case one;
  one.family = input.family;
  one.count = input.count();
  one.entries = makeEntries(plan, input, paces);
  const Stopwatch watch;
  double checking = 0;
  for (int round = 0; round < plan.repetitions; ++round)
  {
    if (round > 0 && plan.maxCaseSeconds > 0 && watch.seconds() - checking > plan.maxCaseSeconds)
    {
      break;
    }
    for (Entry& entry : one.entries)
    {
      if (entry.goesOn())
      {
        RunRequest request;
        request.make = [&entry] { return entry.kind->make(entry.settings); };
        request.input = &input;
        request.warmUp = warmUp.xyz.empty() ? nullptr : &warmUp;
        request.limitSeconds = entry.kind->isOurs ? 0 : plan.maxPeerSeconds;
        request.check = plan.check && round == 0;
        request.isolate = plan.isolate;
        entry.rounds.push_back(measure(request));
        checking += entry.rounds.back().checkSeconds;
      }
    }
  }
  return one;
}

void notePaces(Paces& paces, const Case& one, const Plan& plan)
{
  for (const Entry& entry : one.entries)
  {
    const bool isTimeout = entry.rounds.back().status == Status::Timeout;
    const double seconds = isTimeout ? plan.maxPeerSeconds : entry.medianSeconds();
    if (std::isfinite(seconds))
    {
      paces[entry.kind->name] = seconds / static_cast<double>(one.count);
    }
  }
}

/// Whether every run of ours is right, and has the metrics that all exact programs agree in.
bool isSound(const Problem& problem, const Case& one)
{
  bool isGood = true;
  std::map<std::string, double> agreed;
  for (const Entry& entry : one.entries)
  {
    for (const Measurement& round : entry.rounds)
    {
      isGood = isGood && (!entry.kind->isOurs || round.status == Status::Ok);
      for (const auto& [name, value] : entry.kind->isExact ? round.metrics : Metrics())
      {
        const bool mustAgree =
          std::find(problem.agreed.begin(), problem.agreed.end(), name) != problem.agreed.end();
        if (mustAgree && agreed.emplace(name, value).first->second != value)
        {
          std::fprintf(stderr, "%s: %s differs: %.0f and %.0f\n", entry.kind->name.c_str(),
            name.c_str(), agreed[name], value);
          isGood = false;
        }
      }
    }
  }
  return isGood;
}

bool runPlan(const Plan& plan, Facts facts, const Stopwatch& watch)
{
  facts.insert(facts.begin(),
    { { "section", plan.section }, { "problem", plan.problem->name },
      { "seed", std::to_string(plan.seed) } });
  if (!plan.isolate)
  {
    const Facts device = deviceFacts();
    facts.insert(facts.end(), device.begin(), device.end());
  }
  std::printf("[%s]\n", plan.section.c_str());
  const std::string& few = plan.problem->warmUp;
  const Input warmUp = few.empty() ? Input() : makeCase(plan, few, 1000, 1);
  std::vector<Case> cases;
  bool isGood = true;
  for (const std::string& family : plan.families)
  {
    Paces paces;
    const bool isFile = family.compare(0, 5, "file:") == 0; // which has one count
    for (const std::int64_t count : isFile ? std::vector<std::int64_t>{ 0 } : plan.counts)
    {
      if (plan.maxSeconds > 0 && watch.seconds() > plan.maxSeconds)
      {
        std::printf("%s, %lld: the time is up\n", family.c_str(), static_cast<long long>(count));
        continue;
      }
      cases.push_back(runCase(plan, makeCase(plan, family, count, plan.seed), warmUp, paces));
      notePaces(paces, cases.back(), plan);
      printCase(cases.back(), *plan.problem);
      isGood = isSound(*plan.problem, cases.back()) && isGood;
      // A long benchmark that is stopped leaves what it has.
      writeCsv(plan.output + "/" + plan.section + ".csv", facts, cases);
    }
  }
  return isGood;
}

Facts describeCommand(const std::vector<std::string>& arguments)
{
  char date[32];
  const std::time_t now = std::time(nullptr);
  std::strftime(date, sizeof(date), "%Y-%m-%d %H:%M UTC", std::gmtime(&now));
  std::string command = "flipflop-benchmark";
  for (const std::string& argument : arguments)
  {
    command += " " + argument;
  }
  return { { "date", date }, { "command", command } };
}

}
}

/// 0 if every run of ours is right, 1 if not, 2 for bad arguments.
int main(int argc, char** argv)
{
  using namespace flipflop;
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  std::vector<Plan> plans;
  try
  {
    plans = readPlans(arguments);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr,
      "flipflop-benchmark: %s\nusage: flipflop-benchmark PLAN [SECTION]... [KEY=VALUE]...\n"
      "Benchmarks/Plan.h lists the keys.\n",
      error.what());
    return 2;
  }
  try
  {
    Facts all = describeCommand(arguments);
    const Facts known = facts();
    all.insert(all.end(), known.begin(), known.end());
    const Stopwatch watch;
    bool isGood = true;
    for (const Plan& plan : plans)
    {
      isGood = runPlan(plan, all, watch) && isGood;
    }
    return isGood ? 0 : 1;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "flipflop-benchmark: %s\n", error.what());
    return 1;
  }
}
