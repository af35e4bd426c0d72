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
  "$top/Scripts/wheel/build-wheel.sh" "$wheels" --config-settings=cmake.define.FLIPFLOP_WARNINGS_AS_ERRORS=ON
  wheel=$(echo "$wheels"/repaired/*.whl)
  # in_clean FOLDER REQUIREMENTS FOLDER_OF_TESTS...: the tests, where nothing but these is installed
  in_clean() {
    # No name of a package: the tests run beside it.
    local folder=$wheels/clean-$1 requirements=$2
    shift 2
    "$python" -m venv --clear "$folder"
    "$folder/bin/pip" install --quiet --upgrade pip
    # shellcheck disable=SC2086
    "$folder/bin/pip" install --quiet $requirements
    (cd "$wheels" && PYTHONDONTWRITEBYTECODE=1 PYTHONPATH= "$folder/bin/python" -m pytest -rs \
      -p no:cacheprovider --override-ini 'python_files=Test*.py' "$@")
  }
  say "Test: the wheel with numpy alone"
  in_clean numpy "$wheel pytest scipy mypy" "$top/Testing/Arrays" "$top/Testing/Wheel/TestPages.py" \
    "$top/Testing/Wheel/TestImports.py"
  say "Test: the wheel with PyVista and the VTK of its classes"
  start_display
  in_clean pyvista "$wheel[pyvista,vtk] pytest scipy mypy shapely geopandas rasterio" "$top/Testing/Python" "$top/Testing/Wheel" \
    "$top/Testing/Arrays/TestForms.py" "$top/Testing/Arrays/TestTyping.py"
  exit
fi

"$top/Scripts/install-dependencies.sh" test
"$top/Scripts/check-format.sh"
"$top/Scripts/check-words.py"
[ -n "${DISPLAY:-}" ] || start_display

if [ "$what" = all ]; then
  fixed_layout
  build_and_test asan asan
  build_and_test tsan tsan
  layout=()
fi
build_and_test ci ci "${device_code[@]}"
