#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters' libraries export their installed classes, and nothing of the engine or of their helpers."""

import importlib.util
import os
import re
import subprocess
import unittest
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
LIBRARIES = os.environ["FLIPFLOP_LIBRARIES"].split(":")

SPEC = importlib.util.spec_from_file_location("measure_filters", TOP / "Scripts" / "measure-filters.py")
MEASURE = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(MEASURE)

OURS = re.compile(r"\b((?:vtkP?)?FF[A-Z]\w+|flipflop)\b")


def classes(symbols):
    """The class of each symbol that is ours: the first that its name has, what it is called with aside."""
    found = {}
    for symbol in symbols:
        name = OURS.search(re.sub(r"\(.*", "", symbol)) or OURS.search(symbol)
        if name:
            found.setdefault(name[1], []).append(symbol)
    return found


class Exports(unittest.TestCase):
    def test_classes_of_symbols(self):
        listed = ["T FFRun::Do(std::function<void ()> const&)", "T vtkPFFHullFilter::Take(FFRun&)",
                  "V vtable for FFInput", "i flipflop::HullPlanes::compare(double)", "W std::vector<int>::size()"]
        self.assertEqual(list(classes(listed)), ["FFRun", "vtkPFFHullFilter", "FFInput", "flipflop"])

    def test_only_installed_classes(self):
        installed = MEASURE.installed_classes()
        for library in LIBRARIES:
            with self.subTest(library=os.path.basename(library)):
                listed = subprocess.run(["nm", "--dynamic", "--demangle", "--defined-only", library],
                                        check=True, capture_output=True, text=True).stdout
                symbols = [line.split(" ", 1)[1] for line in listed.splitlines()]
                found = classes(symbols)
                self.assertTrue(set(found) & installed, "exports no filter at all")
                self.assertEqual({name: found[name] for name in set(found) - installed}, {})


if __name__ == "__main__":
    unittest.main()
