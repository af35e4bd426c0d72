# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A dented sphere to its convex hull, by flips: convexify_surface.py [convex.vtp]"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from vtkflipflop import vtkFFConvexifyFilter

sphere = vtkSphereSource()
sphere.SetRadius(1.0)
sphere.SetThetaResolution(100)
sphere.SetPhiResolution(100)
sphere.SetOutputPointsPrecision(vtkAlgorithm.DOUBLE_PRECISION)
sphere.Update()

# Waves in the radius: the surface stays star-shaped from the centre.
dented = sphere.GetOutput()
xyz = vtk_to_numpy(dented.GetPoints().GetData())
radius = 1.0 + 0.2 * np.sin(9.0 * xyz[:, 0]) * np.cos(7.0 * xyz[:, 2])
dented.GetPoints().SetData(numpy_to_vtk(xyz * radius[:, None], deep=True))

convexify = vtkFFConvexifyFilter()
convexify.SetInputData(dented)
convexify.SetKernelPoint(0.0, 0.0, 0.0)
convexify.UseKernelPointOn()  # without it, a kernel point is sought
convexify.SetReportAsFieldData(True)
convexify.Update()
if convexify.GetErrorCode() != 0:
    sys.exit(1)  # the filter has said what is wrong, and where

print(f"{dented.GetNumberOfPoints()} -> {convexify.GetOutput().GetNumberOfPoints()} vertices")
report = convexify.GetOutput().GetFieldData()
flips = [report.GetArray("FlipFlop" + name).GetValue(0) for name in ("Flips22", "Flips31")]
print(f"{flips[0]} flips 2-2, {flips[1]} flips 3-1")
print(f"volume {convexify.GetVolume():.3f}")

writer = vtkXMLPolyDataWriter()
writer.SetInputConnection(convexify.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "convex.vtp")
sys.exit(0 if writer.Write() else 1)
