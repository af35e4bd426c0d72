# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Some cells of a triangulation, with its points."""

from __future__ import annotations

from functools import cached_property
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _core
from ._errors import InputError
from ._image import Grid, Image, Method
from ._plane_cells import LocatedCells
from ._queries import Lengths, unchanged
from ._results import Floats, Ids, NonFinite, Progress, frozen

_OF_WHOLE = ("natural", "laplace")


class CellSelection(LocatedCells):
    """Some of a triangulation's `simplices`, and queries of these alone. Ids stay those of its points.

    locate() has rows of these `simplices`; what none of them holds is outside. Where a cell that stays and one that
    does not have a border in common, that border is inside. Values are those of the triangulation: natural neighbours
    and gradients are found among all its points. There is no nearest(): take the triangulation's. Where all points are
    on a line, queries of some segments alone are an InputError.

    Attributes
    ----------
    triangulation : RegularTriangulation, ConstrainedTriangulation or CellSelection
        that the cells are of
    within : ndarray of bool
        which of its `simplices` these are
    """

    triangulation: LocatedCells
    within: NDArray[np.bool_]
    _call: ClassVar[str] = "regular_triangulation(points).with_cells(within)"

    @classmethod
    def _with(cls, whole: LocatedCells, within: NDArray[np.bool_]) -> Self:
        return cls._of(
            points=whole.points,
            triangulation=whole,
            within=frozen(within),
            _core=_core.with_cells(whole._triangles, within.view(np.uint8)),
            _ignores=whole._ignores,
        )

    @cached_property
    def vertices(self) -> Ids:
        """Ids of the points that the cells have, ascending."""
        return frozen(np.unique(self.simplices))

    def interpolate(
        self,
        values: ArrayLike,
        points: ArrayLike,
        method: Method = "linear",
        *,
        fill_value: float = np.nan,
        threads: int = 0,
        non_finite: NonFinite = "error",
        progress: Progress = None,
    ) -> Lengths:
        """Values of the triangulation where one of these cells is, bit for bit; as RegularTriangulation has it."""
        if method not in _OF_WHOLE:
            return super().interpolate(
                values, points, method, fill_value=fill_value, threads=threads, non_finite=non_finite, progress=progress
            )
        found = self.triangulation.interpolate(
            values, points, method, fill_value=fill_value, threads=threads, non_finite=non_finite, progress=progress
        )
        is_outside = np.less(self.locate(points, threads=threads, non_finite=non_finite), 0)
        axes = tuple(range(is_outside.ndim, found.ndim))
        chosen: Lengths = np.where(np.expand_dims(is_outside, axes), fill_value, found)[()]
        return chosen

    def __repr__(self) -> str:
        return f"<CellSelection: {self.nsimplex} of {len(self.within)} simplices>"

    def _image_on(
        self,
        grid: Grid,
        values: ArrayLike,
        method: str,
        fill: float,
        dtype: DTypeLike | None,
        threads: int,
        progress: Progress,
    ) -> Image:
        if method not in _OF_WHOLE:
            return super()._image_on(grid, values, method, fill, dtype, threads, progress)
        found = self.triangulation._image_on(grid, values, method, fill, dtype, threads, progress)
        ones: Floats = np.ones(self.npoints)
        is_outside = np.isnan(super()._image_on(grid, ones, "linear", np.nan, None, threads, None).array)
        axes = tuple(range(2, found.array.ndim))
        array = np.where(np.expand_dims(is_outside, axes), found.array.dtype.type(fill), found.array)
        return found._replace(array=frozen(array))

    @property
    def _sites(self) -> NDArray[Any]:
        return self.triangulation._sites

    @cached_property
    def _queries(self) -> Any:
        if self.within.all():
            return self.triangulation._queries
        if self.dimension < 2:
            raise InputError("all points are on a line: queries leave out triangles, and no segments", "bad_argument")
        return self._queries_of(self._core)

    def _queries_of(self, cells: Any) -> Any:
        return self.triangulation._queries_of(cells)


def queries_of_some(sites: NDArray[Any], whole: Any, cells: Any, settings: Any) -> Any:
    """The engine's queries to some cells of what is triangulated, in their order.

    whole: the state of the engine's constrained triangulation
    """
    both = _core.ConstrainedTriangulation.__new__(_core.ConstrainedTriangulation)
    both.__setstate__((whole, cells.__getstate__()))
    with unchanged():
        return _core.constrained_queries(sites, both, settings)


def fixed(state: Any, edges: Ids) -> Any:
    """The state of the engine's triangulation as that of a constrained one with these edges, rows of points."""
    sizes, numbers, figures = state
    zeros = np.zeros(3 * len(edges), np.int64)  # the constraint of each edge, its balance and its sides
    counts = [edges.size, len(edges), len(edges), len(edges)]
    return (
        np.concatenate([sizes, counts]),
        np.concatenate([numbers, edges.reshape(-1), zeros]),
        np.concatenate([[0.0], figures]),
    )
