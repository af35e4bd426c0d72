# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo's points: read, terrain or not, with weights, and a few disks."""
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

WEIGHTS = "weight"


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    points = reader.GetOutput()
    if points.GetNumberOfPoints() == 0:
        raise SystemExit(f"{path}: no points")
    return points


def is_terrain(points):
    low_x, high_x, low_y, high_y, low_z, high_z = points.GetBounds()
    return high_z - low_z < min(high_x - low_x, high_y - low_y)


def with_weights(points, weights):
    result = vtkPolyData()
    result.ShallowCopy(points)
    array = numpy_to_vtk(weights, deep=True)
    array.SetName(WEIGHTS)
    result.GetPointData().AddArray(array)
    return result


def array_named(points, *names):
    """The first array of one component and a name, in whatever case, of these; None without."""
    data = points.GetPointData()
    arrays = filter(None, map(data.GetArray, range(data.GetNumberOfArrays())))
    named = (a for a in arrays if a.GetNumberOfComponents() == 1 and a.GetName())
    return next((a for a in named if a.GetName().lower() in names), None)


def weighted(points, delaunay):
    """The points with an array of weights, what these are, briefly and in full; None if all alike.

    Weights are squared lengths. Other values are made such by a factor, a length: then along half
    of the Delaunay edges weights differ by more than the square of the edge's length, so that the
    lighter end lies in the power cell of the heavier one.
    """
    array = array_named(points, "weight", "weights")
    if array:
        return with_weights(points, vtk_to_numpy(array).astype(float)), "weighted", array.GetName()
    array = array_named(points, "intensity")
    xyz = vtk_to_numpy(points.GetPoints().GetData()).astype(float)
    if array:
        values = vtk_to_numpy(array).astype(float)
        brief, what = "bright points heavy", array.GetName()
    else:
        values = xyz[:, 2].max() - xyz[:, 2]
        brief, what = "low points heavy", "the depth below the highest point"
    ids = vtk_to_numpy(delaunay.GetPointData().GetArray("vtkOriginalPointIds"))
    triangles = ids[vtk_to_numpy(delaunay.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
    a, b = triangles.ravel(), numpy.roll(triangles, -1, axis=1).ravel()
    difference = numpy.abs(values[a] - values[b])
    squared_length = ((xyz[a, :2] - xyz[b, :2]) ** 2).sum(axis=1)
    differ = difference > 0
    if not differ.any():
        return None, None, None
    factor = numpy.median(squared_length[differ] / difference[differ])
    return with_weights(points, factor * values), brief, f"{factor:.4g} x {what}"


def disks():
    """Few enough to see each: points in the unit square, weighted by their squared radius."""
    rng = numpy.random.default_rng(142)
    xy = rng.random((60, 2))
    radius = 0.02 + 0.1 * rng.random(60) ** 2
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.column_stack([xy, numpy.zeros(60)]), deep=True))
    result = vtkPolyData()
    result.SetPoints(points)
    return with_weights(result, radius**2)
