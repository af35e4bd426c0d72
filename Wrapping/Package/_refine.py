# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of polygons whose triangles have no small angles, for finite elements."""

from __future__ import annotations

from functools import cached_property
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._areas import AreaFunction, PolygonRegion, limits_of, regions_of, with_sides
from ._arguments import float_of, most_of
from ._constraints import Chains, Constraints, PolygonRule, SplitConstraints
from ._errors import InputError, warn_caller
from ._geometries import Degenerate, lines_of
from ._image import Image
from ._input import values_of, whole_points_of
from ._lines import joined_triangulation
from ._results import Floats, Frozen, Ids, Progress, edges_of, frozen, named, report_of, settings, stretch


class RefinedMesh(Frozen):
    """A constrained Delaunay triangulation without small angles: bit for bit that of its points and segments.

    Attributes
    ----------
    points : ndarray of n by 2
        those given, those that lines add, then the new ones
    heights : ndarray or None
        of these points, where those given have three coordinates; of new ones as by values_at_points()
    new_points : int
        how many are new
    simplices : ndarray of m by 3
        the triangles in the mesh, as ids, counter-clockwise
    areas, angles : ndarray
        of each triangle the area, and the least angle in degrees; rounded
    region_of : ndarray
        for each triangle the row of regions that it is in, -1 if it is in none
    segments : ndarray of k by 2
        the edges that constraints run along, as ids, the lower one first; in lexicographic order
    constraint_of : ndarray
        for each of these the first constraint that runs along it (of polylines, all pairs of consecutive ids, then the
        sides of polygons); -1: an edge of the convex hull
    constraint_of_point : ndarray
        for each new point the constraint that it divides; -1: none
    small_angles : ndarray of a by 3
        the apex and the other ends, counter-clockwise, of each angle of less than 60 degrees between constraints in the
        mesh: there triangles may be thin
    constraints : ndarray
        the ids that each constraint joins
    is_complete : bool
        whether maximum_points did not end it
    kept_segments, kept_triangles : int
        how many segments were too short to be divided, and triangles too near to a vertex
    degenerate : int
        how many polylines, rings and geometries of too few points were left out
    statistics : dict
        counts and seconds
    """

    points: Floats
    heights: Floats | None
    new_points: int
    simplices: Ids
    areas: Floats
    angles: Floats
    region_of: Ids
    segments: Ids
    constraint_of: Ids
    constraint_of_point: Ids
    small_angles: Ids
    constraints: Ids
    is_complete: bool
    kept_segments: int
    kept_triangles: int
    degenerate: int
    dimension: int
    statistics: dict[str, float]
    _across: Ids
    _shares: tuple[Ids, Ids, Floats]
    _call: ClassVar[str] = "refined_mesh(points)"

    @cached_property
    def neighbors(self) -> Ids:
        """For each corner of each of `simplices` the simplex opposite to it, -1 where there is none."""
        return frozen(np.roll(self._across, 2, axis=1))

    @cached_property
    def edges(self) -> Ids:
        """The edges of `simplices`, each once, as ids, the lower one first; in lexicographic order."""
        return edges_of(self.simplices)

    def values_at_points(self, values: ArrayLike) -> Floats:
        """Values at all points, given those at the points that are not new.

        On a constraint they are linear between the ends of it, inside over the triangles of the points that are not
        new.

        Parameters
        ----------
        values : array of one row or number a point
            of the len(points) - new_points first points
        """
        given = values_of(values, len(self.points) - self.new_points)
        offsets, ids, shares = self._shares
        columns = given.reshape(len(given), int(np.prod(given.shape[1:])))
        new = sums_of(columns[ids] * shares[:, None], offsets)
        return frozen(np.concatenate([columns, new]).reshape((len(self.points), *given.shape[1:])))

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
    maximum_area: float | ArrayLike | Image | AreaFunction | None = None,
    regions: Any = None,
    holes: ArrayLike | None = None,
    maximum_points: int | None = None,
    polygon_rule: PolygonRule = "even-odd",
    degenerate: Degenerate = "error",
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
        in degrees, from 0 to 34. Up to 20.7 the refinement is proven to end, to 30 it does in practice; above there is
        a warning, as maximum_points may end it.
    maximum_area : number, or an array of n, or an Image, or a function, optional
        of a triangle; by default any. Of several numbers, that at its centroid: linear between the points, without
        lines; bilinear between the centers of pixels; or what a function gives: called about twenty times, each time
        with an array of k by 2, it returns k areas. They are above 0, or infinite: any.
    regions : r by 2, or r by 3, or a list, optional
        a point in each part of the mesh, which constraints enclose; and the greatest area there, 0 for maximum_area.
        In a list, with lines, also polygons, or polygons and areas: (polygon, area). Their sides become constraints.
    holes : h by 2, optional
        a point in each part that is to be left out
    maximum_points : int, optional
        no more points are inserted; by default ten million. Then the mesh is not complete, and there is a warning.
    degenerate : {"error", "ignore"}
        as for regular_triangulation(), and as for constrained_triangulation() of lines and of regions that are polygons
    threads, progress
        see the module

    Raises
    ------
    InputError
        as regular_triangulation(); or a row of regions, then of holes, that is outside the mesh, on a constraint, or in
        the part of another
    """
    parts = regions_of(regions, holes, degenerate)
    least, most_points = float_of("minimum_angle", minimum_angle), most_of("maximum_points", maximum_points)
    array = whole_points_of(points)
    areas = limits_of(maximum_area, parts.polygons, len(array) if lines is None else None)
    if parts.polygons and lines is None:
        raise ValueError("regions that are polygons go with lines")
    pixels, placement = areas.of_pixels or (None, (0.0, 0.0, 1.0, 1.0))
    warn_of_angle(least)
    with report_of(progress) as report:

        def part(begin: float, end: float) -> Any:
            return settings(threads, "triangles", "error", "cpu", stretch(report, begin, end), False)[0]

        begin = 0.0
        if lines is not None:
            if constraints is not None or polygons is not None:
                raise ValueError("segments are constraints and polygons, or lines, not both")
            own = lines_of(lines, False, degenerate)
            chains, excluded = with_sides(own, parts.polygons), own.degenerate
            joined = joined_triangulation(array, chains, polygon_rule, False, lambda a, b: part(0.3 * a, 0.3 * b))
            array, begin = joined.points, 0.3
            ends, sides, by_direction = joined.constraints, joined._sides, joined._by_direction
            is_union = chains.features is not None and not by_direction
            features = np.ascontiguousarray(joined.geometry_of[len(ends) - sides :]) if is_union else None
            given = None
        else:
            given = Constraints(constraints, polygons, polygon_rule, degenerate)
            excluded = given.degenerate
            ends, sides, by_direction, features = given.ends, given.sides, given.by_direction, None
        try:
            found = _core.refined_mesh(
                array,
                ends,
                sides,
                by_direction,
                features,
                (least, areas.everywhere, most_points),
                parts.rows,
                areas.of_points,
                pixels,
                placement,
                areas.at,
                part(begin, 1.0),
            )
        except InputError as error:
            named_error = parts.of_error(error)
            raise (named_error if given is None else given.of_error(named_error)) from None
    if not found["is_complete"]:
        warn_caller("maximum_points ended the refinement: some triangles are still thin, or too large")
    found["statistics"] = named(found["statistics"])
    found["region_of"] = _numbered(np.append(-1, parts.numbers)[found["region_of"]], parts.polygons, found)
    counts = {"new_points": len(found["points"]) - len(array), "degenerate": excluded + parts.degenerate}
    mesh = RefinedMesh._of(constraints=ends, heights=None, **counts, **found)
    if array.shape[1] == 3:
        mesh.__dict__["heights"] = mesh.values_at_points(array[:, 2])
    return mesh


def warn_of_angle(least: float) -> None:
    if least > 30:
        warn_caller("minimum_angle is above 30 degrees: the refinement may go on until maximum_points ends it")


def sums_of(rows: Floats, offsets: Ids) -> Floats:
    """Of one row or more each, from first to last."""
    sums, counts = rows[offsets[:-1]], np.diff(offsets)
    for i in range(1, counts.max(initial=0)):
        more = counts > i
        sums[more] += rows[offsets[:-1][more] + i]
    return sums


def _numbered(region_of: Ids, polygons: list[PolygonRegion], found: dict[str, Any]) -> Ids:
    """The regions of triangles, those that are polygons among them: of several, the first."""
    if not polygons:
        return frozen(region_of)
    centroids = found["points"][found["simplices"]].mean(axis=1)
    for polygon in reversed(polygons):
        held = polygon.holds(centroids)
        region_of[held & ((region_of < 0) | (region_of > polygon.number))] = polygon.number
    return frozen(region_of)
