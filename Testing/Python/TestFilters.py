# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters from Python: what VTK's wrapper and NumPy's arrays bring to what the C++ tests hold."""

import os
import signal
import threading
import time
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkDataObject,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPlanes,
    vtkPolyData,
)
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkCleanPolyData
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry

import vtkflipflop
from vtkflipflop import (
    vtkFFConvexifyFilter,
    vtkFFHullFilter,
    vtkFFPointInterpolator2D,
    vtkFFPointsToImage,
    vtkFFPowerDiagramFilter,
    vtkFFRegularTriangulationFilter,
    vtkFFSelectEnclosedPoints,
)

from watching import errors_of

CUBE = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=np.float64)
RANDOM = np.random.default_rng(1)


def poly_data(xyz, triangles=(), **arrays):
    """A vtkPolyData of points in space or in the plane, whose memory is shared, with these point arrays."""
    xyz = np.asarray(xyz)
    if xyz.shape[1] == 2:
        xyz = np.column_stack([xyz, np.zeros(len(xyz), xyz.dtype)])
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(xyz)))
    data = vtkPolyData()
    data.SetPoints(points)
    cells = vtkCellArray()
    for triangle in triangles:
        cells.InsertNextCell(len(triangle), triangle)
    data.SetPolys(cells)
    for name, values in arrays.items():
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    return data


def run(kind, data, weights=None, **settings):
    algorithm = kind()
    for name, value in settings.items():
        getattr(algorithm, "Set" + name)(value)
    if weights is not None:
        algorithm.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, weights)
    algorithm.SetInputData(data)
    algorithm.Update()
    return algorithm


def coordinates(output):
    return vtk_to_numpy(output.GetPoints().GetData())


def array(data, name="vtkOriginalPointIds"):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def cells(algorithm):
    """The corners of all cells, by their ids in the input."""
    output = algorithm.GetOutput()
    return array(output)[vtk_to_numpy(output.GetPolys().GetConnectivityArray())]


