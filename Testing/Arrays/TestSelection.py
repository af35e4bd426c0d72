# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.arrays: some cells of a triangulation: where they are, values in them, and their region as polygons."""

import importlib.util
import unittest
from collections import Counter

import numpy as np

from vtkflipflop.arrays import (
    CellSelection,
    InputError,
    alpha_complex,
    constrained_triangulation,
    regular_triangulation,
)

RANDOM = np.random.default_rng(41)
# Of whole numbers, so that what follows is exact in int64: also many points on lines and circles.
POINTS = np.unique(RANDOM.integers(0, 24, (120, 2)), axis=0)
WEIGHTS = RANDOM.integers(0, 12, len(POINTS)).astype(float)
POSITIONS = np.concatenate([POINTS, RANDOM.integers(-1, 50, (400, 2)) / 2])
VALUES = RANDOM.random(len(POINTS))
METHODS = "linear", "natural", "laplace", "clough-tocher"
HAS_SHAPELY = importlib.util.find_spec("shapely") is not None


def doubled_area(a, b, c):
    return (b - a)[..., 0] * (c - a)[..., 1] - (b - a)[..., 1] * (c - a)[..., 0]


def located(cells, positions):
    """For each position the first triangle that holds it; in whole numbers."""
    corners = (2 * cells.points[cells.simplices, :2]).astype(int)
    twice = (2 * positions).astype(int)[:, None]
    held = np.all([doubled_area(corners[:, i], corners[:, i - 2], twice) >= 0 for i in range(3)], axis=0)
    return np.where(held.any(axis=1), np.append(held, ~held.any(axis=1)[:, None], axis=1).argmax(axis=1), -1)


def made():
    """Triangulations of all kinds."""
    chains = {"constraints": [[3, 90], [40, 41]]}
    for facets in ("triangles", "polygons"):
        yield regular_triangulation(POINTS, facets=facets)
        yield regular_triangulation(POINTS, WEIGHTS, facets=facets)
        yield regular_triangulation(POINTS, **chains, facets=facets)
    ring = np.array([[2, 2], [20, 3], [18, 19], [3, 21], [9, 9], [2, 2]])
    yield constrained_triangulation(POINTS, [ring, np.array([[30, 30], [31, 30.5]])], closed_lines_as_borders=True)


