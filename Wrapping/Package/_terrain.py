# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Terrain meshes of arrays: a triangulation of some of the points, within a tolerance of all."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import float_of, most_of
from ._constraints import Chains, Constraints
from ._errors import InputError
from ._geometries import Degenerate, Lines, lines_of
from ._input import column_of, either_excluded, points_of
from ._lines import JoinedTriangulation, joined_triangulation
from ._results import (
    Floats,
    Frozen,
    Ids,
    NonFinite,
    Progress,
    edges_of,
    frozen,
    ignores,
    named,
    report_of,
    settings,
    stretch,
)


class TerrainMesh(Frozen):
    """A constrained Delaunay triangulation of some of the points: those that the tolerance takes.

    It is bit for bit that of these points alone, so `regular_triangulation(points[mesh.vertices], ...)` has it with
    all that triangulations offer.

    Attributes
    ----------
    vertices : ndarray
        ids of the points that were kept, ascending; with lines, of the points of `joined`
    simplices : ndarray of m by 3
        the triangles as ids, counter-clockwise; m by 2 where all points are on one line
    fixed_edges : ndarray of k by 2
        the edges that constraints run along, as ids, the lower one first; in lexicographic order
    constraint_of : ndarray
        for each of these the first constraint that runs along it: of polylines, all pairs of consecutive ids
    errors : ndarray
        for each point how far it is above the mesh, the true number rounded to the nearest double; 0 at vertices, NaN
        where a point was left out
    tolerance : float
        that was asked for; 0 without points
    greatest_error : float
        the greatest magnitude of errors
    beyond : int
        how many points are farther than the tolerance; 0: it is met, exactly
    unreachable : int
        how many of these are at the position of a vertex, which has another height
    degenerate : int
        how many constraints, lines and geometries of too few points were left out
    joined : JoinedTriangulation or None
        with lines, the triangulation of all points and theirs: `joined.points` are those given, then those that lines
        add, then those where lines cross; `joined.geometry_of[constraint_of]` are the geometries
    dimension : int
        of what the points span in x and y: -1 (no point) to 2
    statistics : dict
        counts and seconds; non_finite: how many points were left out
    """

    vertices: Ids
    simplices: Ids
    fixed_edges: Ids
    constraint_of: Ids
    errors: Floats
    tolerance: float
    greatest_error: float
    beyond: int
    unreachable: int
    degenerate: int
    joined: JoinedTriangulation | None
    dimension: int
    statistics: dict[str, float]
    _call: ClassVar[str] = "terrain_mesh(points, tolerance=...)"

    @cached_property
    def edges(self) -> Ids:
        """The edges of `simplices`, each once, as ids, the lower one first; in lexicographic order."""
        return edges_of(self.simplices)

    def __len__(self) -> int:
        return len(self.vertices)

    def __repr__(self) -> str:
        return (
            f"<TerrainMesh: {len(self.vertices)} of {len(self.errors)} points, {len(self.simplices)} simplices, "
            f"greatest error {self.greatest_error:.3g}, {self.beyond} beyond>"
        )


