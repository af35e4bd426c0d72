# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo's convex hulls: taken, written, pictured."""
import os
import time

import picture
from demo_files import print_table, write
from picture_hulls import hull_scene
from vtkflipflop import vtkFFHullFilter


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


def run(sets, folder):
    """For each (name, points) NAME-hull.vtp and NAME.png; hulls.png of two to four; the table."""
    rows = []
    scenes = []
    for name, points in sets:
        hull, seconds = hull_of(points)
        output = hull.GetOutput()
        write(output, os.path.join(folder, f"{name}-hull.vtp"))
        scene = hull_scene(name, points, output, 1500 / 1050, 1.6)
        picture.write_picture(os.path.join(folder, f"{name}.png"), [scene], [1500], 1050)
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
        renderers = [hull_scene(*scene, 600 / 500, 1.0) for scene in scenes]
        together = os.path.join(folder, "hulls.png")
        picture.write_picture(together, renderers, [600] * len(renderers), 500)
    print_table(
        ["hull of", "points", "hull vertices", "facets", "volume", "engine", "seconds"], rows
    )
