#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Take the convex hulls of .vtp files, write them, picture them, and print a table.

    demo.py --output demo-output Data/*.vtp
"""
import argparse
import os
import time

import vtkmodules.vtkRenderingFreeType  # noqa: F401 (text)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (drawing)
from vtkmodules.vtkCommonColor import vtkNamedColors
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkWindowToImageFilter,
)

from vtkflipflop import vtkFFHullFilter

# How to look at each data set: from where, which way is up, and how much heights are exaggerated.
VIEWS = {
    "autzen": {"from": (0.75, -1.0, 0.55), "up": (0, 0, 1), "heights": 4.0},
    "sainthelens": {"from": (0.9, -1.0, 0.55), "up": (0, 0, 1), "heights": 1.5},
    "spot": {"from": (-0.8, 0.35, -1.0), "up": (0, 1, 0), "heights": 1.0},
}
DEFAULT_VIEW = {"from": (0.7, -1.0, 0.6), "up": (0, 0, 1), "heights": 1.0}

COLOURS = vtkNamedColors()


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def write(data, path):
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(path)
    writer.SetInputData(data)
    if not writer.Write():
        raise SystemExit(f"cannot write {path}")


def hull_of(points):
    """The filter after its run, and the seconds that took."""
    hull = vtkFFHullFilter()
    hull.SetInputData(points)
    hull.SetFacetModeToPolygons()
    start = time.perf_counter()
    hull.Update()
    return hull, time.perf_counter() - start


def terrain_colours():
    """Low to high: green, sand, rock, snow."""
    stops = [(0.0, (60, 110, 85)), (0.35, (150, 165, 105)), (0.65, (165, 130, 100)),
             (0.85, (190, 175, 165)), (1.0, (240, 240, 245))]  # fmt: skip
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    table.Build()
    for i in range(256):
        t = i / 255
        for (a, low), (b, high) in zip(stops, stops[1:]):
            if a <= t <= b:
                mix = [(l + (h - l) * (t - a) / (b - a)) / 255 for l, h in zip(low, high)]
                table.SetTableValue(i, *mix, 1.0)
                break
    return table


def actor_of(source, heights):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetScale(1, 1, heights)
    return actor


def point_actor(points, heights, size):
    glyphs = vtkVertexGlyphFilter()
    glyphs.SetInputData(points)
    actor = actor_of(glyphs, heights)
    look = actor.GetProperty()
    look.SetPointSize(size)
    look.RenderPointsAsSpheresOn()
    look.SetColor(0.42, 0.40, 0.38)
    elevation = points.GetPointData().GetArray("Elevation")
    if elevation:
        mapper = actor.GetMapper()
        mapper.ScalarVisibilityOn()
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray("Elevation")
        mapper.SetLookupTable(terrain_colours())
        mapper.SetScalarRange(elevation.GetRange())
    return actor


def hull_actors(hull, heights, scale):
    """The translucent facets, their edges, and the hull's vertices."""
    triangles = vtkTriangleFilter()
    triangles.SetInputData(hull)
    facets = actor_of(triangles, heights)
    look = facets.GetProperty()
    look.SetColor(0.35, 0.60, 0.90)
    look.SetOpacity(0.22)
    look.SetInterpolationToFlat()
    look.SetAmbient(0.35)
    look.SetDiffuse(0.65)

    # Every edge of a polygon is a feature: no facet is coplanar with its neighbour.
    lines = vtkFeatureEdges()
    lines.SetInputData(hull)
    lines.FeatureEdgesOn()
    lines.SetFeatureAngle(0)
    lines.BoundaryEdgesOn()
    lines.NonManifoldEdgesOn()
    lines.ManifoldEdgesOn()
    lines.ColoringOff()
    edges = actor_of(lines, heights)
    look = edges.GetProperty()
    look.SetColor(0.06, 0.22, 0.45)
    look.SetLineWidth(1.3 * scale)
    look.LightingOff()

    corners = vtkVertexGlyphFilter()
    corners.SetInputData(hull)
    vertices = actor_of(corners, heights)
    look = vertices.GetProperty()
    look.SetColor(0.85, 0.30, 0.10)
    look.SetPointSize(6 * scale)
    look.RenderPointsAsSpheresOn()
    return [facets, edges, vertices]


def caption(text, size):
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(0.5, 0.03)
    look = actor.GetTextProperty()
    look.SetFontSize(size)
    look.SetColor(0.15, 0.15, 0.15)
    look.SetJustificationToCentered()
    return actor


def renderer_of(name, points, hull, scale):
    view = VIEWS.get(name, DEFAULT_VIEW)
    heights = view["heights"]
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(point_actor(points, heights, 3.5 * scale))
    for actor in hull_actors(hull, heights, scale):
        renderer.AddActor(actor)
    text = f"{points.GetNumberOfPoints():,} points, {hull.GetNumberOfPoints():,} on the hull"
    if heights != 1:
        text += f" (heights x {heights:g})"
    renderer.AddActor(caption(text, int(22 * scale)))

    renderer.SetUseDepthPeeling(True)
    renderer.SetMaximumNumberOfPeels(16)
    renderer.SetOcclusionRatio(0)

    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(*view["from"])
    camera.SetViewUp(*view["up"])
    camera.SetViewAngle(25)
    renderer.ResetCamera()
    camera.Zoom(1.25)
    renderer.ResetCameraClippingRange()
    return renderer


def picture(renderers, width, height, path):
    """One picture, the renderers side by side in it."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetAlphaBitPlanes(True)
    window.SetMultiSamples(0)
    window.SetSize(width, height)
    for i, renderer in enumerate(renderers):
        renderer.SetViewport(i / len(renderers), 0, (i + 1) / len(renderers), 1)
        renderer.SetUseFXAA(True)
        window.AddRenderer(renderer)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def table(rows):
    head = ["points from", "points", "hull vertices", "facets", "volume", "engine", "seconds"]
    rows = [head] + rows
    widths = [max(len(row[i]) for row in rows) for i in range(len(head))]
    for n, row in enumerate(rows):
        cells = [row[0].ljust(widths[0])]
        cells += [cell.rjust(width) for cell, width in zip(row[1:], widths[1:])]
        print("  ".join(cells))
        if n == 0:
            print("  ".join("-" * width for width in widths))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+", help=".vtp files")
    parser.add_argument("--output", default="demo-output", help="folder for hulls and pictures")
    parser.add_argument("--together", help="also one picture of all, side by side, as this file")
    arguments = parser.parse_args()

    os.makedirs(arguments.output, exist_ok=True)
    rows = []
    scenes = []
    for path in arguments.files:
        name = os.path.splitext(os.path.basename(path))[0]
        points = read(path)
        if points.GetNumberOfPoints() == 0:
            raise SystemExit(f"{path}: no points")
        hull, seconds = hull_of(points)
        output = hull.GetOutput()
        write(output, os.path.join(arguments.output, f"{name}-hull.vtp"))
        picture([renderer_of(name, points, output, 1.5)], 1500, 1050,
                os.path.join(arguments.output, f"{name}.png"))  # fmt: skip
        scenes.append((name, points, output))
        rows.append(
            [
                name,
                f"{points.GetNumberOfPoints():,}",
                f"{output.GetNumberOfPoints():,}",
                f"{output.GetNumberOfCells():,}",
                f"{hull.GetVolume():.6g}",
                hull.GetEngineUsedAsString(),
                f"{seconds:.4f}",
            ]
        )
    if arguments.together:
        renderers = [renderer_of(*scene, 1.0) for scene in scenes]
        picture(renderers, 640 * len(renderers), 560, arguments.together)
    table(rows)
    print(f"\nHulls (.vtp) and pictures (.png) are in {arguments.output}/")


if __name__ == "__main__":
    main()
