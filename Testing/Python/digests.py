# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A digest of each part of an output, the same wherever its bits are the same."""

import hashlib

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

# Of a run's report, what the input and the settings alone decide; the rest tells of the work and of the machine.
OF_THE_RESULT = {
    f"FlipFlop{name}"
    for name in ("Dimension", "Engine", "EngineReason", "Points", "NonFinite", "Volume", "Area", "HiddenPoints",
                 "DroppedCells", "SplitPoints")
}  # fmt: skip
CELLS = ("Verts", "Lines", "Polys", "Strips")


def leaves(data):
    """The leaves of a composite by their flat indices, None for a missing one; of other data, itself at 0."""
    if not data.IsA("vtkDataObjectTree"):
        return {0: data}
    found = {}
    iterator = data.NewTreeIterator()
    iterator.SkipEmptyNodesOff()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        found[iterator.GetCurrentFlatIndex()] = iterator.GetCurrentDataObject()
        iterator.GoToNextItem()
    return found


def number_of_points(data):
    return sum(leaf.GetNumberOfPoints() for leaf in leaves(data).values() if leaf)


def arrays(fields):
    return [fields.GetAbstractArray(i) for i in range(fields.GetNumberOfArrays())]


def describe(array):
    return f"{array.GetName()} {array.GetDataTypeAsString()} {array.GetNumberOfComponents()}"


def content(array):
    """The bytes of an array."""
    if array.IsA("vtkStringArray"):
        return repr([array.GetValue(i) for i in range(array.GetNumberOfValues())]).encode()
    return numpy.ascontiguousarray(vtk_to_numpy(array)).tobytes()


def parts(poly):
    """What makes up a polygonal data set, as pairs of a name and bytes."""
    if poly.GetNumberOfPoints():
        points = poly.GetPoints().GetData()
        yield f"points {points.GetDataTypeAsString()}", content(points)
    for kind in CELLS:
        cells = getattr(poly, f"Get{kind}")()
        for name in ("Offsets", "Connectivity") if cells.GetNumberOfCells() else ():
            # How wide the ids are stored may change on the way to a client.
            ids = vtk_to_numpy(getattr(cells, f"Get{name}Array")()).astype(numpy.int64)
            yield f"{kind} {name}", ids.tobytes()
    for name in ("Point", "Cell", "Field"):
        for array in arrays(getattr(poly, f"Get{name}Data")()):
            if name != "Field" or not array.GetName().startswith("FlipFlop") or array.GetName() in OF_THE_RESULT:
                yield f"{name} data {describe(array)}", content(array)


def digest(data):
    """A SHA-256 of each part of polygonal data, or of a composite of such: all that is repeatable."""
    found = {"class": data.GetClassName()}
    for index, leaf in leaves(data).items():
        found[f"{index} missing"] = leaf is None
        for name, value in parts(leaf) if leaf else ():
            found[f"{index} {name}"] = hashlib.sha256(value).hexdigest()
    return found
