# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""
The pictures of Documentation/ParaView.md: ParaView's window, photographed where a user would look.

Scripts/photograph-paraview.sh takes them. gui.py shows how a script gets at the window.
"""
import os

import gui
import numpy
from paraview import simple
from qt import QtCore, QtGui, QtWidgets
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkImagingColor import vtkImageQuantizeRGBToIndex

SIZE = QtCore.QSize(1280, 860)
POINTS, HIDDEN = (1.0, 0.6, 0.2), (0.95, 0.2, 0.6)
LEFT_COLUMN = 400


def arrange(window, pipeline=150):
    """A window of the size of the pictures, its panels wide enough to be read."""
    window.window.resize(SIZE)
    docks = [window.find(QtWidgets.QDockWidget, name) for name in ("pipelineBrowserDock", "propertiesDock")]
    window.window.resizeDocks(docks, [LEFT_COLUMN] * 2, QtCore.Qt.Orientation.Horizontal)
    window.window.resizeDocks(docks, [pipeline, SIZE.height() - pipeline], QtCore.Qt.Orientation.Vertical)
    yield from window.stands_still()


def of_few_colours(image):
    """The image in 256 colours: a third of the bytes, and no eye sees it."""
    image = image.convertToFormat(QtGui.QImage.Format.Format_RGB888)
    width, height = image.width(), image.height()
    pixels = image.constBits().asarray(image.bytesPerLine() * height)
    pixels = numpy.array(pixels, numpy.uint8).reshape(height, -1)[:, : 3 * width].reshape(-1, 3)
    data = vtkImageData()
    data.SetDimensions(width, height, 1)
    data.GetPointData().SetScalars(numpy_to_vtk(pixels, deep=True))
    quantize = vtkImageQuantizeRGBToIndex()
    quantize.SetInputData(data)
    quantize.SetNumberOfColors(256)
    quantize.Update()
    table = quantize.GetLookupTable()
    colours = vtk_to_numpy(table.GetTable())[: table.GetNumberOfTableValues()]
    indices = vtk_to_numpy(quantize.GetOutput().GetPointData().GetScalars()).astype(numpy.uint8)
    rows = numpy.zeros((height, (width + 3) // 4 * 4), numpy.uint8)
    rows[:, :width] = indices.reshape(height, width)
    few = QtGui.QImage(rows.tobytes(), width, height, QtGui.QImage.Format.Format_Indexed8)
    few.setColorTable([QtGui.qRgb(*(int(c) for c in colour[:3])) for colour in colours])
    return few.copy()


def photograph(window, name, area=None):
    yield from window.stands_still()
    image = gui.photograph(area or window.window.geometry())
    of_few_colours(image).save(os.path.join(gui.output, name))


def area_of(widget):
    return QtCore.QRect(widget.mapToGlobal(QtCore.QPoint(0, 0)), widget.size())


def as_points(source, colour, radius):
    display = simple.Show(source, Representation="Point Gaussian")
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = colour
    display.ShaderPreset = "Plain circle"
    display.GaussianRadius = radius
    return display


def manager(window):
    """The dialog that lists the plugin."""
    yield from window.choose("Tools", "Manage Plugins...")
    dialog = yield from window.dialog("pqPluginDialog")
    dialog.resize(760, 360)
    tree = dialog.findChild(QtWidgets.QTreeWidget, "localPlugins")
    row = next(i for i in range(tree.topLevelItemCount()) if tree.topLevelItem(i).text(0) == "FlipFlop")
    tree.setCurrentItem(tree.topLevelItem(row))
    tree.expandItem(tree.topLevelItem(row))
    # Where the page says that it is, on whatever machine.
    items = [tree.topLevelItem(row).child(i) for i in range(tree.topLevelItem(row).childCount())]
    location = next(item for item in items if item.text(0) == "Location")
    location.setText(1, location.text(1).replace(os.environ["FLIPFLOP_BUILD"], "/opt/flipflop"))
    yield from photograph(window, "paraview-plugin-manager.png", area_of(tree))
    dialog.close()
    yield lambda: gui.gone(dialog)


def menu(window):
    """Where the filters are."""
    filters, flips = window.menu("Filters"), window.menu("Filters", "Flip-Flop")
    bar = window.window.menuBar()
    below = bar.actionGeometry(filters.menuAction()).bottomLeft()
    filters.popup(bar.mapToGlobal(below))
    filters.setActiveAction(flips.menuAction())
    yield flips.isVisible
    yield from photograph(window, "paraview-menu.png")
    filters.hide()


def hull(window):
    """The panel before Apply and the hull after it; then what was found."""
    yield from window.open_file(gui.data("spot.vtp"))
    as_points(simple.GetActiveSource(), POINTS, 0.006)
    view = simple.GetActiveView()
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = (1, 0.25, -0.75), (0, 0, 0), (0, 1, 0)
    simple.ResetCamera(view)
    view.CameraViewAngle = 24
    yield from menu(window)
    yield from window.add_filter("Flip-Flop", "Convex Hull (Flip-Flop)")
    window.tick("ReportAsFieldData")
    yield from window.apply()
    display = simple.Show(simple.GetActiveSource(), Representation="Surface With Edges")
    display.Opacity = 0.4
    simple.Show(simple.FindSource("spot.vtp"))
    simple.Render()
    yield from photograph(window, "paraview-hull.png")
    yield from window.information()
    yield from photograph(window, "paraview-information.png")


def triangulation(window):
    """Weights, hidden points and the power diagram, in two views."""
    yield from window.show_properties()
    simple.ResetSession()
    yield from arrange(window, pipeline=280)
    yield from window.open_file(gui.data("autzen.vtp"))
    yield from window.add_filter("Alphabetical", "Calculator")
    weighted = simple.GetActiveSource()
    weighted.ResultArrayName, weighted.Function = "weight", "-60 * Elevation"
    yield from window.apply()
    simple.Hide(weighted)
    yield from window.add_filter("Flip-Flop", "Delaunay 2D (Flip-Flop)")
    window.property_box("Weights").setCurrentText("weight")
    yield from window.apply()
    found = simple.GetActiveSource()
    simple.SetActiveSource(weighted)
    yield from window.add_filter("Flip-Flop", "Voronoi 2D (Flip-Flop)")
    window.property_box("Weights").setCurrentText("weight")
    yield from window.apply()
    districts = simple.GetActiveSource()
    simple.Hide(districts)
    left = simple.GetActiveView()
    display = simple.Show(found, Representation="Surface With Edges")
    by_array("Elevation", display, left, "POINTS")
    as_points(simple.OutputPort(found, 1), HIDDEN, 6)
    look_down(left)
    layout = simple.GetLayout()
    right = simple.CreateView("RenderView")
    layout.SplitHorizontal(layout.GetViewLocation(left), 0.5)
    layout.AssignView(layout.GetViewLocation(left) + 1, right)
    cells = simple.Show(districts, right, Representation="Surface With Edges")
    by_array("Elevation", cells, right, "CELLS")
    look_down(right)
    simple.SetActiveView(left)
    simple.SetActiveSource(found)
    yield from photograph(window, "paraview-triangulation.png")


def diagram(window):
    """Disks, their power diagram, and the box that cuts it."""
    simple.ResetSession()
    yield from arrange(window, pipeline=100)
    random = numpy.random.default_rng(4)
    places = numpy.c_[random.random((150, 2)) * [300, 200], numpy.zeros(150)]
    radii = 3 + 12 * random.random(150) ** 3
    yield from window.open_file(gui.write_points("disks.vtp", places, radius=radii))
    disks = simple.GetActiveSource()
    yield from window.add_filter("Flip-Flop", "Voronoi 2D (Flip-Flop)")
    window.property_box("Weights").setCurrentText("radius")
    window.property_box("WeightMode").setCurrentText("Radii")
    window.property_box("PowerDiagramBoxMode").setCurrentText("Bounds Given")
    yield from window.apply()
    found = simple.GetActiveSource()
    found.PowerDiagramCorner, found.PowerDiagramLengths = (60, 30, -10), (200, 140, 20)
    spheres = simple.Glyph(
        Input=disks, GlyphType="Sphere", ScaleArray=["POINTS", "radius"], ScaleFactor=2.0, GlyphMode="All Points",
        OrientationArray=["POINTS", "No orientation array"])
    spheres.GlyphType.ThetaResolution = spheres.GlyphType.PhiResolution = 48
    circles = simple.Slice(Input=spheres, SliceType="Plane")
    circles.SliceType.Origin, circles.SliceType.Normal = (0, 0, 0.5), (0, 0, 1)
    display = simple.Show(circles)
    display.LineWidth, display.Ambient, display.Diffuse = 2, 1.0, 0.0
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = (1.0, 1.0, 1.0)
    simple.SetActiveSource(found)
    view = simple.GetActiveView()
    by_array("radius", simple.GetDisplayProperties(found), view, "CELLS")
    view.InteractionMode = "3D"
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = (130, -130, 420), (155, 100, 0), (0, 1, 0)
    panel = window.find(QtWidgets.QWidget, "propertiesPanel")
    box = panel.findChild(QtWidgets.QWidget, "InteractiveBox").findChild(QtWidgets.QCheckBox, "show3DWidget")
    yield from window.stands_still()
    box.setChecked(True)
    simple.Render(view)
    yield from photograph(window, "paraview-diagram.png")


def survey(window):
    """The session of Examples/ParaView, in a window that is large enough for its letters."""
    simple.ResetSession()
    window.window.setGeometry(gui.application.primaryScreen().geometry())
    simple.LoadState(
        os.path.join(os.environ["FLIPFLOP_SOURCE"], "Examples", "ParaView", "survey.pvsm"), data_directory=gui.data(""))
    yield from window.stands_still()
    path = os.path.join(gui.output, "paraview-survey.png")
    simple.SaveScreenshot(path, simple.GetLayout(simple.GetActiveView()), ImageResolution=(1000, 680))
    of_few_colours(QtGui.QImage(path)).save(path)


def error(window):
    """What a NaN brings up."""
    yield from window.open_file(gui.write_points("nan.vtp", [[0, 0, 0], [1, 0, 0], [0, float("nan"), 0]]))
    yield from window.add_filter("Flip-Flop", "Convex Hull (Flip-Flop)")
    yield from window.apply()
    messages = window.find(QtWidgets.QDockWidget, "outputWidgetDock")
    yield messages.isVisible
    messages.resize(1000, 200)
    gui.click(messages.findChild(QtWidgets.QCheckBox, "showFullMessagesCheckBox"))
    for text in messages.findChildren(QtWidgets.QAbstractScrollArea):
        text.verticalScrollBar().setValue(0)
    yield from photograph(window, "paraview-error.png", area_of(messages))


def by_array(name, display, view, association):
    """No bars: there is no room for them."""
    if display.ColorArrayName[1]:
        display.SetScalarBarVisibility(view, False)
    simple.ColorBy(display, (association, name))
    display.SetScalarBarVisibility(view, False)


def look_down(view):
    """At a part of the plane in which single triangles are seen."""
    view.CameraParallelProjection = 1
    view.CameraPosition, view.CameraFocalPoint = (637200, 851480, 1e5), (637200, 851480, 0)
    view.CameraViewUp = (0, 1, 0)
    view.CameraParallelScale = 520
    simple.Render(view)


def test(window):
    yield from arrange(window)
    yield from manager(window)
    yield from hull(window)
    yield from triangulation(window)
    yield from diagram(window)
    yield from error(window)
    yield from survey(window)


gui.run(test)
