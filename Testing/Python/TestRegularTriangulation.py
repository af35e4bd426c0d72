# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkFFRegularTriangulationFilter from Python, through NumPy arrays."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform

from vtkflipflop import vtkFFPowerDiagramFilter, vtkFFRegularTriangulationFilter, vtkPFFRegularTriangulationFilter

from watching import errors_of


def poly_data(xyz, weights=None):
    """A vtkPolyData of the points, in space or in the plane, and their weights."""
    xyz = np.asarray(xyz)
    if xyz.shape[1] == 2:
        xyz = np.column_stack([xyz, np.zeros(len(xyz), xyz.dtype)])
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(xyz), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    if weights is not None:
        array = numpy_to_vtk(np.asarray(weights), deep=True)
        array.SetName("weights")
        data.GetPointData().AddArray(array)
    return data


def use_weights(triangulation, name="weights"):
    triangulation.SetInputArrayToProcess(
        0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, name
    )


def run(xyz, weights=None, kind=vtkFFRegularTriangulationFilter, **settings):
    triangulation = kind()
    for name, value in settings.items():
        getattr(triangulation, "Set" + name)(value)
    if weights is not None:
        use_weights(triangulation)
    triangulation.SetInputData(poly_data(xyz, weights))
    triangulation.Update()
    return triangulation


def original_ids(data):
    return vtk_to_numpy(data.GetArray("vtkOriginalPointIds"))


def triangles(triangulation):
    output = triangulation.GetOutput()
    corners = vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return original_ids(output.GetPointData())[corners]


def cells(output):
    offsets = vtk_to_numpy(output.GetPolys().GetOffsetsArray())
    connectivity = vtk_to_numpy(output.GetPolys().GetConnectivityArray())
    return [connectivity[a:b] for a, b in zip(offsets[:-1], offsets[1:])]


def area(xy):
    x, y = xy[:, 0], xy[:, 1]
    return 0.5 * np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)


