# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Convex hulls of arrays."""

from __future__ import annotations

from enum import IntEnum
from functools import cached_property
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._device import memory_of
from ._arguments import numbers_of
from ._input import ids_of, points_of, whole_points_of
from ._queries import Lengths, Numbers, Sides, Truths, changed, finite, results_of, unchanged
from ._results import (
    QUIET,
    Cells,
    Engine,
    Facets,
    Floats,
    Ids,
    NonFinite,
    Polygons,
    Progress,
    Validation,
    frozen,
    ignores,
    refrozen,
    run,
    settings,
)


class Side(IntEnum):
    """On which side of a hull's surface a point is."""

    OUTSIDE = -1
    ON = 0
    INSIDE = 1


class Diameter(NamedTuple):
    """Two vertices that are farthest apart: of all such pairs the one of the lowest ids; and their distance."""

    first: int
    second: int
    length: float


class OrientedBox(NamedTuple):
    """A box in any position: center + t @ axes, with |t| up to half of lengths.

    Attributes
    ----------
    center : ndarray of ndim
    axes : ndarray of ndim by ndim
        a row for each side: orthonormal, right-handed, the longest side first
    lengths : ndarray of ndim
        of the sides, descending
    volume : float
        in the plane, the area
    lower_bound : float
        no box that holds the hull has less volume
    """

    center: Floats
    axes: Floats
    lengths: Floats
    volume: float
    lower_bound: float

    def __reduce__(self) -> tuple[Any, ...]:
        return refrozen, (type(self), *self)


