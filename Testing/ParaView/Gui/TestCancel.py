# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""
The button beside the progress bar, with the plugin FlipFlopCancel: pressed by a pointer of the X server's in the
middle of a run, it ends that run; pressed not, or beside it, nothing is cancelled.
"""
import subprocess
import sys
import time

import gui
from qt import QtCore, QtWidgets

OFFERED = 0.4  # seconds after which FlipFlopCancel has long been watching; ParaView 6 enables the button at once
SOON = 1 / 2  # from the press to the end of Apply, drawing included: of the time of a whole run


class Pointer(QtCore.QObject):
    """
    Told to act, it does so once, at a progress event with the button enabled: ParaView's thread is the
    filter's then, so the X server moves and clicks at the bidding of another process.
    """

    def __init__(self, window):
        super().__init__()
        self.label = window.find(QtWidgets.QLabel, "ProgressBar")
        self.button = window.find(QtWidgets.QToolButton, "AbortButton")
        self.command, self.start, self.acted, self.enabled = [], None, None, []
        self.label.installEventFilter(self)

    def eventFilter(self, watched, event):
        if event.type() == QtCore.QEvent.Type.Paint and "Convex hull" in self.label.text():
            self.enabled.append(self.button.isEnabled())
            now = time.monotonic()
            if self.enabled[-1] and self.command and now - self.start > OFFERED:
                self.acted = now
                subprocess.Popen(["xdotool", *self.command])
                self.command = []
        return False

    def click(self, widget):
        place = widget.mapToGlobal(widget.rect().center())
        return ["mousemove", str(place.x()), str(place.y()), "click", "1"]


def test(window):
    hull = yield from gui.add_long_hull(window, 2_000_000)
    pointer, accept = Pointer(window), window.find(QtWidgets.QPushButton, "Accept")
    runs = []

    def apply():
        """Press Apply: seconds, and how often the filter ran."""
        pointer.enabled.clear()
        del runs[:]
        start = pointer.start = time.monotonic()
        gui.click(accept)
        gui.check_equal(pointer.button.isEnabled(), False)
        return time.monotonic() - start, len(runs)

    def cancel():
        """Press Apply, then the button: seconds from there to the end."""
        pointer.command = pointer.click(pointer.button)
        _, times = apply()
        end = time.monotonic()
        assert not pointer.command, "the button was never enabled"
        gui.check_equal(times, 1)
        gui.check_equal(hull.GetClientSideObject().GetAbortExecute(), 0)
        return end - pointer.acted

    def press_and_see():
        yield accept.isEnabled
        waited.append(cancel())
        gui.check_equal((yield from window.information())[0][1], "0")

    waited = []
    hull.GetClientSideObject().AddObserver("StartEvent", lambda *_: runs.append(1))
    yield from press_and_see()

    # Apply runs it whole. What else the user does meanwhile waits for the end: a click beside the button,
    # another size of the window, and so of the view.
    yield accept.isEnabled
    top = str(int(window.window.winId()))
    pointer.command = [*pointer.click(pointer.label), "windowsize", top, "1000", "800",
                       "windowsize", top, "1500", "1100"]
    seconds, times = apply()
    assert not pointer.command, f"the button was enabled: {pointer.enabled}"
    gui.check_equal(times, 1)
    yield lambda: window.window.width() == 1500
    whole, _ = yield from window.information()
    assert whole[1] != "0", whole

    # So does a change.
    yield from window.show_properties()
    window.property_box("NonFinitePoints").setCurrentText("Ignore")
    yield from press_and_see()
    yield from window.show_properties()
    window.property_box("NonFinitePoints").setCurrentText("Report an Error")
    _, times = apply()
    gui.check_equal(times, 1)
    gui.check_equal((yield from window.information())[0], whole)

    print(f"whole {seconds:.2f} s, pressed", *(f"{one:.2f} s" for one in waited), "before the end",
          file=sys.__stderr__)
    assert max(waited) < SOON * seconds, f"it ran on for {waited} seconds, where a run takes {seconds:.2f}"
    gui.check_equal(window.messages(), "")


gui.run(test)
