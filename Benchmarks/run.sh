#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run.sh [hull|triangulation|vtk|vtk-hull|vtk-triangulation] [OPTION OF THE BENCHMARK]...: build the
# benchmarks, run one or both (vtk: the two beside VTK's newest release, which it installs), draw
# the figures and write the tables of Documentation/Benchmarks.md or BenchmarksVtk.md. Results: hull.csv, hull.json and
# so on in build/benchmark.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../Scripts/common.sh"

subjects=(hull triangulation)
case "${1:-}" in
  hull | triangulation | vtk-hull | vtk-triangulation) subjects=("$1"); shift ;;
  vtk) subjects=(vtk-hull vtk-triangulation); shift ;;
  --* | "") ;;
  *) echo "usage: run.sh [[vtk-]hull|[vtk-]triangulation|vtk] [OPTION]..." >&2; exit 2 ;;
esac
limits=(--max-case-seconds 120)

"$top/Scripts/install-dependencies.sh" benchmark
configure_and_build benchmark benchmark -DFLIPFLOP_BUILD_FILTERS=OFF \
  -DBUILD_TESTING=OFF

if [[ "${subjects[0]}" == vtk-* ]]; then
  venv="$top/build/benchmark/vtk"
  say "Install: $(grep -v '^#' "$top/Benchmarks/vtk-requirements.txt") in $venv"
  "$python" -m venv "$venv"
  "$venv/bin/pip" install --quiet --requirement "$top/Benchmarks/vtk-requirements.txt"
  export FLIPFLOP_VTK_PYTHON="$venv/bin/python"
  # A case where VTK takes longer is told as such.
  limits=(--sizes 1e4,1e5,1e6 --repetitions 3 --max-case-seconds 15 --max-peer-seconds 15)
fi

for subject in "${subjects[@]}"; do
  page="$top/Documentation/Benchmarks.md"
  [[ "$subject" != vtk-* ]] || page="$top/Documentation/BenchmarksVtk.md"
  results="$top/build/benchmark/$subject"
  say "Run: $subject"
  "$top/build/benchmark/bin/$subject-benchmark" --validate "${limits[@]}" \
    --csv "$results.csv" --json "$results.json" "$@"

  say "Figures and tables: $subject"
  "$python" -B "$top/Benchmarks/plot-figures.py" "$subject" "$results.csv" --json "$results.json" \
    --figures "$top/Documentation/Figures" --markdown "$page"
done
