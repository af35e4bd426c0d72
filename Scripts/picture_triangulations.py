# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of triangulations in the plane: as surfaces over it, and their power diagrams."""
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkLight

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

HIDDEN = (0.84, 0.05, 0.42)
INK = (0.16, 0.16, 0.18)
DISK = (0.08, 0.28, 0.62)
# Pale, so that circles and dots show on them; neighbours get different ones.
CELLS = [(0.65, 0.81, 0.89), (0.99, 0.85, 0.60), (0.74, 0.88, 0.66), (0.84, 0.77, 0.90),
         (0.98, 0.93, 0.66), (0.80, 0.86, 0.86), (0.96, 0.82, 0.78)]  # fmt: skip


def surface_actor(xyz, triangles):
    """Triangles over the plane, lit, coloured by z."""
    actor = actor_of(xyz, triangles, "polys")
    colour_points(actor, xyz[:, 2], HEIGHTS)
    actor.GetMapper().InterpolateScalarsBeforeMappingOn()
    look = actor.GetProperty()
    look.LightingOn()
    look.SetInterpolationToFlat()
    look.SetAmbient(0.38)
    look.SetDiffuse(0.8)
    look.SetSpecular(0)
    return actor


def edges_actor(xyz, triangles, width, opacity):
    corners = vtk_to_numpy(triangles.GetConnectivityArray()).reshape(-1, 3)
    pairs = numpy.stack([corners, numpy.roll(corners, -1, axis=1)], axis=-1).reshape(-1, 2)
    actor = actor_of(xyz, numpy.unique(numpy.sort(pairs, axis=1), axis=0), "lines")
    actor.GetProperty().SetColor(*INK)
    actor.GetProperty().SetOpacity(opacity)
    actor.GetProperty().SetLineWidth(width)
    return actor


def surface_scene(name, triangulation, weights, aspect, scale):
    """The points that appear, as a surface through their z; with weights, the hidden as dots."""
    view = VIEWS.get(name, DEFAULT_VIEW)
    axes = camera_axes(view)
    surface = triangulation.GetOutput()
    xyz = coordinates(surface, view["heights"])
    hidden = coordinates(triangulation.GetHiddenPointsOutput(), view["heights"])
    origin = xyz.mean(axis=0)
    xyz -= origin
    hidden -= origin
    everything = numpy.concatenate([xyz, hidden])
    actors = [surface_actor(xyz, surface.GetPolys())]
    nearer = 0.003 * numpy.ptp(everything) * axes[2]  # or the surface would cut what lies in it
    title = view.get("title", name)
    notes = [exaggerated(view)]
    # In a small picture, or where shades alone tell many triangles apart, edges would only darken.
    size = surface.GetNumberOfPolys()
    if scale > 1 and (weights or size < 15000):
        width, opacity = (0.7, 0.3) if size > 5000 else (1.3, 0.6)
        edges = edges_actor(xyz + 0.2 * nearer, surface.GetPolys(), width * scale, opacity)
        actors.append(edges)
    if weights:
        dot = (4.0 if len(hidden) < 1000 else 2.2) * scale
        actors.append(dots_actor(hidden + nearer, range(len(hidden)), HIDDEN, dot))
        title += f", {weights}"
        notes.insert(0, f"{len(hidden):,} points hidden (pink)")
    else:
        title += ", Delaunay"
        notes.insert(0, f"{len(xyz):,} points")
    text = f"{title}: {size:,} triangles\n{', '.join(filter(None, notes))}"
    renderer = renderer_of(actors, text, scale, everything, axes, aspect)
    # From the upper left, as on maps; a light in the camera would leave slopes flat.
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPositional(False)
    light.SetFocalPoint(0, 0, 0)
    light.SetPosition(*(numpy.array([-0.75, 0.55, 0.35]) @ axes))
    renderer.AddLight(light)
    return renderer


