# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Constraints from a second input, alpha complexes and borders, through ParaView's proxies."""

import unittest

import numpy as np
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkCellArray

from pipelines import array, cells, cloud, errors, fetch, poly_data, producer, run

# A kite whose short diagonal is Delaunay.
KITE = np.array([[0, -3, 7], [1, 0, 0], [0, 3, 0], [-1, 0, 5]])
# A 4 by 4 grid.
GRID = np.array([[i % 4, i // 4, i] for i in range(16)])
OUTER, HOLE = [0, 3, 15, 12], [5, 9, 10, 6]
# A 5 by 5 grid without its centre, around which four triangles have a larger circle.
RING = np.array([[i % 5, i // 5, i] for i in range(25) if i != 12])


def source_of(lines=(), polygons=()):
    data = poly_data(np.empty((0, 3)))
    for some, put in ((lines, data.SetLines), (polygons, data.SetPolys)):
        made = vtkCellArray()
        for ids in some:
            made.InsertNextCell(len(ids), ids)
        put(made)
    return producer(data)


class TestConstraints(unittest.TestCase):
    def test_lines(self):
        triangulation = run(simple.DelaunayTriangulation2DFlipFlop(Input=cloud(KITE)))
        self.assertEqual(cells(fetch(triangulation).GetPolys()), [(0, 1, 3), (1, 2, 3)])
        triangulation.Source = source_of([[0, 2]])
        self.assertEqual(cells(fetch(run(triangulation)).GetPolys()), [(0, 1, 2), (0, 2, 3)])
        self.assertEqual(triangulation.EngineReason, "constraints are the CPU's")
        fixed = fetch(triangulation, 1)
        self.assertEqual(cells(fixed.GetLines()), [(0, 2)])
        self.assertEqual(list(array(fixed.GetCellData(), "ConstraintCellIds")), [0])
        triangulation.Source = None
        self.assertEqual(cells(fetch(run(triangulation)).GetPolys()), [(0, 1, 3), (1, 2, 3)])

    def test_polygons(self):
        triangulation = run(
            simple.DelaunayTriangulation2DFlipFlop(
                Input=cloud(GRID), Source=source_of(polygons=[OUTER, HOLE]), FacetMode="Polygons"
            )
        )
        self.assertEqual(fetch(triangulation).GetNumberOfPolys(), 8)
        self.assertEqual(triangulation.NumberOfDroppedCells, 1)

    def test_the_border(self):
        triangulation = run(
            simple.RegularWeightedDelaunayTriangulationFlipFlop(Input=cloud(RING), Alpha=0.75, GenerateBoundary=1)
        )
        border = fetch(triangulation, 2)
        self.assertEqual(border.GetNumberOfLines(), 2)
        ids = array(border.GetPointData(), "vtkOriginalPointIds")
        rings = [[int(ids[i]) for i in ring] for ring in cells(border.GetLines())]
        self.assertEqual(
            rings,
            [[0, 1, 2, 3, 4, 9, 13, 18, 23, 22, 21, 20, 19, 14, 10, 5, 0], [7, 11, 16, 12, 7]],
        )

    def test_crossing(self):
        triangulation = simple.DelaunayTriangulation2DFlipFlop(Input=cloud(KITE), Source=source_of([[0, 2], [1, 3]]))
        with errors() as lines:
            run(triangulation)
        triangulation.SplitCrossingConstraints = 1
        self.assertEqual(fetch(run(triangulation)).GetNumberOfPolys(), 4)
        self.assertTrue(any("An edge of cell 1 of the source crosses one of cell 0" in line for line in lines), lines)


class TestAlpha(unittest.TestCase):
    def test_complex(self):
        xyz = np.array([[0, 0, 0], [6, 0, 0], [0, 8, 0], [30, 0, 0], [32, 0, 0], [90, 90, 0]])
        triangulation = run(
            simple.RegularWeightedDelaunayTriangulationFlipFlop(
                Input=cloud(xyz), Alpha=5.0, AlphaLines=1, AlphaVerts=1, GenerateAlphas=1
            )
        )
        output = fetch(triangulation)
        self.assertEqual(cells(output.GetPolys()), [(0, 1, 2)])
        self.assertEqual(cells(output.GetLines()), [(3, 4)])
        self.assertEqual(cells(output.GetVerts()), [(5,)])
        self.assertEqual(list(array(output.GetCellData(), "Alpha")), [0, 1, 5])


if __name__ == "__main__":
    unittest.main()
