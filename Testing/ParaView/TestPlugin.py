# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin as ParaView sees it: how it is loaded, and what its filters offer."""

import os
import re
import subprocess
import tempfile
import unittest

import vtkflipflop
from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import VTK_INT_MAX

from pipelines import report, run

ICONS = os.path.join(os.environ["FLIPFLOP_SOURCE"], "Plugin", "Icons")
PLUGIN = os.path.join(os.environ["PV_PLUGIN_PATH"], "FlipFlop.so")
LABELS = {
    "FlipFlopConvexHull": "Convex Hull (Flip-Flop)",
    "FlipFlopConvexify": "Convexify (Flip-Flop)",
    "FlipFlopDelaunay": "Delaunay 2D (Flip-Flop)",
    "FlipFlopPowerDiagram": "Voronoi 2D (Flip-Flop)",
    "FlipFlopSelectEnclosedPoints": "Select Inside Hull (Flip-Flop)",
    "FlipFlopPointInterpolator2D": "Interpolator 2D (Flip-Flop)",
    "FlipFlopPointsToImage": "Points To Image (Flip-Flop)",
    "FlipFlopTerrainMesh": "Terrain Mesh (Flip-Flop)",
    "FlipFlopMesh": "Mesh 2D (Flip-Flop)",
}
PROXIES = {**dict.fromkeys(LABELS, "filters"), "FlipFlopStreamedWriter": "writers"}
# What somebody may search for, and a filter whose short help has it. ParaView 5.11 searches labels alone.
SEARCHED = {
    "raster": "FlipFlopPointsToImage",
    "natural": "FlipFlopPointInterpolator2D",
    "lidar": "FlipFlopTerrainMesh",
    "finite elements": "FlipFlopMesh",
    "power diagram": "FlipFlopPowerDiagram",
    "enclosed": "FlipFlopSelectEnclosedPoints",
    **dict.fromkeys(["regular", "weighted delaunay", "weights", "alpha shape", "breaklines"], "FlipFlopDelaunay"),
}
# The second input of those that answer questions at the points of the first.
SECOND = {"FlipFlopSelectEnclosedPoints": "Surface", "FlipFlopPointInterpolator2D": "Source"}
PORTS = {
    "FlipFlopConvexHull": ["Hull"],
    "FlipFlopConvexify": ["Hull"],
    "FlipFlopDelaunay": ["Triangulation", "Hidden Points", "Border", "Fixed Edges"],
    "FlipFlopPowerDiagram": ["Power Diagram"],
    "FlipFlopSelectEnclosedPoints": ["Points"],
    "FlipFlopPointInterpolator2D": ["Points"],
    "FlipFlopPointsToImage": ["Image"],
    "FlipFlopTerrainMesh": ["Mesh", "Other Points"],
    "FlipFlopMesh": ["Mesh", "Fixed Edges"],
}
# Properties that the classes have no Get for: arrays, and the box, which has the bounds of the points.
WITHOUT_GET = {"Weights", "Heights", "Sizes", "PowerDiagramCorner", "PowerDiagramLengths"}
# Those of either engine.
ENGINES = {"FlipFlopConvexHull", "FlipFlopDelaunay", "FlipFlopPowerDiagram", "FlipFlopPointsToImage"}
MOST_BASIC = 10  # properties that a panel shows, whatever is set and without its gear


def function(name):
    """What makes a filter in Python: ParaView names it for the label."""
    return getattr(simple, re.sub("[^A-Za-z0-9]", "", LABELS[name]))


def prototype(name):
    """The proxy of a name as its XML has it."""
    return servermanager.ProxyManager().SMProxyManager.GetPrototypeProxy(PROXIES[name], name)


def properties(proxy):
    """The properties of a proxy by their names."""
    found, iterator = {}, proxy.NewPropertyIterator()
    iterator.Begin()
    while not iterator.IsAtEnd():
        found[iterator.GetKey()] = iterator.GetProperty()
        iterator.Next()
    return found


