#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# install-dependencies.sh demo|test|fuzz|libcxx|mingw|benchmark|paraview|wheel...: install what is missing (Debian 12, Ubuntu 22.04
# or later). Where everything is there, nothing is done and no privilege is needed.
#
# paraview: what a build of the plugin needs beside ParaView itself, for which see install-paraview.sh.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

build=(g++ cmake ninja-build libtbb-dev libboost-dev libeigen3-dev)
vtk=(libvtk9-dev libpython3-dev python3-vtk9 python3-numpy xvfb)
peers=(libcgal-dev libqhull-dev)
tests=(ccache gappa libgtest-dev libgmp-dev clang-format mpi-default-bin mpi-default-dev doxygen graphviz)
# clang, and what comes with it only by itself: libFuzzer and the sanitizers.
fuzzers=(clang libclang-rt-dev)
libcxx=(clang libc++-dev libc++abi-dev)
# The tests' GoogleTest is built for Windows from its source.
mingw=(cmake ninja-build g++-mingw-w64-x86-64-posix libboost-dev libeigen3-dev googletest wine wine64)
# What ParaView's VTK asks for when CMake looks for it, MPI, the GUI's icons and, for those of the plugin, its Qt; what
# makes help pages; PyQt for the GUI's tests, and what its window of traces asks for.
plugin=(libpython3-dev python3-numpy libavcodec-dev libavformat-dev libavutil-dev libswscale-dev
  libdouble-conversion-dev libexpat1-dev liblz4-dev liblzma-dev libutfcpp-dev zlib1g-dev
  mpi-default-bin mpi-default-dev python3-pygments xvfb)
# Nothing is found, and find fails, where there is no ParaView.
config=$(find "$paraview"/lib* -maxdepth 4 -name paraview-config.cmake 2>/dev/null | head -n 1 || true)
if grep -qs 'PARAVIEW_QT_MAJOR_VERSION "6"' "$config"; then
  plugin+=(qt6-base-dev python3-pyqt6 qt6-tools-dev qt6-documentation-tools xsltproc libqt6sql6-sqlite)
else
  plugin+=(libqt5svg5 qtbase5-dev python3-pyqt5 qtxmlpatterns5-dev-tools qttools5-dev qttools5-dev-tools)
fi
if grep -qs '_paraview_use_external_vtk "ON"' "$config"; then
  plugin+=(libvtk9-dev)
fi

# The wheel's build environment comes from the package index; libgl1 and libxcursor1 are what the wheel vtk draws with.
wheel=(g++ libpython3-dev python3-venv libgl1 libxcursor1 xvfb)

packages=()
for purpose in "$@"; do
  case "$purpose" in
    demo) packages+=("${build[@]}" "${vtk[@]}") ;;
    test) packages+=("${build[@]}" "${vtk[@]}" "${peers[@]}" "${tests[@]}") ;;
    fuzz) packages+=("${build[@]}" "${vtk[@]}" "${peers[@]}" "${tests[@]}" "${fuzzers[@]}") ;;
    libcxx) packages+=("${libcxx[@]}") ;;
    mingw) packages+=("${mingw[@]}") ;;
    benchmark) packages+=("${build[@]}" "${peers[@]}" python3-matplotlib python3-venv) ;;
    paraview) packages+=("${build[@]}" "${plugin[@]}") ;;
    wheel) packages+=("${wheel[@]}") ;;
    *) echo "usage: install-dependencies.sh demo|test|fuzz|libcxx|mingw|benchmark|paraview|wheel..." >&2; exit 2 ;;
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
apt_get update
apt_get install -y --no-install-recommends "${missing[@]}"
