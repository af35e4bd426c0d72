#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run-in-paraview.sh PARAVIEW SCRIPT.py OUTPUT [SECONDS]: run a script in ParaView's window, on a display,
# with a home and with settings of its own, and say whether it passed. The environment names the
# plugin (PV_PLUGIN_PATH). What the script leaves is in the folder OUTPUT.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../../../Scripts/common.sh"

paraview=$1 script=$2 seconds=${4:-240}
mkdir -p "$3"
output=$(realpath "$3")
rm -rf "$output/home" "$output/passed" "$output/failed.png"
mkdir "$output/home"
export FLIPFLOP_GUI_OUTPUT="$output" FLIPFLOP_SOURCE="$top"
export HOME="$output/home" XDG_CONFIG_HOME="$output/home/config" XDG_RUNTIME_DIR="$output/home"
chmod 700 "$XDG_RUNTIME_DIR"
export PYTHONPATH="$top/Testing/ParaView/Gui${PYTHONPATH:+:$PYTHONPATH}" PYTHONDONTWRITEBYTECODE=1

"$python" -c 'import PyQt5.QtTest' 2>/dev/null || "$python" -c 'import PyQt6.QtTest' || {
  echo "The GUI's tests need python3-pyqt5, or python3-pyqt6 where ParaView has Qt 6." >&2
  exit 1
}

trap stop_display EXIT
start_display
# --dr: neither settings nor the welcome dialog. A ParaView that ends before its script does has failed.
timeout --kill-after=5 "$seconds" "$paraview" --dr --script="$script"
[ -e "$output/passed" ] || { echo "ParaView ended before $(basename "$script") had passed" >&2; exit 1; }
