# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Triangulations of points whose x and y have different units: one is scaled by a power of two, without rounding."""

from __future__ import annotations

from functools import cached_property
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ._plane_cells import LocatedCells
from ._results import Floats, Ids, frozen

_GREATEST = np.finfo(np.float64).max
_MOST = 1000  # no scaled point is beyond 2^1000, so no position that would be beyond doubles is one


class RescaledTriangulation(LocatedCells):
    """The exact Delaunay triangulation of points of which the axis of the smaller range is scaled up.

    The factor is a power of two, after which the ranges differ by less than a factor of 2: so scaling does not round,
    and ids and borders are exact. Positions, areas, edge lengths and images are in the caller's unit. Values by
    "natural", "laplace" and "clough-tocher" are those of the scaled points.

    Attributes
    ----------
    scale : ndarray of 2
        by which x and y were multiplied
    scaled : RegularTriangulation
        of the scaled points, with all that such a triangulation offers, in the scaled unit
    """

    scale: Floats
    scaled: Any
    _call: ClassVar[str] = "regular_triangulation(points, rescale=True)"

    @property
    def hidden(self) -> Ids:
        """Ids of the points that do not appear, ascending: duplicates."""
        ids: Ids = self.scaled.hidden
        return ids

    def __repr__(self) -> str:
        return (
            f"<RescaledTriangulation of {self.npoints} points: dimension {self.dimension}, {self._core.cell_count} "
            f"cells, scaled by {self.scale[0]:g} and {self.scale[1]:g}>"
        )

    @cached_property
    def _queries(self) -> Any:
        return _ScaledQueries(self.scaled._queries, self.scale)

    def _queries_of(self, cells: Any) -> Any:
        return _ScaledQueries(self.scaled._queries_of(cells), self.scale)


class _ScaledQueries:
    """The engine's queries at positions in another unit."""

    def __init__(self, queries: Any, scale: Floats) -> None:
        self._queries, self._scale = queries, scale

    def __getattr__(self, name: str) -> Any:
        query = getattr(self._queries, name)
        return lambda *arguments: query(*arguments[:-2], scaled_by(self._scale, arguments[-2]), arguments[-1])

    def image(self, method: str, values: Floats, grid: tuple[float, ...], *arguments: Any) -> Any:
        scaled = np.multiply(grid, np.tile(self._scale, 2)).tolist()
        return self._queries.image(method, values, scaled, *arguments)


def scale_of(points: NDArray[Any]) -> Floats:
    """The powers of two, one of them 1, after which the ranges of x and y differ by less than a factor of 2.

    Neither is above 2^1000, and no scaled point is beyond that.
    """
    rows = points[:, :2].astype(np.float64)
    rows = rows[np.isfinite(rows).all(axis=1)]
    scale = np.ones(2)
    if not len(rows):
        return frozen(scale)
    halves = rows.max(axis=0) / 2 - rows.min(axis=0) / 2  # no overflow
    exponents = np.frexp(halves)[1]
    if (halves > 0).all():
        short = int(exponents.argmin())
        capacity = _MOST - int(np.frexp(np.abs(rows[:, short]).max())[1])
        exponent = min(int(exponents[1 - short] - exponents[short]), capacity, _MOST)
        scale[short] = np.ldexp(1.0, max(exponent, 0))
    return frozen(scale)


def scaled_by(scale: Floats, positions: NDArray[Any]) -> Floats:
    """Positions by x and y; what is beyond doubles at their end."""
    rows: Floats = positions[:, :2].astype(np.float64)
    with np.errstate(over="ignore", invalid="ignore"):
        scaled = rows * scale
    return np.where(np.isfinite(rows), np.clip(scaled, -_GREATEST, _GREATEST), rows)
