# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Triangulations of points and lines that have points of their own: breaklines, borders, geometries."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import flag_of
from ._constrained import ConstrainedTriangulation
from ._constraints import Constraints, PolygonRule
from ._errors import InputError, warn_caller
from ._geometries import Degenerate, Lines, lines_of
from ._input import points_of
from ._results import Facets, Floats, Ids, NonFinite, Progress, frozen, ignores, report_of, settings, stretch
from ._triangulation import RegularTriangulation


class JoinedTriangulation(ConstrainedTriangulation):
    """The constrained Delaunay triangulation of points and of lines that have points of their own.

    Attributes
    ----------
    points : ndarray
        the caller's points, then those that lines add, then those where lines cross; with heights if the points have
        them
    point_origin : ndarray of uint8
        for each point 0: the caller's; 1: of a line; 2: where lines cross
    constraints : ndarray of m by 2
        the ids that each piece of a line joins; those of polygons come last
    geometry_of : ndarray
        for each of `constraints` the geometry in lines that it is of
    height_range : ndarray of n by 2, or None
        at each point the lowest and the highest of all heights given there: its own, and those of lines that end there
        or run through. None: there are no heights, or lines have none of their own.
    differing : int
        at how many points these two differ: `numpy.flatnonzero(height_range[:, 0] < height_range[:, 1])` has them
    degenerate : int
        how many rings, lines and geometries of too few points were left out
    """

    point_origin: NDArray[np.uint8]
    geometry_of: Ids
    height_range: Floats | None
    differing: int
    _line_points: Ids  # that were added
    _crossed: Ids  # of each crossing, the ends of the first line there
    _masked: Floats | None  # the points, where some were left out for their height
    _call: ClassVar[str] = "constrained_triangulation(points, lines)"

    @property
    def _sites(self) -> NDArray[Any]:
        return self.points if self._masked is None else self._masked

    def __repr__(self) -> str:
        added, crossings = ((self.point_origin == origin).sum() for origin in (1, 2))
        return (
            f"<JoinedTriangulation of {self.npoints} points, {added} of lines and {crossings} where they cross: "
            f"dimension {self.dimension}, {self._core.cell_count} cells, {self.dropped} dropped, "
            f"{len(self.fixed_edges)} fixed edges, {self.differing} points of several heights>"
        )


class _LineConstraints(Constraints):
    """The pieces of lines, which errors name as the caller's geometries."""

    def __init__(self, lines: Lines, pieces: Ids, piece_of: Ids, sides: int, by_direction: bool) -> None:
        self.ends, self.sides, self.by_direction = pieces, sides, by_direction
        self._names, self._chain_of = lines.names, lines.chain_of[piece_of]

    def _is_pair(self, row: int) -> bool:
        return False

    def _name_of(self, row: int) -> str:
        return self._names[int(self._chain_of[row])]


def constrained_triangulation(
    points: ArrayLike,
    lines: Any,
    *,
    closed_lines_as_borders: bool = False,
    polygon_rule: PolygonRule = "even-odd",
    facets: Facets = "triangles",
    threads: int = 0,
    non_finite: NonFinite = "error",
    degenerate: Degenerate = "error",
    progress: Progress = None,
) -> JoinedTriangulation:
    """The exact constrained Delaunay triangulation of points and lines, as they come: breaklines, outlines, geometries.

    The points of lines are added. At the x and y of a point, that point is used. A line is divided at all points on
    it. Lines may cross: a point is added there, with each coordinate rounded to the nearest double.

    Heights are the third coordinates. A point keeps its own; an added one has that of the first line that has a point
    there, and a crossing that of the first line that crosses, linear between its points. Lines come before polygons, in
    the order in which they are given. No other height is lost: see `height_range` and `differing` of the result. Lines
    without heights take them from the points: an added point has what
    `regular_triangulation(points).interpolate(points[:, 2], ...)` gives: NaN, and a warning, outside the points' hull.

    Parameters
    ----------
    points : n by 2, or n by 3
        x, y, and heights; none at all with []
    lines : geometries
        a geometry of shapely, or anything with __geo_interface__, as a GeoSeries; or a mapping in its form; or an array
        of n by 2 or n by 3 coordinates, which is one line; or a list of these. LineString, LinearRing, Polygon, their
        Multi..., GeometryCollection, Feature and FeatureCollection are taken. Polygons are borders: cells outside are
        left out. To have their sides as lines alone, pass `polygon.boundary`. All lines have 2 coordinates, or all 3.
    closed_lines_as_borders : bool
        whether lines that end where they begin are rings of polygons, alone or joined end to end: where exactly two
        ends are. Only the first is, of rings that run along the same segments all the way.
    polygon_rule : {"even-odd", "direction"}
        what is inside polygons: as for regular_triangulation(). By "even-odd", rings may have any direction, and of
        several geometries their union is inside; all closed lines are one of these.
    facets : {"triangles", "polygons"}
        which form of the facets is made at once; the other is made when it is first used
    threads, non_finite, progress
        see the module. Lines have to be finite in any case.
    degenerate : {"error", "ignore"}
        what lines of one point, rings of one or two, empty and missing geometries lead to: an error, or that they are
        left out and counted; a polygon with its holes

    Raises
    ------
    InputError
        names the first point at fault; or the geometry and the vertex: a coordinate that is NaN or infinite, fewer than
        two points (a ring: three), no point at all, coordinates of 2 and of 3 numbers
    TypeError
        names what is no line
    """
    array, left_out = points_of(points, ignores(non_finite))
    given = lines_of(lines, flag_of("closed_lines_as_borders", closed_lines_as_borders), degenerate)
    with report_of(progress) as report:

        def part(begin: float, end: float) -> Any:
            return settings(threads, facets, non_finite, "cpu", stretch(report, begin, end), left_out)[0]

        return joined_triangulation(array, given, polygon_rule, left_out, part)


