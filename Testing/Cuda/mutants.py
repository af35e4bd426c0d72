#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Break the CUDA engine on purpose, one way at a time, and see that its tests notice.

A mutant is the source tree with pieces of text replaced, built like the tree itself. Each piece has to be there
exactly once, however its lines are broken: where it is not, the source has changed, and the tables below have to
follow. Without a CUDA compiler the rounds are broken, and the device test on the host has to notice; with one
the executor and the device's code, and the device test on the stand-in. A crash counts, as does a test without end.

    mutants.py --source TREE --work FOLDER [--cuda-compiler NVCC] [--only NAME...]
"""
import argparse
import os
import re
import shutil
import subprocess
import sys

SECONDS = 600
EXECUTOR, PREAMBLE = "Cuda/Device/CudaExecutor.cu", "Testing/Cuda/Ptx/ptx_preamble.cxx.in"

ON_HOST = ["flipflop-device-test", "--host", "--small", "--only", "rounds/"]
STAND_IN = "flipflop-device-test-stand-in"
SMALL = [STAND_IN, "--small"]
# Its copies are of several pieces, and slower than the host fills the next.
LARGE = ["STANDIN_LAG_MICROSECONDS=5000", STAND_IN, "--only", "rounds/plane-uniform-500000"]
# Its points are sent in more pieces than there is pinned memory for.
PIECES = ["STANDIN_LAG_MICROSECONDS=5000", STAND_IN, "--only", "rounds/cube-1000000"]
# Not all of a run's memory may be kept.
LITTLE = ["STANDIN_MEBIBYTES=64", STAND_IN, "--only", "what-stays"]

# (name, what it breaks, [(file, text, text instead), ...]); files without a folder are Cuda/Rounds'.
ROUNDS = [
    ("lock-two-of-three",
     "a 3-1 flip does not lock its third triangle",
     [("FlipKernels.h",
       """      if (k < plan.triangleCount)
      {
        atomics::lower(&data.votes""",
       """      if (k < plan.triangleCount && k < 2)
      {
        atomics::lower(&data.votes"""),
      ("FlipKernels.h",
       "won = won && (k >= plan.triangleCount ||",
       "won = won && (k >= plan.triangleCount || k >= 2 ||")]),
    ("no-message-between-flips",
     "a flip links to where its neighbour was, though that flips too",
     [("FlipKernels.h",
       "outer[k] = flips ? d.moved[other] : other;",
       "outer[k] = other;")]),
    ("message-without-stand-off",
     "a flip writes into a neighbour that flips too",
     [("FlipKernels.h", "        if (!flips)\n", "        if (true)\n")]),
    ("labels-at-once",
     "Check sets labels that other items of the same round may see or not",
     [("FlipKernels.h",
       "  data.proposals[i] = proposal;\n",
       """  data.proposals[i] = proposal;
  if (proposal.action == FlipAction::LabelA || proposal.action == FlipAction::LabelB)
  {
    atomics::setBits(&data.mesh.vertices[data.mesh.origin(halfEdgeFromEnd(data.mesh, proposal))].flags,
      std::uint32_t(VertexLabelled));
  }
"""),
      ("FlipKernels.h",
       "if (atomics::setBits(flags, std::uint32_t(VertexLabelled)) & VertexLabelled)",
       "if (!(atomics::setBits(flags, std::uint32_t(VertexLabelled)) & VertexLabelled))")]),
    ("no-message-between-splits",
     "a new triangle takes its neighbour by its old number, though that was split too",
     [("GrowthKernels.h",
       "if (d.mesh.triangles[other].flags == this->round)",
       "if (false)")]),
    ("vote-by-store",
     "the last vote wins, not the least",
     [("FlipKernels.h",
       "atomics::lower(&data.votes[plan.triangle[k]], voteKey(round, proposal.edge));",
       "data.votes[plan.triangle[k]] = voteKey(round, proposal.edge);")]),
    ("vote-without-rounds",
     "votes of older rounds are not superseded",
     [("FlipKernels.h", "static_cast<std::uint64_t>(~round) << 32 | h", "std::uint64_t(round) << 32 | h")]),
    ("first-come-furthest",
     "the first point of a cone to come is inserted, not the furthest",
     [("GrowthKernels.h",
       "atomics::raise(&data.furthest[t], furthestKey(height, id));",
       """if (data.furthest[t] == 0)
  {
    data.furthest[t] = furthestKey(height, id);
  }""")]),
    ("label-wakes-nobody",
     "triangles around a new label stay at rest",
     [("FlipKernels.h",
       """      flips::wake(d, this->round + 1, triangleOf(spoke));
""",
       "")]),
    ("loser-sleeps",
     "who has lost a vote goes to rest",
     [("FlipKernels.h",
       """    else
    {
      flips::wake(d, this->round + 1, triangleOf(proposal.edge));
    }""",
       "")]),
    ("second-triangle-sleeps",
     "a 2-2 flip wakes only one of its triangles",
     [("FlipKernels.h",
       """    if (proposal.action == FlipAction::Flip22)
    {
      flips::wake(d, this->round + 1, plan.triangle[1]);
    }""",
       "")]),
    ("lower-number-looks",
     "an edge is left to the lower triangle even where that one is at rest",
     [("FlipKernels.h",
       "if (!(other < t && data.queued[other] == round))",
       "if (!(other < t))")]),
    ("undecided-is-decided",
     "the sign of a filter that has not decided is taken for the sign",
     [("FilteredGeometry.h",
       "this->undecided = this->undecided || !known || sign == 0;",
       "(void)known;")]),
    ("ties-are-decided",
     "a tie is not left to the perturbation",
     [("FilteredGeometry.h", "|| !known || sign == 0;", "|| !known;")]),
    ("duplicates-unnoted",
     "a point dropped at a vertex's position is forgotten, even if its id is lower",
     [("GrowthKernels.h",
       "      atomics::lower(&data.lowest[i == 0 ? v[0] : i == 1 ? v[1] : v[2]], p.id);\n",
       "      (void)i;\n")]),
    ("slots-by-counter",
     "new slots go by arrival, not by a prefix sum",
     [("GrowthKernels.h",
       """    const std::uint32_t offset = d.offsets[i];
    if (d.offsets[i + 1] == offset)
    {
      return;
    }
""",
       """    if (d.offsets[i + 1] == d.offsets[i])
    {
      return;
    }
    const std::uint32_t offset = atomics::add(&d.counters->flips[0], 1u);
"""),
      ("GrowthKernels.h",
       "    counters.live[this->round & 1] = 0;\n",
       "    counters.live[this->round & 1] = 0;\n    counters.flips[0] = 0;\n")]),
    ("biased-labels-at-will",
     "the V-biased variant labels in rounds with flips too, if no flip has been noted yet",
     [("FlipKernels.h",
       "if (d.vBiased && this->flipsAreMany())",
       "if (d.vBiased && d.counters->flips[this->round & 1] != 0)")]),
    ("scarce-flips-unordered",
     "whether flips are many is read from a count of the round under way",
     [("FlipKernels.h",
       "counters.flips[(this->round & 1) ^ 1];",
       "counters.flips[this->round & 1];")]),
    ("ids-of-vertices",
     "the finish forgets the points that were dropped at a vertex's position",
     [("FinishKernels.h", "const std::uint32_t id = d.lowest[v];", "const std::uint32_t id = d.mesh.vertices[v].id;")]),
    ("share-from-any-corner",
     "a triangle's share of volume and area is not taken from its lowest corner",
     [("FinishKernels.h", "const std::uint32_t a = triangle.v[first];",
       "const std::uint32_t a = triangle.v[nextCorner(first)];")]),
    ("cells-by-first-corner",
     "cells are sorted by their lowest corners alone",
     [("CellWriter.h", "executor.sort(keyBuffers, thirdBuffers, count, 2 * cornerBits)",
       "executor.sort(keyBuffers, thirdBuffers, count, 0)"),
      ("HostExecutor.h", "return keys[0][a] < keys[0][b];", "return keys[0][a] >> 9 < keys[0][b] >> 9;")]),
    ("undecided-goes-to-rest",
     "a triangle that the filter left open does not stay active until the exact kernel comes",
     [("FlipKernels.h",
       "      if (proposal.edge != NoIndex)\n",
       "      if (false)\n")]),
    ("old-candidates-only",
     "a point that was left open and comes to a triangle without points is never inserted",
     [("Rounds.h", "allCandidates = locates && !allLocated ? round : allCandidates;", "allCandidates = 0;")]),
    ("open-points-stay-behind",
     "points left open are not found in the new order of the others",
     [("OrderKernels.h", "    point.index = index;\n", "    (void)index;\n")]),
    ("open-points-forgotten",
     "points that were left open are gone after a round, though none of them was located",
     [("GrowthKernels.h", "    if (this->allLocated)\n", "    if (true)\n")]),
    ("counters-not-in-turn",
     "a list that the round reads is emptied meanwhile",
     [("FlipKernels.h",
       "counters.active[before] = 0;\n    counters.flips",
       "counters.active[this->round & 1] = 0;\n    counters.flips")]),
]

# (name, what it breaks, the test, [(file, text, text instead), ...])
DEVICE = [
    ("piece-not-waited-for",
     "a piece is read before the device has written it",
     SMALL, [(EXECUTOR,
       """    requireCuda(cudaEventSynchronize(this->session->pieceDone[i & 1]));
    // By""",
       "    // By")]),
    ("piece-written-too-early",
     "pinned memory is filled again before its copy is done",
     PIECES, [(EXECUTOR,
       "    if (piece >= 2)\n",
       "    if (piece >= 3)\n")]),
    ("wrong-piece",
     "a piece is fetched twice, and the next never",
     LARGE, [(EXECUTOR,
       "      fetch(i + 1);\n",
       "      fetch(i);\n")]),
    ("record-not-waited-for",
     "counters are read before the device has written them",
     SMALL, [(EXECUTOR,
       "  requireCuda(cudaEventSynchronize(this->session->recordDone[slot]));\n",
       "")]),
    ("all-is-kept",
     "all memory of a run is kept for the next",
     LITTLE, [(EXECUTOR,
       "      this->keptBytes = total / 8;\n",
       "      this->keptBytes = total;\n")]),
    ("first-device",
     "a session of any device is taken, not one of the current device",
     SMALL, [(EXECUTOR,
       "        if (session->device == device)\n",
       "        if (session->device >= 0)\n")]),
    ("any-devices-memory",
     "points in another device's memory are read there",
     SMALL, [(EXECUTOR,
       "    (attributes.type == cudaMemoryTypeDevice && attributes.device == device);",
       "    attributes.type == cudaMemoryTypeDevice;")]),
    ("record-in-the-hosts-memory",
     "kernels are given the address that the host has for memory of both",
     SMALL, [(EXECUTOR,
       "  return &this->session->recordsOnDevice[slot];\n",
       "  return &this->session->records[slot];\n")]),
    ("wake-in-two-steps",
     "who looks whether a triangle is awake, and who wakes it, are two steps",
     SMALL, [("FlipKernels.h",
       "  if (atomics::exchange(&data.queued[t], next) != next)\n  {\n",
       """  if (atomics::load(&data.queued[t]) != next)
  {
    atomics::store(&data.queued[t], next);
""")]),
    ("too-little-room",
     "a round that adds as much as it can writes behind its arrays",
     LARGE, [("Rounds.h",
       "    this->triangles.grow(after.triangles, before.triangles, &c->triangles);",
       "    this->triangles.grow((before.triangles + after.triangles) / 2, before.triangles, &c->triangles);")]),
]
# Every kind of atomic operation is made plain, so that another thread may come between.
DEVICE += [
    (f"plain-{operation}", f"atomic {operation} is in two steps", SMALL,
     [(PREAMBLE, "#define PTX_PLAIN Nothing", f"#define PTX_PLAIN {operation}")])
    for operation in ("Add", "Exch", "Max", "Min", "Or")
]


