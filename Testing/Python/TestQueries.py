# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the filters answer about places, from Python and together with VTK's own filters."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPlanes, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkClipPolyData
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
from vtkmodules.vtkFiltersModeling import vtkSelectEnclosedPoints
from vtkmodules.vtkFiltersSources import vtkSphereSource

from vtkflipflop import (
    vtkFFHullFilter,
    vtkFFPointInterpolator2D,
    vtkFFRegularTriangulationFilter,
    vtkFFSelectEnclosedPoints,
)

from watching import errors_of

CUBE = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=np.float64)


def poly_data(xyz):
    """A vtkPolyData of the points; the array's memory is shared, not copied."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(xyz)))
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def array(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


class TestPlanes(unittest.TestCase):
    def setUp(self):
        self.xyz = np.random.default_rng(1).standard_normal((300, 3))
        self.hull = vtkFFHullFilter()
        self.hull.SetInputData(poly_data(self.xyz))
        self.hull.Update()
        self.planes = vtkPlanes()
        self.assertTrue(self.hull.GetPlanes(self.planes))

    def test_function(self):
        self.assertEqual(self.planes.GetNumberOfPlanes(), self.hull.GetOutput().GetNumberOfPolys())
        for x in self.xyz:
            self.assertLess(self.planes.EvaluateFunction(x), 1e-14)
        self.assertLess(self.planes.EvaluateFunction(self.xyz.mean(axis=0)), 0.0)

    def test_clip(self):
        """What is clipped by the planes has no area outside the hull."""
        sphere = vtkSphereSource()
        sphere.SetRadius(self.hull.GetOutput().GetLength() / 4)
        clip = vtkClipPolyData()
        clip.SetInputConnection(sphere.GetOutputPort())
        clip.SetClipFunction(self.planes)
        clip.InsideOutOn()
        clip.Update()
        corners = vtk_to_numpy(clip.GetOutput().GetPoints().GetData())
        self.assertGreater(len(corners), 0)
        heights = [self.planes.EvaluateFunction(x) for x in corners.astype(np.float64)]
        self.assertLess(max(heights), 0.1)
        self.assertGreater(max(heights), -0.1)

    def test_extract(self):
        image = vtkImageData()
        image.SetDimensions(9, 9, 9)
        image.SetOrigin(-4, -4, -4)
        extract = vtkExtractGeometry()
        extract.SetInputData(image)
        extract.SetImplicitFunction(self.planes)
        extract.Update()
        found = {extract.GetOutput().GetPoint(i) for i in range(extract.GetOutput().GetNumberOfPoints())}
        select = vtkFFSelectEnclosedPoints()
        select.SetInputData(image)
        select.SetSurfaceConnection(self.hull.GetOutputPort())
        select.Update()
        inside = array(select.GetOutput(), "SelectedPoints")
        enclosed = {image.GetPoint(i) for i in np.flatnonzero(inside)}
        self.assertGreater(len(found), 10)
        self.assertLessEqual(found, enclosed)

    def test_flat(self):
        messages = errors_of(self.hull)
        self.hull.SetInputData(poly_data(CUBE[:4]))
        self.hull.Update()
        self.assertFalse(self.hull.GetPlanes(self.planes))
        self.assertIn("dimension 3", messages[0])


class TestSelectEnclosedPoints(unittest.TestCase):
    def test_cube(self):
        select = vtkFFSelectEnclosedPoints()
        queries = poly_data([[0.5, 0.5, 0.5], [0.5, 0.5, 1.0], [0.5, 0.5, np.nextafter(1.0, 2.0)]])
        select.SetInputData(queries)
        select.SetSurfaceData(poly_data(CUBE))
        select.GenerateDistancesOn()
        select.Update()
        output = select.GetOutput()
        self.assertTrue(output.IsA("vtkPolyData"))
        self.assertEqual(list(array(output, "SelectedPoints")), [1, 1, 0])
        self.assertEqual(list(array(output, "FlipFlopSide")), [1, 0, -1])
        self.assertEqual(list(array(output, "FlipFlopDistance")), [-0.5, 0.0, 2**-52])
        self.assertEqual([select.IsInside(i) for i in range(4)], [1, 1, 0, 0])
        self.assertEqual(select.IsInsideSurface((0.5, 0.5, 1.0)), 1)
        self.assertEqual(select.IsInsideSurface(0.5, 0.5, 1.5), 0)
        select.SelectPointsOnSurfaceOff()
        select.InsideOutOn()
        select.Update()
        self.assertEqual(list(array(output, "SelectedPoints")), [0, 1, 1])

    def test_as_vtk(self):
        """Away from the surface, VTK's filter agrees."""
        rng = np.random.default_rng(2)
        hull = vtkFFHullFilter()
        hull.SetInputData(poly_data(rng.standard_normal((1000, 3))))
        hull.Update()
        queries = poly_data(rng.uniform(-3, 3, (2000, 3)))
        found = []
        for filter in (vtkSelectEnclosedPoints(), vtkFFSelectEnclosedPoints()):
            filter.SetInputData(queries)
            filter.SetSurfaceData(hull.GetOutput())
            filter.Update()
            found.append(array(filter.GetOutput(), "SelectedPoints"))
        self.assertGreater(found[1].sum(), 100)
        np.testing.assert_array_equal(found[0], found[1])

    def test_errors(self):
        select = vtkFFSelectEnclosedPoints()
        messages = errors_of(select)
        select.SetInputData(poly_data(CUBE))
        select.SetSurfaceData(poly_data(np.where(CUBE == 1, np.nan, CUBE)))
        select.Update()
        self.assertEqual(len(messages), 1)
        self.assertIn("first at point 1 of the surface, 7 such point(s)", messages[0])
        self.assertNotEqual(select.GetErrorCode(), 0)
        select.SetNonFinitePoints(select.NON_FINITE_IGNORE)
        select.Update()
        self.assertEqual(list(array(select.GetOutput(), "SelectedPoints")), [1] + 7 * [0])


