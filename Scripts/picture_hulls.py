# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of points and their convex hull.

Every point is drawn, then the hull around them: what faces the camera as a veil with crisp edges,
what is behind as faint edges only. From outside, a convex hull has no other hidden parts.
"""
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

from picture import (
    DEFAULT_VIEW,
    HEIGHTS,
    VIEWS,
    actor_of,
    camera_axes,
    cells_of,
    colour_points,
    coordinates,
    dots_actor,
    exaggerated,
    renderer_of,
)

VEIL = (0.45, 0.66, 0.93)
EDGE = (0.07, 0.24, 0.50)
CORNER = (0.86, 0.28, 0.08)
# Far to near, for points without heights.
DEPTHS = [(0.0, (196, 186, 178)), (1.0, (84, 58, 42))]


def facing(xyz, facet, towards):
    """Whether a facet's outside is turned to the camera."""
    p = xyz[facet]
    normal = numpy.cross(p, numpy.roll(p, -1, axis=0)).sum(axis=0)
    return float(normal @ towards) > 0


def edges_of(facets):
    return sorted({tuple(sorted(e)) for f in facets for e in zip(f, numpy.roll(f, -1))})


def cloud_actor(points, xyz, towards, size):
    """All points, coloured by their heights or, without such, by their depth."""
    actor = actor_of(xyz, [numpy.arange(len(xyz))], "verts")
    actor.GetProperty().SetPointSize(size)
    actor.GetProperty().RenderPointsAsSpheresOn()
    heights = points.GetPointData().GetArray("Elevation")
    if heights:
        colour_points(actor, vtk_to_numpy(heights), HEIGHTS)
    else:
        colour_points(actor, xyz @ towards, DEPTHS)
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

    corners = dots_actor(xyz, seen or range(len(xyz)), CORNER, 5 * scale)
    return [back, veil, edges, corners]


def hull_scene(name, points, hull, aspect, scale):
    """A renderer with everything in it."""
    view = VIEWS.get(name, DEFAULT_VIEW)
    axes = camera_axes(view)
    cloud = coordinates(points, view["heights"])
    finite = numpy.isfinite(cloud).all(axis=1)
    origin = cloud[finite].mean(axis=0)
    cloud = numpy.where(finite[:, None], cloud - origin, 0)
    corners = coordinates(hull, view["heights"]) - origin
    actors = [cloud_actor(points, cloud, axes[2], 3.2 * scale)]
    actors += hull_actors(hull, corners, axes[2], scale)
    text = f"{view.get('title', name)}: {len(cloud):,} points, {len(corners):,} on the hull"
    if exaggerated(view):
        text += f" ({exaggerated(view)})"
    return renderer_of(actors, text, scale, cloud, axes, aspect)
