#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Convex hulls and triangulations of .vtp files: take, write and picture them, print tables.

    demo.py --output demo-output Data/*.vtp

Every file gets a hull. Points that are wider than high, such as terrain, are also triangulated in
the plane, without weights and with. A power diagram of a few disks is there with any files.

The VTK filters compute; with --paraview, in pvpython, the plugin that PV_PLUGIN_PATH names does:

    pvpython demo.py --paraview --output demo-output/paraview Data/*.vtp
"""
import argparse
import pathlib

from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from drawing import draw
from hull_scene import hull_scene
from points import WEIGHTS, disks, is_terrain, read, weighted
from triangulation_scenes import diagram_scene, surface_scene


def write(data, path):
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(data)
    writer.SetDataModeToBinary()  # what ParaView 5.11 can read with any expat
    if not writer.Write():
        raise SystemExit(f"cannot write {path}")


def print_table(head, rows, texts):
    """The first columns, which hold text, to the left; the others to the right."""
    rows = [head] + rows
    widths = [max(len(row[i]) for row in rows) for i in range(len(head))]
    rows.insert(1, ["-" * width for width in widths])
    for row in rows:
        cells = [cell.ljust(width) for cell, width in zip(row[:texts], widths)]
        cells += [cell.rjust(width) for cell, width in zip(row[texts:], widths[texts:])]
        print("  ".join(cells).rstrip())


def hulls(filters, sets, folder):
    """For each (name, points) NAME-hull.vtp and NAME.png; the table."""
    rows = []
    for name, points in sets:
        hull, volume, engine, seconds = filters.hull(points)
        write(hull, folder / f"{name}-hull.vtp")
        draw(folder / f"{name}.png", hull_scene, name, points, hull)
        sizes = points.GetNumberOfPoints(), hull.GetNumberOfPoints(), hull.GetNumberOfCells()
        rows.append(
            [name, *(f"{size:,}" for size in sizes), f"{volume:.6g}", engine, f"{seconds:.4f}"]
        )
    head = ["hull of", "points", "hull vertices", "facets", "volume", "engine", "seconds"]
    print_table(head, rows, texts=1)


def triangulations(filters, sets, folder):
    """For each terrain NAME-delaunay and NAME-weighted, .vtp and .png; power-diagram; the table."""
    rows = []

    def show(file, texts, outputs, engine, seconds, scene, *arguments):
        """A row of the table, which begins with texts, and a picture of the scene."""
        visible, hidden = (data.GetNumberOfPoints() for data in outputs[:2])
        sizes = visible + hidden, visible, hidden, outputs[0].GetNumberOfPolys()
        rows.append([*texts, *(f"{size:,}" for size in sizes), engine, f"{seconds:.4f}"])
        draw(folder / f"{file}.png", scene, *arguments, outputs)

    for name, points in (entry for entry in sets if is_terrain(entry[1])):
        outputs, *report = filters.triangulation(points)
        if outputs[0].GetNumberOfPolys() == 0:
            continue  # all on a line
        file = f"{name}-delaunay"
        write(outputs[0], folder / f"{file}.vtp")
        show(file, [name, "none"], outputs, *report, surface_scene, name, None)

        with_weights, brief, what = weighted(points, outputs[0])
        if not with_weights:
            continue
        print(f"{name}, {brief}: the weights, squared lengths, are {what}")
        outputs, *report = filters.triangulation(with_weights, WEIGHTS)
        file = f"{name}-weighted"
        write(outputs[0], folder / f"{file}.vtp")
        write(outputs[1], folder / f"{name}-hidden.vtp")
        show(file, [name, brief], outputs, *report, surface_scene, name, brief)

    sites = disks()
    outputs, *report = filters.triangulation(sites, WEIGHTS, (-0.1, 1.1, -0.1, 1.1))
    file = "power-diagram"
    write(outputs[2], folder / f"{file}.vtp")
    show(file, ["disks", "radius^2"], outputs, *report, diagram_scene, sites)

    head = ["triangulation of", "weights", "points", "visible", "hidden", "triangles", "engine"]
    print_table(head + ["seconds"], rows, texts=2)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+", type=pathlib.Path, help=".vtp files")
    parser.add_argument(
        "--output", default="demo-output", type=pathlib.Path, help="folder for what is written"
    )
    parser.add_argument("--paraview", action="store_true", help="compute by ParaView's plugin")
    arguments = parser.parse_args()
    if arguments.paraview:
        import paraview_filters as filters
    else:
        import vtk_filters as filters

    folder = arguments.output
    folder.mkdir(parents=True, exist_ok=True)
    sets = [(path.stem, read(path)) for path in arguments.files]
    hulls(filters, sets, folder)
    print()
    triangulations(filters, sets, folder)
    print(f"\nWhat was computed (.vtp) and pictures of it (.png) are in {folder}")


if __name__ == "__main__":
    main()
