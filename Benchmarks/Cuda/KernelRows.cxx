// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Parts.h"

#include <cmath>

namespace flipflop
{

KernelRows::KernelRows(const Settings& settings, RoundsRunner& executor)
  : runner(executor)
  , csv(settings.folder, settings.host ? "rounds" : "kernels", settings.facts,
      "distribution,parameter,n,growth_rounds,flip_rounds,peak_bytes_per_point,kernel,launches,"
      "items,bytes_per_item,bytes,seconds,gb_per_second,microseconds_per_launch")
{
}

void KernelRows::measure(const Subject& subject, const Points& points)
{
  const auto count = static_cast<double>(points.count());
  RunWatch watch;
  watch.times = true;
  RunSeen seen;
  this->runner.run(points.view(), Options(), watch, &seen);
  for (const auto& kernel : seen.launches)
  {
    const LaunchTally& tally = kernel.second;
    const auto bytes = static_cast<double>(tally.bytes);
    const bool measured = tally.seconds > 0;
    std::vector<Cell> row = caseCells(subject.distribution, points.count());
    const Cell rest[] = { std::int64_t(seen.growthRounds), std::int64_t(seen.flipRounds),
      static_cast<double>(seen.mostBytes) / count, kernel.first, tally.launches, tally.items,
      tally.items > 0 ? bytes / static_cast<double>(tally.items) : std::nan(""), tally.bytes,
      measured ? tally.seconds : std::nan(""),
      measured ? 1e-9 * bytes / tally.seconds : std::nan(""),
      measured ? 1e6 * tally.seconds / static_cast<double>(tally.launches) : std::nan("") };
    row.insert(row.end(), std::begin(rest), std::end(rest));
    this->csv.add(row);
  }
  std::printf("%-13s %9lld  %u growth rounds, %u flip rounds, %.0f bytes a point\n",
    subject.label().c_str(), static_cast<long long>(points.count()), seen.growthRounds,
    seen.flipRounds, static_cast<double>(seen.mostBytes) / count);
  std::fflush(stdout);
}

}
