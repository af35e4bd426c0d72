#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes without small angles, by refined_mesh() and by Triangle (the package triangle): a row of CSV for each.

    meshes.py [--picture FILE] [INPUT...]

The inputs are files of GeoJSON, of which all that rings enclose is meshed; or by name Triangle's own samples, and Greenland, which come with its package; the contours of Data/; a made coast
of 1e5 corners with islands; and the unit square with triangles of at most 1e-6. All by default. "thin" counts the
triangles below the least angle, but for rounding; seconds are the best of three, on one thread. The picture has the
least angles of all triangles of some of the inputs.
"""

import argparse
import json
import pathlib
import time

import numpy as np
import triangle
from vtkflipflop.arrays import constrained_triangulation, refined_mesh

ANGLES = (20.0, 25.0, 30.0, 33.0)
SAMPLES = ("face", "A", "la", "double_hex", "box", "greenland")
DRAWN = (("la", 30.0), ("greenland", 30.0), ("contours", 30.0))
REPETITIONS = 3


def of_triangle(name):
    """Points, segments and holes of a sample; of a triangulation, its border."""
    data = triangle.get_data(name)
    points = np.asarray(data["vertices"], float)
    if "segments" in data:
        segments = np.asarray(data["segments"])
        if name == "box":  # it has one side of four
            segments = np.concatenate([segments, [[1, 3], [3, 2], [2, 0]]])
        return points, segments, np.asarray(data.get("holes", np.empty((0, 2))), float)
    cells = np.asarray(data["triangles"])
    edges, counts = np.unique(np.sort(cells[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1), axis=0, return_counts=True)
    border = edges[counts == 1]
    used, border = np.unique(border, return_inverse=True)
    return points[used], border.reshape(-1, 2), np.empty((0, 2))


def contours():
    """Lines of one height, and a box around them; without a second point at a position."""
    path = pathlib.Path(__file__).parent.parent / "Data" / "sainthelens-contours.f32"
    rows = np.fromfile(path, np.float32).reshape(-1, 2).astype(float)
    is_point = ~np.isnan(rows[:, 0])
    low, high = rows[is_point].min(axis=0) - 50, rows[is_point].max(axis=0) + 50
    box = np.array([low, [high[0], low[1]], high, [low[0], high[1]]])
    points, ids = np.unique(np.concatenate([rows[is_point], box]), axis=0, return_inverse=True)
    number = np.cumsum(is_point) - 1
    pairs = np.flatnonzero(is_point[:-1] & is_point[1:])
    segments = np.concatenate([np.column_stack([number[pairs], number[pairs + 1]]), ring(box, is_point.sum())])
    segments = ids.ravel()[segments]
    segments = np.unique(np.sort(segments[segments[:, 0] != segments[:, 1]], axis=1), axis=0)
    return points, segments, np.empty((0, 2))


def ring(corners, begin):
    ids = np.arange(begin, begin + len(corners))
    return np.column_stack([ids, np.roll(ids, -1)])


def coast(count=100_000):
    """A coast, by the middles of sides that are moved again and again; and islands like it."""
    random = np.random.default_rng(2024)

    def shore(corners, center, radius):
        angles = np.linspace(0, 2 * np.pi, 8, endpoint=False)
        line = center + radius * np.column_stack([np.cos(angles), np.sin(angles)])
        while 2 * len(line) <= corners:
            sides = np.roll(line, -1, axis=0) - line
            moved = 0.5 * (line + np.roll(line, -1, axis=0))
            moved += random.uniform(-0.12, 0.12, (len(line), 1)) * sides[:, ::-1] * [1, -1]
            line = np.stack([line, moved], axis=1).reshape(-1, 2)
        return line

    shores = [shore(count - count // 4, [0, 0], 100.0)]
    for x in (-40, 0, 40):
        for y in (-40, 0, 40):
            shores.append(shore(count // 36, [x, y], 12.0))
    points = np.concatenate(shores)
    begins = np.cumsum([0, *map(len, shores)])
    segments = np.concatenate([ring(line, begin) for line, begin in zip(shores, begins)])
    return points, segments, np.array([[x, y] for x in (-40, 0, 40) for y in (-40, 0, 40)], float)


def of_file(path):
    """The rings of a file of GeoJSON, divided where they meet."""
    found = constrained_triangulation([], json.loads(pathlib.Path(path).read_text()))
    return found.points.copy(), np.unique(np.sort(found.constraints, axis=1), axis=0), np.empty((0, 2))


def square():
    points = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])
    return points, ring(points, 0), np.empty((0, 2))


def flipflop_mesh(points, segments, holes, angle, area):
    mesh = refined_mesh(points, constraints=segments, holes=holes, minimum_angle=angle, maximum_area=area, threads=1)
    return mesh.points, mesh.simplices


def triangle_mesh(points, segments, holes, angle, area):
    given = {"vertices": points, "segments": segments}
    if len(holes):
        given["holes"] = holes
    mesh = triangle.triangulate(given, f"pq{angle:g}" + (f"a{area:.12f}" if area else ""))
    return mesh["vertices"], mesh["triangles"]


def least_angles(points, cells):
    corners = points[cells]
    least = np.full(len(cells), 180.0)
    for i in range(3):
        u, v = (corners[:, (i + k) % 3] - corners[:, i] for k in (1, 2))
        cross = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
        least = np.minimum(least, np.degrees(np.arctan2(np.abs(cross), (u * v).sum(axis=1))))
    return least


def measured(mesh, *arguments):
    best = np.inf
    for _ in range(REPETITIONS):
        begin = time.perf_counter()
        found = mesh(*arguments)
        best = min(best, time.perf_counter() - begin)
        if best > 5:
            break
    return best, *found


def draw(histograms, path):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, len(histograms), figsize=(3.6 * len(histograms), 2.6), dpi=90)
    for ax, ((name, angle), of) in zip(axes, histograms.items()):
        for (package, angles), colour in zip(of.items(), ("#1f77b4", "#ff7f0e")):
            ax.hist(angles, np.arange(0, 61, 2), histtype="step", linewidth=1.6, color=colour,
                    label=f"{package}, {len(angles):,}")
        ax.axvline(angle, color="#999999", linewidth=0.8, linestyle="--")
        ax.set_title(name, fontsize=9)
        ax.set_xlabel("least angle, degrees", fontsize=8)
        ax.tick_params(labelsize=7)
        ax.legend(fontsize=6.5, loc="upper left")
    axes[0].set_ylabel("triangles", fontsize=8)
    figure.tight_layout()
    figure.savefig(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("inputs", nargs="*", default=[*SAMPLES, "contours", "coast", "square"])
    parser.add_argument("--picture")
    arguments = parser.parse_args()
    made = {"contours": contours, "coast": coast, "square": square}
    histograms = {}
    print("input,corners,angle,area,package,triangles,least,thin,seconds")
    for name in arguments.inputs:
        graph = made[name]() if name in made else of_file(name) if "." in name else of_triangle(name)
        cases = [(30.0, 1e-6)] if name == "square" else [(angle, None) for angle in ANGLES]
        for angle, area in cases:
            for package, mesh in (("vtkflipflop", flipflop_mesh), ("triangle", triangle_mesh)):
                seconds, points, cells = measured(mesh, *graph, angle, area)
                angles = least_angles(points, cells)
                thin = int((angles < angle - 1e-6).sum())
                row = f"{len(graph[0])},{angle:g},{area or ''},{package},{len(cells)},{angles.min():.2f},{thin},{seconds:.4f}"
                print(f"{pathlib.Path(name).stem},{row}", flush=True)
                if (name, angle) in DRAWN:
                    histograms.setdefault((name, angle), {})[package] = angles
    if arguments.picture:
        draw(histograms, arguments.picture)


if __name__ == "__main__":
    main()
