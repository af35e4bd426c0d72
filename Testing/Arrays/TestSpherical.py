# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.arrays on a sphere: triangles are the hull's by rationals; cells, arcs and areas fit them."""

import importlib.util
import os
import unittest
from fractions import Fraction

import numpy as np
from vtkflipflop.arrays import InputError, directions_of, lonlat_of, spherical_triangulation, spherical_voronoi

CASES = int(os.environ.get("FLIPFLOP_TEST_CASES", 100))
HAS_SCIPY = importlib.util.find_spec("scipy") is not None
OCTAHEDRON = np.concatenate([np.eye(3), -np.eye(3)])
TURN = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]


def random_set(seed):
    """Points anywhere, in one half, a small cap, next to a circle, or of a grid of degrees; a radius and a center."""
    random = np.random.default_rng(seed)
    count = random.integers(5, 30)
    points = random.normal(size=(count, 3))
    kind = seed % 5
    if kind == 1:
        points[:, 2] = np.abs(points[:, 2])
    if kind == 2:
        points = [0, 0, 1] + points * random.choice([1e-1, 1e-4])
    if kind == 3:
        points[:, 2] *= 1e-3
    if kind == 4:
        points = directions_of(random.integers(-12, 13, count) * 15, random.integers(-6, 7, count) * 15)
        points = np.concatenate([points, OCTAHEDRON[: random.integers(3, 7)]])
    elif random.random() < 0.5:
        points = points @ TURN
    radius = random.choice([1.0, 1e-3, 6371.0])
    center = random.normal(size=3) * radius if seed % 2 else np.zeros(3)
    return radius * points / np.linalg.norm(points, axis=1)[:, None] + center, radius, center


def as_integers(rows):
    """The same numbers times a power of two."""
    exact = [list(map(Fraction, row)) for row in rows]
    scale = max(x.denominator for row in exact for x in row)
    return [[int(x * scale) for x in row] for row in exact]


def turn_of(a, b, c, d):
    """More than 0 if d is outside of a triangle, which is counter-clockwise from outside."""
    u, v, w = ([y - x for x, y in zip(a, other)] for other in (b, c, d))
    return (
        u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0])
    )


def arc(a, b):
    return np.arctan2(np.linalg.norm(np.cross(a, b)), np.dot(a, b))


class TestRandom(unittest.TestCase):
    def test_by_rationals(self):
        for seed in range(CASES):
            with self.subTest(seed=seed):
                self.check(*random_set(seed))

    def check(self, points, radius, center):
        found = spherical_triangulation(points, radius=radius, center=center)
        *exact, middle = as_integers([*points.tolist(), center.tolist()])
        for corners in found.simplices.tolist():
            self.assertLessEqual(max(turn_of(*(exact[k] for k in corners), other) for other in exact), 0)
        self.assertEqual(len(found.simplices), 2 * len(found.vertices) - 4)
        self.assertEqual(len(found.edges), 3 * len(found.vertices) - 6)
        np.testing.assert_array_equal(np.union1d(found.vertices, found.hidden), np.arange(len(points)))
        turns = [turn_of(*(exact[k] for k in corners), middle) for corners in found.simplices.tolist()]
        whole = 4 * np.pi * radius**2
        self.assertAlmostEqual(found.areas.sum() / whole, float(max(turns) <= 0), 9)
        self.assertTrue(all(turn <= 0 if area > 0 else turn >= 0 for turn, area in zip(turns, found.areas)))
        for (i, j), length in zip(found.edges, found.edge_lengths):
            self.assertAlmostEqual(length / radius, arc(*((points[[i, j]] - center) / radius)), 9)
        self.check_cells(found, found.voronoi_diagram(), whole)

    def check_cells(self, found, diagram, whole):
        points, center, radius = found.points, found.center, found.radius
        self.assertAlmostEqual(diagram.areas.sum() / whole, 1, 11)
        self.assertGreaterEqual(diagram.areas.min(), 0)
        np.testing.assert_allclose(np.linalg.norm(diagram.vertices - center, axis=1), radius)
        cells = {site: cell.tolist() for site, cell in zip(diagram.sites.tolist(), diagram.cells)}
        self.assertEqual(len(diagram.vertices) - len(diagram.ridge_points) + len(diagram), 2)
        for site, cell in cells.items():
            vertices = diagram.vertices[cell]
            distances = np.linalg.norm(vertices[:, None] - points, axis=2)
            np.testing.assert_allclose(distances[:, site], distances.min(axis=1), atol=1e-10 * radius)
            self.assertEqual(len(set(cell)), len(cell))
        # Each side is in the cell of either point, once in either direction.
        steps = {(site, step) for site, cell in cells.items() for step in zip(cell, cell[1:] + cell[:1])}
        for (one, other), (right, left) in zip(diagram.ridge_points.tolist(), diagram.ridge_vertices.tolist()):
            steps -= {(one, (right, left)), (other, (left, right))}
        self.assertEqual(steps, set())
        for (i, j), length in zip(diagram.ridge_vertices, diagram.ridge_lengths):
            straight = arc(*((diagram.vertices[[i, j]] - center) / radius))
            self.assertAlmostEqual(length / radius, straight, 9)
        np.testing.assert_array_equal(diagram.cell_of[diagram.sites], np.arange(len(diagram)))
        for hidden in found.hidden.tolist():
            apart = np.linalg.norm(points[diagram.sites] - points[hidden], axis=1) / radius
            self.assertLessEqual(apart[diagram.cell_of[hidden]], apart.min() + 1e-9)

    @unittest.skipUnless(HAS_SCIPY, "scipy is not installed")
    def test_areas_are_scipys(self):
        import scipy.spatial

        points = np.random.default_rng(1).normal(size=(200, 3))
        points /= np.linalg.norm(points, axis=1)[:, None]
        wanted = scipy.spatial.SphericalVoronoi(points).calculate_areas()
        np.testing.assert_allclose(spherical_voronoi(points).areas, wanted, rtol=1e-9)


