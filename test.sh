#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# test.sh [release|sanitizers|paraview|wheel|all]...: install what is missing, build and test. By default release.
#   release     formatting, the release build with warnings as errors, every test of it that is not nightly
#               (Scripts/nightly.sh)
#   sanitizers  a part of these under AddressSanitizer and UndefinedBehaviorSanitizer, and under ThreadSanitizer
#   paraview    the tests of the ParaView plugin
#   wheel       the wheel, in clean virtual environments, also with PyVista
# The first failure ends it. Last come each phase's time, and the verdict: passed, or what failed.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/Scripts/common.sh"

parts=("$@")
[ ${#parts[@]} -gt 0 ] || parts=(release)
[ "${parts[*]}" != all ] || parts=(release sanitizers paraview wheel)
for part in "${parts[@]}"; do
  case "$part" in
    release | sanitizers | paraview | wheel) ;;
    *) echo "usage: test.sh [release|sanitizers|paraview|wheel|all]..." >&2; exit 2 ;;
  esac
done

# install PURPOSE...: for Scripts/install-dependencies.sh; then there is a display
install() {
  begin "Install: $*"
  "$top/Scripts/install-dependencies.sh" "$@"
  [ -n "${DISPLAY:-}" ] || start_display
}

test_release() {
  install test
  begin "Formatting"
  "$top/Scripts/check-format.sh"
  "$top/Scripts/check-words.py"
  build_and_test ci ci "${device_code[@]}"
}

test_sanitizers() {
  install test
  fixed_layout
  build_and_test asan asan
  build_and_test tsan tsan
  layout=()
}

test_paraview() {
  install paraview
  "$top/Scripts/install-paraview.sh"
  build_and_test paraview paraview -DFLIPFLOP_WARNINGS_AS_ERRORS=ON "${plugin_options[@]}"
}

# in_clean FOLDER REQUIREMENTS FOLDER_OF_TESTS...: the tests, where nothing but these is installed
in_clean() {
  # No name of a package: the tests run beside it.
  local folder=$wheels/clean-$1 requirements=$2 name=$1
  shift 2
  "$python" -m venv --clear "$folder"
  "$folder/bin/pip" install --quiet --upgrade pip
  # shellcheck disable=SC2086
  "$folder/bin/pip" install --quiet $requirements
  logged "test-wheel-$name" cat env -C "$wheels" PYTHONDONTWRITEBYTECODE=1 PYTHONPATH= \
    "$folder/bin/python" -m pytest -rs -p no:cacheprovider --override-ini 'python_files=Test*.py' "$@"
}

test_wheel() {
  install wheel
  begin "Build: the wheel"
  local wheels="$top/build/wheel" wheel
  rm -f "$wheels"/*.whl
  # What pip would install for the build, in a folder that stays: ccache knows files by their folder.
  "$python" -m venv --clear "$wheels/tools"
  "$wheels/tools/bin/pip" install --quiet --upgrade pip
  # shellcheck disable=SC2046
  "$wheels/tools/bin/pip" install --quiet cmake ninja $("$python" -c 'import sys, tomllib
print(*tomllib.load(open(sys.argv[1], "rb"))["build-system"]["requires"])' "$top/pyproject.toml")
  use_ccache
  # The system's Boost and Eigen are hidden: pip's have to do.
  CMAKE_BUILD_PARALLEL_LEVEL=$(parallel_jobs) logged build-wheel now_and_then \
    "$wheels/tools/bin/pip" wheel "$top" --verbose --no-deps --no-build-isolation --wheel-dir "$wheels" \
    --config-settings=cmake.define.FLIPFLOP_WARNINGS_AS_ERRORS=ON \
    --config-settings='cmake.define.CMAKE_IGNORE_PREFIX_PATH=/;/usr;/usr/local'
  wheel=$(echo "$wheels"/*.whl)
  begin "Test: the wheel with numpy alone"
  in_clean numpy "$wheel pytest scipy mypy" "$top/Testing/Arrays" "$top/Testing/Wheel/TestPages.py" \
    "$top/Testing/Wheel/TestImports.py"
  begin "Test: the wheel with PyVista and the newest VTK"
  in_clean pyvista "$wheel[pyvista,vtk] pytest scipy mypy shapely geopandas rasterio scikit-fem meshio h5py" "$top/Testing/Python" \
    "$top/Testing/Wheel" "$top/Testing/Arrays/TestForms.py" "$top/Testing/Arrays/TestTyping.py" "$top/Testing/Arrays/TestSpatial.py" \
    "$top/Testing/Arrays/TestClipped.py" "$top/Testing/Arrays/TestSelection.py" "$top/Testing/Arrays/TestLines.py"
  test_both_kinds "$wheels/clean-pyvista"
}

# test_both_kinds FOLDER: the wheel's classes, installed there, beside the compiled ones of the release build
test_both_kinds() {
  local compiled="$top/build/ci/lib" package="$wheels/both/vtkflipflop"
  if [ ! -f "$compiled/python3/dist-packages/vtkflipflop/_vtk_check.py" ]; then
    say "Not run: the classes in Python beside the compiled ones, which ./test.sh builds"
    return
  fi
  begin "Test: the classes in Python beside the compiled ones"
  rm -rf "$package"
  mkdir -p "$package"
  cp "$1"/lib/python3*/site-packages/vtkflipflop/*.{py,so} "$package"
  cp "$compiled"/python3/dist-packages/vtkflipflop/{_vtk_check.py,vtkFilters*.so} "$package"
  logged test-both-kinds cat env LD_LIBRARY_PATH="$compiled" PYTHONPATH="$wheels/both" PYTHONDONTWRITEBYTECODE=1 \
    "$python" "$top/Testing/Python/TestBothKinds.py" -v
}

trap conclude EXIT
for part in "${parts[@]}"; do
  "test_$part"
done
