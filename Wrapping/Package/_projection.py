# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The way of points into a plane, and of a power diagram's corners back."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from . import _vtkmodules as vtk
from ._errors import InputError
from ._input import refuse_masked
from ._results import Floats

_transforms = vtk.module("vtkCommonTransforms")
CORNERS = "the power diagram's corners"
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

    def as_others(self, points: NDArray[Any], settings: Any) -> NDArray[Any]:
        """Other points in the same plane."""
        return self.to_plane(points, settings)

    def to_space(self, corners: Floats, what: str = CORNERS) -> Floats:
        """Positions in space of positions in the plane; an error that names these if one has none."""
        return np.column_stack([corners, np.full(len(corners), self._height)])


class BestFitting(Projection):
    """To the plane with the least sum of squared distances to the points."""

    is_xy = False
    _plane: Any

    def to_plane(self, points: NDArray[Any], settings: Any) -> NDArray[Any]:
        positions: Floats
        self._plane, positions = _core.to_best_fitting_plane(points, settings)
        return positions

    @property
    def axes(self) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """The directions of x and y in space."""
        x, y = self._plane.axes
        return tuple(x), tuple(y)

    def as_others(self, points: NDArray[Any], settings: Any) -> NDArray[Any]:
        positions: Floats = self._plane.projected(points, settings)
        return positions

    def to_space(self, corners: Floats, what: str = CORNERS) -> Floats:
        return _finite(self._plane.positions(corners), what)


class ByTransform(Projection):
    """By a transform of VTK's."""

    is_xy = False

    def __init__(self, transform: Any) -> None:
        self._transform = transform

    def to_plane(self, points: NDArray[Any], settings: Any) -> NDArray[Any]:
        if points.shape[1] == 2:
            points = np.column_stack([points, np.zeros(len(points), points.dtype)])
        found = np.full((len(points), 2), np.nan)
        is_finite = np.isfinite(points).all(axis=1)
        found[is_finite] = _transformed(self._transform, points[is_finite])[:, :2]
        return found

    def to_space(self, corners: Floats, what: str = CORNERS) -> Floats:
        transform = self._transform
        if transform.IsA("vtkHomogeneousTransform") and transform.GetMatrix().Determinant() == 0.0:
            raise _error_of(what)
        flat = np.column_stack([corners, np.zeros(len(corners))])
        return _finite(_transformed(transform.GetInverse(), flat), what)


def projection_of(mode: str, transform: Any) -> Projection:
    """The projection that the arguments of the same names tell."""
    if not isinstance(mode, str):
        raise TypeError(f"projection_plane_mode is one of {', '.join(map(repr, _MODES))}, not {mode!r}")
    if mode not in _MODES:
        raise ValueError(f"projection_plane_mode is one of {', '.join(map(repr, _MODES))}, not {mode!r}")
    if transform is not None:
        if mode == "best_fitting_plane":
            raise ValueError('projection_plane_mode="best_fitting_plane" takes no transform')
        return ByTransform(_transform_of(_matrix_of(transform)))
    if mode == "transform":
        raise ValueError('projection_plane_mode="transform" needs a transform')
    return BestFitting() if mode == "best_fitting_plane" else Projection()


def _transform_of(matrix: Floats) -> Any:
    """Without a division where there is nothing to divide by."""
    is_linear = tuple(matrix[3]) == (0.0, 0.0, 0.0, 1.0)
    made = _transforms.vtkTransform() if is_linear else _transforms.vtkPerspectiveTransform()
    made.SetMatrix(vtk.matrix_of(matrix))
    return made


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


def _transformed(transform: Any, points: NDArray[Any]) -> Floats:
    found = vtk.vtkPoints()
    found.SetDataTypeToDouble()
    transform.TransformPoints(vtk.points_of(points.astype(np.float64)), found)
    return np.array(vtk.values_of(found.GetData()), np.float64).reshape(-1, 3)


def _finite(positions: Floats, what: str) -> Floats:
    if not np.isfinite(positions).all():
        raise _error_of(what)
    return positions


def _error_of(what: str) -> InputError:
    return InputError(
        f"{what} have no finite places in space: the transform has no inverse, or they lie too far out", "bad_argument"
    )
