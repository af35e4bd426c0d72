# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each filter on its first Apply, as it comes, on what people have: something is seen, and it is what was meant."""
import os

import gui
import numpy
from paraview import simple
from qt import QtCore, QtTest, QtWidgets

HULL, DELAUNAY = "Convex Hull (Flip-Flop)", "Delaunay 2D (Flip-Flop)"
DIAGRAM, CONVEXIFY = "Voronoi 2D (Flip-Flop)", "Convexify (Flip-Flop)"
TERRAIN = "Terrain Mesh (Flip-Flop)"


def shown(window, source):
    """Show a source made here, as if it had been opened."""
    simple.Show(source)
    simple.ResetCamera()
    simple.SetActiveSource(source)
    yield from window.stands_still(0.2)


def blocks(window):
    spheres = [simple.Sphere(Center=[x, 0, 0]) for x in (0, 2)]
    yield from shown(window, simple.GroupDatasets(Input=spheres))


def table(window):
    """A table has no points until ParaView makes some of it."""
    path = os.path.join(gui.output, "table.csv")
    numpy.savetxt(path, numpy.random.default_rng(2).random((500, 3)), delimiter=",", header="x,y,z", comments="")
    reader = simple.CSVReader(FileName=[path])
    yield from shown(window, simple.TableToPoints(Input=reader, XColumn="x", YColumn="y", ZColumn="z"))


def clean_box(window):
    """ParaView's box has each corner three times."""
    yield from shown(window, simple.Clean(Input=simple.Box()))


def million(window):
    points = numpy.random.default_rng(1).normal(size=(1_000_000, 3))
    yield from window.open_file(gui.write_points("million.vtp", points))


def file(name):
    return lambda window: window.open_file(gui.data(name))


def source(name, **settings):
    return lambda window: shown(window, getattr(simple, name)(**settings))


# A filter, an input, and the number of cells that come.
CASES = {
    "hull": (HULL, file("spot.vtp"), 606),
    "hull-million": (HULL, million, None),
    "hull-blocks": (HULL, blocks, 2 * 96),
    "hull-image": (HULL, source("Wavelet"), 12),
    "hull-table": (HULL, table, None),
    "hull-box": (HULL, source("Box"), 12),
    "delaunay": (DELAUNAY, file("sainthelens.vtp"), 33480),
    "delaunay-survey": (DELAUNAY, file("autzen.vtp"), 21285),
    "diagram": (DIAGRAM, file("autzen.vtp"), 10653),
    "diagram-image": (DIAGRAM, source("Wavelet"), 441),
    "terrain": (TERRAIN, file("sainthelens.vtp"), None),
    "convexify-box": (CONVEXIFY, clean_box, 12),
}


def first_apply(window, name):
    """The output's information, and how it is displayed."""
    label, make, count = CASES[name]
    simple.ResetSession()
    yield from make(window)
    yield from window.add_filter("Flip-Flop", label)
    gui.check_equal(window.shown("CompositeMode") is not None, name == "hull-blocks")
    yield from window.apply()
    yield from window.stands_still(0.2)
    window.screen(f"{name}.png")
    found = simple.GetActiveSource()
    information = found.GetDataInformation()
    cells = information.GetNumberOfCells()
    assert cells == count if count else cells > 20, f"{name} has {cells} cells"
    return found, information, simple.GetDisplayProperties(found)


def box_in_the_view(window, diagram, information):
    """The box given is the data's at first; ParaView's widget moves it."""
    window.property_box("PowerDiagramBoxMode").setCurrentText("Bounds Given")
    yield from window.apply()
    bounds = information.GetBounds()
    gui.check_equal(diagram.GetDataInformation().GetBounds(), bounds)
    panel = window.find(QtWidgets.QWidget, "propertiesPanel")
    widget = panel.findChild(QtWidgets.QWidget, "InteractiveBox")
    yield widget.isVisible
    yield from window.stands_still(0.2)
    window.screen("diagram-box.png")
    x = widget.findChild(QtWidgets.QLineEdit, "translateX")
    x.selectAll()
    QtTest.QTest.keyClicks(x, str(bounds[0] + 100))
    QtTest.QTest.keyClick(x, QtCore.Qt.Key.Key_Return)
    yield from window.apply()
    gui.check_equal(diagram.GetDataInformation().GetBounds()[0], bounds[0] + 100)
    window.property_box("PowerDiagramBoxMode").setCurrentText("Bounds of the Points")
    yield from window.apply()
    gui.check_equal(diagram.GetDataInformation().GetBounds(), bounds)


def test(window):
    for name in CASES:
        found, information, display = yield from first_apply(window, name)
        gui.check_equal(window.messages(), "")
        if name == "hull-box":
            # The input's normals are an array of the output, and do not shade it.
            data = found.GetClientSideObject().GetOutput().GetPointData()
            assert data.HasArray("Normals") and data.GetNormals() is None
        if name.startswith("diagram"):
            gui.check_equal(display.Representation, "Surface With Edges")
            gui.check_equal(list(display.ColorArrayName), ["CELLS", "Elevation" if name == "diagram" else "RTData"])
        if name == "diagram":
            points = simple.FindSource("autzen.vtp").GetDataInformation().GetBounds()
            gui.check_equal(information.GetBounds(), (*points[:5], points[4]))
            yield from box_in_the_view(window, found, information)


gui.run(test)
