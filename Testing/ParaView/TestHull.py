# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The proxies of the hull and of Convexify: what ParaView brings to what the C++ tests hold."""

import unittest

import numpy as np
from paraview import simple
from vtkflipflop import vtkFFHullFilter

from pipelines import (
    IDS,
    array,
    baseline,
    cells,
    cells_by_ids,
    cloud,
    coordinates,
    errors,
    fetch,
    raw,
    real,
    run,
)

CUBE = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=float)


def hull_of(source, **settings):
    return run(simple.ConvexHullFlipFlop(Input=source, **settings))


class TestHull(unittest.TestCase):
    def test_real_data(self):
        for name, file, facets in (
            ("spot", "spot.f32", "spot"),
            ("autzen", "autzen_thin_las.f64", "autzen_thin_las"),
            ("sainthelens", "sainthelens_step3.f32", "sainthelens_step3"),
        ):
            source = real(name)
            xyz = raw(file)
            np.testing.assert_array_equal(coordinates(fetch(source)), xyz)
            hull = hull_of(source, FacetMode="Polygons")
            output = fetch(hull)
            self.assertEqual(cells_by_ids(output), baseline(facets), name)
            ids = array(output.GetPointData(), IDS)
            self.assertEqual(coordinates(output).dtype, xyz.dtype)
            np.testing.assert_array_equal(coordinates(output), xyz[ids])
            self.assertEqual(hull.NumberOfInputPoints, len(xyz))
            self.assertEqual(hull.Dimension, 3)

            heights = fetch(source).GetPointData().GetArray("Elevation")
            if heights:
                passed = array(output.GetPointData(), "Elevation")
                np.testing.assert_array_equal(passed, xyz[ids, 2])

    def test_triangles_by_default(self):
        hull = hull_of(cloud(CUBE))
        self.assertEqual([len(cell) for cell in cells(fetch(hull).GetPolys())], [3] * 12)
        self.assertEqual((hull.Volume, hull.Area), (1.0, 6.0))
        hull.FacetMode = "Polygons"
        self.assertEqual([len(cell) for cell in cells(fetch(run(hull)).GetPolys())], [4] * 6)

    def test_arrays(self):
        source = cloud(CUBE, value=np.arange(8.0))
        data = fetch(hull_of(source, VisiblePointIds=1)).GetPointData()
        np.testing.assert_array_equal(array(data, "OriginalPointIds"), np.arange(8))
        np.testing.assert_array_equal(array(data, "value"), np.arange(8.0))
        data = fetch(hull_of(source, PassPointData=0)).GetPointData()
        self.assertEqual([data.GetArrayName(i) for i in range(data.GetNumberOfArrays())], [IDS])

    def test_what_was_found_as_field_data(self):
        hull = hull_of(cloud(CUBE))
        found = fetch(hull).GetFieldData()
        self.assertEqual(found.GetArray("FlipFlopVolume").GetValue(0), 1.0)
        self.assertEqual(found.GetArray("FlipFlopPoints").GetValue(0), 8)
        self.assertEqual(found.GetAbstractArray("FlipFlopEngine").GetValue(0), "CPU")
        hull.ReportAsFieldData = 0
        self.assertEqual(fetch(run(hull)).GetFieldData().GetNumberOfArrays(), 0)

    def test_points_that_are_not_finite(self):
        xyz = np.vstack([CUBE, CUBE])
        xyz[5, 1] = np.nan
        xyz[11, 0] = np.inf
        with errors() as lines:
            hull = hull_of(cloud(xyz))
        self.assertEqual(len(lines), 1, lines)
        self.assertIn("HullFilter", lines[0])
        self.assertIn("point 5,", lines[0])
        self.assertIn("2 such point", lines[0])
        self.assertEqual(hull.GetDataInformation().GetNumberOfPoints(), 0)
        self.assertEqual(hull.NumberOfNonFinitePoints, 2)

        # The session lives on, and so does the filter.
        with errors() as lines:
            hull.NonFinitePoints = "Ignore"
            output = fetch(run(hull))
        self.assertEqual(lines, [])
        self.assertEqual(list(array(output.GetPointData(), IDS)), [0, 1, 2, 3, 4, 6, 7, 13])
        self.assertEqual(hull.NumberOfNonFinitePoints, 2)
        self.assertEqual(hull.Volume, 1.0)

    def test_cuda(self):
        """The same hull where there is a device, an error where there is none."""
        hull = hull_of(cloud(CUBE))
        if vtkFFHullFilter.IsCUDAAvailable():
            hull.Engine = "CUDA"
            self.assertEqual(run(hull).Volume, 1.0)
            return
        with errors() as lines:
            hull.Engine = "CUDA"
            run(hull)
        self.assertEqual(len(lines), 1, lines)
        self.assertIn("CUDA", lines[0])
        self.assertEqual(hull.GetDataInformation().GetNumberOfPoints(), 0)

    def test_blocks(self):
        blocks = simple.GroupDatasets(Input=[cloud(CUBE), cloud(2 * CUBE + 3)])
        blocks.UpdatePipeline()
        hull = hull_of(blocks)
        self.assertTrue(hull.GetDataInformation().IsCompositeDataSet())
        self.assertEqual(hull.GetDataInformation().GetNumberOfCells(), 24)
        self.assertEqual(hull.Volume, 9.0)

        hull.CompositeMode = "Hull of All Blocks"
        output = fetch(run(hull))
        self.assertEqual(output.GetClassName(), "vtkPolyData")
        ids = array(output.GetPointData(), IDS)
        xyz = np.vstack([CUBE, 2 * CUBE + 3])
        np.testing.assert_array_equal(coordinates(output), xyz[ids])
        indices = array(output.GetPointData(), "BlockIndex")
        self.assertEqual(len(set(indices)), 2)
        np.testing.assert_array_equal(indices == indices[-1], ids >= 8)
        alone = hull_of(cloud(xyz))
        self.assertEqual(cells_by_ids(output), cells_by_ids(fetch(alone)))
        self.assertEqual(hull.Volume, alone.Volume)


class TestConvexify(unittest.TestCase):
    """An octahedron with one vertex pushed in: star-shaped from (0, 0, -0.5)."""

    XYZ = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, -0.125], [0, 0, -1]]
    TRIANGLES = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4],
                 [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]  # fmt: skip

    def convexify(self, source, **settings):
        return run(simple.ConvexifyFlipFlop(Input=source, **settings))

    def test_by_flips(self):
        source = cloud(self.XYZ, self.TRIANGLES)
        for settings in ({}, {"UseKernelPoint": 1, "KernelPoint": [0, 0, -0.5]}):
            convex = self.convexify(source, FacetMode="Polygons", **settings)
            output = fetch(convex)
            self.assertEqual(list(array(output.GetPointData(), IDS)), [0, 1, 2, 3, 5])
            self.assertEqual(output.GetNumberOfPolys(), 5)
            self.assertEqual(convex.Volume, 2.0 / 3.0)

    def test_unused_kernel_point(self):
        """A kernel point counts only where it is to be used, in whatever order all is pushed."""
        convex = self.convexify(cloud(self.XYZ, self.TRIANGLES), KernelPoint=[9, 9, 9])
        self.assertEqual(convex.Volume, 2.0 / 3.0)
        convex.KernelPoint = [8, 8, 8]
        self.assertEqual(run(convex).Volume, 2.0 / 3.0)


if __name__ == "__main__":
    unittest.main()
