# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points and their convex hull.

Every point is drawn, then the hull around them: what faces the camera as a veil with crisp edges,
what is behind as faint edges only. From outside, a convex hull has no other hidden parts.
"""
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

from drawing import (
    HEIGHTS, actor_of, cells_of, colour_points, dots_actor, edges_of, renderer_of, view_of,
)  # fmt: skip

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


def cloud_actor(points, xyz, towards, size):
    """All points, coloured by their heights or, without such, by their depth."""
    actor = dots_actor(xyz, range(len(xyz)), size)
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
    lines = edges_of(front + cells_of(hull.GetLines()))
    hidden = sorted(set(edges_of(facets)) - set(lines))
    seen = sorted({i for line in lines for i in line})
    return [
        actor_of(xyz, hidden, "Lines", Color=EDGE, Opacity=0.18, LineWidth=0.8 * scale),
        actor_of(xyz, front, "Polys", Color=VEIL, Opacity=0.24, Lighting=True, Interpolation=0,
                 Ambient=0.45, Diffuse=0.65),
        actor_of(xyz, lines, "Lines", Color=EDGE, LineWidth=1.1 * scale),
        dots_actor(xyz, seen or range(len(xyz)), 5 * scale, Color=CORNER),
    ]  # fmt: skip


def hull_scene(name, points, hull, aspect, scale):
    """A renderer with everything in it."""
    view = view_of(name)
    towards = view.axes[2]
    cloud = view.coordinates(points)
    origin = cloud.mean(axis=0)
    cloud -= origin
    corners = view.coordinates(hull) - origin
    actors = [cloud_actor(points, cloud, towards, 3.2 * scale)]
    actors += hull_actors(hull, corners, towards, scale)
    text = f"{view.title}: {len(cloud):,} points, {len(corners):,} on the hull"
    if view.note:
        text += f" ({view.note})"
    return renderer_of(actors, text, cloud, view, aspect, scale)
