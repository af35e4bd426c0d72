# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The streamed writer by File > Save Data: its settings come up, and its file opens."""
import os

import gui
from paraview import simple
from qt import QtWidgets


def test(window):
    path = os.path.join(gui.output, "mountain.vtpd")
    if os.path.exists(path):
        os.remove(path)
    yield from window.open_file(gui.data("sainthelens.vtp"))
    yield from window.choose("File", "Save Data...")
    yield from window.choose_file(path)
    dialog = yield from window.dialog("pqProxyWidgetDialog")
    for name in ("Shape", "Weights", "FacetMode", "NumberOfPieces", "MemoryLimit"):
        yield dialog.findChild(QtWidgets.QWidget, name).isVisible
    gui.photograph(dialog.frameGeometry()).save(os.path.join(gui.output, "settings.png"))
    dialog.accept()
    yield lambda: os.path.exists(path)
    gui.check_equal(window.messages(), "")

    triangulation = simple.Delaunay2DFlipFlop(Input=simple.GetActiveSource())
    triangulation.UpdatePipeline()
    yield from window.open_file(path)
    counts = [source.GetDataInformation().GetNumberOfCells() for source in (simple.GetActiveSource(), triangulation)]
    gui.check_equal(counts[0], counts[1])
    gui.check_equal(window.messages(), "")


gui.run(test)
