# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Terrain meshes of arrays: a triangulation of some of the points, within a tolerance of all."""

from __future__ import annotations

from operator import index
from typing import ClassVar

from numpy.typing import ArrayLike

from . import _core
from ._arguments import float_of
from ._constraints import Chains, Constraints
from ._errors import InputError
from ._input import column_of, points_of
from ._results import Floats, Frozen, Ids, NonFinite, Progress, ignores, named, run, settings


class TerrainMesh(Frozen):
    """A constrained Delaunay triangulation of some of the points: those that the tolerance takes.

    It is bit for bit that of these points alone, so `regular_triangulation(points[mesh.vertices], ...)` has it with
    all that triangulations offer.

    Attributes
    ----------
    vertices : ndarray
        ids of the points that were kept, ascending
    simplices : ndarray of m by 3
        the triangles as ids, counter-clockwise; m by 2 where all points are on one line
    fixed_edges : ndarray of k by 2
        the edges that constraints run along, as ids, the lower one first; in lexicographic order
    constraint_of : ndarray
        for each of these the first constraint that runs along it: of polylines, all pairs of consecutive ids
    errors : ndarray
        for each point given how far it is above the mesh, the true number rounded to the nearest double; 0 at vertices,
        NaN where a point was left out
    greatest_error : float
        the greatest magnitude among them
    beyond : int
        how many points are farther than the tolerance; 0: it is met, exactly
    unreachable : int
        how many of these are at the position of a vertex, which has another height
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
    greatest_error: float
    beyond: int
    unreachable: int
    dimension: int
    statistics: dict[str, float]
    _call: ClassVar[str] = "terrain_mesh(points, tolerance=...)"

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
    threads: int = 0,
    non_finite: NonFinite = "error",
    progress: Progress = None,
) -> TerrainMesh:
    """A mesh of some of the points, from which no other point is farther, vertically, than the tolerance: exactly.

    It begins with the corners of the convex hull and the ends of constraints; then the worst point becomes a vertex,
    again and again.

    Parameters
    ----------
    points : n by 3, or n by 2 with heights
        x and y, and z if there are no heights
    heights : n numbers, optional
        instead of z
    tolerance : float
        the greatest vertical distance, 0 or more, in the unit of heights
    max_vertices : int, optional
        no point is inserted once there are so many. By default there is no limit.
    constraints : m by 2 ids, or a sequence of polylines, optional
        breaklines, as regular_triangulation() takes them: they are edges, parted where a vertex is on them
    threads, non_finite, progress
        see the module; a height that is not finite is like such a coordinate

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
        left_out = left_out or masked
        if len(levels) != len(array):
            text = f"there are {len(levels)} heights for {len(array)} points"
            raise InputError(text, "bad_argument", len(array), len(levels))
    elif array.shape[1] == 2:
        raise ValueError("points of two coordinates take heights: pass heights, or points of three coordinates")
    given = Constraints(constraints, None)
    chosen = settings(threads, "triangles", non_finite, "cpu", progress, left_out)
    try:
        found = run(chosen, _core.terrain_mesh, array, levels, given.ends, *limits)
    except InputError as error:
        raise given.of_error(error) from None
    found["statistics"] = named(found["statistics"])
    return TerrainMesh._of(**found)


def limits_of(tolerance: float, vertices: int | None) -> tuple[float, int]:
    """When a mesh is fine enough, from the arguments of these names: 0 vertices for no limit."""
    number = float_of("tolerance", tolerance)
    if not number >= 0:
        raise ValueError(f"tolerance is 0 or more, not {tolerance!r}")
    if vertices is None:
        return number, 0
    try:
        most = index(vertices)
    except TypeError:
        raise TypeError(f"max_vertices is an integer or None, not {vertices!r}") from None
    if not 0 < most < 2**63:
        raise ValueError(f"max_vertices is 1 or more, or None, not {vertices}")
    return number, most