def joined_triangulation(
    array: NDArray[Any],
    given: Lines,
    polygon_rule: PolygonRule,
    left_out: bool,
    part: Callable[[float, float], Any],
    heights_needed: bool = False,
) -> JoinedTriangulation:
    """With the settings of each part of the run.

    heights_needed: whether a line without heights that leaves the points' hull is an error, not a warning
    """
    by_direction = Constraints(None, None, polygon_rule).by_direction
    if not len(array):
        array = np.empty((0, given.points.shape[1]))
    if array.shape[1] < given.points.shape[1]:
        raise InputError(
            "lines have heights, and points have none: pass points of three columns, or lines of two coordinates",
            "bad_argument",
        )

    arguments = array, given.points, given.ends, given.sides
    pieces, piece_of, sides, added, line_points, crossed, joined = _core.join_lines(*arguments, True, part(0.0, 0.2))
    whole = np.zeros((len(array) + len(added), array.shape[1]))
    whole[: len(array)], whole[len(array) :, :2] = array, added
    constraints = _LineConstraints(given, pieces, piece_of, sides, by_direction)
    features = None if by_direction else given.features_of(piece_of[len(pieces) - sides :])
    try:
        core = _core.constrained_triangulation(whole, pieces, sides, by_direction, features, part(0.2, 0.8))
    except InputError as error:
        raise constraints.of_error(error) from None
    constraints.warn_if_none(core)
    heights, differing, last = None, 0, part(0.8, 1.0)
    if given.points.shape[1] == 3:
        whole[len(array) :, 2], heights, differing = _core.line_heights(*arguments, joined, core, last)
    elif array.shape[1] == 3 and len(added):
        plain = RegularTriangulation._of(
            points=array, weights=None, _core=_core.regular_triangulation(array, None, last), _ignores=left_out
        )
        whole[len(array) :, 2] = plain.interpolate(array[:, 2], added)
        unknown = np.flatnonzero(np.isnan(whole[len(array) :, 2]))
        _refuse_outside(added, unknown[plain.locate(added[unknown]) < 0], len(array), heights_needed)
    counts = len(array), len(line_points), len(added) - len(line_points)
    origin = np.repeat(np.array([0, 1, 2], np.uint8), counts)
    return JoinedTriangulation._of(
        points=frozen(whole),
        weights=None,
        constraints=pieces,
        dropped=core.dropped,
        point_origin=frozen(origin),
        geometry_of=frozen(given.geometry_of[piece_of]),
        height_range=heights,
        _line_points=line_points,
        _crossed=np.column_stack(
            [pieces[np.searchsorted(piece_of, crossed), 0], pieces[np.searchsorted(piece_of, crossed, "right") - 1, 1]]
        ),
        _masked=None,
        differing=differing,
        _core=core.inside(),
        _ignores=left_out,
        degenerate=given.degenerate,
        _whole=core,
        _sides=sides,
        _by_direction=by_direction,
        _features=features,
    )


def _refuse_outside(added: Floats, outside: Ids, given: int, heights_needed: bool) -> None:
    """Of these points that lines add, those outside of the points' hull have no height."""
    if not len(outside):
        return
    first = tuple(added[outside[0]].tolist())
    sentence = f"lines without heights leave the points' hull: first at {first}, {len(outside)} such point(s) in all"
    if heights_needed:
        raise InputError(sentence, "bad_argument", given + int(outside[0]), len(outside))
    warn_caller(sentence + ", whose heights are NaN")
