#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# link-paraview-modules.sh: Debian testing's python3-paraview (6.1.1+dfsg1-3) has its modules as X.cpython-314-*.so, but
# paraview-dev's CMake files look for X.so, and no project finds ParaView. Give each module a link of that name.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

for module in "$paraview"/lib/python3/dist-packages/paraview/*/*.cpython-*.so; do
  link=${module%%.cpython-*}.so
  [ ! -e "$module" ] || [ -e "$link" ] || as_root ln -s "$(basename "$module")" "$link"
done
