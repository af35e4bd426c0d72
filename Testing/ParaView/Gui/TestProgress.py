# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""
A long run: the progress bar follows it and names its steps, and it stops soon after it is asked to, by the filter's own
AbortExecute, between two progress events.
"""
import time

import gui
from qt import QtCore, QtWidgets

SOON = 1 / 2  # from the request to the end of Apply, drawing included: of the time of a whole run


class ProgressWatch(QtCore.QObject):
    """Sees each time that the progress bar is painted while the filter runs."""

    def __init__(self, window):
        super().__init__()
        self.label = window.find(QtWidgets.QLabel, "ProgressBar")
        self.parts, self.texts, self.on_progress = [], set(), None
        self.label.installEventFilter(self)

    def eventFilter(self, watched, event):
        if event.type() == QtCore.QEvent.Type.Paint and "Convex hull" in self.label.text():
            self.parts.append(self.filled_part())
            self.texts.add(self.label.text())
            if self.on_progress:
                self.on_progress()
        return False

    def filled_part(self):
        """How much of the bar on the screen has the colour of its left end; the text is in the middle."""
        area = QtCore.QRect(self.label.mapToGlobal(QtCore.QPoint(0, 0)), self.label.size())
        area.setHeight(1)
        image = gui.photograph(area.translated(0, self.label.height() // 4))
        blue = [image.pixelColor(x, 0).blue() - image.pixelColor(x, 0).red() > 60
                for x in range(image.width())]
        return sum(blue) / len(blue)


def test(window):
    hull = yield from gui.add_long_hull(window, 1_200_000)
    watch = ProgressWatch(window)
    start = time.monotonic()
    yield from window.apply()
    seconds = time.monotonic() - start
    parts = watch.parts[1:]  # the first is of what was on the screen before
    assert len(parts) >= 5, f"the bar was painted {len(parts)} times: {parts}"
    assert parts == sorted(parts), f"the bar went back: {parts}"
    assert parts[0] < 0.3 and parts[-1] > 0.4, f"the bar showed {parts}"
    steps = {text.split(":")[1].strip() for text in watch.texts if ":" in text}
    assert steps, f"the bar's texts were {watch.texts}"
    whole, _ = yield from window.information()
    assert whole[1] != "0", whole

    asked = []

    def abort():
        if not asked:
            asked.append(time.monotonic())
            hull.GetClientSideObject().SetAbortExecute(1)

    yield from window.show_properties()
    watch.on_progress = abort
    window.property_box("NonFinitePoints").setCurrentText("Ignore")
    yield from window.apply()
    waited = time.monotonic() - asked[0]
    assert waited < SOON * seconds, f"it ran on for {waited:.2f} seconds, where a run takes {seconds:.2f}"
    counts, _ = yield from window.information()
    gui.check_equal(counts[1], "0")

    # VTK's flag stays until somebody takes it back; then the next run is whole.
    hull.GetClientSideObject().SetAbortExecute(0)
    yield from window.show_properties()
    window.property_box("NonFinitePoints").setCurrentText("Report an Error")
    yield from window.apply()
    gui.check_equal((yield from window.information())[0], whole)
    gui.check_equal(window.messages(), "")


gui.run(test)
