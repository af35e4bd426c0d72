# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the demo's parts share: reading, writing, and tables."""
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    points = reader.GetOutput()
    if points.GetNumberOfPoints() == 0:
        raise SystemExit(f"{path}: no points")
    return points


def write(data, path):
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(path)
    writer.SetInputData(data)
    writer.SetDataModeToBinary()  # what ParaView 5.11 can read with any expat
    if not writer.Write():
        raise SystemExit(f"cannot write {path}")


def print_table(head, rows, texts=1):
    """The first columns, which hold text, to the left; the others to the right."""
    rows = [head] + rows
    widths = [max(len(row[i]) for row in rows) for i in range(len(head))]
    rows.insert(1, ["-" * width for width in widths])
    for row in rows:
        cells = [cell.ljust(width) for cell, width in zip(row[:texts], widths)]
        cells += [cell.rjust(width) for cell, width in zip(row[texts:], widths[texts:])]
        print("  ".join(cells).rstrip())
