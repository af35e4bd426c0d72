# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.spatial is scipy.spatial by another import: names, shapes, types, errors; and the same answers."""

import importlib.util
import itertools
import os
import unittest
import warnings
from fractions import Fraction

import numpy as np
from vtkflipflop import spatial
from vtkflipflop.arrays import convex_hull, power_diagram

HAS_SCIPY = importlib.util.find_spec("scipy") is not None
RANDOM = np.random.default_rng(12)
CLOUDS = {"plane": RANDOM.random((300, 2)), "space": RANDOM.normal(size=(300, 3))}
SQUARE = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])


def rows_of(simplices):
    return {tuple(sorted(row)) for row in simplices.tolist()}


class TestHulls(unittest.TestCase):
    @unittest.skipUnless(HAS_SCIPY, "scipy is not installed")
    def test_as_scipy(self):
        import scipy.spatial

        for name, points in CLOUDS.items():
            with self.subTest(name):
                found, wanted = spatial.ConvexHull(points), scipy.spatial.ConvexHull(points)
                self.assertEqual(rows_of(found.simplices), rows_of(wanted.simplices))
                if points.shape[1] == 2:
                    start = int(np.flatnonzero(wanted.vertices == found.vertices[0])[0])
                    np.testing.assert_array_equal(found.vertices, np.roll(wanted.vertices, -start))
                else:
                    np.testing.assert_array_equal(found.vertices, np.sort(wanted.vertices))
                np.testing.assert_allclose([found.volume, found.area], [wanted.volume, wanted.area])
                one, other = (hull.equations[np.lexsort(np.round(hull.equations, 9).T)] for hull in (found, wanted))
                np.testing.assert_allclose(one, other, atol=1e-12)
                np.testing.assert_array_equal(found.min_bound, wanted.min_bound)
                for attribute in ("vertices", "simplices", "neighbors", "equations", "coplanar", "points"):
                    mine, theirs = getattr(found, attribute), getattr(wanted, attribute)
                    self.assertEqual((mine.dtype, mine.shape), (theirs.dtype, theirs.shape), attribute)
                    self.assertTrue(mine.flags.writeable)

    def test_neighbors(self):
        hull = spatial.ConvexHull(CLOUDS["space"])
        for facet, others in zip(hull.simplices, hull.neighbors):
            for corner, other in enumerate(others):
                self.assertTrue(set(np.delete(facet, corner)) <= set(hull.simplices[other]))

    def test_points_are_added(self):
        for points in CLOUDS.values():
            with spatial.ConvexHull(points[:50], incremental=True) as hull:
                for begin in range(50, 300, 50):
                    hull.add_points(points[begin : begin + 50])
                    whole = spatial.ConvexHull(points[: begin + 50])
                    self.assertEqual(rows_of(hull.simplices), rows_of(whole.simplices))
                    np.testing.assert_array_equal(hull.points, whole.points)
                    self.assertAlmostEqual(hull.volume, whole.volume)
                hull.add_points(points[:3], restart=True)
                self.assertEqual(hull.npoints, 303)
            with self.assertRaisesRegex(RuntimeError, "closed"):
                hull.add_points(points)
        with self.assertRaisesRegex(RuntimeError, "incremental mode not enabled"):
            spatial.ConvexHull(SQUARE).add_points(SQUARE)
        hull = spatial.ConvexHull(SQUARE, incremental=True)
        with self.assertRaisesRegex(ValueError, "invalid size"):
            hull.add_points([[0, 0, 0]])

    def test_bad_input(self):
        for wrong, error, sentence in (
            (SQUARE[:2], spatial.QhullError, "all points are on a line: 2 points span less than 2"),
            (np.column_stack([SQUARE, SQUARE[:, 0]]), spatial.QhullError, "all points are in one plane"),
            (SQUARE[:0], ValueError, "No points given"),
            (SQUARE[[0, 2, 0]], spatial.QhullError, "QH6154 Qhull precision error: Initial simplex is flat"),
            (SQUARE[[1, 1, 1]], spatial.QhullError, "all points are at one position: 3 points"),
            ([1, 2, 3], ValueError, "an array of 2 dimensions, not 1"),
            ([[1], [2]], ValueError, "Need at least 2-D data"),
            ([[0, np.nan]], ValueError, "cannot contain NaN"),
            ([[0, np.inf]], ValueError, "cannot contain infinity"),
            (np.ma.masked_array(SQUARE), ValueError, "masked array"),
            (np.zeros((5, 4)), NotImplementedError, r"not 4: take scipy.spatial.ConvexHull, or pass fallback=True"),
        ):
            with self.subTest(sentence), self.assertRaisesRegex(error, sentence):
                spatial.ConvexHull(wrong)
        with self.assertRaisesRegex(NotImplementedError, "choose facets"):
            spatial.Delaunay(SQUARE, qhull_options="QG3")
        with self.assertRaisesRegex(TypeError, "not complex"):
            spatial.ConvexHull(SQUARE * 1j)
        with self.assertWarnsRegex(UserWarning, "'Qx Qt' mean nothing here"):
            spatial.ConvexHull(SQUARE, qhull_options="Qx Qt")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            spatial.ConvexHull(SQUARE, qhull_options="Qx Qt")

    def test_good(self):
        """Facets that a point sees, and the hull without it."""
        for seed in range(60):
            random = np.random.default_rng(seed)
            dimension, scale = 2 + seed % 2, random.choice([1.0, 0.1, 1e-160, 2.0**300])
            points = random.integers(0, 6, (12, dimension)) * scale
            points[7] = points[7:9].mean(axis=0) if seed % 3 else points[7] * 1.7
            try:
                hull = spatial.ConvexHull(points, True, "QG7")
            except spatial.QhullError:
                continue
            other = spatial.ConvexHull(np.delete(points, 7, axis=0))
            np.testing.assert_array_equal(hull.points[hull.simplices], other.points[other.simplices])
            self.assertEqual(hull.good.tolist(), [side > 0 for side in _sides(points, hull.simplices, points[7])])
            hull.add_points(points[:2] * 2)
            self.assertNotIn(7, hull.vertices)
            self.assertEqual(hull.good.tolist(), [side > 0 for side in _sides(hull.points, hull.simplices, points[7])])
            hidden = spatial.ConvexHull(hull.points, qhull_options="QG-7")
            np.testing.assert_array_equal(hidden.good, ~hull.good)
        self.assertIsNone(spatial.ConvexHull(SQUARE).good)
        with self.assertRaisesRegex(spatial.QhullError, "'QG4' name a point that is not one of 4"):
            spatial.ConvexHull(SQUARE, qhull_options="QG4")
        with self.assertRaisesRegex(spatial.QhullError, "no other point"):
            spatial.ConvexHull(SQUARE[:1], qhull_options="QG0")

    def test_coplanar(self):
        for dimension in (2, 3):
            grid = np.stack(np.meshgrid(*[np.arange(4.0)] * dimension), -1).reshape(-1, dimension) * 0.1
            points = np.concatenate([grid, grid[:3]])
            hull = spatial.ConvexHull(points, qhull_options="Qc")
            is_on = ((points == points.min(axis=0)) | (points == points.max(axis=0))).any(axis=1)
            is_on[hull.vertices] = False
            self.assertEqual(hull.coplanar[:, 0].tolist(), np.flatnonzero(is_on).tolist())
            self.assertEqual(hull.coplanar.dtype, np.int32)
            for i, facet, nearest in hull.coplanar:
                sides = np.array(_sides(points, hull.simplices, points[i]))
                self.assertEqual(sides[facet], 0)
                self.assertIn(nearest, hull.simplices[facet])
                lengths = np.linalg.norm(points[hull.simplices[sides == 0]] - points[i], axis=-1)
                self.assertEqual(np.linalg.norm(points[nearest] - points[i]), lengths.min())
            if HAS_SCIPY:
                import scipy.spatial

                wanted = scipy.spatial.ConvexHull(points, qhull_options="Qt Qc")
                self.assertEqual(len(wanted.coplanar), len(hull.coplanar))
            self.assertEqual(spatial.ConvexHull(points).coplanar.shape, (0, 3))

    @unittest.skipUnless(HAS_SCIPY, "scipy is not installed")
    def test_fallback(self):
        import scipy.spatial

        points = RANDOM.random((30, 4))
        self.assertIs(type(spatial.ConvexHull(points, fallback=True)), scipy.spatial.ConvexHull)
        self.assertIs(type(spatial.Delaunay(points[:, :3], fallback=True)), scipy.spatial.Delaunay)
        self.assertIs(type(spatial.ConvexHull(points[:, :3], fallback=True)), spatial.ConvexHull)


