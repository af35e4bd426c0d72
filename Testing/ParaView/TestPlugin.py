# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin as ParaView sees it: how it is loaded, and what its filters offer."""

import os
import re
import subprocess
import tempfile
import unittest

from paraview import servermanager, simple

from pipelines import run as updated

ICONS = os.path.join(os.environ["FLIPFLOP_SOURCE"], "Plugin", "Icons")
PLUGIN = os.path.join(os.environ["PV_PLUGIN_PATH"], "FlipFlop.so")
LABELS = {
    "FlipFlopConvexHull": "Convex Hull (Flip-Flop)",
    "FlipFlopConvexify": "Convexify (Flip-Flop)",
    "FlipFlopDelaunay": "Delaunay Triangulation 2D (Flip-Flop)",
    "FlipFlopPowerDiagram": "Voronoi / Power Diagram (Flip-Flop)",
    "FlipFlopRegularTriangulation": "Regular (Weighted Delaunay) Triangulation (Flip-Flop)",
    "FlipFlopSelectEnclosedPoints": "Select Points in Convex Hull (Flip-Flop)",
    "FlipFlopPointInterpolator2D": "Point Interpolator 2D, Delaunay (Flip-Flop)",
    "FlipFlopPointsToImage": "Points To Image (Flip-Flop)",
    "FlipFlopTerrainMesh": "Terrain Mesh (Flip-Flop)",
}
# What somebody may search for, and a filter whose short help has it. ParaView 5.11 searches labels alone.
SEARCHED = {
    "raster": "FlipFlopPointsToImage",
    "natural": "FlipFlopPointInterpolator2D",
    "lidar": "FlipFlopTerrainMesh",
    "weights": "FlipFlopRegularTriangulation",
}
# The second input of those that answer questions at the points of the first.
SECOND = {"FlipFlopSelectEnclosedPoints": "Surface", "FlipFlopPointInterpolator2D": "Source"}
COMMON = {
    "PassPointData": 1,
    "VisiblePointIds": 0,
    "ReportAsFieldData": 1,
    "NumberOfThreads": -1,
    "VBiased": 1,
}
FACETS = {"FacetMode": "Triangles"}
ENGINES = {
    "NonFinitePoints": "Report an Error",
    "SkipGhostPoints": 1,
    "Engine": "Automatic",
    "CUDAThreshold": 2**31 - 1,
}
QUERIES = {"NonFinitePoints": "Report an Error", "SkipGhostPoints": 1, "NumberOfThreads": -1}
WEIGHTS = {"Weights": ["POINTS", "None"], "WeightMode": "Weights", "WeightFactor": 1.0}
ALPHA = {"Alpha": 0.0, "AlphaLines": 0, "AlphaVerts": 0, "GenerateAlphas": 0}
PLANE = {"ProjectionPlaneMode": "XY Plane"}
# The box is that of the sphere.
LOW_X, HIGH_X, LOW_Y, HIGH_Y, LOW_Z, HIGH_Z = updated(simple.Sphere()).GetDataInformation().GetBounds()
BOX = {
    "PowerDiagramBoxMode": "Bounds of the Points",
    "PowerDiagramCorner": [LOW_X, LOW_Y, LOW_Z],
    "PowerDiagramLengths": [HIGH_X - LOW_X, HIGH_Y - LOW_Y, HIGH_Z - LOW_Z],
    "GenerateCellMeasures": 0,
}
DEFAULTS = {
    "FlipFlopConvexHull": {
        **COMMON,
        **FACETS,
        **ENGINES,
        "CompositeMode": "Hull of Each Block",
        "GenerateCertificate": 0,
        "NumberOfStreamDivisions": 1,
        "ResultMode": "Automatic",
    },
    "FlipFlopDelaunay": {
        **COMMON,
        **FACETS,
        **ENGINES,
        **PLANE,
        "GenerateCellMeasures": 0,
        "GenerateGhostCells": 0,
        "MaximumEdgeLength": 0.0,
        "PolygonRule": "Even-Odd",
        "ClosedLinesAsBorders": 0,
        "SourcePoints": "Automatic",
        "SplitCrossingConstraints": 0,
    },
    "FlipFlopPowerDiagram": {**COMMON, **ENGINES, **WEIGHTS, **PLANE, **BOX},
    "FlipFlopConvexify": {**COMMON, **FACETS, "UseKernelPoint": 0, "KernelPoint": [0.0, 0.0, 0.0]},
    "FlipFlopRegularTriangulation": {
        **COMMON,
        **FACETS,
        **ENGINES,
        **WEIGHTS,
        **PLANE,
        **ALPHA,
        "GenerateBoundary": 0,
        "GenerateCellMeasures": 0,
        "GenerateCertificate": 0,
        "MaximumEdgeLength": 0.0,
        "GenerateGhostCells": 0,
    },
    "FlipFlopSelectEnclosedPoints": {
        **QUERIES,
        "SelectPointsOnSurface": 1,
        "InsideOut": 0,
        "GenerateDistances": 0,
    },
    "FlipFlopPointInterpolator2D": {
        **QUERIES,
        **WEIGHTS,
        "InterpolationMode": "Linear",
        "NullPointsStrategy": "Mask Points",
        "NullValue": 0.0,
        "InterpolateZ": 1,
        "PassPointArrays": 1,
        "PassCellArrays": 1,
        "PassFieldArrays": 1,
    },
    "FlipFlopPointsToImage": {
        **{name: value for name, value in COMMON.items() if name != "VisiblePointIds"},
        **ENGINES,
        **WEIGHTS,
        **PLANE,
        "SizeMode": "Dimensions",
        "Dimensions": [256, 256],
        "Spacing": [1.0, 1.0],
        "UseInputBounds": 1,
        "SamplingBounds": [0.0, 1.0, 0.0, 1.0],
        "InterpolationMode": "Linear",
        "NullPointsStrategy": "Mask Points",
        "InterpolateZ": 1,
    },
    "FlipFlopTerrainMesh": {
        **COMMON,
        **ENGINES,
        "Tolerance": -1.0,
        "MaximumNumberOfVertices": 0,
        "Heights": ["POINTS", "None"],
        "SourcePoints": "Automatic",
    },
}
PORTS = {
    "FlipFlopConvexHull": ["Hull"],
    "FlipFlopConvexify": ["Hull"],
    "FlipFlopDelaunay": ["Triangulation", "Fixed Edges"],
    "FlipFlopPowerDiagram": ["Power Diagram"],
    "FlipFlopRegularTriangulation": ["Triangulation", "Hidden Points", "Border"],
    "FlipFlopSelectEnclosedPoints": ["Points"],
    "FlipFlopPointInterpolator2D": ["Points"],
    "FlipFlopPointsToImage": ["Image"],
    "FlipFlopTerrainMesh": ["Mesh", "Other Points"],
}
FOUND = ["Dimension", "EngineUsed", "EngineReason", "NumberOfInputPoints", "NumberOfNonFinitePoints"]


