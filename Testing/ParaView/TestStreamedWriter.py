# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""File > Save Data with the streamed writer, and its files as ParaView reads them."""

import os
import tempfile
import unittest

import numpy as np
from paraview import servermanager, simple

from pipelines import IDS, cells_by_ids, cloud, coordinates, errors, fetch, run
from pipelines import array as values_of  # a programmable source gives this module NumPy's array

COUNT = 3000
SEED = 20261126
# The points of one piece of several.
PIECES = f"""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
executive = self.GetExecutive()
information = executive.GetOutputInformation(0)
piece = information.Get(executive.UPDATE_PIECE_NUMBER())
count = information.Get(executive.UPDATE_NUMBER_OF_PIECES())
xyz = np.random.default_rng({SEED}).random(({COUNT}, 3))
here = slice({COUNT} * piece // count, {COUNT} * (piece + 1) // count)
points = vtkPoints()
points.SetData(numpy_to_vtk(xyz[here], deep=True))
output = self.GetPolyDataOutput()
output.SetPoints(points)
asked = numpy_to_vtk(np.full(len(xyz[here]), count), deep=True)
asked.SetName("pieces")
output.GetPointData().AddArray(asked)
"""
INFORMATION = """
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
self.GetExecutive().GetOutputInformation(0).Set(vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)
"""


def points():
    return np.random.default_rng(SEED).random((COUNT, 3))


def file_types(source):
    factory = servermanager.vtkSMProxyManager.GetProxyManager().GetWriterFactory()
    return factory.GetSupportedFileTypes(source.SMProxy)


class TestStreamedWriter(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.file = os.path.join(self.folder.name, "out.vtpd")

    def read(self):
        """The partitions of the file."""
        reader = simple.OpenDataFile(self.file)
        reader.UpdatePipeline()
        data = reader.GetClientSideObject().GetOutputDataObject(0)
        self.assertEqual(data.GetClassName(), "vtkPartitionedDataSet")
        return [data.GetPartition(i) for i in range(data.GetNumberOfPartitions())]

    def compare(self, blocks, filtered, xyz):
        """The blocks' cells and points are those of a filter."""
        expected = fetch(run(filtered))
        cells = [cell for block in blocks for cell in cells_by_ids(block)]
        self.assertEqual(sorted(cells), sorted(cells_by_ids(expected)))
        found = np.concatenate([values_of(block.GetPointData(), IDS) for block in blocks])
        np.testing.assert_array_equal(np.unique(found), values_of(expected.GetPointData(), IDS))
        np.testing.assert_array_equal(np.concatenate([coordinates(block) for block in blocks]), xyz[found])

    def test_a_source_in_pieces(self):
        for shape in ("Triangulation", "Hull"):
            with self.subTest(shape):
                source = simple.ProgrammableSource(
                    OutputDataSetType="vtkPolyData", ScriptRequestInformation=INFORMATION, Script=PIECES
                )
                simple.SaveData(self.file, proxy=source, Shape=shape, NumberOfPieces=6, PointsPerBlock=500)
                blocks = self.read()
                self.assertGreaterEqual(len(blocks), 5)
                for block in blocks:
                    self.assertEqual(set(values_of(block.GetPointData(), "pieces")), {6})
                make = {
                    "Triangulation": simple.Delaunay2DFlipFlop,
                    "Hull": simple.ConvexHullFlipFlop,
                }[shape]
                self.compare(blocks, make(Input=cloud(points())), points())
                self.assertEqual(sorted(os.listdir(self.folder.name)), ["out", "out.vtpd"])

    def test_weights_and_polygons(self):
        xyz = np.round(8 * points()) / 8
        weight = 0.01 * np.random.default_rng(SEED + 1).random(COUNT)
        source = cloud(xyz, weight=weight)
        settings = {"Weights": ["POINTS", "weight"], "FacetMode": "Polygons"}
        simple.SaveData(self.file, proxy=source, PointsPerBlock=700, **settings)
        blocks = self.read()
        found = np.concatenate([values_of(block.GetPointData(), IDS) for block in blocks])
        values = np.concatenate([values_of(block.GetPointData(), "weight") for block in blocks])
        np.testing.assert_array_equal(values, weight[found])
        self.compare(
            blocks, simple.Delaunay2DFlipFlop(Input=source, **settings), xyz
        )

    def test_an_error(self):
        xyz = points()
        xyz[1234, 2] = np.nan
        with errors() as lines:
            simple.SaveData(self.file, proxy=cloud(xyz))
        self.assertEqual(len([line for line in lines if "first at point 1234, 1 such point(s)" in line]), 1, lines)
        self.assertFalse(os.path.exists(self.file))
        with errors() as lines:
            simple.SaveData(self.file, proxy=cloud(xyz), NonFinitePoints="Ignore")
        self.assertEqual(lines, [])
        self.assertEqual(len(self.read()), 1)

    def test_who_is_offered_it(self):
        """Data sets are. Blocks keep ParaView's own writer of that name."""
        source = cloud(points())
        self.assertIn("Flip-Flop's Streamed", file_types(source))
        blocks = run(simple.GroupDatasets(Input=[source]))
        self.assertNotIn("Flip-Flop's Streamed", file_types(blocks))


if __name__ == "__main__":
    unittest.main()
