# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Constrained Delaunay triangulations of arrays: regular ones in form, without what needs empty circles."""

from __future__ import annotations

from functools import cached_property
from typing import Any, NoReturn

from numpy.typing import ArrayLike, NDArray

from . import _core
from ._constraints import Constraints
from ._errors import InputError
from ._results import Ids, Polygons, Progress, Validation, run
from ._triangulation import RegularTriangulation


class ConstrainedTriangulation(RegularTriangulation):
    """The exact constrained Delaunay triangulation of points in the plane: without the cells outside of polygons.

    All constraints are edges, or chains of edges where points are on them. No point that can be seen from inside a
    triangle lies inside its circumcircle. All points stay, also those that only cells outside have. `convex_hull` is
    then the border of the cells that are left. There is no locate(), nearest(), interpolate() and power_diagram(): they
    are for regular triangulations.

    Attributes
    ----------
    constraints : ndarray of m by 2
        the ids that each joins: the caller's constraints (of polylines, all pairs of consecutive ids), then the sides
        of polygons
    fixed_edges : ndarray of k by 2
        the edges that constraints run along, as ids, the lower one first; in lexicographic order. Also those outside.
    constraint_of : ndarray
        for each of these the first row of constraints that runs along it
    dropped : int
        how many cells were outside of the polygons; of `polygons`, if facets="polygons" was asked for
    """

    constraints: Ids
    fixed_edges: Ids
    constraint_of: Ids
    dropped: int
    _whole: Any
    _sides: int
    _by_direction: bool

    def __init__(self, points: NDArray[Any], given: Constraints, core: Any, ignores: bool) -> None:
        super().__init__(points, None, core.inside(), ignores)
        self.__dict__.update(
            constraints=given.ends,
            fixed_edges=core.fixed_edges(),
            constraint_of=core.constraint_of(),
            dropped=core.dropped,
            _whole=core,
            _sides=given.sides,
            _by_direction=given.by_direction,
        )

    @cached_property
    def polygons(self) -> Polygons:
        """Facets as ids: all points of one circle that no constraint parts are one polygon."""
        core = self._core
        if core.cell_size == 3:
            as_polygons = _core.Settings(0, True, self._ignores, 1, None)
            whole = _core.constrained_triangulation(
                self.points, self.constraints, self._sides, self._by_direction, as_polygons
            )
            core = whole.inside()
        return Polygons(core.offsets(), core.corners())

    def power_diagram(self, box: ArrayLike | None = None, *, threads: int = 0, progress: Progress = None) -> NoReturn:
        """A TypeError: constrained triangulations have no power diagram."""
        raise TypeError("a constrained triangulation has no power diagram: take that of the points without constraints")

    def validate(self, *, threads: int = 0) -> Validation:
        """Decides exactly whether this is the constrained triangulation of the points, before cells were left out."""
        fault, text, index = _core.validate_constrained(
            self.points, self.constraints, self._sides, self._whole, threads
        )
        return Validation(fault == 0, text, index)

    def __repr__(self) -> str:
        return (
            f"<ConstrainedTriangulation of {self.npoints} points: dimension {self.dimension}, {self._core.cell_count} "
            f"cells, {self.dropped} dropped, {len(self.fixed_edges)} fixed edges>"
        )

    @property
    def _queries(self) -> NoReturn:
        raise TypeError(
            "a constrained triangulation has no locate(), nearest() and interpolate(): take the triangulation of the "
            "points without constraints"
        )


def constrained_triangulation(
    points: NDArray[Any], given: Constraints, chosen: tuple[Any, Any], ignores: bool
) -> ConstrainedTriangulation:
    """With the settings that are chosen."""
    try:
        core = run(chosen, _core.constrained_triangulation, points, given.ends, given.sides, given.by_direction)
    except InputError as error:
        raise given.of_error(error) from None
    given.warn_if_none(core)
    return ConstrainedTriangulation(points, given, core, ignores)
