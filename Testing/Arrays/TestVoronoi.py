# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Diagrams of vtkflipflop.arrays, unbounded and cut: sides, rays, vertices and cells are those of rationals."""

import itertools
import os
import unittest
from fractions import Fraction

import numpy as np
from vtkflipflop.arrays import InputError, power_diagram, regular_triangulation, voronoi_diagram

CASES = int(os.environ.get("FLIPFLOP_TEST_CASES", 150))
RANDOM = np.random.default_rng(5)
SQUARE = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])


def random_set(seed, scales):
    """Few points of a small grid, so that many are on one circle or line; in every other set with weights."""
    random = np.random.default_rng(seed)
    size = random.integers(1, 9)
    points = random.permuted(np.unique(random.integers(0, [5, random.choice([1, 2, 5])], (size, 2)), axis=0), axis=0)
    scale = random.choice(scales)
    weights = random.integers(-3, 4, len(points)) * scale**2 if seed % 2 else None
    return points * scale, weights


def perpendicular(a, b):
    return b[1] - a[1], a[0] - b[0]


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def as_floats(position):
    return tuple(map(float, position))


class Exact:
    """The diagram of a few points in rationals, by all pairs of sites that have a cell."""

    def __init__(self, points, weights, sites):
        self.points = [tuple(map(Fraction, row)) for row in points.tolist()]
        self.weights = [Fraction(0)] * len(points) if weights is None else [Fraction(w) for w in weights.tolist()]
        self.sites = sites
        self.lines, self.ridges, self.rays = {}, {}, {}
        for pair in itertools.combinations(sites, 2):
            self.add(*pair)

    def add(self, i, j):
        """The part of the line of equal power to two sites where none is nearer."""
        a, b = self.points[i], self.points[j]
        step, (u, v) = perpendicular(a, b), (b[0] - a[0], b[1] - a[1])
        square = u * u + v * v
        share = (square + self.weights[i] - self.weights[j]) / (2 * square)
        foot = a[0] + share * u, a[1] + share * v
        low, high = None, None
        for k in set(self.sites) - {i, j}:
            # To the site k it is farther than to i: slope * t >= least.
            c = self.points[k]
            slope = 2 * (step[0] * (a[0] - c[0]) + step[1] * (a[1] - c[1]))
            least = self.power(foot, i) - self.power(foot, k)
            if slope == 0 and least > 0:
                return
            if slope > 0:
                low = least / slope if low is None else max(low, least / slope)
            if slope < 0:
                high = least / slope if high is None else min(high, least / slope)
        if low is not None and high is not None and low >= high:
            return
        self.lines[i, j] = foot, step, low, high
        ends = [None if t is None else (foot[0] + t * step[0], foot[1] + t * step[1]) for t in (low, high)]
        self.ridges[i, j] = ends
        start = next((end for end in ends if end is not None), foot)
        directions = [step] * (high is None) + [(-step[0], -step[1])] * (low is None)
        self.rays[i, j] = [(as_floats(start), as_floats(direction)) for direction in directions]

    def power(self, x, k):
        return (x[0] - self.points[k][0]) ** 2 + (x[1] - self.points[k][1]) ** 2 - self.weights[k]


def cut_at(box, foot, step, low, high):
    """The ends of the part of a line, foot + t * step for t from low to high, within a box; None: nothing."""
    for x, d, least, most in zip(foot, step, box[::2], box[1::2]):
        if d == 0 and not least < x < most:
            return None
        if d != 0:
            one, other = sorted([(least - x) / d, (most - x) / d])
            low = one if low is None else max(low, one)
            high = other if high is None else min(high, other)
    return None if low >= high else [(foot[0] + t * step[0], foot[1] + t * step[1]) for t in (low, high)]


