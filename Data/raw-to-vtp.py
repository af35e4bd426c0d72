#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Write raw little-endian coordinates (x y z per point, no header) as a .vtp file.

    raw-to-vtp.py points.f32 points.vtp --elevation

float32 (.f32) stays float and float64 (.f64) stays double, bit for bit. Each point is a vertex cell, or ParaView
would show nothing. The data stands between its tags, not appended: ParaView 5.11 cannot read appended data where
expat has the fix of CVE-2023-52425.
"""
import argparse
import os

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

TYPES = {".f32": "<f4", ".f64": "<f8"}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("raw")
    parser.add_argument("vtp")
    parser.add_argument("--elevation", action="store_true", help="add z as a point data array")
    arguments = parser.parse_args()

    kind = TYPES[os.path.splitext(arguments.raw)[1]]
    xyz = numpy.fromfile(arguments.raw, dtype=kind).reshape(-1, 3)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(xyz, deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    vertices = vtkCellArray()
    vertices.SetData(
        numpy_to_vtk(numpy.arange(len(xyz) + 1, dtype=numpy.int32), deep=True),
        numpy_to_vtk(numpy.arange(len(xyz), dtype=numpy.int32), deep=True),
    )
    data.SetVerts(vertices)
    if arguments.elevation:
        elevation = numpy_to_vtk(numpy.ascontiguousarray(xyz[:, 2]), deep=True)
        elevation.SetName("Elevation")
        data.GetPointData().SetScalars(elevation)

    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(arguments.vtp)
    writer.SetInputData(data)
    writer.SetDataModeToBinary()
    writer.SetCompressorTypeToZLib()
    writer.SetCompressionLevel(9)
    if not writer.Write():
        raise SystemExit(f"cannot write {arguments.vtp}")

    reader = vtkXMLPolyDataReader()
    reader.SetFileName(arguments.vtp)
    reader.Update()
    back = vtk_to_numpy(reader.GetOutput().GetPoints().GetData())
    if back.dtype != xyz.dtype or back.tobytes() != xyz.tobytes():
        raise SystemExit(f"{arguments.vtp} does not hold the same bits")
    print(f"{arguments.vtp}: {len(xyz)} points, {back.dtype}")


if __name__ == "__main__":
    main()
