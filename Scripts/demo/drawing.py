# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What all pictures share: views, actors, captions, the camera, and files."""
import itertools

import numpy
import vtkmodules.vtkRenderingFreeType  # noqa: F401 (text)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (drawing)
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkWindowToImageFilter,
)

SIZE = (1500, 1050)
SCALE = 1.6  # of lines, dots and texts

# Low to high: forest, meadow, rock, ash, snow.
HEIGHTS = [(0.0, (52, 98, 74)), (0.3, (120, 146, 92)), (0.55, (168, 142, 104)),
           (0.8, (176, 160, 150)), (1.0, (206, 208, 222))]  # fmt: skip


class View:
    """How to look at data: from where, which way is up, how much heights are exaggerated."""

    def __init__(self, title, towards=(0.7, -1.0, 0.6), up=(0, 0, 1), heights=1.0):
        self.title = title
        self.heights = heights
        self.note = f"heights x {heights:g}" if heights != 1 else ""
        towards = numpy.array(towards, float)
        towards /= numpy.linalg.norm(towards)
        right = numpy.cross(up, towards)
        right /= numpy.linalg.norm(right)
        # Right, up, and towards the camera: orthonormal rows.
        self.axes = numpy.array([right, numpy.cross(towards, right), towards])

    def coordinates(self, data):
        xyz = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
        return xyz * (1, 1, self.heights)


VIEWS = {
    "autzen": View("Autzen", (0.45, -1.0, 0.5), heights=4.0),
    "sainthelens": View("St Helens", (0.7, 0.9, 0.75), heights=1.5),
    "spot": View("Spot", (1.0, 0.25, -0.75), up=(0, 1, 0)),
}


def view_of(name):
    return VIEWS.get(name) or View(name)


def cells_of(cell_array):
    offsets = vtk_to_numpy(cell_array.GetOffsetsArray())
    corners = vtk_to_numpy(cell_array.GetConnectivityArray())
    return [corners[a:b].tolist() for a, b in zip(offsets[:-1], offsets[1:])]


def edges_of(cells):
    return sorted({(min(e), max(e)) for cell in cells for e in zip(cell, [*cell[1:], cell[0]])})


def actor_of(xyz, cells, kind, **look):
    """An actor for cells, all "Verts", "Lines" or "Polys"; its look in vtkProperty's words."""
    array = vtkCellArray()
    ends = numpy.cumsum([0, *map(len, cells)])
    corners = numpy.fromiter(itertools.chain.from_iterable(cells), numpy.int64)
    array.SetData(*(numpy_to_vtkIdTypeArray(ids, deep=True) for ids in (ends, corners)))
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(xyz), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    getattr(data, f"Set{kind}")(array)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    for name, value in {"Lighting": False, **look}.items():
        getattr(actor.GetProperty(), f"Set{name}")(value)
    return actor


def dots_actor(xyz, ids, size, **look):
    return actor_of(xyz, [ids], "Verts", PointSize=size, RenderPointsAsSpheres=True, **look)


def colour_points(actor, values, stops):
    stop_values, colours = zip(*stops)
    shades = [numpy.interp(numpy.linspace(0, 1, 256), stop_values, shade) for shade in zip(*colours)]
    rgba = numpy.column_stack([*shades, numpy.full(256, 255)]).round().astype(numpy.uint8)
    table = vtkLookupTable()
    table.SetTable(numpy_to_vtk(rgba, deep=True))
    mapper = actor.GetMapper()
    mapper.GetInput().GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
    mapper.SetLookupTable(table)
    # A few outliers, such as birds in a scan, do not take the colours from the rest.
    low, high = numpy.percentile(values, [1, 99])
    mapper.SetScalarRange(*((low, high) if low < high else (low - 1, high + 1)))
    mapper.UseLookupTableScalarRangeOff()


def caption(text, size):
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(0.5, 0.025)
    look = actor.GetTextProperty()
    look.SetFontSize(size)
    look.SetColor(0.15, 0.15, 0.15)
    look.SetJustificationToCentered()
    look.SetLineSpacing(1.25)
    return actor


def fit_camera(camera, xyz, axes, aspect, margin):
    """A parallel view that just holds all points, with a margin, a share, for the caption below."""
    seen = xyz @ axes.T
    low, high = seen.min(axis=0), seen.max(axis=0)
    width, height, depth = numpy.maximum(high - low, 1e-9 * ((high - low).max() or 1e9))
    half = 0.5 * max(height / (0.94 - margin), width / aspect / 0.94)
    centre = (low + high) / 2 - (0, margin * half, 0)
    camera.ParallelProjectionOn()
    camera.SetParallelScale(half)
    camera.SetFocalPoint(*(centre @ axes))
    distance = depth + half
    camera.SetPosition(*((centre + (0, 0, distance)) @ axes))
    camera.SetViewUp(*axes[1])
    camera.SetClippingRange(0.4 * half, distance + depth)


def renderer_of(actors, text, xyz, view, aspect, scale):
    """A renderer of the actors, which shows all of xyz, and the text below."""
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in [*actors, caption(text, int(21 * scale))]:
        renderer.AddActor(actor)
    renderer.SetUseDepthPeeling(True)
    renderer.SetMaximumNumberOfPeels(8)
    renderer.SetUseFXAA(True)
    margin = 0.05 + 0.05 * len(text.split("\n"))
    fit_camera(renderer.GetActiveCamera(), xyz, view.axes, aspect, margin)
    return renderer


def draw(path, scene, *arguments):
    """A PNG of the scene of these arguments: it makes a renderer, for an aspect ratio and a scale."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetAlphaBitPlanes(True)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    window.AddRenderer(scene(*arguments, SIZE[0] / SIZE[1], SCALE))
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.SetInputBufferTypeToRGB()
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
