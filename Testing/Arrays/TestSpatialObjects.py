# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What vtkflipflop.spatial returns as objects of Python: copies, pickles, subclasses, arguments by name."""

import copy
import importlib.util
import pickle
import unittest

import numpy as np
from vtkflipflop import spatial

HAS_SCIPY = importlib.util.find_spec("scipy") is not None
RANDOM = np.random.default_rng(12)
CLOUDS = {"plane": RANDOM.random((300, 2)), "space": RANDOM.normal(size=(300, 3))}
SQUARE = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])
OCTAHEDRON = np.concatenate([np.eye(3), -np.eye(3)])


def rows_of(simplices):
    return {tuple(sorted(row)) for row in simplices.tolist()}


class TestObjects(unittest.TestCase):
    def test_copies(self):
        points, values = CLOUDS["plane"], CLOUDS["plane"] @ [1, 2]
        near = np.array([[0.4, 0.6], [0.5, 0.5]])
        for made, shown in (
            (spatial.ConvexHull(points), lambda hull: (hull.simplices, hull.volume)),
            (spatial.Delaunay(points), lambda tri: (tri.simplices, tri.find_simplex(near))),
            (spatial.Voronoi(points), lambda diagram: (diagram.vertices, diagram.ridge_vertices)),
            (spatial.Delaunay(points, True), lambda tri: (tri.simplices, tri.points)),
            (spatial.Voronoi(points, True), lambda diagram: (diagram.vertices, diagram.ridge_vertices)),
            (spatial.SphericalVoronoi(OCTAHEDRON), lambda diagram: (diagram.vertices, diagram.regions)),
            (
                spatial.HalfspaceIntersection([[-1, 0, 0], [0, -1, 0], [1, 1, -1]], [0.25, 0.25]),
                lambda found: (found.intersections, found.dual_points),
            ),
            (spatial.LinearNDInterpolator(points, values), lambda surface: (surface(near),)),
            (spatial.CloughTocher2DInterpolator(points, values), lambda surface: (surface(near),)),
            (spatial.NearestNDInterpolator(points, values), lambda surface: (surface(near),)),
        ):
            for duplicate in (copy.copy, copy.deepcopy, lambda some: pickle.loads(pickle.dumps(some))):
                with self.subTest(type(made).__name__):
                    other = duplicate(made)
                    self.assertIs(type(other), type(made))
                    for one, another in zip(shown(made), shown(other)):
                        np.testing.assert_array_equal(one, another)

    def test_copies_are_added_to(self):
        """Each has its own points."""
        points = CLOUDS["plane"]
        for kind in (spatial.ConvexHull, spatial.Delaunay, spatial.Voronoi):
            for duplicate in (copy.copy, copy.deepcopy, lambda some: pickle.loads(pickle.dumps(some))):
                made = kind(points[:40], incremental=True)
                made.add_points(points[40:60])
                other = duplicate(made)
                other.add_points(points[60:100])
                made.add_points(points[200:])
                for some, rows in (
                    (other, points[:100]),
                    (made, np.concatenate([points[:60], points[200:]])),
                ):
                    np.testing.assert_array_equal(some.points, rows)
                    if kind is spatial.Voronoi:
                        np.testing.assert_array_equal(some.vertices, kind(rows).vertices)
                    else:
                        self.assertEqual(rows_of(some.simplices), rows_of(kind(rows).simplices))

    def test_subclasses(self):
        class Named(spatial.ConvexHull):
            def __init__(self, name, points):
                super().__init__(points)
                self.name = name

        class Own(spatial.Delaunay):
            pass

        class Sphere(spatial.SphericalVoronoi):
            def __init__(self, name, points):
                super().__init__(points)

        hull = Named("square", SQUARE)
        self.assertEqual((hull.name, hull.volume), ("square", 1))
        self.assertIs(type(Own(SQUARE, incremental=True)), Own)
        self.assertEqual(len(Sphere("octahedron", OCTAHEDRON).regions), 6)
        with self.assertRaisesRegex(NotImplementedError, "not 4: take scipy.spatial.ConvexHull$"):
            Named("none", np.zeros((5, 4)))
        with self.assertRaisesRegex(NotImplementedError, "not 3: take scipy.spatial.Delaunay$"):
            Own(CLOUDS["space"], fallback=True)

    def test_arguments_by_name(self):
        points = CLOUDS["plane"]
        for kind in (spatial.ConvexHull, spatial.Delaunay, spatial.Voronoi):
            made = kind(points=points.tolist(), incremental=True, qhull_options=None)
            made.add_points(points=points[:2], restart=True)
            self.assertEqual(made.npoints, 302)
            with self.assertRaises(TypeError):
                kind()
            with self.assertRaisesRegex(TypeError, "hull_options"):
                kind(points, hull_options="")
        positional = spatial.Delaunay(points, False, True, None)
        positional.add_points(points[:1])
        self.assertEqual(positional.npoints, 301)
        if HAS_SCIPY:
            import scipy.spatial

            made = spatial.Delaunay(points=CLOUDS["space"], qhull_options="Qbb Qc", fallback=True)
            self.assertIs(type(made), scipy.spatial.Delaunay)
            made = spatial.Voronoi(points, False, False, "QG3", fallback=True)
            self.assertIs(type(made), scipy.spatial.Voronoi)


if __name__ == "__main__":
    unittest.main()
