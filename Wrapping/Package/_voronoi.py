# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Unbounded Voronoi and power diagrams of points in the plane."""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._queries import finite, unchanged
from ._results import QUIET, Engine, Floats, Frozen, Ids, NonFinite, Polygons, Progress, frozen, refrozen
from ._rings import Sides, polygons_around, sides_of
from ._triangulation import RegularTriangulation, regular_triangulation


class Rays(NamedTuple):
    """The open ends of a diagram's sides.

    Attributes
    ----------
    ridges : ndarray of r
        the row of `ridge_points` of each
    starts : ndarray of r by 2
        where each begins: a vertex; of a line, the point of equal power between its two points, rounded once
    directions : ndarray of r by 2
        away from the triangulation, perpendicular to the line through its two points and as long as they are apart:
        (b.y - a.y, a.x - b.x) of these as a and b, in one order or the other. Both differences are rounded once; the
        points themselves have the direction exactly. A vector beyond the doubles is halved.
    """

    ridges: Ids
    starts: Floats
    directions: Floats

    def __reduce__(self) -> tuple[Any, ...]:
        return refrozen, (type(self), *self)


class VoronoiDiagram(Frozen):
    """The Voronoi diagram of points in the plane, unbounded; of points with weights, the power diagram.

    Which cells meet, and where, is exact; coordinates of vertices are rounded. Points of one circle meet in one vertex,
    and no side has length zero. Names are those of scipy.spatial.Voronoi. For cells cut at a box or a polygon, see
    power_diagram().

    Points on a line have a diagram of lines, without a vertex; one point has all of the plane, without a side.

    Attributes
    ----------
    triangulation : RegularTriangulation
        whose dual this is: with `points`, `weights` and `hidden`
    """

    triangulation: RegularTriangulation
    _call: ClassVar[str] = "voronoi_diagram(points)"

    @cached_property
    def vertices(self) -> Floats:
        """Where three cells or more meet, as rows of x and y: each rounded once, infinite beyond the doubles."""
        if self.triangulation.dimension < 2:
            return frozen(np.empty((0, 2)))
        core, points, weights, _ = self.triangulation._facets
        with unchanged():
            return _core.facet_centers(points, weights, core, QUIET)

    @property
    def ridge_points(self) -> Ids:
        """The two points between which each side is, the lower id first."""
        return self._ridges[0]

    @property
    def ridge_vertices(self) -> Ids:
        """The two ends of each side, as rows of `vertices`: -1 where it has no end.

        That comes first; of two vertices, the one on the right, seen from the first point to the second.
        """
        return self._ridges[1]

    @cached_property
    def rays(self) -> Rays:
        """Where sides have no end: one ray of each; of a line two, which begin between its points."""
        points, pairs = self.triangulation.points, self.ridge_points
        if self.triangulation.dimension < 2:
            ends = np.repeat(pairs, 2, axis=0)
            ends[1::2] = ends[1::2, ::-1]
            ridges, starts = np.repeat(np.arange(len(pairs)), 2), np.repeat(self._feet, 2, axis=0)
        else:
            ridges = np.flatnonzero(self.ridge_vertices[:, 0] < 0)
            starts = self.vertices[self.ridge_vertices[ridges, 1]]
            ends = self._border
        corners = finite(points, ends)[ends, :2].astype(np.float64)
        return Rays(frozen(ridges), frozen(starts), frozen(_perpendicular(corners[:, 0], corners[:, 1])))

    @cached_property
    def _feet(self) -> Floats:
        """For points on a line: of each pair the point of equal power on the line."""
        points, weights, pairs = self.triangulation.points, self.triangulation.weights, self.ridge_points
        positions: list[Any] = finite(points, pairs)[pairs, :2].tolist()
        sizes: list[Any] = [[0.0, 0.0]] * len(pairs) if weights is None else weights[pairs].tolist()
        feet = [_between(*two, *both) for two, both in zip(positions, sizes)]
        return frozen(np.array(feet, float).reshape(-1, 2))

    @property
    def cells(self) -> Polygons:
        """The vertices of each cell, counter-clockwise; of an open one from one ray to the other."""
        return self._cells[0]

    @property
    def is_open(self) -> NDArray[np.bool_]:
        """Which cells have no end: those of the points on the border of the triangulation."""
        return self._cells[1]

    @property
    def sites(self) -> Ids:
        """The id of each cell's point, ascending."""
        return self.triangulation.vertices

    @cached_property
    def cell_of(self) -> Ids:
        """For each point the row of its cell; of a hidden one, of a cell that its position is in, exactly.

        A point at the position of others has the cell of theirs. -1: the point is not finite and ignored.
        """
        found = np.full(self.triangulation.npoints, -1)
        found[self.sites] = np.arange(len(self.sites))
        hidden = self.triangulation.hidden
        if len(hidden):
            found[hidden] = found[np.asarray(self.triangulation.nearest(self.triangulation.points[hidden]))]
        return frozen(found)

    def __len__(self) -> int:
        return len(self.sites)

    def __repr__(self) -> str:
        return f"<VoronoiDiagram: {len(self)} cells, {len(self.vertices)} vertices, {len(self.ridge_points)} sides>"

    @cached_property
    def _sides(self) -> Sides:
        """The sides of the triangulation's facets; ends are rows of `sites`."""
        core = self.triangulation._facets[0]
        return sides_of(Polygons(core.offsets(), core.connectivity()))

    @cached_property
    def _chosen(self) -> Ids:
        """Of each pair of twins one, and all that have none."""
        return frozen(np.flatnonzero((self._sides.twins < 0) | (self._sides.tails < self._sides.heads)))

    @property
    def _border(self) -> Ids:
        """The points at the ends of the border's sides, counter-clockwise."""
        outer = self._chosen[self._sides.twins[self._chosen] < 0]
        return self.sites[np.column_stack([self._sides.tails[outer], self._sides.heads[outer]])]

    @cached_property
    def _ridges(self) -> tuple[Ids, Ids]:
        if self.triangulation.dimension < 2:
            pairs = self.triangulation.edges if self.triangulation.dimension == 1 else np.empty((0, 2), np.int64)
            return pairs, frozen(np.full(pairs.shape, -1))
        tails, heads, facets, twins = (column[self._chosen] for column in self._sides)
        points = self.sites[np.sort(np.column_stack([tails, heads]), axis=1)]
        ends = np.column_stack([np.where(twins < 0, -1, self._sides.polygons[twins]), facets])
        return frozen(points), frozen(ends)

    @cached_property
    def _cells(self) -> tuple[Polygons, NDArray[np.bool_]]:
        count = len(self.sites)
        if self.triangulation.dimension < 2:
            none = Polygons(frozen(np.zeros(count + 1, np.int64)), frozen(np.empty(0, np.int64)))
            return none, frozen(np.ones(count, bool))
        cells, is_open = polygons_around(self._sides, count)
        frozen(cells.offsets), frozen(cells.connectivity)
        return cells, frozen(is_open)


