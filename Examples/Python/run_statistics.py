# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What runs report, for the real points of Data/: run_statistics.py [hull.vtp]

Documentation/Statistics.md shows what this prints, and says what it means.
"""

import os
import sys

from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

from vtkflipflop import vtkFFHullFilter, vtkFFRegularTriangulationFilter

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")


def reader_of(name):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(os.path.join(DATA, name))
    reader.Update()
    return reader


st_helens, autzen = reader_of("sainthelens.vtp"), reader_of("autzen.vtp")
points = autzen.GetOutput().GetPointData()
weights = numpy_to_vtk(-60.0 * vtk_to_numpy(points.GetArray("Elevation")), deep=True)
weights.SetName("weight")  # low points are heavy, and hide higher ones
points.AddArray(weights)

hull = vtkFFHullFilter()
hull.SetInputConnection(st_helens.GetOutputPort())

delaunay = vtkFFRegularTriangulationFilter()
delaunay.SetInputConnection(st_helens.GetOutputPort())

regular, unbiased = vtkFFRegularTriangulationFilter(), vtkFFRegularTriangulationFilter()
for triangulation in (regular, unbiased):
    triangulation.SetInputConnection(autzen.GetOutputPort())
    triangulation.SetInputArrayToProcess(0, 0, 0, 0, "weight")
unbiased.SetVBiased(False)  # vertices are labelled at once

runs = [hull, delaunay, regular, unbiased]
for run in runs:
    run.SetNumberOfThreads(1)
    run.SetReportAsFieldData(True)
    run.Update()


def row(name, figures):
    print(f"{name:26}" + "".join(f"{figure:>12}" for figure in figures))


row("", ["hull", "Delaunay", "weighted", "unbiased"])
row("points of the output", [run.GetOutput().GetNumberOfPoints() for run in runs])
reports = [run.GetOutput().GetFieldData() for run in runs]
for count in (
    ["Points", "NonFinite", "Culled", "Insertions", "Moves", "Flips22", "Flips31", "FlipsV"]
    + ["FlipsD", "Labelled", "Redundant", "EdgeChecks", "ExactCalls"]
):
    row("FlipFlop" + count, [report.GetArray("FlipFlop" + count).GetValue(0) for report in reports])
for stage in ("Scan", "Locate", "Grow", "Flip", "Finish", "Total"):
    seconds = [report.GetArray("FlipFlopSeconds" + stage).GetValue(0) for report in reports]
    row("FlipFlopSeconds" + stage, [f"{value:.4f}" for value in seconds])

# The report is in the file, for those who open it.
writer = vtkXMLPolyDataWriter()
writer.SetInputConnection(hull.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "hull.vtp")
sys.exit(0 if writer.Write() else 1)
