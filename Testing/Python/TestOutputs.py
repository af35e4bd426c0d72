# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The same bits in every environment: Debian's VTK, ParaView's, the wheel's.

Each of them runs this file and compares with one baseline. --write makes it anew, where an output changes on
purpose:

    PYTHONPATH=<the folder that holds vtkflipflop> python3 TestOutputs.py --write
"""

import hashlib
import sys
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from vtkflipflop import (
    vtkFFConvexifyFilter,
    vtkFFHullFilter,
    vtkFFPowerDiagramFilter,
    vtkFFRegularTriangulationFilter,
)

import digests
import given

PLANAR = {
    "triangulation": vtkFFRegularTriangulationFilter,
    "power diagram": vtkFFPowerDiagramFilter,
}


def read(name):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(given.TOP / "Data" / name))
    reader.Update()
    return reader.GetOutput()


def made(xyz):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(xyz), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def weighted(data, weights):
    array = numpy_to_vtk(np.ascontiguousarray(weights), deep=True)
    array.SetName("weight")
    data.GetPointData().AddArray(array)
    return data


def inputs():
    """Pairs of a name and points with the array "weight"."""
    for name in ("autzen", "sainthelens", "spot"):
        data = read(f"{name}.vtp")
        yield name, weighted(data, given.weights_of(vtk_to_numpy(data.GetPoints().GetData())))
    for name, xyz, weights in given.made():
        yield name, weighted(made(xyz), weights)


def cases():
    """Pairs of a name and a filter that is ready to run."""
    for name, data in inputs():
        for facets in ("Triangles", "Polygons"):
            hull = vtkFFHullFilter()
            hull.SetFacetMode(getattr(hull, f"FACETS_AS_{facets.upper()}"))
            hull.SetInputData(data)
            yield f"hull, {facets.lower()}: {name}", hull
        for kind, planar in PLANAR.items():
            for weights in ("None", "weight"):
                algorithm = planar()
                algorithm.SetInputArrayToProcess(0, 0, 0, 0, weights)
                algorithm.SetInputData(data)
                yield f"{kind}, {weights.lower()}: {name}", algorithm
    hull = vtkFFHullFilter()
    hull.SetInputData(dict(inputs())["uniform"])
    surface = vtkFFConvexifyFilter()
    surface.SetInputConnection(hull.GetOutputPort())
    yield "convexify: uniform", surface


def outcome(algorithm):
    """Every part of every output by a digest, and the figures whose bits are promised."""
    algorithm.Update()
    found = {}
    for port in range(algorithm.GetNumberOfOutputPorts()):
        for part, value in digests.parts(algorithm.GetOutputDataObject(port)):
            found[f"port {port}, {part}"] = hashlib.sha256(value).hexdigest()
    for figure in ("Volume", "Area"):
        if hasattr(algorithm, f"Get{figure}"):
            value = np.float64(getattr(algorithm, f"Get{figure}")())
            found[figure] = hashlib.sha256(value.tobytes()).hexdigest()
    return found


def lines():
    return [
        f"{digest}  {name}; {part}"
        for name, algorithm in cases()
        for part, digest in outcome(algorithm).items()
    ]


class TestOutputs(unittest.TestCase):
    def test_bits_are_those_of_the_baseline(self):
        expected = given.BASELINE.read_text().splitlines()
        self.assertGreater(len(expected), 100)
        self.assertEqual(lines(), expected)


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        given.BASELINE.write_text("\n".join(lines()) + "\n")
    else:
        unittest.main()
