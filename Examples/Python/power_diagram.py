# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Voronoi diagram of points, with their data on its cells: power_diagram.py [cells.vtp]"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from vtkflipflop import vtkFFPowerDiagramFilter

# Gauges with the rain that each has measured.
rng = np.random.default_rng(1)
xyz = np.column_stack([rng.random((1000, 2)), np.zeros(1000)])
rain = numpy_to_vtk(20.0 + 10.0 * np.sin(5.0 * xyz[:, 0]), deep=True)
rain.SetName("rain")

points = vtkPoints()
points.SetData(numpy_to_vtk(xyz))
gauges = vtkPolyData()
gauges.SetPoints(points)
gauges.GetPointData().SetScalars(rain)

# The places nearest to each gauge: Voronoi cells, or power cells if the gauges had weights.
diagram = vtkFFPowerDiagramFilter()
diagram.SetInputData(gauges)
diagram.SetPowerDiagramBounds(0.0, 1.0, 0.0, 1.0)
diagram.SetPowerDiagramBoxMode(diagram.BOX_OF_BOUNDS)
diagram.Update()

cells = diagram.GetOutput()
corners = vtk_to_numpy(cells.GetPoints().GetData())
offsets = vtk_to_numpy(cells.GetPolys().GetOffsetsArray())
connectivity = vtk_to_numpy(cells.GetPolys().GetConnectivityArray())
areas = []
for begin, end in zip(offsets[:-1], offsets[1:]):
    x, y, _ = corners[connectivity[begin:end]].T
    areas.append(0.5 * np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))
areas = np.array(areas)
mean = np.sum(areas * vtk_to_numpy(cells.GetCellData().GetArray("rain")))
print(f"{cells.GetNumberOfCells()} cells, area {areas.sum():.6f}, rain on average {mean:.3f}")
assert abs(areas.sum() - 1.0) < 1e-9

writer = vtkXMLPolyDataWriter()
writer.SetInputConnection(diagram.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "cells.vtp")
sys.exit(0 if writer.Write() else 1)
