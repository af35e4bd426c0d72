# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What Start Trace writes while somebody works in the window, pvpython does again; so it does what the page tells."""
import os
import re
import subprocess

import gui
from paraview import simple
from qt import QtWidgets

READ = """
for source in GetSources().values():
    information = source.GetDataInformation()
    print(information.GetNumberOfPoints(), information.GetNumberOfCells())
"""


def run(name, script):
    """What a script prints in pvpython, line by line."""
    path = os.path.join(gui.output, name)
    with open(path, "w") as file:
        file.write(script)
    result = subprocess.run(
        [os.environ["FLIPFLOP_PVPYTHON"], "--dr", path],
        cwd=os.environ["FLIPFLOP_SOURCE"], capture_output=True, text=True, timeout=60,
    )  # fmt: skip
    gui.check_equal((result.returncode, result.stderr), (0, ""))
    return result.stdout.split("\n")[:-1]


def trace(window):
    """Record how a hull is taken by hand; the script that comes of it."""
    yield from window.choose("Tools", "Start Trace")
    options = yield from window.dialog("pqProxyWidgetDialog")
    gui.click(options.findChild(QtWidgets.QPushButton, "OKButton"))
    yield lambda: gui.gone(options)
    yield from window.open_file(gui.data("spot.vtp"))
    yield from window.add_filter("Flip-Flop", "Convex Hull (Flip-Flop)")
    window.property_box("FacetMode").setCurrentText("Polygons")
    yield from window.apply()
    yield from window.choose("Tools", "Stop Trace")

    def editors():
        return [w for w in gui.application.topLevelWidgets() if gui.kind(w) == "pqPythonScriptEditor"]

    yield lambda: any(editor.isVisible() for editor in editors())
    return next(
        text.toPlainText()
        for text in editors()[0].findChildren(QtWidgets.QTextEdit)
        if gui.kind(text.parent()) == "pqPythonTextArea"
    )


def test(window):
    script = yield from trace(window)
    assert "ConvexHullFlipFlop(" in script and "FacetMode = 'Polygons'" in script, script
    hull = simple.GetActiveSource().GetDataInformation()
    shown = f"{hull.GetNumberOfPoints()} {hull.GetNumberOfCells()}"
    gui.check_equal(sorted(run("trace.py", script + READ)), sorted(["2930 2930", shown]))

    with open(os.path.join(os.environ["FLIPFLOP_SOURCE"], "Documentation", "ParaView.md")) as page:
        example = re.search("```python\n(.*?)```", page.read(), re.S).group(1)
    visible, hidden, found = run("page.py", example)
    gui.check_equal(int(visible) + int(hidden), 10653)
    gui.check_equal(found.split()[1], "3.0")
    gui.check_equal(window.messages(), "")


gui.run(test)
