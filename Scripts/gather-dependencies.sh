#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# gather-dependencies.sh FOLDER: put into FOLDER what Scripts/gpu.sh needs on a machine that has CUDA and
# CMake, but neither oneTBB nor Boost nor Eigen nor Qhull, and cannot install them. FOLDER can be moved;
# `cmake -DCMAKE_PREFIX_PATH=FOLDER` finds everything in it. It takes g++, libboost-dev, libeigen3-dev and Debian's or Ubuntu's
# package lists (apt-get update), and no privilege. The other machine's C library must not be older.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

[ $# -eq 1 ] || { echo "usage: gather-dependencies.sh FOLDER" >&2; exit 2; }
mkdir -p "$1"
folder=$(cd "$1" && pwd)
[ -z "$(ls -A "$folder")" ] || { echo "$folder is not empty" >&2; exit 2; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

say "oneTBB and Qhull: from packages"
# Libraries' packages carry their version in their name: development packages tell it.
# runtime_of PACKAGE PATTERN
runtime_of() {
  local found
  found=$(apt-cache depends "$1" | sed -n "s/^[ |]*[A-Z][a-z]*: *\($2\)\$/\1/p" | head -1)
  [ -n "$found" ] || { echo "$1 depends on no $2" >&2; return 1; }
  echo "$found"
}
tbb=$(runtime_of libtbb-dev 'libtbb[0-9]*')
malloc=$(runtime_of "$tbb" 'libtbbmalloc[0-9]*')
qhull=$(runtime_of libqhull-dev 'libqhull-r[0-9.]*')
packages=(libtbb-dev "$tbb" "$malloc" libqhull-dev "$qhull")
printf '%s\n' "${packages[@]}"
(cd "$work" && apt-get download -qq -o APT::Sandbox::User=root "${packages[@]}")
for package in "$work"/*.deb; do
  dpkg -x "$package" "$work/unpacked"
done

mkdir -p "$folder/include" "$folder/lib/cmake"
for headers in tbb oneapi libqhull_r; do
  cp -R "$work/unpacked/usr/include/$headers" "$folder/include/"
done
# Under the names that programs ask for; no links, which not every way of copying keeps.
for library in libtbb libtbbmalloc libqhull_r; do
  for found in "$work"/unpacked/usr/lib/*/"$library".so.*; do
    name=$(objdump -p "$found" | awk '$1 == "SONAME" {print $2}')
    [ "${found##*/}" != "$name" ] || cp -L "$found" "$folder/lib/"
  done
done

say "Boost: the headers that the engine includes"
# All of its configuration: another compiler may take another part of it.
for source in "$top"/Engine/*/*.cxx "$top"/Cuda/*/*.cxx; do
  g++ -std=c++17 -isystem /usr/include/eigen3 -I "$top/Engine" -I "$top/Engine/include" -I "$top/Cuda" -I "$top/Cuda/include" -M "$source"
done | tr -s ' \\' '\n' | sed -n 's|^.*/include/boost/|boost/|p' | sort -u >"$work/boost"
includes=$(printf '#include <boost/version.hpp>\n' | g++ -xc++ -M - | tr -s ' \\' '\n' |
  sed -n 's|/boost/version.hpp$||p')
tar -C "$includes" -c --dereference --files-from "$work/boost" boost/config | tar -C "$folder/include" -x

say "Eigen: its headers"
cp -R /usr/include/eigen3/Eigen "$folder/include/"

# The packages' own files for CMake insist on all that the packages hold.
# imported NAME TARGET KIND [LIBRARY]
imported() {
  local library=
  [ -z "${4:-}" ] || library=$(basename "$folder/lib/$4".so.*)
  mkdir -p "$folder/lib/cmake/$1"
  {
    printf 'get_filename_component(prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)\n'
    printf 'if(NOT TARGET %s)\n  add_library(%s %s IMPORTED)\n' "$2" "$2" "$3"
    printf '  set_target_properties(%s PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${prefix}/include")\n' "$2"
    [ -z "$library" ] ||
      printf '  set_target_properties(%s PROPERTIES IMPORTED_LOCATION "${prefix}/lib/%s")\n' "$2" "$library"
    printf 'endif()\n'
  } >"$folder/lib/cmake/$1/$1Config.cmake"
}
imported TBB TBB::tbb SHARED libtbb
imported Qhull Qhull::qhull_r SHARED libqhull_r
imported Boost Boost::headers INTERFACE
imported Eigen3 Eigen3::Eigen INTERFACE

say "Gathered in $folder"
du -sh "$folder"
