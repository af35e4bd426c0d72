# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Triangulations in the plane: as surfaces over it, and their power diagrams."""
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkLight

from drawing import (
    HEIGHTS, View, actor_of, cells_of, colour_points, dots_actor, edges_of, renderer_of, view_of,
)  # fmt: skip
from points import WEIGHTS

HIDDEN = (0.84, 0.05, 0.42)
INK = (0.16, 0.16, 0.18)
DISK = (0.08, 0.28, 0.62)
# Pale, so that circles and dots show on them; neighbours get different ones.
CELLS = [(0.65, 0.81, 0.89), (0.99, 0.85, 0.60), (0.74, 0.88, 0.66), (0.84, 0.77, 0.90),
         (0.98, 0.93, 0.66), (0.80, 0.86, 0.86), (0.96, 0.82, 0.78)]  # fmt: skip


def surface_actor(xyz, triangles):
    """Triangles over the plane, lit, coloured by z."""
    actor = actor_of(xyz, triangles, "Polys", Lighting=True, Interpolation=0, Ambient=0.38,
                     Diffuse=0.8, Specular=0)  # fmt: skip
    colour_points(actor, xyz[:, 2], HEIGHTS)
    actor.GetMapper().InterpolateScalarsBeforeMappingOn()
    return actor


def surface_scene(name, weights, outputs, aspect, scale):
    """The points that appear, as a surface through their z; with weights, the hidden as dots."""
    view = view_of(name)
    surface, hidden = outputs
    xyz, below = view.coordinates(surface), view.coordinates(hidden)
    origin = xyz.mean(axis=0)
    xyz -= origin
    below -= origin
    everything = numpy.concatenate([xyz, below])
    triangles = cells_of(surface.GetPolys())
    actors = [surface_actor(xyz, triangles)]
    nearer = 0.003 * numpy.ptp(everything) * view.axes[2]  # or the surface would cut what is in it
    # Where shades alone distinguish many triangles, edges would only darken.
    size = len(triangles)
    if weights or size < 15000:
        width, opacity = (0.7, 0.3) if size > 5000 else (1.3, 0.6)
        actors.append(
            actor_of(xyz + 0.2 * nearer, edges_of(triangles), "Lines", Color=INK, Opacity=opacity,
                     LineWidth=width * scale)
        )  # fmt: skip
    if weights:
        dot = (4.0 if len(below) < 1000 else 2.2) * scale
        actors.append(dots_actor(below + nearer, range(len(below)), dot, Color=HIDDEN))
        note = f"{len(below):,} points hidden (pink)"
    else:
        note = f"{len(xyz):,} points"
    text = f"{view.title}, {weights or 'Delaunay'}: {size:,} triangles\n"
    text += ", ".join(filter(None, [note, view.note]))
    renderer = renderer_of(actors, text, everything, view, aspect, scale)
    # From the upper left, as on maps; a light in the camera would leave slopes flat.
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPositional(False)
    light.SetFocalPoint(0, 0, 0)
    light.SetPosition(*(numpy.array([-0.75, 0.55, 0.35]) @ view.axes))
    renderer.AddLight(light)
    return renderer


def colours_of(cells):
    """One of CELLS for each cell, none that a neighbour has."""
    at_edge = {}
    for i, cell in enumerate(cells):
        for edge in edges_of([cell]):
            at_edge.setdefault(edge, []).append(i)
    neighbours = [set() for _ in cells]
    for pair in at_edge.values():
        for i in pair:
            neighbours[i].update(pair)
    # The cell of fewest neighbours is coloured after all others, and so on: in a plane map each
    # then has five coloured neighbours at most, and the colours suffice.
    left = {i: others - {i} for i, others in enumerate(neighbours)}
    order = []
    while left:
        order.append(min(left, key=lambda i: (len(left[i]), i)))
        for j in left.pop(order[-1]):
            left[j].discard(order[-1])
    chosen = [None] * len(cells)
    for i in reversed(order):
        taken = {chosen[j] for j in neighbours[i]}
        # A turn for each cell, or the first colours would be everywhere.
        turns = [(i + k) % len(CELLS) for k in range(len(CELLS))]
        chosen[i] = next(k for k in turns if k not in taken)
    return chosen


def circles_actor(centres, radii, **look):
    angles = numpy.linspace(0, 2 * numpy.pi, 97)[:-1]
    ring = numpy.column_stack([numpy.cos(angles), numpy.sin(angles), 0 * angles])
    xyz = (centres[:, None, :] + radii[:, None, None] * ring).reshape(-1, 3)
    rings = numpy.arange(len(xyz)).reshape(len(centres), -1)
    return actor_of(xyz, numpy.column_stack([rings, rings[:, 0]]), "Lines", **look)


def ids_of(attributes):
    return vtk_to_numpy(attributes.GetArray("vtkOriginalPointIds"))


def contains(corners, position):
    """Whether the position is in a counter-clockwise convex polygon."""
    along = numpy.roll(corners, -1, axis=0) - corners
    return bool((numpy.cross(along[:, :2], (position - corners)[:, :2]) >= 0).all())


def diagram_scene(sites, outputs, aspect, scale):
    """Power cells, the circles of the weights, and which sites have no cell."""
    view = View("Power diagram", (0, 0, 1), up=(0, 1, 0))
    shown, hidden, diagram = outputs
    cells = cells_of(diagram.GetPolys())
    corners, xyz = view.coordinates(diagram), view.coordinates(sites)
    radii = numpy.sqrt(vtk_to_numpy(sites.GetPointData().GetArray(WEIGHTS)))
    layer = numpy.array([0, 0, 0.01])  # what is drawn later lies higher

    colours = colours_of(cells)
    actors = []
    for k, colour in enumerate(CELLS):
        of_colour = [cell for cell, chosen in zip(cells, colours) if chosen == k]
        actors.append(actor_of(corners, of_colour, "Polys", Color=colour))
    borders = [[*cell, cell[0]] for cell in cells]
    actors.append(actor_of(corners + layer, borders, "Lines", Color=INK, LineWidth=1.5 * scale))

    # A power cell need not hold its site: a line joins the two.
    strays = []
    for site, cell in zip(ids_of(diagram.GetCellData()), cells):
        if not contains(corners[cell], xyz[site]):
            strays += [xyz[site], corners[cell].mean(axis=0)]
    if strays:
        pairs = numpy.arange(len(strays)).reshape(-1, 2)
        ends = numpy.array(strays) + 2 * layer
        actors.append(actor_of(ends, pairs, "Lines", Color=DISK, LineWidth=1.1 * scale))

    for data, colour, layers in ((shown, DISK, 2), (hidden, HIDDEN, 4)):
        which = ids_of(data.GetPointData())
        centres = xyz[which] + layers * layer
        actors.append(circles_actor(centres, radii[which], Color=colour, LineWidth=1.2 * scale))
        actors.append(dots_actor(xyz + (layers + 1) * layer, which, 5 * scale, Color=colour))
    text = f"{view.title}: {len(cells)} cells of {len(xyz)} disks\n"
    text += f"{hidden.GetNumberOfPoints()} disks hidden (pink)"
    everything = numpy.concatenate([corners, corners + 6 * layer])
    return renderer_of(actors, text, everything, view, aspect, scale)