def terrain_mesh(
    points: ArrayLike,
    heights: ArrayLike | None = None,
    *,
    tolerance: float = 0.0,
    max_vertices: int | None = None,
    constraints: Chains | None = None,
    lines: Any = None,
    threads: int = 0,
    non_finite: NonFinite = "error",
    degenerate: Degenerate = "error",
    progress: Progress = None,
) -> TerrainMesh:
    """A mesh of some of the points, from which no other point is farther, vertically, than the tolerance: exactly.

    It begins with the corners of the convex hull, the ends of constraints and the points of lines; then the worst point
    becomes a vertex, again and again.

    Parameters
    ----------
    points : n by 3, or n by 2 with heights
        x and y, and z if there are no heights
    heights : n numbers, optional
        instead of z
    tolerance : float
        the greatest vertical distance, 0 or more, in the unit of heights. By default 0, where that of
        vtkFFTerrainMeshFilter is a hundredth of the heights' range.
    max_vertices : int, optional
        no point is inserted once there are so many. By default there is no limit.
    constraints : m by 2 ids, or a sequence of polylines, optional
        breaklines, as regular_triangulation() takes them: they are edges, parted where a vertex is on them
    lines : geometries, optional
        instead, breaklines with points of their own, as constrained_triangulation() takes them, which says which points
        they add, where they cross, too, and at which heights. Of polygons, only the sides count.
    threads, non_finite, progress
        see the module; a height that is not finite is like such a coordinate
    degenerate : {"error", "ignore"}
        as regular_triangulation() has it for constraints, and constrained_triangulation() for lines

    Raises
    ------
    InputError
        names the first point at fault and how many there are

    Notes
    -----
    Of several points at one position, the one of the lowest id is the vertex. Others there whose heights differ by more
    than the tolerance are `unreachable`.
    """
    limits = limits_of(tolerance, max_vertices)
    ignore = ignores(non_finite)
    array, left_out = points_of(points, ignore)
    levels = None
    if heights is not None:
        levels, masked = column_of(heights, "height", ignore)
        if len(levels) != len(array):
            text = f"there are {len(levels)} heights for {len(array)} points"
            raise InputError(text, "bad_argument", len(array), len(levels))
        left_out = either_excluded(array, left_out, levels, masked)
    elif array.shape[1] == 2:
        raise ValueError("points of two coordinates take heights: pass heights, or points of three coordinates")
    with report_of(progress) as report:

        def part(begin: float, end: float) -> Any:
            return settings(threads, "triangles", non_finite, "cpu", stretch(report, begin, end), left_out)[0]

        if lines is not None:
            if constraints is not None:
                raise ValueError("breaklines are constraints or lines, not both")
            return mesh_with_lines(array, levels, lines_of(lines, False, degenerate), limits, left_out, part)
        given = Constraints(constraints, None, degenerate=degenerate)
        try:
            found, _ = _core.terrain_mesh(array, levels, given.ends, *limits, part(0.0, 1.0))
        except InputError as error:
            raise given.of_error(error) from None
    found["statistics"] = named(found["statistics"])
    return TerrainMesh._of(joined=None, degenerate=given.degenerate, **found)


def mesh_with_lines(
    array: NDArray[Any],
    levels: NDArray[Any] | None,
    lines: Lines,
    limits: tuple[float, int],
    left_out: bool,
    part: Callable[[float, float], Any],
) -> TerrainMesh:
    """The mesh of points and lines of their own, with the settings of each part of the run."""
    whole = np.array(array[:, :3] if levels is None else np.column_stack([array[:, :2], levels]), np.float64)
    masked = whole.copy()
    masked[~np.isfinite(whole[:, 2]), 0] = np.nan  # such a point is no line's
    edges = lines._replace(sides=0, features=None)
    joined = joined_triangulation(
        masked, edges, "even-odd", left_out, lambda begin, end: part(0.5 * begin, 0.5 * end), True
    )
    if left_out:
        given = frozen(np.concatenate([whole, joined.points[len(array) :]]))
        joined = JoinedTriangulation._of(**{**vars(joined), "points": given, "_masked": joined.points})
    found, _ = _core.terrain_mesh(joined.points, None, joined.constraints, *limits, part(0.5, 1.0))
    found["statistics"] = named(found["statistics"])
    return TerrainMesh._of(joined=joined, degenerate=lines.degenerate, **found)


def limits_of(tolerance: float, vertices: int | None) -> tuple[float, int]:
    """When a mesh is fine enough, from the arguments of these names: 0 vertices for no limit."""
    number = float_of("tolerance", tolerance)
    if not number >= 0:
        raise ValueError(f"tolerance is 0 or more, not {tolerance!r}")
    return number, most_of("max_vertices", vertices)
