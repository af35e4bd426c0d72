# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters through their proxies: what ParaView brings to what the C++ tests hold."""

import unittest

import numpy as np
from paraview import simple
from vtkflipflop import vtkFFHullFilter
from vtkmodules.vtkCommonDataModel import vtkCellArray

from pipelines import (
    IDS,
    array,
    baseline,
    bits,
    cells,
    cells_by_ids,
    cloud,
    coordinates,
    errors,
    fetch,
    poly_data,
    producer,
    raw,
    real,
    report,
    run,
)

CUBE = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=float)
# A square, its centre, and a light point near the centre.
SQUARE = np.array([[0, 0, 7], [2, 0, 8], [2, 2, 9], [0, 2, 6], [1, 1, 5], [1.25, 1, 4]])
WEIGHT = np.array([0, 0, 0, 0, 1, -3.0])
# A kite whose short diagonal is Delaunay.
KITE = np.array([[0, -3, 7], [1, 0, 0], [0, 3, 0], [-1, 0, 5]])


def hull_of(source, **settings):
    return run(simple.ConvexHullFlipFlop(Input=source, **settings))


def triangulation_of(source, **settings):
    return run(simple.Delaunay2DFlipFlop(Input=source, **settings))


def diagram_of(source, **settings):
    return run(simple.Voronoi2DFlipFlop(Input=source, **settings))


def port_sizes(proxy):
    return [proxy[i].GetDataInformation().GetNumberOfPoints() for i in range(3)]


def source_of(lines):
    data, made = poly_data(np.empty((0, 3))), vtkCellArray()
    for ids in lines:
        made.InsertNextCell(len(ids), ids)
    data.SetLines(made)
    return producer(data)


class TestHull(unittest.TestCase):
    def test_real_data(self):
        source, xyz = real("sainthelens"), raw("sainthelens_step3.f32")
        np.testing.assert_array_equal(coordinates(fetch(source)), xyz)
        hull = hull_of(source, FacetMode="Polygons")
        output = fetch(hull)
        self.assertEqual(cells_by_ids(output), baseline("sainthelens_step3"))
        ids = array(output.GetPointData(), IDS)
        self.assertEqual(coordinates(output).dtype, xyz.dtype)
        np.testing.assert_array_equal(coordinates(output), xyz[ids])
        np.testing.assert_array_equal(array(output.GetPointData(), "Elevation"), xyz[ids, 2])
        self.assertEqual((report(hull).GetNumberOfInputPoints(), report(hull).GetDimension()), (len(xyz), 3))

    def test_arrays(self):
        source = cloud(CUBE, value=np.arange(8.0))
        data = fetch(hull_of(source, GenerateOriginalIds=1)).GetPointData()
        np.testing.assert_array_equal(array(data, "OriginalPointIds"), np.arange(8))
        np.testing.assert_array_equal(array(data, "value"), np.arange(8.0))
        data = fetch(hull_of(source, PassPointData=0)).GetPointData()
        self.assertEqual([data.GetArrayName(i) for i in range(data.GetNumberOfArrays())], [IDS])

    def test_what_was_found_as_field_data(self):
        hull = hull_of(cloud(CUBE), ReportAsFieldData=1)
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
        self.assertEqual(report(hull).GetNumberOfNonFinitePoints(), 2)

        # The session lives on, and so does the filter.
        with errors() as lines:
            hull.NonFinitePoints = "Ignore"
            output = fetch(run(hull))
        self.assertEqual(lines, [])
        self.assertEqual(list(array(output.GetPointData(), IDS)), [0, 1, 2, 3, 4, 6, 7, 13])
        self.assertEqual(report(hull).GetNumberOfNonFinitePoints(), 2)
        self.assertEqual(report(hull).GetVolume(), 1.0)

    def test_cuda(self):
        """The same hull where there is a device, an error where there is none."""
        hull = hull_of(cloud(CUBE))
        if vtkFFHullFilter.IsCUDAAvailable():
            hull.Engine = "CUDA"
            self.assertEqual(report(run(hull)).GetVolume(), 1.0)
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
        self.assertEqual(report(hull).GetVolume(), 9.0)
        hull.CompositeMode = "Hull of All Blocks"
        output = fetch(run(hull))
        self.assertEqual(output.GetClassName(), "vtkPolyData")
        alone = hull_of(cloud(np.vstack([CUBE, 2 * CUBE + 3])))
        self.assertEqual(cells_by_ids(output), cells_by_ids(fetch(alone)))
        self.assertEqual(report(hull).GetVolume(), report(alone).GetVolume())
        self.assertEqual(len(set(array(output.GetPointData(), "BlockIndex"))), 2)

    # An octahedron with one vertex pushed in: star-shaped from (0, 0, -0.5).
    XYZ = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, -0.125], [0, 0, -1]]
    TRIANGLES = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4],
                 [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]  # fmt: skip

    def test_convexify(self):
        """A kernel point counts only where it is to be used, in whatever order all is pushed."""
        source = cloud(self.XYZ, self.TRIANGLES)
        for settings in ({}, {"UseKernelPoint": 1, "KernelPoint": [0, 0, -0.5]}, {"KernelPoint": [9, 9, 9]}):
            convex = run(simple.ConvexifyFlipFlop(Input=source, **settings))
            self.assertEqual(list(array(fetch(convex).GetPointData(), IDS)), [0, 1, 2, 3, 5])
            self.assertEqual(report(convex).GetVolume(), 2.0 / 3.0)


