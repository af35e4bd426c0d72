#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# gpu.sh [--dependencies FOLDER] [--output FOLDER] [--quick] [PART...]: on a machine with an NVIDIA GPU, build the CUDA
# engine, test it on the device, by itself and under compute-sanitizer, and measure it; in less than nine minutes.
#
# Each part is useful alone, and takes less than nine minutes; all of them in one call share these:
#   tests   the device test, compute-sanitizer, the device's floors
#   device  the engine alone, the most points first: whole runs, with the device's own times of each stage; kernels; a
#           pass of Nsight Compute
#   peers   beside the CPU engine and Qhull, and from how many points on the device is faster
# In a bundle (gpu-bundle.sh), nothing is built.
# --dependencies: what gather-dependencies.sh has put there. --output (build/gpu/results): for log.txt,
# memcheck.txt, initcheck.txt, a CSV for each section of Benchmarks/Cuda/device.plan, and tables.md. --quick: small
# sizes only. FLIPFLOP_GPU_SECONDS in the environment: another limit for all.
#
# Exit status: 0; 1 where a step failed, whose successors ran all the same; 77 where there is no device.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

no_device=77
sanitizer_found=99 # as we ask it to exit where it found something
build="$top/build/gpu"
plan="$top/Benchmarks/Cuda/device.plan"
# A bundle has the programs beside Scripts/.
prebuilt=
if [ -x "$top/bin/flipflop-device-test" ]; then
  prebuilt=yes
  build=$top
  # The C++ library in the bundle takes a newer C library than the programs do.
  if ldd "$build/bin/flipflop-device-test" | grep -qE 'lib(stdc\+\+|gcc_s)\.so.*not found'; then
    export LD_LIBRARY_PATH="$top/lib/standard${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
  fi
fi
dependencies=
parts=()
output="$build/results"
quick=
while [ $# -gt 0 ]; do
  case "$1" in
    --dependencies) dependencies=$(cd "$2" && pwd); shift 2 ;;
    --output) output=$2; shift 2 ;;
    --quick) quick=yes; shift ;;
    tests | device | peers) parts+=("$1"); shift ;;
    *) echo "usage: gpu.sh [--dependencies FOLDER] [--output FOLDER] [--quick] [tests|device|peers]..." >&2; exit 2 ;;
  esac
done
[ ${#parts[@]} -gt 0 ] || parts=(tests device peers)
has() {
  [[ " ${parts[*]} " == *" $1 "* ]]
}
mkdir -p "$output"
output=$(cd "$output" && pwd)
export PATH="$PATH:/usr/local/cuda/bin"

allowed=${FLIPFLOP_GPU_SECONDS:-520}
measuring=$((allowed / 4)) # kept for the benchmark, whatever the tests take
has device || has peers || measuring=20
left() {
  echo $((allowed - SECONDS))
}

summary=()
failed=
# note WORD TEXT
note() {
  summary+=("$(printf '%-8s %s' "$1" "$2")")
  [ "$1" != FAILED ] || failed=yes
}

# step NAME SECONDS RESERVED COMMAND...: run it for no longer than that, and so that the time reserved for what
# follows remains. Returns its status, or 124 where its time was up or there was none.
step() {
  local name=$1 limit=$2 most=$(($(left) - $3)) status=0 since=$SECONDS
  shift 3
  [ "$limit" -le "$most" ] || limit=$most
  if [ "$limit" -le 0 ]; then
    note skipped "$name: no time is left"
    return 124
  fi
  say "$name (for $limit s at most)"
  timeout --kill-after=5 "$limit" "$@" || status=$?
  case "$status" in
    0) note ok "$name: $((SECONDS - since)) s" ;;
    "$no_device") note skipped "$name: there is no device" ;;
    124 | 137) note FAILED "$name: not done in $limit s" ;;
    *) note FAILED "$name: status $status after $((SECONDS - since)) s" ;;
  esac
  return "$status"
}

