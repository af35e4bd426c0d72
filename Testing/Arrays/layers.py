# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The layers that take arrays, as a test's parameter: what both promise is tried on each by one test."""

from importlib.util import find_spec

import vtkflipflop.arrays

LAYERS = {"arrays": vtkflipflop.arrays}
if find_spec("pyvista"):
    import vtkflipflop.pyvista

    LAYERS["pyvista"] = vtkflipflop.pyvista


def corners(result):
    """The points that a hull or triangulation has, or the corners of cells: in their own type, in the layer's order."""
    if hasattr(result, "sites"):
        return result.vertices
    return result.points[result.vertices] if hasattr(result, "vertices") else result.points


def ids(result):
    """The ids of a hull's or triangulation's points."""
    return result.vertices if hasattr(result, "vertices") else result.point_data["vtkOriginalPointIds"]


def bits(result):
    """Its points and cells, to compare within a layer."""
    name = next(name for name in ("faces", "cells", "simplices") if hasattr(result, name))
    cells = tuple(result.cells) if name == "cells" else (getattr(result, name),)
    return corners(result).tobytes(), *(cell.tobytes() for cell in cells)
