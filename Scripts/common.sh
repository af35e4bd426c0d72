# shellcheck shell=bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Sourced by the scripts: where things are, what to install, how to build, a display where there is none, what is printed.

top="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"

# What was compiled before, in this clone or another, is not compiled again where ccache is installed. (The sloppiness is
# what precompiled headers take.) Called after the installation.
use_ccache() {
  command -v ccache >/dev/null || return 0
  export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
  export CCACHE_BASEDIR="${CCACHE_BASEDIR:-$top}" CCACHE_NOHASHDIR="${CCACHE_NOHASHDIR:-1}"
  export CCACHE_SLOPPINESS="${CCACHE_SLOPPINESS:-pch_defines,time_macros}"
}

# Debian's own Python, whose vtk module belongs to libvtk9; another may come first in PATH.
python=/usr/bin/python3

# One compiler for every core, but no more than memory carries: VTK's headers take over 1 GiB each.
parallel_jobs() {
  local cores gibibytes
  cores=$(nproc)
  gibibytes=$(awk '/^MemAvailable:/ {print int($2 / 1048576 / 1.5)}' /proc/meminfo)
  echo $((gibibytes < 1 ? 1 : gibibytes < cores ? gibibytes : cores))
}

say() {
  printf '\n== %s\n' "$*"
}

# begin PHASE: what follows belongs to it, until the next begins.
phases=()
begin() {
  end_phase
  phase=$1 phase_begin=$SECONDS
  say "$phase"
}
end_phase() {
  [ -z "${phase:-}" ] || phases+=("$(printf '%6d s  %s' $((SECONDS - phase_begin)) "$phase")")
  phase=
}

# logged LOG FILTER COMMAND...: what the command prints goes into build/logs/LOG, and through the filter.
logged() {
  local filter=$2
  log="$top/build/logs/$1"
  shift 2
  mkdir -p "$top/build/logs"
  "$@" 2>&1 | tee "$log" | "$filter"
}
# A line at most every ten seconds: of a build.
now_and_then() {
  local line next=0
  while IFS= read -r line; do
    ((SECONDS < next)) || { printf '%s\n' "$line" && next=$((SECONDS + 10)); }
  done
}
# A line a test: without those that say that it starts.
without_starts() { grep --line-buffered -vE '^ *Start +[0-9]+: ' || true; }

# What went wrong, of a build's or a test's log: the first errors of a build, or the names of tests that failed.
errors_of() {
  if grep -q '^FAILED: ' "$1"; then
    sed -n '/^FAILED: /,$p' "$1" | grep -v '^\[[0-9]*/[0-9]*\]' | cut -c1-300 | head -n 40
  elif grep -qE '\*\*\*|^\[  FAILED  \]|^FAIL' "$1"; then
    grep -E '\*\*\*|^\[  FAILED  \]|^(FAIL|ERROR|FAILED): |: not so: |: Failure$|^Expected: |^E  ' "$1" | head -n 40
  else
    tail -n 20 "$1"
  fi
}

# On the way out of a script: the time of each phase, and last the verdict. A signal is a failure.
trap 'exit 130' INT
trap 'exit 143' TERM
conclude() {
  local status=$? failed=${phase:-}
  stop_display
  end_phase
  [ ${#phases[@]} -gt 0 ] || return "$status"
  say "Times"
  printf '%s\n' "${phases[@]}"
  if [ "$status" -eq 0 ]; then
    say "${success:-Passed}, in $SECONDS s"
  else
    say "Failed: $failed"
    if [ -n "${log:-}" ]; then
      errors_of "$log"
      echo "All of it: $log"
    fi
  fi
  exit "$status"
}

# as_root COMMAND...: with sudo, where we are not root
as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    echo "Not root, and there is no sudo: install them first." >&2
    return 1
  fi
}

apt_get() {
  as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq "$@"
}

# The prefix of the ParaView to build for: the user's, or what install-paraview.sh has put there.
paraview=$(realpath -m "${PARAVIEW_ROOT:-$top/build/paraview-root/usr}")
# The last one's place is in the build's cache.
plugin_options=(-UParaView_DIR -UVTK_DIR "-DCMAKE_PREFIX_PATH=$paraview")

# The preset ci insists on nvcc, for the device's code; where there is none, the rest is tested.
device_code=()
command -v nvcc >/dev/null || device_code=(-DFLIPFLOP_CUDA=OFF)

# What configure_and_build builds; by default everything.
targets=(all)

# configure_and_build PRESET FOLDER [OPTION OF CMAKE]...: in build/FOLDER
configure_and_build() {
  local preset=$1 folder=$2 build="$top/build/$2"
  shift 2
  use_ccache
  begin "Build: preset $preset in build/$folder"
  mkdir -p "$build"
  logged "configure-$folder" now_and_then \
    cmake -S "$top" --preset "$preset" -B "$build" -DPython3_EXECUTABLE="$python" "$@"
  logged "build-$folder" now_and_then \
    cmake --build "$build" --parallel "$(parallel_jobs)" --target "${targets[@]}"
}

# What comes before a test's command.
layout=()

# The sanitizers' shadow memory does not fit every random layout that newer kernels choose.
fixed_layout() {
  if setarch "$(uname -m)" -R true 2>/dev/null; then
    layout=(setarch "$(uname -m)" -R)
  fi
}

# build_and_test PRESET FOLDER [OPTION OF CMAKE]...: in build/FOLDER
build_and_test() {
  local preset=$1 folder=$2
  shift 2
  configure_and_build "$preset" "$folder" -DFLIPFLOP_ALL_TESTS=ON "$@"
  begin "Test: preset $preset in build/$folder"
  # One more than there are cores: some tests wait more than they compute.
  logged "test-$folder" without_starts "${layout[@]}" ctest --test-dir "$top/build/$folder" --output-on-failure \
    --no-tests=error --parallel $(($(parallel_jobs) + 1))
}

# A display of our own. Debian's VTK draws through X only; -displayfd picks a free number, -noreset
# keeps the server alive between clients.
start_display() {
  local file number=
  file=$(mktemp)
  Xvfb -displayfd 3 -noreset -nolisten tcp -screen 0 1600x1200x24 \
    3>"$file" >/dev/null 2>&1 &
  display_process=$!
  for _ in $(seq 100); do
    number=$(cat "$file")
    [ -n "$number" ] && break
    kill -0 "$display_process" 2>/dev/null || break
    sleep 0.1
  done
  rm -f "$file"
  [ -n "$number" ] || { echo "Xvfb did not start" >&2; return 1; }
  export DISPLAY=":$number"
  unset WAYLAND_DISPLAY XAUTHORITY
}

stop_display() {
  [ -z "${display_process:-}" ] || kill "$display_process" 2>/dev/null || true
  display_process=
}

# cached BUILD NAME: what CMake keeps under that name
cached() {
  sed -n "s/^$2:INTERNAL=//p" "$1/CMakeCache.txt"
}

# python_path BUILD: the folder that holds the package vtkflipflop
python_path() {
  local path
  path=$(cached "$1" FLIPFLOP_PYTHONPATH)
  [ -d "$path/vtkflipflop" ] || { echo "$1 holds no Python package vtkflipflop" >&2; return 1; }
  echo "$path"
}

# plugin_path BUILD: the folder that holds the ParaView plugin
plugin_path() {
  local path
  path=$(cached "$1" FLIPFLOP_PLUGIN_PATH)
  [ -f "$path/FlipFlop.so" ] || { echo "$1 holds no ParaView plugin" >&2; return 1; }
  echo "$path"
}
