# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The files of Data/: any program shows their points, and Debian's ParaView can read them."""

import unittest
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

FILES = sorted((Path(__file__).resolve().parents[2] / "Data").glob("*.vtp"))


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


class TestData(unittest.TestCase):
    def test_each_point_is_a_vertex(self):
        self.assertGreaterEqual(len(FILES), 3)
        for path in FILES:
            with self.subTest(path.name):
                data = read(path)
                count = data.GetNumberOfPoints()
                self.assertGreater(count, 0)
                self.assertEqual(data.GetNumberOfCells(), count)
                self.assertEqual(data.GetNumberOfVerts(), count)
                corners = vtk_to_numpy(data.GetVerts().GetConnectivityArray())
                np.testing.assert_array_equal(corners, np.arange(count))

    def test_nothing_is_appended(self):
        for path in FILES:
            with self.subTest(path.name):
                content = path.read_bytes()
                self.assertNotIn(b"AppendedData", content)
                self.assertLess(len(content), 2**20)


if __name__ == "__main__":
    unittest.main()
