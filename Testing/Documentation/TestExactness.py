# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Exactness.md's tables, row by row: what the filters give is what the page says."""

import glob
import os
import re
import unittest

from failures import FAILURES, surface
from outcomes import errors_while_updating, hull_of, poly_data, triangulation_of
from tree import TOP, read
from vtkflipflop import vtkFFAlgorithm

PAGE = read("Documentation", "Exactness.md")


def rows_below(header):
    """The cells of the table of this header, without its rule."""
    lines = PAGE.split(f"\n{header}\n", 1)[1].split("\n\n", 1)[0].splitlines()[1:]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]


def found(name, points):
    """The row as it should be."""
    data = poly_data(points.strip("`"))
    ignore = name.endswith("ignored")
    return [name, points, hull_of(data, ignore), *triangulation_of(data, ignore)]


class TestExactness(unittest.TestCase):
    def test_every_input_has_an_answer(self):
        rows = rows_below("| input | points | hull | triangulation | hidden | power cells |")
        self.assertGreater(len(rows), 30)
        for row in rows:
            with self.subTest(row[0]):
                self.assertEqual(row, found(*row[:2]), "| " + " | ".join(found(*row[:2])) + " |")

    def test_errors(self):
        rows = rows_below("| input | the filter's sentence begins | the engine throws |")
        self.assertEqual([row[0] for row in rows], list(FAILURES))
        for name, sentence, _ in rows:
            if "CUDA" in name and vtkFFAlgorithm.IsCUDAAvailable():
                continue
            with self.subTest(name):
                algorithm = FAILURES[name]()
                messages = errors_while_updating(algorithm)
                self.assertEqual(len(messages), 1)
                self.assertGreater(len(sentence), 20)
                self.assertEqual(messages[0][: len(sentence)], sentence)
                self.assertNotEqual(algorithm.GetErrorCode(), 0)
                for port in range(algorithm.GetNumberOfOutputPorts()):
                    output = algorithm.GetOutputDataObject(port)
                    self.assertEqual(output.GetNumberOfElements(0), 0)

    def test_a_surface_without_points_is_none(self):
        algorithm = surface([], "")
        self.assertEqual(errors_while_updating(algorithm), [])
        self.assertEqual(algorithm.GetDimension(), -1)
        self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 0)

    def test_every_code_and_no_other_is_told(self):
        codes = re.search(r"enum class ErrorCode\n\{(.*?)\};", read("Engine", "include", "flipflop", "Error.h"), re.DOTALL)
        codes = set(re.findall(r"^\s*(\w+)\s*(?:,|///<)", codes[1], re.MULTILINE))
        self.assertIn("NonFinite", codes)
        told = set(re.findall(r"`([A-Z]\w+)`", PAGE))
        self.assertEqual(codes - told, set())

    def test_tests_that_are_named_exist(self):
        tests = set()
        for path in glob.glob(os.path.join(TOP, "Testing", "Engine", "*", "Test*.cxx")):
            tests |= set(re.findall(r"^TEST\((\w+), (\w+)\)", read(path), re.MULTILINE))
        named = {tuple(name) for name in re.findall(r"`([A-Z]\w+)\.([A-Z]\w+)`", PAGE)}
        self.assertGreater(len(named), 10)
        self.assertEqual(named - tests, set())


if __name__ == "__main__":
    unittest.main()
