#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# mingw.sh [OPTION OF GOOGLETEST]...: build the engine and its tests for Windows by MinGW-w64, on std::thread, and run them by
# Wine. What the tests take is put in build/mingw-root: GoogleTest, GMP and MPFR are built from Debian's sources, Boost,
# Eigen and CGAL are headers.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$top/Scripts/install-dependencies.sh" test mingw
use_ccache
root="$top/build/mingw-root"
sources="$top/build/mingw-sources"
mkdir -p "$root/include" "$root/lib/cmake/CGAL" "$sources"

# fetch_source PACKAGE: its source package, from where this machine's packages come from, by lists of our own
fetch_source() {
  local file options=(-o Dir::Etc::SourceList=/dev/null -o "Dir::Etc::SourceParts=$sources/parts"
    -o "Dir::State::Lists=$sources/lists" -o APT::Sandbox::User=root)
  if [ ! -d "$sources/parts" ]; then
    mkdir -p "$sources/parts" "$sources/lists/partial"
    for file in /etc/apt/sources.list /etc/apt/sources.list.d/*; do
      [ ! -s "$file" ] || sed -e 's/^Types: *deb *$/Types: deb-src/' -e 's/^deb /deb-src /' "$file" \
        >"$sources/parts/$(basename "$file")"
    done
    apt-get -qq "${options[@]}" update || true # others' archives may have no sources
  fi
  (cd "$sources" && apt-get -qq "${options[@]}" source --download-only "$1")
}

# build_library PACKAGE LIBRARY [OPTION OF CONFIGURE]...
build_library() {
  local package=$1 library=$2 folder="$sources/$1"
  shift 2
  [ ! -f "$root/lib/$library" ] || return 0
  say "Build: $package for Windows"
  fetch_source "$package"
  rm -rf "$folder"
  mkdir -p "$folder"
  tar -xf "$(ls "$sources/$package"*_*.orig.tar.*z | head -1)" -C "$folder" --strip-components=1
  # Debian leaves GMP's manual out, which its makefiles ask for.
  [ -e "$folder/doc/Makefile.in" ] || { mkdir -p "$folder/doc" && printf '%%:\n\t@:\n' >"$folder/doc/Makefile.in"; }
  (cd "$folder" && ./configure --host=x86_64-w64-mingw32 --prefix="$root" --disable-shared --enable-static \
    CC=x86_64-w64-mingw32-gcc-posix CXX=x86_64-w64-mingw32-g++-posix CC_FOR_BUILD=gcc CFLAGS=-O2 CXXFLAGS=-O2 "$@" \
    && make -j"$(parallel_jobs)" && make install) >"$folder.log" 2>&1 || { tail -40 "$folder.log"; return 1; }
}

build_library gmp libgmpxx.a --enable-cxx
build_library mpfr4 libmpfr.a --with-gmp="$root"
for headers in boost CGAL; do
  ln -sfn "/usr/include/$headers" "$root/include/$headers"
done
# Debian's own file would bring the headers of Linux.
cat >"$root/lib/cmake/CGAL/CGALConfig.cmake" <<'END'
add_library(CGAL::CGAL INTERFACE IMPORTED)
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
set_target_properties(CGAL::CGAL PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "${root}/include"
  INTERFACE_COMPILE_DEFINITIONS "CGAL_USE_GMP=1;CGAL_USE_MPFR=1"
  INTERFACE_COMPILE_OPTIONS -frounding-math
  INTERFACE_LINK_LIBRARIES "${root}/lib/libmpfr.a;${root}/lib/libgmp.a")
END
ln -sfn /usr/include/eigen3/Eigen "$root/include/Eigen"
mkdir -p "$root/lib/cmake/Eigen3"
cat >"$root/lib/cmake/Eigen3/Eigen3Config.cmake" <<'END'
add_library(Eigen3::Eigen INTERFACE IMPORTED)
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
set_target_properties(Eigen3::Eigen PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${root}/include")
END
if [ ! -f "$root/lib/libgtest.a" ]; then
  say "Build: GoogleTest for Windows"
  cmake -S /usr/src/googletest -B "$sources/googletest" -G Ninja -DCMAKE_TOOLCHAIN_FILE="$top/CMake/mingw.cmake" \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$root" -DCMAKE_INSTALL_LIBDIR=lib -DBUILD_GMOCK=OFF >/dev/null
  cmake --build "$sources/googletest" --target install >/dev/null
fi

configure_and_build mingw mingw
# A Wine of our own. A program is started once, not once for each of its tests: that takes Wine a second.
export WINEPREFIX="$top/build/mingw-wine" WINEDEBUG=-all
failed=()
for program in "$top"/build/mingw/bin/Test*.exe; do
  say "Test: $(basename "$program") by Wine"
  wine "$program" --gtest_brief=1 "$@" || failed+=("$(basename "$program")")
done
say "Test: the fuzzers' corpus by Wine"
wine "$top/build/mingw/bin/FuzzEngineReplay.exe" "$top/Testing/Fuzz/Corpus/Engine" || failed+=(FuzzEngineReplay.exe)
[ ${#failed[@]} -eq 0 ] || { echo "Failed: ${failed[*]}" >&2; exit 1; }
