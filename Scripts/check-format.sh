#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# check-format.sh [--fix]: name every C++ file that clang-format would change, or change them.
#
# clang-format's opinion changes between its versions; that of version 14 (Debian 12, Ubuntu 22.04)
# counts. Where another is installed, nothing is judged.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

wanted=14
tool=$(command -v clang-format-$wanted || command -v clang-format)
if ! "$tool" --version | grep -q "version $wanted\."; then
  echo "Formatting is not checked: that takes clang-format $wanted, and here is $("$tool" --version)"
  exit 0
fi

cd "$top"
mapfile -d '' files < <(find . -path ./.git -prune -o -path './build*' -prune -o -type f \
  \( -name '*.h' -o -name '*.cxx' -o -name '*.cu' -o -name '*.cuh' \) -print0 | sort -z)
if [ "${1:-}" = --fix ]; then
  "$tool" -i "${files[@]}"
  exit 0
fi

if ! printf '%s\0' "${files[@]}" | xargs -0 -n 20 -P "$(nproc)" "$tool" --dry-run --Werror; then
  echo "Scripts/check-format.sh --fix mends them" >&2
  exit 1
fi
echo "Formatting: ${#files[@]} files are as clang-format $wanted writes them"
