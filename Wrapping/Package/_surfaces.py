# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The cells of surfaces, as polygons that the engine cuts into triangles."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._errors import InputError
from ._meshes import Part, corners_of
from ._results import Ids

HULL_OF_POINTS = (
    "It takes triangles, polygons and triangle strips; Convex Hull (vtkFFHullFilter) gives the hull of points."
)


def surface_of(part: Part, name: str) -> tuple[NDArray[Any], NDArray[Any], Ids | None]:
    """The cells of a surface: where their corners begin, the corners, and the cell of each; None: all are triangles.

    A strip is several triangles. What is no polygon is an error that names the first such cell.
    """
    mesh = part.mesh
    of = f" of {name}" if name else ""
    polygons, strips = mesh.GetPolys(), mesh.GetStrips()
    vertices, lines = mesh.GetNumberOfVerts(), mesh.GetNumberOfLines()
    if vertices + lines and not polygons.GetNumberOfCells() + strips.GetNumberOfCells():
        kinds = "vertices and lines" if vertices and lines else "vertices" if vertices else "lines"
        sentence = f"the surface{of} has no polygons: its cells are {kinds}"
        raise InputError(f"{sentence}; convex_hull() gives the hull of points", "bad_argument").for_filters(
            f"{sentence}. {HULL_OF_POINTS}"
        )
    if vertices + lines:
        wrong = f"must be a triangle, a polygon or a triangle strip, but cell 0{of} is a"
        wrong += " vertex cell" if vertices else " line cell"
        raise InputError(f"every cell of a surface {wrong}", "bad_triangle", 0).for_filters(
            f"Every cell of the input {wrong}. Take vertices and lines out: Extract Cells By Type "
            "(vtkExtractCellsByType) can do that."
        )
    try:
        starts, corners = corners_of(polygons, f"the surface's cells{of}")
        strip_starts, strip_corners = corners_of(strips, f"the surface's cells{of}")
    except InputError as error:
        raise error.for_filters(str(error).replace("the surface's", "The input's", 1) + ".")
    count = len(starts) - 1
    sizes = np.concatenate([np.diff(starts), np.diff(strip_starts)])
    if (sizes < 3).any():
        cell = int((sizes < 3).argmax())
        sentence = (
            f"every polygon and every triangle strip must have three points or more, but cell {cell}{of} is a "
            f"{'polygon' if cell < count else 'strip'} of {sizes[cell]}"
        )
        raise InputError(sentence, "bad_triangle", cell).for_filters(
            f"{sentence}. Clean (vtkCleanPolyData) can take it out."
        )
    if (sizes[:count] == 3).all() and len(sizes) == count:
        return starts, corners, None
    triangles = _triangles_of_strips(strip_starts, strip_corners)
    cell_of = np.repeat(count + np.arange(len(sizes) - count), sizes[count:] - 2)
    all_starts = np.concatenate([starts, starts[-1] + 3 * np.arange(1, len(triangles) + 1)])
    return all_starts, np.concatenate([corners, triangles.reshape(-1)]), np.concatenate([np.arange(count), cell_of])


def _triangles_of_strips(starts: NDArray[np.int64], corners: NDArray[np.int64]) -> NDArray[np.int64]:
    """Every other triangle of a strip goes the other way round."""
    found = []
    for begin, end in zip(starts[:-1], starts[1:]):
        strip = corners[begin:end]
        rows = np.stack([strip[:-2], strip[1:-1], strip[2:]], axis=1)
        rows[1::2, :2] = rows[1::2, 1::-1]
        found.append(rows)
    return np.concatenate([np.empty((0, 3), np.int64), *found])


def by_cell(call: Callable[..., Any], cell_of: Ids | None) -> Callable[..., Any]:
    """The call, whose errors name the surface's cells instead of its triangles; None: each cell is a triangle."""
    if cell_of is None:
        return call

    def translated(*arguments: Any) -> Any:
        try:
            return call(*arguments)
        except InputError as error:
            where = re.search(r"\bat (triangle|cell) \d+", str(error))
            if where is None or error.index < 0:
                raise
            cell = int(cell_of[error.index])
            message = str(error).replace(where[0], f"at cell {cell}")
            raise InputError(message, error.code, cell, error.count) from None

    return translated
