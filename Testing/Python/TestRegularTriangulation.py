# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkFFRegularTriangulationFilter from Python, through NumPy arrays."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData
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
        hidden = original_ids(triangulation.GetOutput(1).GetPointData())
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
