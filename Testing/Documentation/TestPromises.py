# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Promises.md names tests that exist, and every test of the filters."""

import glob
import os
import re
import unittest

from tree import TOP, read

PAGE = read("Documentation", "Promises.md")


def names(*patterns):
    """The files' names, without what is after the dot."""
    files = [path for pattern in patterns for path in glob.glob(os.path.join(TOP, "Testing", pattern), recursive=True)]
    return {os.path.basename(path).split(".")[0] for path in files}


class TestPromises(unittest.TestCase):
    def setUp(self):
        rows = re.findall(r"^\|[^|]+\|[^|]+\| ([^|]+) \|$", PAGE, re.MULTILINE)
        self.named = {name for row in rows for name in re.findall(r"`([\w.]+)`", row)}

    def test_named_tests_exist(self):
        tests = names("**/Test*.*", "Cxx/RunPackage.cmake", "Cuda/Rounds/mutants.py", "Fuzz/*.cxx")
        for path in glob.glob(os.path.join(TOP, "Testing", "**", "*.cxx"), recursive=True):
            tests |= {".".join(name) for name in re.findall(r"^TEST\w*\((\w+), (\w+)\)", read(path), re.MULTILINE)}
        self.assertGreater(len(self.named), 40)
        self.assertEqual(self.named - tests, set())

    def test_every_test_of_filters_holds_a_promise(self):
        self.assertEqual(names("Cxx/Test*.cxx", "Cxx/Mpi/Test*.cxx") - self.named, set())


if __name__ == "__main__":
    unittest.main()