class ConvexHull(Cells):
    """The exact convex hull of points in space, or of points in the plane.

    Ids are rows of the caller's array. Every vertex is a true corner and has the lowest id of its position. The form
    is the same for any number of threads and either engine, bit for bit. Names are those of scipy.spatial.ConvexHull.

    Of points in space, facets are the triangles `simplices` (counter-clockwise from outside, a fan for each facet of
    more corners) and the true facets `polygons`. Of points in the plane (rows of two), facets are edges,
    counter-clockwise. Points that span less give a lower `dimension` and, in space and in the plane alike, one polygon,
    segment or point.
    """

    _call: ClassVar[str] = "convex_hull(points)"

    @cached_property
    def vertices(self) -> Ids:
        """Ids of the vertices, ascending; of points in the plane, counter-clockwise from the lowest."""
        return self._ring() if self._is_ring else self._core.vertices()

    @cached_property
    def simplices(self) -> Ids:
        """Facets as rows of ids: of three in space, of two in the plane; of two or one, if the points span no more."""
        if self._is_ring:
            ring = self.vertices
            return frozen(np.column_stack([ring, np.roll(ring, -1)]))
        return super().simplices

    @cached_property
    def neighbors(self) -> Ids:
        """For each vertex of each of `simplices` the facet opposite to it; -1 where there is none."""
        if self._is_ring:
            edges = np.arange(len(self.vertices))
            return frozen(np.column_stack([np.roll(edges, -1), np.roll(edges, 1)]))
        return super().neighbors

    @cached_property
    def equations(self) -> Floats:
        """Of each of `simplices` the outward unit normal and the offset: normal . x + offset <= 0 in the hull; rounded.

        Of points in space that span a plane, the plane's own, and of points in the plane that span a line, the line's:
        the last component of the normal that is not 0 is positive. Empty if points span less.
        """
        if not self._planar:
            with unchanged():
                return _core.facet_planes(self.points, self._triangles, QUIET)
        begins, steps = self._sides
        normals = np.column_stack([steps[:, 1], -steps[:, 0]]) / np.hypot(steps[:, 0], steps[:, 1])[:, None]
        if self.dimension == 1 and (normals[0, 1], normals[0, 0]) < (0, 0):
            normals = -normals
        return frozen(np.column_stack([normals, -(normals * begins).sum(axis=1)]))

    @cached_property
    def polygons(self) -> Polygons:
        """The true facets, as ids. In the plane, the hull itself is the one polygon."""
        core = self._core
        if core.cell_size == 3:
            # As triangles: the hull of the vertices is the same, and has the facets.
            ids = core.vertices()
            with unchanged():
                core = _core.convex_hull(self.points[ids], _core.Settings(0, True, False, 1, None))
            if not np.array_equal(ids[core.triangles().corners()], self._triangles.corners()):
                raise changed()
            return Polygons(core.offsets(), frozen(ids[core.corners()]))
        return Polygons(core.offsets(), core.corners())

    @property
    def certificate(self) -> Ids:
        """For each point the row of `simplices` whose cone from `apex` holds it; below dimension 3, that holds it.

        With it, a program that shares nothing with the engine checks the hull in linear time: Checker/check_result.py.
        -1: the point is not finite and ignored. Of points in the plane, 0: the one polygon.
        """
        return self._certificate[0]

    @property
    def apex(self) -> Floats:
        """One position, or four, as rows: their exact mean is the apex of the certificate's cones. Inside the hull.

        Below dimension 3 there is none.
        """
        return self._certificate[1]

    @property
    def volume(self) -> float:
        """Of the solid; of points in the plane, the area."""
        return self._core.area if self._planar else self._core.volume

    @cached_property
    def area(self) -> float:
        """Of the surface; of points in the plane, the perimeter. If points span one dimension less, the facet once."""
        if self._planar:
            steps = self._sides[1]
            return float(np.hypot(steps[:, 0], steps[:, 1]).sum())
        return self._core.area

    @cached_property
    def min_bound(self) -> Floats:
        """The least of each coordinate."""
        return frozen(self._corners().min(axis=0))

    @cached_property
    def max_bound(self) -> Floats:
        """The greatest of each coordinate."""
        return frozen(self._corners().max(axis=0))

    def contains(
        self, points: ArrayLike, *, threads: int = 0, non_finite: NonFinite = "error", progress: Progress = None
    ) -> Truths:
        """Whether each point is inside or on the surface; exactly: `points[hull.contains(points)]`.

        A point that is not finite and ignored is outside. side() distinguishes inside and surface.

        Parameters
        ----------
        points : array of shape (..., ndim)
            of any type that convex_hull() takes. A tuple of ndim arrays is an error: it could be points or coordinates.

        Returns
        -------
        array of shape (...); of one point, of shape (ndim,), its answer
        """
        sides = results_of(self._queries.contains, points, (self.ndim,), threads, non_finite, progress)
        return sides >= 0  # type: ignore

    def side(
        self, points: ArrayLike, *, threads: int = 0, non_finite: NonFinite = "error", progress: Progress = None
    ) -> Sides:
        """On which side of the surface each point is, exactly: a Side as int8, -1 outside, 0 on, 1 inside.

        Below the dimension of the space, a hull has no inside. A point that is not finite and ignored is outside.
        Parameters and the result's form are those of contains().
        """
        found: Sides = results_of(self._queries.contains, points, (self.ndim,), threads, non_finite, progress)
        return found

    def distance(
        self, points: ArrayLike, *, threads: int = 0, non_finite: NonFinite = "error", progress: Progress = None
    ) -> Lengths:
        """The distance of each point from the surface: negative inside, 0 on it, positive outside.

        The sign is exact. The distance is rounded, to 1e-14 of that to the farthest vertex. Infinity: the hull is
        empty, or no double is so large. NaN: the point is not finite and ignored. Parameters and the result's form are
        those of contains().
        """
        found: Lengths = results_of(self._queries.distance, points, (self.ndim,), threads, non_finite, progress)
        return found

    def support(
        self, directions: ArrayLike, *, threads: int = 0, non_finite: NonFinite = "error", progress: Progress = None
    ) -> Numbers:
        """The id of the vertex that is farthest along each direction, exactly; of several, the lowest.

        Directions are vectors of any length. -1: the hull is empty, or the direction is not finite and ignored. The
        result's form is that of contains().
        """
        found: Numbers = results_of(
            self._queries.support, directions, (self.ndim,), threads, non_finite, progress, what="directions"
        )
        return found

    def diameter(self) -> Diameter:
        """The two vertices that are farthest apart, found by exact comparison."""
        return Diameter(*self._queries.diameter(QUIET))

    def minimal_box(self) -> OrientedBox:
        """A small box around the hull, in any position, and a proven bound of how small a box can be.

        In the plane, it is the least rectangle, up to rounding. In space, it is the least box of a large family: see
        minimalBox() in the engine's HullQueries.h.
        """
        numbers, volume, lower_bound = self._queries.minimal_box(QUIET)
        center, axes, lengths = numbers[:3], numbers[3:12].reshape(3, 3), numbers[12:]
        if not self._planar:
            return OrientedBox(center, axes, lengths, volume, lower_bound)
        return OrientedBox(center[:2], axes[:2, :2], lengths[:2], volume, lower_bound)

    def validate(self, *, threads: int = 0) -> Validation:
        """Decides exactly whether this is the convex hull of the points."""
        fault, text, index = _core.validate_hull(self.points, self._core, threads)
        return Validation(fault == 0, text, index)

    def __repr__(self) -> str:
        return f"<ConvexHull of {self.npoints} points: dimension {self.dimension}, {len(self.vertices)} vertices>"

    @property
    def _planar(self) -> bool:
        return self.points.shape[1] == 2

    @property
    def _is_ring(self) -> bool:
        return self._planar and self.dimension == 2

    @property
    def _sides(self) -> tuple[Floats, Floats]:
        """Where each of `simplices` in the plane begins, and from there to its end."""
        sides = self.simplices if self.dimension > 0 else np.empty((0, 2), np.int64)
        ends = finite(self.points, sides)[sides].astype(np.float64)
        return ends[:, 0], ends[:, 1] - ends[:, 0]

    @cached_property
    def _queries(self) -> Any:
        with unchanged():
            return hull_queries(self.points, self._core, QUIET)

    @cached_property
    def _certificate(self) -> tuple[Ids, Floats]:
        chosen = _core.Settings(0, False, self._ignores, 1, None)
        with unchanged():
            cells, apex = _core.hull_certificate(self.points, self._triangles, chosen)
        return (frozen(np.minimum(cells, 0)) if self._planar else cells), apex

    def _ring(self) -> Ids:
        """The corners of the one cell, in order."""
        if self._core.cell_size == 3 and self._core.cell_count > 1:
            return self.polygons.connectivity
        return self._core.corners()

    def _corners(self) -> NDArray[Any]:
        if self.dimension < 0:
            return np.full((1, self.ndim), np.nan)
        ids = self._core.vertices()
        return finite(self.points, ids)[ids].astype(np.float64)