class TestHull(unittest.TestCase):
    def test_cube(self):
        hull = run(vtkFFHullFilter, poly_data(np.vstack([CUBE, RANDOM.random((1000, 3)), CUBE])))
        self.assertEqual(list(array(hull.GetOutput())), list(range(8)))
        self.assertEqual((hull.GetDimension(), hull.GetVolume(), hull.GetArea()), (3, 1.0, 6.0))
        np.testing.assert_array_equal(coordinates(hull.GetOutput()), CUBE)
        hull.SetFacetMode(hull.FACETS_AS_POLYGONS)
        hull.Update()
        self.assertEqual(hull.GetOutput().GetNumberOfPolys(), 6)
        self.assertEqual(list(cells(hull)[:4]), [0, 1, 5, 4])

    def test_types(self):
        for dtype in (np.float32, np.float64, np.int32):
            points = (1000 * RANDOM.standard_normal((5000, 3))).astype(dtype)
            output = run(vtkFFHullFilter, poly_data(points)).GetOutput()
            self.assertEqual(coordinates(output).dtype, dtype)
            self.assertEqual(coordinates(output).tobytes(), points[array(output)].tobytes())

    def test_progress_and_abort(self):
        hull = vtkFFHullFilter()
        hull.SetInputData(poly_data(RANDOM.standard_normal((100000, 3))))
        seen = []
        tag = hull.AddObserver("ProgressEvent", lambda caller, event: seen.append(caller.GetProgress()))
        hull.Update()
        self.assertEqual(seen, sorted(seen))
        self.assertEqual(seen[-1], 1.0)
        hull.RemoveObserver(tag)
        messages = errors_of(hull)
        hull.AddObserver("ProgressEvent", lambda caller, event: caller.SetAbortExecute(1))
        hull.Modified()
        hull.Update()
        self.assertEqual(hull.GetOutput().GetNumberOfPoints(), 0)
        self.assertEqual(messages, [])

    def test_interrupt(self):
        """Ctrl-C in a run raises once VTK has returned; algorithms in Python stop."""
        triangulation, next_one = vtkFFRegularTriangulationFilter(), vtkCleanPolyData()
        triangulation.SetInputData(poly_data(RANDOM.random((300000, 2))))
        triangulation.SetNumberOfThreads(1)
        next_one.SetInputConnection(triangulation.GetOutputPort())
        # Python has no handler where it was started by what ignores the signal.
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.default_int_handler))
        messages, timer = errors_of(triangulation), threading.Timer(0.05, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            next_one.Update()
            timer.join()
            for _ in range(500):
                time.sleep(0.01)
        self.assertEqual((messages, triangulation.GetErrorCode()), ([], 0))
        if vtkflipflop.vtk_classes == "python":
            self.assertEqual(triangulation.GetOutput().GetNumberOfPoints(), 0)

    def test_streamed_composites(self):
        hull, whole = vtkFFHullFilter(), vtkMultiBlockDataSet()
        whole.SetBlock(0, poly_data(CUBE))
        hull.SetInputData(whole)
        hull.SetNumberOfStreamDivisions(2)
        messages = errors_of(hull)
        hull.Update()
        self.assertIn("A composite that is streamed has one hull. Set Composite Mode to Hull of All", messages[0])
        self.assertEqual(hull.GetErrorCode(), 40001)

    def test_planes(self):
        xyz = RANDOM.standard_normal((300, 3))
        hull, planes = run(vtkFFHullFilter, poly_data(xyz)), vtkPlanes()
        self.assertTrue(hull.GetPlanes(planes))
        self.assertEqual(planes.GetNumberOfPlanes(), hull.GetOutput().GetNumberOfPolys())
        self.assertLess(max(planes.EvaluateFunction(x) for x in xyz), 1e-14)
        # VTK's own filters take them.
        image = vtkImageData()
        image.SetDimensions(9, 9, 9)
        image.SetOrigin(-4, -4, -4)
        extract = vtkExtractGeometry()
        extract.SetInputData(image)
        extract.SetImplicitFunction(planes)
        extract.Update()
        found = {extract.GetOutput().GetPoint(i) for i in range(extract.GetOutput().GetNumberOfPoints())}
        select = run(vtkFFSelectEnclosedPoints, image, SurfaceData=hull.GetOutput())
        inside = {image.GetPoint(i) for i in np.flatnonzero(array(select.GetOutput(), "SelectedPoints"))}
        self.assertGreater(len(found), 10)
        self.assertLessEqual(found, inside)
        messages = errors_of(hull)
        hull.SetInputData(poly_data(CUBE[:4]))
        hull.Update()
        self.assertFalse(hull.GetPlanes(planes))
        self.assertIn("dimension 3", messages[0])

    def test_convexify(self):
        """An octahedron with one vertex pushed in: star-shaped from (0, 0, -0.5)."""
        xyz = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, -0.125], [0, 0, -1.0]]
        triangles = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]
        convexify = vtkFFConvexifyFilter()
        convexify.SetKernelPoint(0.0, 0.0, -0.5)
        self.assertEqual(convexify.GetKernelPoint(), (0.0, 0.0, -0.5))
        convexify.SetInputData(poly_data(xyz, triangles))
        convexify.Update()
        self.assertEqual(list(array(convexify.GetOutput())), [0, 1, 2, 3, 5])
        self.assertEqual(convexify.GetVolume(), 2.0 / 3.0)

    @unittest.skipUnless(vtkflipflop.vtk_classes == "compiled", "only compiled classes are for distributed data")
    def test_one_process(self):
        """Without others, the filters for distributed data are the plain ones; None is no array."""
        from vtkflipflop import vtkPFFHullFilter, vtkPFFRegularTriangulationFilter

        data = poly_data(RANDOM.standard_normal((3000, 3)), weights=np.arange(3000.0))
        for plain, distributed in (
            (vtkFFHullFilter, vtkPFFHullFilter),
            (vtkFFRegularTriangulationFilter, vtkPFFRegularTriangulationFilter),
        ):
            expected, found = run(plain, data), distributed()
            found.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "None")
            found.SetInputData(data)
            for controller in (found.GetController(), None):
                found.SetController(controller)
                found.Update()
                self.assertEqual(coordinates(found.GetOutput()).tobytes(), coordinates(expected.GetOutput()).tobytes())
                np.testing.assert_array_equal(cells(found), cells(expected))