class TestPointInterpolator2D(unittest.TestCase):
    def setUp(self):
        rng = np.random.default_rng(3)
        self.xy = rng.uniform(-1, 1, (1000, 3))
        self.values = np.stack([self.xy[:, 0] + 2 * self.xy[:, 1], 3 - self.xy[:, 1]], axis=1)
        source = poly_data(self.xy)
        values = numpy_to_vtk(self.values)
        values.SetName("values")
        source.GetPointData().AddArray(values)
        self.image = vtkImageData()
        self.image.SetDimensions(20, 20, 1)
        self.image.SetOrigin(-1.1, -1.1, 0)
        self.image.SetSpacing(0.11, 0.11, 1)
        self.filter = vtkFFPointInterpolator2D()
        self.filter.SetInputData(self.image)
        self.filter.SetSourceData(source)

    def test_linear_function(self):
        at = np.array([self.image.GetPoint(i) for i in range(400)])
        for mode in (self.filter.LINEAR, self.filter.NATURAL_NEIGHBOR):
            self.filter.SetInterpolationMode(mode)
            self.filter.Update()
            output = self.filter.GetOutput()
            self.assertTrue(output.IsA("vtkImageData"))
            valid = array(output, "vtkValidPointMask") == 1
            self.assertGreater(valid.sum(), 200)
            self.assertLess(valid.sum(), 400)
            expected = np.stack([at[:, 0] + 2 * at[:, 1], 3 - at[:, 1]], axis=1)
            found = array(output, "values")
            np.testing.assert_allclose(found[valid], expected[valid], rtol=0, atol=1e-13)
            self.assertTrue((found[~valid] == 0).all())
            self.assertTrue(output.GetPointData().HasArray("Elevation"))

    def test_settings(self):
        self.filter.SetNullPointsStrategy(self.filter.CLOSEST_POINT)
        self.filter.SetZArrayName("z")
        self.filter.AddExcludedArray("values")
        self.filter.Update()
        data = self.filter.GetOutput().GetPointData()
        self.assertEqual([data.GetArrayName(i) for i in range(data.GetNumberOfArrays())], ["z"])
        at = np.array([self.image.GetPoint(i)[:2] for i in range(400)])
        nearest = ((self.xy[None, :, :2] - at[:, None]) ** 2).sum(axis=2).argmin(axis=1)
        self.assertEqual(array(self.filter.GetOutput(), "z")[0], self.xy[nearest[0], 2])

    def test_measures(self):
        """A triangle's value at its centroid is the mean of its corners'."""
        triangulation = vtkFFRegularTriangulationFilter()
        triangulation.SetGenerateCellMeasures(True)
        triangulation.SetInputData(self.filter.GetSource())
        triangulation.Update()
        output = triangulation.GetOutput()
        centroids = vtk_to_numpy(output.GetCellData().GetArray("Centroid"))
        self.assertTrue((vtk_to_numpy(output.GetCellData().GetArray("Area")) > 0).all())
        self.filter.SetInputData(poly_data(centroids))
        self.filter.Update()
        corners = vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        means = array(output, "values")[corners].mean(axis=1)
        np.testing.assert_allclose(array(self.filter.GetOutput(), "values"), means, atol=1e-13)


if __name__ == "__main__":
    unittest.main()
