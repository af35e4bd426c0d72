# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The hull of a scanned cow, by the menu and the button Apply: its picture, and what ParaView tells of it."""
import os

import gui
import pictures
from paraview import simple


def test(window):
    yield from window.open_file(gui.data("spot.vtp"))
    cloud = simple.GetActiveSource()
    simple.Show(cloud, Representation="Point Gaussian")
    pictures.look_from((1.0, 0.25, -0.75), (0, 1, 0))
    points = pictures.draw(os.path.join(gui.output, "points.png"))

    yield from window.add_filter("Flip-Flop", "Convex Hull (Flip-Flop)")
    yield from window.apply()
    hull = simple.GetActiveSource()
    simple.Hide(cloud)
    simple.Show(hull, Representation="Surface")
    pictures.look_from((1.0, 0.25, -0.75), (0, 1, 0))
    pictures.check("hull.png", gui.output, {"the points": points})

    counts, arrays = yield from window.information()
    gui.check_equal(counts, ["305 (float)", "606"])
    gui.check_range(arrays, "FlipFlopDimension", 3, 3)
    gui.check_range(arrays, "FlipFlopPoints", 2930, 2930)
    gui.check_range(arrays, "FlipFlopVolume", 1.2, 1.3)
    gui.check_range(arrays, "FlipFlopArea", 5, 7)
    gui.check_range(arrays, "FlipFlopSecondsTotal", 0, 60)
    gui.check_equal(arrays["FlipFlopEngine"][0], "string")
    gui.check_equal(window.messages(), "")


gui.run(test)
