# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""
Whether two pictures show the same, whatever draws them.

Drivers differ in the last bit of a colour and in the pixels along edges. So silhouettes are compared (the
pictures' backgrounds are transparent), and the mean difference of colours where both pictures have some.
"""
import os

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

LEAST_OVERLAP = 0.98  # of silhouettes: intersection over union
MOST_DIFFERENCE = 6.0  # mean of the colours' absolute differences, of 255
SIZE = (400, 300)

baselines = os.path.join(os.path.dirname(os.path.abspath(__file__)), "Baseline")


def read(path):
    """The rows, columns and red, green, blue, alpha of a PNG."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    colours = vtk_to_numpy(image.GetPointData().GetScalars())
    assert colours.shape[1] == 4, f"{path} has no transparency"
    return colours.reshape(height, width, 4)


def compare(one, other):
    """The overlap of two pictures' silhouettes, and their mean difference in colour there."""
    assert one.shape == other.shape, f"sizes {one.shape} and {other.shape}"
    silhouettes = [picture[..., 3] >= 128 for picture in (one, other)]
    both, either = silhouettes[0] & silhouettes[1], silhouettes[0] | silhouettes[1]
    assert either.any(), "both pictures are empty"
    differences = numpy.abs(one[both][:, :3].astype(float) - other[both][:, :3])
    return both.sum() / either.sum(), differences.mean() if both.any() else 255.0


def alike(one, other):
    overlap, difference = compare(one, other)
    return overlap >= LEAST_OVERLAP and difference <= MOST_DIFFERENCE


def draw(path):
    """Draw the active view to a file, and read it."""
    simple.SaveScreenshot(
        path, simple.GetActiveView(), ImageResolution=SIZE, TransparentBackground=1
    )
    return read(path)


def look_from(position, up):
    """Look at all that is visible from a direction."""
    view = simple.GetActiveView()
    view.OrientationAxesVisibility = 0
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = position, (0, 0, 0), up
    simple.ResetCamera(view)


def check(name, folder, others):
    """
    The active view must look like the baseline of that name; and to show that the comparison can tell,
    none of the others, which are pictures of something else, may.
    """
    drawn = draw(os.path.join(folder, name))
    baseline = read(os.path.join(baselines, name))
    overlap, difference = compare(drawn, baseline)
    assert alike(drawn, baseline), f"{name}: overlap {overlap:.4f}, colours differ by {difference:.2f}"
    for what, other in others.items():
        assert not alike(other, baseline), f"{name} cannot be told from {what}"
