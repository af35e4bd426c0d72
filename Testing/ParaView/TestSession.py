# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters within a session: time, selections, and states that a fresh session loads."""

import os
import pickle
import subprocess
import tempfile
import unittest

import numpy as np
from paraview import simple, smstate

from pipelines import IDS, array, bits, cells_by_ids, cloud, coordinates, fetch, real, report, run

# Points at random that move with the time step, on the sphere of radius 1 + time.
INFORMATION = """
executive = self.GetExecutive()
information = executive.GetOutputInformation(0)
steps = [0.0, 1.0, 2.0]
information.Set(executive.TIME_STEPS(), steps, len(steps))
information.Set(executive.TIME_RANGE(), [0.0, 2.0], 2)
"""
POINTS = """
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
executive = self.GetExecutive()
time = executive.GetOutputInformation(0).Get(executive.UPDATE_TIME_STEP())
xyz = np.random.default_rng(int(time)).standard_normal((400, 3))
xyz *= (1 + time) / np.linalg.norm(xyz, axis=1)[:, None]
points = vtkPoints()
points.SetData(numpy_to_vtk(xyz, deep=True))
self.GetPolyDataOutput().SetPoints(points)
"""


def points_at(time):
    xyz = np.random.default_rng(int(time)).standard_normal((400, 3))
    return xyz * ((1 + time) / np.linalg.norm(xyz, axis=1)[:, None])


class TestTime(unittest.TestCase):
    def test_each_step_anew(self):
        source = simple.ProgrammableSource(
            OutputDataSetType="vtkPolyData", ScriptRequestInformation=INFORMATION, Script=POINTS
        )
        source.UpdatePipelineInformation()
        self.assertEqual(list(source.TimestepValues), [0.0, 1.0, 2.0])
        hull = simple.ConvexHullFlipFlop(Input=source)
        triangulation = simple.Delaunay2DFlipFlop(Input=source)
        volumes = []
        for time in (0.0, 2.0, 1.0, 2.0):
            for proxy, alone in (
                (hull, simple.ConvexHullFlipFlop(Input=cloud(points_at(time)))),
                (triangulation, simple.Delaunay2DFlipFlop(Input=cloud(points_at(time)))),
            ):
                proxy.UpdatePipeline(time)
                run(alone)
                self.assertEqual(bits(fetch(proxy)), bits(fetch(alone)), time)
            volumes.append(report(hull).GetVolume())
        self.assertEqual(volumes[1], volumes[3])
        self.assertEqual(len(set(volumes)), 3)
        self.assertTrue(0.9 < volumes[1] / 27 / volumes[0] < 1.1)


class TestSelection(unittest.TestCase):
    def test_hull_of_a_selection(self):
        source = real("sainthelens")
        simple.SetActiveSource(source)
        simple.SelectPoints("Elevation > 1500", source)
        extracted = simple.ExtractSelection(Input=source)
        hull = run(simple.ConvexHullFlipFlop(Input=extracted))
        xyz = coordinates(fetch(source))
        chosen = xyz[array(fetch(source).GetPointData(), "Elevation") > 1500]
        self.assertTrue(100 < len(chosen) < len(xyz) / 2)
        self.assertEqual(report(hull).GetNumberOfInputPoints(), len(chosen))
        alone = run(simple.ConvexHullFlipFlop(Input=cloud(chosen)))
        self.assertEqual(cells_by_ids(fetch(hull)), cells_by_ids(fetch(alone)))
        self.assertEqual(coordinates(fetch(hull)).dtype, xyz.dtype)
        simple.ClearSelection(source)

    def test_selection_of_a_hull(self):
        """Ids of the hull's points, which ParaView has never seen in the input, do not get in its way."""
        hull = run(simple.ConvexHullFlipFlop(Input=real("spot"), GenerateOriginalIds=1))
        ids = array(fetch(hull).GetPointData(), IDS)
        simple.SetActiveSource(hull)
        simple.SelectPoints("OriginalPointIds < 1000", hull)
        extracted = simple.ExtractSelection(Input=hull)
        extracted.UpdatePipeline()
        kept = array(fetch(extracted).GetPointData(), "OriginalPointIds")
        np.testing.assert_array_equal(np.sort(kept), ids[ids < 1000])
        simple.ClearSelection(hull)


