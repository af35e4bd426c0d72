#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Break the rounds' kernels on purpose, one way at a time, and see that MutantProbe notices.

A mutant is a copy of the headers in Cuda/Rounds/ with a few pieces of text replaced. Each piece has to be there
exactly once: where it is not, the kernels have changed, and the table below has to follow. The test passes
when the probe finds nothing wrong with the kernels as they are, and something with every mutant. A crash, a
timeout and the probe's own word all count.
"""
import argparse
import concurrent.futures
import glob
import os
import re
import resource
import shutil
import subprocess
import sys
import time

SECONDS = 300  # for the probe of the unbroken kernels; mutants get ten times what that takes
GIGABYTES = 4

# (name, what it breaks, [(header, text, text instead), ...])
MUTANTS = [
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
     "whether flips are many is told from a count of the round under way",
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


class Probe:
    """Where and how a probe is built and run."""

    def __init__(self, arguments):
        self.arguments = arguments
        self.seconds = SECONDS
        self.took = 0

    def write_headers(self, folder, edits):
        """A copy of Cuda/Rounds/ with the edits. Raises ValueError where one does not apply."""
        shutil.rmtree(folder, ignore_errors=True)
        folder = os.path.join(folder, "Rounds")
        os.makedirs(folder)
        for header in glob.glob(os.path.join(self.arguments.source, "Cuda", "Rounds", "*.h")):
            shutil.copy(header, folder)
        for header, old, new in edits:
            path = os.path.join(folder, header)
            with open(path, encoding="utf-8") as file:
                text = file.read()
            # However clang-format has broken its lines.
            pattern = r"\s+".join(re.escape(word) for word in old.split())
            found = list(re.finditer(pattern, text))
            if len(found) != 1:
                raise ValueError(f"{header} has this text {len(found)} times, not once; the table in "
                                 f"mutants.py has to follow the kernels:\n{old}")
            text = text[:found[0].start()] + new.strip("\n") + text[found[0].end():]
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)

    def build(self, folder):
        """The probe from the headers in a folder. Raises ValueError where it does not compile."""
        source = self.arguments.source
        binary = os.path.join(folder, "probe")
        libraries = [name if os.path.sep in name else "-l" + name
                     for name in self.arguments.libraries]
        includes = [folder] + [os.path.join(source, *part) for part in
                               (("Cuda", "include"), ("Engine",), ("Engine", "include"), ())]
        command = [self.arguments.compiler, "-std=c++17", "-O1", "-ffp-contract=off", "-w", "-o", binary]
        command += ["-I" + include for include in includes]
        command += [f'-DFLIPFLOP_THREADS_HEADER="{self.arguments.threads}"']
        command += [os.path.join(source, "Testing", "Cuda", "Rounds", "MutantProbe.cxx")] + libraries
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              check=False)
        if done.returncode != 0:
            raise ValueError("does not compile:\n" + done.stdout[-3000:])
        return binary

    def notice(self, name, edits):
        """How the probe noticed; empty where it did not."""
        folder = os.path.join(self.arguments.work, name)
        self.write_headers(folder, edits)
        binary = self.build(folder)

        def limit():
            resource.setrlimit(resource.RLIMIT_AS, (GIGABYTES << 30, GIGABYTES << 30))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

        start = time.monotonic()
        try:
            done = subprocess.run([binary], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                                  timeout=self.seconds, preexec_fn=limit, check=False)
        except subprocess.TimeoutExpired:
            return f"no end within {self.seconds:.0f} s"
        finally:
            self.took = time.monotonic() - start
            shutil.rmtree(folder, ignore_errors=True)
        if done.returncode < 0:
            return f"died of signal {-done.returncode}"
        return (done.stdout.strip() or "exit status 1") if done.returncode else ""


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--source", required=True, help="the project's folder")
    parser.add_argument("--work", required=True, help="a folder to build in")
    parser.add_argument("--compiler", required=True)
    parser.add_argument("--libraries", required=True, nargs="+", help="files, or names to link")
    parser.add_argument("--threads", required=True, help="the header of the library of threads")
    parser.add_argument("--only", help="this mutant alone")
    arguments = parser.parse_args()
    probe = Probe(arguments)

    start = time.monotonic()
    found = probe.notice("unbroken", [])
    if found:
        sys.exit(f"the kernels as they are: {found}")
    probe.seconds = max(20, 10 * probe.took)
    print(f"{'unbroken':28} nothing wrong ({time.monotonic() - start:.0f} s)", flush=True)

    mutants = [m for m in MUTANTS if arguments.only in (None, m[0])]
    faults = 0
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        tasks = [pool.submit(probe.notice, name, edits) for name, _, edits in mutants]
        for (name, breaks, _), task in zip(mutants, tasks):
            try:
                how = task.result()
            except ValueError as error:
                how, faults = f"CANNOT BE MADE: {error}", faults + 1
            else:
                if not how:
                    how, faults = f"NOT NOTICED: {breaks}", faults + 1
            print(f"{name:28} {how}", flush=True)
    print(f"{len(mutants)} mutants in {time.monotonic() - start:.0f} s")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
