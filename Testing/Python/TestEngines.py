# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The choice of the engine, from Python."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from vtkflipflop import (
    vtkFFAlgorithm,
    vtkFFConvexifyFilter,
    vtkFFHullFilter,
    vtkFFRegularTriangulationFilter,
)

from watching import errors_of

AVAILABLE = vtkFFAlgorithm.IsCUDAAvailable()
DEVICE = vtkFFAlgorithm.GetCUDADeviceName()
PROBLEM = vtkFFAlgorithm.GetCUDAProblem()


def poly_data(count):
    points = vtkPoints()
    xyz = np.random.default_rng(7).standard_normal((count, 3))
    points.SetData(numpy_to_vtk(xyz, deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def result(algorithm):
    """The output's bits."""
    output = algorithm.GetOutput()
    arrays = (
        output.GetPoints().GetData(),
        output.GetPolys().GetConnectivityArray(),
        output.GetPointData().GetArray("vtkOriginalPointIds"),
    )
    return [vtk_to_numpy(array).tobytes() for array in arrays]


class TestEngines(unittest.TestCase):
    def each(self, count=2000):
        for filter_class in (vtkFFHullFilter, vtkFFRegularTriangulationFilter):
            with self.subTest(filter_class.__name__):
                algorithm = filter_class()
                algorithm.SetInputData(poly_data(count))
                algorithm.SetEngine(algorithm.ENGINE_CPU)
                algorithm.Update()
                self.assertEqual(algorithm.GetEngineUsed(), vtkFFAlgorithm.ENGINE_CPU)
                self.assertIn("asked for", algorithm.GetEngineReason())
                yield algorithm, result(algorithm)

    def test_status(self):
        self.assertEqual(bool(DEVICE), AVAILABLE)
        self.assertEqual(bool(PROBLEM), not AVAILABLE)

    def test_automatic(self):
        for algorithm, expected in self.each():
            algorithm.SetEngine(algorithm.ENGINE_AUTOMATIC)
            algorithm.Update()
            self.assertEqual(algorithm.GetEngineUsed(), vtkFFAlgorithm.ENGINE_CPU)
            self.assertTrue(algorithm.GetEngineReason())
            self.assertEqual(result(algorithm), expected)
            self.assertGreater(algorithm.GetCUDAThreshold(), 2**31 - 2)
            algorithm.SetCUDAThreshold(2000)
            self.assertEqual(algorithm.GetCUDAThreshold(), 2000)
            algorithm.Update()
            self.assertEqual(algorithm.GetEngineUsedAsString(), "CUDA" if AVAILABLE else "CPU")
            self.assertIn(DEVICE if AVAILABLE else PROBLEM, algorithm.GetEngineReason())
            self.assertEqual(result(algorithm), expected)

    @unittest.skipIf(AVAILABLE, "there is a device: " + DEVICE)
    def test_without_device(self):
        for algorithm, expected in self.each():
            messages = errors_of(algorithm)
            algorithm.SetEngine(algorithm.ENGINE_CUDA)
            algorithm.Update()
            self.assertEqual(len(messages), 1)
            self.assertIn(PROBLEM, messages[0])
            self.assertIn("Set Engine to Automatic or CPU", messages[0])
            self.assertNotEqual(algorithm.GetErrorCode(), 0)
            self.assertEqual(algorithm.GetEngineUsed(), vtkFFAlgorithm.ENGINE_NONE)
            self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 0)
            algorithm.SetEngine(algorithm.ENGINE_AUTOMATIC)
            algorithm.Update()
            self.assertEqual(len(messages), 1)
            self.assertEqual(result(algorithm), expected)

    @unittest.skipUnless(AVAILABLE, PROBLEM)
    def test_with_device(self):
        for algorithm, expected in self.each():
            algorithm.SetEngine(algorithm.ENGINE_CUDA)
            algorithm.Update()
            self.assertEqual(algorithm.GetErrorCode(), 0)
            self.assertEqual(algorithm.GetEngineUsed(), vtkFFAlgorithm.ENGINE_CUDA)
            self.assertIn(DEVICE, algorithm.GetEngineReason())
            self.assertEqual(result(algorithm), expected)

    def test_convexify(self):
        hull = vtkFFHullFilter()
        hull.SetInputData(poly_data(50))
        convexify = vtkFFConvexifyFilter()
        convexify.SetInputConnection(hull.GetOutputPort())
        messages = errors_of(convexify)
        convexify.Update()
        self.assertIn("this filter runs on the CPU", convexify.GetEngineReason())
        self.assertGreater(convexify.GetOutput().GetNumberOfPolys(), 0)
        convexify.SetEngine(convexify.ENGINE_CUDA)
        convexify.Update()
        self.assertEqual(len(messages), 1)
        self.assertIn("this filter runs on the CPU", messages[0])
        self.assertEqual(convexify.GetOutput().GetNumberOfPoints(), 0)


if __name__ == "__main__":
    unittest.main()
