#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# photograph-paraview.sh: take the pictures of ParaView's window in Documentation/Figures again (paraview-*.png), with
# the plugin that test.sh paraview has built. Look at each before it is committed.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

pictures="$top/build/paraview/photographs"
rm -rf "$pictures"
export FLIPFLOP_BUILD="$top/build/paraview"
plugin=$(plugin_path "$FLIPFLOP_BUILD")
PV_PLUGIN_PATH="$plugin:${plugin}Icons" "$top/Testing/ParaView/Gui/run-in-paraview.sh" \
  "$paraview/bin/paraview" "$top/Testing/ParaView/Gui/photographs.py" "$pictures"
cp "$pictures"/paraview-*.png "$top/Documentation/Figures/"
