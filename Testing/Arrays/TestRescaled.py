# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.arrays: triangulations of points whose x and y have different units."""

import importlib.util
import unittest
from fractions import Fraction

import numpy as np

from vtkflipflop.arrays import InputError, RescaledTriangulation, regular_triangulation

RANDOM = np.random.default_rng(51)
POINTS = RANDOM.random((60, 2)) * [1, 3000] + [5, -100]
AT = RANDOM.random((200, 2)) * [1.2, 3600] + [4.9, -400]
VALUES = RANDOM.random((60, 2))
METHODS = "linear", "natural", "laplace", "clough-tocher"


def is_inside_circle(a, b, c, d):
    """By the determinant, exactly: whether d is inside the circle of a, b, c, counter-clockwise."""
    rows = [(x - d[0], y - d[1], (x - d[0]) ** 2 + (y - d[1]) ** 2) for x, y in (a, b, c)]
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = rows
    return az * (bx * cy - cx * by) - bz * (ax * cy - cx * ay) + cz * (ax * by - bx * ay) > 0


class TestRescaled(unittest.TestCase):
    def test_it_is_the_triangulation_of_the_scaled_points(self):
        ours = regular_triangulation(POINTS, rescale=True)
        self.assertIs(type(ours), RescaledTriangulation)
        self.assertEqual(ours.scale.tolist(), [2.0**12, 1])
        scaled = [tuple(map(Fraction, row)) for row in (POINTS * ours.scale).tolist()]
        factors = [Fraction(number) for number in ours.scale.tolist()]
        self.assertEqual(scaled, [tuple(Fraction(x) * f for x, f in zip(row, factors)) for row in POINTS.tolist()])
        for triangle in ours.simplices[::5].tolist():
            corners = [scaled[i] for i in triangle]
            self.assertFalse(any(is_inside_circle(*corners, point) for point in scaled))
        self.assertTrue(ours.scaled.validate())
        plain = regular_triangulation(POINTS)
        self.assertFalse(np.array_equal(ours.simplices, plain.simplices))
        self.assertAlmostEqual(ours.areas.sum(), plain.areas.sum(), delta=1e-9)
        self.assertEqual({*map(tuple, ours.convex_hull.tolist())}, {*map(tuple, plain.convex_hull.tolist())})
        np.testing.assert_array_equal(ours.vertices, plain.vertices)

    def test_ranges_come_within_a_factor_of_two(self):
        for power in (-1060, -900, -40, -1, 0, 1, 2, 70, 1000):
            for columns in ([0, 1], [1, 0]):
                points = (RANDOM.random((40, 2)) - 0.5)[:, columns] * [1, 2.0**power][:: 1 - 2 * columns[0]]
                ours = regular_triangulation(points, rescale=True)
                ranges = np.ptp(ours.scaled.points, axis=0)
                if abs(power) < 1000:
                    self.assertTrue(0.5 < ranges[0] / ranges[1] < 2)
                self.assertEqual(ours.scale.min(), 1)
                self.assertTrue((ours.scaled.points / ours.scale == points).all())

    def test_units_of_powers_of_two_change_nothing(self):
        ours = regular_triangulation(POINTS, rescale=True)
        values = {method: ours.interpolate(VALUES, AT, method) for method in METHODS}
        self.assertTrue(np.isnan(values["linear"]).any())
        for unit in ([1, 2.0**-11], [2.0**30, 1], [2.0**-200, 2.0**-150]):
            with self.subTest(unit=unit):
                other = regular_triangulation(POINTS * unit, rescale=True)
                np.testing.assert_array_equal(other.simplices, ours.simplices)
                np.testing.assert_array_equal(other.locate(AT * unit), ours.locate(AT))
                for method in METHODS:
                    np.testing.assert_allclose(other.interpolate(VALUES, AT * unit, method), values[method], rtol=1e-12)

    def test_all_is_in_the_caller_s_unit(self):
        ours = regular_triangulation(POINTS, rescale=True, facets="polygons")
        inside = POINTS[ours.simplices].mean(axis=1)
        np.testing.assert_array_equal(ours.locate(inside), np.arange(ours.nsimplex))
        np.testing.assert_array_equal(ours.find_simplex(inside[0]), 0)
        ends = POINTS[ours.edges]
        lengths = np.hypot(*(ends[:, 0] - ends[:, 1]).T)
        within = ours.within_edge_length(np.median(lengths))
        some = ours.with_cells(within)
        self.assertTrue(0 < some.nsimplex < ours.nsimplex)
        full = np.where(within, np.cumsum(within) - 1, -1)
        np.testing.assert_array_equal(some.locate(inside), full)
        for cells in (ours, some):
            for method in METHODS:
                image = cells.to_image(VALUES, shape=(6, 5), method=method, fill_value=-1)
                self.assertEqual(image.transform[2], POINTS[cells.vertices, 0].min())
                pixels = np.stack(np.meshgrid(image.x, image.y), axis=-1)
                values = cells.interpolate(VALUES, pixels, method, fill_value=-1)
                np.testing.assert_array_equal(image.array, values)
        self.assertAlmostEqual(
            sum(np.ptp(np.array(part[0])[:, 0]) for part in ours.__geo_interface__["coordinates"]),
            np.ptp(POINTS[:, 0]),
        )

    def test_far_positions_are_outside(self):
        ours = regular_triangulation(POINTS * [1, 2.0**900], rescale=True)
        self.assertEqual(ours.locate([1e308, 0]), -1)
        self.assertEqual(ours.interpolate(VALUES[:, 0], [-1e308, 0], fill_value=3), 3)
        for wrong in (np.nan, np.inf):
            with self.assertRaisesRegex(InputError, "NaN or infinite: first at point 1"):
                ours.locate([[5, 0], [wrong, 0]])
            self.assertEqual(ours.locate([wrong, 0], non_finite="ignore"), -1)

    def test_points_of_all_kinds(self):
        bad = np.column_stack([POINTS, np.zeros(60)])
        bad[7, 1] = np.inf
        with self.assertRaisesRegex(InputError, "NaN or infinite: first at point 7"):
            regular_triangulation(bad, rescale=True)
        masked = np.ma.array(POINTS, mask=np.repeat(np.arange(60) == 7, 2))
        kept = np.delete(np.arange(60), 7)
        wanted = kept[regular_triangulation(POINTS[kept], rescale=True).simplices]
        for ours in (
            regular_triangulation(bad, rescale=True, non_finite="ignore"),
            regular_triangulation(masked, rescale=True),
        ):
            np.testing.assert_array_equal(ours.simplices, wanted)
        single = regular_triangulation(POINTS.astype(np.float32), rescale=True)
        double = regular_triangulation(POINTS.astype(np.float32).astype(float), rescale=True)
        np.testing.assert_array_equal(single.simplices, double.simplices)
        for points in (POINTS[:0], POINTS[:1], np.arange(4)[:, None] * [1, 0]):
            ours = regular_triangulation(points, rescale=True)
            self.assertEqual(ours.scale.tolist(), [1, 1])
            np.testing.assert_array_equal(ours.simplices, regular_triangulation(points).simplices)

    def test_what_it_does_not_go_with(self):
        for given in ({"weights": np.zeros(60)}, {"constraints": [[0, 1]]}, {"polygons": [[0, 1, 2]]}):
            with self.assertRaisesRegex(InputError, "rescale=True is for points without weights and constraints"):
                regular_triangulation(POINTS, **given, rescale=True)
        with self.assertRaisesRegex(TypeError, "rescale is True or False"):
            regular_triangulation(POINTS, rescale=2)

    @unittest.skipUnless(importlib.util.find_spec("scipy"), "no scipy")
    def test_as_scipy_where_ranges_differ_by_a_power_of_two(self):
        from scipy.interpolate import LinearNDInterpolator

        points = np.concatenate([RANDOM.random((200, 2)), [[0, 0], [1, 0], [1, 1], [0, 1]]]) * [2.0**-12, 1]
        at, values = RANDOM.random((300, 2)) * [2.0**-12, 1], RANDOM.random(204)
        theirs = LinearNDInterpolator(points, values, rescale=True)(at)
        ours = regular_triangulation(points, rescale=True)
        np.testing.assert_allclose(ours.interpolate(values, at), theirs, rtol=1e-9)


if __name__ == "__main__":
    unittest.main()