class TestTriangulation(unittest.TestCase):
    def check_regular(self, xy, weights, triangulation):
        """Brute force over integers, which NumPy does not round: every lift lies on or above the
        plane of each triangle, and what appears is used."""
        p = np.asarray(xy, np.int64)
        lift = np.sum(p * p, axis=1) - np.asarray(weights, np.int64)
        seen = set()
        twice_area = 0
        for a, b, c in triangles(triangulation):
            u, v = p[b] - p[a], p[c] - p[a]
            turn = u[0] * v[1] - u[1] * v[0]
            self.assertGreater(turn, 0)
            twice_area += turn
            q = p - p[a]
            h, hu, hv = lift - lift[a], lift[b] - lift[a], lift[c] - lift[a]
            above = (
                h * turn
                - q[:, 0] * (hu * v[1] - hv * u[1])
                + q[:, 1] * (hu * v[0] - hv * u[0])
            )
            self.assertTrue(np.all(above >= 0), "a point lies beneath a triangle")
            seen.update((a, b, c))
        shown = original_ids(triangulation.GetOutput().GetPointData())
        hidden = original_ids(triangulation.GetHiddenPointsOutput().GetPointData())
        self.assertEqual(seen, set(shown))
        self.assertEqual(sorted([*shown, *hidden]), list(range(len(p))))
        self.assertEqual(len(hidden), triangulation.GetNumberOfHiddenPoints())
        return twice_area

    def test_integers_against_brute_force(self):
        rng = np.random.default_rng(1)
        for size in (4, 10, 40):
            for heft in (0, 3, size * size):
                xy = rng.integers(-size, size, (200, 2))
                xy[:4] = [[-size, -size], [size, -size], [size, size], [-size, size]]
                weights = rng.integers(-heft, heft + 1, 200)
                weights[:4] = heft + 1  # the corners stay, whatever else
                for dtype in (np.float64, np.float32, np.int32):
                    triangulation = run(xy.astype(dtype), weights.astype(dtype))
                    twice = self.check_regular(xy, weights, triangulation)
                    self.assertEqual(twice, 8 * size * size)
                    points = vtk_to_numpy(triangulation.GetOutput().GetPoints().GetData())
                    self.assertEqual(points.dtype, dtype)

    def test_delaunay_hides_duplicates_alone(self):
        rng = np.random.default_rng(2)
        xy = rng.standard_normal((5000, 2))
        triangulation = run(np.vstack([xy, xy[:100]]))
        hidden = original_ids(triangulation.GetHiddenPointsOutput().GetPointData())
        self.assertEqual(list(hidden), list(range(5000, 5100)))
        self.assertEqual(triangulation.GetHiddenPointsOutput().GetNumberOfVerts(), 100)

    def test_any_number_of_threads(self):
        rng = np.random.default_rng(3)
        xy = rng.random((30000, 2))
        weights = rng.random(30000) * 1e-4
        reference = None
        for threads in (1, 2, 4, 0):
            result = triangles(run(xy, weights, NumberOfThreads=threads)).tobytes()
            reference = reference or result
            self.assertEqual(result, reference)

    def test_degenerate(self):
        empty = run(np.empty((0, 3)))
        self.assertEqual((empty.GetDimension(), empty.GetOutput().GetNumberOfPoints()), (-1, 0))
        one = run([[1.0, 2.0]] * 5, [0.0, 3.0, 3.0, 2.0, -1.0])
        self.assertEqual((one.GetDimension(), one.GetOutput().GetNumberOfVerts()), (0, 1))
        self.assertEqual(list(original_ids(one.GetOutput().GetPointData())), [1])
        line = run(np.outer(np.arange(10.0), [1.0, -2.0]))
        self.assertEqual((line.GetDimension(), line.GetOutput().GetNumberOfLines()), (1, 9))

    def test_projection(self):
        rng = np.random.default_rng(4)
        xy = rng.integers(-1000, 1000, (500, 2)).astype(np.float64)
        flat = triangles(run(xy))
        up = np.column_stack([np.zeros(500), xy])  # the plane x = 0, seen from +x
        mode = vtkFFRegularTriangulationFilter
        fitted = run(up, ProjectionPlaneMode=mode.BEST_FITTING_PLANE)
        np.testing.assert_array_equal(triangles(fitted), flat)

        transform = vtkTransform()
        transform.SetMatrix([0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1])
        turned = run(up, ProjectionPlaneMode=mode.TRANSFORM_PLANE, Transform=transform)
        np.testing.assert_array_equal(triangles(turned), flat)
        ids = original_ids(turned.GetOutput().GetPointData())
        np.testing.assert_array_equal(
            vtk_to_numpy(turned.GetOutput().GetPoints().GetData()), up[ids]
        )
        self.assertEqual(turned.GetTransform(), transform)

    def test_power_diagram(self):
        rng = np.random.default_rng(5)
        xy = rng.random((500, 2))
        weights = 0.01 * rng.random(500)
        mode = vtkFFPowerDiagramFilter
        triangulation = run(xy, weights)
        diagram = run(
            xy,
            weights,
            mode,
            PowerDiagramBoxMode=mode.BOX_OF_BOUNDS,
            PowerDiagramBounds=(-1.0, 2.0, 0.0, 1.0),
        ).GetOutput()
        corners = vtk_to_numpy(diagram.GetPoints().GetData())
        areas = [area(corners[cell]) for cell in cells(diagram)]
        self.assertAlmostEqual(sum(areas), 3.0, places=10)
        self.assertGreater(min(areas), 0.0)
        sites = original_ids(diagram.GetCellData())
        passed = vtk_to_numpy(diagram.GetCellData().GetArray("weights"))
        np.testing.assert_array_equal(passed, weights[sites])
        hidden = original_ids(triangulation.GetHiddenPointsOutput().GetPointData())
        self.assertGreater(len(hidden), 0)
        self.assertFalse(set(hidden) & set(sites))

    def test_one_process_and_no_weights(self):
        """Without others, the filter for distributed data is the plain one; None is no array."""
        xy = np.random.default_rng(8).standard_normal((2000, 2))
        expected = triangles(run(xy))
        distributed = vtkPFFRegularTriangulationFilter()
        messages = errors_of(distributed)
        use_weights(distributed, "None")
        distributed.SetInputData(poly_data(xy, np.arange(2000.0)))
        distributed.Update()
        self.assertEqual(messages, [])
        np.testing.assert_array_equal(triangles(distributed), expected)

    def test_blocks(self):
        rng = np.random.default_rng(9)
        clouds = [rng.standard_normal((n, 2)) for n in (100, 200)]
        blocks = vtkMultiBlockDataSet()
        for k, xy in enumerate(clouds):
            blocks.SetBlock(k, poly_data(xy, 0.1 * rng.random(len(xy))))
        triangulation = vtkFFRegularTriangulationFilter()
        messages = errors_of(triangulation)
        use_weights(triangulation)
        triangulation.SetInputDataObject(blocks)
        triangulation.Update()
        self.assertEqual(messages, [])
        self.assertEqual(triangulation.GetNumberOfInputPoints(), 300)
        for k, xy in enumerate(clouds):
            counts = [
                triangulation.GetOutputDataObject(port).GetBlock(k).GetNumberOfPoints()
                for port in range(2)
            ]
            self.assertEqual(sum(counts), len(xy))
            self.assertGreater(counts[1], 0)
        blocks.GetBlock(1).GetPointData().RemoveArray("weights")
        blocks.Modified()
        triangulation.Update()
        self.assertEqual(len(messages), 1)
        self.assertIn("of data set 1 of the composite is missing", messages[0])

    def test_errors(self):
        rng = np.random.default_rng(6)
        xyz = rng.random((20, 3))
        weights = rng.random(20)
        xyz[5, 1] = np.nan
        xyz[6, 2] = np.inf
        weights[11] = np.nan
        triangulation = vtkFFRegularTriangulationFilter()
        messages = errors_of(triangulation)
        use_weights(triangulation)
        triangulation.SetInputData(poly_data(xyz, weights))
        triangulation.Update()
        self.assertEqual(len(messages), 1)
        self.assertIn("point 5,", messages[0])
        self.assertIn("3 such point", messages[0])
        self.assertNotEqual(triangulation.GetErrorCode(), 0)
        self.assertEqual(triangulation.GetOutput().GetNumberOfPoints(), 0)

        triangulation.SetNonFinitePoints(triangulation.NON_FINITE_IGNORE)
        triangulation.Update()
        self.assertEqual(len(messages), 1)
        self.assertEqual(triangulation.GetNumberOfNonFinitePoints(), 3)
        self.assertGreater(triangulation.GetOutput().GetNumberOfPolys(), 0)

        use_weights(triangulation, "absent")
        triangulation.Update()
        self.assertEqual(len(messages), 2)
        self.assertIn('"absent"', messages[1])
        self.assertEqual(triangulation.GetOutput().GetNumberOfPoints(), 0)
        use_weights(triangulation, "")  # none again
        triangulation.Update()
        self.assertEqual(len(messages), 2)

    def test_documentation_and_defaults(self):
        triangulation = vtkFFRegularTriangulationFilter()
        self.assertIn("Delaunay", vtkFFRegularTriangulationFilter.__doc__)
        self.assertEqual(triangulation.GetNumberOfOutputPorts(), 3)
        self.assertEqual(triangulation.GetProjectionPlaneMode(), triangulation.XY_PLANE)
        diagram = vtkFFPowerDiagramFilter()
        self.assertEqual(diagram.GetPowerDiagramBoxMode(), diagram.BOX_OF_POINTS)
        self.assertEqual(diagram.GetPowerDiagramBounds(), (0.0, 1.0, 0.0, 1.0))
        self.assertIsNone(triangulation.GetTransform())
        self.assertFalse(hasattr(triangulation, "GetVolume"))


if __name__ == "__main__":
    unittest.main()