def settings_of(proxy):
    """Those that are neither inputs nor proxies."""
    return {key: prop for key, prop in properties(proxy).items() if not prop.IsA("vtkSMProxyProperty")}


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
late = simple.Interpolator2DFlipFlop(Input=simple.Sphere())
late.Source = simple.Sphere()
late.UpdatePipeline()
print(late.PointData["vtkValidPointMask"].GetRange(), late.Weights)
"""
        lines = self.run_with(make, complains=True, PV_PLUGIN_PATH=os.environ["PV_PLUGIN_PATH"])
        self.assertEqual(set(lines[1:-3]), set(PROXIES))
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
    def source(self, name, **settings):
        if name in SECOND:
            settings[SECOND[name]] = simple.Sphere(Radius=2)
        flat = name == "FlipFlopMesh"  # the sides of polygons on a sphere cross in the plane
        return function(name)(Input=run(simple.Plane() if flat else simple.Sphere()), **settings)

    def test_defaults(self):
        """They are the classes' own."""
        for name in PROXIES:
            proxy = prototype(name)
            plain = getattr(vtkflipflop, proxy.GetVTKClassName())()
            for key, prop in settings_of(proxy).items():
                if key in WITHOUT_GET:
                    continue
                own = getattr(plain, re.sub("^(Set|Store)", "Get", prop.GetCommand()))()
                own = list(own) if isinstance(own, tuple) else [own]
                found = [prop.GetElement(i) for i in range(prop.GetNumberOfElements())]
                if prop.IsA("vtkSMStringVectorProperty"):
                    own, found = ([text or "" for text in texts] for texts in (own, found))
                if key == "CUDAThreshold":
                    own = [min(own[0], VTK_INT_MAX)]  # all above mean the same, and ParaView reads no greater default
                self.assertEqual(found, own, f"{name}.{key}")
        self.assertEqual(self.source("FlipFlopDelaunay").Transform.GetXMLName(), "Transform3")

    def test_panels(self):
        """What they show at first is little, and all of it settings."""
        for name in PROXIES:
            proxy = prototype(name)
            groups = [proxy.GetPropertyGroup(i) for i in range(proxy.GetNumberOfPropertyGroups())]
            conditional = {
                group.GetPropertyName(i)
                for group in groups
                if group.GetHints()
                for i in range(group.GetNumberOfProperties())
            }
            basic = []
            for key, prop in settings_of(proxy).items():
                self.assertFalse(prop.GetInformationOnly(), key)
                self.assertFalse(prop.IsA("vtkSMIdTypeVectorProperty"), f"ParaView 5.11 does not show {key}")
                hints = prop.GetHints()
                decorated = hints and hints.FindNestedElementByName("PropertyWidgetDecorator")
                if prop.GetPanelVisibility() == "default" and not decorated and key not in conditional:
                    basic.append(key)
            self.assertLessEqual(len(basic), MOST_BASIC, f"{name} shows {basic}")
            for key in ("Engine", "CUDAThreshold"):
                self.assertEqual(proxy.GetProperty(key) is not None, name in ENGINES, name)

    def test_original_ids(self):
        hull = self.source("FlipFlopConvexHull", GenerateOriginalIds=1)
        self.assertEqual(report(hull).GetVisiblePointIds(), True)
        self.assertIn("OriginalPointIds", run(hull).PointData.keys())

    def test_ports(self):
        for name, ports in PORTS.items():
            proxy = self.source(name).SMProxy
            self.assertEqual(proxy.GetNumberOfOutputPorts(), len(ports))
            self.assertEqual([proxy.GetOutputPortName(i) for i in range(len(ports))], ports)

    def test_answers(self):
        proxy = run(self.source("FlipFlopSelectEnclosedPoints", GenerateDistances=1))
        self.assertEqual(proxy.PointData["SelectedPoints"].GetRange(), (1, 1))
        self.assertEqual(proxy.PointData["FlipFlopSide"].GetRange(), (1, 1))
        self.assertLess(proxy.PointData["FlipFlopDistance"].GetRange()[1], -1.0)
        proxy = run(self.source("FlipFlopPointInterpolator2D"))
        self.assertEqual(proxy.PointData["vtkValidPointMask"].GetRange(), (1, 1))
        self.assertIn("Elevation", proxy.PointData.keys())

    def test_report(self):
        for name in LABELS.keys() - SECOND.keys():
            found = run(self.source(name, ReportAsFieldData=1)).FieldData
            self.assertGreaterEqual(found["FlipFlopThreads"].GetRange()[0], 1, name)
            self.assertGreater(found["FlipFlopSecondsTotal"].GetRange()[0], 0.0)

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
            for key, prop in properties(proxy).items():
                text = prop.GetDocumentation()
                self.assertTrue(text and text.GetDescription().strip(), key)

    def test_menu(self):
        with open(os.path.join(ICONS, "FlipFlopIcons.qrc")) as file:
            icons = file.read()
        for name in LABELS:
            menu = definition(name).FindNestedElementByName("Hints").FindNestedElementByName("ShowInMenu")
            self.assertEqual(menu.GetAttribute("category"), "Flip-Flop")
            self.assertEqual(menu.GetAttribute("icon"), f":/FlipFlop/{name}.svg")
            self.assertIn(f"<file>{name}.svg</file>", icons)


if __name__ == "__main__":
    unittest.main()
