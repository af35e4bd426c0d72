# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo's triangulations in the plane, without weights and with, and a power diagram."""
import os
import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData

import picture
from demo_files import print_table, write
from picture_triangulations import diagram_scene, surface_scene
from vtkflipflop import vtkFFRegularTriangulationFilter

WEIGHTS = "weight"


def triangulation_of(points, weights=None, bounds=None):
    """The filter after its run, and the seconds that took; with the power diagram in the bounds."""
    triangulation = vtkFFRegularTriangulationFilter()
    triangulation.SetInputData(points)
    if weights:
        triangulation.SetInputArrayToProcess(
            0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, weights
        )
    if bounds:
        triangulation.GeneratePowerDiagramOn()
        triangulation.SetPowerDiagramBounds(*bounds)
        triangulation.SetPowerDiagramBoxModeToBounds()
    start = time.perf_counter()
    triangulation.Update()
    seconds = time.perf_counter() - start
    if triangulation.GetErrorCode() != 0:
        raise SystemExit("no triangulation")
    return triangulation, seconds


def is_terrain(points):
    low_x, high_x, low_y, high_y, low_z, high_z = points.GetBounds()
    return high_z - low_z < min(high_x - low_x, high_y - low_y)


def array_named(points, names):
    data = points.GetPointData()
    for i in range(data.GetNumberOfArrays()):
        array = data.GetArray(i)
        name = array.GetName() if array and array.GetNumberOfComponents() == 1 else None
        if name and name.lower() in names:
            return array
    return None


def weighted(points, delaunay):
    """The points with an array of weights, what these are, briefly and in full; None if all alike.

    Weights are squared lengths. Other values are made such by a factor, a length: then along half
    of the Delaunay edges weights differ by more than the square of the edge's length, so that the
    lighter end lies in the power cell of the heavier one.
    """
    array = array_named(points, ("weight", "weights"))
    if array:
        weights, brief, what = vtk_to_numpy(array).astype(float), "weighted", array.GetName()
    else:
        array = array_named(points, ("intensity",))
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
        weights, what = factor * values, f"{factor:.4g} x {what}"
    result = vtkPolyData()
    result.ShallowCopy(points)
    scaled = numpy_to_vtk(weights, deep=True)
    scaled.SetName(WEIGHTS)
    result.GetPointData().AddArray(scaled)
    return result, brief, what


def disks():
    """Few enough to see each: points in the unit square, weighted by their squared radius."""
    rng = numpy.random.default_rng(142)
    xy = rng.random((60, 2))
    radius = 0.02 + 0.1 * rng.random(60) ** 2
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.column_stack([xy, numpy.zeros(60)]), deep=True))
    weights = numpy_to_vtk(radius**2, deep=True)
    weights.SetName(WEIGHTS)
    result = vtkPolyData()
    result.SetPoints(points)
    result.GetPointData().AddArray(weights)
    return result


def row_of(name, weights, triangulation, seconds):
    output = triangulation.GetOutput()
    hidden = triangulation.GetNumberOfHiddenPoints()
    return [
        name,
        weights,
        f"{output.GetNumberOfPoints() + hidden:,}",
        f"{output.GetNumberOfPoints():,}",
        f"{hidden:,}",
        f"{output.GetNumberOfPolys():,}",
        triangulation.GetEngineUsedAsString(),
        f"{seconds:.4f}",
    ]


def draw_together(scenes, path):
    """Terrain side by side, then the diagram, which is not as wide."""
    widths = [550] * (len(scenes) - 1) + [400]
    renderers = [kind(*data, w / 420, 0.8) for (kind, *data), w in zip(scenes, widths)]
    picture.write_picture(path, renderers, widths, 420)


def run(sets, folder):
    """For each terrain NAME-delaunay and NAME-weighted, .vtp and .png; power-diagram; the table.

    triangulations.png has the first terrain without weights, the last one with, and the diagram.
    """

    def draw(kind, name, *data):
        path = os.path.join(folder, f"{name}.png")
        picture.write_picture(path, [kind(*data, 1500 / 1050, 1.6)], [1500], 1050)

    rows = []
    together = []
    for name, points in (entry for entry in sets if is_terrain(entry[1])):
        plain, seconds = triangulation_of(points)
        if plain.GetOutput().GetNumberOfPolys() == 0:
            continue  # all on a line
        write(plain.GetOutput(), os.path.join(folder, f"{name}-delaunay.vtp"))
        draw(surface_scene, f"{name}-delaunay", name, plain, None)
        rows.append(row_of(name, "none", plain, seconds))
        together[:] = together[:1] or [(surface_scene, name, plain, None)]

        heavy, brief, what = weighted(points, plain.GetOutput())
        if not heavy:
            continue
        print(f"{name}, {brief}: the weights, squared lengths, are {what}")
        regular, seconds = triangulation_of(heavy, WEIGHTS)
        write(regular.GetOutput(), os.path.join(folder, f"{name}-weighted.vtp"))
        write(regular.GetHiddenPointsOutput(), os.path.join(folder, f"{name}-hidden.vtp"))
        draw(surface_scene, f"{name}-weighted", name, regular, brief)
        rows.append(row_of(name, brief, regular, seconds))
        together[1:] = [(surface_scene, name, regular, brief)]

    sites = disks()
    diagram, seconds = triangulation_of(sites, WEIGHTS, (-0.1, 1.1, -0.1, 1.1))
    write(diagram.GetPowerDiagramOutput(), os.path.join(folder, "power-diagram.vtp"))
    draw(diagram_scene, "power-diagram", sites, WEIGHTS, diagram)
    rows.append(row_of("disks", "radius^2", diagram, seconds))
    together.append((diagram_scene, sites, WEIGHTS, diagram))

    if len(together) > 1:
        draw_together(together, os.path.join(folder, "triangulations.png"))
    head = ["triangulation of", "weights", "points", "visible", "hidden", "triangles", "engine"]
    print_table(head + ["seconds"], rows, texts=2)
