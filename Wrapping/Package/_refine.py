# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of polygons whose triangles have no small angles, for finite elements."""

from __future__ import annotations

from functools import cached_property
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import float_of, most_of
from ._constraints import Chains, Constraints, PolygonRule, SplitConstraints
from ._errors import InputError, warn_caller
from ._geometries import lines_of
from ._input import doubles_of, whole_points_of
from ._lines import joined_triangulation
from ._results import Floats, Frozen, Ids, Progress, edges_of, frozen, named, report_of, settings, stretch


class RefinedMesh(Frozen):
    """A constrained Delaunay triangulation without small angles: bit for bit that of its points and segments.

    Attributes
    ----------
    points : ndarray of n by 2
        those given, those that lines add, then the new ones
    new_points : int
        how many are new
    simplices : ndarray of m by 3
        the triangles in the mesh, as ids, counter-clockwise
    region_of : ndarray
        for each triangle the row of regions that it is in, -1 if it is in none
    segments : ndarray of k by 2
        the edges that constraints run along, as ids, the lower one first; in lexicographic order
    constraint_of : ndarray
        for each of these the first constraint that runs along it (of polylines, all pairs of consecutive ids, then the
        sides of polygons); -1: an edge of the convex hull
    constraint_of_point : ndarray
        for each new point the constraint that it divides; -1: none
    constraints : ndarray
        the ids that each constraint joins
    is_complete : bool
        whether maximum_points did not end it
    kept_segments, kept_triangles : int
        how many segments were too short to be divided, and triangles too near to a vertex
    statistics : dict
        counts and seconds
    """

    points: Floats
    new_points: int
    simplices: Ids
    region_of: Ids
    segments: Ids
    constraint_of: Ids
    constraint_of_point: Ids
    constraints: Ids
    is_complete: bool
    kept_segments: int
    kept_triangles: int
    dimension: int
    statistics: dict[str, float]
    _across: Ids
    _call: ClassVar[str] = "refined_mesh(points)"

    @cached_property
    def neighbors(self) -> Ids:
        """For each corner of each of `simplices` the simplex opposite to it, -1 where there is none."""
        return frozen(np.roll(self._across, 2, axis=1))

    @cached_property
    def edges(self) -> Ids:
        """The edges of `simplices`, each once, as ids, the lower one first; in lexicographic order."""
        return edges_of(self.simplices)

    @cached_property
    def areas(self) -> Floats:
        """The area of each of `simplices`, rounded."""
        a, b, c = (self.points[self.simplices[:, i]] for i in range(3))
        return frozen(0.5 * _cross(b - a, c - a))

    @cached_property
    def angles(self) -> Floats:
        """The least angle of each of `simplices`, in degrees, rounded."""
        corners = [self.points[self.simplices[:, i]] for i in range(3)]
        least = np.full(len(self.simplices), np.inf)
        for i in range(3):
            u, v = corners[(i + 1) % 3] - corners[i], corners[(i + 2) % 3] - corners[i]
            least = np.minimum(least, np.arctan2(_cross(u, v), (u * v).sum(axis=1)))
        return frozen(np.degrees(least))

    def __len__(self) -> int:
        return len(self.simplices)

    def __repr__(self) -> str:
        return f"<RefinedMesh: {len(self.simplices)} triangles, {self.new_points} new of {len(self.points)} points>"


