#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of a made terrain within a tolerance, by each package that is installed: vertices, triangles, seconds, error.
Then rasters of 4 ROWS^2 pixels of ROWS^2 random points, beside scipy's interpolators: seconds.

    terrain.py [ROWS [SHARE...]]

The terrain is an image of ROWS by ROWS heights (1000 by default), since pydelatin and vtkGreedyTerrainDecimation take
nothing else. For each SHARE of vertices (0.05 and 0.01) the tolerance is the one at which vtkflipflop keeps so many.
The error is the greatest vertical distance of a height from the mesh, by the same code for all.
"""

import importlib.metadata
import sys
import time

import numpy as np

REPETITIONS = 3


def terrain(rows):
    """Hills of all sizes, the higher the wider, and noise."""
    random = np.random.default_rng(2013)
    x, y = np.meshgrid(np.linspace(0, 1, rows), np.linspace(0, 1, rows))
    heights = random.normal(0, 0.02, (rows, rows))
    for octave in range(8):
        angles = random.uniform(0, 2 * np.pi, 3)
        for angle in angles:
            phase = 2.0 ** (octave + 1) * np.pi * (np.cos(angle) * x + np.sin(angle) * y) + angle
            heights += 100 / 2.5**octave * np.sin(phase)
    return np.float32(heights).astype(float)


def flipflop_mesh(heights, tolerance, **limits):
    from vtkflipflop.arrays import terrain_mesh

    rows, columns = np.indices(heights.shape).reshape(2, -1)
    points = np.column_stack([columns, rows]).astype(float)
    begin = time.perf_counter()
    mesh = terrain_mesh(points, heights.ravel(), tolerance=tolerance, threads=1, **limits)
    seconds = time.perf_counter() - begin
    return seconds, points[mesh.vertices], np.searchsorted(mesh.vertices, mesh.simplices), mesh


def pydelatin_mesh(heights, tolerance):
    from pydelatin import Delatin

    begin = time.perf_counter()
    mesh = Delatin(np.float32(heights), max_error=tolerance)
    triangles = mesh.triangles
    seconds = time.perf_counter() - begin
    xy = np.asarray(mesh.vertices, float).reshape(-1, 3)[:, :2]
    xy[:, 1] = len(heights) - 1 - xy[:, 1]  # it has the first row at the top
    return seconds, xy, np.asarray(triangles).reshape(-1, 3)


def vtk_mesh(heights, tolerance):
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkCommonDataModel import vtkImageData
    from vtkmodules.vtkFiltersHybrid import vtkGreedyTerrainDecimation

    image = vtkImageData()
    image.SetDimensions(heights.shape[1], heights.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(heights.ravel()))
    decimation = vtkGreedyTerrainDecimation()
    decimation.SetInputData(image)
    decimation.SetErrorMeasureToAbsoluteError()
    decimation.SetAbsoluteError(tolerance)
    decimation.BoundaryVertexDeletionOff()
    begin = time.perf_counter()
    decimation.Update()
    seconds = time.perf_counter() - begin
    mesh = decimation.GetOutput()
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return seconds, vtk_to_numpy(mesh.GetPoints().GetData())[:, :2].astype(float), triangles


def greatest_error(heights, xy, triangles):
    """In double, over all heights in each triangle; infinite where a height is in none."""
    errors = np.full(heights.shape, np.inf)
    z = heights[xy[:, 1].astype(int), xy[:, 0].astype(int)]
    for a, b, c in triangles:
        (left, low), (right, high) = xy[[a, b, c]].min(0).astype(int), xy[[a, b, c]].max(0).astype(int)
        x, y = np.meshgrid(np.arange(left, right + 1), np.arange(low, high + 1))
        (ux, uy), (vx, vy) = xy[b] - xy[a], xy[c] - xy[a]
        wx, wy, area = x - xy[a, 0], y - xy[a, 1], ux * vy - uy * vx
        s, t = (wx * vy - wy * vx) / area, (ux * wy - uy * wx) / area
        inside = (s >= 0) & (t >= 0) & (s + t <= 1)
        found = abs(heights[y, x] - z[a] - s * (z[b] - z[a]) - t * (z[c] - z[a]))
        errors[y[inside], x[inside]] = found[inside]
    return errors.max()


def fastest(make):
    seconds = []
    for _ in range(REPETITIONS):
        begin = time.perf_counter()
        make()
        seconds.append(time.perf_counter() - begin)
    return min(seconds)


def rasters(rows):
    """Seconds of each method, once all that does not depend on the pixels is built."""
    from vtkflipflop.arrays import regular_triangulation

    random = np.random.default_rng(2014)
    points = random.random((rows * rows, 2))
    values = np.sin(10 * points[:, 0]) * np.cos(20 * points[:, 1])
    triangulation = regular_triangulation(points)
    shape = (2 * rows, 2 * rows)
    pixels = np.column_stack([axis.ravel() for axis in np.meshgrid(*[np.linspace(0.001, 0.999, 2 * rows)] * 2)])
    print("method,package,threads,seconds")
    for threads in (1, 2):
        for method in ("linear", "natural", "clough-tocher"):
            seconds = fastest(lambda: triangulation.to_image(values, shape=shape, method=method, threads=threads))
            print(f"{method},vtkflipflop to_image,{threads},{seconds:.3f}", flush=True)
        seconds = fastest(lambda: triangulation.interpolate(values, pixels, threads=threads))
        print(f"linear,vtkflipflop interpolate,{threads},{seconds:.3f}", flush=True)
    try:
        from scipy.interpolate import CloughTocher2DInterpolator, LinearNDInterpolator
        from scipy.spatial import Delaunay
    except ImportError:
        return
    tree = Delaunay(points)
    for method, kind in (("linear", LinearNDInterpolator), ("clough-tocher", CloughTocher2DInterpolator)):
        interpolator = kind(tree, values)
        print(f"{method},scipy,1,{fastest(lambda: interpolator(pixels)):.3f}", flush=True)


def main(rows=1000, *shares):
    heights = terrain(int(rows))
    programs = {"vtkflipflop": flipflop_mesh, "pydelatin": pydelatin_mesh, "vtk": vtk_mesh}
    print(f"# terrain.py {rows}, numpy seed 2013, {REPETITIONS} repetitions, the fastest; one thread")
    print("tolerance,package,version,vertices,triangles,seconds,greatest error")
    for share in map(float, shares or (0.05, 0.01)):
        tolerance = flipflop_mesh(heights, 0.0, max_vertices=int(share * heights.size))[3].greatest_error
        for package, make in programs.items():
            try:
                version = importlib.metadata.version(package)
            except importlib.metadata.PackageNotFoundError:
                continue
            runs = [make(heights, tolerance)[:3] for _ in range(REPETITIONS)]
            seconds, xy, triangles = min(runs, key=lambda run: run[0])
            counts = f"{len(xy)},{len(triangles)}"
            error = greatest_error(heights, xy, triangles)
            print(f"{tolerance:.6g},{package},{version},{counts},{seconds:.3f},{error:.6g}", flush=True)
    rasters(int(rows))


if __name__ == "__main__":
    main(*sys.argv[1:])
