# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The convex hull of a million points, written to a file: hull_of_points.py [hull.vtp]"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from vtkflipflop import vtkFFHullFilter

xyz = np.random.default_rng(1).standard_normal((1_000_000, 3))

points = vtkPoints()
points.SetData(numpy_to_vtk(xyz))
cloud = vtkPolyData()
cloud.SetPoints(points)

hull = vtkFFHullFilter()
hull.SetInputData(cloud)
hull.Update()

ids = vtk_to_numpy(hull.GetOutput().GetPointData().GetArray("vtkOriginalPointIds"))
triangles = vtk_to_numpy(hull.GetOutput().GetPolys().GetConnectivityArray()).reshape(-1, 3)
print(f"{len(xyz)} points, {len(ids)} vertices, {len(triangles)} triangles")
print(f"volume {hull.GetVolume():.3f}")
print(f"engine {hull.GetEngineUsedAsString()}, since {hull.GetEngineReason()}")
assert np.array_equal(vtk_to_numpy(hull.GetOutput().GetPoints().GetData()), xyz[ids])

writer = vtkXMLPolyDataWriter()
writer.SetInputConnection(hull.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "hull.vtp")
sys.exit(0 if writer.Write() else 1)