def function(name):
    """What makes a filter in Python: ParaView names it for the label."""
    return getattr(simple, re.sub("[^A-Za-z0-9]", "", LABELS[name]))


def definition(name):
    """The XML of a filter, as ParaView holds it."""
    manager = servermanager.ProxyManager().SMProxyManager.GetProxyDefinitionManager()
    return manager.GetCollapsedProxyDefinition("filters", name, None, False)


class TestLoading(unittest.TestCase):
    """Each way of loading the plugin, in a process of its own without the others."""

    # Whether the filter is there before and after; where it comes from.
    SCRIPT = """
from paraview import simple
print("before", hasattr(simple, "ConvexHullFlipFlop"))
{load}
print("after", hasattr(simple, "ConvexHullFlipFlop"))
hull = simple.ConvexHullFlipFlop(Input=simple.Sphere())
hull.UpdatePipeline()
print("cells", hull.GetDataInformation().GetNumberOfCells())
"""

    def execute(self, *command, complains=False, **environment):
        """What a command prints; it must succeed, and, unless VTK complains, without a word of error."""
        clean = {k: v for k, v in os.environ.items() if not k.startswith("PV_PLUGIN")}
        result = subprocess.run(
            command, env={**clean, **environment}, capture_output=True, text=True, timeout=120
        )
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr != "", complains, result.stderr)
        return result.stdout.splitlines()

    def run_with(self, load="", plugins=None, **settings):
        """The script's lines. Plugins are the text of a configuration file."""
        with tempfile.TemporaryDirectory() as folder:
            script = os.path.join(folder, "load.py")
            with open(script, "w") as file:
                file.write(self.SCRIPT.format(load=load))
            if plugins:
                settings["PV_PLUGIN_CONFIG_FILE"] = os.path.join(folder, "plugins.xml")
                with open(settings["PV_PLUGIN_CONFIG_FILE"], "w") as file:
                    file.write(plugins)
            return self.execute(os.environ["FLIPFLOP_PVPYTHON"], "--dr", script, **settings)

    def test_load_plugin(self):
        load = f"simple.LoadPlugin({PLUGIN!r}, remote=False, ns=vars(simple))"
        self.assertEqual(self.run_with(load), ["before False", "after True", "cells 96"])

    def test_plugin_path(self):
        lines = self.run_with(PV_PLUGIN_PATH=os.environ["PV_PLUGIN_PATH"])
        self.assertEqual(lines, ["before True", "after True", "cells 96"])

    def test_configuration_file(self):
        plugins = f'<Plugins><Plugin name="FlipFlop" filename="{PLUGIN}"/></Plugins>'
        lines = self.run_with(plugins=plugins)
        self.assertEqual(lines, ["before True", "after True", "cells 96"])

    def test_without_input(self):
        """Each proxy can be made where nothing is open, which VTK minds; a crash would end the process."""
        make = """
for group, module in (("filters", simple), ("writers", simple.servermanager.writers)):
    manager = simple.servermanager.ProxyManager()
    names = manager.SMProxyManager.GetProxyDefinitionManager().NewSingleGroupIterator(group)
    while not names.IsDoneWithTraversal():
        if names.GetProxyName().startswith("FlipFlop"):
            label = manager.GetPrototypeProxy(group, names.GetProxyName()).GetXMLLabel()
            simple.SetActiveSource(None)
            getattr(module, "".join(filter(str.isalnum, label)))()
            print(names.GetProxyName(), flush=True)
        names.GoToNextItem()
late = simple.PointInterpolator2DDelaunayFlipFlop(Input=simple.Sphere())
late.Source = simple.Sphere()
late.UpdatePipeline()
print(late.PointData["vtkValidPointMask"].GetRange(), late.Weights)
"""
        lines = self.run_with(make, complains=True, PV_PLUGIN_PATH=os.environ["PV_PLUGIN_PATH"])
        self.assertEqual(set(lines[1:-3]), {*LABELS, "FlipFlopStreamedWriter"})
        self.assertEqual(lines[-3], "(1.0, 1.0) ['POINTS', 'None']")

    def test_installed(self):
        """In a folder that was not known when it was built; so is the Python package, with and without it."""
        build = os.environ["FLIPFLOP_BUILD"]
        with tempfile.TemporaryDirectory() as prefix:
            self.execute(os.environ["FLIPFLOP_CMAKE"], "--install", build, "--prefix", prefix)
            here = os.path.join(prefix, os.path.relpath(os.environ["PV_PLUGIN_PATH"], build))
            package = os.path.join(
                prefix, os.path.relpath(os.environ["PYTHONPATH"].split(os.pathsep)[0], build)
            )
            mapped = """
for line in open("/proc/self/maps"):
    path = line.split(maxsplit=5)[5:]
    if path and "FlipFlop" in path[0] and "r-x" in line:
        print(path[0].strip())
"""
            lines = self.run_with(mapped, PV_PLUGIN_PATH=here, PYTHONPATH=package)
            self.assertEqual([lines[0], *lines[-2:]], ["before True", "after True", "cells 96"])
            self.assertEqual(len(lines), 6)  # the plugin, and a library for each module
            self.assertTrue(all(line.startswith(here) for line in lines[1:4]), lines)

            lines = self.execute(
                os.environ["FLIPFLOP_PVPYTHON"], "--dr", "-c",
                "import vtkflipflop\nvtkflipflop.vtkFFHullFilter\nprint(vtkflipflop.__file__)" + mapped,
                PYTHONPATH=package,
            )  # fmt: skip
            self.assertEqual(len(lines), 5)  # the package, and for each module its wrapping and its library
            self.assertTrue(all(line.startswith(prefix) for line in lines), lines)


