# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""
A LiDAR survey: its surface within its outline, and how densely each place was sampled.

A trace as ParaView writes it, shortened. Load the plugin FlipFlop, then choose File > Load State, or Tools >
Python Shell > Run Script; or, where this source tree is the current folder:

    pvpython Examples/ParaView/survey.py [PICTURE.png [STATE.pvsm]]
"""
import sys

from paraview.simple import *

# The surface: triangles between neighbours, without the long ones at the border.
autzen = XMLPolyDataReader(registrationName='autzen.vtp', FileName=['Data/autzen.vtp'])
surface = DelaunayTriangulation2DFlipFlop(registrationName='Surface', Input=autzen)
surface.MaximumEdgeLength = 250.0

# The outline of the survey: the convex hull of the points with z = 0 is a polygon.
flat = Calculator(registrationName='Flat', Input=autzen)
flat.CoordinateResults = 1
flat.Function = 'coordsX*iHat + coordsY*jHat'
outline = ConvexHullFlipFlop(registrationName='Outline', Input=flat)
outline.FacetMode = 'Polygons'

# The density: the larger a point's Voronoi cell, the fewer points there are.
density = VoronoiPowerDiagramFlipFlop(registrationName='Density', Input=autzen)
density.GenerateCellMeasures = 1

left = CreateView('RenderView')
right = CreateView('RenderView')
layout = CreateLayout('Survey')
layout.SplitHorizontal(0, 0.5)
layout.AssignView(1, left)
layout.AssignView(2, right)
layout.SetSize(1000, 680)
for view in left, right:
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    view.CenterAxesVisibility = 0
    view.CameraParallelProjection = 1

surfaceDisplay = Show(surface, left)
surfaceDisplay.SetRepresentationType('Surface')
ColorBy(surfaceDisplay, ('POINTS', 'Elevation'))
elevations = GetColorTransferFunction('Elevation')
elevations.ApplyPreset('Cool to Warm', True)
elevations.RescaleTransferFunction(405.0, 480.0)
surfaceDisplay.SetScalarBarVisibility(left, False)
outlineDisplay = Show(outline, left)
outlineDisplay.SetRepresentationType('Feature Edges')
outlineDisplay.AmbientColor = outlineDisplay.DiffuseColor = [0.0, 0.0, 0.0]
ColorBy(outlineDisplay, None)

densityDisplay = Show(density, right)
densityDisplay.SetRepresentationType('Surface')
ColorBy(densityDisplay, ('CELLS', 'Area'))
areas = GetColorTransferFunction('Area')
areas.ApplyPreset('Cool to Warm', True)
areas.RescaleTransferFunction(300.0, 6000.0)
areas.MapControlPointsToLogSpace()
areas.UseLogScale = 1
densityDisplay.SetScalarBarVisibility(right, False)

for view in left, right:
    ResetCamera(view)
    view.CameraParallelScale *= 0.62
Render(left)
Render(right)

if len(sys.argv) > 1:
    SaveScreenshot(sys.argv[1], layout, ImageResolution=[1000, 680])
if len(sys.argv) > 2:
    SaveState(sys.argv[2])
