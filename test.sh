#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# test.sh [quick|paraview|wheel]: install what is missing, check the formatting, build and run the tests: a part of them
# under the sanitizers (not with quick), then all but the nightly ones (Scripts/nightly.sh). With paraview: those of the
# ParaView plugin instead; with wheel: build the wheel, and test it in a clean virtual environment with PyVista. The
# first failure ends it; what is printed last is ctest's or pytest's summary.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/Scripts/common.sh"

what=${1:-all}
case "$what" in
  all | quick | paraview | wheel) ;;
  *) echo "usage: test.sh [quick|paraview|wheel]" >&2; exit 2 ;;
esac

trap stop_display EXIT

if [ "$what" = paraview ]; then
  "$top/Scripts/install-dependencies.sh" paraview
  "$top/Scripts/install-paraview.sh"
  start_display
  build_and_test paraview paraview -DFLIPFLOP_WARNINGS_AS_ERRORS=ON "${plugin_options[@]}"
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
  "$wheels/clean/bin/pip" install --quiet "$(echo "$wheels"/repaired/*.whl)[pyvista,vtk]" scipy pytest
  start_display
  (cd "$wheels" && PYTHONDONTWRITEBYTECODE=1 PYTHONPATH= "$wheels/clean/bin/python" -m pytest -rs \
    -p no:cacheprovider --override-ini 'python_files=Test*.py' "$top/Testing/Python" "$top/Testing/Wheel")
  exit
fi

"$top/Scripts/install-dependencies.sh" test
"$top/Scripts/check-format.sh"
[ -n "${DISPLAY:-}" ] || start_display

if [ "$what" = all ]; then
  fixed_layout
  build_and_test asan asan
  build_and_test tsan tsan
  layout=()
fi
build_and_test ci ci
