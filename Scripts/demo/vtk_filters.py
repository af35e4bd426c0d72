# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo's runs of the VTK filters."""
import time

from vtkmodules.vtkCommonDataModel import vtkDataObject

from vtkflipflop.vtkFiltersFlipFlop import vtkFFHullFilter, vtkFFPowerDiagramFilter, vtkFFRegularTriangulationFilter


def updated(filter):
    """The seconds that its run took."""
    start = time.perf_counter()
    filter.Update()
    seconds = time.perf_counter() - start
    if filter.GetErrorCode() != 0:
        raise SystemExit(f"{filter.GetClassName()} failed")
    return seconds


def hull(points):
    """The hull, its volume, the engine's name, and the seconds that took."""
    filter = vtkFFHullFilter()
    filter.SetInputData(points)
    filter.SetFacetMode(filter.FACETS_AS_POLYGONS)
    seconds = updated(filter)
    return filter.GetOutput(), filter.GetVolume(), filter.GetEngineUsedAsString(), seconds


def triangulation(points, weights=None, bounds=None):
    """(Triangulation, hidden points, power diagram if there are bounds), the engine's name, seconds."""
    filter = vtkFFRegularTriangulationFilter()
    filter.SetInputData(points)
    if weights:
        filter.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, weights)
    seconds = updated(filter)
    outputs = [filter.GetOutput(), filter.GetOutput(1)]
    if bounds:
        diagram = vtkFFPowerDiagramFilter()
        diagram.SetInputData(points)
        diagram.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, weights or "")
        diagram.SetPowerDiagramBounds(*bounds)
        diagram.SetPowerDiagramBoxMode(diagram.BOX_OF_BOUNDS)
        seconds += updated(diagram)
        outputs.append(diagram.GetOutput())
    return outputs, filter.GetEngineUsedAsString(), seconds
