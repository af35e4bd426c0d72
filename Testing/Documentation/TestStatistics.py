# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Statistics.md tells of every figure, and shows those of a real run."""

import glob
import os
import re
import subprocess
import sys
import tempfile
import unittest

from tree import TOP, read

PAGE = read("Documentation", "Statistics.md")


def counts(block):
    """The figures of a run_statistics.py's rows, without the seconds."""
    rows = [line for line in block.strip("\n").splitlines() if not line.startswith("FlipFlopSeconds")]
    return {re.split(r"\s{2,}", row)[0]: row.split()[-4:] for row in rows}


class TestStatistics(unittest.TestCase):
    def test_the_run_shown(self):
        with tempfile.TemporaryDirectory() as folder:
            output = subprocess.run(
                [
                    sys.executable,
                    os.path.join(TOP, "Examples", "Python", "run_statistics.py"),
                    os.path.join(folder, "hull.vtp"),
                ],
                check=True,
                capture_output=True,
                text=True,
            ).stdout
        shown = PAGE.split("```")[1]
        self.assertGreater(len(counts(shown)), 10)
        self.assertEqual(counts(shown), counts(output))

    def test_what_holds_for_every_run(self):
        figures = counts(PAGE.split("```")[1])
        for run in range(4):
            of = {name: row[run] for name, row in figures.items() if row[run].isdigit()}
            flips22, flips31, by_volume, by_degree, insertions, redundant, points = (
                int(of[name])
                for name in ("FlipFlopFlips22", "FlipFlopFlips31", "FlipFlopFlipsV")
                + ("FlipFlopFlipsD", "FlipFlopInsertions", "FlipFlopRedundant")
                + ("points of the output",)
            )
            self.assertEqual(flips22 + flips31, by_volume + by_degree)
            self.assertEqual(points, (4 if run == 0 else 3) + insertions - flips31 - redundant)

    def test_every_figure_is_told(self):
        struct = read("Engine", "include", "flipflop", "Statistics.h")
        members = re.findall(r"^  (?:std::int64_t|double|int) (\w+) = 0;", struct, re.MULTILINE)
        arrays = {
            name
            for path in glob.glob(os.path.join(TOP, "Filters", "*.cxx"))
            for name in re.findall(r'AddValue\([^"]*"(FlipFlop\w+)"', read(path))
        }
        self.assertEqual((len(members), len(arrays)), (21, 18))
        told = set(re.findall(r"`([\w()]+)`", PAGE))
        self.assertEqual((set(members) | arrays) - told, set())


if __name__ == "__main__":
    unittest.main()
