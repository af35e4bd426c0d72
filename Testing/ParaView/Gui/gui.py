# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""
A hand on ParaView's window: menus, dialogs, buttons, panels, for scripts that run inside it.

ParaView's own Python runs the script (paraview --script), and PyQt finds the widgets of the process
that it is in. ParaView has the event loop, so a script is a generator, taken up by a timer: it yields
a condition, and goes on once that holds. What opens a dialog is triggered by the event loop, too; the
dialog's own loop runs the timer on.

    def test(gui):
        yield from gui.open_file("Data/spot.vtp")
        yield from gui.add_filter("Flip-Flop", "Convex Hull (Flip-Flop)")
        yield from gui.apply()

    gui.run(test)
"""
import os
import sys
import time
import traceback

import numpy
from paraview import simple
from qt import QtCore, QtTest, QtWidgets, sip
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

PATIENCE = 30.0  # seconds that a condition may take to come true

application = QtWidgets.QApplication.instance()
output = os.environ["FLIPFLOP_GUI_OUTPUT"]
_kept = []  # Qt does not keep Python's objects alive


def kind(widget):
    return widget.metaObject().className()


def data(name):
    return os.path.join(os.environ["FLIPFLOP_SOURCE"], "Data", name)


def write_points(name, coordinates, **arrays):
    """Write points, with these point arrays, to a file of the output folder; its path."""
    points, cloud = vtkPoints(), vtkPolyData()
    points.SetData(numpy_to_vtk(numpy.asarray(coordinates, float), deep=True))
    cloud.SetPoints(points)
    for array_name, values in arrays.items():
        array = numpy_to_vtk(values, deep=True)
        array.SetName(array_name)
        cloud.GetPointData().AddArray(array)
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(os.path.join(output, name))
    writer.SetInputData(cloud)
    writer.SetCompressorTypeToNone()
    writer.SetDataModeToBinary()  # appended data cannot be read with every expat
    assert writer.Write()
    return writer.GetFileName()


def add_long_hull(window, count):
    """
    A filter that runs long, on one thread, and whose result is little to draw: of points within rounding of a
    plane nearly every decision is a close call.
    """
    points = numpy.random.default_rng(1).random((count, 3))
    points[:, 2] = (points[:, 0] + points[:, 1]) / 3
    yield from window.open_file(write_points("plane.vtp", points))
    yield from window.add_filter("Flip-Flop", "Convex Hull (Flip-Flop)")
    hull = simple.GetActiveSource()
    hull.NumberOfThreads = 1
    return hull


def check_equal(found, wanted):
    assert found == wanted, f"{found!r}, not {wanted!r}"


def check_range(arrays, name, least, most):
    """Of one value, which the Information panel shows as a type and a range such as [3, 3]."""
    assert name in arrays, f"no array {name} in {sorted(arrays)}"
    low, value = (float(text) for text in arrays[name][1].strip("[]").split(","))
    assert low == value and least <= value <= most, f"{name} is {value}, not in [{least}, {most}]"


def choices(box):
    return [box.itemText(i) for i in range(box.count())]


def plain(text):
    """Of a label: without the mark of its shortcut."""
    return text.replace("&", "")


def click(widget):
    assert widget.isEnabled() and widget.isVisible(), f"{widget.objectName()} cannot be clicked"
    QtTest.QTest.mouseClick(widget, QtCore.Qt.MouseButton.LeftButton)


def click_for_dialog(widget):
    """Click what opens a dialog: it returns only when that is closed."""
    QtCore.QTimer.singleShot(0, lambda: click(widget))


def gone(widget):
    return sip.isdeleted(widget) or not widget.isVisible()


def rows(model):
    """What a table shows: a list of texts for each row."""
    return [
        [model.index(row, column).data() for column in range(model.columnCount())]
        for row in range(model.rowCount())
    ]


def photograph(area):
    """The image of an area of the screen."""
    screen = application.primaryScreen()
    return screen.grabWindow(0, area.x(), area.y(), area.width(), area.height()).toImage()


class Gui:
    """ParaView's main window."""

    def __init__(self):
        self.window = next(
            widget
            for widget in application.topLevelWidgets()
            if isinstance(widget, QtWidgets.QMainWindow) and widget.isVisible()
        )
        screen = application.primaryScreen().geometry()
        self.window.setGeometry(screen)

    def find(self, widget_class, name):
        found = self.window.findChild(widget_class, name)
        assert found is not None, f"ParaView has no {widget_class.__name__} named {name}"
        return found

    # -- menus and dialogs

    def menu(self, *path):
        """The menu of a path such as "Filters", "Flip-Flop"."""
        menu = self.window.menuBar()
        for name in path:
            below = {plain(a.text()): a.menu() for a in menu.actions() if a.menu()}
            assert name in below, f"no menu {name} among {sorted(below)}"
            menu = below[name]
            menu.aboutToShow.emit()  # some are filled only then
        return menu

    def entries(self, *path):
        """What is enabled in a menu, and what is not: its entries by name."""
        return {plain(action.text()): action for action in self.menu(*path).actions()}

    def choose(self, *path):
        """Choose an entry of a menu."""
        found = []

        def enabled():
            action = self.entries(*path[:-1]).get(path[-1])
            found[:] = [action]
            return action is not None and action.isEnabled()

        yield enabled
        QtCore.QTimer.singleShot(0, found[0].trigger)

    def dialog(self, *names):
        """Wait for the dialog of a class, or of one of several: versions of ParaView differ."""
        yield lambda: application.activeModalWidget() is not None
        dialog = application.activeModalWidget()
        assert kind(dialog) in names, f"a {kind(dialog)} came up where a {' or '.join(names)} should"
        return dialog

    def choose_file(self, path):
        """Give a path to the file dialog that is coming up."""
        dialog = yield from self.dialog("pqFileDialog")
        name = dialog.findChild(QtWidgets.QLineEdit, "EntityName")
        name.setText(path)
        QtTest.QTest.keyClick(name, QtCore.Qt.Key.Key_Return)
        yield lambda: gone(dialog)

    # -- the pipeline

    def open_file(self, path):
        yield from self.choose("File", "Open...")
        yield from self.choose_file(path)
        yield from self.apply()

    def add_filter(self, category, name):
        """Choose a filter from its category in the menu Filters."""
        yield from self.choose("Filters", category, name)
        yield self.find(QtWidgets.QPushButton, "Accept").isEnabled

    def apply(self):
        """Press Apply. The pipeline runs before the click returns."""
        accept = self.find(QtWidgets.QPushButton, "Accept")
        yield accept.isEnabled
        click(accept)
        yield lambda: not accept.isEnabled()

    # -- what ParaView shows

    def show_tab(self, name):
        """Bring a panel to the front that shares its place with others."""
        for tabs in self.window.findChildren(QtWidgets.QTabBar):
            names = [plain(tabs.tabText(i)) for i in range(tabs.count())]
            if name in names:
                tabs.setCurrentIndex(names.index(name))

    def show_properties(self):
        self.show_tab("Properties")
        yield self.find(QtWidgets.QWidget, "propertiesPanel").isVisible

    def shown(self, name):
        """What the Properties panel shows of a property, or None. It keeps the widgets of other filters, hidden."""
        widgets = self.find(QtWidgets.QWidget, "propertiesPanel").findChildren(QtWidgets.QWidget, name)
        return next((widget for widget in widgets if widget.isVisible()), None)

    def property_box(self, name):
        """The list of choices of a property in the Properties panel, also of an advanced one."""
        panel = self.find(QtWidgets.QWidget, "propertiesPanel")
        return (self.shown(name) or panel.findChild(QtWidgets.QWidget, name)).findChild(QtWidgets.QComboBox)

    def tick(self, name):
        """Tick the box of a property in the Properties panel."""
        box = self.shown(name).findChild(QtWidgets.QCheckBox)
        QtTest.QTest.mouseClick(box, QtCore.Qt.MouseButton.LeftButton, pos=QtCore.QPoint(8, box.height() // 2))
        assert box.isChecked()

    def information(self):
        """
        What the Information panel shows of the active source: its counts of points and cells, and its
        arrays, for each a list of texts by the array's name.
        """
        self.show_tab("Information")
        table = self.find(QtWidgets.QTreeView, "dataArraysTable")
        yield table.isVisible
        counts = [self.find(QtWidgets.QLabel, name).text() for name in ("pointCount", "cellCount")]
        return counts, {row[0]: row[1:] for row in rows(table.model())}

    def messages(self):
        """All that the window "Output Messages" holds, in full."""
        return self.find(QtWidgets.QWidget, "outputWidget").findChild(QtWidgets.QTextEdit).toPlainText()

    def clear_messages(self):
        clear = self.find(QtWidgets.QWidget, "outputWidget").findChild(QtWidgets.QPushButton, "clearButton")
        click(clear)
        yield lambda: self.messages() == ""

    def screen(self, name, area=None):
        """Photograph the whole screen, or an area of it."""
        area = area or application.primaryScreen().geometry()
        photograph(area).save(os.path.join(output, name))

    def stands_still(self, seconds=0.5):
        """Wait until the screen has not changed for so long."""
        area, last, since = application.primaryScreen().geometry(), None, 0.0

        def still():
            nonlocal last, since
            now = photograph(area)
            if now != last:
                last, since = now, time.monotonic()
            return time.monotonic() - since > seconds

        yield still


class Run:
    """Takes a test's generator up again and again, until it ends or fails."""

    def __init__(self, test):
        self.test = test
        self.condition = lambda: True
        self.since = time.monotonic()
        self.steps = None

    def step(self):
        try:
            self.steps = self.steps or self.test(Gui())
            if self.condition():
                self.condition = next(self.steps, None)
                self.since = time.monotonic()
            elif time.monotonic() - self.since > PATIENCE:
                self.steps.throw(TimeoutError(f"did not come true in {PATIENCE:g} seconds"))
            if self.condition:
                QtCore.QTimer.singleShot(20, self.step)
            else:
                open(os.path.join(output, "passed"), "w").close()
                application.exit(0)
        except BaseException:
            traceback.print_exc(file=sys.__stderr__)
            area = application.primaryScreen().geometry()
            photograph(area).save(os.path.join(output, "failed.png"))
            application.exit(1)


def run(test):
    """Run a test once ParaView's window is up, and end ParaView."""
    _kept.append(Run(test))
    QtCore.QTimer.singleShot(0, _kept[-1].step)
