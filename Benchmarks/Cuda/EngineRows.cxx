// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Parts.h"

#if defined(FLIPFLOP_HAVE_QHULL)
#include "HullContenders.h"
#endif

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flipflop
{

namespace
{

const double none = std::nan("");

double secondsSince(std::chrono::steady_clock::time_point begin)
{
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  return seconds.count();
}

}

Points::Points(const Subject& subject, std::int64_t count, std::uint64_t seed)
  : xyz(makePoints(subject.distribution, count, seed))
  , plane(subject.plane)
  , weighted(subject.distribution.isWeighted())
{
}

RunInput Points::view() const
{
  RunInput input;
  input.plane = this->plane;
  input.points = PointView(this->xyz.data(), this->count());
  if (this->weighted)
  {
    input.weights = WeightView(this->xyz.data() + 2, this->count(), 3);
  }
  return input;
}

std::vector<Subject> subjects(const Settings& settings)
{
  std::vector<Subject> all;
  for (const char* label : { "cube", "ball", "box:0.01", "shell:0.01", "shell:0.0001", "shell:0" })
  {
    all.push_back({ Distribution::parse(label, Family::Space), false });
  }
  for (const char* label : { "uniform:0", "uniform:27", "uniform:0.19" })
  {
    all.push_back({ Distribution::parse(label, Family::Plane), true });
  }
  if (!settings.only.empty())
  {
    all.erase(std::remove_if(all.begin(), all.end(),
                [&](const Subject& subject) { return subject.label() != settings.only; }),
      all.end());
  }
  return all;
}

std::vector<Subject> crossoverSubjects()
{
  return { { Distribution::parse("cube", Family::Space), false },
    { Distribution::parse("shell:0", Family::Space), false },
    { Distribution::parse("uniform:0", Family::Plane), true },
    { Distribution::parse("uniform:27", Family::Plane), true } };
}

Timed timed(const Settings& settings, const std::function<RunResult()>& run)
{
  constexpr double Enough = 4;
  const auto begin = std::chrono::steady_clock::now();
  std::vector<double> seconds;
  std::vector<Statistics> statistics;
  Timed result;
  for (int i = 0; i <= settings.repetitions; ++i)
  {
    const auto now = std::chrono::steady_clock::now();
    const RunResult found = run();
    const double took = secondsSince(now);
    if (i == 0 && took < 1)
    {
      continue;
    }
    seconds.push_back(took);
    statistics.push_back(found.cells().statistics);
    result.vertices = static_cast<std::int64_t>(found.cells().pointIds.size());
    result.cells = found.cells().cellCount();
    if (secondsSince(begin) > Enough)
    {
      break;
    }
  }
  std::vector<std::size_t> order(seconds.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return seconds[a] < seconds[b]; });
  const std::size_t middle = order[order.size() / 2];
  result.runs = static_cast<int>(seconds.size());
  result.median = seconds[middle];
  result.least = seconds[order.front()];
  result.greatest = seconds[order.back()];
  result.statistics = statistics[middle];
  return result;
}

EngineRows::EngineRows(const Settings& chosen, RoundsRunner& device)
  : settings(chosen)
  , runner(device)
  , csv(chosen.folder, "engines", chosen.facts,
      "distribution,parameter,n,contender,threads,runs,seconds_median,seconds_min,seconds_max,"
      "times_cpu,vertices,cells,seconds_scan,seconds_locate,seconds_grow,seconds_flip,"
      "seconds_compact,seconds_finish,device_copy_in,device_grow,device_flip,device_finish,"
      "device_copy_out,growth_rounds,flip_rounds,peak_device_bytes,"
      "device_bytes_per_point")
  , qhullLeft(chosen.qhullSeconds)
{
}