class TestTriangulations(unittest.TestCase):
    @unittest.skipUnless(HAS_SCIPY, "scipy is not installed")
    def test_as_scipy(self):
        import scipy.spatial

        points, queries = CLOUDS["plane"], RANDOM.random((200, 2)) * 1.2 - 0.1
        found, wanted = spatial.Delaunay(points), scipy.spatial.Delaunay(points)
        self.assertEqual(rows_of(found.simplices), rows_of(wanted.simplices))
        self.assertEqual(rows_of(found.convex_hull), rows_of(wanted.convex_hull))
        mine, theirs = found.find_simplex(queries), wanted.find_simplex(queries)
        np.testing.assert_array_equal(mine < 0, theirs < 0)
        np.testing.assert_array_equal(
            np.sort(found.simplices[mine[mine >= 0]]), np.sort(wanted.simplices[theirs[theirs >= 0]])
        )
        np.testing.assert_array_equal(spatial.tsearch(found, queries[0]), mine[0])
        first, ids = wanted.vertex_neighbor_vertices
        for i, (begin, end) in enumerate(zip(first[:-1], first[1:])):
            own = found.vertex_neighbor_vertices
            self.assertEqual(set(own[1][own[0][i] : own[0][i + 1]]), set(ids[begin:end]))
        for attribute in ("simplices", "neighbors", "equations", "convex_hull", "coplanar", "transform", "points"):
            one, other = getattr(found, attribute), getattr(wanted, attribute)
            self.assertEqual((one.dtype, one.shape), (other.dtype, other.shape), attribute)
            self.assertTrue(one.flags.writeable)
        # A triangle's plane has its lifted corners, and no lifted point is below.
        heights = found.plane_distance(points)
        np.testing.assert_allclose(np.take_along_axis(heights.T, found.simplices.astype(int), axis=1), 0, atol=1e-15)
        self.assertLess(heights.max(), 1e-15)
        self.assertGreater(found.plane_distance(points[found.simplices[0]].mean(axis=0)).max(), 0)

    def test_transform(self):
        tri = spatial.Delaunay(CLOUDS["plane"])
        queries = RANDOM.random((100, 2))
        cells = tri.find_simplex(queries)
        queries, cells = queries[cells >= 0], cells[cells >= 0]
        two = np.einsum("nij,nj->ni", tri.transform[cells, :2], queries - tri.transform[cells, 2])
        shares = np.column_stack([two, 1 - two.sum(axis=1)])
        self.assertGreater(shares.min(), -1e-12)
        back = np.einsum("nk,nkj->nj", shares, tri.points[tri.simplices[cells]])
        np.testing.assert_allclose(back, queries, atol=1e-12)

    def test_points_are_added_and_duplicates_told(self):
        points = np.concatenate([CLOUDS["plane"], CLOUDS["plane"][:20]])
        tri = spatial.Delaunay(points[:100], incremental=True)
        tri.add_points(points[100:])
        whole = spatial.Delaunay(points)
        np.testing.assert_array_equal(tri.simplices, whole.simplices)
        np.testing.assert_array_equal(tri.points, points)
        self.assertEqual(whole.coplanar[:, [0, 2]].tolist(), [[300 + i, i] for i in range(20)])
        self.assertTrue(all(i in whole.simplices[cell] for _, cell, i in whole.coplanar))
        self.assertTrue((whole.vertex_to_simplex >= 0).all())
        with self.assertRaisesRegex(spatial.QhullError, "on a line"):
            spatial.Delaunay([[0, 0], [1, 1], [2, 2]])
        for wrong, error in (([2, 2, 2], ValueError), (1, IndexError)):
            with self.assertRaises(error):
                whole.find_simplex(wrong)
        with self.assertRaisesRegex(NotImplementedError, "points have 2 coordinates here, not 3"):
            spatial.Delaunay(CLOUDS["space"])

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "matplotlib is not installed")
    def test_pictures(self):
        import matplotlib

        matplotlib.use("Agg")
        from matplotlib import pyplot

        ax = pyplot.figure().gca()
        for draw, shown, lines in (
            (spatial.convex_hull_plot_2d, spatial.ConvexHull(SQUARE), 4),
            (spatial.delaunay_plot_2d, spatial.Delaunay(SQUARE), 5),
            (spatial.voronoi_plot_2d, spatial.Voronoi(SQUARE), 4),
        ):
            ax.clear()
            self.assertIs(draw(shown, ax), ax.figure)
            self.assertEqual(sum(len(some.get_segments()) for some in ax.collections), lines)
            np.testing.assert_allclose([*ax.get_xlim(), *ax.get_ylim()], [-0.1, 1.1, -0.1, 1.1])
        # Rays begin at vertices, and go farther than the points.
        rays = np.array(ax.collections[-1].get_segments())
        np.testing.assert_array_equal(rays[:, 0], np.full((4, 2), 0.5))
        np.testing.assert_allclose(np.abs(rays[:, 1] - 0.5).max(axis=1), 1)
        # Those of a furthest-site diagram go the other way.
        ax.clear()
        spatial.voronoi_plot_2d(spatial.Voronoi([[0, 0], [1, 0], [0.4, 1]], furthest_site=True), ax)
        spatial.voronoi_plot_2d(spatial.Voronoi([[0, 0], [1, 0], [0.4, 1]]), ax)
        (one, other) = (np.array(some.get_segments()) for some in ax.collections if some.get_segments())
        steps = [rays[np.lexsort(rays[:, 1].T), 1] - rays[0, 0] for rays in (one, other)]
        np.testing.assert_allclose(np.sort(steps[0], axis=0), np.sort(-steps[1], axis=0))
        with self.assertRaisesRegex(ValueError, "in the plane, not of 3 coordinates"):
            spatial.convex_hull_plot_2d(spatial.ConvexHull(CLOUDS["space"]))


