// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Parts.h"

#include <cmath>

namespace flipflop
{

void measureCrossover(const Settings& settings, RoundsRunner& runner, const Allowance& allowance)
{
  Csv csv(settings.folder, "crossover", settings.facts,
    "distribution,parameter,n,threads,seconds_cpu,seconds_cuda,times_cpu,cuda_pays_from");
  const std::int64_t greatest = std::min<std::int64_t>(settings.sizes.back(), 1000000);
  for (const Subject& subject : crossoverSubjects())
  {
    struct Pair
    {
      std::int64_t count;
      Timed cpu, cuda;
    };
    std::vector<Pair> pairs;
    for (std::int64_t decade = 1000; decade <= greatest; decade *= 10)
    {
      for (const std::int64_t count : { decade, 2 * decade, 5 * decade })
      {
        if (count > greatest || allowance.left() <= 0)
        {
          break;
        }
        const Points points(subject, count, settings.seed);
        const RunInput input = points.view();
        pairs.push_back({ count, timed(settings, [&] { return runOnCpu(input, Options()); }),
          timed(settings, [&] { return runner.run(input, Options()); }) });
      }
    }
    // The least size from which on it is faster at every size measured.
    std::int64_t from = -1;
    for (auto pair = pairs.rbegin(); pair != pairs.rend() && pair->cuda.median < pair->cpu.median;
         ++pair)
    {
      from = pair->count;
    }
    for (const Pair& pair : pairs)
    {
      std::vector<Cell> row = caseCells(subject.distribution, pair.count);
      row.insert(row.end(),
        { pair.cpu.statistics.threads, pair.cpu.median, pair.cuda.median,
          pair.cpu.median / pair.cuda.median, from < 0 ? Cell("never") : Cell(from) });
      csv.add(row);
    }
    std::printf("%-13s the CUDA engine pays from %s points on\n", subject.label().c_str(),
      from < 0 ? "no measured number of" : std::to_string(from).c_str());
    std::fflush(stdout);
  }
}

}
