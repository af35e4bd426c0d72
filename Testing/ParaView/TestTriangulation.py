# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The triangulation's proxy: weights, planes, ports and the filter's other promises, through ParaView."""

import unittest

import numpy as np
from paraview import simple

from pipelines import (
    array,
    bits,
    cells,
    cells_by_ids,
    cloud,
    coordinates,
    errors,
    fetch,
    poly_data,
    producer,
    run,
)

# A square, its centre, and a light point near the centre.
SQUARE = np.array([[0, 0, 7], [2, 0, 8], [2, 2, 9], [0, 2, 6], [1, 1, 5], [1.25, 1, 4]])
WEIGHT = np.array([0, 0, 0, 0, 1, -3.0])


def triangulation_of(source, **settings):
    return run(simple.RegularWeightedDelaunayTriangulationFlipFlop(Input=source, **settings))


def diagram_of(source, **settings):
    return run(simple.VoronoiPowerDiagramFlipFlop(Input=source, **settings))


def port_sizes(proxy):
    return [proxy[i].GetDataInformation().GetNumberOfPoints() for i in range(3)]


class TestWeights(unittest.TestCase):
    def test_none_by_default(self):
        """ParaView offers the active scalars to a filter that wants an array; this one does not."""
        data = poly_data(SQUARE, weight=WEIGHT, flat=np.zeros(6))
        data.GetPointData().SetActiveScalars("weight")
        source = producer(data)
        triangulation = simple.RegularWeightedDelaunayTriangulationFlipFlop(Input=source)
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

    def test_not_finite(self):
        weight = WEIGHT.copy()
        weight[2] = np.nan
        source = cloud(SQUARE, weight=weight)
        with errors() as lines:
            triangulation = triangulation_of(source, Weights=["POINTS", "weight"])
        self.assertEqual(len(lines), 1, lines)
        self.assertIn("point 2,", lines[0])
        self.assertEqual(port_sizes(triangulation), [0, 0, 0])
        triangulation.NonFinitePoints = "Ignore"
        # Without that corner of the square the light point is one of the border.
        self.assertEqual(port_sizes(run(triangulation)), [5, 0, 0])
        self.assertEqual(triangulation.NumberOfNonFinitePoints, 1)


class TestPlanes(unittest.TestCase):
    def test_plane(self):
        """A steep plane: from above the points lie on a line, in their own plane and turned they do not."""
        rng = np.random.default_rng(4)
        xy = rng.random((500, 2))
        flat = cells_by_ids(fetch(triangulation_of(cloud(np.column_stack([xy, 0 * xy[:, 0]])))))
        source = cloud(np.column_stack([xy[:, 0], 0 * xy[:, 0], xy[:, 1]]))
        triangulation = triangulation_of(source)
        self.assertEqual(triangulation.Dimension, 1)
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
        self.assertEqual(run(triangulation).Dimension, 1)


class TestPorts(unittest.TestCase):
    def test_power_diagram(self):
        source = cloud(SQUARE, weight=WEIGHT)
        proxy = diagram_of(source, Weights=["POINTS", "weight"])
        diagram = fetch(proxy)
        ids = array(diagram.GetCellData(), "OriginalPointIds")
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
        self.assertEqual(hidden.NumberOfInputPoints, triangulation.NumberOfHiddenPoints)
        self.assertGreater(hidden.NumberOfInputPoints, 0)
        area = simple.IntegrateVariables(Input=diagram_of(source, Weights=["POINTS", "weight"]))
        area.UpdatePipeline()
        low_x, high_x, low_y, high_y = fetch(source).GetBounds()[:4]
        self.assertAlmostEqual(
            array(fetch(area).GetCellData(), "Area")[0], (high_x - low_x) * (high_y - low_y), places=12
        )


if __name__ == "__main__":
    unittest.main()
