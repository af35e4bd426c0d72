# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A file with a NaN: the filter's own words come up in Output Messages, and ParaView goes on."""
import gui
import numpy
from qt import QtWidgets


def test(window):
    coordinates = numpy.random.default_rng(1).random((100, 3))
    coordinates[[7, 42], 1] = numpy.nan
    yield from window.open_file(gui.write_points("nan.vtp", coordinates))
    yield from window.add_filter("Flip-Flop", "Convex Hull (Flip-Flop)")
    gui.check_equal(window.messages(), "")
    yield from window.apply()

    said = "A coordinate is NaN or infinite: first at point 7, 2 such point(s) in all."
    choice = "set Non Finite Points to Ignore."
    yield window.find(QtWidgets.QDockWidget, "outputWidgetDock").isVisible
    assert said in window.messages(), window.messages()
    assert choice in window.messages(), window.messages()
    window.screen("error.png")
    counts, _ = yield from window.information()
    gui.check_equal(counts[1], "0")

    # The choice in the panel does what the message says, and other data is no worse for it.
    yield from window.clear_messages()
    yield from window.show_properties()
    window.property_box("NonFinitePoints").setCurrentText("Ignore")
    yield from window.apply()
    counts, arrays = yield from window.information()
    assert counts[1] != "0", counts
    gui.check_range(arrays, "FlipFlopNonFinitePoints", 2, 2)

    yield from window.open_file(gui.data("spot.vtp"))
    yield from window.add_filter("Flip-Flop", "Convex Hull (Flip-Flop)")
    yield from window.apply()
    counts, _ = yield from window.information()
    gui.check_equal(counts, ["305 (float)", "606"])
    gui.check_equal(window.messages(), "")


gui.run(test)