# sanitize TOOL BEGINNING [OPTION]...: the small ones of the checks whose names begin so
sanitize() {
  local tool=$1 checks=$2 test="$build/bin/flipflop-device-test" file="$output/$1.txt" probe=0 status=0
  shift 2
  local command=(compute-sanitizer --tool "$tool" "$@" --error-exitcode "$sanitizer_found")
  if ! command -v compute-sanitizer >/dev/null; then
    note skipped "$tool: there is no compute-sanitizer"
    return
  fi
  local most=$(($(left) - measuring))
  if [ "$most" -le 0 ]; then
    note skipped "$tool: no time is left"
    return
  fi
  # Where it does not work at all, as in some virtual machines, that is not the engine's fault.
  timeout --kill-after=5 $((most < 40 ? most : 40)) \
    "${command[@]}" "$test" --only probe >"$file" 2>&1 || probe=$?
  if [ "$probe" -ne 0 ] && [ "$probe" -ne "$sanitizer_found" ]; then
    tail -n 5 "$file"
    note skipped "$tool: compute-sanitizer does not work here (status $probe)"
    return
  fi
  step "$tool" 80 "$measuring" "${command[@]}" "$test" --small --only "$checks" >>"$file" 2>&1 || status=$?
  [ "$status" -ne "$sanitizer_found" ] || grep -m 40 '^=====' "$file" || true
  tail -n 3 "$file"
}

# One pass of Nsight Compute over launches of the three busiest kernels, where all points are extreme.
profile() {
  if ! command -v ncu >/dev/null; then
    note skipped "ncu: it is not there"
    return
  fi
  mkdir -p "$output/ncu"
  step "ncu" 90 "$measuring" ncu --kernel-name-base demangled --kernel-name 'regex:(Relocate|Check|Relink)<' \
    --launch-skip 30 --launch-count 30 --section SpeedOfLight --section MemoryWorkloadAnalysis --section Occupancy \
    --section LaunchStats "$build/bin/flipflop-benchmark" "$plan" kernels-space "output=$output/ncu" counts=1e6 \
    families=shell0 >"$output/ncu.txt" || true
  tail -n 3 "$output/ncu.txt"
}

# measure NAME SHARE SECTION...: sections of the plan for SHARE tenths of the time that is left. It ends by itself once its
# time is up, except for the case at hand.
measure() {
  local name=$1 seconds=$(($(left) * $2 / 10))
  shift 2
  local options=("output=$output" "max-seconds=$seconds" "max-peer-seconds=$((seconds / 8))")
  [ -z "$quick" ] || options+=("counts=1e5,1e4" repetitions=3)
  step "Benchmark of $name" "$(left)" 5 "$build/bin/flipflop-benchmark" "$plan" "$@" "${options[@]}" || true
}

main() {
  local options=() tested=0
  if [ -z "$prebuilt" ]; then
    [ -z "$dependencies" ] || options+=("-DCMAKE_PREFIX_PATH=$dependencies")
    if ! step Configure 60 0 cmake -S "$top" --preset gpu -B "$build" "${options[@]}" ||
      ! step Build 240 0 cmake --build "$build" --parallel "$(parallel_jobs)"; then
      return 1
    fi
  fi

  options=()
  [ -z "$quick" ] || options+=(--small)
  has tests || options=(--only probe)
  step "Device test" 130 "$measuring" "$build/bin/flipflop-device-test" "${options[@]}" || tested=$?
  [ "$tested" -ne "$no_device" ] || return "$no_device"
  if has tests; then
    sanitize memcheck "" --leak-check full
    sanitize initcheck rounds/
    measure floors 8 floors
  fi
  if has device; then
    measure engines 4 device-hull device-triangulation
    measure kernels 5 kernels-space kernels-plane
    profile
  fi
  if has peers; then
    measure peers 6 peers-hull peers-triangulation
    measure crossover 8 crossover-hull crossover-triangulation
  fi
  local results
  for results in "$output"/*.csv; do
    echo "### $(basename "$results" .csv)"
    python3 -B "$top/Benchmarks/report.py" "$results"
  done >"$output/tables.md" || note FAILED report.py
  [ -z "$failed" ]
}

whole() {
  local status=0
  main || status=$?
  say "After $SECONDS s, with results in $output"
  printf '%s\n' "${summary[@]}"
  return "$status"
}

status=0
whole 2>&1 | tee "$output/log.txt" || status=${PIPESTATUS[0]}
exit "$status"
