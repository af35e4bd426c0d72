#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK's own filters, run for the benchmarks: VtkProcess.cxx starts this with VTK's newest wheel.

    vtk_contenders.py FILTER THREADS
    vtk_contenders.py --version

Commands come on the standard input, lines with data behind them; answers go to the standard output:

    points N, then x y z of each as doubles    ready
    run                                        done SECONDS PEAK ROUNDED POINTS CELLS CORNERS, then
                                               the points as doubles, offsets and corners as int64
    (whatever fails)                           error TEXT

The points are in VTK's memory before the clock starts; what is timed is Update() of a new filter.
One thread is VTK's backend Sequential, more are STDThread: the wheel has no other, and the first is
what it takes by itself.
"""
import sys
import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject, vtkPoints, vtkSMPTools, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkConvexHull, vtkDelaunay2D, vtkDelaunay3D
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkFiltersMeshing import vtkVoronoiFlower2D


def convex_hull(cloud):
    hull = vtkConvexHull()
    hull.SetInputData(cloud)
    return hull, 0


def delaunay_3d(cloud):
    """The hull is the surface of the tetrahedra."""
    tetrahedra = vtkDelaunay3D()
    tetrahedra.SetInputData(cloud)
    surface = vtkGeometryFilter()
    surface.SetInputConnection(tetrahedra.GetOutputPort())
    return surface, 0


def delaunay_2d(cloud):
    triangles = vtkDelaunay2D()
    triangles.SetInputData(cloud)
    return triangles, 0


def delaunay_2d_sorted(cloud):
    """The same, the points inserted along Hilbert's curve."""
    triangles, port = delaunay_2d(cloud)
    triangles.UseHilbertSorterOn()
    return triangles, port


def voronoi_flower_2d(cloud):
    flower = vtkVoronoiFlower2D()
    flower.SetInputData(cloud)
    flower.SetOutputTypeToDelaunay()
    return flower, 1


FILTERS = {
    "convex-hull": convex_hull,
    "delaunay-3d": delaunay_3d,
    "delaunay-2d": delaunay_2d,
    "delaunay-2d-sorted": delaunay_2d_sorted,
    "voronoi-flower-2d": voronoi_flower_2d,
}


def memory(field):
    """A field of /proc/self/status in bytes."""
    with open("/proc/self/status", encoding="ascii") as status:
        return next(1024 * int(line.split()[1]) for line in status if line.startswith(field + ":"))


def reset_peak():
    """Let VmHWM start again at what is resident now, and return that."""
    with open("/proc/self/clear_refs", "w", encoding="ascii") as file:
        file.write("5")
    return memory("VmRSS")


def cloud_of(coordinates):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(coordinates))
    cloud = vtkPolyData()
    cloud.SetPoints(points)
    return cloud


def run(make, cloud, out):
    last, port = make(cloud)
    before = reset_peak()
    start = time.perf_counter()
    last.Update()
    seconds = time.perf_counter() - start
    peak = memory("VmHWM") - before

    output = last.GetOutputDataObject(port)
    points, rounded = numpy.empty((0, 3)), 0
    if output.GetNumberOfPoints():
        given = vtk_to_numpy(output.GetPoints().GetData())
        points, rounded = given.astype(numpy.float64), int(given.dtype == numpy.float32)
    polys = output.GetPolys()
    offsets = numpy.zeros(1, numpy.int64)
    corners = numpy.empty(0, numpy.int64)
    if polys.GetNumberOfCells():
        offsets = vtk_to_numpy(polys.GetOffsetsArray()).astype(numpy.int64)
        corners = vtk_to_numpy(polys.GetConnectivityArray()).astype(numpy.int64)
    say(out, f"done {seconds:.9f} {peak} {rounded} {len(points)} {len(offsets) - 1} {len(corners)}")
    for array in (points, offsets, corners):
        out.write(numpy.ascontiguousarray(array).data.cast("B") if array.size else b"")
    out.flush()


def say(out, text):
    out.write(text.encode() + b"\n")
    out.flush()


def serve(make):
    commands, out = sys.stdin.buffer, sys.stdout.buffer
    coordinates = cloud = None  # VTK reads the coordinates in place
    for line in iter(commands.readline, b""):
        words = line.decode().split()
        try:
            if words[0] == "points":
                data = bytearray(24 * int(words[1]))
                commands.readinto(data)
                coordinates = numpy.frombuffer(data).reshape(-1, 3)
                cloud = cloud_of(coordinates)
                say(out, "ready")
            else:
                run(make, cloud, out)
        except Exception as error:  # pylint: disable=broad-exception-caught
            say(out, "error " + " ".join(repr(error).replace('"', "'").split()))


def main():
    if sys.argv[1] == "--version":
        print(vtkVersion.GetVTKVersion())
        return
    threads = int(sys.argv[2])
    if not vtkSMPTools.SetBackend("Sequential" if threads == 1 else "STDThread"):
        raise SystemExit("VTK has no such backend")
    vtkSMPTools.Initialize(threads)
    vtkObject.GlobalWarningDisplayOff()
    serve(FILTERS[sys.argv[1]])


if __name__ == "__main__":
    main()
