# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Exactness.md's tables, row by row: what the filters give is what the page says."""

import unittest

from failures import surface
from outcomes import errors_while_updating, hull_of, poly_data, triangulation_of
from tree import read

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

    def test_a_surface_without_points_is_none(self):
        algorithm = surface([], "")
        self.assertEqual(errors_while_updating(algorithm), [])
        self.assertEqual(algorithm.GetDimension(), -1)
        self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 0)


if __name__ == "__main__":
    unittest.main()
