#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# test.sh [quick]: install what is missing, check the formatting, build and run every test: under the
# sanitizers (not with quick), then with the filters and Python. The first failure ends it; what is
# printed last is ctest's summary.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/Scripts/common.sh"

quick=
case "${1:-}" in
  "") ;;
  quick) quick=yes ;;
  *) echo "usage: test.sh [quick]" >&2; exit 2 ;;
esac

# run_tests PRESET [COMMAND...]: build it, then ctest through COMMAND
run_tests() {
  local preset=$1
  shift
  configure_and_build "$preset" "$preset"
  say "Test: preset $preset"
  "$@" ctest --test-dir "$top/build/$preset" --output-on-failure --no-tests=error \
    --parallel "$(parallel_jobs)"
}

"$top/Scripts/install-dependencies.sh" test
"$top/Scripts/check-format.sh"

trap stop_display EXIT
[ -n "${DISPLAY:-}" ] || start_display

if [ -z "$quick" ]; then
  run_tests asan
  # ThreadSanitizer's shadow does not fit every random memory layout of newer kernels.
  layout=()
  if setarch "$(uname -m)" -R true 2>/dev/null; then
    layout=(setarch "$(uname -m)" -R)
  fi
  run_tests tsan "${layout[@]}"
fi
run_tests ci
