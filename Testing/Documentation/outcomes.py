# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the filters make of points, in the words of Exactness.md's tables.

Points are written `x y z` or `x y z w`, one after another with ; between. A cell is its corners'
ids: `0-1-2`. Facets are polygons.
"""

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData

from vtkflipflop import vtkFFHullFilter, vtkFFPowerDiagramFilter, vtkFFRegularTriangulationFilter

NOTHING = "nothing"


def poly_data(text):
    """Points as they are written; with an array "weight" if any has one."""
    rows = [[float(number) for number in point.split()] for point in text.split(";")]
    rows = [row for row in rows if row]
    points, weights = vtkPoints(), vtkDoubleArray()
    points.SetDataTypeToDouble()
    weights.SetName("weight")
    for row in rows:
        points.InsertNextPoint(row[:3])
        weights.InsertNextValue(row[3] if len(row) > 3 else 0.0)
    data = vtkPolyData()
    data.SetPoints(points)
    if any(len(row) > 3 for row in rows):
        data.GetPointData().AddArray(weights)
    return data


def messages_while_updating(algorithm, event):
    """The sentences of the event, ErrorEvent or WarningEvent, without VTK's preamble."""
    messages = []

    def observe(caller, event, message):
        messages.append(message.split("): ", 1)[1].strip())

    observe.CallDataType = "string0"
    algorithm.AddObserver(event, observe)
    algorithm.Update()
    return messages


def errors_while_updating(algorithm):
    return messages_while_updating(algorithm, "ErrorEvent")


def ids(attributes):
    array = attributes.GetArray("vtkOriginalPointIds")
    return [int(array.GetValue(i)) for i in range(array.GetNumberOfTuples())]


def cells(output):
    """`0-1-2` of each cell, in its original ids."""
    names = ids(output.GetPointData())
    for i in range(output.GetNumberOfCells()):
        corners = output.GetCell(i).GetPointIds()
        chain = (str(names[corners.GetId(k)]) for k in range(corners.GetNumberOfIds()))
        yield "`" + "-".join(chain) + "`"


def outcome(algorithm):
    """(dimension and cells, or the error) of a filter that is set up."""
    messages = errors_while_updating(algorithm)
    if messages:
        assert algorithm.GetOutput().GetNumberOfPoints() == 0
        return "error: " + messages[0].split(":")[0]
    found = " ".join(cells(algorithm.GetOutput())) or NOTHING
    return f"{algorithm.GetDimension()}: {found}"


def use_weights(triangulation):
    triangulation.SetInputArrayToProcess(
        0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "weight"
    )
    return triangulation


def hull_of(data, ignore=False):
    hull = vtkFFHullFilter()
    hull.SetNonFinitePoints(ignore)
    hull.SetFacetMode(hull.FACETS_AS_POLYGONS)
    hull.SetInputData(data)
    return outcome(hull)


def triangulation_of(data, ignore=False):
    """(the triangulation, ids of the hidden points, ids of the points with a power cell)"""
    triangulation = vtkFFRegularTriangulationFilter()
    triangulation.SetNonFinitePoints(ignore)
    triangulation.SetFacetMode(triangulation.FACETS_AS_POLYGONS)
    diagram = vtkFFPowerDiagramFilter()
    diagram.SetNonFinitePoints(ignore)
    diagram.SetInputData(data)
    if data.GetPointData().HasArray("weight"):
        use_weights(triangulation)
        use_weights(diagram)
    triangulation.SetInputData(data)
    found = outcome(triangulation)
    if found.startswith("error"):
        return found, "", ""
    hidden = ids(triangulation.GetOutput(1).GetPointData())
    diagram.Update()
    sites = ids(diagram.GetOutput().GetCellData())
    return found, " ".join(map(str, hidden)), " ".join(map(str, sites))
