#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Write the contours of a digital elevation model, a regular grid of points in a .vtp file.

    vtp-to-contours.py sainthelens.vtp sainthelens-contours.f32

Line by line, the lowest height first: x y of each vertex in little-endian float32, as seen from the
least x and y; two NaNs end a line. A closed line ends where it began.
"""
import argparse

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkStripper
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


def grid(path):
    """The heights as an image whose origin is the corner of the least x and y."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    xyz = vtk_to_numpy(reader.GetOutput().GetPoints().GetData()).astype(float)
    xyz = xyz[numpy.lexsort((xyz[:, 0], xyz[:, 1]))]
    x, y = (numpy.unique(xyz[:, axis]) for axis in (0, 1))
    image = vtkImageData()
    image.SetDimensions(len(x), len(y), 1)
    image.SetSpacing(x[1] - x[0], y[1] - y[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(xyz[:, 2], deep=True))
    return image


def lines(image, height):
    contour = vtkContourFilter()
    contour.SetInputData(image)
    contour.SetValue(0, height)
    stripper = vtkStripper()
    stripper.SetInputConnection(contour.GetOutputPort())
    stripper.SetMaximumLength(10**6)
    stripper.Update()
    data = stripper.GetOutput()
    xy = vtk_to_numpy(data.GetPoints().GetData())[:, :2] if data.GetNumberOfPoints() else None
    for i in range(data.GetNumberOfLines()):
        ids = data.GetCell(i).GetPointIds()
        yield xy[[ids.GetId(k) for k in range(ids.GetNumberOfIds())]]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("vtp")
    parser.add_argument("contours")
    parser.add_argument("--interval", type=float, default=20, help="metres of height (20)")
    arguments = parser.parse_args()

    image = grid(arguments.vtp)
    low, high = image.GetScalarRange()
    # Not the lowest height itself: St Helens has it wherever there is no data.
    first, last = int(low // arguments.interval) + 1, int(high // arguments.interval)
    vertices = 0
    with open(arguments.contours, "wb") as file:
        for height in (step * arguments.interval for step in range(first, last + 1)):
            for line in lines(image, height):
                vertices += len(line)
                file.write(line.astype("<f4").tobytes())
                file.write(numpy.full(2, numpy.nan, "<f4").tobytes())
    print(f"{arguments.contours}: {vertices} vertices")


if __name__ == "__main__":
    main()
