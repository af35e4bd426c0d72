# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tools > Manage Plugins > Load New brings the filters into their menu, where nothing else loaded them."""
import os

import gui
from qt import QtWidgets


def test(window):
    assert "Flip-Flop" not in window.entries("Filters"), "the plugin is there before it is loaded"
    yield from window.choose("Tools", "Manage Plugins...")
    manager = yield from window.dialog("pqPluginDialog")
    gui.click_for_dialog(manager.findChild(QtWidgets.QPushButton, "loadLocal"))
    yield from window.choose_file(os.environ["FLIPFLOP_PLUGIN"])
    listed = manager.findChild(QtWidgets.QTreeWidget, "localPlugins")
    yield lambda: ["FlipFlop", "Loaded"] in gui.rows(listed.model())
    window.screen("plugin-manager.png")
    manager.close()
    yield lambda: gui.gone(manager)
    for name in ("Convex Hull", "Convexify", "Delaunay 2D", "Voronoi 2D"):
        assert f"{name} (Flip-Flop)" in window.entries("Filters", "Flip-Flop"), name
    gui.check_equal(window.messages(), "")


gui.run(test)
