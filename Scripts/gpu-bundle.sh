#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# gpu-bundle.sh [ARCHITECTURES]: make build/gpu-bundle, a folder to take to a machine with an NVIDIA GPU and nothing but
# its driver: the device test and the benchmark with the libraries they need, the CUDA runtime among them, and gpu.sh.
# There: Scripts/gpu.sh. It takes nvcc here; there, a C library that the programs find new enough: the last line tells.
# The C++ library that comes along is for machines that have none, and may take a newer one.
#
# ARCHITECTURES, as CMAKE_CUDA_ARCHITECTURES: 80-real;90 by default (A100, H100, H200, and newer ones by PTX).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

most_megabytes=64 # which such machines take
bundle="$top/build/gpu-bundle"
build="$top/build/gpu-bundle-build"

"$top/Scripts/install-dependencies.sh" benchmark
# The libraries are looked for beside the programs.
configure_and_build gpu gpu-bundle-build "-DCMAKE_CUDA_ARCHITECTURES=${1:-80-real;90}" \
  '-DCMAKE_BUILD_RPATH=$ORIGIN/../lib'

rm -rf "$bundle"
mkdir -p "$bundle/bin" "$bundle/lib" "$bundle/Scripts" "$bundle/Benchmarks/Cuda"
cp "$build/bin/flipflop-device-test" "$build/bin/flipflop-benchmark" "$bundle/bin"
strip "$bundle"/bin/*
# All but the C library's own, which the machine has.
ldd "$bundle"/bin/* | sed -n 's/.* => \(\/[^ ]*\) .*/\1/p' | sort -u |
  grep -vE '/(libc|libm|libdl|librt|libpthread|libresolv)\.so\.[0-9]+$' | xargs -I{} cp -L {} "$bundle/lib"
mkdir "$bundle/lib/standard"
mv "$bundle"/lib/libstdc++.so.* "$bundle"/lib/libgcc_s.so.* "$bundle/lib/standard"
cp "$top/Scripts/gpu.sh" "$top/Scripts/common.sh" "$bundle/Scripts"
cp "$top/Benchmarks/report.py" "$bundle/Benchmarks"
cp "$top/Benchmarks/Cuda/device.plan" "$bundle/Benchmarks/Cuda"

megabytes=$(du -sm "$bundle" | cut -f1)
# newest FILE...: the newest C library that one of them takes
newest() {
  objdump -T "$@" 2>/dev/null | grep -o 'GLIBC_2\.[0-9]*' | sort -uV | tail -1
}
echo "$bundle: $megabytes MB, needs $(newest "$bundle"/bin/* "$bundle"/lib/*.so*)," \
  "and $(newest "$bundle"/lib/standard/*) where there is no libstdc++"
[ "$megabytes" -le "$most_megabytes" ] || { echo "More than $most_megabytes MB" >&2; exit 1; }
