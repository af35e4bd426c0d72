#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Break the CUDA executor and the rounds on purpose, one way at a time, and see that the device test on the stand-in notices.

A mutant is the source tree with one piece of text replaced, built like the tree itself. Each piece has to be there
exactly once: where it is not, the source has changed, and the table below has to follow.

    mutants.py --source TREE --work FOLDER --cuda-compiler NVCC [--only NAME...]
"""
import argparse
import os
import shutil
import subprocess
import sys

from is_noticed import is_noticed

EXECUTOR, ROUNDS, FLIPS = "Cuda/Device/CudaExecutor.cu", "Cuda/Rounds/Rounds.h", "Cuda/Rounds/FlipKernels.h"
TARGET = "flipflop-device-test-stand-in"

SMALL = ["--small"]
# Its copies are of several pieces, and slower than the host fills the next.
LARGE = ["STANDIN_LAG_MICROSECONDS=5000", "--only", "rounds/plane-uniform-500000"]

# Its points are sent in more pieces than there is pinned memory for.
PIECES = ["STANDIN_LAG_MICROSECONDS=5000", "--only", "rounds/cube-1000000"]
# Not all of a run's memory may be kept.
LITTLE = ["STANDIN_MEBIBYTES=64", "--only", "what-stays"]

# (name, what it breaks, the device test's environment and arguments, file, text, text instead)
MUTANTS = [
    ("piece-not-waited-for",
     "a piece is read before the device has written it",
     SMALL, EXECUTOR,
     """    requireCuda(cudaEventSynchronize(this->session->pieceDone[i & 1]));
    // By""",
     """    // By"""),
    ("piece-written-too-early",
     "pinned memory is filled again before its copy is done",
     PIECES, EXECUTOR, "    if (piece >= 2)\n", "    if (piece >= 3)\n"),
    ("wrong-piece",
     "a piece is fetched twice, and the next never",
     LARGE, EXECUTOR, "      fetch(i + 1);\n", "      fetch(i);\n"),
    ("record-not-waited-for",
     "counters are read before the device has written them",
     SMALL, EXECUTOR, "  requireCuda(cudaEventSynchronize(this->session->recordDone[slot]));\n", ""),
    ("all-is-kept",
     "all memory of a run is kept for the next",
     LITTLE, EXECUTOR, "      this->keptBytes = total / 8;\n", "      this->keptBytes = total;\n"),
    ("first-device",
     "a session of any device is taken, not one of the current device",
     SMALL, EXECUTOR, "        if (session->device == device)\n", "        if (session->device >= 0)\n"),
    ("any-devices-memory",
     "points in another device's memory are read there",
     SMALL, EXECUTOR, "    (attributes.type == cudaMemoryTypeDevice && attributes.device == device);",
     "    attributes.type == cudaMemoryTypeDevice;"),
    ("record-in-the-hosts-memory",
     "kernels are given the address that the host has for memory of both",
     SMALL, EXECUTOR, "  return &this->session->recordsOnDevice[slot];\n", "  return &this->session->records[slot];\n"),
    ("wake-in-two-steps",
     "who looks whether a triangle is awake, and who wakes it, are two steps",
     SMALL, FLIPS,
     "  if (atomics::exchange(&data.queued[t], next) != next)\n  {\n",
     "  if (atomics::load(&data.queued[t]) != next)\n  {\n    atomics::store(&data.queued[t], next);\n"),
    ("too-little-room",
     "a round that adds as much as it can writes behind its arrays",
     LARGE, ROUNDS,
     "    this->triangles.grow(after.triangles, before.triangles, &c->triangles);",
     "    this->triangles.grow((before.triangles + after.triangles) / 2, before.triangles, &c->triangles);"),
]  # fmt: skip


def run(command, log):
    with open(log, "w", encoding="utf-8") as file:
        return subprocess.run(command, stdout=file, stderr=subprocess.STDOUT).returncode


def copy_tree(source, to):
    """What git knows of the source, as it lies there."""
    names = subprocess.run(["git", "-C", source, "ls-files", "--cached", "--others", "--exclude-standard", "-z"],
                           check=True, capture_output=True, text=True).stdout.split("\0")
    for name in filter(None, names):
        if not name.startswith(("Documentation/Figures", "Data/", "Testing/Data/")):
            os.makedirs(os.path.dirname(os.path.join(to, name)), exist_ok=True)
            shutil.copy(os.path.join(source, name), os.path.join(to, name))  # newer than what was built


class Tree:
    def __init__(self, options):
        self.source, self.build = os.path.join(options.work, "source"), os.path.join(options.work, "build")
        self.log = os.path.join(options.work, "log.txt")
        shutil.rmtree(self.source, ignore_errors=True)
        copy_tree(options.source, self.source)
        command = [
            "cmake", "-G", "Ninja", "-S", self.source, "-B", self.build, "-DCMAKE_BUILD_TYPE=Release",
            f"-DCMAKE_CUDA_COMPILER={options.cuda_compiler}", "-DFLIPFLOP_CUDA=ON", "-DFLIPFLOP_BUILD_FILTERS=OFF",
            "-DCMAKE_CUDA_ARCHITECTURES=90", "-DFLIPFLOP_WRAP_PYTHON=OFF", "-DFLIPFLOP_BUILD_EXAMPLES=OFF",
            "-DBUILD_TESTING=ON",
        ]  # fmt: skip
        if run(command, self.log):
            sys.exit(f"cmake failed: {self.log}")

    def built(self):
        return run(["cmake", "--build", self.build, "--target", TARGET], self.log) == 0

    def test(self, arguments):
        environment = [word for word in arguments if "=" in word]
        rest = [word for word in arguments if "=" not in word]
        return is_noticed(["env", *environment, os.path.join(self.build, "bin", TARGET), *rest])

    def noticed(self, arguments, path, text, instead):
        """(whether the device test notices the replacement, what it says)"""
        path = os.path.join(self.source, path)
        with open(path, encoding="utf-8") as file:
            whole = file.read()
        if whole.count(text) != 1:
            return False, f"the text is there {whole.count(text)} times"
        try:
            with open(path, "w", encoding="utf-8") as file:
                file.write(whole.replace(text, instead))
            return self.test(arguments) if self.built() else (False, f"does not compile: {self.log}")
        finally:
            with open(path, "w", encoding="utf-8") as file:
                file.write(whole)


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--source", required=True)
    parser.add_argument("--work", required=True)
    parser.add_argument("--cuda-compiler", required=True)
    parser.add_argument("--only", nargs="+", default=[name for name, *_ in MUTANTS])
    options = parser.parse_args()
    os.makedirs(options.work, exist_ok=True)
    tree = Tree(options)
    if not tree.built():
        sys.exit(f"the tree does not compile: {tree.log}")
    for arguments in (SMALL, LARGE, PIECES, LITTLE):
        failed, said = tree.test(arguments)
        if failed:
            sys.exit(f"the unbroken tree fails: {said}")
    missed = 0
    for name, what, *replacement in MUTANTS:
        if name in options.only:
            noticed, said = tree.noticed(*replacement)
            print(f"{'noticed' if noticed else 'MISSED '} {name}: {what}: {said}", flush=True)
            missed += not noticed
    print(f"{missed} missed")
    return missed > 0


if __name__ == "__main__":
    sys.exit(main())
