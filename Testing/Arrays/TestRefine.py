# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Refined meshes of arrays: shapes, areas and angles, and a small finite element problem that they serve."""

import unittest
import warnings

import numpy as np
from vtkflipflop.arrays import Image, InputError, refined_mesh, regular_triangulation

SQUARE = [[0.0, 0], [1, 0], [1, 1], [0, 1]]
RING = [[0, 1, 2, 3]]


class TestRefine(unittest.TestCase):
    def check(self, mesh, angle):
        self.assertTrue(mesh.is_complete)
        self.assertEqual((mesh.kept_segments, mesh.kept_triangles), (0, 0))
        self.assertGreater(mesh.angles.min(), angle - 1e-9)
        self.assertGreater(mesh.areas.min(), 0)
        whole = regular_triangulation(mesh.points, constraints=mesh.segments)
        np.testing.assert_array_equal(whole.fixed_edges, mesh.segments)
        rows = set(map(tuple, whole.simplices))
        self.assertTrue(all(tuple(row) in rows for row in mesh.simplices))

    def test_square(self):
        for angle, area in ((20, None), (30, 0.01), (0, 0.001)):
            with self.subTest(angle=angle, area=area):
                mesh = refined_mesh(SQUARE, polygons=RING, minimum_angle=angle, maximum_area=area)
                self.check(mesh, angle)
                self.assertAlmostEqual(mesh.areas.sum(), 1, delta=1e-13)
                self.assertLessEqual(mesh.areas.max(), area or 1)
                self.assertEqual(mesh.new_points, len(mesh.points) - 4)
                np.testing.assert_array_equal(mesh.points[:4], SQUARE)
                on = mesh.points[4:][mesh.constraint_of_point >= 0]
                self.assertTrue(((on == 0) | (on == 1)).any(axis=1).all())

    def test_neighbors(self):
        mesh = refined_mesh(SQUARE, polygons=RING, maximum_area=0.01)
        for row, others in enumerate(mesh.neighbors):
            for corner, other in enumerate(others):
                edge = set(np.delete(mesh.simplices[row], corner))
                if other < 0:
                    self.assertIn(tuple(sorted(edge)), set(map(tuple, mesh.segments)))
                else:
                    self.assertTrue(edge <= set(mesh.simplices[other]))

    def test_regions_and_holes(self):
        points = [*SQUARE, [0.5, 0], [0.5, 1], [0.7, 0.4], [0.9, 0.4], [0.8, 0.6]]
        mesh = refined_mesh(
            points,
            constraints=[[4, 5], [6, 7], [7, 8], [8, 6]],
            polygons=RING,
            regions=[[0.1, 0.1, 0.001], [0.9, 0.9, 0]],
            holes=[[0.8, 0.5]],
            maximum_area=0.05,
        )
        self.check(mesh, 25)
        self.assertAlmostEqual(mesh.areas.sum(), 1 - 0.02, delta=1e-13)
        left = mesh.points[mesh.simplices].mean(axis=1)[:, 0] < 0.5
        np.testing.assert_array_equal(mesh.region_of, np.where(left, 0, 1))
        self.assertLessEqual(mesh.areas[left].max(), 0.001)
        self.assertGreater(mesh.areas[~left].max(), 0.001)

    def test_lines(self):
        polygon = {
            "type": "Polygon",
            "coordinates": [
                [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]],
                [[1, 1], [3, 1], [3, 3], [1, 3], [1, 1]],
            ],
        }
        across = {"type": "LineString", "coordinates": [[-1, 0.5], [5, 0.75]]}
        mesh = refined_mesh([], lines=[polygon, across], minimum_angle=28)
        self.check(mesh, 28)
        self.assertAlmostEqual(mesh.areas.sum(), 12, delta=1e-12)

    def test_geometries_of_too_few_points(self):
        """They are left out and counted, also as regions, whose numbers stay."""
        square = _polygon([[0, 0], [4, 0], [4, 4], [0, 4]])
        nothing = {"type": "Polygon", "coordinates": ()}
        inner, two = _polygon([[1, 1], [2, 1], [2, 2], [1, 2]]), _polygon([[1, 1], [2, 2]])
        mesh = refined_mesh([], lines=[square, nothing, two], regions=[nothing, (two, 1), inner], degenerate="ignore")
        self.assertEqual(mesh.degenerate, 4)
        self.assertAlmostEqual(mesh.areas.sum(), 16, delta=1e-13)
        self.assertAlmostEqual(mesh.areas[mesh.region_of == 2].sum(), 1, delta=1e-13)
        self.assertEqual(set(mesh.region_of), {-1, 2})
        for lines, regions, name in (
            ([square, two], None, r"lines\[1\], ring 0 has 2 point"),
            (square, [inner, nothing], r"regions\[1\] is empty"),
            (square, [(two, 0.1)], r"regions\[0\], ring 0 has 2 point"),
        ):
            with self.assertRaisesRegex(InputError, f"^{name}.*; degenerate='ignore' leaves it out$"):
                refined_mesh([], lines=lines, regions=regions)

    def test_overlapping_polygons(self):
        """Their union is meshed."""
        squares = [_polygon([[x, x], [x + 2, x], [x + 2, x + 2], [x, x + 2]]) for x in (0, 1)]
        mesh = refined_mesh([], lines=squares)
        self.check(mesh, 25)
        self.assertAlmostEqual(mesh.areas.sum(), 7, delta=1e-12)

    def check_areas(self, mesh, limit):
        shares = mesh.areas / limit(mesh.points[mesh.simplices].mean(axis=1))
        self.assertLessEqual(shares.max(), 1 + 1e-9)
        self.assertGreater(shares.max(), 0.8)

    def test_areas_by_position(self):
        calls = []

        def near_origin(positions):
            calls.append(len(positions))
            return 1e-4 + 0.05 * np.hypot(*positions.T)

        self.check_areas(refined_mesh(SQUARE, polygons=RING, maximum_area=near_origin), near_origin)
        self.assertLess(len(calls), 40)

        def linear(positions):
            return 0.002 + positions @ [0.01, 0.02]

        self.check_areas(refined_mesh(SQUARE, polygons=RING, maximum_area=linear(np.array(SQUARE))), linear)
        empty = Image(np.zeros((8, 5)), (0.25, 0, 0, 0, -0.25, 1.5))
        pixels = Image(linear(np.stack(np.meshgrid(empty.x, empty.y), axis=2)) + 0.01, empty.transform)
        mesh = refined_mesh(SQUARE, polygons=RING, maximum_area=pixels)
        # West of the first centers it is as there.
        self.check_areas(mesh, lambda p: linear(np.maximum(p, [empty.x[0], 0])) + 0.01)

    def test_regions_of_polygons(self):
        whole, part = _polygon([[0, 0], [4, 0], [4, 4], [0, 4]]), _polygon([[1, 1], [5, 1], [5, 3], [1, 3]])
        corner = _polygon([[0, 0], [0.5, 0], [0, 0.5]])
        mesh = refined_mesh([], lines=whole, regions=[(part, 0.01), [0.1, 3.9, 0.1], corner], maximum_area=0.5)
        self.check(mesh, 25)
        x, y = mesh.points[mesh.simplices].mean(axis=1).T
        in_part, in_corner = (x > 1) & (y > 1) & (y < 3), x + y < 0.5
        np.testing.assert_array_equal(mesh.region_of, np.where(in_part, 0, np.where(in_corner, 2, 1)))
        for region, most, area in ((0, 0.01, 6), (1, 0.1, 16 - 6 - 0.125), (2, 0.5, 0.125)):
            inside = mesh.region_of == region
            self.assertAlmostEqual(mesh.areas[inside].sum(), area, delta=1e-12)
            self.assertLessEqual(mesh.areas[inside].max(), most)

    def test_values_at_points(self):
        points = np.array([*SQUARE, [0.3, 0.6]])
        mesh = refined_mesh(points, polygons=RING, maximum_area=0.01)
        self.assertIsNone(mesh.heights)
        values = points @ [[1, 2], [3, -4]]
        np.testing.assert_allclose(mesh.values_at_points(values), mesh.points @ [[1, 2], [3, -4]], rtol=0, atol=1e-15)
        found = mesh.values_at_points(np.eye(5)[4])
        self.assertEqual((found.shape, found.min(), found.max()), ((len(mesh.points),), 0, 1))
        self.assertEqual(found[5:][mesh.constraint_of_point >= 0].max(), 0)
        high = refined_mesh(np.column_stack([points, values[:, 0]]), polygons=RING, maximum_area=0.01)
        np.testing.assert_array_equal(high.heights, mesh.values_at_points(values[:, 0]))
        polygon = _polygon([[0, 0, 1], [2, 0, 2], [0, 2, 3]])
        of_lines = refined_mesh([], lines=polygon, maximum_area=0.1)
        np.testing.assert_allclose(of_lines.heights, 1 + of_lines.points @ [0.5, 1], rtol=0, atol=1e-15)

    def test_small_angles(self):
        spikes = [[0, 0], [9, 0], [9, 1], [0, 9], [-9, 0.5], [-9, -0.5]]
        mesh = refined_mesh(spikes, polygons=[[0, 1, 2], [0, 4, 5]], constraints=[[0, 3]])
        self.assertEqual(set(map(tuple, mesh.small_angles.tolist())), {(0, 1, 2), (0, 4, 5)})
        self.assertEqual(refined_mesh(SQUARE, polygons=RING).small_angles.shape, (0, 3))

    def test_bad_input(self):
        def failing(positions):
            raise KeyError("mine")

        for wrong, error, sentence in (
            (dict(minimum_angle=35), InputError, "from 0 to 34 degrees"),
            (dict(minimum_angle="a"), TypeError, "minimum_angle is a number"),
            (dict(maximum_area=0), ValueError, "maximum_area is above 0"),
            (dict(maximum_area=np.nan), ValueError, "maximum_area is above 0"),
            (dict(maximum_points=0), ValueError, "maximum_points is 1 or more"),
            (dict(regions=[[2, 2]]), InputError, r"inside of the mesh, on no constraint: regions\[0\]"),
            (dict(holes=[[0.5, 0.5], [0.5, 0.2]]), InputError, r"two regions must not be in one part.*: holes\[1\]"),
            (dict(regions=[1, 2]), ValueError, "regions are rows of 2 or 3 numbers"),
            (dict(regions=[(_polygon(SQUARE), 1)]), ValueError, "regions that are polygons go with lines"),
            (dict(regions=[(_polygon(SQUARE), -1)]), ValueError, r"the area of regions\[0\] is above 0"),
            (dict(regions=[{"type": "LineString", "coordinates": SQUARE}]), TypeError, r"regions\[0\] is no polygon"),
            (dict(maximum_area=[1, 1]), ValueError, "values are 4 numbers"),
            (dict(maximum_area=[1, 1, 0, 1]), InputError, "areas of points must be above 0.*: at index 2"),
            (dict(maximum_area=lambda p: np.ones(3)), ValueError, r"maximum_area gives 2 numbers, not .* \(3,\)"),
            (dict(maximum_area=lambda p: p[:, 0] - 2), InputError, r"maximum_area gives -.* at \(0.*areas are above 0"),
            (dict(maximum_area=failing), KeyError, "mine"),
            (dict(maximum_area=Image(np.zeros((1, 1)), (1, 0, 0, 0, -1, 0))), InputError, "areas of pixels"),
            (dict(maximum_area=Image(np.zeros(3), (1, 0, 0, 0, -1, 0))), ValueError, "has rows and columns"),
            (dict(constraints=[[0, 9]]), InputError, "constraint 0"),
            (dict(lines=[]), ValueError, "not both"),
        ):
            with self.subTest(**wrong), self.assertRaisesRegex(error, sentence), warnings.catch_warnings():
                warnings.simplefilter("ignore")
                refined_mesh(SQUARE, polygons=RING, **wrong)
        with self.assertRaisesRegex(InputError, r"on no constraint: regions\[1\]"):
            refined_mesh([], lines=_polygon(SQUARE), regions=[_polygon(SQUARE), [5, 5]])
        with self.assertRaisesRegex(ValueError, "maximum_area is no array: lines add points"):
            refined_mesh(SQUARE, lines=[], maximum_area=[1, 1, 1, 1])
        with self.assertWarnsRegex(UserWarning, "above 30 degrees"):
            refined_mesh(SQUARE, polygons=RING, minimum_angle=33)
        with self.assertWarnsRegex(UserWarning, "maximum_points ended"):
            mesh = refined_mesh(SQUARE, polygons=RING, maximum_area=1e-4, maximum_points=50)
        self.assertFalse(mesh.is_complete)
        self.assertEqual(mesh.new_points, 50)

    def test_finite_elements(self):
        """Linear elements for -laplace(u) = f with a known u: the error falls by four where areas do."""
        errors = []
        for area in (4e-3, 1e-3, 2.5e-4):
            mesh = refined_mesh(SQUARE, polygons=RING, minimum_angle=28, maximum_area=area)
            errors.append(_poisson_error(mesh))
        for coarse, fine in zip(errors, errors[1:]):
            self.assertGreater(coarse / fine, 2.5)
        self.assertLess(errors[-1], 1e-3)


