# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Interpolators of points in the plane, by the names and arguments of scipy.interpolate."""

from __future__ import annotations

from functools import cached_property
from importlib import import_module
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._image import Method
from ._plane_cells import LocatedCells
from ._qhull import QhullError
from ._results import distinct, edges_of
from ._triangulation import RegularTriangulation, regular_triangulation


class _Interpolator:
    """Values between points.

    Parameters
    ----------
    points : n by 2, or x and y in a tuple, or a Delaunay triangulation, also scipy's: its triangles are used
    values : array of n rows or numbers, also complex
    fill_value : number
        what there is outside of the convex hull
    rescale : bool
        whether x and y are taken by their ranges, each from 0 to 1; points and tri are as given

    Raises
    ------
    QhullError
        the points are on a line
    """

    _method: Method = "linear"

    def __init__(self, points: Any, values: ArrayLike, fill_value: complex = np.nan, rescale: bool = False) -> None:
        self._given = points if hasattr(points, "simplices") else None
        if self._given is not None and rescale:
            sentence = "Rescaling is not supported when passing a Delaunay triangulation as ``points``."
            raise ValueError(f"{sentence} {type(self).__name__} rescales points alone.")
        rows = _rows_of(points)
        if np.iscomplexobj(rows):
            raise TypeError("points are real numbers, not complex ones")
        rows = np.asarray(rows, np.float64)
        if rows.ndim != 2 or rows.shape[1] != 2:
            raise NotImplementedError(f"points are n by 2 here, not of shape {rows.shape}: take scipy.interpolate")
        if not len(rows):
            raise ValueError("No points given")
        self.points, self.fill_value, self.values = rows.copy(), fill_value, np.asarray(values)
        if self.values.shape[:1] != (len(rows),):
            raise ValueError("different number of values and points")
        self._origin, self._scale = np.zeros(2), np.ones(2)
        if rescale:
            self._origin = rows.mean(axis=0)
            ranges = np.ptp(rows, axis=0)
            self._scale = np.where(ranges > 0, ranges, 1.0)
        self._found = self._triangulated((self.points - self._origin) / self._scale)

    def _triangulated(self, rows: NDArray[Any]) -> LocatedCells:
        """The triangles to interpolate over; of a given triangulation, its own."""
        found = getattr(self._given, "_found", None)
        if self._given is None or isinstance(found, RegularTriangulation):
            found = regular_triangulation(rows) if found is None else found
        else:
            used = distinct(self._given.simplices)
            edges = np.searchsorted(used, edges_of(np.asarray(self._given.simplices, np.int64)))
            self.values = self.values[used]
            found = regular_triangulation(rows[used], constraints=edges)
        if found.dimension < 2:
            raise QhullError(f"all points are on a line: {len(rows)} points span less than 2 dimensions")
        return found

    @property
    def tri(self) -> Any:
        """The triangulation, as it was given; or of the points."""
        if self._given is None:
            self._given = import_module(f"{__package__}.spatial").Delaunay(self.points)
        return self._given

    def __call__(self, *args: ArrayLike) -> NDArray[Any]:
        """At positions (..., 2), or at x and y, also in a tuple. A row of 2 k numbers are k positions."""
        return self._at(self._positions(args))

    def _positions(self, args: tuple[Any, ...]) -> NDArray[Any]:
        at = _together(args if len(args) > 1 else args[0])
        if at.ndim == 1 and not at.size % 2 and not isinstance(args[0], tuple) and len(args) == 1:
            at = at.reshape(-1, 2)
        if at.shape[-1:] != (2,):
            raise ValueError(f"number of dimensions in xi does not match x: {at.shape}")
        return np.asarray((at - self._origin) / self._scale)

    def _at(self, positions: NDArray[Any]) -> NDArray[Any]:
        fill = complex(self.fill_value)
        found = self._real(self.values.real, positions, fill.real)
        if np.iscomplexobj(self.values) or fill.imag:
            return np.asarray(found + 1j * self._real(self.values.imag, positions, fill.imag))
        return found

    def _real(self, values: NDArray[Any], positions: NDArray[Any], fill: float) -> NDArray[Any]:
        given = values.astype(np.float64)
        return np.asarray(
            self._found.interpolate(given, positions, method=self._method, fill_value=fill, non_finite="ignore")
        )


def _together(coordinates: Any) -> NDArray[Any]:
    """Positions; of a tuple of x and y, that are broadcast."""
    if isinstance(coordinates, tuple):
        return np.stack(np.broadcast_arrays(*map(np.asarray, coordinates)), axis=-1)
    return np.asarray(coordinates)


def _rows_of(points: Any) -> NDArray[Any]:
    """x and y in a tuple as rows."""
    rows = _together(getattr(points, "points", points))
    return rows.reshape(-1, rows.shape[-1]) if isinstance(points, tuple) else rows


class LinearNDInterpolator(_Interpolator):
    __doc__ = f"""As scipy.interpolate.LinearNDInterpolator, in the plane. {_Interpolator.__doc__}"""


