# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The regular triangulation of disks: regular_triangulation.py [disks.vtp]"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from vtkflipflop import vtkFFRegularTriangulationFilter

# Disks of many sizes; a weight is a squared length, here that of the radius.
rng = np.random.default_rng(1)
xyz = np.column_stack([rng.random((100_000, 2)), np.zeros(100_000)])
radius = rng.exponential(0.002, 100_000)
weights = numpy_to_vtk(radius**2, deep=True)
weights.SetName("squared radius")

points = vtkPoints()
points.SetData(numpy_to_vtk(xyz))
disks = vtkPolyData()
disks.SetPoints(points)
disks.GetPointData().AddArray(weights)

triangulation = vtkFFRegularTriangulationFilter()
triangulation.SetInputData(disks)
triangulation.SetInputArrayToProcess(  # without: Delaunay
    0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "squared radius"
)
triangulation.Update()

shown = triangulation.GetOutput()
hidden = triangulation.GetOutput(1)
ids = vtk_to_numpy(hidden.GetPointData().GetArray("vtkOriginalPointIds"))
triangles = vtk_to_numpy(shown.GetPolys().GetConnectivityArray()).reshape(-1, 3)
print(f"{len(xyz)} disks: {shown.GetNumberOfPoints()} shown, {len(ids)} hidden")
print(f"{len(triangles)} triangles")
print(f"mean radius of the hidden {radius[ids].mean():.5f}, of all {radius.mean():.5f}")
assert shown.GetNumberOfPoints() + len(ids) == len(xyz)

writer = vtkXMLPolyDataWriter()
writer.SetInputConnection(triangulation.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "disks.vtp")
sys.exit(0 if writer.Write() else 1)