class TestPlane(unittest.TestCase):
    def test_projection(self):
        kind = vtkFFRegularTriangulationFilter
        xy = RANDOM.integers(-1000, 1000, (500, 2)).astype(np.float64)
        flat = cells(run(kind, poly_data(xy)))
        up = poly_data(np.column_stack([np.zeros(500), xy]))  # the plane x = 0, seen from +x
        transform = vtkTransform()
        transform.SetMatrix([0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1])
        for settings in ({"ProjectionPlaneMode": kind.BEST_FITTING_PLANE}, {"Transform": transform}):
            np.testing.assert_array_equal(cells(run(kind, up, **settings)), flat)

    def test_changes_of_the_transform(self):
        transform, triangulation = vtkTransform(), vtkFFRegularTriangulationFilter()
        triangulation.SetInputData(poly_data(RANDOM.random((50, 3))))
        triangulation.SetTransform(transform)
        self.assertEqual(triangulation.GetProjectionPlaneMode(), triangulation.TRANSFORM_PLANE)
        runs, next_one = [], vtkCleanPolyData()
        next_one.SetInputConnection(triangulation.GetOutputPort())
        triangulation.AddObserver("EndEvent", lambda caller, event: runs.append(caller))
        # The inverse announces nothing.
        for change in (lambda: None, lambda: transform.RotateX(40.0), lambda: transform.RotateX(40.0),
                       lambda: triangulation.SetTransform(transform.GetInverse()), lambda: transform.RotateY(40.0)):
            change()
            before = triangulation.GetMTime()
            for algorithm in (next_one, triangulation, next_one):
                algorithm.Update()
            self.assertGreaterEqual(triangulation.GetMTime(), before)
        self.assertEqual(len(runs), 5)

    def test_box_of_a_power_diagram(self):
        diagram = vtkFFPowerDiagramFilter()
        diagram.StorePowerDiagramLengths(0.25, 0.5, 9.0)
        diagram.StorePowerDiagramCorner(1e17, 0.0, 9.0)
        diagram.StorePowerDiagramCorner(1.0, 2.0, 9.0)
        self.assertEqual(diagram.GetPowerDiagramBounds(), (1.0, 1.25, 2.0, 2.5))
        self.assertEqual(diagram.GetPowerDiagramBoxMode(), diagram.BOX_OF_POINTS)
        diagram.SetPowerDiagramBounds((0.0, 1.0, 0.0, 1.0))
        self.assertEqual(diagram.GetPowerDiagramBoxMode(), diagram.BOX_OF_BOUNDS)

    def test_power_diagram(self):
        data = poly_data(RANDOM.random((500, 2)), weights=0.01 * RANDOM.random(500))
        hidden = array(run(vtkFFRegularTriangulationFilter, data, "weights").GetOutput(1))
        diagram = vtkFFPowerDiagramFilter()
        self.assertEqual(diagram.GetPowerDiagramBounds(), (0.0, 1.0, 0.0, 1.0))
        diagram = run(vtkFFPowerDiagramFilter, data, "weights", PowerDiagramBounds=(-1.0, 2.0, 0.0, 1.0)).GetOutput()
        self.assertEqual(diagram.GetBounds()[:4], (-1.0, 2.0, 0.0, 1.0))
        sites = vtk_to_numpy(diagram.GetCellData().GetArray("vtkOriginalPointIds"))
        passed = vtk_to_numpy(diagram.GetCellData().GetArray("weights"))
        np.testing.assert_array_equal(passed, array(data, "weights")[sites])
        self.assertGreater(len(hidden), 0)
        self.assertFalse(set(hidden) & set(sites))

    def test_errors(self):
        xyz, weights = RANDOM.random((20, 3)), RANDOM.random(20)
        xyz[5, 1], xyz[6, 2], weights[11] = np.nan, np.inf, np.nan
        triangulation = vtkFFRegularTriangulationFilter()
        messages = errors_of(triangulation)
        triangulation.SetInputData(poly_data(xyz, weights=weights))
        said = ["first at point 5, 3 such point", '"absent"']
        for name, ignored in (("weights", False), ("weights", True), ("absent", True), ("", True)):
            triangulation.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, name)
            triangulation.SetNonFinitePoints(
                triangulation.NON_FINITE_IGNORE if ignored else triangulation.NON_FINITE_ERROR
            )
            count = len(messages)
            triangulation.Update()
            fails = len(messages) > count
            self.assertEqual(fails, name == "absent" or not ignored)
            self.assertEqual(triangulation.GetErrorCode() != 0, fails)
            self.assertEqual(triangulation.GetOutput().GetNumberOfPoints() == 0, fails)
        for message, words in zip(messages, said, strict=True):
            self.assertIn(words, message)


