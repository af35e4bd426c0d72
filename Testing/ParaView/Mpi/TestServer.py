# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""
The filters on a pvserver of several ranks, with this process as the client: what arrives here is what the
plain classes make here of all pieces; so are the words of errors, after which the server goes on.
"""

import os
import tempfile
import unittest

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import cases
import digests
import observing
import pieces
import ranks

PLUGIN = os.path.join(os.environ["PV_PLUGIN_PATH"], "FlipFlop.so")
GOOD = ("Ball", "LatticePolygons", "LastRankOnly", "Blocks", "BlocksAsOne", "RealSpread", "Delaunay", "Regular",
        "Disks")
BAD = ("Nan", "NanInTriangulation", "SomeWeights", "NoWeights")


def expected(name):
    """The plain class of a case, run here on what all ranks have."""
    case = cases.CASES[name]
    datas = [pieces.KINDS[case.kind](rank, ranks.RANKS) for rank in range(ranks.RANKS)]
    return pieces.serial(cases.plain_class(case), pieces.append(datas), case.settings)


def outputs(plain):
    return [plain.GetOutputDataObject(port) for port in range(plain.GetNumberOfOutputPorts())]


class ServerTest(unittest.TestCase):
    environment = os.environ  # the server's

    @classmethod
    def setUpClass(cls):
        cls.server = ranks.Server(cls.environment)
        cls.addClassCleanup(ranks.stop, cls.server.process)
        cls.messages = observing.Messages()

    @classmethod
    def tearDownClass(cls):
        """A server that lived to the end ends well."""
        code = cls.server.close()
        assert code == 0, f"pvserver ended with {code}:\n" + "".join(cls.server.output)

    def check_outputs(self, proxy, plain):
        """What the client fetches is what the plain class gave; of a triangulation, it comes in shares."""
        for port, output in enumerate(outputs(plain)):
            if plain.IsA("vtkFFPlanarAlgorithm"):
                union = pieces.union_of_cells if plain.IsA("vtkFFPowerDiagramFilter") else pieces.union
                shares = [servermanager.Fetch(proxy, rank, idx=port) for rank in range(ranks.RANKS)]
                for found, wanted in zip(union(shares), union([output])):
                    self.assertEqual(len(found), len(wanted), port)
                    self.assertTrue(found == wanted, port)  # to show how they differ takes minutes
                continue
            fetched = servermanager.Fetch(proxy, 0, idx=port)
            self.assertEqual(digests.digest(fetched), pieces.as_sent(digests.digest(output)), port)

    def check_good(self, name):
        source, proxy = cases.pipeline(name)
        plain = expected(name)
        self.assertEqual(plain.GetErrorCode(), 0)
        self.messages.take()
        proxy.UpdatePipeline()
        told = self.messages.take()
        self.assertEqual([words for kind, words in told if kind == "Error"], [])
        self.check_outputs(proxy, plain)
        self.check_information(proxy, plain, cases.CASES[name])
        simple.Delete(proxy)
        simple.Delete(source)

    def check_information(self, proxy, plain, case):
        """What was found arrives as field data in the Information panel."""
        shown = proxy.FieldData
        for part in ("Dimension", "Points", "Volume", "Area", "HiddenPoints", "DroppedCells"):
            key = f"FlipFlop{part}"
            found = observing.of_field(outputs(plain)[0], key)
            self.assertEqual(key in shown.keys(), bool(found), key)
            if found:
                # Of a triangulation, the first rank tells of all, and the others of their shares.
                least = shown[key].GetRange()[0] if case.filter != cases.HULL else min(found)
                self.assertEqual(shown[key].GetRange(), (least, max(found)), key)
        self.assertIn("FlipFlopSecondsTotal", shown.keys())


class TestResults(ServerTest):
    def test_results(self):
        for name in GOOD:
            with self.subTest(name):
                self.check_good(name)

    def test_errors(self):
        """They come with the filter's own words, once, and another filter works afterwards."""
        for name in BAD:
            with self.subTest(name):
                _, proxy = cases.pipeline(name)
                self.messages.take()
                plain = expected(name)
                own = self.messages.take()
                self.assertNotEqual(plain.GetErrorCode(), 0)
                self.assertEqual([kind for kind, words in own], ["Error"])
                proxy.UpdatePipeline()
                self.assertEqual([told for told in self.messages.take() if told[0] == "Error"], own)
                self.check_outputs(proxy, plain)
                self.check_good("LatticePolygons")

    def test_correction(self):
        """The same filter works once its input is mended."""
        _, proxy = cases.pipeline("NoWeights")
        proxy.UpdatePipeline()
        self.assertEqual(proxy.GetDataInformation().GetNumberOfPoints(), 0)
        proxy.Weights = ["POINTS", "Weight"]
        proxy.UpdatePipeline()
        self.check_outputs(proxy, expected("Regular"))

    def test_picture(self):
        """The server draws what it has: here nothing but the picture arrives."""
        _, proxy = cases.pipeline("Ball")
        view = simple.CreateRenderView(ViewSize=[300, 200], OrientationAxesVisibility=0)
        view.RemoteRenderThreshold = 0.0
        view.UseColorPaletteForBackground = 0
        view.Background = [0.0, 0.0, 0.0]
        display = simple.Show(proxy, view)
        display.Representation = "Surface"
        display.DiffuseColor = display.AmbientColor = [1.0, 0.0, 0.0]
        display.ColorArrayName = ["POINTS", ""]
        simple.ResetCamera(view)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "hull.png")
            simple.SaveScreenshot(path, view, ImageResolution=[300, 200])
            self.assertTrue(view.GetClientSideObject().GetUseDistributedRenderingForRender())
            reader = vtkPNGReader()
            reader.SetFileName(path)
            reader.Update()
        colours = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
        drawn = numpy.any(colours > 0, axis=1)
        self.assertTrue(0.1 < drawn.mean() < 0.9, drawn.mean())
        self.assertTrue(numpy.all(colours[drawn, 0] > 0))
        self.assertGreater(len(numpy.unique(colours[:, 0])), 10)  # shades of facets
        simple.Delete(view)


