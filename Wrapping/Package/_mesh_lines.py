# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lines of a mesh that have points of their own, and the mesh that they and other points give."""

from __future__ import annotations

from typing import Any

import numpy as np
import pyvista as pv
from numpy.typing import NDArray

from ._errors import InputError
from ._geometries import Chain, Degenerate, Degenerates, Lines, lines_from, lines_of
from ._lines import JoinedTriangulation
from ._mesh_constraints import chains_of
from ._meshes import Cloud, set_cells, values_of
from ._results import Ids


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


def mesh_of(cloud: Cloud, found: JoinedTriangulation, lines: Any, pass_point_data: bool) -> pv.PolyData:
    """The triangulation as a mesh, with the points' data, the lines' and marks."""
    core = found._core
    made = points_of_mesh(cloud, found, core.vertices(), lines, pass_point_data)
    set_cells(made, core.dimension, core.cell_size, None if core.cell_size else core.offsets(), core.connectivity())
    return made


def points_of_mesh(
    cloud: Cloud, found: JoinedTriangulation, vertices: Ids, lines: Any, pass_point_data: bool
) -> pv.PolyData:
    """The same without cells, of these points alone: all that were added, or none of them."""
    given = len(cloud.array)
    made = cloud.mesh(cloud.ids(vertices[vertices < given]), pass_point_data)
    new = vertices[vertices >= given]
    if len(new):
        made = _with_added(made, found, vertices, lines, given)
    made.point_data["PointOrigin"] = found.point_origin[vertices]
    if found.height_range is not None:
        made.point_data["HeightRange"] = found.height_range[vertices]
    return made


def _with_added(base: pv.PolyData, found: JoinedTriangulation, vertices: Ids, lines: Any, given: int) -> pv.PolyData:
    """The mesh with the added ones of these points, too. Where lines cross, data is linear along the first."""
    new = vertices[vertices >= given]
    positions = found.points[new]
    if positions.shape[1] == 2:
        positions = np.column_stack([positions, np.zeros(len(new))])
    made = pv.PolyData()
    points = np.concatenate([np.asarray(base.points, np.float64), positions])
    made.SetPoints(pv.vtk_points(points, deep=True, force_float=False))
    own = pv.wrap(lines).point_data if hasattr(lines, "IsA") else {}
    shares = _shares(found)
    crossed = np.searchsorted(vertices, found._crossed)
    for name in [name for name in base.point_data.keys() if name != "vtkOriginalPointIds"]:
        old = np.asarray(base.point_data[name])
        added = np.zeros((len(new), *old.shape[1:]), old.dtype)
        if old.dtype.kind in "fc":
            added += np.nan
        if name in own and own[name].shape[1:] == old.shape[1:]:
            added[: len(found._line_points)] = own[name][found._line_points]
        whole = np.concatenate([old, added])
        if len(crossed):
            share, first, last = shares.reshape(-1, *[1] * (old.ndim - 1)), whole[crossed[:, 0]], whole[crossed[:, 1]]
            if old.dtype.kind in "biufc":
                between = (1 - share) * first + share * last
                whole[-len(crossed) :] = np.rint(between) if old.dtype.kind in "biu" else between
            else:
                whole[-len(crossed) :] = np.where(share < 0.5, first, last)
        made.point_data.set_array(whole, name)
    made.point_data.active_scalars_name = base.point_data.active_scalars_name
    ids = pv.numpy_to_idarr(np.concatenate([base["vtkOriginalPointIds"], np.full(len(new), -1)]), deep=True)
    ids.SetName("vtkOriginalPointIds")
    made.GetPointData().AddArray(ids)
    return made


def _shares(found: JoinedTriangulation) -> NDArray[np.float64]:
    """How far each crossing is on the way along the first line there, from 0 to 1; rounded."""
    if not len(found._crossed):
        return np.empty(0)
    at = 0.5 * found.points[-len(found._crossed) :, :2]
    a, b = (0.5 * found.points[ends, :2] for ends in found._crossed.T)
    axis = (np.abs(b - a)[:, 0] < np.abs(b - a)[:, 1]).astype(int)
    rows = np.arange(len(axis))
    shares: NDArray[np.float64] = np.clip((at - a)[rows, axis] / (b - a)[rows, axis], 0.0, 1.0)
    return shares
