# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.arrays: hulls of points in the plane answer as those of the same points in space, where both may."""

import itertools
import unittest

import numpy as np

from vtkflipflop.arrays import convex_hull, convex_hulls

RANDOM = np.random.default_rng(31)
STEPS = np.array([4, 0, 2, 1, 3, 0, 4])[:, None]
NONE, ONE, SAME = np.empty((0, 2)), np.array([[2.0, 3]]), np.tile([2.0, 3], (4, 1))
LINES = [np.add(STEPS * step, [0, 3.0]) for step in ([2, 1], [1, 0], [0, 1], [-3, 0.25], [2.0**-1000, 1])]
AREAS = [np.array([[5.0, 0], [0, 0], [0, 2]]), RANDOM.random((12, 2)), RANDOM.integers(0, 4, (30, 2)).astype(float)]
POSITIONS = np.vstack([RANDOM.integers(-1, 8, (30, 2)) / 2.0, [[2, 3], [0, 3], [8, 7], [np.nan, 0]]])
# Where x and y go in space.
AXES = ([0, 1], [1, 2], [2, 0])


def in_space(points, axes):
    found = np.zeros((len(points), 3))
    found[:, axes] = points
    return found


class TestFlatHulls(unittest.TestCase):
    def pairs(self, sets):
        for points, axes, facets in itertools.product(sets, AXES, ("triangles", "polygons")):
            plane, space = convex_hull(points, facets=facets), convex_hull(in_space(points, axes), facets=facets)
            self.same(plane, space, axes)
            yield plane, space, points, axes

    def same(self, plane, space, axes):
        """What both have alike, whatever they span."""
        self.assertEqual((plane.dimension, len(plane.vertices)), (space.dimension, len(space.vertices)))
        self.assertTrue(plane.validate() and space.validate())
        self.assertEqual(plane.diameter(), space.diameter())
        where = in_space(POSITIONS, axes)
        for name in ("contains", "support"):
            found = [getattr(hull, name)(at, non_finite="ignore") for hull, at in ((plane, POSITIONS), (space, where))]
            np.testing.assert_array_equal(*found)
        for name in ("min_bound", "max_bound"):
            np.testing.assert_array_equal(getattr(plane, name), getattr(space, name)[axes])
        first, second = plane.minimal_box(), space.minimal_box()
        np.testing.assert_array_equal(first.center, second.center[axes])
        np.testing.assert_array_equal([*first.lengths, 0], second.lengths)
        self.assertEqual((second.volume, second.lower_bound), (0, 0))
        if first.lengths[0] > 0 == first.lengths[1]:  # others may be turned
            np.testing.assert_array_equal(np.abs(first.axes[0]), np.abs(second.axes[0, axes]))
        for box in (first, second):
            self.assertAlmostEqual(np.linalg.det(box.axes), 1, delta=1e-14)

    def test_points_that_span_no_area_are_alike(self):
        for plane, space, _, axes in self.pairs([NONE, ONE, SAME, *LINES]):
            for name in ("vertices", "simplices", "neighbors", "edges", "certificate"):
                np.testing.assert_array_equal(getattr(plane, name), getattr(space, name))
            for name in ("offsets", "connectivity"):
                np.testing.assert_array_equal(getattr(plane.polygons, name), getattr(space.polygons, name))
            self.assertEqual(plane.apex.size + space.apex.size, 0)
            self.assertEqual((plane.volume, space.volume, space.area), (0, 0, 0))
            # A line in the plane is a facet, with a length and an equation; in space it is none.
            self.assertEqual(len(plane.equations), int(plane.dimension == 1))
            self.assertEqual(space.equations.shape, (0, 4))
            self.assertEqual(plane.area, plane.diameter().length if plane.dimension == 1 else 0)
            where = in_space(POSITIONS, axes)
            found = [hull.side(p, non_finite="ignore") for hull, p in ((plane, POSITIONS), (space, where))]
            np.testing.assert_array_equal(*found)
            found = [hull.distance(p, non_finite="ignore") for hull, p in ((plane, POSITIONS), (space, where))]
            np.testing.assert_allclose(*found, rtol=1e-14, atol=0)

    def test_areas_in_the_plane_are_facets_in_space(self):
        for plane, space, points, axes in self.pairs(AREAS):
            self.assertEqual((space.dimension, space.volume), (2, 0))
            self.assertEqual(plane.volume, space.area)
            np.testing.assert_array_equal(np.sort(plane.vertices), space.vertices)
            ring, outline = plane.polygons[0], space.polygons[0]
            self.assertEqual(len(plane.polygons), len(space.polygons))
            turned = np.roll(ring, -int(np.flatnonzero(ring == outline[0])[0]))
            np.testing.assert_array_equal(turned, outline)
            # The same plane for all triangles.
            normal = np.zeros(4)
            normal[3 - sum(axes)] = 1
            np.testing.assert_array_equal(space.equations, np.tile(normal, (len(space.simplices), 1)))
            where = in_space(POSITIONS, axes)
            # In space, what is inside is on the surface.
            found = [hull.side(p, non_finite="ignore") for hull, p in ((plane, POSITIONS), (space, where))]
            np.testing.assert_array_equal(np.minimum(found[0], 0), found[1])
            found = [hull.distance(p, non_finite="ignore") for hull, p in ((plane, POSITIONS), (space, where))]
            np.testing.assert_allclose(np.maximum(found[0], 0), found[1], rtol=1e-14, atol=1e-14)
            self.assertTrue((plane.certificate == 0).all())
            corners = points[space.simplices[space.certificate]]
            for i in range(3):
                a, b = corners[:, i], corners[:, (i + 1) % 3]
                turns = (b - a)[:, 0] * (points - a)[:, 1] - (b - a)[:, 1] * (points - a)[:, 0]
                self.assertTrue((turns >= -1e-15).all())

    def test_many_in_one_call(self):
        sets = [NONE, ONE, SAME, *LINES, *AREAS]
        plane, space = convex_hulls(sets), convex_hulls([in_space(points, AXES[0]) for points in sets])
        spans = np.array([convex_hull(points).dimension for points in sets])
        np.testing.assert_array_equal(np.where(spans == 2, plane.volumes, 0), space.areas)
        self.assertFalse(space.volumes.any())
        np.testing.assert_array_equal(plane.areas, [convex_hull(points).area for points in sets])


if __name__ == "__main__":
    unittest.main()
