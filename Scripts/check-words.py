#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""check-words.py [FILE]...: names of files and identifiers in the sources that have a word which the tree has replaced.

Comments and strings are not read. Without files, all sources under version control are checked.
"""

import os
import re
import subprocess
import sys

TOP = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

# Identifiers, whole: what to write.
NAMES = {
    "AnswersOf": "RepliesOf",
    "EdgesFixed": "EdgeFixed",
    "FF_APART": "FF_NOINLINE",
    "FF_FLAT": "FF_FLATTEN",
    "HullModel": "PreparedHull",
    "Introduction": "BlockSummary",
    "KnownSites": "ReceivedSites",
    "LowestOf": "DisjointSets",
    "Model": "Geometry",
    "Unfolding": "OctahedralMap",
    "amend": "beforeCanonicalForm",
    "amends": "changesTriangulation",
    "asRow": "asDeterminantRow",
    "eachLeft": "eachRemaining",
    "eachRun": "eachChunk",
    "eachCheckedRun": "eachCheckedChunk",
    "idsLeft": "remainingIds",
    "isOfConcern": "mayNeedFlip",
    "leaveOut": "exclude",
    "monitorToTell": "monitorToUse",
    "numberFound": "parallelCompact",
    "runCount": "chunkCount",
    "takenCount": "excludedCount",
    "toTell": "monitorToUse",
    "unfoldingOf": "octahedralMapOf",
}

# Words of identifiers, such as the second of "leftOut" or "left_out": what to write.
WORDS = {
    "anew": "again",
    "answer": "result, reply or query",
    "answers": "results, replies or queries",
    "ask": "query or request",
    "asked": "requested, queried or sampled",
    "asks": "queries",
    "beside": "adjacent",
    "heavy": "weighted, or weights",
    "judge": "validate or classify",
    "place": "index, slot, rank, position or location",
    "places": "indices, slots, ranks, positions or locations",
    "room": "capacity or module",
    "rooms": "modules",
    "tell": "report or emit",
    "tells": "reports or emits",
    "thing": "the name of the thing",
    "things": "items",
    "told": "reported, sent or stored",
    "whom": "the name of the thing",
}

# The words are checked in these folders, the names everywhere.
FOLDERS = ("Engine/", "Cuda/", "Filters/", "Wrapping/", "Examples/", "Benchmarks/", "Scripts/")

# Names that may stay, each with the reason.
ALLOWED = {
    "in_place": "NumPy's word for no copy",
    "placeKernel": "to place is a verb here",
}

SOURCES = (".h", ".cxx", ".cu", ".cuh", ".py", ".in")


def sources():
    listed = subprocess.run(["git", "-C", TOP, "ls-files", "-z"], check=True, stdout=subprocess.PIPE)
    return [name for name in listed.stdout.decode().split("\0") if name.endswith(SOURCES)]


def code(text, path):
    """The text without comments and strings; lines keep their numbers."""
    if path.endswith((".py", ".py.in")):
        pattern = r'"""(?s:.*?)"""|#[^\n]*|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\''
    else:
        pattern = r'//[^\n]*|/\*(?s:.*?)\*/|"(?:\\.|[^"\\\n])*"'
    return re.sub(pattern, lambda match: "\n" * match.group().count("\n"), text)


def words(name):
    return [word.lower() for word in re.findall(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+", name)]


def replacement(name, folder):
    """What to write in place of the name; none if it may stay."""
    if name in ALLOWED:
        return None
    if name in NAMES:
        return NAMES[name]
    if folder.startswith(FOLDERS):
        for word in words(name):
            if word in WORDS:
                return f"{WORDS[word]} for {word}"
    return None


def complaints(path, text):
    found = []
    stem = os.path.basename(path).split(".")[0]
    better = replacement(stem, path)
    if better:
        found.append(f"{path}: the file is named {stem}; write {better}")
    for number, line in enumerate(code(text, path).split("\n"), 1):
        for name in sorted(set(re.findall(r"[A-Za-z_]\w+", line))):
            better = replacement(name, path)
            if better:
                found.append(f"{path}:{number}: {name}; write {better}")
    return found


def main():
    count = 0
    files = [os.path.relpath(os.path.abspath(name), TOP) for name in sys.argv[1:]] or sources()
    for path in files:
        if path == os.path.relpath(os.path.abspath(__file__), TOP):
            continue
        with open(os.path.join(TOP, path), encoding="utf-8") as file:
            for complaint in complaints(path, file.read()):
                print(complaint)
                count += 1
    if count:
        sys.exit(f"{count} names have words that the tree has replaced (Scripts/check-words.py)")
    print(f"Words: no name of {len(files)} sources has one that the tree has replaced")


if __name__ == "__main__":
    main()