class TestStates(unittest.TestCase):
    # In a fresh session: what the sources of these names give, and their settings.
    LOADER = """
import pickle, sys
from paraview import simple
sys.path.insert(0, {tests!r})
from pipelines import bits, fetch, run
{load}
found = {{}}
for name, port in {outputs!r}:
    found[name, port] = bits(fetch(run(simple.FindSource(name)), port))
weighted, diagram = simple.FindSource("weighted"), simple.FindSource("diagram")
found["settings"] = [list(weighted.Weights), weighted.FacetMode.GetData(),
                     weighted.ProjectionPlaneMode.GetData(), list(weighted.Transform.Rotate),
                     list(diagram.PowerDiagramCorner), list(diagram.PowerDiagramLengths)]
with open({result!r}, "wb") as file:
    pickle.dump(found, file)
"""
    OUTPUTS = [("hull", 0), ("convex", 0), ("weighted", 0), ("weighted", 1), ("diagram", 0)]

    def setUp(self):
        simple.ResetSession()
        source = real("autzen")
        simple.RenameSource("autzen", source)
        squares = simple.Calculator(
            registrationName="squares", Input=source, ResultArrayName="squares",
            Function="coordsZ*coordsZ", ResultArrayType="Double",
        )  # fmt: skip
        hull = simple.ConvexHullFlipFlop(registrationName="hull", Input=source)
        simple.ConvexifyFlipFlop(registrationName="convex", Input=hull)
        weighted = simple.Delaunay2DFlipFlop(registrationName="weighted", Input=squares)
        weighted.Weights = ["POINTS", "squares"]
        weighted.FacetMode = "Polygons"
        weighted.ProjectionPlaneMode = "Transform"
        weighted.Transform.Rotate = [10, 0, 0]
        diagram = simple.Voronoi2DFlipFlop(registrationName="diagram", Input=squares)
        diagram.Weights = ["POINTS", "squares"]
        diagram.PowerDiagramBoxMode = "Bounds Given"
        diagram.PowerDiagramCorner, diagram.PowerDiagramLengths = [635700, 848900, 0], [300, 300, 0]
        self.expected = {
            (name, port): bits(fetch(run(simple.FindSource(name)), port)) for name, port in self.OUTPUTS
        }
        self.expected["settings"] = [
            ["POINTS", "squares"], "Polygons", "Transform", [10, 0, 0], [635700, 848900, 0],
            [300, 300, 0],
        ]  # fmt: skip

    def check(self, save, load):
        """What the sources give after a way of saving and one of loading is what they give here."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "state")
            save(path)
            script, result = os.path.join(folder, "load.py"), os.path.join(folder, "result")
            with open(script, "w") as file:
                file.write(
                    self.LOADER.format(
                        tests=os.path.dirname(os.path.abspath(__file__)),
                        load=load.format(path=path),
                        outputs=self.OUTPUTS,
                        result=result,
                    )
                )
            done = subprocess.run(
                [os.environ["FLIPFLOP_PVPYTHON"], "--dr", script],
                capture_output=True, text=True, timeout=200,
            )  # fmt: skip
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(result, "rb") as file:
                found = pickle.load(file)
        self.assertEqual(found["settings"], self.expected["settings"])
        for output in self.OUTPUTS:
            self.assertTrue(found[output] == self.expected[output], f"{output} differs")
            self.assertGreater(len(found[output][0]), 0)

    def test_state_file(self):
        self.check(simple.SaveState, "simple.LoadState({path!r})")

    def test_python_state(self):
        def save(path):
            with open(path, "w") as file:
                file.write(smstate.get_state())

        self.check(save, "exec(open({path!r}).read())")


if __name__ == "__main__":
    unittest.main()