class TestDiagrams(unittest.TestCase):
    @unittest.skipUnless(HAS_SCIPY, "scipy is not installed")
    def test_as_scipy(self):
        import scipy.spatial

        points = CLOUDS["plane"]
        found, wanted = spatial.Voronoi(points), scipy.spatial.Voronoi(points)
        order, other = (np.lexsort(np.round(diagram.vertices, 9).T) for diagram in (found, wanted))
        np.testing.assert_allclose(found.vertices[order], wanted.vertices[other], rtol=1e-9)
        number = {-1: -1, **dict(zip(order.tolist(), other.tolist()))}
        ridges = {tuple(sorted(pair)): set(ends) for pair, ends in zip(wanted.ridge_points.tolist(), wanted.ridge_vertices)}
        self.assertEqual({pair: {number[i] for i in ends} for pair, ends in found.ridge_dict.items()}, ridges)
        for i in range(len(points)):
            mine, theirs = (diagram.regions[diagram.point_region[i]] for diagram in (found, wanted))
            self.assertEqual({number[k] for k in mine}, set(theirs))
        self.assertEqual(len(found.regions), len(wanted.regions))
        for attribute in ("vertices", "ridge_points"):
            one, another = getattr(found, attribute), getattr(wanted, attribute)
            self.assertEqual((one.dtype, one.shape), (another.dtype, another.shape), attribute)

    def test_by_rationals(self):
        """Vertices are all centers of circles through three points that have none inside, rounded once."""
        for seed in range(int(os.environ.get("FLIPFLOP_TEST_CASES", 300))):
            random = np.random.default_rng(seed)
            points = np.unique(random.integers(0, 5, (7, 2)), axis=0) * random.choice([1.0, 0.1, 1e-160, 2.0**300])
            circles = _empty_circles(points)
            if not circles:
                continue
            diagram = spatial.Voronoi(points)
            self.assertEqual({tuple(row) for row in diagram.vertices.tolist()}, set(circles.values()), f"seed {seed}")
            # One vertex far away ends all rays.
            cells = len(diagram.regions) - 1
            self.assertEqual(len(diagram.vertices) + 1 - len(diagram.ridge_points) + cells, 2, f"seed {seed}")

    def test_cells_are_those_in_a_box(self):
        points = np.concatenate([CLOUDS["plane"], np.mgrid[0:6, 0:6].reshape(2, -1).T + 2.0, CLOUDS["plane"][:5]])
        diagram = spatial.Voronoi(points)
        boxed = power_diagram(points, domain=(-1000, 1000, -1000, 1000))
        corners = {site: boxed.vertices[region] for site, region in zip(boxed.sites.tolist(), boxed.regions)}
        bounded = 0
        for i in range(len(points) - 5):
            region = diagram.regions[diagram.point_region[i]]
            own = diagram.vertices[[k for k in region if k >= 0]]
            if -1 not in region and np.abs(own).max() < 1000:
                bounded += 1
                self.assertEqual(set(map(tuple, own)), set(map(tuple, corners[i])))
                turns = np.cross(np.column_stack([np.roll(own, -1, axis=0) - own, np.zeros(len(own))]),
                                 np.column_stack([np.roll(own, -2, axis=0) - own, np.zeros(len(own))]))[:, 2]
                self.assertGreater(turns.min(), -1e-12)
        self.assertGreater(bounded, 250)
        np.testing.assert_array_equal(diagram.point_region[-5:], diagram.point_region[:5])

    def test_points_are_added(self):
        points = CLOUDS["plane"]
        diagram = spatial.Voronoi(points[:100], incremental=True)
        diagram.add_points(points[100:])
        whole = spatial.Voronoi(points)
        np.testing.assert_array_equal(diagram.vertices, whole.vertices)
        self.assertEqual(diagram.regions, whole.regions)
        with self.assertWarnsRegex(UserWarning, "'Qbb Qc' mean nothing here"):
            self.assertEqual(len(spatial.Voronoi(points, qhull_options="Qbb Qc").regions), 300)
        with self.assertRaisesRegex(spatial.QhullError, "on a line"):
            spatial.Voronoi([[0, 0], [1, 1], [2, 2]])


