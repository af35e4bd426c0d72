#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# install-dependencies.sh demo|test|benchmark...: install what is missing (Debian 12, Ubuntu 22.04 or
# later). Where everything is there, nothing is done and no privilege is needed.
set -euo pipefail

build=(g++ cmake ninja-build libtbb-dev libboost-dev)
vtk=(libvtk9-dev libpython3-dev python3-vtk9 python3-numpy xvfb)
peers=(libcgal-dev libqhull-dev)
tests=(libgtest-dev libgmp-dev clang-format)

packages=()
for purpose in "$@"; do
  case "$purpose" in
    demo) packages+=("${build[@]}" "${vtk[@]}") ;;
    test) packages+=("${build[@]}" "${vtk[@]}" "${peers[@]}" "${tests[@]}") ;;
    benchmark) packages+=("${build[@]}" "${peers[@]}" python3-matplotlib) ;;
    *) echo "usage: install-dependencies.sh demo|test|benchmark..." >&2; exit 2 ;;
  esac
done

missing=()
for package in $(printf '%s\n' "${packages[@]}" | sort -u); do
  state=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  # A package for several architectures answers once for each.
  [[ "$state" == installed* ]] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

echo "Installing: ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "Not root, and there is no sudo: install them first." >&2; exit 1; }
  as_root=(sudo)
fi
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends "${missing[@]}"