void EngineRows::measure(const Subject& subject, const Points& points, const Allowance& allowance)
{
  Options options;
  const RunInput input = points.view();
  Timed all;
  all.median = none;
  if (!this->settings.deviceOnly)
  {
    all = timed(this->settings, [&] { return runOnCpu(input, options); });
    this->add(subject, points, "cpu", all.statistics.threads, all, RunSeen(), all.median);
  }

  RunSeen seen;
  const auto onDevice = [&](const RunInput& from)
  { return timed(this->settings, [&] { return this->runner.run(from, options, {}, &seen); }); };
  const Timed copied = onDevice(input);
  this->add(subject, points, "cuda", copied.statistics.threads, copied, seen, all.median);
  RunInput placed = input;
  const Holding held = this->runner.place(placed);
  const Timed inPlace = onDevice(placed);
  this->add(
    subject, points, "cuda-in-place", inPlace.statistics.threads, inPlace, seen, all.median);

  if (this->settings.deviceOnly)
  {
    return;
  }
  if (allowance.left() > 0)
  {
    options.threads = 1;
    const Timed one = timed(this->settings, [&] { return runOnCpu(input, options); });
    this->add(subject, points, "cpu", 1, one, RunSeen(), all.median);
  }
  if (!points.plane && allowance.left() > 0)
  {
    this->measureQhull(subject, points, all.median, allowance);
  }
}

#if defined(FLIPFLOP_HAVE_QHULL)
void EngineRows::measureQhull(
  const Subject& subject, const Points& points, double cpuSeconds, const Allowance& allowance)
{
  const auto count = static_cast<double>(points.count());
  const auto before = this->qhullPerPoint.find(subject.label());
  // It takes somewhat more a point with each size.
  const double expected = before == this->qhullPerPoint.end() ? 0 : 1.3 * before->second * count;
  if (expected > std::min(this->qhullLeft, allowance.left()))
  {
    return;
  }
  const std::unique_ptr<Contender> qhull = makeQhull();
  qhull->prepare(points.xyz);
  const auto begin = std::chrono::steady_clock::now();
  qhull->run();
  Timed result;
  result.runs = 1;
  result.median = result.least = result.greatest = secondsSince(begin);
  result.vertices = qhull->outcome().vertices;
  result.cells = qhull->outcome().facets;
  this->qhullLeft -= result.median;
  this->qhullPerPoint[subject.label()] = result.median / count;
  this->add(subject, points, "qhull", 1, result, RunSeen(), cpuSeconds);
}
#else
void EngineRows::measureQhull(const Subject&, const Points&, double, const Allowance&) {}
#endif

void EngineRows::add(const Subject& subject, const Points& points, const std::string& contender,
  int threads, const Timed& result, const RunSeen& seen, double cpuSeconds)
{
  const bool cpu = contender == "cpu";
  const bool ours = contender != "qhull";
  const bool device = ours && !cpu;
  const Statistics& s = result.statistics;
  const auto stage = [&](const char* name)
  {
    const auto found = seen.partSeconds.find(name);
    return found == seen.partSeconds.end() ? none : found->second;
  };
  std::vector<Cell> row = caseCells(subject.distribution, points.count());
  const Cell rest[] = { contender, threads, result.runs, result.median, result.least,
    result.greatest, cpuSeconds / result.median, result.vertices, result.cells,
    ours ? s.secondsScan : none, cpu ? s.secondsLocate : none, ours ? s.secondsGrow : none,
    ours ? s.secondsFlip : none, device ? s.secondsCompact : none, ours ? s.secondsFinish : none,
    stage("copy to the device"), stage("grow"), stage("flip"), stage("finish"),
    stage("copy to the host"), device ? Cell(std::int64_t(seen.growthRounds)) : Cell(""),
    device ? Cell(std::int64_t(seen.flipRounds)) : Cell(""),
    device ? Cell(seen.mostBytes) : Cell(""),
    device ? Cell(static_cast<double>(seen.mostBytes) / static_cast<double>(points.count()))
           : Cell("") };
  row.insert(row.end(), std::begin(rest), std::end(rest));
  this->csv.add(row);
  std::printf("%-13s %9lld  %-13s %2d thr. %10.5f s  %6.2f x cpu  %d runs\n",
    subject.label().c_str(), static_cast<long long>(points.count()), contender.c_str(), threads,
    result.median, cpuSeconds / result.median, result.runs);
  std::fflush(stdout);
}

}
