# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a filter has to say comes up in Output Messages, in the panel's words; doing what it says helps."""
import gui
import numpy
from qt import QtWidgets


def says(window, *words):
    """The messages that are shown have these words."""
    yield window.find(QtWidgets.QDockWidget, "outputWidgetDock").isVisible
    for part in words:
        assert part in window.messages(), window.messages()


def choose(window, name, choice):
    """What the message says: another choice in the panel, after which nothing is said."""
    yield from window.clear_messages()
    yield from window.show_properties()
    window.property_box(name).setCurrentText(choice)
    yield from window.apply()
    gui.check_equal(window.messages(), "")


def not_finite(window):
    coordinates = numpy.random.default_rng(1).random((100, 3))
    coordinates[[7, 42], 1] = numpy.nan
    yield from window.open_file(gui.write_points("nan.vtp", coordinates))
    yield from window.add_filter("Flip-Flop", "Convex Hull (Flip-Flop)")
    gui.check_equal(window.messages(), "")
    window.tick("ReportAsFieldData")
    yield from window.apply()
    yield from says(window, "A coordinate is NaN or infinite: first at point 7, 2 such point(s) in all.",
                    "set Non Finite Points to Ignore.")
    window.screen("error.png")
    counts, _ = yield from window.information()
    gui.check_equal(counts[1], "0")
    yield from choose(window, "NonFinitePoints", "Ignore")
    counts, arrays = yield from window.information()
    assert counts[1] != "0", counts
    gui.check_range(arrays, "FlipFlopNonFinite", 2, 2)


def without_a_device(window):
    """It is the hull of the points that are finite, still."""
    yield from window.show_properties()
    window.property_box("Engine").setCurrentText("CUDA")
    yield from window.apply()
    if window.messages():  # else there is a device
        yield from says(window, "The CUDA engine was asked for, but ", "Set Engine to Automatic or CPU.")
        window.screen("device.png")
        yield from choose(window, "Engine", "Automatic")
    counts, _ = yield from window.information()
    assert counts[1] != "0", counts


def wall(window):
    """Points in a vertical plane: in the XY plane they are a chain, in their own they have triangles."""
    along, up = numpy.random.default_rng(2).integers(0, 1000, (2, 200))
    yield from window.open_file(gui.write_points("wall.vtp", numpy.stack([along, 2 * along, up], axis=1) + 0.0))
    yield from window.add_filter("Flip-Flop", "Delaunay 2D (Flip-Flop)")
    window.tick("ReportAsFieldData")
    yield from window.apply()
    yield from says(window, "The points are in one vertical plane",
                    "set Projection Plane Mode to Best-Fitting Plane.")
    window.screen("wall.png")
    _, arrays = yield from window.information()
    gui.check_range(arrays, "FlipFlopDimension", 1, 1)
    yield from choose(window, "ProjectionPlaneMode", "Best-Fitting Plane")
    _, arrays = yield from window.information()
    gui.check_range(arrays, "FlipFlopDimension", 2, 2)


def no_surface(window):
    """A file of points has no surface to convexify; the message names the filter that takes it."""
    yield from window.open_file(gui.data("spot.vtp"))
    yield from window.add_filter("Flip-Flop", "Convexify (Flip-Flop)")
    yield from window.apply()
    yield from says(window, "The surface has no polygons: its cells are vertices.", "Convex Hull (vtkFFHullFilter)")
    window.screen("no-surface.png")
    yield from window.clear_messages()


def test(window):
    yield from not_finite(window)
    yield from without_a_device(window)
    yield from wall(window)
    yield from no_surface(window)
    yield from window.open_file(gui.data("spot.vtp"))
    yield from window.add_filter("Flip-Flop", "Convex Hull (Flip-Flop)")
    yield from window.apply()
    counts, _ = yield from window.information()
    gui.check_equal(counts, ["305 (float)", "606"])
    gui.check_equal(window.messages(), "")


gui.run(test)
