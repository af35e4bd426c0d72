# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests see of data and of messages, in whatever process: a client, a server's rank, plain Python."""

import hashlib
import re

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow

UNREPEATABLE = ("FlipFlopSeconds", "FlipFlopThreads")
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
            if array.GetName() not in UNREPEATABLE:
                yield f"{name} data {describe(array)}", content(array)


def digest(data):
    """A SHA-256 of each part of polygonal data, or of a composite of such: all that is repeatable."""
    found = {"class": data.GetClassName()}
    for index, leaf in leaves(data).items():
        found[f"{index} missing"] = leaf is None
        for name, value in parts(leaf) if leaf else ():
            found[f"{index} {name}"] = hashlib.sha256(value).hexdigest()
    return found


def of_field(data, name):
    """The one value of a field data array, for each leaf that has it."""
    found = [leaf.GetFieldData().GetAbstractArray(name) for leaf in leaves(data).values() if leaf]
    return [array.GetValue(0) for array in found if array]


class Messages:
    """Errors and warnings that reach this process's output window, as pairs of a kind and its words."""

    def __init__(self):
        self.told = []
        for kind in ("Error", "Warning"):
            vtkOutputWindow.GetInstance().AddObserver(f"{kind}Event", self._observer(kind))

    def _observer(self, kind):
        def observe(caller, event, text):
            # What VTK puts before the words is the source line, the class and the object.
            for words in re.findall(r"\(0x[0-9a-f]+\): (.*)", text) or [text.strip()]:
                self.told.append((kind, words))

        observe.CallDataType = "string0"
        return observe

    def take(self):
        """All since the last call."""
        told, self.told = self.told, []
        return told
