#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# demo.sh [paraview] [FILE.vtp...]: install what is missing, build, and take the convex hulls of the files
# (by default all of Data/) and the triangulations of those that are terrain, through the VTK filters or, with
# paraview, through the ParaView plugin. What comes out, and pictures of it, goes to demo-output/ or
# demo-output/paraview/.
set -euo pipefail
here=$PWD
source "$(dirname "${BASH_SOURCE[0]}")/Scripts/common.sh"

plugin=
if [ "${1:-}" = paraview ]; then
  plugin=yes
  shift
fi

inputs=()
for file in "$@"; do
  case "$file" in
    /*) inputs+=("$file") ;;
    *) inputs+=("$here/$file") ;;
  esac
done
[ ${#inputs[@]} -gt 0 ] || inputs=("$top"/Data/*.vtp)

success=Done
trap conclude EXIT
if [ -n "$plugin" ]; then
  begin "Install"
  "$top/Scripts/install-dependencies.sh" paraview
  "$top/Scripts/install-paraview.sh"
  configure_and_build paraview paraview -DBUILD_TESTING=OFF -DFLIPFLOP_WRAP_PYTHON=OFF "${plugin_options[@]}"
  start_display
  begin "Convex hulls and triangulations in ParaView"
  export PV_PLUGIN_PATH
  PV_PLUGIN_PATH=$(plugin_path "$top/build/paraview")
  "$paraview/bin/pvpython" --dr "$top/Scripts/demo/demo.py" --paraview \
    --output "$top/demo-output/paraview" "${inputs[@]}"
  say "The GUI with the plugin"
  echo "PV_PLUGIN_PATH=$PV_PLUGIN_PATH $paraview/bin/paraview"
  echo "then open a file of Data/ and choose Filters > Flip-Flop"
  exit
fi

begin "Install"
"$top/Scripts/install-dependencies.sh" demo
targets=(vtkFiltersFlipFlopPython)
configure_and_build default demo -DBUILD_TESTING=OFF
start_display
begin "Convex hulls and triangulations"
PYTHONPATH="$(python_path "$top/build/demo")" \
  "$python" "$top/Scripts/demo/demo.py" --output "$top/demo-output" "${inputs[@]}"
