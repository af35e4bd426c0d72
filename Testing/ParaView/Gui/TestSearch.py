# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Who searches for a filter finds it by what it makes, with its icon; "?" opens its page, and fields have tooltips."""
import os

import gui
from qt import QtTest, QtWidgets, six

# What somebody types after Ctrl+Space, and a part of what they must find.
FOUND = {
    "delaunay": ["Delaunay 2D (Flip-Flop)"],
    "voronoi": ["Voronoi 2D (Flip-Flop)"],
    "hull": ["Convex Hull (Flip-Flop)", "Select Inside Hull (Flip-Flop)"],
    "interpol": ["Interpolator 2D (Flip-Flop)"],
    "convexify": ["Convexify (Flip-Flop)"],
}
# ParaView 6 also searches the short help.
FOUND_BY_HELP = {
    "raster": ["Points To Image (Flip-Flop)"],
    "natural": ["Interpolator 2D (Flip-Flop)", "Points To Image (Flip-Flop)"],
    "lidar": ["Terrain Mesh (Flip-Flop)", "Points To Image (Flip-Flop)"],
    "weights": ["Delaunay 2D (Flip-Flop)", "Voronoi 2D (Flip-Flop)"],
    "regular": ["Delaunay 2D (Flip-Flop)"],
    "power diagram": ["Voronoi 2D (Flip-Flop)"],
}


def search(window, text):
    """What ParaView's search lists for a text: the icons by the names."""
    entries = window.entries("Filters")
    yield from window.choose("Filters", next(name for name in entries if name.startswith("Search")))
    dialog = yield from window.dialog("pqQuickLaunchDialog", "pqQuickLaunchDialogExtended")
    QtTest.QTest.keyClicks(dialog.findChild(QtWidgets.QLineEdit) or dialog, text)
    yield from window.stands_still(0.2)
    window.screen(f"search-{text}.png")
    model = dialog.findChild(QtWidgets.QListView).model()
    indices = [model.index(row, 0) for row in range(model.rowCount())]
    found = {index.data(): index.data(gui.QtCore.Qt.ItemDataRole.DecorationRole) for index in indices}
    dialog.reject()
    yield lambda: gui.gone(dialog)
    return found


def page(window):
    """The text of the page that the panel's "?" opens."""
    panel = window.find(QtWidgets.QWidget, "propertiesPanel")
    gui.click_for_dialog(panel.findChild(QtWidgets.QPushButton, "Help"))

    def helpers():
        return [w for w in gui.application.topLevelWidgets() if gui.kind(w) == "pqHelpWindow" and w.isVisible()]

    yield lambda: helpers() != []

    def text():
        return "".join(browser.toPlainText() for browser in helpers()[0].findChildren(QtWidgets.QTextBrowser))

    yield lambda: text() != ""
    found = text()
    yield from window.stands_still(0.2)
    window.screen("help.png")
    helpers()[0].close()
    yield lambda: helpers() == []
    return found


def test(window):
    yield from window.open_file(gui.data("autzen.vtp"))
    icons = "FlipFlopIcons" in os.environ["PV_PLUGIN_PATH"]
    for text, names in {**FOUND, **(FOUND_BY_HELP if six else {})}.items():
        found = yield from search(window, text)
        for name in names:
            assert name in found, f"{text} finds {sorted(found)}, not {name}"
            gui.check_equal(found[name] is not None and not found[name].isNull(), icons)

    yield from window.add_filter("Flip-Flop", "Voronoi 2D (Flip-Flop)")
    text = yield from page(window)
    for words in ("Voronoi 2D (Flip-Flop)", "a disk of radius r has the weight", "PowerDiagramBoxMode"):
        assert words in text, text
    tip = window.property_box("ProjectionPlaneMode").parent().toolTip()
    assert "The plane in which the points are triangulated" in tip, tip
    gui.check_equal(window.messages(), "")


gui.run(test)
