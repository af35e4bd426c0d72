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
    gui.check_equal(names, {"autzen.vtp", "Surface", "Flat", "Outline", "Density"})
    surface = simple.FindSource("Surface")
    gui.check_equal(surface.MaximumEdgeLength, 250.0)
    simple.SaveScreenshot(by_state, simple.GetLayout(simple.GetActiveView()), ImageResolution=SIZE)
    check(by_state)
    # The triangles that are left out are those with a longer edge.
    dropped = surface.FieldData["FlipFlopDroppedCells"].GetRange()[0]
    assert dropped > 0, dropped

    by_trace = os.path.join(gui.output, "trace.png")
    script = os.path.join(EXAMPLES, "survey.py")
    result = subprocess.run(
        [os.environ["FLIPFLOP_PVPYTHON"], "--dr", script, by_trace],
        cwd=SOURCE, capture_output=True, text=True, timeout=100,
    )  # fmt: skip
    gui.check_equal((result.returncode, result.stderr), (0, ""))
    check(by_trace)
    gui.check_equal(window.messages(), "")


gui.run(test)
