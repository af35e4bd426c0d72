# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Terrain meshes of a mesh's points: what the engine found, as meshes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from . import _vtkmodules as vtk
from ._meshes import set_cells
from ._results import Ids


def meshes_of_terrain(found: dict[str, Any], points_of: Callable[[Ids], Any], rest: bool) -> list[Any]:
    """The mesh; and of the points that were not kept, vertices with their errors. points_of: a mesh of some points."""
    vertices, simplices = found["vertices"], found["simplices"]
    made = [points_of(vertices)]
    set_cells(made[0], found["dimension"], simplices.shape[1], None, np.searchsorted(vertices, simplices.ravel()))
    if rest:
        left = ~np.isnan(found["errors"])
        left[vertices] = False
        rows = np.flatnonzero(left)
        made.append(points_of(rows))
        set_cells(made[1], 0, 1, None, np.arange(len(rows)))
        made[1].GetPointData().AddArray(vtk.array_of(found["errors"][rows], "TerrainError"))
    return made
