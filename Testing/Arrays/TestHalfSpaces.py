# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Intersections of half-spaces. That they are exact is for the engine's tests."""

import importlib.util
import pickle
import unittest

import numpy as np
from vtkflipflop import spatial
from vtkflipflop.arrays import InputError, half_space_intersection

HAS_SCIPY = importlib.util.find_spec("scipy") is not None
RANDOM = np.random.default_rng(21)
SQUARE = np.array([[-1.0, 0, 0], [1, 0, -1], [0, -1, 0], [0, 1, -2]])
CUBE = np.array([[-1.0, 0, 0, 0], [1, 0, 0, -1], [0, -1, 0, 0], [0, 1, 0, -1], [0, 0, -1, 0], [0, 0, 1, -1]])


def random_half_spaces(count, ndim):
    normals = RANDOM.normal(size=(count, ndim))
    return np.column_stack([normals, -np.linalg.norm(normals, axis=1) * RANDOM.uniform(1, 1.2, count)])


class TestArrays(unittest.TestCase):
    def test_boxes(self):
        for rows, corners, volume, area in ((SQUARE, 4, 2, 6), (CUBE, 8, 1, 6)):
            found = half_space_intersection(rows)
            self.assertEqual(found.kind, "bounded")
            self.assertEqual((len(found.vertices), found.volume, found.area), (corners, volume, area))
            np.testing.assert_array_equal(found.facets, np.arange(len(rows)))
            self.assertEqual(repr(found).split(":")[1], f" bounded, {len(rows)} facets, {corners} vertices>")

    def test_facets_are_counter_clockwise_from_outside(self):
        found = half_space_intersection(random_half_spaces(60, 3))
        self.assertGreater(len(found.facets), 20)
        uses = np.bincount(found.facet_vertices.connectivity, minlength=len(found.vertices))
        np.testing.assert_array_equal(uses, np.diff(found.facets_at_vertices.offsets))
        for facet, ids in zip(found.facets, found.facet_vertices):
            row, corners = found.half_spaces[facet], found.vertices[ids]
            np.testing.assert_allclose(corners @ row[:3] + row[3], 0, atol=1e-12)
            turns = np.cross(np.roll(corners, -1, axis=0) - corners, np.roll(corners, -2, axis=0) - corners)
            self.assertGreater((turns @ row[:3]).min(), 0)
            for vertex in ids:
                self.assertIn(facet, found.facets_at_vertices[vertex])

    def test_polygons_are_counter_clockwise(self):
        found = half_space_intersection(random_half_spaces(60, 2))
        a, b = found.vertices, np.roll(found.vertices, -1, axis=0)
        self.assertAlmostEqual(found.volume, (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum() / 2)
        for facet, (begin, end) in zip(found.facets, found.facet_vertices):
            self.assertEqual((begin + 1) % len(found.vertices), end)
            row = found.half_spaces[facet]
            np.testing.assert_allclose(found.vertices[[begin, end]] @ row[:2] + row[2], 0, atol=1e-12)

    def test_kinds(self):
        for rows, kind in (
            (SQUARE[:3], "unbounded"),
            (np.vstack([SQUARE, [[1, 0, 0]]]), "flat"),
            (np.vstack([SQUARE, [[1, 0, 0.5]]]), "empty"),
            (np.vstack([SQUARE, [[0, 0, 0.5]]]), "empty"),
            (np.vstack([SQUARE, [[0, 0, -0.5]]]), "bounded"),
            (np.vstack([SQUARE, SQUARE[:1] * 3, [[1, 1, -3]], [[1, 1, -9]]]), "bounded"),
        ):
            with self.subTest(kind):
                found = half_space_intersection(rows)
                self.assertEqual(found.kind, kind)
                self.assertEqual(len(found.facet_vertices), len(found.facets))
                self.assertEqual(np.isnan(found.interior_point).any(), kind in ("flat", "empty"))
                volume = {"bounded": 2, "unbounded": np.inf}.get(kind, 0)
                self.assertEqual(found.volume, volume)
                if kind == "bounded":
                    np.testing.assert_array_equal(found.facets, np.arange(4))

    def test_sizes_at_any_magnitude(self):
        for size in (1e-200, 1e150):
            found = half_space_intersection(np.empty((0, 3)), bounds=(-size, size, -size, size))
            np.testing.assert_allclose([found.volume, found.area], [4 * size * size, 8 * size])
            planes = spatial.HalfspaceIntersection(found.half_spaces, (0, 0)).dual_equations
            np.testing.assert_allclose(np.abs(planes[:, :2]), 0.5**0.5)
            np.testing.assert_allclose(planes[:, 2], -(0.5**0.5) / size)

    def test_bounds(self):
        found = half_space_intersection([[1, 1, -1]], bounds=(0, 4, 0, 5))
        self.assertEqual((found.kind, found.volume), ("bounded", 0.5))
        np.testing.assert_array_equal(found.facets, [0, 1, 3])
        found = half_space_intersection(np.empty((0, 4)), bounds=(0, 1, 0, 2, 0, 3))
        self.assertEqual(found.volume, 6)
        with self.assertRaisesRegex(ValueError, "x0 < x1"):
            half_space_intersection(SQUARE, bounds=(0, 0, 1, 2))

    def test_bad_input(self):
        for rows, interior, error, sentence in (
            (SQUARE, (0.5, 0), InputError, r"the interior point is not strictly inside half-space 2: \[0.0, -1.0"),
            ([[1, np.nan, 0]], None, InputError, "half-space 0 is not finite"),
            ([[1, 2]], None, ValueError, r"n by 3, not an array of shape \(1, 2\)"),
            (SQUARE, (0.5, 1, 2), ValueError, "interior_point is 2 finite numbers"),
        ):
            with self.subTest(sentence), self.assertRaisesRegex(error, sentence):
                half_space_intersection(rows, interior)

    def test_a_copy_has_all(self):
        found = half_space_intersection(CUBE)
        found.volume
        again = pickle.loads(pickle.dumps(found))
        np.testing.assert_array_equal(again.vertices, found.vertices)
        self.assertEqual([list(ids) for ids in again.facet_vertices], [list(ids) for ids in found.facet_vertices])
        self.assertFalse(found.vertices.flags.writeable or again.vertices.flags.writeable)


class TestSpatial(unittest.TestCase):
    @unittest.skipUnless(HAS_SCIPY, "scipy is not installed")
    def test_as_scipy(self):
        import scipy.spatial

        for ndim in (2, 3):
            rows, inside = random_half_spaces(200, ndim), np.zeros(ndim)
            found = spatial.HalfspaceIntersection(rows, inside)
            wanted = scipy.spatial.HalfspaceIntersection(rows, inside)
            facets = {frozenset(ids): i for i, ids in enumerate(found.dual_facets)}
            order = [facets[frozenset(ids)] for ids in wanted.dual_facets]
            np.testing.assert_allclose(found.intersections[order], wanted.intersections)
            np.testing.assert_allclose(found.dual_equations[order], wanted.dual_equations, atol=1e-12)
            np.testing.assert_allclose(found.dual_points, wanted.dual_points)
            np.testing.assert_array_equal(found.dual_vertices, wanted.dual_vertices)
            self.assertEqual(found.dual_vertices.dtype, wanted.dual_vertices.dtype)
            np.testing.assert_allclose(
                [found.dual_volume, found.dual_area], [wanted.dual_volume, wanted.dual_area]
            )
            self.assertEqual((found.ndim, found.nineq), (wanted.ndim, wanted.nineq))

    def test_half_spaces_are_added(self):
        for ndim in (2, 3):
            rows, inside = random_half_spaces(200, ndim), np.zeros(ndim)
            added = spatial.HalfspaceIntersection(rows[:50], inside, incremental=True)
            for begin in range(50, 200, 50):
                added.add_halfspaces(rows[begin : begin + 50])
            whole = spatial.HalfspaceIntersection(rows, inside)
            np.testing.assert_array_equal(added.intersections, whole.intersections)
            self.assertEqual(added.dual_facets, whole.dual_facets)
            np.testing.assert_array_equal(added.dual_points, whole.dual_points)
            self.assertAlmostEqual(added.dual_volume, whole.dual_volume)
            bad = np.append(np.ones(ndim), 0.0)
            with self.assertRaisesRegex(spatial.QhullError, "not strictly inside half-space 200"):
                added.add_halfspaces(bad)
            with self.assertRaisesRegex(ValueError, "half-space 200, .* is not finite"):
                added.add_halfspaces(np.append(np.ones(ndim), np.nan))
            self.assertEqual(added.nineq, 200)
            added.add_halfspaces(rows[0], restart=True)
            added.close()
            with self.assertRaisesRegex(RuntimeError, "closed"):
                added.add_halfspaces(rows)

    def test_bad_input(self):
        for rows, inside, error, sentence in (
            (SQUARE, (0, 1), spatial.QhullError, r"feasible point \[0. 1.\] is not strictly inside half-space 0"),
            (SQUARE[:2], (0.5, 1), spatial.QhullError, "unbounded"),
            (SQUARE, (0.5, 1, 1), ValueError, "feasible point has to be"),
            (np.zeros((5, 5)), np.zeros(4), NotImplementedError, "pass fallback=True"),
        ):
            with self.subTest(sentence), self.assertRaisesRegex(error, sentence):
                spatial.HalfspaceIntersection(rows, inside)


if __name__ == "__main__":
    unittest.main()
