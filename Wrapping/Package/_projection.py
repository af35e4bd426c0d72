# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The way of points into a plane, and of a power diagram's corners back."""

from __future__ import annotations

from typing import Any

import numpy as np
import pyvista as pv
from numpy.typing import NDArray

from . import _core
from ._errors import InputError
from ._input import refuse_masked
from ._results import Floats

_MODES = ("xy_plane", "best_fitting_plane", "transform")


class Projection:
    """To x and y as they are, and back to the lowest z of what was triangulated."""

    is_xy = True
    _height: float = 0.0

    def to_plane(self, points: NDArray[Any], settings: Any) -> NDArray[Any]:
        """The points in the plane, as rows of two or more; a point has a NaN if any coordinate is not finite."""
        positions = _core.to_xy_plane(points, settings) if points.shape[1] == 3 else None
        return points if positions is None else positions

    def lie_beneath(self, points: NDArray[Any], triangulation: Any) -> None:
        """Chooses the plane's height in space, where there is a choice."""
        self._height = _core.height_below(points, triangulation) if points.shape[1] == 3 else 0.0

    def to_space(self, corners: Floats) -> Floats:
        """Positions in space of positions in the plane; an error if one has none."""
        return np.column_stack([corners, np.full(len(corners), self._height)])


class _BestFitting(Projection):
    """To the plane with the least sum of squared distances to the points."""

    is_xy = False
    _plane: Any

    def to_plane(self, points: NDArray[Any], settings: Any) -> NDArray[Any]:
        positions: Floats
        self._plane, positions = _core.to_best_fitting_plane(points, settings)
        return positions

    def to_space(self, corners: Floats) -> Floats:
        return _finite(self._plane.positions(corners))


class _ByMatrix(Projection):
    """By a matrix of 4 by 4."""

    is_xy = False

    def __init__(self, matrix: Floats) -> None:
        self._matrix = matrix

    def to_plane(self, points: NDArray[Any], settings: Any) -> NDArray[Any]:
        if points.shape[1] == 2:
            points = np.column_stack([points, np.zeros(len(points), points.dtype)])
        found = _transformed(self._matrix, points.astype(np.float64))[:, :2]
        found[~np.isfinite(points).all(axis=1)] = np.nan
        return np.ascontiguousarray(found)

    def to_space(self, corners: Floats) -> Floats:
        inverse = pv.vtkmatrix_from_array(self._matrix)  # inverted as VTK's transforms are
        if inverse.Determinant() == 0.0:
            raise InputError("the power diagram's corners have no places in space: the transform has no inverse")
        inverse.Invert()
        flat = np.column_stack([corners, np.zeros(len(corners))])
        return _finite(_transformed(np.asarray(pv.array_from_vtkmatrix(inverse), np.float64), flat))


def projection_of(mode: str, transform: Any) -> Projection:
    """The projection that the arguments of the same names tell."""
    if not isinstance(mode, str):
        raise TypeError(f"projection_plane_mode is one of {', '.join(map(repr, _MODES))}, not {mode!r}")
    if mode not in _MODES:
        raise ValueError(f"projection_plane_mode is one of {', '.join(map(repr, _MODES))}, not {mode!r}")
    if transform is not None:
        if mode == "best_fitting_plane":
            raise ValueError('projection_plane_mode="best_fitting_plane" takes no transform')
        return _ByMatrix(_matrix_of(transform))
    if mode == "transform":
        raise ValueError('projection_plane_mode="transform" needs a transform')
    return _BestFitting() if mode == "best_fitting_plane" else Projection()


def _matrix_of(transform: Any) -> Floats:
    values = getattr(transform, "matrix", transform)  # pyvista.Transform
    if hasattr(values, "GetMatrix"):
        values = values.GetMatrix()
    if hasattr(values, "GetElement"):
        values = [[values.GetElement(i, k) for k in range(4)] for i in range(4)]
    refuse_masked(values, "transform")
    try:
        matrix = np.array(values, np.float64)
    except (TypeError, ValueError):
        raise TypeError(f"transform is 4 by 4 numbers, not of type {type(transform).__name__}") from None
    if matrix.shape != (4, 4) or not np.isfinite(matrix).all():
        raise ValueError(f"transform is 4 by 4 finite numbers, not {transform!r}")
    return matrix


def _transformed(matrix: Floats, points: Floats) -> Floats:
    """In the order of VTK's operations."""
    x, y, z = points.T
    with np.errstate(all="ignore"):
        rows = [row[0] * x + row[1] * y + row[2] * z + row[3] for row in matrix]
        if tuple(matrix[3]) != (0.0, 0.0, 0.0, 1.0):
            rows = [(1.0 / rows[3]) * row for row in rows]
    return np.column_stack(rows[:3])


def _finite(positions: Floats) -> Floats:
    if not np.isfinite(positions).all():
        raise InputError("the power diagram's corners have no finite places in space: they lie too far out")
    return positions