def colours_of(cells):
    """One of CELLS for each cell, none that a neighbour has."""
    at_edge = {}
    for i, cell in enumerate(cells):
        for edge in zip(cell, numpy.roll(cell, -1)):
            at_edge.setdefault(frozenset(edge), []).append(i)
    neighbours = [set() for _ in cells]
    for pair in at_edge.values():
        for i in pair:
            neighbours[i].update(pair)
    # The cell of fewest neighbours is coloured after all others, and so on: in a plane map each
    # then has five coloured neighbours at most, and the colours suffice.
    left = {i: set(others) - {i} for i, others in enumerate(neighbours)}
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


def circles_actor(centres, radii, width):
    angles = numpy.linspace(0, 2 * numpy.pi, 97)[:-1]
    ring = numpy.column_stack([numpy.cos(angles), numpy.sin(angles), 0 * angles])
    xyz = (centres[:, None, :] + radii[:, None, None] * ring).reshape(-1, 3)
    rings = numpy.arange(len(xyz)).reshape(len(centres), -1)
    actor = actor_of(xyz, numpy.column_stack([rings, rings[:, 0]]), "lines")
    actor.GetProperty().SetLineWidth(width)
    return actor


def contains(corners, place):
    """Whether the place is in a counter-clockwise convex polygon."""
    along = numpy.roll(corners, -1, axis=0) - corners
    return bool((numpy.cross(along[:, :2], (place - corners)[:, :2]) >= 0).all())


def diagram_scene(sites, weights, triangulation, aspect, scale):
    """Power cells, the circles of the weights, and which sites have no cell."""
    axes = camera_axes({"from": (0, 0, 1), "up": (0, 1, 0)})
    diagram = triangulation.GetPowerDiagramOutput()
    cells = cells_of(diagram.GetPolys())
    corners = coordinates(diagram, 1)
    xyz = coordinates(sites, 1)
    radii = numpy.sqrt(vtk_to_numpy(sites.GetPointData().GetArray(weights)))
    layer = numpy.array([0, 0, 0.01])  # what is drawn later lies higher

    colours = numpy.array(colours_of(cells))
    actors = []
    for k, colour in enumerate(CELLS):
        actor = actor_of(corners, [cells[i] for i in numpy.flatnonzero(colours == k)], "polys")
        actor.GetProperty().SetColor(*colour)
        actors.append(actor)
    borders = actor_of(corners + layer, [[*cell, cell[0]] for cell in cells], "lines")
    borders.GetProperty().SetColor(*INK)
    borders.GetProperty().SetLineWidth(1.5 * scale)
    actors.append(borders)

    # A power cell need not hold its site: a line tells which is whose.
    ids = "vtkOriginalPointIds"
    strays = []
    for site, cell in zip(vtk_to_numpy(diagram.GetCellData().GetArray(ids)), cells):
        if not contains(corners[cell], xyz[site]):
            strays += [xyz[site], corners[cell].mean(axis=0)]
    if strays:
        pairs = numpy.arange(len(strays)).reshape(-1, 2)
        leaders = actor_of(numpy.array(strays) + 2 * layer, pairs, "lines")
        leaders.GetProperty().SetColor(*DISK)
        leaders.GetProperty().SetLineWidth(1.1 * scale)
        actors.append(leaders)

    hidden = vtk_to_numpy(triangulation.GetHiddenPointsOutput().GetPointData().GetArray(ids))
    shown = vtk_to_numpy(triangulation.GetOutput().GetPointData().GetArray(ids))
    for which, colour, layers in ((shown, DISK, 2), (hidden, HIDDEN, 4)):
        circles = circles_actor(xyz[which] + layers * layer, radii[which], 1.2 * scale)
        circles.GetProperty().SetColor(*colour)
        actors += [circles, dots_actor(xyz + (layers + 1) * layer, which, colour, 5 * scale)]
    text = f"Power diagram: {len(cells)} cells of {len(xyz)} disks\n"
    text += f"{len(hidden)} disks hidden (pink)"
    everything = numpy.concatenate([corners, corners + 6 * layer])
    return renderer_of(actors, text, scale, everything, axes, aspect)
