#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs each package that is installed on Data/PeersFaults/, and says what Checker/check_result.py finds in its results.

    faults.py [FILE]...

A file has a line "# hull: ..." or "# triangulation: ..." and x, y, z of a point in each further line. All coordinates
are floats of single precision, so that no package has to round them. What a package may choose is not held against
it: its triangles are turned outwards first, and a point of a facet may be a vertex or not.
"""

import glob
import importlib.metadata
import multiprocessing
import os
import sys

import numpy as np

TOP = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path[:0] = [os.path.join(TOP, "Benchmarks"), os.path.join(TOP, "Checker")]

import check_result  # noqa: E402
import peers  # noqa: E402


@peers.function(2)
def startinpy_triangulation(points, _):
    import startinpy

    triangulation = startinpy.DT()
    triangulation.insert(np.column_stack([points, np.zeros(len(points))]))
    # Vertex 0 is infinite; points may be in another order, or missing.
    ids = {tuple(p): i for i, p in enumerate(points.tolist())}
    found = [ids[tuple(p[:2])] if i else -1 for i, p in enumerate(np.asarray(triangulation.points).tolist())]
    return [[found[i] for i in row] for row in triangulation.triangles]


@peers.function(2)
def shapely_triangulation(points, _):
    import shapely

    ids = {tuple(p): i for i, p in enumerate(points.tolist())}
    triangles = shapely.delaunay_triangles(shapely.MultiPoint(points)).geoms
    return [[ids[p] for p in list(triangle.exterior.coords)[:3]] for triangle in triangles]


@peers.function(3)
def trimesh_hull(points, _):
    import trimesh

    mesh = trimesh.convex.convex_hull(points)
    ids = {tuple(p): i for i, p in enumerate(points.tolist())}
    return [[ids[tuple(mesh.vertices[i].tolist())] for i in face] for face in mesh.faces]


@peers.function(3)
def manifold_hull(points, _):
    import manifold3d

    mesh = manifold3d.Manifold.hull_points(points).to_mesh()
    ids = {tuple(p): i for i, p in enumerate(points.tolist())}
    return [[ids[tuple(map(float, mesh.vert_properties[i][:3]))] for i in face] for face in mesh.tri_verts]


# By the name of the distribution.
PEERS = {
    "hull": {
        "scipy (Qhull)": ("scipy", peers.TASKS["scipy-hull"]),
        "vtkConvexHull": ("vtk", peers.TASKS["vtk-convex-hull"]),
        "vtkDelaunay3D": ("vtk", peers.TASKS["vtk-delaunay-3d"]),
        "meshlib": ("meshlib", peers.TASKS["meshlib-hull"]),
        "trimesh": ("trimesh", trimesh_hull),
        "manifold3d": ("manifold3d", manifold_hull),
        "vtkflipflop": ("vtkflipflop", peers.TASKS["our-hull"]),
    },
    "triangulation": {
        "scipy (Qhull)": ("scipy", peers.TASKS["scipy-triangulation"]),
        "vtkDelaunay2D": ("vtk", peers.TASKS["vtk-delaunay-2d"]),
        "vtkVoronoiFlower2D": ("vtk", peers.TASKS["vtk-voronoi-flower-2d"]),
        "matplotlib": ("matplotlib", peers.TASKS["matplotlib-triangulation"]),
        "triangle": ("triangle", peers.TASKS["triangle-triangulation"]),
        "startinpy": ("startinpy", startinpy_triangulation),
        "shapely": ("shapely", shapely_triangulation),
        "vtkflipflop": ("vtkflipflop", peers.TASKS["our-triangulation"]),
    },
}


def read(path):
    """The kind, what the input is, and the points."""
    with open(path, encoding="utf-8") as file:
        kind, what = file.readline()[1:].strip().split(": ", 1)
        points = np.array([list(map(float, line.split())) for line in file], np.float64).reshape(-1, 3)
    return kind, what, points


def outwards(kind, points, cells):
    """The triangles, turned so that an inner point is beneath them (in the plane: counter-clockwise)."""
    exact = check_result.Exact({"points": list(map(tuple, points.tolist()))}).points
    four = check_result.independent(exact, range(len(points)))
    middle = tuple(map(sum, zip(*(exact[i] for i in four))))
    turned = []
    for cell in cells:
        a, b, c = (exact[i] for i in cell[:3])
        if kind == "hull" and len(four) == 4:
            u, v = check_result.minus(b, a), check_result.minus(c, a)
            w = tuple(m - 4 * x for m, x in zip(middle, a))
            side = -check_result.dot(check_result.cross(u, v), w)
        else:
            side = check_result.turn(a, b, c)
        turned.append(tuple(cell) if side >= 0 else tuple(cell[::-1]))
    return turned


def verdict(kind, task, points):
    """In words, of one package's result."""
    work = task(points.copy(), 1, 1)
    try:
        work.run()
        found, cells, _ = work.result()
    except Exception as error:  # pylint: disable=broad-exception-caught
        return f"refuses: {type(error).__name__}"
    if not isinstance(cells, np.ndarray):
        offsets, corners = (np.asarray(a).tolist() for a in cells)
        cells = [corners[a:b] for a, b in zip(offsets, offsets[1:])]
    else:
        cells = cells.tolist()
    if not cells:
        return "wrong: the result is empty"
    ids = {}
    for i, p in enumerate((points if kind == "hull" else points[:, :2]).tolist()):
        ids.setdefault(tuple(p), i)
    try:
        corner = [ids[tuple(map(float, p[: 3 if kind == "hull" else 2]))] for p in np.asarray(found).tolist()]
    except KeyError as error:
        return f"wrong: no point is at {error.args[0]}"
    cells = [tuple(corner[i] for i in cell) for cell in cells]
    rows = points if kind == "hull" else points[:, :2]
    case = {"points": list(map(tuple, rows.tolist())), "cells": outwards(kind, points, cells)}
    try:
        check_result.KINDS[kind](case)
    except check_result.Wrong as wrong:
        return f"wrong: {wrong}"
    return "right"


def send(pipe, kind, name, points):
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    os.dup2(1, 2)
    pipe.send(verdict(kind, PEERS[kind][name][1], points))


def watched(kind, name, points, seconds=20):
    """The verdict; a package may end its process, or not come back."""
    ours, theirs = multiprocessing.Pipe()
    process = multiprocessing.get_context("fork").Process(target=send, args=(theirs, kind, name, points))
    process.start()
    theirs.close()
    try:
        return ours.recv() if ours.poll(seconds) else f"no result in {seconds} s"
    except EOFError:
        return "ends the process"
    finally:
        process.kill()
        process.join()


def main(paths):
    for path in paths or sorted(glob.glob(os.path.join(TOP, "Data", "PeersFaults", "*-*.txt"))):
        kind, what, points = read(path)
        print(f"\n{os.path.basename(path)}: {kind} of {len(points)} points: {what}")
        for name, (package, _) in PEERS[kind].items():
            try:
                version = importlib.metadata.version(package)
            except importlib.metadata.PackageNotFoundError:
                continue
            print(f"  {name} {version}: {watched(kind, name, points)}", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
