#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Python packages, run for the benchmarks: PeerProcess.cxx starts this.

    peers.py NAME THREADS PARTS

Commands come on the standard input, replies go to the standard output, lines with data behind them:

    points N, then x y z of each as doubles    ready
    run                                        done SECONDS PEAK ROUNDED POINTS CELLS CORNERS, then
                                               the points as doubles, offsets and corners as int64
    (whatever fails)                           error TEXT

The points are in the package's form before the clock starts; what is timed is the call. ROUNDED is 1
if the package returns floats. A batch of hulls, of PARTS points each, returns vertices without cells.
VTK with one thread has the backend Sequential, with more STDThread: its wheel has no other.
"""

import os
import sys
import time

import numpy as np


class Task:
    """run() is timed; result() is (points, cells, whether points are rounded to float)."""

    def __init__(self, points, threads, parts):
        self.points, self.threads, self.parts = points, threads, parts
        self.found = None


def function(columns):
    """A task from a function of an array of so many columns and the task, which returns cells of point ids."""

    def decorate(call):
        class Call(Task):
            def __init__(self, *arguments):
                super().__init__(*arguments)
                self.array = np.ascontiguousarray(self.points[:, :columns])

            def run(self):
                self.found = call(self.array, self)

            def result(self):
                return self.points, np.asarray(self.found), False

        return Call

    return decorate


@function(3)
def our_hull(points, task):
    from vtkflipflop.arrays import convex_hull

    return convex_hull(points, threads=task.threads).simplices


@function(2)
def our_triangulation(points, task):
    from vtkflipflop.arrays import regular_triangulation

    return regular_triangulation(points, threads=task.threads).simplices


@function(3)
def scipy_hull(points, _):
    from scipy.spatial import ConvexHull

    return ConvexHull(points).simplices


@function(2)
def scipy_triangulation(points, _):
    from scipy.spatial import Delaunay

    return Delaunay(points).simplices


@function(2)
def matplotlib_triangulation(points, _):
    from matplotlib.tri import Triangulation

    return Triangulation(points[:, 0], points[:, 1]).triangles


@function(2)
def triangle_triangulation(points, _):
    import triangle

    return triangle.triangulate({"vertices": points})["triangles"]


class MeshlibHull(Task):
    def run(self):
        from meshlib import mrmeshnumpy, mrmeshpy

        mesh = mrmeshpy.makeConvexHull(mrmeshnumpy.pointCloudFromPoints(self.points))
        self.found = mrmeshnumpy.getNumpyVerts(mesh), mrmeshnumpy.getNumpyFaces(mesh.topology)

    def result(self):
        return (*self.found, True)


class Batch(Task):
    """Hulls of sets of points; the result is their vertices."""

    def sets(self):
        return self.points[: len(self.points) // self.parts * self.parts].reshape(-1, self.parts, 3)

    def result(self):
        vertices = [part[ids] for part, ids in zip(self.sets(), self.found)]
        return np.concatenate(vertices), np.empty((0, 3), np.int64), False


class OurManyHulls(Batch):
    def run(self):
        from vtkflipflop.arrays import convex_hulls

        offsets = np.arange(0, len(self.sets()) * self.parts + 1, self.parts)
        self.hulls = convex_hulls(self.points[: offsets[-1]], offsets, threads=self.threads)

    def result(self):
        self.found = [hull.vertices for hull in self.hulls]
        return super().result()


class OurHullsInALoop(Batch):
    def run(self):
        from vtkflipflop.arrays import convex_hull

        self.found = [convex_hull(part, threads=self.threads).vertices for part in self.sets()]


class ScipyHullsInALoop(Batch):
    def run(self):
        from scipy.spatial import ConvexHull

        self.found = [ConvexHull(part).vertices for part in self.sets()]


class VtkTask(Task):
    """Update() of a new filter: last() makes it, and names the output port."""

    def __init__(self, *arguments):
        from vtkmodules.util.numpy_support import numpy_to_vtk
        from vtkmodules.vtkCommonCore import vtkObject, vtkPoints, vtkSMPTools
        from vtkmodules.vtkCommonDataModel import vtkPolyData

        super().__init__(*arguments)
        vtkObject.GlobalWarningDisplayOff()
        if not vtkSMPTools.SetBackend("Sequential" if self.threads == 1 else "STDThread"):
            raise RuntimeError("VTK has no such backend")
        vtkSMPTools.Initialize(self.threads)
        points = vtkPoints()
        points.SetData(numpy_to_vtk(self.points))
        self.cloud = vtkPolyData()
        self.cloud.SetPoints(points)
        self.filter, self.port = self.last()

    def run(self):
        self.filter.Update()

    def result(self):
        from vtkmodules.util.numpy_support import vtk_to_numpy

        output = self.filter.GetOutputDataObject(self.port)
        points = np.empty((0, 3))
        if output.GetNumberOfPoints():
            points = vtk_to_numpy(output.GetPoints().GetData())
        polys = output.GetPolys()
        cells = [np.empty(0, np.int64)] * 2
        if polys.GetNumberOfCells():
            cells = vtk_to_numpy(polys.GetOffsetsArray()), vtk_to_numpy(polys.GetConnectivityArray())
        return points, cells, points.dtype == np.float32


class VtkConvexHull(VtkTask):
    def last(self):
        from vtkmodules.vtkFiltersCore import vtkConvexHull

        hull = vtkConvexHull()
        hull.SetInputData(self.cloud)
        return hull, 0


class VtkDelaunay3D(VtkTask):
    """The hull is the surface of the tetrahedra."""

    def last(self):
        from vtkmodules.vtkFiltersCore import vtkDelaunay3D
        from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter

        tetrahedra = vtkDelaunay3D()
        tetrahedra.SetInputData(self.cloud)
        surface = vtkGeometryFilter()
        surface.SetInputConnection(tetrahedra.GetOutputPort())
        return surface, 0


class VtkDelaunay2D(VtkTask):
    def last(self):
        from vtkmodules.vtkFiltersCore import vtkDelaunay2D

        triangles = vtkDelaunay2D()
        triangles.SetInputData(self.cloud)
        return triangles, 0


class VtkDelaunay2DSorted(VtkDelaunay2D):
    """The same, the points inserted along Hilbert's curve."""

    def last(self):
        triangles, port = super().last()
        triangles.UseHilbertSorterOn()
        return triangles, port


