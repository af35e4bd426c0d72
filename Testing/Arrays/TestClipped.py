# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The cookbook's recipe for cells in a concave domain with holes: shapely intersects each cell with it."""

import importlib.util
import unittest

import numpy as np

from vtkflipflop.arrays import power_diagram

RANDOM = np.random.default_rng(61)


@unittest.skipUnless(importlib.util.find_spec("shapely"), "no shapely")
class TestClipped(unittest.TestCase):
    def test_cells_fill_the_domain(self):
        import shapely

        holes = [shapely.Point(x, y).buffer(1).exterior.coords for x, y in ((3, 3), (8, 4))]
        comb = [(0, 0), (10, 0), (10, 10), (8, 6), (6, 10), (5, 5.5), (3, 10), (0, 6)]
        domain = shapely.Polygon(comb, holes)
        grid = np.stack(np.meshgrid(np.arange(11), np.arange(11)), axis=-1).reshape(-1, 2)
        for points, weights in (
            (RANDOM.random((200, 2)) * 10, None),
            (RANDOM.random((200, 2)) * 10, RANDOM.random(200) * 0.5),
            (RANDOM.random((30, 2)) * 30 - 10, None),  # some beyond the domain
            (grid, None),  # sides along the border
        ):
            cells = power_diagram(points, weights, bounds=domain.bounds)
            shapes = np.array([shapely.Polygon(cells.vertices[ring]) for ring in cells.cells])
            self.assertTrue(shapely.is_valid(shapes).all())
            clipped = shapely.intersection(shapes, domain)
            np.testing.assert_allclose(shapely.area(clipped).sum(), domain.area, rtol=1e-12)
            # Each position of the domain is in the cell of its nearest site.
            at = RANDOM.random((100, 2)) * 10
            at = at[shapely.contains_xy(domain, *at.T)]
            heavy = np.zeros(len(points)) if weights is None else weights
            nearest = (((at[:, None] - points) ** 2).sum(axis=2) - heavy).argmin(axis=1)
            row = np.full(len(points), -1)
            row[cells.sites] = np.arange(len(cells))
            self.assertTrue(shapely.intersects_xy(clipped[row[nearest]], *at.T).all())


if __name__ == "__main__":
    unittest.main()
