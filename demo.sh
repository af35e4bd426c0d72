#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# demo.sh [FILE.vtp...]: install what is missing, build, and take the convex hulls of the files (by
# default all of Data/) and the triangulations of those that are terrain, through the VTK filters.
# What comes out, and pictures of it, goes to demo-output/.
set -euo pipefail
here=$PWD
source "$(dirname "${BASH_SOURCE[0]}")/Scripts/common.sh"

inputs=()
for file in "$@"; do
  case "$file" in
    /*) inputs+=("$file") ;;
    *) inputs+=("$here/$file") ;;
  esac
done
[ ${#inputs[@]} -gt 0 ] || inputs=("$top"/Data/*.vtp)

"$top/Scripts/install-dependencies.sh" demo
configure_and_build default demo -DFLIPFLOP_BUILD_TESTING=OFF -DFLIPFLOP_BUILD_EXAMPLES=OFF

trap stop_display EXIT
start_display
say "Convex hulls and triangulations"
PYTHONPATH="$(python_path "$top/build/demo")" \
  "$python" "$top/Scripts/demo.py" --output "$top/demo-output" "${inputs[@]}"