def _polygon(ring):
    return {"type": "Polygon", "coordinates": [[*ring, ring[0]]]}


def _poisson_error(mesh):
    """The root of the mean square of the error at vertices, of u = sin(pi x) sin(pi y)."""
    used, cells = np.unique(mesh.simplices, return_inverse=True)
    cells, points = cells.reshape(-1, 3), mesh.points[used]
    matrix, load = np.zeros((len(used), len(used))), np.zeros(len(used))
    truth = np.sin(np.pi * points).prod(axis=1)
    for cell in cells:
        x = points[cell]
        edges = np.array([x[2] - x[1], x[0] - x[2], x[1] - x[0]])
        area = abs(edges[0, 0] * edges[1, 1] - edges[0, 1] * edges[1, 0]) / 2
        matrix[np.ix_(cell, cell)] += edges @ edges.T / (4 * area)
        load[cell] += 2 * np.pi**2 * truth[cell] * area / 3
    inside = ((points > 0) & (points < 1)).all(axis=1)
    found = np.zeros(len(used))
    found[inside] = np.linalg.solve(matrix[np.ix_(inside, inside)], load[inside])
    return np.sqrt(np.mean((found - truth) ** 2))


if __name__ == "__main__":
    warnings.simplefilter("error")
    unittest.main()