class TestSelections(unittest.TestCase):
    def test_queries_see_these_cells_alone(self):
        for whole in made():
            for within in (
                whole.within_edge_length(3.0),
                whole.alphas <= np.median(whole.alphas),
                np.arange(whole.nsimplex) % 3 > 0,
                np.zeros(whole.nsimplex, bool),
                np.ones(whole.nsimplex, bool),
            ):
                with self.subTest(whole=repr(whole), kept=int(within.sum())):
                    some = whole.with_cells(within)
                    self.check(whole, some, within)

    def check(self, whole, some, within):
        self.assertIs(type(some), CellSelection)
        np.testing.assert_array_equal(some.simplices, whole.simplices[within])
        np.testing.assert_array_equal(some.areas, whole.areas[within])
        np.testing.assert_array_equal(some.vertices, np.unique(some.simplices))
        found, values = located(some, POSITIONS), np.resize(VALUES, whole.npoints)
        np.testing.assert_array_equal(some.locate(POSITIONS), found)
        np.testing.assert_array_equal(some.find_simplex(POSITIONS.reshape(-1, 2, 2)), found.reshape(-1, 2))
        for method in ("linear", "clough-tocher") if hasattr(whole, "fixed_edges") else METHODS:
            ours = some.interpolate(values, POSITIONS, method, fill_value=-7)
            theirs = whole.interpolate(values, POSITIONS, method)
            np.testing.assert_array_equal(ours, np.where(found < 0, -7, theirs))
            both = some.interpolate(np.column_stack([values, -values]), POSITIONS[:9], method)
            np.testing.assert_array_equal(both[:, 0], np.where(found[:9] < 0, np.nan, ours[:9]))
            np.testing.assert_array_equal(both[:, 1], -both[:, 0])
            image = some.to_image(values, shape=(8, 6), bounds=(0, 24, 0, 24), method=method, fill_value=-7)
            pixels = np.stack(np.meshgrid(image.x, image.y), axis=-1)
            np.testing.assert_array_equal(
                image.array, some.interpolate(values, pixels, method, fill_value=-7), strict=True
            )

    def test_a_border_of_a_long_triangle_is_the_short_one_s(self):
        points = np.array([[0, 0], [1, 0], [0, 1], [9, 1]])
        whole = regular_triangulation(points)
        some = whole.with_cells(whole.within_edge_length(1.5))
        self.assertEqual((whole.nsimplex, some.nsimplex), (2, 1))
        on = [[0.5, 0.5], [1, 0], [0, 1]]
        np.testing.assert_array_equal(some.locate(on), [0, 0, 0])
        for method in METHODS:
            np.testing.assert_allclose(some.interpolate(points.sum(axis=1), on, method), [1, 1, 1])
            self.assertTrue(np.isnan(some.interpolate(points[:, 0], [0.5001, 0.5], method)))

    def test_images_of_all_forms(self):
        whole = regular_triangulation(POINTS)
        some = whole.with_cells(whole.within_edge_length(3))
        for method in METHODS:
            single = some.to_image(VALUES.astype(np.float32), spacing=3, method=method)
            self.assertEqual(single.array.dtype, np.float32)
            pair = some.to_image(np.column_stack([VALUES, VALUES]), spacing=3, method=method, dtype=np.float32)
            np.testing.assert_array_equal(pair.array[..., 1], pair.array[..., 0])
            self.assertEqual((pair.array.shape[2], single.transform), (2, pair.transform))
            self.assertFalse(single.array.flags.writeable)
        self.assertIsInstance(some.interpolate(VALUES, [3, 3], "natural"), np.float64)
        with self.assertRaisesRegex(InputError, "an image of no point: give bounds"):
            whole.with_cells(np.zeros(whole.nsimplex, bool)).to_image(VALUES, spacing=1)

    def test_cells_of_cells_and_of_complexes(self):
        whole = regular_triangulation(POINTS)
        some = whole.with_cells(whole.within_edge_length(4))
        fewer = some.with_cells(some.within_edge_length(3))
        plain = whole.with_cells(whole.within_edge_length(3))
        for name in ("locate", "find_simplex"):
            np.testing.assert_array_equal(getattr(fewer, name)(POSITIONS), getattr(plain, name)(POSITIONS))
        np.testing.assert_array_equal(
            fewer.interpolate(VALUES, POSITIONS, "natural"), plain.interpolate(VALUES, POSITIONS, "natural")
        )
        shape = whole.alpha_complex(2)
        np.testing.assert_array_equal(shape.cells.simplices, shape.simplices)
        np.testing.assert_array_equal(shape.cells.locate(POSITIONS), located(shape.cells, POSITIONS))

    def test_every_dimension(self):
        line = np.array([[0, 0], [1, 0], [3, 0], [4, 0]])
        for points in (line, line[:1], line[:0]):
            whole = regular_triangulation(points)
            every = whole.with_cells(np.ones(whole.nsimplex, bool))
            np.testing.assert_array_equal(every.locate(POSITIONS), whole.locate(POSITIONS))
            np.testing.assert_array_equal(every.simplices, whole.simplices)
            self.assertEqual(every.__geo_interface__["coordinates"], [])
        none = regular_triangulation(line[:1]).with_cells([False])
        self.assertEqual((none.nsimplex, none.locate(line[0])), (0, -1))
        for method in METHODS:
            self.assertTrue(np.isnan(none.interpolate([1.0], line[0], method)))

    def test_segments_of_a_line(self):
        along = np.array([4, 0, 1, 3, 8])
        weights = [0, 0.5, 0, 0, 0.25]
        halves = np.arange(-2, 20) / 2
        for step in ([1, 0], [1, 2], [0, -3]):
            points, positions = np.outer(along, step), np.outer(halves, step)
            for whole in (
                regular_triangulation(points),
                regular_triangulation(points, weights, facets="polygons"),
                regular_triangulation(points, constraints=[[1, 0]]),
            ):
                methods = ("linear", "clough-tocher") if hasattr(whole, "fixed_edges") else METHODS
                self.assertEqual((whole.dimension, whole.nsimplex), (1, 4))
                for number in range(2**whole.nsimplex):
                    within = number >> np.arange(whole.nsimplex) & 1 > 0
                    some = whole.with_cells(within)
                    ends = np.sort(along[some.simplices], axis=1)
                    holding = [[i for i, (a, b) in enumerate(ends) if a <= at <= b] for at in halves]
                    rows = np.array([min(found, default=-1) for found in holding])
                    np.testing.assert_array_equal(some.locate(positions), rows)
                    for method in methods:
                        values = np.where(rows < 0, -7, 3 * halves - 1)
                        ours = some.interpolate(3.0 * along - 1, positions, method, fill_value=-7)
                        np.testing.assert_allclose(ours, values, rtol=1e-14)
                    image = some.to_image(VALUES[:5], shape=(3, 9), bounds=(-1, 8, -9, 9), method=method)
                    pixels = np.stack(np.meshgrid(image.x, image.y), axis=-1)
                    np.testing.assert_array_equal(image.array, some.interpolate(VALUES[:5], pixels, method))

    def test_what_within_may_be(self):
        whole = regular_triangulation(POINTS)
        within = whole.within_edge_length(3)
        np.testing.assert_array_equal(whole.with_cells(within.tolist()).simplices, whole.with_cells(within).simplices)
        for wrong, error, sentence in (
            (within[1:], ValueError, f"within is an array of {whole.nsimplex} truths, one for each cell, not of shape"),
            (np.flatnonzero(within), TypeError, "within is an array of bool, not of type int64"),
            (np.ma.array(within, mask=within), InputError, "within: entry .* is masked"),
            (0.5, TypeError, "within are an array or a list"),
        ):
            with self.assertRaisesRegex(error, sentence):
                whole.with_cells(wrong)
        given = within.copy()
        some = whole.with_cells(given)
        given[:] = False
        self.assertGreater(some.within.sum(), 0)
        with self.assertRaisesRegex(InputError, "natural neighbours are those of a regular triangulation"):
            constrained = regular_triangulation(POINTS, constraints=[])
            constrained.with_cells(constrained.within_edge_length(3)).to_image(VALUES, spacing=3, method="natural")
        with self.assertRaisesRegex(InputError, "natural neighbours are those of a regular triangulation"):
            constrained.with_cells(constrained.within_edge_length(3)).interpolate(VALUES, POSITIONS, "laplace")


