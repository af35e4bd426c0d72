#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# libcxx.sh [PATTERN]: compile all sources, or those whose path has the pattern, with clang and its own standard library,
# libc++, warnings as errors. Nothing is linked: Debian's GoogleTest, VTK and GMP are libstdc++'s.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$top/Scripts/install-dependencies.sh" test libcxx
use_ccache
build="$top/build/libcxx"
mkdir -p "$build"
(cd "$top" && cmake --preset clang -B "$build" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON) \
  >"$build/configure.log" 2>&1 || { cat "$build/configure.log"; exit 1; }
say "Compile with libc++"
"$python" - "$build/compile_commands.json" "$top" "${1:-}" <<'END' |
import json, os, shlex, sys
path, top, pattern = sys.argv[1:]
for entry in json.load(open(path, encoding="utf-8")):
    file = os.path.relpath(entry["file"], top)
    # What VTK's build has made is not ours.
    if not file.startswith("build") and pattern in file:
        words = shlex.split(entry["command"])
        del words[words.index("-o"):words.index("-o") + 2]
        words[words.index("-c")] = "-fsyntax-only"
        command = shlex.join(words + ["-stdlib=libc++"])
        print(f"echo {file}; cd {shlex.quote(entry['directory'])} && {command} || {{ echo FAILED {file}; exit 1; }}", end="\0")
END
  xargs -0 -r -P "$(parallel_jobs)" -n 1 sh -c
say "All compiled"
