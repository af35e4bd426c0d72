# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A mountain's triangulation by the menu: without weights as the panel comes up, then with some."""
import os

import gui
import pictures
from paraview import simple

FROM, UP = (0.7, 0.9, 0.75), (0, 0, 1)


def test(window):
    yield from window.open_file(gui.data("sainthelens.vtp"))
    yield from window.add_filter("Alphabetical", "Calculator")
    cloud = simple.GetActiveSource()
    cloud.ResultArrayName, cloud.Function = "weight", "Elevation * Elevation / 10"
    yield from window.apply()
    yield from window.add_filter("Flip-Flop", "Convex Hull (Flip-Flop)")
    yield from window.apply()
    hull = simple.GetActiveSource()
    simple.Show(hull, Representation="Surface")
    pictures.look_from(FROM, UP)
    wrapped = pictures.draw(os.path.join(gui.output, "hull.png"))
    simple.Hide(hull)

    simple.SetActiveSource(cloud)
    yield from window.add_filter("Flip-Flop", "Delaunay 2D (Flip-Flop)")
    weights = window.property_box("Weights")
    gui.check_equal(sorted(gui.choices(weights)), ["Elevation", "None", "weight"])
    gui.check_equal(weights.currentText(), "None")
    assert not window.shown("WeightMode")
    window.tick("ReportAsFieldData")
    yield from window.apply()
    triangulation = simple.GetActiveSource()
    display = simple.Show(triangulation, Representation="Surface")
    display.SetScalarBarVisibility(simple.GetActiveView(), False)
    simple.ColorBy(display, ("POINTS", "Elevation"))
    # The default before ParaView 6.
    simple.GetColorTransferFunction("Elevation").ApplyPreset("Cool to Warm", True)
    pictures.look_from(FROM, UP)
    pictures.check("triangulation.png", gui.output, {"the hull": wrapped})
    counts, arrays = yield from window.information()
    gui.check_range(arrays, "FlipFlopDimension", 2, 2)
    gui.check_range(arrays, "FlipFlopHiddenPoints", 0, 0)
    gui.check_equal(counts[0].replace(",", ""), "17004 (float)")  # as the locale has it

    # Weights that differ more than neighbours are apart hide points. A port has them, and all points are on
    # one of the two.
    yield from window.show_properties()
    weights.setCurrentText("weight")
    yield lambda: window.shown("WeightMode")
    yield from window.apply()
    _, arrays = yield from window.information()
    gui.check_range(arrays, "FlipFlopHiddenPoints", 1, 17003)
    visible, hidden = (
        simple.OutputPort(triangulation, port).GetDataInformation().GetNumberOfPoints()
        for port in (0, 1)
    )
    gui.check_equal(visible + hidden, 17004)
    gui.check_range(arrays, "FlipFlopHiddenPoints", hidden, hidden)

    # What constraints take comes with them.
    yield from window.show_properties()
    weights.setCurrentText("None")
    yield from window.apply()
    assert not window.shown("SplitCrossingConstraints")
    low_x, high_x, low_y, high_y, low, high = cloud.GetDataInformation().GetBounds()
    line = simple.Line(Point1=[low_x, low_y, low], Point2=[high_x, high_y, high])
    simple.SetActiveSource(triangulation)
    triangulation.Source = line
    yield lambda: window.shown("SplitCrossingConstraints")
    window.screen("panel.png")
    triangulation.UpdatePipeline()
    assert simple.OutputPort(triangulation, "Fixed Edges").GetDataInformation().GetNumberOfCells() > 1
    gui.check_equal(window.messages(), "")


gui.run(test)
