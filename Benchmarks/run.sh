#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run.sh SECTION... [KEY=VALUE...]: build the benchmarks, measure sections of benchmarks.plan, and print their tables.
# Results: build/benchmark/SECTION.csv for each run, SECTION-summary.csv for each program, for Documentation/Measurements.
# Sections with Python packages install them; our wheel is taken from FLIPFLOP_WHEEL, if that is set.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../Scripts/common.sh"

plan="$top/Benchmarks/benchmarks.plan"
results="$top/build/benchmark"
sections=()
for argument in "$@"; do
  [[ "$argument" == *=* ]] || sections+=("$argument")
done
if [ ${#sections[@]} -eq 0 ]; then
  echo "usage: run.sh SECTION... [KEY=VALUE...]; sections: $(sed -n 's/^\[\(.*\)\]/\1/p' "$plan" | tr '\n' ' ')" >&2
  exit 2
fi

"$top/Scripts/install-dependencies.sh" benchmark
options=(-DBUILD_TESTING=OFF -DFLIPFLOP_WRAP_PYTHON=OFF)
[[ " ${sections[*]} " == *" many-blocks "* ]] || options+=(-DFLIPFLOP_BUILD_FILTERS=OFF)
[[ " ${sections[*]} " != *" round-counts"* ]] || options+=(-DFLIPFLOP_BUILD_CUDA_PROGRAMS=ON)
configure_and_build benchmark benchmark "${options[@]}"

if [[ " ${sections[*]} " =~ " "(vtk-|python-|many-hulls) ]]; then
  venv="$results/peers"
  say "Install $(grep -v '^#' "$top/Benchmarks/peers-requirements.txt" | tr '\n' ' ')in $venv"
  "$python" -m venv "$venv"
  "$venv/bin/pip" install --quiet --requirement "$top/Benchmarks/peers-requirements.txt" \
    ${FLIPFLOP_WHEEL:+"$FLIPFLOP_WHEEL"}
  export FLIPFLOP_PEER_PYTHON="$venv/bin/python"
fi

cd "$top" # the plan names files from here
status=0
"$results/bin/flipflop-benchmark" "$plan" "$@" "output=$results" || status=$?
for section in "${sections[@]}"; do
  say "$section"
  "$python" -B "$top/Benchmarks/report.py" "$results/$section.csv" --csv "$results/$section-summary.csv"
done
exit "$status"
