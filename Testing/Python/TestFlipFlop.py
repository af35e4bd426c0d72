# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters from Python: the same promises as in C++, through NumPy arrays."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkDataSetAttributes,
    vtkMultiBlockDataSet,
    vtkPolyData,
)
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer

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
    def check_hull(self, xyz, output):
        """Brute force over integer points, where NumPy's integers are exact."""
        ids = original_ids(output)
        np.testing.assert_array_equal(coordinates(output), xyz[ids])
        self.assertTrue(np.all(np.diff(ids) > 0))
        p = xyz.astype(np.int64)
        extreme = set()
        for a, b, c in ids[corners(output.GetPolys(), 3)]:
            normal = np.cross(p[b] - p[a], p[c] - p[a])
            side = (p - p[a]) @ normal
            self.assertTrue(np.any(normal != 0))
            self.assertTrue(np.all(side <= 0), "a point lies outside a facet")
            extreme.update((a, b, c))
        self.assertEqual(extreme, set(ids))

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

    def test_integer_points_against_brute_force(self):
        rng = np.random.default_rng(2)
        for size in (4, 10, 40):
            for _ in range(10):
                xyz = rng.integers(-size, size, (300, 3)).astype(np.float64)
                hull, output = run(xyz)
                self.assertEqual(hull.GetDimension(), 3)
                self.check_hull(xyz, output)

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
        self.check_hull(integers, output)

    def test_any_number_of_threads(self):
        rng = np.random.default_rng(4)
        xyz = rng.standard_normal((40000, 3))
        xyz /= np.linalg.norm(xyz, axis=1)[:, None]
        reference = None
        for threads in (1, 2, 4, 0):
            hull, output = run(xyz, NumberOfThreads=threads)
            result = (coordinates(output).tobytes(), corners(output.GetPolys(), 3).tobytes())
            reference = reference or result
            self.assertEqual(result, reference)
        self.assertEqual(hull.GetEngineUsed(), vtkFFHullFilter.ENGINE_CPU)
        self.assertTrue(hull.GetEngineReason())

    def test_degenerate(self):
        hull, output = run(np.empty((0, 3)))
        self.assertEqual((hull.GetDimension(), output.GetNumberOfPoints()), (-1, 0))

        hull, output = run(np.tile(CUBE[3], (7, 1)))
        self.assertEqual((hull.GetDimension(), output.GetNumberOfVerts()), (0, 1))
        self.assertEqual(list(original_ids(output)), [0])

        hull, output = run(np.outer(np.arange(10), [1.0, -2.0, 3.0]))
        self.assertEqual((hull.GetDimension(), output.GetNumberOfLines()), (1, 1))
        self.assertEqual(list(original_ids(output)), [0, 9])

        grid = np.array([[x, y, 5.0] for x in range(10) for y in range(10)])
        hull, output = run(grid, FacetMode=vtkFFHullFilter.FACETS_AS_POLYGONS)
        self.assertEqual((hull.GetDimension(), output.GetNumberOfPolys()), (2, 1))
        self.assertEqual(list(original_ids(output)), [0, 9, 90, 99])
        self.assertEqual(hull.GetArea(), 81.0)

    def test_point_data(self):
        rng = np.random.default_rng(5)
        xyz = rng.standard_normal((2000, 3))
        values = rng.standard_normal((2000, 4))
        data = poly_data(xyz)
        array = numpy_to_vtk(values)
        array.SetName("values")
        data.GetPointData().SetScalars(array)
        hull = vtkFFHullFilter()
        hull.SetInputData(data)
        hull.Update()
        output = hull.GetOutput()
        passed = vtk_to_numpy(output.GetPointData().GetScalars())
        np.testing.assert_array_equal(passed, values[original_ids(output)])
        self.assertEqual(output.GetPointData().GetScalars().GetName(), "values")
        hull.PassPointDataOff()
        hull.VisiblePointIdsOn()
        hull.Update()
        names = [output.GetPointData().GetArrayName(i) for i in range(2)]
        self.assertEqual(output.GetPointData().GetNumberOfArrays(), 2)
        self.assertEqual(sorted(names), ["OriginalPointIds", "vtkOriginalPointIds"])

    def test_ghost_points(self):
        data = poly_data(np.vstack([[[9, 9, 9]], CUBE]))
        marks = numpy_to_vtk(np.array([vtkDataSetAttributes.DUPLICATEPOINT] + 8 * [0], np.uint8))
        marks.SetName(vtkDataSetAttributes.GhostArrayName())
        data.GetPointData().AddArray(marks)
        hull = vtkFFHullFilter()
        hull.SetInputData(data)
        hull.Update()
        self.assertEqual(list(original_ids(hull.GetOutput())), list(range(1, 9)))
        self.assertEqual((hull.GetVolume(), hull.GetNumberOfInputPoints()), (1.0, 8))
        hull.SkipGhostPointsOff()
        hull.Update()
        self.assertEqual(hull.GetNumberOfInputPoints(), 9)
        self.assertGreater(hull.GetVolume(), 1.0)

    def test_blocks(self):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, poly_data(CUBE))
        blocks.SetBlock(1, poly_data(CUBE + [3, 0, 0]))
        hull = vtkFFHullFilter()
        hull.SetInputDataObject(blocks)
        hull.Update()
        output = hull.GetOutputDataObject(0)
        self.assertTrue(output.IsA("vtkMultiBlockDataSet"))
        self.assertEqual(output.GetBlock(1).GetNumberOfPolys(), 12)
        self.assertEqual(hull.GetVolume(), 2.0)
        hull.SetCompositeMode(hull.HULL_OF_ALL_BLOCKS)
        hull.Update()
        output = hull.GetOutput()
        self.assertEqual(hull.GetVolume(), 4.0)
        self.assertEqual(list(original_ids(output)), [0, 2, 4, 6, 9, 11, 13, 15])
        indices = vtk_to_numpy(output.GetPointData().GetArray("BlockIndex"))
        self.assertEqual(list(indices), [1] * 4 + [2] * 4)

    def test_errors(self):
        xyz = np.vstack([CUBE, CUBE])
        xyz[5, 1] = np.nan
        xyz[11, 0] = np.inf
        hull = vtkFFHullFilter()
        messages = errors_of(hull)
        hull.SetInputData(poly_data(xyz))
        hull.Update()
        self.assertEqual(len(messages), 1)
        self.assertIn("point 5,", messages[0])
        self.assertIn("2 such point", messages[0])
        self.assertNotEqual(hull.GetErrorCode(), 0)
        self.assertEqual(hull.GetOutput().GetNumberOfPoints(), 0)

        hull.SetNonFinitePoints(hull.NON_FINITE_IGNORE)
        hull.Update()
        self.assertEqual(len(messages), 1)
        self.assertEqual(hull.GetErrorCode(), 0)
        self.assertEqual(hull.GetNumberOfNonFinitePoints(), 2)
        self.assertEqual(list(original_ids(hull.GetOutput())), [0, 1, 2, 3, 4, 6, 7, 13])

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

    def test_report_as_field_data(self):
        hull, output = run(CUBE)
        self.assertEqual(output.GetFieldData().GetNumberOfArrays(), 0)
        hull.ReportAsFieldDataOn()
        hull.Update()
        data = output.GetFieldData()
        count = data.GetNumberOfArrays()
        found = {data.GetArrayName(i): data.GetAbstractArray(i).GetValue(0) for i in range(count)}
        self.assertEqual(len(found), 26)
        expected = {
            "FlipFlopDimension": 3,
            "FlipFlopPoints": 8,
            "FlipFlopNonFinite": 0,
            "FlipFlopEngine": "CPU",
            "FlipFlopEngineReason": hull.GetEngineReason(),
            "FlipFlopThreads": 1,
            "FlipFlopVolume": 1.0,
            "FlipFlopArea": 6.0,
        }
        self.assertEqual({name: found[name] for name in expected}, expected)
        self.assertEqual(
            found["FlipFlopFlips22"] + found["FlipFlopFlips31"],
            found["FlipFlopFlipsV"] + found["FlipFlopFlipsD"],
        )
        self.assertGreater(found["FlipFlopSecondsTotal"], 0.0)

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

    def test_pipeline(self):
        source = vtkTrivialProducer()
        source.SetOutput(poly_data(CUBE))
        hull = vtkFFHullFilter()
        hull.SetInputConnection(source.GetOutputPort())
        convexify = vtkFFConvexifyFilter()
        convexify.SetInputConnection(hull.GetOutputPort())
        convexify.Update()
        self.assertEqual(convexify.GetVolume(), 1.0)


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

    def test_errors(self):
        cases = [
            (self.triangles[:-1], "not closed"),
            (self.triangles[:-1] + [[0, 5, 3]], "not oriented"),
            (self.triangles[:-1] + [[0, 3, 9]], "cell 7"),
            (self.triangles[:-1] + [[0, 3, 5, 1]], "cell 7"),
            (self.triangles + [[0, 1, 2]], "not a manifold"),
        ]
        for triangles, part in cases:
            convexify = vtkFFConvexifyFilter()
            messages = errors_of(convexify)
            convexify.SetInputData(surface(self.xyz, triangles))
            convexify.Update()
            self.assertEqual(len(messages), 1)
            self.assertIn(part, messages[0])
            self.assertIn("cell", messages[0])
            self.assertEqual(convexify.GetOutput().GetNumberOfPoints(), 0)

        convexify = vtkFFConvexifyFilter()
        messages = errors_of(convexify)
        convexify.SetInputData(surface(self.xyz, self.triangles))
        convexify.SetKernelPoint(0.0, 0.0, 0.5)
        convexify.UseKernelPointOn()
        convexify.Update()
        self.assertIn("4 such triangle", messages[0])
        self.assertIn("cell 0", messages[0])


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