def voronoi_diagram(
    points: ArrayLike,
    weights: ArrayLike | None = None,
    *,
    threads: int = 0,
    non_finite: NonFinite = "error",
    engine: Engine = "automatic",
    progress: Progress = None,
) -> VoronoiDiagram:
    """The unbounded Voronoi diagram of points in the plane; with weights, the power diagram.

    Parameters
    ----------
    points, weights, threads, non_finite, engine, progress
        as for regular_triangulation()
    """
    return regular_triangulation(
        points, weights, facets="polygons", threads=threads, non_finite=non_finite, engine=engine, progress=progress
    ).voronoi_diagram()


def _perpendicular(tails: Floats, heads: Floats) -> Floats:
    """The vectors from tails to heads, turned clockwise: half of them, where they would be infinite."""
    with np.errstate(over="ignore"):
        turned = np.column_stack([heads[:, 1] - tails[:, 1], tails[:, 0] - heads[:, 0]])
    if not np.isfinite(turned).all():
        far = ~np.isfinite(turned).all(axis=1)
        turned[far] = _perpendicular(tails[far] / 2, heads[far] / 2)
    return turned


def _between(a: list[float], b: list[float], of_a: float, of_b: float) -> list[float]:
    """The point of equal power on the line through two points with weights; each coordinate rounded once."""
    p, q = [Fraction(x) for x in a], [Fraction(x) for x in b]
    square = sum((y - x) ** 2 for x, y in zip(p, q))
    share = (square + Fraction(of_a) - Fraction(of_b)) / (2 * square)
    return [_rounded(x + share * (y - x)) for x, y in zip(p, q)]


def _rounded(number: Fraction) -> float:
    try:
        return float(number)
    except OverflowError:
        return np.inf if number > 0 else -np.inf
