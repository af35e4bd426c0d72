#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The same calls of scipy's classes and of vtkflipflop.spatial's: a table of seconds and ratios, as Markdown.

    spatial.py [WORD...]

With words, the rows that have one of them. What is measured is the call and the attributes that programs read; the
best of three, on all threads that each has.
"""

import sys
import time

import numpy as np
import scipy.interpolate
import scipy.spatial
from vtkflipflop import spatial

RANDOM = np.random.default_rng(7)
REPETITIONS = 3


def directions(count):
    rows = RANDOM.normal(size=(count, 3))
    return rows / np.linalg.norm(rows, axis=1)[:, None]


def attributes(found, *names):
    """Which are computed when they are first read."""
    return [getattr(found, name) for name in names]


def hull(points):
    return lambda of: attributes(of.ConvexHull(points), "simplices", "equations", "volume")


def triangles(points, **options):
    return lambda of: attributes(of.Delaunay(points, **options), "simplices", "neighbors")


def cells(points):
    return lambda of: attributes(of.Voronoi(points), "vertices", "regions", "ridge_vertices")


def half_spaces(count, reach):
    normals = directions(count)
    rows = np.column_stack([normals, -RANDOM.uniform(1, reach, count)])
    return lambda of: of.HalfspaceIntersection(rows, np.zeros(3)).intersections


def queries(points, positions):
    def call(of):
        made = of.Delaunay(points)
        return lambda: made.find_simplex(positions)

    return call


def values(name, points, positions):
    heights = np.sin(7 * points[:, 0]) + points[:, 1]

    def call(of):
        made = getattr(of if of is spatial else scipy.interpolate, name)(points, heights)
        return lambda: made(positions)

    return call


def rows():
    cube, square = RANDOM.random((1_000_000, 3)), RANDOM.random((100_000, 2))
    grid = np.stack(np.meshgrid(*2 * [np.arange(300.0)]), axis=-1).reshape(-1, 2)
    positions = RANDOM.random((1_000_000, 2))
    sphere = directions(100_000)
    few = RANDOM.random((20, 3))
    yield "`ConvexHull`, 1e6 in a cube", hull(cube)
    yield "`ConvexHull`, 1e5 on a sphere", hull(sphere)
    yield "`ConvexHull`, 1e6 in a square", hull(cube[:, :2])
    yield "`ConvexHull`, 20", hull(few)
    yield "`Delaunay`, 1e5", triangles(square)
    yield "`Delaunay`, a grid of 9e4", triangles(grid)
    yield "`Delaunay`, 20", triangles(few[:, :2])
    yield "`Delaunay`, 1e5, `furthest_site=True`", triangles(square, furthest_site=True)
    yield "`find_simplex`, 1e6 in 1e5", queries(square, positions)
    yield "`Voronoi`, 1e5", cells(square)
    yield "`HalfspaceIntersection`, 1e5 around a ball", half_spaces(100_000, 1)
    yield "`HalfspaceIntersection`, 1e5, of which 2 % have a facet", half_spaces(100_000, 1.1)
    yield "`SphericalVoronoi`, 1e5", lambda of: of.SphericalVoronoi(sphere).regions
    for name in ("LinearNDInterpolator", "CloughTocher2DInterpolator", "NearestNDInterpolator"):
        yield f"`{name}`, 1e6 in 1e5", values(name, square, positions)


def measured(call, of):
    """The best time of the call; of one that prepares something and returns a function, of that."""
    best = np.inf
    for _ in range(REPETITIONS):
        begin = time.perf_counter()
        found = call(of)
        if callable(found):
            begin = time.perf_counter()
            found()
        best = min(best, time.perf_counter() - begin)
        if best > 5:
            break
    return best


def main():
    print("| call | scipy, s | here, s | ratio |\n|---|---|---|---|")
    for name, call in rows():
        if len(sys.argv) < 2 or any(word in name for word in sys.argv[1:]):
            theirs, ours = (measured(call, of) for of in (scipy.spatial, spatial))
            print(f"| {name} | {theirs:.3g} | {ours:.3g} | {theirs / ours:.2g} |", flush=True)


if __name__ == "__main__":
    main()
