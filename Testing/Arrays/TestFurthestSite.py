# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Furthest-site triangulations and diagrams. That the triangles are right is for the engine's tests."""

import importlib.util
import pickle
import unittest
from fractions import Fraction

import numpy as np
from vtkflipflop import spatial
from vtkflipflop.arrays import convex_hull, furthest_site_triangulation

HAS_SCIPY = importlib.util.find_spec("scipy") is not None
RANDOM = np.random.default_rng(8)
CLOUDS = [RANDOM.normal(size=(60, 2)), RANDOM.integers(-4, 5, (40, 2)).astype(float), np.array([[0.0, 0], [3, 1]])]


def furthest(points, position):
    """The points that are the furthest from a position, exactly."""
    squares = [sum((Fraction(a) - b) ** 2 for a, b in zip(point, position)) for point in points.tolist()]
    return {tuple(point) for point, square in zip(points.tolist(), squares) if square == max(squares)}


class TestFurthestSite(unittest.TestCase):
    def test_triangles(self):
        for points in CLOUDS[:2]:
            found = furthest_site_triangulation(points)
            np.testing.assert_array_equal(found.vertices, np.sort(convex_hull(points).vertices))
            self.assertEqual(len(found.vertices) + len(found.hidden), len(points))
            self.assertAlmostEqual(found.areas.sum(), convex_hull(points).volume)
            cells = found.locate(points)
            np.testing.assert_array_equal(cells >= 0, True)
            centers = points[found.simplices].mean(axis=1)
            np.testing.assert_array_equal(found.locate(centers), np.arange(found.nsimplex))
            again = pickle.loads(pickle.dumps(found))
            np.testing.assert_array_equal(again.simplices, found.simplices)

    def test_rays_have_the_furthest_points(self):
        for points in CLOUDS:
            diagram = furthest_site_triangulation(points).voronoi_diagram()
            rays = diagram.rays
            self.assertEqual(len(rays.ridges), len(diagram.sites))
            for row, start, direction in zip(rays.ridges, rays.starts.tolist(), rays.directions.tolist()):
                far = [Fraction(x) + 1000 * Fraction(d) for x, d in zip(start, direction)]
                # The start is rounded: either of the two may be a little further.
                self.assertLessEqual(furthest(points, far), set(map(tuple, points[diagram.ridge_points[row]].tolist())))

    def test_cells_are_counter_clockwise(self):
        diagram = furthest_site_triangulation(CLOUDS[0]).voronoi_diagram()
        self.assertTrue(diagram.is_open.all())
        self.assertGreater(len(diagram.vertices), 4)
        for ids in diagram.cells:
            corners = diagram.vertices[ids]
            for a, b, c in zip(corners, corners[1:], corners[2:]):
                self.assertGreater((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), 0)
        for (p, q), (right, left) in zip(diagram.ridge_points, diagram.ridge_vertices):
            if right >= 0:
                step, across = CLOUDS[0][q] - CLOUDS[0][p], diagram.vertices[left] - diagram.vertices[right]
                self.assertGreater(step[0] * across[1] - step[1] * across[0], 0)
        self.assertTrue(repr(diagram).startswith("<FurthestSiteDiagram: "))
        np.testing.assert_array_equal(diagram.cell_of < 0, ~np.isin(np.arange(60), diagram.sites))

    @unittest.skipUnless(HAS_SCIPY, "scipy is not installed")
    def test_as_scipy(self):
        import scipy.spatial

        points = CLOUDS[0]
        found, wanted = (of.Delaunay(points, furthest_site=True) for of in (spatial, scipy.spatial))
        self.assertEqual({frozenset(row) for row in found.simplices}, {frozenset(row) for row in wanted.simplices})
        self.assertEqual(found.furthest_site, True)
        np.testing.assert_array_equal(found.find_simplex([[9, 9], [0, 0]]) < 0, [True, False])
        one, other = (of.Voronoi(points, furthest_site=True) for of in (spatial, scipy.spatial))
        np.testing.assert_allclose(*(of.vertices[np.lexsort(of.vertices.T)] for of in (one, other)))
        self.assertEqual(
            {frozenset(pair) for pair in one.ridge_points.tolist()},
            {frozenset(pair) for pair in other.ridge_points.tolist()},
        )
        bare = spatial.Voronoi(points, furthest_site=True, qhull_options="Qbb")
        self.assertEqual([bare.regions[i] for i in bare.point_region], [one.regions[i] for i in one.point_region])
        for mine, theirs in zip(one.point_region, other.point_region):
            self.assertEqual(len(one.regions[mine]), len(other.regions[theirs]))
        added = spatial.Delaunay(points[:30], furthest_site=True, incremental=True)
        added.add_points(points[30:])
        np.testing.assert_array_equal(added.simplices, found.simplices)


if __name__ == "__main__":
    unittest.main()
