# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What all pictures share: views, actors, captions, the camera, and files."""
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

# How to look at a data set: from where, which way is up, how much heights are exaggerated.
VIEWS = {
    "autzen": {
        "title": "Autzen",
        "from": (0.45, -1.0, 0.5),
        "up": (0, 0, 1),
        "heights": 4.0,
    },
    "sainthelens": {
        "title": "St Helens",
        "from": (0.7, 0.9, 0.75),
        "up": (0, 0, 1),
        "heights": 1.5,
    },
    "spot": {"title": "Spot", "from": (1.0, 0.25, -0.75), "up": (0, 1, 0), "heights": 1.0},
}
DEFAULT_VIEW = {"from": (0.7, -1.0, 0.6), "up": (0, 0, 1), "heights": 1.0}

# Low to high: forest, meadow, rock, ash, snow.
HEIGHTS = [(0.0, (52, 98, 74)), (0.3, (120, 146, 92)), (0.55, (168, 142, 104)),
           (0.8, (176, 160, 150)), (1.0, (206, 208, 222))]  # fmt: skip


def camera_axes(view):
    """Right, up, and towards the camera: orthonormal rows."""
    towards = numpy.array(view["from"], float)
    towards /= numpy.linalg.norm(towards)
    right = numpy.cross(view["up"], towards)
    right /= numpy.linalg.norm(right)
    return numpy.array([right, numpy.cross(towards, right), towards])


def coordinates(data, heights):
    """Of a data set, moved to its own origin and with its heights exaggerated."""
    xyz = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    return xyz * (1, 1, heights)


def exaggerated(view):
    return f"heights x {view['heights']:g}" if view["heights"] != 1 else ""


def cells_of(cell_array):
    offsets = vtk_to_numpy(cell_array.GetOffsetsArray())
    corners = vtk_to_numpy(cell_array.GetConnectivityArray())
    return [corners[a:b] for a, b in zip(offsets[:-1], offsets[1:])]


def array_of(cells):
    """The vtkCellArray of lists of ids."""
    sizes = [len(cell) for cell in cells]
    offsets = numpy.concatenate([[0], numpy.cumsum(sizes)]).astype(numpy.int64)
    corners = numpy.concatenate([numpy.asarray(c) for c in cells] or [[]]).astype(numpy.int64)
    array = vtkCellArray()
    array.SetData(
        numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(corners, deep=True)
    )
    return array


def actor_of(xyz, cells, kind):
    """An actor for cells of one kind: "verts", "lines" or "polys"."""
    array = cells if isinstance(cells, vtkCellArray) else array_of(cells)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(xyz), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    {"verts": data.SetVerts, "lines": data.SetLines, "polys": data.SetPolys}[kind](array)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    return actor


def dots_actor(xyz, ids, colour, size):
    actor = actor_of(xyz, [numpy.asarray(ids)], "verts")
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().SetPointSize(size)
    actor.GetProperty().RenderPointsAsSpheresOn()
    return actor


def colour_table(stops):
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    table.Build()
    places = [place for place, _ in stops]
    for i in range(256):
        rgb = [numpy.interp(i / 255, places, [c[k] for _, c in stops]) / 255 for k in range(3)]
        table.SetTableValue(i, *rgb, 1.0)
    return table


def colour_points(actor, values, stops):
    mapper = actor.GetMapper()
    mapper.GetInput().GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
    mapper.SetLookupTable(colour_table(stops))
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


def fit_camera(camera, xyz, axes, aspect, room):
    """A parallel view that just holds all points, with room, a share, for the caption below."""
    seen = xyz @ axes.T
    low, high = seen.min(axis=0), seen.max(axis=0)
    width, height, depth = numpy.maximum(high - low, 1e-9 * ((high - low).max() or 1e9))
    half = 0.5 * max(height / (0.94 - room), width / aspect / 0.94)
    centre = (low + high) / 2 - (0, room * half, 0)
    camera.ParallelProjectionOn()
    camera.SetParallelScale(half)
    camera.SetFocalPoint(*(centre @ axes))
    distance = depth + half
    camera.SetPosition(*((centre + (0, 0, distance)) @ axes))
    camera.SetViewUp(*axes[1])
    camera.SetClippingRange(0.4 * half, distance + depth)


def renderer_of(actors, text, scale, xyz, axes, aspect):
    """A renderer of the actors, which shows all of xyz, and the text below."""
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    renderer.AddActor(caption(text, int(21 * scale)))
    renderer.SetUseDepthPeeling(True)
    renderer.SetMaximumNumberOfPeels(8)
    renderer.SetUseFXAA(True)
    fit_camera(renderer.GetActiveCamera(), xyz, axes, aspect, 0.05 + 0.05 * len(text.split("\n")))
    return renderer


def write_picture(path, renderers, widths, height):
    """One PNG, the renderers side by side in it."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetAlphaBitPlanes(True)
    window.SetMultiSamples(0)
    window.SetSize(sum(widths), height)
    ends = numpy.cumsum([0, *widths]) / sum(widths)
    for renderer, left, right in zip(renderers, ends[:-1], ends[1:]):
        renderer.SetViewport(left, 0, right, 1)
        window.AddRenderer(renderer)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.SetInputBufferTypeToRGB()
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