class TestDiagrams(unittest.TestCase):
    def test_by_rationals(self):
        for seed in range(CASES):
            points, weights = random_set(seed, [1.0, 0.1, 1e-100, 2.0**300])
            with self.subTest(seed=seed):
                self.check(points, weights)

    def check(self, points, weights):
        facets = ("triangles", "polygons")[len(points) % 2]
        triangulation = regular_triangulation(points, weights, facets=facets)
        diagram = triangulation.voronoi_diagram()
        exact = Exact(points, weights, diagram.sites.tolist())
        pairs = list(map(tuple, diagram.ridge_points.tolist()))
        self.assertEqual(len(set(pairs)), len(pairs))
        self.assertEqual(set(pairs), set(exact.ridges))
        position_of = {}
        for pair, ends in zip(pairs, diagram.ridge_vertices.tolist()):
            low, high = exact.ridges[pair]
            self.assertEqual(ends[0] < 0, low is None or high is None)
            # On the right first; a ray's start is last.
            own = [end for end in (high, low) if end is not None]
            self.assertEqual([as_floats(end) for end in own], [as_floats(diagram.vertices[k]) for k in ends if k >= 0])
            position_of.update(zip([k for k in ends if k >= 0], own))
        self.assertEqual(len(position_of), len(diagram.vertices))
        self.assertEqual(len(set(position_of.values())), len(diagram.vertices))
        found = {pair: [] for pair in pairs}
        for ridge, start, direction in zip(*diagram.rays):
            found[pairs[ridge]].append((as_floats(start), as_floats(direction)))
        self.assertEqual({p: sorted(r) for p, r in found.items()}, {p: sorted(r) for p, r in exact.rays.items()})
        if triangulation.dimension == 2:
            for row, site in enumerate(diagram.sites.tolist()):
                self.check_cell(diagram, exact, position_of, row, site)

    def check_cell(self, diagram, exact, position_of, row, site):
        """Sides follow each other, with the neighbours on the right."""
        own = exact.points[site]
        sides, rays = {}, []
        for pair, (first, second) in zip(diagram.ridge_points.tolist(), diagram.ridge_vertices.tolist()):
            if site in pair:
                other = exact.points[sum(pair) - site]
                away = other[0] - own[0], other[1] - own[1]
                if first >= 0:
                    sides[first, second] = sides[second, first] = away
                else:
                    ends = exact.ridges[tuple(pair)]
                    onward = perpendicular(exact.points[pair[0]], exact.points[pair[1]])
                    rays.append((second, onward if ends[1] is None else (-onward[0], -onward[1]), away))
        ring = diagram.cells[row].tolist()
        self.assertEqual(diagram.is_open[row], bool(rays))
        self.assertEqual(len(rays), 2 * diagram.is_open[row])
        steps = list(zip(ring, ring[1:] if rays else ring[1:] + ring[:1]))
        self.assertEqual(2 * len(steps), len(sides))
        for i, j in steps:
            (x0, y0), (x1, y1) = position_of[i], position_of[j]
            self.assertLess(cross((x1 - x0, y1 - y0), sides[i, j]), 0)
        if rays:
            outward = [cross(direction, away) < 0 for _, direction, away in rays]
            self.assertEqual(sorted(outward), [False, True])
            self.assertEqual(rays[outward.index(True)][0], ring[-1])
            self.assertEqual(rays[outward.index(False)][0], ring[0])

    def test_cells_are_those_in_a_large_box(self):
        for seed in range(CASES):
            points, weights = random_set(seed, [1.0, 2.0**300])
            diagram = voronoi_diagram(points, weights)
            reach = 10 * max(np.abs(diagram.vertices).max(initial=0), np.abs(points).max(), 1)
            boxed = power_diagram(points, weights, (-reach, reach, -reach, reach))
            with self.subTest(seed=seed):
                np.testing.assert_array_equal(boxed.sites, diagram.sites)
                for row, corners in enumerate(boxed.regions):
                    ring = list(map(tuple, boxed.vertices[corners].tolist()))
                    is_outer = [max(map(abs, corner)) == reach for corner in ring]
                    self.assertEqual(any(is_outer), diagram.is_open[row])
                    inner = [corner for corner, outer in zip(ring, is_outer) if not outer]
                    own = list(map(tuple, diagram.vertices[diagram.cells[row]].tolist()))
                    self.assertEqual(set(own), set(inner))
                    if own:
                        at = inner.index(own[0])
                        self.assertEqual(own, inner[at:] + inner[:at])

    def test_rays_end_at_the_box(self):
        points = RANDOM.random((200, 2))
        diagram = voronoi_diagram(points)
        reach = 10 * np.abs(diagram.vertices).max()
        boxed = power_diagram(points, domain=(-reach, reach, -reach, reach))
        outer = boxed.vertices[(np.abs(boxed.vertices) == reach).any(axis=1)]
        ridges, starts, directions = diagram.rays
        self.assertEqual(len(ridges), len(regular_triangulation(points).convex_hull))
        for start, direction in zip(starts, directions):
            steps = outer - start
            angles = np.abs(np.arctan2(cross(direction, steps.T), steps @ direction))
            self.assertLess(angles.min(), 1e-9)

    def test_hidden_points(self):
        points = np.concatenate([SQUARE, [[0.5, 0.25]], SQUARE[1:3], [[np.nan, 0]]])
        diagram = voronoi_diagram(points, [0, 0, 0, 0, -9, 0, -1, 0], non_finite="ignore")
        self.assertEqual(diagram.sites.tolist(), [0, 1, 2, 3])
        self.assertEqual(diagram.cell_of.tolist(), [0, 1, 2, 3, 0, 1, 2, -1])
        self.assertEqual(diagram.vertices.tolist(), [[0.5, 0.5]])
        self.assertEqual((len(diagram), diagram.is_open.all()), (4, True))
        self.assertEqual([cell.tolist() for cell in diagram.cells], 4 * [[0]])

    def test_every_dimension(self):
        for points, counts in (([], (0, 0, 0)), ([[1, 2]], (1, 0, 0)), ([[1, 2], [1, 2], [2, 4], [0, 0]], (3, 2, 4))):
            diagram = voronoi_diagram(np.reshape(points, (-1, 2)))
            self.assertEqual((len(diagram), len(diagram.ridge_points), len(diagram.rays.ridges)), counts)
            self.assertEqual([cell.tolist() for cell in diagram.cells], [[]] * counts[0])
            self.assertTrue(diagram.is_open.all())
        self.assertEqual(diagram.ridge_points.tolist(), [[0, 2], [0, 3]])
        self.assertEqual(diagram.rays.starts.tolist(), [[1.5, 3], [1.5, 3], [0.5, 1], [0.5, 1]])

    def test_any_magnitude(self):
        far = 1.7e308
        for points in ([[-far, -far], [far, -far], [0, far]], [[-far, 1], [far, 2]]):
            rays = voronoi_diagram(points).rays
            self.assertTrue(np.isfinite(rays.directions).all())
            self.assertTrue((np.abs(rays.directions).max(axis=1) > 1e307).all())
        # Beyond the doubles: of points with weights, and of three nearly on a line.
        self.assertEqual(voronoi_diagram([[0, 0], [1e-200, 0]], [0.0, 1e200]).rays.starts[0].tolist(), [-np.inf, 0])
        self.assertEqual(voronoi_diagram([[-1e200, 0], [0, 1e-200], [1e200, 0]]).vertices.tolist(), [[0, -np.inf]])

    def test_points_in_space_count_by_x_and_y(self):
        points = RANDOM.random((50, 3)).astype(np.float32)
        one, other = voronoi_diagram(points), voronoi_diagram(points[:, :2].astype(float))
        np.testing.assert_array_equal(one.vertices, other.vertices)
        np.testing.assert_array_equal(one.rays.directions, other.rays.directions)

    def test_bad_input(self):
        with self.assertRaisesRegex(InputError, "first at point 1"):
            voronoi_diagram([[0, 0], [np.nan, 0]])
        with self.assertRaisesRegex(TypeError, "no Voronoi diagram"):
            regular_triangulation(SQUARE, constraints=[[0, 1]]).voronoi_diagram()
        points = RANDOM.random((50, 2))
        diagram = regular_triangulation(points).voronoi_diagram()
        points[:25] = 0
        with self.assertRaisesRegex(InputError, "points have changed"):
            diagram.cells  # noqa: B018


