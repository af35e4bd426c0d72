#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run.sh [OPTION OF hull-benchmark]...: build the benchmark, run it, draw the figures and write the
# tables of Documentation/Benchmarks.md. Results: build/benchmark/results.csv and .json.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../Scripts/common.sh"

"$top/Scripts/install-dependencies.sh" benchmark
configure_and_build benchmark benchmark -DFLIPFLOP_BUILD_FILTERS=OFF \
  -DFLIPFLOP_BUILD_TESTING=OFF -DFLIPFLOP_BUILD_EXAMPLES=OFF

results="$top/build/benchmark/results"
say "Run"
"$top/build/benchmark/bin/hull-benchmark" --validate --max-case-seconds 120 \
  --csv "$results.csv" --json "$results.json" "$@"

say "Figures and tables"
"$python" "$top/Benchmarks/plot-figures.py" "$results.csv" --json "$results.json" \
  --figures "$top/Documentation/Figures" --markdown "$top/Documentation/Benchmarks.md"