def refined_mesh(
    points: ArrayLike,
    *,
    constraints: Chains | SplitConstraints | None = None,
    polygons: Chains | None = None,
    lines: Any = None,
    minimum_angle: float = 25.0,
    maximum_area: float | None = None,
    regions: ArrayLike | None = None,
    holes: ArrayLike | None = None,
    maximum_points: int | None = None,
    polygon_rule: PolygonRule = "even-odd",
    threads: int = 0,
    progress: Progress = None,
) -> RefinedMesh:
    """A mesh for finite elements: triangles with no smaller angle, and no larger area, than asked for.

    It covers what is inside the polygons; without polygons, what constraints enclose; where they enclose nothing, the
    convex hull. Points are added, by Delaunay refinement: on constraints, rounded, so that a constraint may bend there
    by the last bits; and inside.

    Where constraints meet at less than 60 degrees, triangles between them may be as thin as that angle makes them.

    Parameters
    ----------
    points : n by 2, or n by 3
        x and y count; none at all, with lines, by []
    constraints, polygons, polygon_rule
        as for regular_triangulation()
    lines : geometries, optional
        instead, polygons and lines with points of their own, also of shapely, as constrained_triangulation() takes
        them; they may cross
    minimum_angle : float
        in degrees, from 0 to 34. Up to 20.7 the refinement is proven to end, to 30 it does in practice.
    maximum_area : float, optional
        of a triangle; by default any
    regions : r by 2, or r by 3, optional
        a point in each part of the mesh, which constraints enclose; and the greatest area there, 0 for maximum_area
    holes : h by 2, optional
        a point in each part that is to be left out
    maximum_points : int, optional
        no more points are inserted; by default ten million. Then the mesh is not complete, and there is a warning.
    threads, progress
        see the module

    Raises
    ------
    InputError
        as regular_triangulation(); or a row of regions, then of holes, that is outside the mesh, on a constraint, or in
        the part of another
    """
    parts = _parts_of(regions, holes)
    least, most = float_of("minimum_angle", minimum_angle), _area_of(maximum_area)
    limits = least, most, parts, most_of("maximum_points", maximum_points)
    array = whole_points_of(points)
    with report_of(progress) as report:

        def part(begin: float, end: float) -> Any:
            return settings(threads, "triangles", "error", "cpu", stretch(report, begin, end), False)[0]

        begin = 0.0
        if lines is not None:
            if constraints is not None or polygons is not None:
                raise ValueError("segments are constraints and polygons, or lines, not both")
            joined = joined_triangulation(
                array, lines_of(lines, False, "error"), polygon_rule, False, lambda a, b: part(0.3 * a, 0.3 * b)
            )
            array, begin = joined.points, 0.3
            ends, sides, by_direction = joined.constraints, joined._sides, joined._by_direction
            given = None
        else:
            given = Constraints(constraints, polygons, polygon_rule)
            ends, sides, by_direction = given.ends, given.sides, given.by_direction
        try:
            found = _core.refined_mesh(array, ends, sides, by_direction, *limits, part(begin, 1.0))
        except InputError as error:
            raise (error if given is None else given.of_error(error)) from None
    if not found["is_complete"]:
        warn_caller("maximum_points ended the refinement: some triangles are still thin, or too large")
    region, count = found.pop("region_of"), np.count_nonzero(parts[:, 3] == 0)
    found["statistics"] = named(found["statistics"])
    return RefinedMesh._of(
        new_points=len(found["points"]) - len(array),
        region_of=frozen(np.where((region > 0) & (region <= count), region - 1, -1)),
        constraints=ends,
        **found,
    )


def _cross(u: NDArray[Any], v: NDArray[Any]) -> NDArray[Any]:
    return u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]


def _rows_of(what: str, values: ArrayLike | None, columns: tuple[int, ...]) -> NDArray[np.float64]:
    array = doubles_of([] if values is None else values, what)
    if array.size == 0:
        return np.empty((0, columns[0]))
    if array.ndim != 2 or array.shape[1] not in columns:
        wanted = " or ".join(map(str, columns))
        raise ValueError(f"{what} are rows of {wanted} numbers, not an array of shape {array.shape}")
    return array


def _parts_of(regions: ArrayLike | None, holes: ArrayLike | None) -> NDArray[np.float64]:
    """Rows of x, y, an area, and whether it is a hole: regions, then holes."""
    inside, outside = _rows_of("regions", regions, (2, 3)), _rows_of("holes", holes, (2,))
    parts = np.zeros((len(inside) + len(outside), 4))
    parts[: len(inside), : inside.shape[1]] = inside
    parts[len(inside) :, :2] = outside
    parts[len(inside) :, 3] = 1
    return parts


def _area_of(area: float | None) -> float:
    if area is None:
        return 0.0
    number = float_of("maximum_area", area)
    if not number > 0:
        raise ValueError(f"maximum_area is above 0, or None, not {area!r}")
    return number
