# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Intersections of half-spaces of arrays, of space and of the plane."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from functools import cached_property
from typing import Any, ClassVar, Literal

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arguments import numbers_of
from ._errors import InputError
from ._input import doubles_of
from ._results import Floats, Frozen, Ids, Polygons, Progress, frozen, named, run, settings
from ._rings import polygons_around, sides_of

Kind = Literal["bounded", "unbounded", "flat", "empty"]
_KINDS: tuple[Kind, ...] = ("bounded", "unbounded", "flat", "empty")


class HalfSpaceIntersection(Frozen):
    """The intersection of half-spaces: a convex solid, or of the plane a polygon.

    Attributes
    ----------
    half_spaces : ndarray of n by 4, or n by 3
        those given, then those of bounds
    kind : {"bounded", "unbounded", "flat", "empty"}
        exactly. "flat": no position is strictly inside all, but some are on borders. Those that are not bounded have
        no vertices.
    interior_point : ndarray
        as given, or one that was found: strictly inside; NaN where there is none
    vertices : ndarray of m by 3, or m by 2
        each coordinate rounded once; of a polygon counter-clockwise
    facets : ndarray
        the half-spaces that have a facet (of a polygon a side), as rows of half_spaces, ascending; others are
        redundant, as all but the first of several that are the same
    facets_at_vertices : Polygons
        for each vertex the half-spaces whose facets meet there, exactly; counter-clockwise from outside
    dual_points : ndarray of n by 3, or n by 2
        normal / -(normal @ interior_point + offset), rounded once; the hull's vertices are `facets`. Without an
        interior there are none.
    statistics : dict
        counts and seconds
    """

    half_spaces: Floats
    kind: Kind
    interior_point: Floats
    vertices: Floats
    facets: Ids
    facets_at_vertices: Polygons
    dual_points: Floats
    statistics: dict[str, float]
    _call: ClassVar[str] = "half_space_intersection(half_spaces)"

    @property
    def ndim(self) -> int:
        """How many coordinates positions have."""
        return int(self.half_spaces.shape[1]) - 1

    @cached_property
    def facet_vertices(self) -> Polygons:
        """For each of `facets` its corners, as rows of vertices: counter-clockwise from outside; of a side two."""
        if not len(self.facets):
            return Polygons(frozen(np.zeros(1, np.int64)), frozen(np.empty(0, np.int64)))
        corners, offsets = self.facets_at_vertices.connectivity, self.facets_at_vertices.offsets
        row = np.searchsorted(self.facets, corners)
        if self.ndim == 2:
            vertex = np.repeat(np.arange(len(self.vertices)), 2)
            # Vertex i is where the side of its second half-plane begins.
            ends = np.empty((len(self.facets), 2), np.int64)
            ends[row[1::2], 0], ends[row[0::2], 1] = vertex[1::2], vertex[0::2]
            return Polygons(frozen(2 * np.arange(len(ends) + 1)), frozen(ends.reshape(-1)))
        found, _ = polygons_around(sides_of(Polygons(offsets, row)), len(self.facets))
        return Polygons(frozen(found.offsets), frozen(found.connectivity))

    @property
    def volume(self) -> float:
        """Of the solid, of a polygon its area; rounded. Infinity if it is unbounded."""
        return self._sizes[0]

    @property
    def area(self) -> float:
        """Of the surface, of a polygon its perimeter; rounded. Infinity if it is unbounded."""
        return self._sizes[1]

    @cached_property
    def _sizes(self) -> tuple[float, float]:
        if not len(self.vertices):
            return (np.inf, np.inf) if self.kind == "unbounded" else (0.0, 0.0)
        return sizes_of(self.vertices - self.interior_point, self.facet_vertices)

    def __repr__(self) -> str:
        return (
            f"<HalfSpaceIntersection of {len(self.half_spaces)} half-spaces: {self.kind}, {len(self.facets)} facets, "
            f"{len(self.vertices)} vertices>"
        )


