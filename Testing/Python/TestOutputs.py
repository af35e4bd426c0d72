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
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from vtkflipflop import vtkFFConvexifyFilter, vtkFFHullFilter, vtkFFRegularTriangulationFilter

import digests

TOP = Path(__file__).resolve().parents[2]
BASELINE = TOP / "Testing" / "Data" / "Baseline" / "outputs.sha256"


def read(name):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(TOP / "Data" / name))
    reader.Update()
    return reader.GetOutput()


def made(xyz):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(xyz), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def numbers(count, seed):
    """Numbers in [0, 1) by integers alone: NumPy's generators may change with its version."""
    state, found = np.uint64(seed), np.empty(count)
    with np.errstate(over="ignore"):
        for i in range(count):
            state = state * np.uint64(6364136223846793005) + np.uint64(1442695040888963407)
            found[i] = float(state >> np.uint64(11)) / 2**53
    return found


def weighted(data, weights):
    array = numpy_to_vtk(np.ascontiguousarray(weights), deep=True)
    array.SetName("weight")
    data.GetPointData().AddArray(array)
    return data


def inputs():
    """Pairs of a name and points with the array "weight"."""
    for name in ("autzen", "sainthelens", "spot"):
        data = read(f"{name}.vtp")
        height = vtk_to_numpy(data.GetPoints().GetData())[:, 2].astype(np.float64)
        yield name, weighted(data, (height - height.min()) ** 2)
    uniform = numbers(9000, 1).reshape(-1, 3)
    yield "uniform", weighted(made(uniform), numbers(3000, 2) * 1e-3)
    yield "uniform float", weighted(made(uniform.astype(np.float32)), numbers(3000, 3) * 1e-3)
    grid = np.stack(np.meshgrid(*3 * [np.arange(6.0)], indexing="ij"), -1).reshape(-1, 3)
    yield "grid", weighted(made(grid), np.arange(216) % 5 / 4)
    yield "far", weighted(made(1e15 + grid), np.zeros(216))


def cases():
    """Pairs of a name and a filter that is ready to run."""
    for name, data in inputs():
        for facets in ("Triangles", "Polygons"):
            hull = vtkFFHullFilter()
            getattr(hull, f"SetFacetModeTo{facets}")()
            hull.SetInputData(data)
            yield f"hull, {facets.lower()}: {name}", hull
        for weights in ("None", "weight"):
            triangulation = vtkFFRegularTriangulationFilter()
            triangulation.SetInputArrayToProcess(0, 0, 0, 0, weights)
            triangulation.GeneratePowerDiagramOn()
            triangulation.SetInputData(data)
            yield f"triangulation, {weights.lower()}: {name}", triangulation
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
        expected = BASELINE.read_text().splitlines()
        self.assertGreater(len(expected), 100)
        self.assertEqual(lines(), expected)


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        BASELINE.write_text("\n".join(lines()) + "\n")
    else:
        unittest.main()