class TestLoading(ServerTest):
    """A server that knows nothing of the plugin is given it by the client."""

    environment = {name: value for name, value in os.environ.items() if name != "PV_PLUGIN_PATH"}

    def test_load(self):
        simple.LoadPlugin(PLUGIN, remote=True, ns=vars(simple))
        self.check_good("Ball")
        self.check_good("Disks")


class TestState(unittest.TestCase):
    NAMES = ("Ball", "Blocks", "Disks", "RealSpread")

    def digests(self):
        """What the session's filters give."""
        found = {}
        for name in self.NAMES:
            proxy = simple.FindSource(name)
            proxy.UpdatePipeline()
            found[name] = digests.digest(servermanager.Fetch(proxy, 0))
        return found

    def in_session(self, prepare):
        """What the filters of a session with a server of its own give."""
        server = ranks.Server()
        self.addCleanup(ranks.stop, server.process)
        prepare()
        found = self.digests()
        self.assertEqual(server.close(), 0, server.output)
        return found

    def test_state(self):
        """What one session saves, a fresh one with another server gives again."""
        with tempfile.TemporaryDirectory() as folder:
            state = os.path.join(folder, "state.pvsm")

            def save():
                for name in self.NAMES:
                    simple.RenameSource(name, cases.pipeline(name)[1])
                simple.SaveState(state)

            saved = self.in_session(save)
            loaded = self.in_session(lambda: simple.LoadState(state))
        self.assertEqual(loaded, saved)
        for digest in saved.values():
            self.assertTrue(any("Polys" in part for part in digest))


if __name__ == "__main__":
    unittest.main()
