# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Intersections of half-spaces by scipy.spatial's names."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import InputError
from ._half_spaces import HalfSpaceIntersection as Found
from ._half_spaces import half_space_intersection, sizes_of
from ._incremental import Incremental
from ._input import doubles_of
from ._qhull import QhullError, say_unused
from ._results import Polygons

Rows = NDArray[np.float64]


class HalfspaceIntersection(Incremental):
    """The intersection of half-spaces of the plane or of space, as scipy.spatial.HalfspaceIntersection.

    Attributes
    ----------
    halfspaces : ndarray of nineq by ndim + 1
        those given, also by add_halfspaces(): normal and offset, normal @ x + offset <= 0
    interior_point : ndarray of ndim
    intersections : ndarray of ninter by ndim
        the vertices, each once; each coordinate rounded once
    dual_points : ndarray of nineq by ndim
    dual_facets : list of lists
        for each of intersections the half-spaces whose facets meet there, exactly
    dual_vertices : ndarray
        the half-spaces that have a facet, ascending
    dual_equations : ndarray of ninter by ndim + 1
        of the dual points' hull, rounded
    dual_volume, dual_area : float

    Raises
    ------
    QhullError
        the interior point is not strictly inside, or the intersection is unbounded
    """

    @classmethod
    def _why_not(cls, halfspaces: Any, *arguments: Any, **settings: Any) -> str:
        if np.ndim(halfspaces) != 2 or np.shape(halfspaces)[1] in (3, 4):
            return ""
        return f"half-spaces are n by 3 or n by 4 here, not n by {np.shape(halfspaces)[1]}"

    def __init__(
        self,
        halfspaces: ArrayLike,
        interior_point: ArrayLike,
        incremental: bool = False,
        qhull_options: str | None = None,
        *,
        fallback: bool = False,
    ) -> None:
        self._check(halfspaces)
        say_unused(qhull_options)
        rows, point = _rows_of(halfspaces), np.array(doubles_of(interior_point, "the numbers of interior_point"))
        if point.shape != (rows.shape[1] - 1,):
            raise ValueError(f"feasible point has to be a (ndim-1,) array, not of shape {point.shape}")
        self._open(incremental)
        self.interior_point = point
        self._take(rows, np.arange(len(rows)))

    def _take(self, rows: Rows, kept: NDArray[np.int64]) -> None:
        """kept: the half-spaces that count"""
        try:
            found = half_space_intersection(rows[kept], self.interior_point)
        except InputError as error:
            if error.index < 0:
                raise
            at = f"half-space {kept[error.index]}, {rows[kept[error.index]]}"
            if error.code == "non_finite":
                raise ValueError(f"{at} is not finite") from None
            raise QhullError(f"feasible point {self.interior_point} is not strictly inside {at}") from None
        if found.kind != "bounded":
            raise QhullError("the intersection is unbounded: add half-spaces, as those of a box")
        self._forget()
        self.halfspaces, self._found, self._kept = rows, found, kept
        self._duals = found.dual_points if len(kept) == len(rows) else None

    def add_halfspaces(self, halfspaces: ArrayLike, restart: bool = False) -> None:
        """Add half-spaces after the others. Those that were redundant are not looked at again, but with restart."""
        self._require_open()
        rows = _rows_of(np.atleast_2d(np.asarray(halfspaces)))
        if rows.shape[1] != self.halfspaces.shape[1]:
            raise ValueError(f"invalid size for new half-spaces: {rows.shape}")
        whole = np.concatenate([self.halfspaces, rows])
        before = np.arange(self.nineq) if restart else self._kept[self._found.facets]
        self._take(whole, np.concatenate([before, np.arange(self.nineq, len(whole))]))

    @property
    def ndim(self) -> int:
        return int(self.halfspaces.shape[1]) - 1

    @property
    def nineq(self) -> int:
        return len(self.halfspaces)

    @cached_property
    def intersections(self) -> Rows:
        return self._found.vertices.copy()

    @cached_property
    def dual_points(self) -> Rows:
        if self._duals is not None:
            return self._duals.copy()
        return half_space_intersection(self.halfspaces, self.interior_point).dual_points.copy()

    @cached_property
    def dual_facets(self) -> list[list[int]]:
        return [self._kept[ids].tolist() for ids in self._found.facets_at_vertices]

    @cached_property
    def dual_vertices(self) -> NDArray[np.int64]:
        return np.array(self._kept[self._found.facets])

    @cached_property
    def dual_equations(self) -> Rows:
        arms = self._found.vertices - self.interior_point
        sizes = np.abs(arms).max(axis=1, keepdims=True)
        lengths = np.linalg.norm(arms / sizes, axis=1, keepdims=True)
        return np.column_stack([arms / sizes / lengths, -1 / lengths / sizes])

    @property
    def dual_volume(self) -> float:
        return self._dual_sizes[0]

    @property
    def dual_area(self) -> float:
        return self._dual_sizes[1]

    @cached_property
    def _dual_sizes(self) -> tuple[float, float]:
        found: Found = self._found
        ends = found.facets_at_vertices
        return sizes_of(found.dual_points, Polygons(ends.offsets, ends.connectivity))


def _rows_of(halfspaces: Any) -> Rows:
    rows = np.array(doubles_of(halfspaces, "the numbers of half-spaces"), np.float64)
    if rows.ndim != 2:
        raise ValueError(f"halfspaces should be provided as a 2D array, not of {rows.ndim} dimensions")
    return rows
