#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# paraview-plugin-devel.sh TOOLSET: within one of Kitware's images paraview_org-plugin-devel, as root, build the plugin for
# the ParaView of paraview.org. TOOLSET is the compiler: devtoolset-9 (CentOS 7, ParaView 5) or gcc-toolset-10 (ParaView
# 6). Boost's and Eigen's headers are to be in build/headers/include, and Eigen's files for CMake in
# build/headers/share/eigen3/cmake: the images' systems have old ones. What there is to hand out is in
# build/paraview-plugin-devel/plugin. This script has not been run yet.
set -euo pipefail

toolset=$1
top="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
build="$top/build/paraview-plugin-devel"
prefix="$build/install"

# CentOS 7 is no longer mirrored, only archived.
if [ -e /etc/yum.repos.d/CentOS-Base.repo ]; then
  sed -i -e 's/^mirrorlist=/#&/' -e 's,^#* *baseurl=http://mirror.centos.org,baseurl=http://vault.centos.org,' \
    /etc/yum.repos.d/CentOS-*.repo
fi
# The images' own compiler for ParaView 5 is GCC 7, whose C++17 is incomplete.
if ! scl enable "$toolset" true 2>/dev/null; then
  yum install -y "$toolset"
fi

# Where ParaView was built: its CMake files name that folder.
paraview=/builds/gitlab-kitware-sciviz-ci/build/install
[ -d "$paraview" ] || ln -s /paraview/gitlab-kitware-sciviz-ci /builds/gitlab-kitware-sciviz-ci

# On std::thread: the plugin shall load no oneTBB beside ParaView's own. FlipFlopIcons needs development files of Qt that
# an image need not have.
scl enable "$toolset" -- cmake -S "$top" -B "$build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_LIBDIR=lib \
  -DFLIPFLOP_BUILD_PLUGIN=ON -DFLIPFLOP_THREADS_BACKEND=STD -DFLIPFLOP_WRAP_PYTHON=OFF \
  -DBUILD_TESTING=OFF -DCMAKE_PREFIX_PATH="$paraview;$top/build/headers"
scl enable "$toolset" -- cmake --build "$build" --parallel "$(nproc)"
scl enable "$toolset" -- cmake --install "$build" --prefix "$prefix"

rm -rf "$build/plugin"
cp -r "$(dirname "$(find "$prefix" -name FlipFlop.so)")" "$build/plugin"
cp "$top/LICENSE" "$build/plugin"