def sizes_of(positions: Floats, facets: Polygons) -> tuple[float, float]:
    """Volume and surface of a solid around the origin, or area and perimeter of a polygon; rounded."""
    exponent = int(np.frexp(np.abs(positions).max())[1])
    unit = np.ldexp(1.0, min(exponent, 1023))  # so that no product overflows or vanishes
    volume, area = _sizes_of(positions / unit, facets)
    ndim = positions.shape[1]
    with np.errstate(over="ignore"):
        return float(volume * unit**ndim), float(area * unit ** (ndim - 1))


def _sizes_of(positions: Floats, facets: Polygons) -> tuple[float, float]:
    sizes = np.diff(facets.offsets)
    first = np.repeat(facets.connectivity[facets.offsets[:-1]], sizes)
    here, following = facets.connectivity, np.roll(facets.connectivity, -1)
    if positions.shape[1] == 2:
        a, b = positions[here[::2]], positions[here[1::2]]
        area = (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum() / 2
        return float(area), float(np.linalg.norm(b - a, axis=1).sum())
    following[facets.offsets[1:] - 1] = facets.connectivity[facets.offsets[:-1]]
    a, b, c = positions[first], positions[here], positions[following]
    normals = np.cross(b - a, c - a)
    return float((a * normals).sum() / 6), float(np.linalg.norm(normals, axis=1).sum() / 2)


def half_space_intersection(
    half_spaces: ArrayLike,
    interior_point: ArrayLike | None = None,
    *,
    bounds: ArrayLike | None = None,
    threads: int = 0,
    progress: Progress = None,
) -> HalfSpaceIntersection:
    """The exact intersection of half-spaces: where normal @ x + offset <= 0 for each row (normal, offset).

    Parameters
    ----------
    half_spaces : n by 4, or of the plane n by 3
        finite numbers. Normals may have any length; one of zeros stands for all positions, or for none if its offset
        is positive.
    interior_point : 3 numbers, or 2
        a position strictly inside all; by default one is found
    bounds : 6 numbers, or 4
        a box in VTK's order (x0, x1, y0, y1, z0, z1), whose sides join as half-spaces: of one that is unbounded
    threads, progress
        see the module

    Raises
    ------
    InputError
        names the half-space that is not finite, or that does not have the interior point strictly inside
    """
    rows = doubles_of(half_spaces, "the numbers of half_spaces")
    if rows.ndim != 2 or rows.shape[1] not in (3, 4):
        raise ValueError(f"half_spaces are n by 4 numbers, of the plane n by 3, not an array of shape {rows.shape}")
    ndim = rows.shape[1] - 1
    if bounds is not None:
        rows = np.concatenate([rows, _walls_of(numbers_of("bounds", bounds, 2 * ndim))])
    rows = frozen(np.array(rows))
    given = None if interior_point is None else np.array(numbers_of("interior_point", interior_point, ndim))
    chosen = settings(threads, "polygons", "error", "cpu", progress, False)
    with _half_spaces_named(rows):
        found = run(chosen, _core.half_space_intersection, rows, given)
    kind, interior, facets, offsets, corners, vertices, dual_points, statistics = found
    return HalfSpaceIntersection._of(
        half_spaces=rows,
        kind=_KINDS[kind],
        interior_point=interior,
        vertices=vertices,
        facets=facets,
        facets_at_vertices=Polygons(offsets, corners),
        dual_points=dual_points,
        statistics=named(statistics),
    )


@contextmanager
def _half_spaces_named(rows: Any) -> Iterator[None]:
    """An error about a half-space, from in here, has its numbers."""
    try:
        yield
    except InputError as error:
        if error.index < 0:
            raise
        row, code = rows[error.index].tolist(), error.code
        what = {
            "non_finite": "half-space {} is not finite: {}",
            "bad_argument": "the interior point is not strictly inside half-space {}: {}",
        }[code]
        raise InputError(what.format(error.index, row), code, error.index, error.count) from None


def _walls_of(box: tuple[float, ...]) -> Floats:
    """The sides of a box as half-spaces."""
    walls = np.zeros((len(box), len(box) // 2 + 1))
    for i, (low, high) in enumerate(zip(box[::2], box[1::2])):
        if not low < high:
            raise ValueError(f"bounds are (x0, x1, y0, y1, ...) with x0 < x1 and so on, not {box}")
        walls[2 * i, [i, -1]] = -1, low
        walls[2 * i + 1, [i, -1]] = 1, -high
    return walls