class TestSpheres(unittest.TestCase):
    OCTAHEDRON = np.concatenate([np.eye(3), -np.eye(3)])

    def check(self, points, radius, center):
        diagram = spatial.SphericalVoronoi(points, radius, center)
        areas = diagram.calculate_areas()
        self.assertAlmostEqual(areas.sum() / (4 * np.pi * radius**2), 1, 12)
        self.assertGreater(areas.min(), 0)
        self.assertEqual(len(diagram.vertices), 2 * len(points) - 4)
        np.testing.assert_allclose(np.linalg.norm(diagram.vertices - center, axis=1), radius)
        for point, region in zip(points, diagram.regions):
            own = diagram.vertices[region]
            nearest = np.linalg.norm(own[:, None] - points, axis=2).min(axis=1)
            np.testing.assert_allclose(np.linalg.norm(own - point, axis=1), nearest, atol=1e-11 * radius)
        return areas

    def test_random(self):
        for seed in range(60):
            random = np.random.default_rng(seed)
            points = random.normal(size=(random.integers(4, 60), 3))
            if seed % 3 == 0:  # all on one side
                points[:, 2] = np.abs(points[:, 2]) + 0.1
            center, radius = random.normal(size=3), random.choice([1.0, 1e-3, 6371.0])
            points *= radius / np.linalg.norm(points, axis=1)[:, None]
            areas = self.check(points + center, radius, center)
            if HAS_SCIPY and seed % 3:
                import scipy.spatial

                wanted = scipy.spatial.SphericalVoronoi(points + center, radius, center)
                np.testing.assert_allclose(areas, wanted.calculate_areas(), rtol=1e-8)
        areas = self.check(self.OCTAHEDRON, 1.0, np.zeros(3))
        np.testing.assert_allclose(areas, 4 * np.pi / 6)

    def test_bad_input(self):
        for wrong, error, sentence in (
            (dict(points=self.OCTAHEDRON[:, :2]), NotImplementedError, "n by 3 here.*fallback=True"),
            (dict(points=self.OCTAHEDRON, radius=2), ValueError, "Radius inconsistent"),
            (dict(points=self.OCTAHEDRON, radius=None), ValueError, "`radius` is `None`"),
            (dict(points=self.OCTAHEDRON[[0, 1, 3, 4]]), ValueError, "Rank of input points must be at least 3"),
            (dict(points=self.OCTAHEDRON[[0, 1, 2, 3, 4, 5, 0]]), ValueError, "Duplicate generators"),
        ):
            with self.subTest(sentence), self.assertRaisesRegex(error, sentence):
                spatial.SphericalVoronoi(**wrong)
        points = memoryview(self.OCTAHEDRON)
        self.assertEqual(len(spatial.SphericalVoronoi(points).regions), 6)
        self.assertEqual(convex_hull(points).volume, 4 / 3)