class CloughTocher2DInterpolator(_Interpolator):
    """As scipy.interpolate.CloughTocher2DInterpolator: smooth. Gradients are those of fitted quadratic functions.

    So quadratic functions are reproduced, and values differ from scipy's; tol and maxiter do not matter.

    Attributes
    ----------
    grad : ndarray of n by components by 2
        the gradients at the points; with rescale, of points taken by their ranges
    """

    _method = "clough-tocher"

    def __init__(
        self,
        points: Any,
        values: ArrayLike,
        fill_value: complex = np.nan,
        tol: float = 1e-6,
        maxiter: int = 400,
        rescale: bool = False,
    ) -> None:
        if _rows_of(points).shape[1:] not in ((), (2,)):
            raise ValueError("CloughTocher2DInterpolator is of points in the plane, n by 2")
        super().__init__(points, values, fill_value, rescale)

    @cached_property
    def grad(self) -> NDArray[Any]:
        """The gradients at the points, n by components by 2; of coordinates as rescale changes them."""
        if not isinstance(self._found, RegularTriangulation):
            raise NotImplementedError("gradients are of points, or of a triangulation of vtkflipflop.spatial")
        return _gradients(self._found, self.values.reshape(len(self.values), -1))


def estimate_gradients_2d_global(tri: Any, y: ArrayLike, maxiter: int = 400, tol: float = 1e-6) -> NDArray[Any]:
    """As scipy.interpolate's: the gradients of values at the points of a triangulation, of the shape of y and 2.

    They are those of CloughTocher2DInterpolator; of points at another's position, the other's. maxiter and tol do not
    matter.
    """
    values = np.asarray(y)
    if len(values) != len(tri.points):
        raise ValueError("'y' has a wrong number of items")
    found = getattr(tri, "_found", None)
    if not isinstance(found, RegularTriangulation):
        found = regular_triangulation(np.asarray(tri.points, np.float64))
    return _gradients(found, values)


def _gradients(found: RegularTriangulation, values: NDArray[Any]) -> NDArray[Any]:
    if np.iscomplexobj(values):
        return np.asarray(_gradients(found, values.real) + 1j * _gradients(found, values.imag))
    gradients = np.moveaxis(found.gradients(values.astype(np.float64)), 1, -1).copy()
    if len(found.hidden):
        gradients[found.hidden] = gradients[np.asarray(found.nearest(found.points[found.hidden]))]
    return gradients


class NearestNDInterpolator(_Interpolator):
    """As scipy.interpolate.NearestNDInterpolator, in the plane: exact; of several points as near, the first.

    Results are doubles or complex numbers, also of integers.
    """

    _found: RegularTriangulation

    def __init__(self, x: Any, y: ArrayLike, rescale: bool = False, tree_options: Any = None) -> None:
        super().__init__(x, y, np.nan, rescale)
        if not np.iscomplexobj(self.values):
            self.values = self.values.astype(np.float64)

    def _triangulated(self, rows: NDArray[Any]) -> RegularTriangulation:
        return regular_triangulation(rows)

    def __call__(self, *args: ArrayLike, distance_upper_bound: float = np.inf, **query_options: Any) -> NDArray[Any]:
        """At positions (..., 2), or at x and y; NaN where no point is nearer than distance_upper_bound.

        query_options: of those of scipy's trees, p=2, eps and workers are accepted, and change nothing
        """
        p = query_options.pop("p", 2)
        wrong = sorted(query_options.keys() - {"eps", "workers"})
        if wrong or p != 2:
            what = f"not of p = {p}" if p != 2 else f"without {', '.join(wrong)}"
            raise NotImplementedError(f"distances are Euclid's here, {what}: take scipy.interpolate")
        at = self._positions(args)
        ids = np.asarray(self._found.nearest(at))
        found = self.values[ids]
        if distance_upper_bound < np.inf:
            found[np.linalg.norm(at - self._found.points[ids], axis=-1) >= distance_upper_bound] = np.nan
        return np.asarray(found)


def griddata(
    points: Any,
    values: ArrayLike,
    xi: Any,
    method: Literal["linear", "nearest", "cubic"] = "linear",
    fill_value: complex = np.nan,
    rescale: bool = False,
) -> NDArray[Any]:
    """As scipy.interpolate.griddata, of points in the plane; xi are positions (..., 2), or a tuple of x and y."""
    rows = _rows_of(points)
    at = xi if isinstance(xi, tuple) else (xi,)
    if method == "nearest":
        return NearestNDInterpolator(rows, values, rescale)(*at)
    if method == "linear":
        return LinearNDInterpolator(rows, values, fill_value, rescale)(*at)
    if method == "cubic":
        return CloughTocher2DInterpolator(rows, values, fill_value, rescale=rescale)(*at)
    raise ValueError(f"Unknown interpolation method {method!r}: it is 'linear', 'nearest' or 'cubic'")
