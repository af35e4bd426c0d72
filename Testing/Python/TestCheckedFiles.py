# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Results of the filters as .vtp files: Checker/check_result.py reads each form and accepts them.

Data/ is among the inputs. Testing/Arrays/TestChecker.py has what the program notices.
"""

import itertools
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

from vtkflipflop import vtkFFAlgorithm, vtkFFHullFilter, vtkFFPowerDiagramFilter, vtkFFRegularTriangulationFilter

import given

PROGRAM = str(given.TOP / "Checker" / "check_result.py")
# Each form that VTK writes: the data's mode, the compressor, and for appended data whether it is in base64.
FORMS = [(mode, packed, encoded) for mode, packed, encoded in itertools.product(
    ("SetDataModeToAscii", "SetDataModeToBinary", "SetDataModeToAppended"), (False, True), (False, True))]  # fmt: skip


def cloud(xyz, weights=None, ghosts=()):
    points, data = vtkPoints(), vtkPolyData()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(xyz), deep=True))
    data.SetPoints(points)
    marks = np.zeros(len(xyz), np.uint8)
    marks[list(ghosts)] = 1
    for name, values in (("weight", weights), ("vtkGhostType", marks if ghosts else None)):
        if values is not None:
            array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
            array.SetName(name)
            data.GetPointData().AddArray(array)
    return data


def read(name):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(given.TOP / "Data" / name))
    reader.Update()
    return reader.GetOutput()


def write(data, path, form=FORMS[-1]):
    mode, packed, encoded = form
    if mode == "SetDataModeToAscii":
        for cells in (data.GetVerts(), data.GetLines(), data.GetPolys()):
            if hasattr(cells, "ConvertToFixedSizeDefaultStorage"):  # VTK 9.6 ends the process on such cells
                cells.ConvertToDefaultStorage()
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(path)
    writer.SetInputData(data)
    getattr(writer, mode)()
    writer.SetEncodeAppendedData(encoded)
    if not packed:
        writer.SetCompressorTypeToNone()
    writer.Write()


def made(kind, data, facets=vtkFFAlgorithm.FACETS_AS_TRIANGLES):
    run = kind()
    run.SetInputData(data)
    run.SetFacetMode(facets)
    if kind is not vtkFFHullFilter and data.GetPointData().HasArray("weight"):
        run.SetInputArrayToProcess(0, 0, 0, 0, "weight")
    run.Update()
    return run.GetOutput()


class TestCheckedFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = lambda name: os.path.join(folder.name, name)

    def check(self, kind, result, data, *options, form=FORMS[-1], code=0):
        write(result, self.path("result.vtp"), form)
        write(data, self.path("points.vtp"), form)
        command = [sys.executable, PROGRAM, kind, self.path("result.vtp"), self.path("points.vtp"), *options]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
        self.assertEqual(done.returncode, code, done.stdout)
        return done.stdout

    def test_every_form_of_file(self):
        random = np.random.default_rng(7)
        for form, kind in itertools.product(FORMS, (np.float32, np.float64)):
            data = cloud(random.random((60, 3)).astype(kind), random.random(60) * 0.01)
            self.check("hull", made(vtkFFHullFilter, data), data, form=form)
            result = made(vtkFFRegularTriangulationFilter, data)
            self.check("triangulation", result, data, "--weights", "weight", form=form)

    def test_facets_dimensions_and_ghosts(self):
        grid = np.stack(np.meshgrid(*[np.arange(3.0)] * 3), -1).reshape(-1, 3)
        for xyz in (grid, grid * [1, 1, 0], grid * [0, 1, 2], grid * [1, 0, 0], grid[:1], grid[:0]):
            for ghosts in ((), (0, 5)) if len(xyz) > 1 else ((),):
                data = cloud(xyz, None, ghosts)
                finite = cloud(np.where(np.isin(np.arange(len(xyz)), ghosts)[:, None], np.nan, xyz))
                for facets in (vtkFFAlgorithm.FACETS_AS_TRIANGLES, vtkFFAlgorithm.FACETS_AS_POLYGONS):
                    # Ghosts are left out of results: for the program, they are no points.
                    self.check("hull", made(vtkFFHullFilter, data, facets), finite)
                    self.check("triangulation", made(vtkFFRegularTriangulationFilter, data, facets), finite)

    def test_real_data(self):
        for name in ("spot.vtp", "autzen.vtp", "sainthelens.vtp"):
            data = read(name)
            text = self.check("hull", made(vtkFFHullFilter, data), data)
            self.assertIn(f"of {data.GetNumberOfPoints()} points", text)
            self.check("triangulation", made(vtkFFRegularTriangulationFilter, data), data)
            weighted = cloud(vtk_to_numpy(data.GetPoints().GetData()),
                             given.weights_of(vtk_to_numpy(data.GetPoints().GetData())))  # fmt: skip
            result = made(vtkFFRegularTriangulationFilter, weighted)
            self.check("triangulation", result, weighted, "--weights", "weight")

    def test_power_diagram(self):
        data = cloud(np.random.default_rng(8).random((80, 3)) * [1, 1, 0])
        triangulation = made(vtkFFRegularTriangulationFilter, data)
        write(triangulation, self.path("triangulation.vtp"))
        diagram = made(vtkFFPowerDiagramFilter, data)
        box = map(repr, diagram.GetBounds()[:4])
        self.check("diagram", diagram, data, "--triangulation", self.path("triangulation.vtp"), "--box", *box)

    def test_wrong_point(self):
        data = cloud(np.random.default_rng(9).random((50, 3)))
        hull = made(vtkFFHullFilter, data)
        hull.GetPoints().SetPoint(0, 5, 5, 5)
        self.assertIn("is not where the input's point", self.check("hull", hull, data, code=1))


if __name__ == "__main__":
    unittest.main()
