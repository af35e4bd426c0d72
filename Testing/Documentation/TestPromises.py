# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Promises.md names tests that exist, and every test of the filters. Faults.md names tests and commits that exist."""

import datetime
import glob
import os
import re
import subprocess
import unittest

from tree import TOP, read

PAGE = read("Documentation", "Promises.md")
FAULTS = read("Documentation", "Faults.md")


def names(*patterns):
    """The files' names, without what is after the dot."""
    files = [path for pattern in patterns for path in glob.glob(os.path.join(TOP, "Testing", pattern), recursive=True)]
    return {os.path.basename(path).split(".")[0] for path in files}


def all_tests():
    found = names("**/Test*.*", "Cxx/RunPackage.cmake", "Cuda/mutants.py", "Cuda/Device/DeviceTest.cxx", "Fuzz/*.cxx")
    for path in glob.glob(os.path.join(TOP, "Testing", "**", "*.cxx"), recursive=True):
        found |= {".".join(name) for name in re.findall(r"^TEST\w*\((\w+), (\w+)\)", read(path), re.MULTILINE)}
    return found


class TestPromises(unittest.TestCase):
    def setUp(self):
        rows = re.findall(r"^\|[^|]+\|[^|]+\| ([^|]+) \|$", PAGE, re.MULTILINE)
        self.named = {name for row in rows for name in re.findall(r"`([\w.]+)`", row)}

    def test_named_tests_exist(self):
        self.assertGreater(len(self.named), 40)
        self.assertEqual(self.named - all_tests(), set())

    def test_every_test_of_filters_holds_a_promise(self):
        self.assertEqual(names("Cxx/Test*.cxx", "Cxx/Mpi/Test*.cxx") - self.named, set())


class TestFaults(unittest.TestCase):
    ROW = r"^\| [^|]+ \| [^|]+ \| ([\d-]+) \| ([\d-]+)(?: (\w+))? \| ([^|]+) \|$"

    def setUp(self):
        self.rows = re.findall(self.ROW, FAULTS, re.MULTILINE)
        lines = [line for line in FAULTS.splitlines() if line.startswith("| ") and not line.startswith("| fault ")]
        self.assertEqual(len(self.rows), len(lines))
        self.assertGreater(len(lines), 25)
        self.assertLessEqual(len(FAULTS.split()), 900)

    def test_named_tests_exist(self):
        tests = all_tests() | names("Fuzz/Corpus/*/*")
        for *_, cell in self.rows:
            named = re.findall(r"`([^`]+)`", cell)
            self.assertTrue(named, cell)
            self.assertEqual(set(named) - tests, set())

    def test_dates_are_those_of_commits(self):
        def git(*arguments):
            return subprocess.run(["git", "-C", TOP, *arguments], capture_output=True, text=True,
                                  check=False).stdout.strip()

        has_history = git("rev-parse", "--is-shallow-repository") == "false"
        for since, mended, commit, _ in self.rows:
            self.assertLessEqual(datetime.date.fromisoformat(since), datetime.date.fromisoformat(mended))
            if has_history and commit:
                self.assertEqual(git("log", "-1", "--format=%ad", "--date=short", commit), mended, commit)


if __name__ == "__main__":
    unittest.main()