class TestInterpolators(unittest.TestCase):
    def test_as_scipy(self):
        points, queries = CLOUDS["plane"], RANDOM.random((40, 5, 2)) * 1.2 - 0.1
        stretched = points * [1, 1000]
        values = np.column_stack([points @ [1, 2], np.sin(5 * points[:, 0])])
        found = spatial.LinearNDInterpolator(points, values)(queries)
        self.assertEqual(found.shape, (40, 5, 2))
        np.testing.assert_allclose(found[..., 0][~np.isnan(found[..., 0])], (queries @ [1, 2])[~np.isnan(found[..., 0])])
        x, y = queries[..., 0], queries[..., 1]
        by_grid = spatial.griddata((points[:, 0], points[:, 1]), values, (x, y))
        np.testing.assert_array_equal(by_grid, found)
        of_complex = spatial.griddata(points, values[:, 0] + 2j, queries, fill_value=7)
        np.testing.assert_array_equal(of_complex[np.isnan(found[..., 0])], 7)
        np.testing.assert_allclose(of_complex.imag[~np.isnan(found[..., 0])], 2)
        square = points[:, 0] ** 2 + points[:, 0] * points[:, 1]
        smooth = spatial.griddata(points, square, queries, "cubic")
        inside = ~np.isnan(smooth)
        np.testing.assert_allclose(smooth[inside], (x**2 + x * y)[inside], atol=1e-9)
        near = spatial.griddata(points, np.arange(300), queries, "nearest")
        distances = np.linalg.norm(queries[..., None, :] - points, axis=-1)
        np.testing.assert_array_equal(near, distances.argmin(axis=-1))
        again = spatial.LinearNDInterpolator(spatial.Delaunay(points), values)(queries)
        np.testing.assert_array_equal(again, found)
        of_tuple = spatial.LinearNDInterpolator((points[:, 0], points[:, 1]), values[:, 0] * 1j)
        self.assertEqual(of_tuple(0.5, 0.5).shape, ())
        self.assertEqual(len(of_tuple.tri.simplices), spatial.Delaunay(points).nsimplex)
        if HAS_SCIPY:
            import scipy.interpolate

            for rescale in (False, True):
                arguments = stretched, values, queries * [1, 1000]
                one = spatial.griddata(*arguments, "linear", -1, rescale)
                other = scipy.interpolate.griddata(*arguments, "linear", -1, rescale)
                np.testing.assert_allclose(one, other, atol=1e-9)

    def test_gradients(self):
        points = CLOUDS["plane"]
        x, y = points.T
        values = np.column_stack([x**2 - 3 * x * y, np.sin(3 * x)])
        wanted = np.transpose([[2 * x - 3 * y, -3 * x], [3 * np.cos(3 * x), 0 * x]], (2, 0, 1))
        tri, smooth = spatial.Delaunay(points), spatial.CloughTocher2DInterpolator(points, values)
        found = spatial.estimate_gradients_2d_global(tri, values)
        np.testing.assert_array_equal(found, smooth.grad)
        np.testing.assert_allclose(found[:, 0], wanted[:, 0], atol=1e-9)
        np.testing.assert_allclose(found[:, 1], wanted[:, 1], atol=0.2)
        of_complex = spatial.estimate_gradients_2d_global(tri, values[:, 0] + 1j * values[:, 1])
        np.testing.assert_array_equal(of_complex, found[:, 0] + 1j * found[:, 1])
        twice = spatial.CloughTocher2DInterpolator(np.concatenate([points, points[:5]]), np.append(x, x[:5]))
        np.testing.assert_allclose(twice.grad, np.broadcast_to([[[1.0, 0]]], (305, 1, 2)), atol=1e-12)
        stretched = spatial.CloughTocher2DInterpolator(points * [1, 1000], y, rescale=True)
        np.testing.assert_allclose(stretched.grad[:, 0, 1], np.ptp(y), rtol=1e-12)
        with self.assertRaisesRegex(ValueError, "wrong number of items"):
            spatial.estimate_gradients_2d_global(tri, values[1:])
        if HAS_SCIPY:
            import scipy.interpolate

            for given in (x, values, values.reshape(300, 2, 1), x + 1j):
                one, other = (
                    layer.CloughTocher2DInterpolator(points, given) for layer in (spatial, scipy.interpolate)
                )
                self.assertEqual((one.grad.shape, one.grad.dtype), (other.grad.shape, other.grad.dtype))
                self.assertEqual(spatial.estimate_gradients_2d_global(tri, given).shape, given.shape + (2,))
            of_scipys = spatial.estimate_gradients_2d_global(scipy.spatial.Delaunay(points), values)
            np.testing.assert_array_equal(of_scipys, found)

    @unittest.skipUnless(HAS_SCIPY, "scipy is not installed")
    def test_a_given_triangulation(self):
        import scipy.interpolate
        import scipy.spatial

        grid = np.mgrid[0:5, 0:5].reshape(2, -1).T.astype(float)
        values, queries = RANDOM.random(25), RANDOM.random((50, 2)) * 4
        for given in (spatial.Delaunay(grid), scipy.spatial.Delaunay(grid)):
            theirs = scipy.interpolate.LinearNDInterpolator(given, values) if "scipy" in type(given).__module__ else None
            mine = spatial.LinearNDInterpolator(given, values)
            self.assertIs(mine.tri, given)
            if theirs is not None:
                np.testing.assert_allclose(mine(queries), theirs(queries))
        far = spatial.Delaunay(CLOUDS["plane"], furthest_site=True)
        heights = CLOUDS["plane"] @ [2.0, 3]
        inside = far.points[far.simplices].mean(axis=1)
        np.testing.assert_allclose(spatial.LinearNDInterpolator(far, heights)(inside), inside @ [2.0, 3])

    def test_flat_points(self):
        for kind in (spatial.LinearNDInterpolator, spatial.CloughTocher2DInterpolator):
            with self.assertRaisesRegex(spatial.QhullError, "on a line: 3 points span less"):
                kind([[0, 0], [1, 1], [2, 2]], [0, 1, 2])
            with self.assertRaisesRegex(ValueError, "No points given"):
                kind(np.empty((0, 2)), [])
        self.assertEqual(spatial.NearestNDInterpolator([[0, 0], [1, 1], [2, 2]], [0, 1, 2])([1.2, 1]), 1)

    def test_forms_of_positions(self):
        points, values = CLOUDS["plane"], np.arange(300)
        for kind in (spatial.LinearNDInterpolator, spatial.CloughTocher2DInterpolator, spatial.NearestNDInterpolator):
            surface = kind(points, values)
            grid = np.mgrid[0.2:0.8:4j, 0.3:0.7:3j]
            found = surface(np.moveaxis(grid, 0, -1))
            self.assertEqual((found.shape, found.dtype), ((4, 3), float))
            np.testing.assert_array_equal(surface(*grid), found)
            np.testing.assert_array_equal(surface(tuple(grid)), found)
            np.testing.assert_array_equal(surface(grid[0][:, :1], grid[1][:1]), found)
            self.assertEqual(surface((0.2, 0.3)), found[0, 0])
            for one, shape in (((0.2, 0.3), ()), ([0.2, 0.3], (1,)), ([0.2, 0.3, 0.2, 0.7], (2,))):
                self.assertEqual(surface(one).shape, shape)
            for wrong in (grid, tuple([*grid, grid[0]]), [0.2, 0.3, 0.4], 0.2):
                with self.assertRaisesRegex(ValueError, "dimensions in xi"):
                    surface(wrong)
        near = surface(points + [0.001, 0], distance_upper_bound=0.002, workers=2)
        np.testing.assert_array_equal(near[near == near], surface(points + [0.001, 0])[near == near])
        self.assertTrue(np.isnan(surface([[5, 5]], distance_upper_bound=1)).all())
        with self.assertRaisesRegex(NotImplementedError, "Euclid"):
            surface([[5, 5]], p=1)

    def test_bad_input(self):
        with self.assertRaisesRegex(ValueError, "different number of values and points"):
            spatial.LinearNDInterpolator(SQUARE, [1, 2])
        with self.assertRaisesRegex(ValueError, "different number of values and points"):
            spatial.LinearNDInterpolator(SQUARE, 3)
        with self.assertRaisesRegex(TypeError, "not complex"):
            spatial.LinearNDInterpolator(SQUARE * 1j, range(4))
        with self.assertRaisesRegex(NotImplementedError, r"n by 2 here, not of shape \(300, 3\): take scipy.interpolate"):
            spatial.LinearNDInterpolator(CLOUDS["space"], np.arange(300))
        with self.assertRaisesRegex(ValueError, "points in the plane"):
            spatial.CloughTocher2DInterpolator(CLOUDS["space"], np.arange(300))
        with self.assertRaisesRegex(ValueError, "Rescaling is not supported when passing a Delaunay triangulation"):
            spatial.LinearNDInterpolator(spatial.Delaunay(SQUARE), range(4), rescale=True)
        with self.assertRaisesRegex(ValueError, "dimensions in xi"):
            spatial.NearestNDInterpolator(SQUARE, range(4))(np.zeros((2, 3)))
        with self.assertRaisesRegex(ValueError, "Unknown interpolation method 'spline'"):
            spatial.griddata(SQUARE, range(4), SQUARE, "spline")