class TestProxies(unittest.TestCase):
    def source(self, name):
        second = {SECOND[name]: simple.Sphere(Radius=2)} if name in SECOND else {}
        return function(name)(Input=updated(simple.Sphere()), **second)

    def test_defaults(self):
        for name, defaults in DEFAULTS.items():
            proxy = self.source(name)
            for key, value in defaults.items():
                got = proxy.GetPropertyValue(key)
                got = list(got) if isinstance(value, list) else got
                self.assertEqual(got, value, f"{name}.{key}")
                self.assertEqual(getattr(proxy, key), proxy.GetPropertyValue(key))
            settings = {
                key
                for key in proxy.ListProperties()
                if not proxy.GetProperty(key).SMProperty.GetInformationOnly()
            }
            self.assertEqual(settings - {"Input", "Transform", "Source", *SECOND.values()}, set(defaults))
        transform = self.source("FlipFlopRegularTriangulation").Transform
        self.assertEqual(transform.GetXMLName(), "Transform3")

    def test_ports(self):
        for name, ports in PORTS.items():
            proxy = self.source(name).SMProxy
            self.assertEqual(proxy.GetNumberOfOutputPorts(), len(ports))
            self.assertEqual([proxy.GetOutputPortName(i) for i in range(len(ports))], ports)

    def test_answers(self):
        proxy = self.source("FlipFlopSelectEnclosedPoints")
        proxy.GenerateDistances = 1
        proxy.UpdatePipeline()
        self.assertEqual(proxy.PointData["SelectedPoints"].GetRange(), (1, 1))
        self.assertEqual(proxy.PointData["FlipFlopSide"].GetRange(), (1, 1))
        self.assertLess(proxy.PointData["FlipFlopDistance"].GetRange()[1], -1.0)
        proxy = self.source("FlipFlopPointInterpolator2D")
        proxy.UpdatePipeline()
        self.assertEqual(proxy.PointData["vtkValidPointMask"].GetRange(), (1, 1))
        self.assertIn("Elevation", proxy.PointData.keys())

    def test_what_a_run_found(self):
        for name in LABELS.keys() - SECOND.keys():
            proxy = self.source(name)
            proxy.UpdatePipeline()
            proxy.UpdatePropertyInformation()
            for key in FOUND:
                self.assertTrue(proxy.GetProperty(key).SMProperty.GetInformationOnly(), key)
            self.assertEqual(proxy.NumberOfInputPoints, 50, name)
            self.assertEqual(proxy.EngineUsed, "CPU")
            self.assertNotEqual(proxy.EngineReason, "")
            self.assertGreaterEqual(proxy.FieldData["FlipFlopThreads"].GetRange()[0], 1)
            self.assertGreater(proxy.FieldData["FlipFlopSecondsTotal"].GetRange()[0], 0.0)

    def test_texts(self):
        with open(os.path.join(os.environ["FLIPFLOP_SOURCE"], "Documentation", "ParaView.md")) as file:
            page = file.read()
        for word, name in SEARCHED.items():
            self.assertIn(word, self.source(name).SMProxy.GetDocumentation().GetShortHelp().lower())
        for name, label in LABELS.items():
            proxy = self.source(name).SMProxy
            self.assertEqual(proxy.GetXMLLabel(), label)
            documentation = proxy.GetDocumentation()
            self.assertGreater(len(documentation.GetShortHelp()), 20)
            self.assertIn("exact", documentation.GetLongHelp())
            self.assertGreater(len(documentation.GetDescription().split()), 80, name)
            self.assertIn("(Flip-Flop)", label)
            self.assertIn("error", documentation.GetDescription())
            self.assertIn(label, page)
            iterator = proxy.NewPropertyIterator()
            iterator.Begin()
            count = 0
            while not iterator.IsAtEnd():
                text = iterator.GetProperty().GetDocumentation()
                self.assertTrue(text and text.GetDescription().strip(), iterator.GetKey())
                count += 1
                iterator.Next()
            self.assertGreater(count, 6 if name in SECOND else 12)

    def test_menu(self):
        for name in LABELS:
            menu = definition(name).FindNestedElementByName("Hints").FindNestedElementByName("ShowInMenu")
            self.assertEqual(menu.GetAttribute("category"), "Flip-Flop")
            self.assertEqual(menu.GetAttribute("icon"), f":/FlipFlop/{name}.svg")
            self.assertTrue(os.path.exists(os.path.join(ICONS, f"{name}.svg")))


if __name__ == "__main__":
    unittest.main()
