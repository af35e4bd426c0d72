# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The session of Examples/ParaView, as a state and as a trace: each gives the picture that the page shows."""
import os
import subprocess

import gui
import numpy
import pictures
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

SOURCE = os.environ["FLIPFLOP_SOURCE"]
EXAMPLES = os.path.join(SOURCE, "Examples", "ParaView")
SHOWN = os.path.join(SOURCE, "Documentation", "Figures", "paraview-survey.png")
SIZE = (1000, 680)


def read(path):
    """The picture's red, green, blue, and as alpha, whether there is anything on the white page."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    colours = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].reshape(height, width, 3)
    alpha = numpy.where(colours.min(axis=2, keepdims=True) < 230, 255, 0).astype(numpy.uint8)
    return numpy.concatenate([colours, alpha], axis=2)


def check(path):
    found, wanted = read(path), read(SHOWN)
    assert pictures.alike(found, wanted), f"{path}: {pictures.compare(found, wanted)}"


def test(window):
    by_state = os.path.join(gui.output, "state.png")
    simple.LoadState(os.path.join(EXAMPLES, "survey.pvsm"), data_directory=os.path.join(SOURCE, "Data"))
    yield from window.stands_still()
    window.screen("window.png")
    names = {name for name, _ in simple.GetSources()}
    texts = {"About the points", "About the mesh", "About the others", "About the raster"}
    gui.check_equal(names, {"sainthelens.vtp", "Line", "Rim", "Mesh", "Pixels", "Raster", "Relief"} | texts)
    mesh = simple.FindSource("Mesh")
    simple.SaveScreenshot(by_state, simple.GetLayout(simple.GetActiveView()), ImageResolution=SIZE)
    check(by_state)
    # What the texts say of the mesh is so.
    kept = mesh.GetDataInformation().GetNumberOfPoints()
    others = simple.OutputPort(mesh, 1).GetDataInformation().GetNumberOfPoints()
    added, beyond = (int(mesh.FieldData[f"FlipFlop{name}Points"].GetRange()[0]) for name in ("Added", "Unreachable"))
    gui.check_equal((kept + others - added, added, beyond), (17004, 14, 0))
    assert f"{kept:,} vertices" in simple.FindSource("About the mesh").Text
    assert f"{others:,} points" in simple.FindSource("About the others").Text
    greatest = mesh.FieldData["FlipFlopGreatestError"].GetRange()[0]
    assert 19 < greatest <= mesh.Tolerance == 20.0, greatest

    # Without a window, the trace draws; without what it needs, it names that.
    script, folder = os.path.join(EXAMPLES, "survey.py"), os.path.join(gui.output, "trace")
    os.makedirs(folder, exist_ok=True)

    def trace(**environment):
        return subprocess.run(
            [os.environ["FLIPFLOP_PVPYTHON"], "--dr", script], env={**os.environ, **environment},
            cwd=folder, capture_output=True, text=True, timeout=100,
        )  # fmt: skip

    for missing, environment in (("the plugin FlipFlop", {"PV_PLUGIN_PATH": ""}), ("Data/sainthelens.vtp", {})):
        result = trace(**environment)
        assert result.returncode != 0 and f"survey.py needs {missing}: " in result.stderr, result.stderr
    os.symlink(os.path.join(SOURCE, "Data"), os.path.join(folder, "Data"))
    result = trace()
    os.remove(os.path.join(folder, "Data"))
    by_trace = os.path.join(folder, "survey.png")
    gui.check_equal((result.returncode, result.stdout, result.stderr), (0, f"The picture is {by_trace}\n", ""))
    check(by_trace)

    # In the window, the trace selects the filter to try, so that its panel shows. A state selects nothing.
    os.chdir(SOURCE)
    session = {}
    with open(script) as file:
        exec(compile(file.read(), script, "exec"), session)
    gui.check_equal(simple.GetActiveSource(), session["mesh"])
    yield from window.show_properties()
    panel = window.find(gui.QtWidgets.QWidget, "propertiesPanel")
    yield panel.findChild(gui.QtWidgets.QWidget, "Tolerance").isVisible
    yield from window.stands_still()
    window.screen("selected.png")
    gui.check_equal(window.messages(), "")
    assert not os.path.exists("survey.png")


gui.run(test)
