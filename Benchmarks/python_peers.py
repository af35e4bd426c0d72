#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.arrays beside what the Python package index has for the same arrays.

    pip install vtkflipflop scipy triangle meshlib
    python3 Benchmarks/python_peers.py [--sizes 1e2,1e3,...] [--rounds N] [--csv FILE] [--markdown]

In each round every contender has its turn, and the least of its times counts. A contender that took longer than
--limit seconds for a size is not asked for the next one. Points are in NumPy's memory before the clock starts; what is
timed is the call, and reading the cells and vertices as arrays of ids.

What others return is judged without a tolerance: a hull by its vertices, which our own hull tells once the engine's
exact validation has passed it; a triangulation by the signs, in integers, of its triangles and of the in-circle test
over its edges (coordinates are multiples of 2^-20, so 64 bits and Python's integers carry them), and by its number of
triangles, which Euler's formula tells. "-": it raised an error, or says that it leaves points out.
"""

import argparse
import csv
import platform
import sys
import time
from datetime import date
from importlib.metadata import version

import numpy as np

from vtkflipflop.arrays import convex_hull, convex_hulls, regular_triangulation

UNIT = 2.0**-20


# Points -----------------------------------------------------------------------------------------------------------


def on_lattice(points):
    """Multiples of UNIT: few enough bits for the judge, and enough that ties are rare."""
    return np.round(points / UNIT) * UNIT


def ball(random, count):
    points = random.standard_normal((count, 3))
    points /= np.linalg.norm(points, axis=1)[:, None]
    return on_lattice(points * random.random(count)[:, None] ** (1 / 3))


def sphere(random, count):
    points = random.standard_normal((count, 3))
    return on_lattice(points / np.linalg.norm(points, axis=1)[:, None])


def box_grid(random, count):
    side = max(2, round(count ** (1 / 3)))
    return np.stack(np.meshgrid(*3 * [np.arange(side)], indexing="ij"), -1).reshape(-1, 3) / 1024


def square(random, count):
    return on_lattice(random.random((count, 2)))


def clusters(random, count):
    centers = random.random((10, 2))
    return on_lattice(centers[random.integers(0, 10, count)] + 0.01 * random.standard_normal((count, 2)))


def square_grid(random, count):
    side = max(2, round(count**0.5))
    return np.stack(np.meshgrid(*2 * [np.arange(side)], indexing="ij"), -1).reshape(-1, 2) / 1024


# Contenders: points to (ids of the cells, ids of the vertices or None) -------------------------------------------------


def our_hull(threads):
    def run(points):
        hull = convex_hull(points, threads=threads)
        return hull.simplices, hull.vertices

    return run


def scipy_hull(points):
    from scipy.spatial import ConvexHull

    hull = ConvexHull(points)
    return hull.simplices, hull.vertices


def meshlib_hull(points):
    from meshlib import mrmeshnumpy, mrmeshpy

    mesh = mrmeshpy.makeConvexHull(mrmeshnumpy.pointCloudFromPoints(points))
    return mrmeshnumpy.getNumpyFaces(mesh.topology), mrmeshnumpy.getNumpyVerts(mesh)


def our_triangulation(threads):
    def run(points):
        found = regular_triangulation(points, threads=threads)
        return found.simplices, None

    return run


def scipy_triangulation(points):
    from scipy.spatial import Delaunay

    return Delaunay(points).simplices, None


def matplotlib_triangulation(points):
    from matplotlib.tri import Triangulation

    return Triangulation(points[:, 0], points[:, 1]).triangles, None


def shewchuk_triangulation(points):
    import triangle

    return triangle.triangulate({"vertices": points})["triangles"], None


# The judge --------------------------------------------------------------------------------------------------------


def judge_hull(points, cells, vertices):
    """Whether the true corners, and no others, are the vertices."""
    ours = convex_hull(points)
    if not ours.validate():
        raise SystemExit("our own hull is wrong")
    true = points[ours.vertices]
    if np.issubdtype(vertices.dtype, np.integer):
        found = points[np.unique(cells)]
    else:  # the places themselves
        found = vertices.astype(np.float64)
    order = lambda rows: rows[np.lexsort(rows.T)]  # noqa: E731
    return found.shape == true.shape and bool((order(found) == order(true)).all())


def turns(a, b, c):
    """Twice the area of abc, exactly: differences are below 2^22, so products are below 2^45."""
    return (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])


def in_circles(a, b, c, d):
    """Whether any d is inside the circle of its counter-clockwise abc: exact where doubles leave it open."""
    rows = [p - d for p in (a, b, c)]
    squares = [(row**2).sum(axis=1).astype(float) for row in rows]
    minors = [
        (rows[j][:, 0] * rows[k][:, 1] - rows[j][:, 1] * rows[k][:, 0]).astype(float) for j, k in ((1, 2), (2, 0), (0, 1))
    ]
    value = sum(square * minor for square, minor in zip(squares, minors))
    bound = 2.0**-48 * sum(np.abs(square * minor) for square, minor in zip(squares, minors))
    if (value > bound).any():
        return True
    open_ones = np.nonzero(np.abs(value) <= bound)[0]
    r = [[[int(x) for x in row[i]] for i in open_ones] for row in rows]
    for (ax, ay), (bx, by), (cx, cy) in zip(*r):
        sign = (
            (ax * ax + ay * ay) * (bx * cy - by * cx)
            + (bx * bx + by * by) * (cx * ay - cy * ax)
            + (cx * cx + cy * cy) * (ax * by - ay * bx)
        )
        if sign > 0:
            return True
    return False


def judge_triangulation(points, cells, _):
    """Whether the triangles are a Delaunay triangulation of all points (duplicates count once)."""
    places = np.round(points / UNIT).astype(np.int64)
    places -= places.min(axis=0)
    cells = np.array(cells, np.int64)
    turn = turns(*(places[cells[:, k]] for k in range(3)))
    cells[turn < 0] = cells[turn < 0][:, ::-1]
    if (turn == 0).any():
        return False
    halves = np.vstack([cells[:, [0, 1, 2]], cells[:, [1, 2, 0]], cells[:, [2, 0, 1]]])
    size = len(points)
    keys, twins = halves[:, 0] * size + halves[:, 1], halves[:, 1] * size + halves[:, 0]
    order = np.argsort(keys)
    if (np.diff(keys[order]) == 0).any():
        return False
    at = np.minimum(np.searchsorted(keys, twins, sorter=order), len(keys) - 1)
    inner = keys[order[at]] == twins
    # Euler: triangles = 2 * points - 2 - border, where every point is a vertex and the border is the hull's.
    border, shown = int((~inner).sum()), len(np.unique(places[np.unique(cells)], axis=0))
    if shown != len(np.unique(places, axis=0)) or len(cells) != 2 * shown - 2 - border:
        return False
    # The border's triangles must fill the hull: twice its area, in integers.
    ring = places[convex_hull(points).vertices]
    after = np.roll(ring, -1, axis=0)
    if int(np.abs(turn).sum()) != int((ring[:, 0] * after[:, 1] - ring[:, 1] * after[:, 0]).sum()):
        return False
    one, opposite = halves[inner], halves[order[at[inner]], 2]
    return not in_circles(*(places[one[:, k]] for k in range(3)), places[opposite])


SUBJECTS = {
    "hull": (
        {"ball": ball, "sphere": sphere, "grid": box_grid},
        {
            "vtkflipflop": our_hull(0),
            "vtkflipflop, 1 thread": our_hull(1),
            "scipy ConvexHull": scipy_hull,
            "meshlib": meshlib_hull,
        },
        judge_hull,
    ),
    "triangulation": (
        {"uniform": square, "clusters": clusters, "grid": square_grid},
        {
            "vtkflipflop": our_triangulation(0),
            "vtkflipflop, 1 thread": our_triangulation(1),
            "scipy Delaunay": scipy_triangulation,
            "matplotlib": matplotlib_triangulation,
            "triangle": shewchuk_triangulation,
        },
        judge_triangulation,
    ),
}


# Measuring --------------------------------------------------------------------------------------------------------


def measured(contenders, points, rounds):
    """Least seconds and the last result of each; None for one that raised an error."""
    seconds, results = {}, {}
    for _ in range(rounds):
        for name, call in contenders.items():
            if seconds.get(name, 0) is None:
                continue
            start = time.perf_counter()
            try:
                results[name] = call(points)
            except Exception as error:  # whatever a peer raises
                print(f"  {name}: {type(error).__name__}: {str(error)[:100]}", file=sys.stderr)
                seconds[name] = None
                continue
            took = time.perf_counter() - start
            seconds[name] = min(took, seconds.get(name, took))
    return seconds, results


def rows_of_subject(subject, sizes, rounds, limit):
    families, contenders, judge = SUBJECTS[subject]
    for family, make in families.items():
        left = dict(contenders)
        for size in sizes:
            points = make(np.random.default_rng(1), size)
            # Small ones are over sooner than the clock is sure of.
            seconds, results = measured(left, points, rounds * max(1, 20_000 // size))
            for name in left:
                took = seconds[name]
                right = "-" if took is None else "yes" if judge(points, *results[name]) else "NO"
                yield subject, family, len(points), name, took, right
            left = {name: call for name, call in left.items() if seconds[name] is None or seconds[name] < limit}


def row_of_small_calls():
    """What a call costs beyond the engine's own time, on the corners of a cube."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    count = 20_000
    for _ in range(1000):
        convex_hull(corners, threads=1)
    start = time.perf_counter()
    for _ in range(count):
        convex_hull(corners, threads=1)
    call = (time.perf_counter() - start) / count
    engine = min(convex_hull(corners, threads=1).statistics["seconds_total"] for _ in range(1000))
    return call, engine


def rows_of_batch(rounds):
    """10^5 hulls of 50 points: one call, a loop over ours, a loop over scipy's."""
    from scipy.spatial import ConvexHull

    sets, size = 100_000, 50
    points = np.random.default_rng(2).random((sets * size, 3))
    offsets = np.arange(0, len(points) + 1, size)
    parts = points.reshape(sets, size, 3)
    ways = {
        "vtkflipflop, one call": lambda _: convex_hulls(points, offsets).volumes,
        "vtkflipflop, one call, 1 thread": lambda _: convex_hulls(points, offsets, threads=1).volumes,
        "vtkflipflop, a loop": lambda _: np.array([convex_hull(part).volume for part in parts]),
        "scipy, a loop": lambda _: np.array([ConvexHull(part).volume for part in parts]),
    }
    seconds, results = measured(ways, points, rounds)
    expected = results["vtkflipflop, one call"]
    for name, took in seconds.items():
        right = "yes" if np.allclose(results[name], expected, rtol=1e-12) else "NO"
        yield "batch", "uniform", len(points), name, took, right


def markdown(rows):
    """A table for each subject and family: one line for each contender."""
    for subject, family in dict.fromkeys((row[0], row[1]) for row in rows):
        some = [row for row in rows if row[:2] == (subject, family)]
        sizes = list(dict.fromkeys(row[2] for row in some))
        print(f"\n| {subject}, {family} | " + " | ".join(f"{size:,}" for size in sizes) + " |")
        print("|---" * (len(sizes) + 1) + "|")
        for name in dict.fromkeys(row[3] for row in some):
            cells = []
            for size in sizes:
                found = [row for row in some if row[2:4] == (size, name)]
                took, right = found[0][4:] if found else (None, "")
                text = "" if took is None else f"{took * 1e3:.3g} ms"
                cells.append(f"{text} {'' if right == 'yes' else right}".strip() or "not asked")
            print(f"| {name} | " + " | ".join(cells) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sizes", default="1e2,1e3,1e4,1e5,1e6")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--limit", type=float, default=10.0, help="seconds")
    parser.add_argument("--csv")
    parser.add_argument("--markdown", action="store_true")
    arguments = parser.parse_args()
    sizes = [int(float(size)) for size in arguments.sizes.split(",")]

    packages = ", ".join(f"{name} {version(name)}" for name in ("vtkflipflop", "numpy", "scipy", "triangle", "meshlib"))
    print(f"{date.today()}, Python {platform.python_version()}, {packages}")
    call, engine = row_of_small_calls()
    print(f"a hull of 8 points: {call * 1e6:.1f} us a call, {engine * 1e6:.1f} us in the engine")
    rows = []
    for source in (*(rows_of_subject(s, sizes, arguments.rounds, arguments.limit) for s in SUBJECTS), rows_of_batch(1)):
        for row in source:
            rows.append(row)
            print(*row, sep=", ", flush=True)
    if arguments.csv:
        with open(arguments.csv, "w", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(("subject", "family", "points", "contender", "seconds", "right"))
            writer.writerows(rows)
    if arguments.markdown:
        markdown(rows)


if __name__ == "__main__":
    main()