class TestQueries(unittest.TestCase):
    def test_select_enclosed_points(self):
        queries = poly_data([[0.5, 0.5, 0.5], [0.5, 0.5, 1.0], [0.5, 0.5, np.nextafter(1.0, 2.0)]])
        select = run(vtkFFSelectEnclosedPoints, queries, SurfaceData=poly_data(CUBE), GenerateDistances=True)
        output = select.GetOutput()
        self.assertTrue(output.IsA("vtkPolyData"))
        self.assertEqual(list(array(output, "SelectedPoints")), [1, 1, 0])
        self.assertEqual(list(array(output, "FlipFlopSide")), [1, 0, -1])
        self.assertEqual(list(array(output, "FlipFlopDistance")), [-0.5, 0.0, 2**-52])
        self.assertEqual([select.IsInside(i) for i in range(4)], [1, 1, 0, 0])
        self.assertEqual(select.IsInsideSurface((0.5, 0.5, 1.0)), 1)
        self.assertEqual(select.IsInsideSurface(0.5, 0.5, 1.5), 0)

    def test_point_interpolator(self):
        xy = RANDOM.uniform(-1, 1, (1000, 3))
        image = vtkImageData()
        image.SetDimensions(20, 20, 1)
        image.SetOrigin(-1.1, -1.1, 0)
        image.SetSpacing(0.11, 0.11, 1)
        at = np.array([image.GetPoint(i) for i in range(400)])
        source = poly_data(xy, values=np.stack([xy[:, 0] + 2 * xy[:, 1], 3 - xy[:, 1]], axis=1))
        for mode in (vtkFFPointInterpolator2D.LINEAR, vtkFFPointInterpolator2D.NATURAL_NEIGHBOR):
            found = run(vtkFFPointInterpolator2D, image, SourceData=source, InterpolationMode=mode)
            output = found.GetOutput()
            self.assertTrue(output.IsA("vtkImageData") and output.GetPointData().HasArray("Elevation"))
            valid = array(output, "vtkValidPointMask") == 1
            self.assertTrue(200 < valid.sum() < 400)
            expected = np.stack([at[:, 0] + 2 * at[:, 1], 3 - at[:, 1]], axis=1)
            np.testing.assert_allclose(array(output, "values")[valid], expected[valid], rtol=0, atol=1e-13)
            self.assertTrue((array(output, "values")[~valid] == 0).all())
        found.AddExcludedArray("values")
        found.SetZArrayName("z")
        found.Update()
        self.assertTrue(found.GetOutput().GetPointData().HasArray("z"))
        self.assertFalse(found.GetOutput().GetPointData().HasArray("values"))

    def test_points_to_image(self):
        source = poly_data(RANDOM.uniform(-1, 1, (1000, 3)), values=RANDOM.uniform(-1, 1, (1000, 2)))
        made = run(vtkFFPointsToImage, source, SizeMode=vtkFFPointsToImage.SIZE_BY_SPACING, Spacing=(0.07, 0.03))
        image = made.GetOutput()
        self.assertTrue(image.IsA("vtkImageData"))
        self.assertEqual(image.GetSpacing(), (0.07, 0.03, 1.0))
        points = run(vtkFFPointInterpolator2D, image, SourceData=source, NullValue=float("nan")).GetOutput()
        for name in ("values", "Elevation"):
            self.assertTrue(np.array_equal(array(image, name), array(points, name), equal_nan=True))
        self.assertTrue(np.isnan(array(image, "values")).any())
        made.SetDimensions(5, 7)
        made.SetSizeMode(vtkFFPointsToImage.SIZE_BY_DIMENSIONS)
        made.Update()
        self.assertEqual(made.GetOutput().GetDimensions(), (5, 7, 1))


class TestPackage(unittest.TestCase):
    def test_kind(self):
        """The classes are what the package says, and one can choose those in Python."""
        is_python = issubclass(vtkFFHullFilter, VTKPythonAlgorithmBase)
        self.assertEqual(vtkflipflop.vtk_classes, "python" if is_python else "compiled")
        if os.environ.get("VTKFLIPFLOP_CLASSES") == "python":
            self.assertTrue(is_python)

    @unittest.skipUnless(vtkflipflop.vtk_classes == "compiled", "these are not wrapped")
    def test_names(self):
        """All that is wrapped is exported."""
        wrapped = {
            name
            for module in ("vtkFiltersFlipFlop", "vtkFiltersParallelFlipFlop")
            for name in dir(__import__(f"vtkflipflop.{module}", fromlist=[module]))
            if name.startswith(("vtkFF", "vtkPFF")) and name != "vtkFFErrorCode"
        }
        self.assertGreater(len(wrapped), 12)
        self.assertEqual(set(vtkflipflop.__all__), wrapped)
        for name in vtkflipflop.__all__:
            self.assertTrue(hasattr(vtkflipflop, name))
        self.assertRegex(vtkflipflop.__version__, r"^\d+\.\d+\.\d+$")

    def test_device(self):
        available = vtkFFHullFilter.IsCUDAAvailable()
        self.assertEqual(bool(vtkFFHullFilter.GetCUDADeviceName()), available)
        self.assertEqual(bool(vtkFFHullFilter.GetCUDAProblem()), not available)


if __name__ == "__main__":
    unittest.main()
