# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the plugin's tests share: sources to feed filters with, and what comes out of these."""

import contextlib
import os
import tempfile

import numpy as np
from paraview import servermanager, simple
from vtkflipflop import vtkFFAlgorithm
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

SOURCE = os.environ["FLIPFLOP_SOURCE"]
IDS = "vtkOriginalPointIds"


def poly_data(xyz, triangles=(), **arrays):
    """A vtkPolyData of points, triangles between them, and point arrays."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(xyz, dtype=float), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    cells = vtkCellArray()
    for triangle in triangles:
        cells.InsertNextCell(len(triangle), [int(i) for i in triangle])
    data.SetPolys(cells)
    for name, values in arrays.items():
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    return data


def producer(data):
    """Data made here as a source of the pipeline."""
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    source.UpdatePipeline()
    return source


def cloud(xyz, triangles=(), **arrays):
    return producer(poly_data(xyz, triangles, **arrays))


def real(name):
    """A file of Data/, read by ParaView."""
    source = simple.XMLPolyDataReader(FileName=[os.path.join(SOURCE, "Data", name + ".vtp")])
    source.UpdatePipeline()
    return source


def run(proxy):
    """The proxy after its run."""
    proxy.UpdatePipeline()
    return proxy


def report(proxy):
    """The filter itself, which has the report of the last run."""
    found = proxy.GetClientSideObject()
    assert isinstance(found, vtkFFAlgorithm)
    return found


def fetch(proxy, port=0):
    return servermanager.Fetch(proxy, idx=port)


def coordinates(data):
    return vtk_to_numpy(data.GetPoints().GetData()) if data.GetNumberOfPoints() else np.empty((0, 3))


def array(attributes, name):
    return vtk_to_numpy(attributes.GetArray(name))


def cells(cell_array):
    """The corners of each cell, as tuples."""
    offsets = vtk_to_numpy(cell_array.GetOffsetsArray())
    corners = vtk_to_numpy(cell_array.GetConnectivityArray())
    return [tuple(corners[a:b]) for a, b in zip(offsets[:-1], offsets[1:])]


def cells_by_ids(data, cell_array=None):
    """The cells (by default the polygons), their corners named by their ids in the input."""
    ids = array(data.GetPointData(), IDS)
    return [tuple(ids[list(cell)]) for cell in cells(cell_array or data.GetPolys())]


def bits(data):
    """All that a vtkPolyData of polygons consists of, to be compared with another."""
    attributes = data.GetPointData()
    names = sorted(attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays()))
    return [
        coordinates(data).tobytes(),
        cells(data.GetPolys()),
        {name: array(attributes, name).tobytes() for name in names},
    ]


def baseline(name):
    """The facets of a file of Testing/Data/Baseline, as CGAL found them."""
    with open(os.path.join(SOURCE, "Testing", "Data", "Baseline", name + ".txt")) as file:
        lines = file.read().splitlines()
    head = dict(line.split() for line in lines[:5])
    facets = [tuple(int(i) for i in line.split()) for line in lines[5:]]
    assert len(facets) == int(head["cells"])
    return facets


def raw(name):
    """The coordinates of a file of Testing/Data."""
    dtype = {".f32": np.float32, ".f64": np.float64}[os.path.splitext(name)[1]]
    return np.fromfile(os.path.join(SOURCE, "Testing", "Data", name), dtype).reshape(-1, 3)


@contextlib.contextmanager
def errors():
    """A list that will hold the lines which ParaView writes to its error output."""
    lines = []
    kept = os.dup(2)
    with tempfile.TemporaryFile() as file:
        os.dup2(file.fileno(), 2)
        try:
            yield lines
        finally:
            os.dup2(kept, 2)
            os.close(kept)
            file.seek(0)
            lines += file.read().decode().splitlines()