class VtkVoronoiFlower2D(VtkTask):
    def last(self):
        from vtkmodules.vtkFiltersMeshing import vtkVoronoiFlower2D

        flower = vtkVoronoiFlower2D()
        flower.SetInputData(self.cloud)
        flower.SetOutputTypeToDelaunay()
        return flower, 1


TASKS = {
    "our-hull": our_hull,
    "our-triangulation": our_triangulation,
    "our-many-hulls": OurManyHulls,
    "our-hulls-in-a-loop": OurHullsInALoop,
    "scipy-hull": scipy_hull,
    "scipy-triangulation": scipy_triangulation,
    "scipy-hulls-in-a-loop": ScipyHullsInALoop,
    "matplotlib-triangulation": matplotlib_triangulation,
    "triangle-triangulation": triangle_triangulation,
    "meshlib-hull": MeshlibHull,
    "vtk-convex-hull": VtkConvexHull,
    "vtk-delaunay-3d": VtkDelaunay3D,
    "vtk-delaunay-2d": VtkDelaunay2D,
    "vtk-delaunay-2d-sorted": VtkDelaunay2DSorted,
    "vtk-voronoi-flower-2d": VtkVoronoiFlower2D,
}


def memory(field):
    """A field of /proc/self/status in bytes."""
    with open("/proc/self/status", encoding="ascii") as status:
        return next(1024 * int(line.split()[1]) for line in status if line.startswith(field + ":"))


def measure(task):
    """Seconds, and the peak of memory beyond what was resident before."""
    with open("/proc/self/clear_refs", "w", encoding="ascii") as file:
        file.write("5")  # the peak is the present now
    before = memory("VmRSS")
    start = time.perf_counter()
    task.run()
    return time.perf_counter() - start, memory("VmHWM") - before


def say(out, text):
    out.write(text.encode() + b"\n")
    out.flush()


def send(out, task):
    seconds, peak = measure(task)
    points, cells, rounded = task.result()
    if isinstance(cells, np.ndarray):  # triangles
        cells = np.arange(0, cells.size + 1, 3), cells.reshape(-1)
    offsets, corners = cells
    count = max(0, len(offsets) - 1)
    offsets = offsets if count else np.zeros(1)
    say(out, f"done {seconds:.9f} {peak} {int(rounded)} {len(points)} {count} {len(corners)}")
    for array, kind in ((points, np.float64), (offsets, np.int64), (corners, np.int64)):
        out.write(np.ascontiguousarray(array, kind).tobytes())
    out.flush()


def main():
    name, threads, parts = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    commands, out = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what a package prints is no reply
    points = None
    for line in iter(commands.readline, b""):
        words = line.decode().split()
        try:
            if words[0] == "points":
                data = bytearray(24 * int(words[1]))
                commands.readinto(data)
                points = np.frombuffer(data).reshape(-1, 3)
                task = TASKS[name](points, threads, parts)
                say(out, "ready")
            else:
                send(out, task)
        except Exception as error:  # pylint: disable=broad-exception-caught
            say(out, "error " + " ".join(repr(error).replace('"', "'").split()))


if __name__ == "__main__":
    main()
