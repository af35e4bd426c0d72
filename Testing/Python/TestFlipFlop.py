# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters from Python: what VTK's wrapper and NumPy's arrays bring to what the C++ tests hold."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import vtkflipflop
from vtkflipflop import vtkFFConvexifyFilter, vtkFFHullFilter, vtkPFFHullFilter

from watching import errors_of

CUBE = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=np.float64)


def poly_data(xyz):
    """A vtkPolyData of the points; the array's memory is shared, not copied."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(xyz)))
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def surface(xyz, triangles):
    data = poly_data(xyz)
    cells = vtkCellArray()
    for triangle in triangles:
        cells.InsertNextCell(len(triangle), [int(i) for i in triangle])
    data.SetPolys(cells)
    return data


def run(xyz, **settings):
    hull = vtkFFHullFilter()
    for name, value in settings.items():
        getattr(hull, "Set" + name)(value)
    hull.SetInputData(poly_data(xyz))
    hull.Update()
    return hull, hull.GetOutput()


def coordinates(output):
    return vtk_to_numpy(output.GetPoints().GetData())


def original_ids(output):
    return vtk_to_numpy(output.GetPointData().GetArray("vtkOriginalPointIds"))


def corners(cells, size):
    return vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, size)


class TestHull(unittest.TestCase):
    def test_cube(self):
        rng = np.random.default_rng(1)
        xyz = np.vstack([CUBE, rng.random((1000, 3)), CUBE])
        hull, output = run(xyz)
        self.assertEqual(list(original_ids(output)), list(range(8)))
        self.assertEqual(output.GetNumberOfPolys(), 12)
        self.assertEqual(hull.GetDimension(), 3)
        self.assertEqual(hull.GetVolume(), 1.0)
        self.assertEqual(hull.GetArea(), 6.0)
        np.testing.assert_array_equal(coordinates(output), CUBE)

        hull.SetFacetMode(hull.FACETS_AS_POLYGONS)
        hull.Update()
        self.assertEqual(output.GetNumberOfPolys(), 6)
        self.assertEqual(list(corners(output.GetPolys(), 4)[0]), [0, 1, 5, 4])

    def test_types(self):
        rng = np.random.default_rng(3)
        xyz = rng.standard_normal((5000, 3))
        for dtype in (np.float32, np.float64):
            points = xyz.astype(dtype)
            hull, output = run(points)
            self.assertEqual(coordinates(output).dtype, dtype)
            np.testing.assert_array_equal(
                coordinates(output).view(np.uint8), points[original_ids(output)].view(np.uint8)
            )
        integers = (1000 * xyz).astype(np.int32)
        hull, output = run(integers)
        self.assertEqual(coordinates(output).dtype, np.int32)

    def test_progress_and_abort(self):
        rng = np.random.default_rng(6)
        hull = vtkFFHullFilter()
        hull.SetInputData(poly_data(rng.standard_normal((100000, 3))))
        seen = []

        def observe(caller, event):
            seen.append(caller.GetProgress())

        tag = hull.AddObserver("ProgressEvent", observe)
        hull.Update()
        self.assertEqual(seen, sorted(seen))
        self.assertEqual(seen[-1], 1.0)
        self.assertGreater(hull.GetOutput().GetNumberOfPoints(), 0)
        hull.RemoveObserver(tag)

        messages = errors_of(hull)
        hull.AddObserver("ProgressEvent", lambda caller, event: caller.SetAbortExecute(1))
        hull.Modified()
        hull.Update()
        self.assertEqual(hull.GetOutput().GetNumberOfPoints(), 0)
        self.assertEqual(messages, [])

    def test_one_process(self):
        """Without others, the filter for distributed data is the plain one."""
        xyz = np.random.default_rng(7).standard_normal((5000, 3))
        _, expected = run(xyz)
        distributed = vtkPFFHullFilter()
        distributed.SetInputData(poly_data(xyz))
        for controller in (distributed.GetController(), None):
            distributed.SetController(controller)
            distributed.Update()
            output = distributed.GetOutput()
            self.assertEqual(coordinates(output).tobytes(), coordinates(expected).tobytes())
            np.testing.assert_array_equal(original_ids(output), original_ids(expected))
            np.testing.assert_array_equal(
                corners(output.GetPolys(), 3), corners(expected.GetPolys(), 3)
            )


class TestConvexify(unittest.TestCase):
    def setUp(self):
        """An octahedron with one vertex pushed in: star-shaped from the origin."""
        self.xyz = np.array(
            [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 0.125], [0, 0, -1]], dtype=float
        )
        self.triangles = [
            [0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4],
            [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5],
        ]

    def test_by_flips(self):
        xyz = np.vstack([self.xyz, [[50, 50, 50]]])  # the last is not used
        xyz[4, 2] = -0.125
        convexify = vtkFFConvexifyFilter()
        messages = errors_of(convexify)
        convexify.SetInputData(surface(xyz, self.triangles))
        convexify.SetKernelPoint(0.0, 0.0, -0.5)
        convexify.UseKernelPointOn()
        convexify.SetFacetMode(convexify.FACETS_AS_POLYGONS)
        convexify.Update()
        self.assertEqual(messages, [])
        output = convexify.GetOutput()
        self.assertEqual(list(original_ids(output)), [0, 1, 2, 3, 5])
        self.assertEqual(output.GetNumberOfPolys(), 5)
        self.assertEqual(convexify.GetVolume(), 2.0 / 3.0)

        convexify.UseKernelPointOff()
        convexify.Update()
        self.assertEqual(messages, [])
        self.assertEqual(list(original_ids(convexify.GetOutput())), [0, 1, 2, 3, 5])


class TestPackage(unittest.TestCase):
    def test_names(self):
        self.assertEqual(
            sorted(vtkflipflop.__all__),
            [
                "vtkFFAlgorithm",
                "vtkFFConstrainedDelaunayFilter",
                "vtkFFConvexifyFilter",
                "vtkFFHullAlgorithm",
                "vtkFFHullFilter",
                "vtkFFPlanarAlgorithm",
                "vtkFFPointInterpolator2D",
                "vtkFFPowerDiagramFilter",
                "vtkFFQueryAlgorithm",
                "vtkFFRegularTriangulationFilter",
                "vtkFFSelectEnclosedPoints",
                "vtkPFFDelaunayFilter",
                "vtkPFFHullFilter",
                "vtkPFFPowerDiagramFilter",
                "vtkPFFRegularTriangulationFilter",
            ],
        )
        for name in vtkflipflop.__all__:
            self.assertTrue(hasattr(vtkflipflop, name))
        self.assertRegex(vtkflipflop.__version__, r"^\d+\.\d+\.\d+$")

    def test_device(self):
        available = vtkFFHullFilter.IsCUDAAvailable()
        self.assertEqual(bool(vtkFFHullFilter.GetCUDADeviceName()), available)
        self.assertEqual(bool(vtkFFHullFilter.GetCUDAProblem()), not available)

    def test_documentation(self):
        self.assertIn("convex hull", vtkFFHullFilter.__doc__)
        self.assertIn("Flip-Flop", vtkFFConvexifyFilter.__doc__)

    def test_defaults(self):
        hull = vtkFFHullFilter()
        self.assertEqual(hull.GetEngine(), vtkFFHullFilter.ENGINE_AUTOMATIC)
        self.assertEqual(hull.GetNumberOfThreads(), 0)
        self.assertEqual(hull.GetFacetMode(), vtkFFHullFilter.FACETS_AS_TRIANGLES)
        self.assertEqual(hull.GetNonFinitePoints(), vtkFFHullFilter.NON_FINITE_ERROR)
        self.assertEqual(hull.GetCompositeMode(), vtkFFHullFilter.HULL_OF_EACH_BLOCK)
        self.assertTrue(hull.GetSkipGhostPoints())
        self.assertTrue(hull.GetPassPointData())
        self.assertTrue(hull.GetVBiased())
        self.assertFalse(hull.GetVisiblePointIds())
        self.assertFalse(vtkFFConvexifyFilter().GetUseKernelPoint())
        self.assertEqual(vtkFFConvexifyFilter().GetKernelPoint(), (0.0, 0.0, 0.0))


if __name__ == "__main__":
    unittest.main()
