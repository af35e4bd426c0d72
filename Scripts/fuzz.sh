#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# fuzz.sh Engine|Filters SECONDS [OPTION OF LIBFUZZER]...: build the fuzzer with the preset fuzz, and run it for so
# long from the tree's corpus and from what earlier runs have found, which is kept in build/fuzz/corpus. It stops at
# a finding; the input is then in build/fuzz/findings, and build/fuzz/bin/Fuzz...Replay FILE runs it again.
#
# fuzz.sh Engine|Filters minimise: make the tree's corpus anew, as few of those inputs as reach the same code.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

usage() {
  echo "usage: fuzz.sh Engine|Filters SECONDS|minimise [OPTION OF LIBFUZZER]..." >&2
  exit 2
}
[ $# -ge 2 ] || usage
entry=$1 what=$2
shift 2
[[ "$entry" =~ ^(Engine|Filters)$ && "$what" =~ ^([0-9]+|minimise)$ ]] || usage

"$top/Scripts/install-dependencies.sh" fuzz
use_ccache
build="$top/build/fuzz"
say "Build: preset fuzz in $build"
(cd "$top" && cmake --preset fuzz)
cmake --build "$build" --parallel "$(parallel_jobs)" --target "Fuzz$entry" "Fuzz${entry}Replay"

tree="$top/Testing/Fuzz/Corpus/$entry"
grown="$build/corpus/$entry"
findings="$build/findings"
mkdir -p "$grown" "$findings"
fuzzer=("$build/bin/Fuzz$entry" -max_len=1024 -timeout=120 -rss_limit_mb=4096 -print_final_stats=1
  "-artifact_prefix=$findings/$entry-")
# A random layout of newer kernels may leave no room for the sanitizers' shadow memory.
if setarch "$(uname -m)" -R true 2>/dev/null; then
  fuzzer=(setarch "$(uname -m)" -R "${fuzzer[@]}")
fi
# libFuzzer must see VTK's leaks no more than ours; what is VTK's own is named with a reason.
export LSAN_OPTIONS="suppressions=$top/Testing/Fuzz/leaks.txt:print_suppressions=0"

if [ "$what" = minimise ]; then
  kept=$(mktemp -d)
  trap 'rm -rf "$kept"' EXIT
  "${fuzzer[@]}" -set_cover_merge=1 -use_counters=0 "$kept" "$tree" "$grown"
  # What a fault was found by stays: the names of those files tell it.
  find "$tree" -type f -regextype posix-extended -regex '.*/[0-9a-f]{40}' -delete
  cp "$kept"/* "$tree"
  exit
fi
say "Fuzz: $entry, $what seconds"
"${fuzzer[@]}" "-max_total_time=$what" "$@" "$grown" "$tree"
