# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lines of a mesh that have points of their own, and the mesh that they and other points give."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _vtkmodules as vtk
from ._errors import InputError
from ._geometries import Chain, Degenerate, Degenerates, Lines, lines_from, lines_of
from ._lines import JoinedTriangulation
from ._mesh_added import shares_of, with_crossings, with_points
from ._mesh_constraints import chains_of
from ._meshes import Cloud, set_cells
from ._results import Ids
from ._vtkmodules import values_of


def lines_of_call(values: Any, closed_are_rings: bool, degenerate: Degenerate = "error") -> Lines:
    """The lines and polygons of a PolyData, with all of its points; or those of geometries."""
    if not hasattr(values, "IsA"):
        return lines_of(values, closed_are_rings, degenerate)
    if not values.IsA("vtkPolyData"):
        raise TypeError(f"lines are a PolyData or geometries, not a {values.GetClassName()}")
    degenerates = Degenerates(degenerate)
    cells = [(ids, False) for ids in chains_of(values.GetLines())]
    cells += [(ids[:-1] if len(ids) > 1 and ids[0] == ids[-1] else ids, True) for ids in chains_of(values.GetPolys())]
    if not cells:
        degenerates.add(InputError("lines is empty: it has no line and no polygon", "bad_argument"))
    points = np.empty((0, 3)) if values.GetPoints() is None else values_of(values.GetPoints().GetData()).reshape(-1, 3)
    first = values.GetNumberOfVerts()
    _require_points(points, [ids for ids, _ in cells], first)
    chains = [
        Chain(f"cell {number} of lines", number, ids, is_ring)
        for number, (ids, is_ring) in enumerate(cells, first)
        if not degenerates.excluded(f"cell {number} of lines", number, points[ids], is_ring)
    ]
    return lines_from(points.astype(np.float64), chains, closed_are_rings, False, degenerates)


def breaklines_of_call(
    values: Any, constraints: Any, heights: Any, composite: bool, degenerate: Degenerate
) -> tuple[Any, Lines] | None:
    """The lines of a terrain mesh, as they were given and as they are read; None: there are none."""
    if values is None:
        return None
    if composite:
        raise TypeError("lines are for one data set, and the mesh is a composite")
    if constraints is not None:
        raise ValueError("breaklines are constraints or lines, not both")
    if heights is not None:
        raise ValueError("lines have their heights in z: leave heights out, and give the mesh's points theirs there")
    return values, lines_of_call(values, False, degenerate)


def _require_points(points: NDArray[Any], chains: list[Ids], first: int) -> None:
    """All chains' points are there, and finite."""
    is_finite = np.isfinite(points).all(axis=1)
    for number, ids in enumerate(chains, first):
        missing = (ids < 0) | (ids >= len(points))
        if missing.any():
            point = int(ids[missing][0])
            sentence = f"point {point} of cell {number} of lines is not there: lines have {len(points)} point(s)"
            raise InputError(sentence, "constraint_point", number, point)
        wrong = ids[~is_finite[ids]]
        if len(wrong):
            where = tuple(points[wrong[0]].tolist())
            sentence = f"point {wrong[0]} of cell {number} of lines, {where}, has a coordinate that is NaN or infinite"
            raise InputError(sentence, "non_finite", number, len(wrong))


def mesh_of(cloud: Cloud, found: JoinedTriangulation, lines: Any, pass_point_data: bool) -> Any:
    """The triangulation as a mesh, with the points' data, the lines' and marks."""
    core = found._core
    made = points_of_mesh(cloud, found, core.vertices(), lines, pass_point_data)
    set_cells(made, core.dimension, core.cell_size, None if core.cell_size else core.offsets(), core.connectivity())
    return made


def points_of_mesh(
    cloud: Cloud, found: JoinedTriangulation, vertices: Ids, lines: Any, pass_point_data: bool
) -> Any:
    """The same without cells, of these points alone: all that were added, or none of them."""
    given = len(cloud.array)
    made = cloud.mesh(cloud.ids(vertices[vertices < given]), pass_point_data)
    new = vertices[vertices >= given]
    if len(new):
        made = _with_added(made, found, vertices, lines)
    made.GetPointData().AddArray(vtk.array_of(found.point_origin[vertices], "PointOrigin"))
    if found.height_range is not None:
        made.GetPointData().AddArray(vtk.array_of(found.height_range[vertices], "HeightRange"))
    return made


def _with_added(given: Any, found: JoinedTriangulation, vertices: Ids, lines: Any) -> Any:
    """The mesh with the points that were added, the last ones of these."""
    points = found.points
    if points.shape[1] == 2:
        points = np.column_stack([points, np.zeros(len(points))])
    rows, crossed = found._line_points, found._crossed
    first = len(points) - len(crossed)  # that is a crossing
    if len(rows):
        mesh = lines if hasattr(lines, "IsA") else None
        given = with_points(given, vtk.points_of(points[first - len(rows) : first]), mesh, rows)
    if len(crossed):
        a, b = (points[ids, :2] for ids in crossed.T)
        shares = shares_of(points[first:, :2], a, b)
        given = with_crossings(given, points[first:], np.searchsorted(vertices, crossed), shares)
    return given
