# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Constrained Delaunay triangulations of arrays: regular ones in form, without what needs empty circles."""

from __future__ import annotations

from functools import cached_property
from typing import Any, ClassVar, NoReturn

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._constraints import Constraints
from ._errors import InputError
from ._geometries import multi_line
from ._image import Method
from ._queries import Lengths, changed, finite, unchanged
from ._results import QUIET, Ids, NonFinite, Polygons, Progress, Validation, run
from ._triangulation import RegularTriangulation


class ConstrainedTriangulation(RegularTriangulation):
    """The exact constrained Delaunay triangulation of points in the plane: without the cells outside of polygons.

    All constraints are edges, or chains of edges where points are on them. No point that can be seen from inside a
    triangle lies inside its circumcircle. All points stay, also those that only cells outside have. `convex_hull` is
    then the border of the cells that are left. locate() and interpolate() are over these cells, too; a point that none
    of them holds is outside. There is no nearest(), no natural neighbours and no power_diagram(): they are those of the
    triangulation without constraints.

    Attributes
    ----------
    constraints : ndarray of m by 2
        the ids that each joins: the caller's constraints (of polylines, all pairs of consecutive ids), then the sides
        of polygons
    dropped : int
        how many cells were outside of the polygons; of `polygons`, if facets="polygons" was chosen
    degenerate : int
        how many polylines and polygons of too few ids were left out
    """

    constraints: Ids
    dropped: int
    degenerate: int = 0
    _whole: Any
    _sides: int
    _by_direction: bool
    _features: Ids | None = None  # of sides, if the union of several is inside
    _call: ClassVar[str] = "regular_triangulation(points, constraints=...)"

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in super().__getstate__().items() if name != "_core"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        super().__setstate__(state | {"_core": state["_whole"].inside()})

    @cached_property
    def fixed_edges(self) -> Ids:
        """The edges that constraints run along, as ids, the lower one first; in lexicographic order.

        Also those outside.
        """
        return self._whole.fixed_edges()

    @cached_property
    def constraint_of(self) -> Ids:
        """For each of `fixed_edges` the first row of `constraints` that runs along it."""
        return self._whole.constraint_of()

    @cached_property
    def fixed_lines(self) -> dict[str, Any]:
        """`fixed_edges` as a MultiLineString, a mapping of the protocol __geo_interface__.

        Coordinates are three if the points have three. shapely.geometry.shape() takes it.
        """
        return multi_line(finite(self.points, self.fixed_edges), self.fixed_edges)

    @cached_property
    def polygons(self) -> Polygons:
        """Facets as ids: all points of one circle that no constraint parts are one polygon."""
        core = self._core
        if core.cell_size == 3:
            as_polygons = _core.Settings(0, True, self._ignores, 1, None)
            with unchanged():
                whole = _core.constrained_triangulation(
                    self._sites, self.constraints, self._sides, self._by_direction, self._features, as_polygons
                )
            core = whole.inside()
            if not np.array_equal(core.triangles().corners(), self._core.corners()):
                raise changed()
        return Polygons(core.offsets(), core.corners())

    def power_diagram(
        self,
        domain: Any = None,
        *,
        bounds: ArrayLike | None = None,
        box: ArrayLike | None = None,
        threads: int = 0,
        progress: Progress = None,
    ) -> NoReturn:
        """A TypeError: constrained triangulations have no power diagram."""
        raise TypeError("a constrained triangulation has no power diagram: take that of the points without constraints")

    def voronoi_diagram(self) -> NoReturn:
        """A TypeError: constrained triangulations have no Voronoi diagram."""
        raise TypeError(
            "a constrained triangulation has no Voronoi diagram: take that of the points without constraints"
        )

    def nearest(
        self, points: ArrayLike, *, threads: int = 0, non_finite: NonFinite = "error", progress: Progress = None
    ) -> NoReturn:
        """A TypeError: that is a question to the triangulation without constraints."""
        raise TypeError("a constrained triangulation has no nearest(): take that of the points without constraints")

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
        """Values between the points' values, over each of `simplices`; as RegularTriangulation has it.

        "natural" and "laplace" are an InputError: natural neighbours are those of the triangulation without
        constraints. The gradients of "clough-tocher" are estimated across constraints, too.
        """
        if method in ("natural", "laplace"):
            raise InputError(
                "a constrained triangulation has no natural neighbours: take method='linear', or interpolate in the "
                "triangulation of the points without constraints",
                "bad_argument",
            )
        return super().interpolate(
            values, points, method, fill_value=fill_value, threads=threads, non_finite=non_finite, progress=progress
        )

    def validate(self, *, threads: int = 0) -> Validation:
        """Decides exactly whether this is the constrained triangulation of the points, before cells were left out."""
        fault, text, index = _core.validate_constrained(
            self._sites, self.constraints, self._sides, self._whole, threads
        )
        return Validation(fault == 0, text, index)

    def __repr__(self) -> str:
        return (
            f"<ConstrainedTriangulation of {self.npoints} points: dimension {self.dimension}, {self._core.cell_count} "
            f"cells, {self.dropped} dropped, {len(self.fixed_edges)} fixed edges>"
        )

    def _queries_of(self, cells: Any) -> Any:
        with unchanged():
            return _core.constrained_queries(self._sites, self._whole, QUIET, cells)


def constrained_triangulation(
    points: NDArray[Any], given: Constraints, chosen: tuple[Any, Any], ignores: bool
) -> ConstrainedTriangulation:
    """With the settings that are chosen."""
    try:
        arguments = points, given.ends, given.sides, given.by_direction, None
        core = run(chosen, _core.constrained_triangulation, *arguments)
    except InputError as error:
        raise given.of_error(error) from None
    given.warn_if_none(core)
    return ConstrainedTriangulation._of(
        points=points,
        weights=None,
        constraints=given.ends,
        dropped=core.dropped,
        degenerate=given.degenerate,
        _core=core.inside(),
        _ignores=ignores,
        _whole=core,
        _sides=given.sides,
        _by_direction=given.by_direction,
    )
