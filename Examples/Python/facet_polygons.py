# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A hull of true facets, which keeps the points' data: facet_polygons.py [facets.vtp]"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from vtkflipflop import vtkFFHullFilter

# A grid of 11 x 11 x 11 points, with a temperature at each.
z, y, x = np.mgrid[0:11, 0:11, 0:11]
xyz = np.column_stack([x.ravel(), y.ravel(), z.ravel()]).astype(np.float64)
temperature = numpy_to_vtk(20.0 + 0.5 * xyz[:, 2])
temperature.SetName("temperature")

points = vtkPoints()
points.SetData(numpy_to_vtk(xyz))
grid = vtkPolyData()
grid.SetPoints(points)
grid.GetPointData().SetScalars(temperature)

# The hull is a cube: six polygons, eight points, however many points lie in its sides.
hull = vtkFFHullFilter()
hull.SetInputData(grid)
hull.SetFacetMode(hull.FACETS_AS_POLYGONS)
hull.Update()

cube = hull.GetOutput()
ids = vtk_to_numpy(cube.GetPointData().GetArray("vtkOriginalPointIds"))
kept = vtk_to_numpy(cube.GetPointData().GetScalars())
for i, degrees in zip(ids, kept):
    print(f"input point {i}: {degrees} degrees")
print(cube.GetNumberOfPolys(), "facets")
assert cube.GetNumberOfPolys() == 6 and cube.GetNumberOfPoints() == 8

writer = vtkXMLPolyDataWriter()
writer.SetInputConnection(hull.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "facets.vtp")
sys.exit(0 if writer.Write() else 1)
