#!/usr/bin/env pvpython
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Convex hulls and triangulations of .vtp files in ParaView, through the plugin's filters.

    pvpython demo_paraview.py --output demo-output/paraview Data/*.vtp

The plugin is found by PV_PLUGIN_PATH. Every file gets a hull; terrain is also triangulated, without weights
and with. Each result is pictured as ParaView shows it.
"""
import argparse
import os
import time

import numpy
from paraview import servermanager, simple

import demo_triangulations
from demo_files import print_table
from picture import DEFAULT_VIEW, HEIGHTS, VIEWS, camera_axes, coordinates, exaggerated, fit_camera
from picture_hulls import EDGE, VEIL
from picture_triangulations import HIDDEN, INK

CLOUD = (0.45, 0.36, 0.30)
LIGHT_TO_HEAVY = [(0.0, (244, 247, 252)), (0.5, (168, 200, 236)), (1.0, (62, 112, 178))]
WIDTH, HEIGHT = 1500, 1050


def updated(proxy):
    """The proxy after its run, and the seconds that took."""
    start = time.perf_counter()
    proxy.UpdatePipeline()
    seconds = time.perf_counter() - start
    proxy.UpdatePropertyInformation()
    return proxy, seconds


def size(proxy, port=0):
    information = proxy[port].GetDataInformation()
    return information.GetNumberOfPoints(), information.GetNumberOfCells()


class Picture:
    """A view of one data set, from where its name says."""

    def __init__(self, name, look=None):
        self.look = look or VIEWS.get(name, DEFAULT_VIEW)
        self.title = self.look.get("title", name)
        self.shown = []
        self.view = simple.CreateRenderView()
        self.view.ViewSize = [WIDTH, HEIGHT]
        self.view.UseColorPaletteForBackground = 0
        self.view.Background = [1, 1, 1]
        self.view.OrientationAxesVisibility = 0

    def show(self, source, kind, colour, **properties):
        """Show the source in one colour, as ParaView calls the kind of representation."""
        data = servermanager.Fetch(source, idx=source.Port)
        self.shown.append(coordinates(data, self.look["heights"]))
        shown = simple.Show(source, self.view)
        shown.Representation = kind
        shown.ColorArrayName = ["POINTS", ""]
        shown.AmbientColor = shown.DiffuseColor = colour
        shown.Scale = [1, 1, self.look["heights"]]
        for key, value in properties.items():
            setattr(shown, key, value)
        return shown

    def dots(self, source, colour, share, **properties):
        """Show the source's points, with cells or without, as disks of a share of the picture."""
        shown = self.show(source, "Point Gaussian", colour, ShaderPreset="Plain circle", **properties)
        shown.GaussianRadius = share * numpy.ptp(numpy.concatenate(self.shown), axis=0).max()

    def colour(self, shown, association, name, stops):
        """Colour by an array, from its least value to its greatest."""
        simple.ColorBy(shown, (association, name))
        array = (shown.Input.PointData if association == "POINTS" else shown.Input.CellData)[name]
        low, high = array.GetRange()
        points = [[low + place * (high - low), *numpy.divide(rgb, 255)] for place, rgb in stops]
        table = simple.GetColorTransferFunction(name)
        table.ColorSpace = "RGB"
        table.RGBPoints = numpy.ravel(points).tolist()
        shown.SetScalarBarVisibility(self.view, False)

    def write(self, path, *notes):
        notes = list(filter(None, [*notes, exaggerated(self.look)]))
        text = simple.Text(Text=f"{self.title}: {', '.join(notes)}")
        shown = simple.Show(text, self.view)
        shown.Color = [0.15, 0.15, 0.15]
        shown.FontSize = 22
        shown.WindowLocation = "Lower Center"
        axes = camera_axes(self.look)
        fit_camera(
            self.view.GetActiveCamera(), numpy.concatenate(self.shown), axes, WIDTH / HEIGHT, 0.1
        )
        simple.SaveScreenshot(path, self.view, ImageResolution=[WIDTH, HEIGHT])
        simple.Delete(text)


def hull_of(name, points, folder):
    """NAME-hull.png, and the table's row."""
    hull, seconds = updated(simple.FlipFlopConvexHull(Input=points, FacetMode="Polygons"))
    (count, _), (corners, facets) = size(points), size(hull)
    picture = Picture(name)
    picture.dots(points, CLOUD, 0.13 / max(count, 1) ** 0.5)  # the more, the smaller
    picture.show(hull, "Surface", VEIL, Opacity=0.3, Interpolation="Flat")
    # Edges of a translucent surface would be as faint as it is.
    edges = simple.FeatureEdges(Input=hull, FeatureAngle=0, ManifoldEdges=1, Coloring=0)
    picture.show(edges, "Surface", EDGE, LineWidth=2.0)
    picture.write(
        os.path.join(folder, f"{name}-hull.png"), f"{count:,} points", f"{corners:,} on the hull"
    )
    return [name, f"{count:,}", f"{corners:,}", f"{facets:,}", f"{hull.Volume:.6g}", hull.EngineUsed,
            f"{seconds:.4f}"]  # fmt: skip


def row_of(name, weights, triangulation, seconds):
    points, triangles = size(triangulation)
    hidden = triangulation.NumberOfHiddenPoints
    return [name, weights, f"{points + hidden:,}", f"{points:,}", f"{hidden:,}", f"{triangles:,}",
            triangulation.EngineUsed, f"{seconds:.4f}"]  # fmt: skip


def triangulation_of(name, points, folder, weights=None):
    """The filter after its run, and the table's row; NAME-delaunay.png or NAME-weighted.png."""
    kind = "weighted" if weights else "delaunay"
    filter = simple.FlipFlopRegularTriangulation(Input=points)
    if weights:
        filter.Weights = ["POINTS", demo_triangulations.WEIGHTS]
    triangulation, seconds = updated(filter)
    row = row_of(name, weights or "none", triangulation, seconds)
    picture = Picture(name)
    notes = [f"{row[5]} triangles"]
    surface = picture.show(triangulation, "Surface", VEIL, Interpolation="Flat", Ambient=0.35)
    if "Elevation" in triangulation.PointData.keys():
        picture.colour(surface, "POINTS", "Elevation", HEIGHTS)
    if weights:
        picture.dots(simple.OutputPort(triangulation, 1), HIDDEN, 0.0015)
        notes += [weights, f"{row[4]} points hidden (pink)"]
    picture.write(os.path.join(folder, f"{name}-{kind}.png"), *notes)
    return triangulation, row


def producer_of(data, name):
    """Data made here as a source of the pipeline."""
    source = simple.TrivialProducer(registrationName=name)
    source.GetClientSideObject().SetOutput(data)
    source.UpdatePipeline()
    return source


def diagram_of(folder):
    """power-diagram.png, and the table's row."""
    sites = producer_of(demo_triangulations.disks(), "disks")
    triangulation, seconds = updated(
        simple.FlipFlopRegularTriangulation(
            Input=sites,
            Weights=["POINTS", demo_triangulations.WEIGHTS],
            GeneratePowerDiagram=1,
            PowerDiagramBoxMode="Bounds Given",
            PowerDiagramBounds=[-0.1, 1.1, -0.1, 1.1],
        )
    )
    row = row_of("disks", "radius^2", triangulation, seconds)
    look = {"title": "Power diagram", "from": (0, 0, 1), "up": (0, 1, 0), "heights": 1.0}
    picture = Picture("disks", look)
    diagram = simple.OutputPort(triangulation, 2)
    cells = picture.show(diagram, "Surface With Edges", VEIL, EdgeColor=EDGE, LineWidth=3.0,
                         Ambient=1, Diffuse=0)  # fmt: skip
    picture.colour(cells, "CELLS", demo_triangulations.WEIGHTS, LIGHT_TO_HEAVY)
    # What is drawn later lies higher.
    picture.show(triangulation, "Wireframe", INK, LineWidth=1.5, Position=[0, 0, 0.01])
    hidden = simple.OutputPort(triangulation, 1)
    picture.dots(hidden, HIDDEN, 0.009, Position=[0, 0, 0.02])
    picture.write(
        os.path.join(folder, "power-diagram.png"),
        f"{size(triangulation, 2)[1]} cells, dark where disks are large",
        "the triangulation",
        f"{row[4]} points hidden (pink)",
    )
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+", help=".vtp files")
    parser.add_argument("--output", default="demo-output/paraview", help="folder for what is written")
    arguments = parser.parse_args()
    if not hasattr(simple, "FlipFlopConvexHull"):
        raise SystemExit("the plugin is not loaded: PV_PLUGIN_PATH names no folder that holds it")
    simple._DisableFirstRenderCameraReset()
    folder = arguments.output
    os.makedirs(folder, exist_ok=True)

    hulls = []
    triangulations = []
    for path in arguments.files:
        name = os.path.splitext(os.path.basename(path))[0]
        source = simple.XMLPolyDataReader(registrationName=name, FileName=[path])
        source.UpdatePipeline()
        hulls.append(hull_of(name, source, folder))
        points = servermanager.Fetch(source)
        if not demo_triangulations.is_terrain(points):
            continue
        delaunay, row = triangulation_of(name, source, folder)
        triangulations.append(row)
        heavy, brief, _ = demo_triangulations.weighted(points, servermanager.Fetch(delaunay))
        if heavy:
            source = producer_of(heavy, f"{name} with weights")
            triangulations.append(triangulation_of(name, source, folder, brief)[1])
    triangulations.append(diagram_of(folder))

    print_table(
        ["hull of", "points", "hull vertices", "facets", "volume", "engine", "seconds"], hulls
    )
    print()
    head = ["triangulation of", "weights", "points", "visible", "hidden", "triangles", "engine"]
    print_table(head + ["seconds"], triangulations, texts=2)
    print(f"\nPictures (.png) are in {folder}")


if __name__ == "__main__":
    main()
