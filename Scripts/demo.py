#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Take the convex hulls of .vtp files, write them, picture them, and print a table.

    demo.py --output demo-output Data/*.vtp

A few files are also pictured side by side, in the order given: hulls.png.
"""
import argparse
import os
import time

from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

import picture
from vtkflipflop import vtkFFHullFilter


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    points = reader.GetOutput()
    if points.GetNumberOfPoints() == 0:
        raise SystemExit(f"{path}: no points")
    return points


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
    seconds = time.perf_counter() - start
    if hull.GetErrorCode() != 0:
        raise SystemExit("no hull")
    return hull, seconds


def print_table(rows):
    head = ["points of", "points", "hull vertices", "facets", "volume", "engine", "seconds"]
    rows = [head] + rows
    widths = [max(len(row[i]) for row in rows) for i in range(len(head))]
    rows.insert(1, ["-" * width for width in widths])
    for row in rows:
        cells = [row[0].ljust(widths[0])]
        cells += [cell.rjust(width) for cell, width in zip(row[1:], widths[1:])]
        print("  ".join(cells))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+", help=".vtp files")
    parser.add_argument("--output", default="demo-output", help="folder for hulls and pictures")
    arguments = parser.parse_args()

    os.makedirs(arguments.output, exist_ok=True)
    rows = []
    scenes = []
    for path in arguments.files:
        name = os.path.splitext(os.path.basename(path))[0]
        points = read(path)
        hull, seconds = hull_of(points)
        output = hull.GetOutput()
        write(output, os.path.join(arguments.output, f"{name}-hull.vtp"))
        scene = picture.scene(name, points, output, 1500 / 1050, 1.6)
        picture.write_picture(os.path.join(arguments.output, f"{name}.png"), [scene], 1500, 1050)
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
    if 2 <= len(scenes) <= 4:
        renderers = [picture.scene(*scene, 600 / 500, 1.0) for scene in scenes]
        together = os.path.join(arguments.output, "hulls.png")
        picture.write_picture(together, renderers, 600 * len(renderers), 500)
    print_table(rows)
    print(f"\nHulls (.vtp) and pictures (.png) are in {arguments.output}")


if __name__ == "__main__":
    main()