class TestCutDiagrams(unittest.TestCase):
    def test_sides_are_those_of_rationals(self):
        for seed in range(CASES):
            points, weights = random_set(seed, [1.0, 2.0**-300])
            random = np.random.default_rng(seed)
            scale = 1.0 if points.max(initial=0) >= 0.5 else 2.0**-300
            x, y = np.sort(random.integers(-8, 48, (2, 2)), axis=1) / 8
            box = np.array([x[0], x[1] + 1, y[0], y[1] + 1]) * scale
            with self.subTest(seed=seed):
                diagram = power_diagram(points, weights, box)
                exact = Exact(points, weights, regular_triangulation(points, weights).vertices.tolist())
                wanted = {}
                for pair, line in exact.lines.items():
                    ends = cut_at([*map(Fraction, box.tolist())], *line)
                    if ends:
                        wanted[pair] = as_floats(ends[1]), as_floats(ends[0])
                pairs = list(map(tuple, diagram.ridge_points.tolist()))
                self.assertEqual(pairs, sorted(wanted))
                for pair, ends in zip(pairs, diagram.vertices[diagram.ridge_vertices]):
                    self.assertEqual(tuple(map(tuple, ends.tolist())), wanted[pair])
                self.check_lengths(diagram)

    def check_lengths(self, diagram):
        """Sides sum to perimeters; they and the border's are all sides, and neighbours those that share one."""
        perimeters, sides = np.zeros(len(diagram)), {}
        for row, cell in enumerate(diagram.cells):
            corners = diagram.vertices[cell]
            perimeters[row] = np.linalg.norm(corners - np.roll(corners, -1, axis=0), axis=1).sum()
            for i, j in zip(cell.tolist(), np.roll(cell, -1).tolist()):
                sides[i, j] = row
        rows = np.searchsorted(diagram.sites, diagram.ridge_points)
        own = np.searchsorted(diagram.sites, diagram.border_points)
        sums = np.bincount(own, diagram.border_lengths, len(diagram))
        for column in rows.T:
            sums += np.bincount(column, diagram.ridge_lengths, len(diagram))
        np.testing.assert_allclose(sums, perimeters)
        # By a table of all sides.
        common = {(row, sides[j, i], i, j) for (i, j), row in sides.items() if row < sides.get((j, i), -1)}
        self.assertEqual(set(zip(*rows.T.tolist(), *diagram.ridge_vertices.T.tolist())), common)
        border = {(row, i, j) for (i, j), row in sides.items() if (j, i) not in sides}
        self.assertEqual(set(zip(own.tolist(), *diagram.border_vertices.T.tolist())), border)
        first, others = diagram.neighbors
        found = [set(others[begin:end].tolist()) for begin, end in zip(first, first[1:])]
        wanted = [{a + b - row for a, b, *_ in common if row in (a, b)} for row in range(len(diagram))]
        self.assertEqual(found, wanted)
        self.assertEqual(len(others), sum(map(len, wanted)))

    def test_in_a_polygon(self):
        points, weights = RANDOM.random((400, 2)), RANDOM.random(400) * 0.005
        for domain in (None, [[0.2, 0.1], [0.9, 0.3], [0.7, 0.8], [0.1, 0.7]]):
            diagram = power_diagram(points, weights, domain)
            self.check_lengths(diagram)
            self.assertTrue((np.diff(diagram.ridge_points[:, 0]) >= 0).all())
        steps = np.roll(domain, -1, axis=0) - domain
        self.assertAlmostEqual(diagram.border_lengths.sum(), np.hypot(*steps.T).sum())
        # Where rounding has bent sides, two cells have several.
        random = np.random.default_rng(268)
        angles, radii = random.random(60) * 6.28, random.choice([1, 1, 3.3], 60)
        around = np.column_stack([np.cos(angles), np.sin(angles)]) * radii[:, None] + random.choice([0, 1.1])
        self.check_lengths(power_diagram(around, domain=(-5, 5, -5, 5)))

    def test_nothing(self):
        for points, borders in (([], 0), ([[1, 2]], 4)):
            diagram = power_diagram(np.reshape(points, (-1, 2)), domain=(0, 1, 0, 1))
            self.assertEqual((len(diagram.ridge_points), len(diagram.border_points)), (0, borders))
            self.assertEqual([part.tolist() for part in diagram.neighbors], [[0] * (len(points) + 1), []])


if __name__ == "__main__":
    unittest.main()
