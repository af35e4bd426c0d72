# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of points and their convex hull.

Every point is drawn, then the hull around them: what faces the camera as a veil with crisp edges,
what is behind as faint edges only. From outside, a convex hull has no other hidden parts.
"""
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

VEIL = (0.45, 0.66, 0.93)
EDGE = (0.07, 0.24, 0.50)
CORNER = (0.86, 0.28, 0.08)
# Far to near, for points without heights.
DEPTHS = [(0.0, (196, 186, 178)), (1.0, (84, 58, 42))]
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


def cells_of(cell_array):
    offsets = vtk_to_numpy(cell_array.GetOffsetsArray())
    corners = vtk_to_numpy(cell_array.GetConnectivityArray())
    return [corners[a:b] for a, b in zip(offsets[:-1], offsets[1:])]


def facing(xyz, facet, towards):
    """Whether a facet's outside is turned to the camera."""
    p = xyz[facet]
    normal = numpy.cross(p, numpy.roll(p, -1, axis=0)).sum(axis=0)
    return float(normal @ towards) > 0


def edges_of(facets):
    return sorted({tuple(sorted(e)) for f in facets for e in zip(f, numpy.roll(f, -1))})


def actor_of(xyz, cells, kind):
    """An actor for cells of one kind: "verts", "lines" or "polys"."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(xyz), deep=True))
    sizes = [len(cell) for cell in cells]
    offsets = numpy.concatenate([[0], numpy.cumsum(sizes)]).astype(numpy.int64)
    corners = numpy.concatenate([numpy.asarray(c) for c in cells] or [[]]).astype(numpy.int64)
    array = vtkCellArray()
    array.SetData(
        numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(corners, deep=True)
    )
    data = vtkPolyData()
    data.SetPoints(points)
    {"verts": data.SetVerts, "lines": data.SetLines, "polys": data.SetPolys}[kind](array)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
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


def cloud_actor(points, xyz, towards, size):
    """All points, coloured by their heights or, without such, by their depth."""
    actor = actor_of(xyz, [numpy.arange(len(xyz))], "verts")
    actor.GetProperty().SetPointSize(size)
    actor.GetProperty().RenderPointsAsSpheresOn()
    scalars = points.GetPointData().GetArray("Elevation")
    stops = HEIGHTS if scalars else DEPTHS
    scalars = scalars or numpy_to_vtk(xyz @ towards, deep=True)
    mapper = actor.GetMapper()
    mapper.GetInput().GetPointData().SetScalars(scalars)
    mapper.SetLookupTable(colour_table(stops))
    # A few outliers, such as birds in a scan, do not take the colours from the rest.
    mapper.SetScalarRange(*numpy.percentile(vtk_to_numpy(scalars), [1, 99]))
    mapper.UseLookupTableScalarRangeOff()
    return actor


def hull_actors(hull, xyz, towards, scale):
    facets = cells_of(hull.GetPolys())
    solid = len(facets) > 1
    front = [f for f in facets if not solid or facing(xyz, f, towards)]
    lines = edges_of(front) + [tuple(line) for line in cells_of(hull.GetLines())]
    seen = sorted({i for line in lines for i in line} | {i for f in front for i in f})
    hidden = sorted(set(edges_of(facets)) - set(lines))

    back = actor_of(xyz, hidden, "lines")
    back.GetProperty().SetColor(*EDGE)
    back.GetProperty().SetOpacity(0.18)
    back.GetProperty().SetLineWidth(0.8 * scale)

    veil = actor_of(xyz, front, "polys")
    look = veil.GetProperty()
    look.SetColor(*VEIL)
    look.SetOpacity(0.24)
    look.LightingOn()
    look.SetInterpolationToFlat()
    look.SetAmbient(0.45)
    look.SetDiffuse(0.65)

    edges = actor_of(xyz, lines, "lines")
    edges.GetProperty().SetColor(*EDGE)
    edges.GetProperty().SetLineWidth(1.1 * scale)

    corners = actor_of(xyz, [numpy.array(seen or range(len(xyz)))], "verts")
    corners.GetProperty().SetColor(*CORNER)
    corners.GetProperty().SetPointSize(5 * scale)
    corners.GetProperty().RenderPointsAsSpheresOn()
    return [back, veil, edges, corners]


def caption(text, size):
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(0.5, 0.025)
    look = actor.GetTextProperty()
    look.SetFontSize(size)
    look.SetColor(0.15, 0.15, 0.15)
    look.SetJustificationToCentered()
    return actor


def fit_camera(camera, xyz, axes, aspect):
    """A parallel view that just holds all points, with room for the caption below."""
    seen = xyz @ axes.T
    low, high = seen.min(axis=0), seen.max(axis=0)
    width, height, depth = numpy.maximum(high - low, 1e-9 * ((high - low).max() or 1e9))
    half = 0.5 * max(height / 0.84, width / aspect / 0.94)
    centre = (low + high) / 2 - (0, 0.05 * 2 * half, 0)
    camera.ParallelProjectionOn()
    camera.SetParallelScale(half)
    camera.SetFocalPoint(*(centre @ axes))
    distance = depth + half
    camera.SetPosition(*((centre + (0, 0, distance)) @ axes))
    camera.SetViewUp(*axes[1])
    camera.SetClippingRange(0.4 * half, distance + depth)


def scene(name, points, hull, aspect, scale):
    """A renderer with everything in it."""
    view = VIEWS.get(name, DEFAULT_VIEW)
    axes = camera_axes(view)
    cloud = coordinates(points, view["heights"])
    finite = numpy.isfinite(cloud).all(axis=1)
    origin = cloud[finite].mean(axis=0)
    cloud = numpy.where(finite[:, None], cloud - origin, 0)

    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(cloud_actor(points, cloud, axes[2], 3.2 * scale))
    corners = coordinates(hull, view["heights"]) - origin
    for actor in hull_actors(hull, corners, axes[2], scale):
        renderer.AddActor(actor)
    text = f"{view.get('title', name)}: {len(cloud):,} points, {len(corners):,} on the hull"
    if view["heights"] != 1:
        text += f" (heights x {view['heights']:g})"
    renderer.AddActor(caption(text, int(21 * scale)))
    renderer.SetUseDepthPeeling(True)
    renderer.SetMaximumNumberOfPeels(8)
    renderer.SetUseFXAA(True)
    fit_camera(renderer.GetActiveCamera(), cloud, axes, aspect)
    return renderer


def write_picture(path, renderers, width, height):
    """One PNG, the renderers side by side in it."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetAlphaBitPlanes(True)
    window.SetMultiSamples(0)
    window.SetSize(width, height)
    for i, renderer in enumerate(renderers):
        renderer.SetViewport(i / len(renderers), 0, (i + 1) / len(renderers), 1)
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
