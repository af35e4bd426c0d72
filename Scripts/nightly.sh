#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# nightly.sh [sanitizers|tests|checker|compilers|windows|wheels|reference|fuzz]...: what takes too long for every change. By default all:
#   sanitizers  every test that a sanitizer can find something in (test.sh runs a part of them), and where there is
#               nvcc, the device's code
#   tests       the tests that only FLIPFLOP_NIGHTLY builds: the tests of the tests, by mutants; the pictures beside
#               their sources; the device code's budgets for every architecture
#   checker     10,000 random results, and mutants of some, by the program that shares nothing with the engine
#   compilers   clang with libc++, compiled only
#   windows     MinGW-w64, run by Wine
#   wheels      the wheels for each Python that is here, beside each VTK and PyVista (Testing/Wheel/matrix.py)
#   reference   the reference of C++ and of Python, rendered
#   fuzz        each fuzzer for half an hour
# The first failure ends it.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

parts=("$@")
[ ${#parts[@]} -gt 0 ] || parts=(sanitizers tests checker compilers windows wheels reference fuzz)

for part in "${parts[@]}"; do
  case "$part" in
    sanitizers | tests | checker | compilers | windows | wheels | reference | fuzz) ;;
    *) echo "usage: nightly.sh [sanitizers|tests|checker|compilers|windows|wheels|reference|fuzz]..." >&2; exit 2 ;;
  esac
done

trap conclude EXIT
"$top/Scripts/install-dependencies.sh" test
use_ccache
[ -n "${DISPLAY:-}" ] || start_display
for part in "${parts[@]}"; do
  begin "Nightly: $part"
  case "$part" in
    sanitizers)
      fixed_layout
      build_and_test asan asan-nightly -DFLIPFLOP_NIGHTLY=ON
      build_and_test tsan tsan-nightly -DFLIPFLOP_NIGHTLY=ON
      build="$top/build/tsan-filters"
      (cd "$top" && cmake --preset tsan -B "$build" -DFLIPFLOP_BUILD_FILTERS=ON -DFLIPFLOP_WRAP_PYTHON=OFF \
        -DPython3_EXECUTABLE="$python")
      cmake --build "$build" --target FiltersFlipFlopCxxTests --parallel "$(parallel_jobs)"
      say "Test: filters updated by two threads at once, under ThreadSanitizer"
      "${layout[@]}" "$build/bin/FiltersFlipFlopCxxTests" TestFFTwoAtOnce
      if command -v nvcc >/dev/null; then
        build="$top/build/stand-in-tsan"
        (cd "$top" && cmake --preset stand-in-tsan -B "$build" -DPython3_EXECUTABLE="$python")
        cmake --build "$build" --target flipflop-device-test-stand-in --parallel "$(parallel_jobs)"
        say "Test: the device's code, on the stand-in, under ThreadSanitizer"
        "${layout[@]}" "$build/bin/flipflop-device-test-stand-in" --small
      fi
      layout=()
      ;;
    tests) build_and_test ci ci-nightly -DFLIPFLOP_NIGHTLY=ON "${device_code[@]}" ;;
    checker)
      "$top/Scripts/install-dependencies.sh" wheel
      "$python" -m venv --clear "$top/build/checker"
      "$top/build/checker/bin/pip" install --quiet "$top" pytest
      FLIPFLOP_CHECKER_CASES=2000 "$top/build/checker/bin/python" -m pytest -p no:cacheprovider \
        --override-ini 'python_files=Test*.py' "$top/Testing/Arrays/TestChecker.py"
      ;;
    compilers) "$top/Scripts/libcxx.sh" ;;
    windows) "$top/Scripts/mingw.sh" ;;
    wheels)
      "$top/Scripts/install-dependencies.sh" wheel
      rm -rf "$top/build/wheels"
      # From 3.12 on, the last one's is for all.
      for name in python3.11 python3.12 python3.13 python3.14; do
        "$name" -c "" 2>/dev/null || continue
        "$name" -m venv "$top/build/wheels/$name"
        "$top/build/wheels/$name/bin/pip" wheel "$top" --no-deps --wheel-dir "$top/build/wheels"
      done
      "$python" "$top/Testing/Wheel/matrix.py" "$top"/build/wheels/*.whl
      ;;
    reference) "$top/Scripts/build-reference.sh" ;;
    fuzz)
      for entry in Engine Filters; do
        "$top/Scripts/fuzz.sh" "$entry" 1800
      done
      ;;
  esac
done
