// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the benchmark's driver is made of: plans, measured runs, and the CSV.
#include "Plan.h"
#include "Results.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace flipflop
{
namespace
{

std::string writePlan(const std::string& text)
{
  const std::string path = ::testing::TempDir() + "benchmark.plan";
  std::ofstream(path) << text;
  return path;
}

const char* const plan = R"(
repetitions = 3    # for all sections
[first]
problem = triangulation
families = circle, in-use
counts = 1e3, 20
programs = flipflop
[hull]
families = file:some.f64
counts = 100
programs = flipflop
threads = 4
)";

TEST(Plans, HaveSectionsWithTheirOwnAndCommonValues)
{
  const std::vector<Plan> plans = readPlans({ writePlan(plan) });
  ASSERT_EQ(plans.size(), 2);
  EXPECT_EQ(plans[0].problem->name, "triangulation");
  EXPECT_EQ(plans[0].repetitions, 3);
  EXPECT_EQ(plans[0].counts, (std::vector<std::int64_t>{ 1000, 20 }));
  EXPECT_EQ(plans[0].families.front(), "circle");
  EXPECT_GT(plans[0].families.size(), 40) << "in use, in their order and shuffled";
  EXPECT_EQ(plans[1].problem->name, "hull") << "the section's name";
  EXPECT_EQ(plans[1].threads, std::vector<int>{ 4 });
}

TEST(Plans, ArgumentsChooseSectionsAndReplaceValues)
{
  const std::vector<Plan> plans =
    readPlans({ writePlan(plan), "hull", "counts=7,8", "check=no", "repetitions=9" });
  ASSERT_EQ(plans.size(), 1);
  EXPECT_EQ(plans[0].section, "hull");
  EXPECT_EQ(plans[0].counts, (std::vector<std::int64_t>{ 7, 8 }));
  EXPECT_EQ(plans[0].repetitions, 9);
  EXPECT_FALSE(plans[0].check);
}

TEST(Plans, RefuseWhatTheyDoNotKnow)
{
  const std::string path = writePlan(plan);
  const std::vector<std::string> bad[] = { {}, { path + "none" }, { path, "second" },
    { path, "color=red" }, { path, "counts=many" }, { path, "counts=1e3,,5" },
    { path, "counts=1e10" }, { path, "check=perhaps" }, { path, "programs=unknown" },
    { path, "problem=unknown" }, { writePlan("[hull]\nfamilies = cube\n") },
    { writePlan("[hull]\nfamilies\n") } };
  for (const std::vector<std::string>& arguments : bad)
  {
    EXPECT_THROW(readPlans(arguments), std::invalid_argument)
      << ::testing::PrintToString(arguments);
  }
}

/// Does as it is named.
class Scripted final : public Program
{
public:
  explicit Scripted(std::string how)
    : how(std::move(how))
  {
  }
  void prepare(const Input& given) override { this->input = &given; }
  void run() override
  {
    if (this->how == "throw" && this->input->count() > 1)
    {
      throw std::runtime_error("as asked");
    }
    if (this->how == "crash" && this->input->count() > 1)
    {
      std::_Exit(3);
    }
    if (this->how == "sleep" && this->input->count() > 1)
    {
      std::this_thread::sleep_for(std::chrono::seconds(100));
    }
    if (this->how == "allocate")
    {
      std::vector<char> block(100 << 20, 1);
      this->sum = block[this->input->count()];
    }
  }
  Metrics metrics() const override
  {
    Metrics metrics = { { "kernel, exact: items", 12345678 + this->sum } };
    if (this->how == "elsewhere")
    {
      metrics.emplace_back("seconds", 77);
    }
    return metrics;
  }
  CheckResult check() const override
  {
    return { this->how != "wrong", this->how == "wrong" ? "it is wrong" : "valid" };
  }

private:
  std::string how;
  const Input* input = nullptr;
  double sum = 0;
};

Measurement measured(const std::string& how, bool isolate = true)
{
  static const Input input = makeInput("cube", false, 1000, 1);
  static const Input few = makeInput("cube", false, 1, 1);
  RunRequest request;
  request.make = [=] { return std::make_unique<Scripted>(how); };
  request.input = &input;
  request.warmUp = &few;
  request.limitSeconds = how == "sleep" ? 0.2 : 0;
  request.check = true;
  request.isolate = isolate;
  return measure(request);
}

TEST(MeasuredRuns, SendTimeMemoryMetricsAndCheck)
{
  for (const bool isolate : { true, false })
  {
    const Measurement found = measured("allocate", isolate);
    EXPECT_EQ(found.status, Status::Ok) << found.message;
    EXPECT_EQ(found.message, "valid");
    EXPECT_GT(found.seconds, 0);
    EXPECT_GT(found.peakBytes, 90 << 20);
    ASSERT_EQ(found.metrics.size(), 1);
    EXPECT_EQ(found.metrics[0].first, "kernel, exact: items");
    EXPECT_EQ(found.metrics[0].second, 12345679);
  }
  EXPECT_EQ(measured("elsewhere").seconds, 77);
}

TEST(MeasuredRuns, ReportWhatGoesWrong)
{
  EXPECT_EQ(measured("wrong").status, Status::Wrong);
  EXPECT_EQ(measured("wrong").message, "it is wrong");
  EXPECT_EQ(measured("throw").status, Status::Failed);
  EXPECT_EQ(measured("throw").message, "as asked");
  EXPECT_EQ(measured("throw", false).message, "as asked");
  EXPECT_EQ(measured("crash").status, Status::Failed);
  EXPECT_EQ(measured("crash").message, "the process ended without a result");
  EXPECT_EQ(measured("sleep").status, Status::Timeout);
}

TEST(Inputs, AreTheSameFromAProcessOfTheirOwn)
{
  const auto make = [] { return makeInput("uniformHeavy", true, 1000, 3); };
  const Input here = make();
  const Input apart = makeApart(make);
  EXPECT_EQ(apart.xyz, here.xyz);
  EXPECT_TRUE(apart.isWeighted);
  EXPECT_FALSE(makeInput("uniform", true, 10, 3).isWeighted);
  EXPECT_THROW(makeApart([] { return makeInput("none", true, 10, 3); }), std::invalid_argument);
}

TEST(Inputs, OfAFileAreAllItsPoints)
{
  const std::string path = ::testing::TempDir() + "points.f32";
  const float points[] = { 1, 2, 3, 4, 5, 6 };
  std::ofstream(path, std::ios::binary)
    .write(reinterpret_cast<const char*>(points), sizeof(points));
  EXPECT_EQ(makeInput("file:" + path, false, 0, 0).xyz, (Coordinates{ 1, 2, 3, 4, 5, 6 }));
  EXPECT_EQ(makeInput("file:" + path, true, 0, 0).xyz, (Coordinates{ 1, 2, 0, 4, 5, 0 }));
  EXPECT_THROW(makeInput("file:none.f32", true, 0, 0), std::invalid_argument);
  EXPECT_THROW(makeInput("file:points.txt", true, 0, 0), std::invalid_argument);
}

TEST(Results, AreALineOfCsvForEachRun)
{
  Entry entry;
  entry.kind = &findProblem("hull").find("flipflop");
  entry.settings = { 2, 0 };
  entry.rounds.resize(2);
  entry.rounds[0].status = Status::Ok;
  entry.rounds[0].seconds = 0.25;
  entry.rounds[0].metrics = { { "vertices", 8 }, { "a, b", 123456789 } };
  entry.rounds[1].message = "no, \"not\"";
  Case one;
  one.family = "cube";
  one.count = 100;
  one.entries = { entry };
  const std::string path = ::testing::TempDir() + "results.csv";
  writeCsv(path, { { "seed", "1" } }, { one });
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  EXPECT_EQ(text.str(),
    "# seed: 1\n"
    "family,count,program,threads,parts,round,status,seconds,peak_bytes,vertices,\"a, b\",message\n"
    "cube,100,flipflop,2,0,0,ok,0.25,,8,123456789,\n"
    "cube,100,flipflop,2,0,1,failed,,,,,\"no, 'not'\"\n");
}

TEST(Problems, AgreeWithOurOwnResultOnEveryPath)
{
  for (const char* name : { "hull", "triangulation", "constrained", "alpha", "areas", "terrain",
         "small", "many-hulls", "many-triangulations", "blocks-plane", "blocks-space" })
  {
    const Problem& problem = findProblem(name);
    const char* const family = problem.input ? "streets" : problem.isPlane ? "circle" : "ball";
    const Input input = std::string(name) == "areas" ? problem.input("uniform-varied", 200, 1)
      : problem.input                                ? problem.input(family, 1000, 1)
                                                     : makeInput(family, problem.isPlane, 1000, 1);
    Metrics first;
    for (const ProgramKind& kind : problem.programs)
    {
      if (kind.name.compare(0, 8, "flipflop") != 0 && kind.name != "one-run")
      {
        continue;
      }
      RunRequest request;
      request.make = [&] { return kind.make({ 2, 10 }); };
      request.input = &input;
      request.check = true;
      const Measurement found = measure(request);
      EXPECT_EQ(found.status, Status::Ok) << name << ", " << kind.name << ": " << found.message;
      Metrics agreed;
      for (const auto& metric : found.metrics)
      {
        for (const std::string& wanted : problem.agreed)
        {
          metric.first == wanted ? agreed.push_back(metric) : void();
        }
      }
      EXPECT_EQ(agreed.size(), problem.agreed.size()) << name;
      first = first.empty() ? agreed : first;
      EXPECT_EQ(agreed, first) << name << ", " << kind.name;
    }
  }
}

}
}
