# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""
A terrain survey: points with heights, a breakline, a small mesh within a tolerance of all points, and a raster.

A trace as ParaView writes it, shortened. It needs the plugin FlipFlop, and this source tree as the current folder.
In the window, choose File > Load State, or Tools > Python Shell > Run Script. Without one, it draws a picture:

    pvpython Examples/ParaView/survey.py [PICTURE.png [STATE.pvsm]]
"""
import os
import sys

from paraview.simple import *

DATA = 'Data/sainthelens.vtp'
if 'TerrainMeshFlipFlop' not in globals():
    raise RuntimeError('survey.py needs the plugin FlipFlop: set PV_PLUGIN_PATH to its folder, or load it.')
if not os.path.exists(DATA):
    raise RuntimeError(f'survey.py needs {DATA}: make the source tree the current folder, not {os.getcwd()}.')

# The survey: a digital elevation model of Mount St Helens, in metres.
points = XMLPolyDataReader(registrationName='sainthelens.vtp', FileName=[DATA])

# A breakline with points of its own: the rim of the crater. Its heights are an array, too, as those of the points.
line = PolyLineSource(registrationName='Line')
line.Points = [
    563790, 5117360, 2088, 563880, 5116780, 2355, 563790, 5116240, 2477, 563610, 5115740, 2384,
    563320, 5115280, 2498, 562780, 5115190, 2497, 562300, 5115380, 2529, 561990, 5115640, 2503,
    561810, 5115910, 2445, 561730, 5116170, 2401, 561810, 5116410, 2414, 561830, 5116580, 2402,
    561900, 5116730, 2381, 561990, 5116870, 2322]
rim = Calculator(registrationName='Rim', Input=line)
rim.ResultArrayName = 'Elevation'
rim.Function = 'coordsZ'

# The mesh: of some of the points and of the rim, within 20 m of all points.
mesh = TerrainMeshFlipFlop(registrationName='Mesh', Input=points, Source=rim)
mesh.Tolerance = 20.0

# The raster: a pixel every 60 m, by a smooth surface through all points; then lifted by its values.
pixels = Plane(registrationName='Pixels')
pixels.Origin = [557945.0, 5107991.5, 0.0]
pixels.Point1 = [567665.0, 5107991.5, 0.0]
pixels.Point2 = [557945.0, 5121941.5, 0.0]
pixels.XResolution, pixels.YResolution = 162, 232
raster = Interpolator2DFlipFlop(registrationName='Raster', Input=pixels, Source=points)
raster.InterpolationMode = 'Clough-Tocher'
relief = WarpByScalar(registrationName='Relief', Input=raster)
relief.Scalars = ['POINTS', 'Elevation']

layout = CreateLayout('Survey')
views = [CreateView('RenderView') for _ in range(4)]
layout.SplitHorizontal(0, 0.5)
layout.SplitVertical(1, 0.5)
layout.SplitVertical(2, 0.5)
for view, cell in zip(views, (3, 5, 4, 6)):
    layout.AssignView(cell, view)
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    view.CenterAxesVisibility = 0
    view.CameraParallelProjection = 1
layout.SetSize(1000, 680)

elevations = GetColorTransferFunction('Elevation')
elevations.ApplyPreset('Cool to Warm', True)
errors = GetColorTransferFunction('TerrainError')
errors.ApplyPreset('Cool to Warm', True)


def explain(view, name, text):
    """What the view shows."""
    source = Text(registrationName=name)
    source.Text = text
    display = Show(source, view)
    display.Color = [0.1, 0.1, 0.1]
    display.FontSize = 14
    display.WindowLocation = 'Upper Center'


def colour(view, source, array, title):
    """Colours by a point array, and a bar of them with its unit."""
    display = Show(source, view)
    ColorBy(display, ('POINTS', array))
    display.SetScalarBarVisibility(view, True)
    bar = GetScalarBar(GetColorTransferFunction(array), view)
    bar.Title, bar.ComponentTitle = title, ''
    bar.TitleColor = bar.LabelColor = [0.1, 0.1, 0.1]
    bar.TitleFontSize = bar.LabelFontSize = 12
    bar.AutomaticLabelFormat = 0
    bar.LabelFormat = bar.RangeLabelFormat = '%.0f'
    bar.WindowLocation = 'Lower Left Corner'
    bar.ScalarBarLength = 0.35
    return display


def outline(view):
    """The rim as a thick line."""
    display = Show(rim, view)
    ColorBy(display, None)
    display.AmbientColor = display.DiffuseColor = [0.0, 0.0, 0.0]
    display.LineWidth = 3.0


def count(source):
    source.UpdatePipeline()
    return f'{source.GetDataInformation().GetNumberOfPoints():,}'


others = OutputPort(mesh, 1)
cloud = colour(views[0], points, 'Elevation', 'Elevation (m)')
cloud.SetRepresentationType('Points')
cloud.PointSize = 2.0
outline(views[0])
explain(views[0], 'About the points', f'{count(points)} points with heights; the rim, a breakline')

surface = colour(views[1], mesh, 'Elevation', 'Elevation (m)')
surface.SetRepresentationType('Surface With Edges')
surface.EdgeColor = [0.25, 0.25, 0.25]
outline(views[1])
explain(views[1], 'About the mesh', f'Terrain Mesh: {count(mesh)} vertices; the rim is kept as edges')

rest = colour(views[2], others, 'TerrainError', 'Height above the mesh (m)')
rest.SetRepresentationType('Points')
rest.PointSize = 2.0
explain(views[2], 'About the others', f'The other {count(others)} points: at most 20 m from the mesh')

smooth = colour(views[3], relief, 'Elevation', 'Elevation (m)')
smooth.SetRepresentationType('Surface')
explain(views[3], 'About the raster', 'Point Interpolator 2D: a raster, a pixel every 60 m')

elevations.RescaleTransferFunction(700.0, 2500.0)
errors.RescaleTransferFunction(-20.0, 20.0)
for view in views:
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.CameraFocalPoint = [562800.0, 5115000.0, 1500.0]
    view.CameraPosition = [569800.0, 5124000.0, 9000.0]
    ResetCamera(view)
    view.CameraParallelScale *= 0.68
    Render(view)

# Its panel shows: change Tolerance, and press Apply.
SetActiveView(views[1])
SetActiveSource(mesh)

# Not in the window, which shows all.
if os.path.basename(sys.argv[0]) == 'survey.py':
    picture = sys.argv[1] if len(sys.argv) > 1 else 'survey.png'
    SaveScreenshot(picture, layout, ImageResolution=[1000, 680])
    print('The picture is', os.path.abspath(picture))
    if len(sys.argv) > 2:
        SaveState(sys.argv[2])