def run(command, log):
    with open(log, "w", encoding="utf-8") as file:
        return subprocess.run(command, stdout=file, stderr=subprocess.STDOUT).returncode


def copy_tree(source, to):
    """What git knows of the source, as it lies there."""
    names = subprocess.run(["git", "-C", source, "ls-files", "--cached", "--others", "--exclude-standard", "-z"],
                           check=True, capture_output=True, text=True).stdout.split("\0")
    for name in filter(None, names):
        if os.path.exists(os.path.join(source, name)) and not name.startswith(("Documentation/Figures", "Data/")):
            os.makedirs(os.path.dirname(os.path.join(to, name)), exist_ok=True)
            shutil.copy(os.path.join(source, name), os.path.join(to, name))  # newer than what was built


def replaced(path, text, old, new):
    """The text with one piece replaced, however clang-format has broken its lines."""
    found = list(re.finditer(r"\s+".join(re.escape(word) for word in old.split()), text))
    if len(found) != 1:
        raise ValueError(f"{path} has this text {len(found)} times, not once: {old}")
    return text[:found[0].start()] + new.strip("\n") + text[found[0].end():]


class Tree:
    def __init__(self, options):
        self.source, self.build = os.path.join(options.work, "source"), os.path.join(options.work, "build")
        self.log = os.path.join(options.work, "log.txt")
        shutil.rmtree(self.source, ignore_errors=True)
        copy_tree(options.source, self.source)
        cuda = ["-DFLIPFLOP_CUDA=OFF"]
        if options.cuda_compiler:
            cuda = ["-DFLIPFLOP_CUDA=ON", f"-DCMAKE_CUDA_COMPILER={options.cuda_compiler}",
                    "-DCMAKE_CUDA_ARCHITECTURES=90"]
        command = [
            "cmake", "-G", "Ninja", "-S", self.source, "-B", self.build, "-DCMAKE_BUILD_TYPE=Release", *cuda,
            "-DFLIPFLOP_BUILD_FILTERS=OFF", "-DFLIPFLOP_WRAP_PYTHON=OFF", "-DFLIPFLOP_BUILD_EXAMPLES=OFF",
            "-DBUILD_TESTING=ON",
        ]  # fmt: skip
        if run(command, self.log):
            sys.exit(f"cmake failed: {self.log}")

    def noticed(self, test):
        """(whether the test fails, what it says at last)"""
        at = next(i for i, word in enumerate(test) if "=" not in word)
        if run(["cmake", "--build", self.build, "--target", test[at]], self.log):
            return False, f"does not compile: {self.log}"
        command = ["env", *test[:at], os.path.join(self.build, "bin", test[at]), *test[at + 1:]]
        try:
            ended = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                   timeout=SECONDS)
        except subprocess.TimeoutExpired:
            return True, f"not done in {SECONDS} s"
        said = [line for line in ended.stdout.splitlines() if not line.startswith("ok ")]
        return ended.returncode != 0, f"status {ended.returncode}: " + " / ".join(said[-3:])

    def mutant_noticed(self, test, edits):
        before = {}
        try:
            for path, old, new in edits:
                path = os.path.join(self.source, path if "/" in path else f"Cuda/Rounds/{path}")
                with open(path, encoding="utf-8") as file:
                    text = file.read()
                before.setdefault(path, text)
                with open(path, "w", encoding="utf-8") as file:
                    file.write(replaced(path, text, old, new))
            return self.noticed(test)
        except ValueError as error:
            return False, str(error)
        finally:
            for path, text in before.items():
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--source", required=True)
    parser.add_argument("--work", required=True)
    parser.add_argument("--cuda-compiler")
    parser.add_argument("--only", nargs="+")
    options = parser.parse_args()
    os.makedirs(options.work, exist_ok=True)
    mutants = DEVICE if options.cuda_compiler else [(name, what, ON_HOST, edits) for name, what, edits in ROUNDS]
    mutants = [mutant for mutant in mutants if mutant[0] in (options.only or [mutant[0]])]
    tree = Tree(options)
    for test in (SMALL, LARGE, PIECES, LITTLE) if options.cuda_compiler else (ON_HOST,):
        failed, said = tree.noticed(test)
        if failed or "does not compile" in said:
            sys.exit(f"the unbroken tree fails: {said}")
    missed = 0
    for name, what, test, edits in mutants:
        noticed, said = tree.mutant_noticed(test, edits)
        print(f"{'noticed' if noticed else 'MISSED '} {name}: {what}: {said}", flush=True)
        missed += not noticed
    print(f"{missed} of {len(mutants)} missed")
    return missed > 0


if __name__ == "__main__":
    sys.exit(main())