class TestSpecial(unittest.TestCase):
    def test_octahedron(self):
        diagram = spherical_voronoi(2 * OCTAHEDRON + 1, center=(1, 1, 1), radius=2)
        np.testing.assert_allclose(diagram.areas, 16 * np.pi / 6)
        np.testing.assert_allclose(diagram.triangulation.areas, 2 * np.pi)
        np.testing.assert_allclose(diagram.triangulation.edge_lengths, np.pi)
        np.testing.assert_allclose(diagram.ridge_lengths, 2 * np.arccos(1 / 3))
        self.assertEqual(sorted(map(len, diagram.regions)), 6 * [4])

    def test_points_of_one_circle_meet_once(self):
        cube = np.stack(np.meshgrid([-1, 1], [-1, 1], [-1, 1]), axis=-1).reshape(-1, 3)
        diagram = spherical_voronoi(cube, radius=np.sqrt(3))
        self.assertEqual((len(diagram.vertices), len(diagram.ridge_points)), (6, 12))
        np.testing.assert_allclose(diagram.areas, 4 * np.pi * 3 / 8)
        np.testing.assert_allclose(diagram.triangulation.areas.sum(), 4 * np.pi * 3)

    def test_half_a_sphere_down_to_the_equator(self):
        """The center is on the hull's surface, on the diagonal of a facet."""
        lon, lat = np.meshgrid(np.arange(0, 360, 10), np.arange(0, 90, 30))
        for turn in (np.eye(3), TURN):
            triangulation = spherical_triangulation(directions_of(lon, lat).reshape(-1, 3) @ turn)
            whole = triangulation.areas.sum() / (4 * np.pi)
            self.assertAlmostEqual(whole, round(whole), 9)
            self.assertAlmostEqual(triangulation.voronoi_diagram().areas.sum() / (4 * np.pi), 1, 9)
        exactly = spherical_triangulation(directions_of([0, 90, 180, 270, 0], [0, 0, 0, 0, 90]))
        np.testing.assert_allclose(np.sort(exactly.areas), np.array([1, 1, 1, 1, 2, 2]) * np.pi / 2)

    def test_points_opposite_to_each_other_are_neighbours(self):
        diagram = spherical_voronoi([[0, 0, 1], [0, 0, -1], [1, 0, 0], [0, 1, 0]])
        self.assertIn([0, 1], diagram.ridge_points.tolist())
        self.assertAlmostEqual(diagram.areas.sum(), 4 * np.pi)
        np.testing.assert_allclose(diagram.areas[:2], diagram.areas[0])

    def test_hidden_points(self):
        steps = np.linspace(0, 1e-7, 400)
        near = directions_of(*np.meshgrid(steps, steps[:20]))
        points = np.concatenate([OCTAHEDRON, near.reshape(-1, 3), OCTAHEDRON[2:4], [[np.nan, 0, 0]]])
        diagram = spherical_voronoi(points, non_finite="ignore")
        hidden = diagram.triangulation.hidden
        self.assertGreater(len(hidden), 1000)
        self.assertEqual(hidden[-2:].tolist(), [len(points) - 3, len(points) - 2])
        self.assertEqual(diagram.cell_of[[-3, -2, -1]].tolist(), [*diagram.cell_of[[2, 3]], -1])
        self.assertTrue((diagram.cell_of[:-1] >= 0).all())
        with self.assertRaisesRegex(InputError, "NaN or infinite"):
            spherical_voronoi(points)
        # A copy of a point has its cell, though one that is a little farther out is farthest along its direction.
        near = directions_of([44.95, 45], 20) * [[1 - 5e-7], [1 + 5e-7]]
        copied = spherical_voronoi(np.concatenate([OCTAHEDRON, near, near]))
        self.assertEqual(copied.cell_of.tolist(), [0, 1, 2, 3, 4, 5, 6, 7, 6, 7])

    def test_longitudes_and_latitudes(self):
        found = directions_of([0, 90, 180, -180, 270, 450, 5, 77, 30], [0, 0, 0, 0, 0, 0, 90, -90, 60])
        wanted = [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [-1, 0, 0], [0, -1, 0], [0, 1, 0], [0, 0, 1], [0, 0, -1]]
        self.assertEqual(found[:-1].tolist(), wanted)
        np.testing.assert_allclose(found[-1], [np.sqrt(3) / 4, 0.25, np.sqrt(0.75)])
        lon, lat = np.random.default_rng(1).uniform([-180, -90], [180, 90], (100, 2)).T
        found = directions_of(lon, lat)
        radians = np.radians(lon), np.radians(lat)
        wanted = np.cos(radians[0]) * np.cos(radians[1]), np.sin(radians[0]) * np.cos(radians[1]), np.sin(radians[1])
        np.testing.assert_allclose(found, np.transpose(wanted), atol=1e-15)
        np.testing.assert_allclose(lonlat_of(7 * found), np.column_stack([lon, lat]))
        self.assertEqual(directions_of(lon[:, None], lat[:5]).shape, (100, 5, 3))
        one = spherical_voronoi(np.column_stack([lon, lat]), lonlat=True, radius=6371)
        other = spherical_voronoi(6371 * found, radius=6371)
        np.testing.assert_array_equal(one.vertices, other.vertices)
        twice = [[0, 90], [90, 90], [180, 0], [-180, 0], [60, 0], [300, 0], [0, -90]]
        poles = spherical_triangulation(twice, lonlat=True)
        self.assertEqual(poles.hidden.tolist(), [1, 3])

    def test_bad_input(self):
        lonlat = [[0, 0], [0, 91], [np.nan, 0]]
        for call, error, sentence in (
            (dict(points=OCTAHEDRON, radius=2), InputError, "sphere of radius 2.0 .*: first at point 0, 6 such"),
            (dict(points=OCTAHEDRON, radius=-1), ValueError, "radius is more than 0"),
            (dict(points=OCTAHEDRON, threshold=1), ValueError, "threshold is a share"),
            (dict(points=OCTAHEDRON, center=[0, 0]), ValueError, "center is 3 finite numbers"),
            (dict(points=OCTAHEDRON, lonlat=True), ValueError, "n by 2 with lonlat=True, not"),
            (dict(points=OCTAHEDRON[:, :2]), ValueError, "n by 3 or n by 2 with lonlat=True, not"),
            (dict(points=OCTAHEDRON[[0, 1, 3, 4]]), InputError, "not in one plane: these span 2 dimensions"),
            (dict(points=lonlat, lonlat=True), InputError, "a latitude is beyond 90 degrees: first at point 1, 1 such"),
            (dict(points=lonlat[::2], lonlat=True), InputError, "NaN or infinite: first at point 1"),
        ):
            with self.subTest(sentence), self.assertRaisesRegex(error, sentence):
                spherical_voronoi(**call)


if __name__ == "__main__":
    unittest.main()
