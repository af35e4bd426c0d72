#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# test.sh [quick|paraview|wheel]: install what is missing, check the formatting, build and run every test: under
# the sanitizers (not with quick), then with the filters and Python. With paraview: those of the ParaView
# plugin instead; with wheel: build the wheel, and test it in a clean virtual environment with PyVista. The first
# failure ends it; what is printed last is ctest's or pytest's summary.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/Scripts/common.sh"

what=${1:-all}
case "$what" in
  all | quick | paraview | wheel) ;;
  *) echo "usage: test.sh [quick|paraview|wheel]" >&2; exit 2 ;;
esac

# build_and_test PRESET [OPTION OF CMAKE]...
build_and_test() {
  local preset=$1
  shift
  configure_and_build "$preset" "$preset" -DFLIPFLOP_ALL_TESTS=ON "$@"
  say "Test: preset $preset"
  "${layout[@]}" ctest --test-dir "$top/build/$preset" --output-on-failure --no-tests=error \
    --parallel "$(parallel_jobs)"
}

layout=()
trap stop_display EXIT

if [ "$what" = paraview ]; then
  "$top/Scripts/install-dependencies.sh" paraview
  "$top/Scripts/install-paraview.sh"
  start_display
  build_and_test paraview "${plugin_options[@]}"
  exit
fi

if [ "$what" = wheel ]; then
  "$top/Scripts/install-dependencies.sh" wheel
  wheels="$top/build/wheel"
  "$top/Scripts/wheel/build-wheel.sh" "$wheels" \
    --config-settings=cmake.define.FLIPFLOP_WARNINGS_AS_ERRORS=ON
  say "Test: the wheel in a clean environment"
  "$python" -m venv --clear "$wheels/clean"
  "$wheels/clean/bin/pip" install --quiet --upgrade pip
  "$wheels/clean/bin/pip" install --quiet "$(echo "$wheels"/repaired/*.whl)[pyvista]" pytest tqdm
  start_display
  (cd "$wheels" && PYTHONDONTWRITEBYTECODE=1 PYTHONPATH= "$wheels/clean/bin/python" -m pytest -rs \
    -p no:cacheprovider --override-ini 'python_files=Test*.py' "$top/Testing/Python" "$top/Testing/Wheel")
  exit
fi

"$top/Scripts/install-dependencies.sh" test
"$top/Scripts/check-format.sh"
[ -n "${DISPLAY:-}" ] || start_display

# The sanitizers' shadow memory does not fit every random layout that newer kernels choose.
if [ "$what" = all ]; then
  if setarch "$(uname -m)" -R true 2>/dev/null; then
    layout=(setarch "$(uname -m)" -R)
  fi
  build_and_test asan
  build_and_test tsan
  layout=()
fi
build_and_test ci
