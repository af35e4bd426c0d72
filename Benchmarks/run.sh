#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run.sh [hull|triangulation] [OPTION OF THE BENCHMARK]...: build the benchmarks, run one or both, draw
# the figures and write the tables of Documentation/Benchmarks.md. Results: hull.csv, hull.json,
# triangulation.csv and triangulation.json in build/benchmark.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../Scripts/common.sh"

subjects=(hull triangulation)
case "${1:-}" in
  hull | triangulation) subjects=("$1"); shift ;;
  --* | "") ;;
  *) echo "usage: run.sh [hull|triangulation] [OPTION OF THE BENCHMARK]..." >&2; exit 2 ;;
esac

"$top/Scripts/install-dependencies.sh" benchmark
configure_and_build benchmark benchmark -DFLIPFLOP_BUILD_FILTERS=OFF \
  -DFLIPFLOP_BUILD_TESTING=OFF -DFLIPFLOP_BUILD_EXAMPLES=OFF

for subject in "${subjects[@]}"; do
  results="$top/build/benchmark/$subject"
  say "Run: $subject"
  "$top/build/benchmark/bin/$subject-benchmark" --validate --max-case-seconds 120 \
    --csv "$results.csv" --json "$results.json" "$@"

  say "Figures and tables: $subject"
  "$python" -B "$top/Benchmarks/plot-figures.py" "$subject" "$results.csv" --json "$results.json" \
    --figures "$top/Documentation/Figures" --markdown "$top/Documentation/Benchmarks.md"
done