def hull_queries(points: NDArray[Any], core: Any, chosen: Any) -> Any:
    """A hull of the engine's, ready for contains(), distance() and others."""
    return _core.hull_queries(points, core.triangles(), chosen)


def convex_hull(
    points: ArrayLike,
    *,
    facets: Facets = "triangles",
    threads: int = 0,
    non_finite: NonFinite = "error",
    engine: Engine = "automatic",
    progress: Progress = None,
) -> ConvexHull:
    """The exact convex hull of points.

    Parameters
    ----------
    points : n by 3, or n by 2
        any finite numbers in any position, up to 2^32 - 2 points
    facets : {"triangles", "polygons"}
        which form of the facets is made at once; the other is made when it is first used
    threads, non_finite, engine, progress
        see the module

    Raises
    ------
    InputError
        names the first point at fault and how many there are
    """
    array, left_out = points_of(points, ignores(non_finite))
    chosen = settings(threads, facets, non_finite, engine, progress, left_out)
    chosen[0].points_memory = memory_of(array)
    return ConvexHull._made(array, run(chosen, _core.convex_hull, array), left_out)


def convexify(
    points: ArrayLike,
    triangles: ArrayLike,
    kernel: ArrayLike | None = None,
    *,
    facets: Facets = "triangles",
    threads: int = 0,
    progress: Progress = None,
) -> ConvexHull:
    """The convex hull of a closed star-shaped surface, reached by flips alone.

    Parameters
    ----------
    points : n by 3
        points that no triangle uses are no part of it
    triangles : m by 3
        ids of a closed, consistently oriented manifold, outward or inward
    kernel : 3 numbers, optional
        a point that strictly sees the inside of every triangle; by default it is sought
    facets, threads, progress
        as for convex_hull()

    Raises
    ------
    InputError
        the surface is open, not a manifold, not oriented or not star-shaped; names the first triangle
    """
    array = whole_points_of(points)
    if array.shape[1] != 3:
        raise ValueError(f"the points of a surface are n by 3 coordinates, not an array of shape {array.shape}")
    corners = ids_of(triangles, "triangles")
    if corners.shape == (0,):
        corners = corners.reshape(0, 3)
    if corners.ndim != 2 or corners.shape[1] != 3:
        raise ValueError(f"triangles are m by 3 ids, not an array of shape {corners.shape}")
    kernel_point = None if kernel is None else numbers_of("kernel", kernel, 3)
    chosen, bar = settings(threads, facets, "error", "cpu", progress, False)
    core = run((chosen, bar), _core.convexify, array, corners, kernel_point)
    return ConvexHull._made(array, core, False)