def _sides(points, simplices, at):
    """For each facet on which side of its plane the position is: 1 outside; as determinants of fractions."""
    found = []
    for facet in points[simplices]:
        arms = [[Fraction(x) - Fraction(y) for x, y in zip(corner, at)] for corner in facet.tolist()]
        value = 0
        for order in itertools.permutations(range(len(arms))):
            term = (-1) ** sum(i > j for i, j in itertools.combinations(order, 2))
            for row, column in enumerate(order):
                term *= arms[row][column]
            value -= term
        found.append((value > 0) - (value < 0))
    return found


def _empty_circles(points):
    """The centers, as pairs of fractions, of circles through three points without one inside; and these rounded."""
    rows = [tuple(map(Fraction, row)) for row in points.tolist()]
    found = {}
    for a, b, c in itertools.combinations(rows, 3):
        u, v = ((b[0] - a[0], b[1] - a[1]), (c[0] - a[0], c[1] - a[1]))
        cross = 2 * (u[0] * v[1] - u[1] * v[0])
        if cross == 0:
            continue
        p, q = u[0] ** 2 + u[1] ** 2, v[0] ** 2 + v[1] ** 2
        center = a[0] + (p * v[1] - q * u[1]) / cross, a[1] + (q * u[0] - p * v[0]) / cross
        radius = (center[0] - a[0]) ** 2 + (center[1] - a[1]) ** 2
        if all((center[0] - x) ** 2 + (center[1] - y) ** 2 >= radius for x, y in rows):
            found[center] = tuple(map(float, center))
    return found


if __name__ == "__main__":
    unittest.main()