class TestPlane(unittest.TestCase):
    def test_no_weights_by_default(self):
        """ParaView offers the active scalars to a filter that wants an array; this one does not."""
        data = poly_data(SQUARE, weight=WEIGHT, flat=np.zeros(6))
        data.GetPointData().SetActiveScalars("weight")
        source = producer(data)
        triangulation = simple.Delaunay2DFlipFlop(Input=source)
        self.assertEqual(triangulation.Weights[1], "None")
        plain = fetch(run(triangulation))
        self.assertEqual(plain.GetNumberOfPoints(), 6)
        choices = triangulation.GetProperty("Weights").SMProperty.GetDomain("array_list")
        choices = [choices.GetString(i) for i in range(choices.GetNumberOfStrings())]
        self.assertEqual(sorted(choices), ["None", "flat", "weight"])

        triangulation.Weights = ["POINTS", "weight"]
        self.assertEqual(port_sizes(run(triangulation)), [5, 1, 0])
        triangulation.Weights = ["POINTS", "flat"]
        self.assertEqual(cells(fetch(run(triangulation)).GetPolys()), cells(plain.GetPolys()))
        triangulation.Weights = ["POINTS", "None"]
        self.assertEqual(bits(fetch(run(triangulation))), bits(plain))

    def test_plane(self):
        """A steep plane: from above the points lie on a line, in their own plane and turned they do not."""
        rng = np.random.default_rng(4)
        xy = rng.random((500, 2))
        flat = cells_by_ids(fetch(triangulation_of(cloud(np.column_stack([xy, 0 * xy[:, 0]])))))
        source = cloud(np.column_stack([xy[:, 0], 0 * xy[:, 0], xy[:, 1]]))
        triangulation = triangulation_of(source)
        self.assertEqual(report(triangulation).GetDimension(), 1)
        self.assertEqual(fetch(triangulation).GetNumberOfLines(), 499)

        triangulation.ProjectionPlaneMode = "Best-Fitting Plane"
        fitted = fetch(run(triangulation))
        self.assertEqual({frozenset(c) for c in cells_by_ids(fitted)}, {frozenset(c) for c in flat})

        # About x by -90 degrees: z becomes y. The sine is 1 or so rounded, and 0 times 0 is 0.
        triangulation.ProjectionPlaneMode = "Transform"
        triangulation.Transform.Rotate = [-90, 0, 0]
        turned = fetch(run(triangulation))
        self.assertEqual(cells_by_ids(turned), flat)
        np.testing.assert_array_equal(coordinates(turned), coordinates(fetch(source)))

        # The transform counts: another one is another run.
        triangulation.Transform.Rotate = [0, 0, 0]
        self.assertEqual(report(run(triangulation)).GetDimension(), 1)

    def test_power_diagram(self):
        source = cloud(SQUARE, weight=WEIGHT)
        proxy = diagram_of(source, Weights=["POINTS", "weight"])
        diagram = fetch(proxy)
        ids = array(diagram.GetCellData(), IDS)
        self.assertEqual(list(ids), [0, 1, 2, 3, 4])
        np.testing.assert_array_equal(array(diagram.GetCellData(), "weight"), WEIGHT[:5])
        self.assertEqual(diagram.GetBounds(), (0.0, 2.0, 0.0, 2.0, 4.0, 4.0))
        self.assertEqual([len(cell) for cell in cells(diagram.GetPolys())], [3, 3, 3, 3, 8])

        # Bounds count only where they are to be used.
        proxy.PowerDiagramCorner, proxy.PowerDiagramLengths = [-9, -9, 0], [18, 18, 0]
        self.assertEqual(fetch(run(proxy)).GetBounds(), (0.0, 2.0, 0.0, 2.0, 4.0, 4.0))
        proxy.PowerDiagramBoxMode = "Bounds Given"
        proxy.PowerDiagramCorner, proxy.PowerDiagramLengths = [-4, -3, 0], [8, 6, 0]
        self.assertEqual(fetch(run(proxy)).GetBounds(), (-4.0, 4.0, -3.0, 3.0, 4.0, 4.0))
        with errors() as lines:
            proxy.PowerDiagramLengths = [-1, 1, 0]
            run(proxy)
        self.assertEqual(len(lines), 1, lines)
        self.assertIn("(xmin, xmax, ymin, ymax)", lines[0])
        self.assertEqual(proxy.GetDataInformation().GetNumberOfPoints(), 0)

    def test_further_ports_feed_filters(self):
        rng = np.random.default_rng(5)
        source = cloud(
            np.column_stack([rng.random((300, 2)), np.zeros(300)]), weight=0.02 * rng.random(300)
        )
        triangulation = triangulation_of(source, Weights=["POINTS", "weight"])
        hidden = run(simple.ConvexHullFlipFlop(Input=simple.OutputPort(triangulation, "Hidden Points")))
        self.assertEqual(report(hidden).GetNumberOfInputPoints(), report(triangulation).GetNumberOfHiddenPoints())
        self.assertGreater(report(hidden).GetNumberOfInputPoints(), 0)
        area = simple.IntegrateVariables(Input=diagram_of(source, Weights=["POINTS", "weight"]))
        area.UpdatePipeline()
        low_x, high_x, low_y, high_y = fetch(source).GetBounds()[:4]
        self.assertAlmostEqual(
            array(fetch(area).GetCellData(), "Area")[0], (high_x - low_x) * (high_y - low_y), places=12
        )

    def test_terrain_mesh(self):
        mesh = run(simple.TerrainMeshFlipFlop(Input=real("sainthelens"), ReportAsFieldData=1))
        low, high = mesh.PointData["Elevation"].GetRange()
        self.assertEqual(mesh.FieldData["FlipFlopTolerance"].GetRange()[0], 0.01 * (high - low))
        mesh.Tolerance = 20.0
        run(mesh)
        kept, others = (fetch(mesh, i) for i in range(2))
        self.assertLess(kept.GetNumberOfPoints(), others.GetNumberOfPoints())
        self.assertEqual(kept.GetNumberOfPoints() + others.GetNumberOfPoints(), report(mesh).GetNumberOfInputPoints())
        errors = abs(array(others.GetPointData(), "TerrainError"))
        self.assertEqual(mesh.FieldData["FlipFlopGreatestError"].GetRange()[0], errors.max())
        self.assertLessEqual(errors.max(), 20.0)
        mesh.Heights = ["POINTS", "Elevation"]
        self.assertEqual(bits(fetch(run(mesh))), bits(kept))
        mesh.MaximumNumberOfVertices = 50
        self.assertEqual(fetch(run(mesh)).GetNumberOfPoints(), 50)
        self.assertGreater(report(mesh).GetNumberOfPointsBeyond(), 0)
        # A breakline with points of its own.
        line = simple.PolyLineSource(Points=[563000, 5112000, 900, 563500, 5113000, 1000])
        mesh.MaximumNumberOfVertices, mesh.Heights = 0, ["POINTS", "None"]
        mesh.Source = line
        origins = array(fetch(run(mesh)).GetPointData(), "PointOrigin")
        self.assertEqual(np.count_nonzero(origins == 1), 2)
        self.assertEqual(fetch(mesh).GetFieldData().GetArray("FlipFlopAddedPoints").GetTuple1(0), 2)

    def test_mesh(self):
        square = simple.Plane(XResolution=1, YResolution=1)
        mesh = run(simple.Mesh2DFlipFlop(Input=square, MinimumAngle=30.0, MaximumArea=0.01, ReportAsFieldData=1))
        found = fetch(mesh).GetCellData()
        self.assertGreaterEqual(array(found, "MinimumAngle").min(), 30.0 - 1e-9)
        self.assertLessEqual(array(found, "Area").max(), 0.01)
        self.assertEqual(set(array(found, "Region")), {-1})
        self.assertEqual(mesh.FieldData["FlipFlopAddedPoints"].GetRange()[0], report(mesh).GetNumberOfAddedPoints())
        edges = fetch(mesh, 1)
        self.assertEqual(set(array(edges.GetCellData(), "ConstraintCellIds")), {0})
        mesh.Regions = cloud([[0.1, 0.1, 0.0]], MaximumArea=np.array([0.001]))
        found = fetch(run(mesh)).GetCellData()
        self.assertLessEqual(array(found, "Area").max(), 0.001)
        self.assertEqual(set(array(found, "Region")), {0})

    def test_points_to_image(self):
        survey = real("sainthelens")
        image = run(simple.PointsToImageFlipFlop(Input=survey))
        self.assertEqual(fetch(image).GetDimensions(), (256, 256, 1))
        image.SizeMode = "Spacing"
        image.Spacing = [100.0, 200.0]
        image.InterpolationMode = "Clough-Tocher"
        made = fetch(run(image))
        self.assertEqual(made.GetSpacing(), (100.0, 200.0, 1.0))
        points = simple.Interpolator2DFlipFlop(Input=image, Source=survey,
                                                            InterpolationMode="Clough-Tocher")
        points.NullValue = float("nan")
        found = fetch(run(points)).GetPointData()
        for name in ("Elevation", "vtkValidPointMask"):
            one, other = (array(data, name) for data in (made.GetPointData(), found))
            self.assertTrue(np.array_equal(one, other, equal_nan=True), name)
        self.assertLess(np.isnan(array(made.GetPointData(), "Elevation")).mean(), 0.5)

    def test_lines(self):
        triangulation = triangulation_of(cloud(KITE))
        self.assertEqual(cells(fetch(triangulation).GetPolys()), [(0, 1, 3), (1, 2, 3)])
        triangulation.Source = source_of([[0, 2]])
        self.assertEqual(cells(fetch(run(triangulation)).GetPolys()), [(0, 1, 2), (0, 2, 3)])
        self.assertEqual(report(triangulation).GetEngineReason(), "constraints are the CPU's")
        fixed = fetch(triangulation, 3)
        self.assertEqual(cells(fixed.GetLines()), [(0, 2)])
        self.assertEqual(list(array(fixed.GetCellData(), "ConstraintCellIds")), [0])
        triangulation.Source = None
        self.assertEqual(cells(fetch(run(triangulation)).GetPolys()), [(0, 1, 3), (1, 2, 3)])

    def test_crossing(self):
        triangulation = simple.Delaunay2DFlipFlop(Input=cloud(KITE), Source=source_of([[0, 2], [1, 3]]))
        with errors() as lines:
            run(triangulation)
        triangulation.SplitCrossingConstraints = 1
        self.assertEqual(fetch(run(triangulation)).GetNumberOfPolys(), 4)
        self.assertTrue(any("An edge of cell 1 of the source crosses one of cell 0" in line for line in lines), lines)

    def test_border_and_alpha(self):
        """A 5 by 5 grid without its centre, around which four triangles have a larger circle."""
        ring = np.array([[i % 5, i // 5, i] for i in range(25) if i != 12])
        triangulation = triangulation_of(cloud(ring), Alpha=0.75, GenerateBoundary=1, GenerateAlphas=1)
        self.assertEqual(fetch(triangulation, 2).GetNumberOfLines(), 2)
        self.assertLessEqual(array(fetch(triangulation).GetCellData(), "Alpha").max(), 0.75)
        xyz = np.array([[0, 0, 0], [6, 0, 0], [0, 8, 0], [30, 0, 0], [32, 0, 0], [90, 90, 0]])
        output = fetch(triangulation_of(cloud(xyz), Alpha=5.0, AlphaLines=1, AlphaVerts=1))
        self.assertEqual(cells(output.GetPolys()), [(0, 1, 2)])
        self.assertEqual(cells(output.GetLines()), [(3, 4)])
        self.assertEqual(cells(output.GetVerts()), [(5,)])


if __name__ == "__main__":
    unittest.main()