def doubled_area_of(ring):
    x, y = np.array(ring)[:, :2].T.astype(int)
    return int((x[:-1] * y[1:] - x[1:] * y[:-1]).sum())


class TestRegions(unittest.TestCase):
    """A region is a valid MultiPolygon; of points of whole numbers, so areas are exact."""

    def regions(self):
        for whole in (regular_triangulation(POINTS), regular_triangulation(POINTS, WEIGHTS, facets="polygons")):
            yield whole, whole
            for limit in (2, 2.5, 3, 4, 6):
                yield whole.with_cells(whole.within_edge_length(limit)), whole
            for divisor in (2, 3, 7):  # many parts and holes that touch at points
                some = whole.with_cells(np.arange(whole.nsimplex) * 7919 % 31 % divisor > 0)
                yield some, whole
            for alpha in (0.5, 1.5, 2, 3):
                shape = whole.alpha_complex(alpha)
                yield shape, whole
                self.assertEqual(shape.__geo_interface__, shape.cells.__geo_interface__)

    def test_rings_are_those_of_valid_polygons(self):
        touching = holes = 0
        for cells, whole in self.regions():
            given = cells.__geo_interface__
            self.assertEqual(given["type"], "MultiPolygon")
            areas = [doubled_area_of(ring) for polygon in given["coordinates"] for ring in polygon]
            self.assertEqual(sum(areas), doubled_area(*whole.points[cells.simplices].transpose(1, 0, 2)).sum())
            sides = Counter()
            for polygon in given["coordinates"]:
                self.assertEqual([doubled_area_of(ring) > 0 for ring in polygon], [True] + [False] * (len(polygon) - 1))
                at = {}
                for number, ring in enumerate(polygon):
                    self.assertEqual(ring[0], ring[-1])
                    self.assertEqual(len(set(ring)), len(ring) - 1)
                    sides.update(map(frozenset, zip(ring, ring[1:])))
                    for corner in ring[1:]:
                        at.setdefault(corner, set()).add(number)
                # Rings that touch in a circle would part the inside.
                parent = {}

                def root(node):
                    while parent.get(node, node) != node:
                        node = parent[node]
                    return node

                for corner, numbers in at.items():
                    for number in numbers if len(numbers) > 1 else ():
                        self.assertNotEqual(root(number), root(corner))
                        parent[root(number)] = root(corner)
                        touching += 1
                holes += len(polygon) - 1
            # Each side has the cells on one side of it alone.
            edges = Counter(frozenset(map(tuple, whole.points[cells.simplices[:, [i, i - 1]]][row].tolist()))
                            for i in range(3) for row in range(len(cells.simplices)))  # fmt: skip
            self.assertEqual(set(sides), {edge for edge, count in edges.items() if count == 1})
            self.assertEqual(set(sides.values()) - {1}, set())
        self.assertGreater(touching, 20)
        self.assertGreater(holes, 20)

    @unittest.skipUnless(HAS_SHAPELY, "no shapely")
    def test_shapely_takes_them(self):
        import shapely

        for cells, whole in self.regions():
            shape = shapely.geometry.shape(cells)
            self.assertTrue(shape.is_valid, shapely.is_valid_reason(shape))
            triangles = shapely.polygons(whole.points[cells.simplices])
            self.assertEqual(shape.area, shapely.area(triangles).sum())
            self.assertTrue(shape.equals(shapely.unary_union(triangles)))

    def test_heights_stay_and_regions_are_borders(self):
        points = np.column_stack([POINTS, np.arange(len(POINTS))])
        shape = alpha_complex(points, 2.5)
        self.assertEqual({len(corner) for part in shape.__geo_interface__["coordinates"] for corner in part[0]}, {3})
        inside = constrained_triangulation([], alpha_complex(POINTS, 2.5))
        self.assertEqual(inside.areas.sum(), shape.cells.areas.sum())
        self.assertEqual(alpha_complex(POINTS, 0).__geo_interface__["coordinates"], [])


if __name__ == "__main__":
    unittest.main()
