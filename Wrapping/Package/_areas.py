# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The greatest areas of a refined mesh's triangles: everywhere, in regions, and by position."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arguments import float_of
from ._constrained import ConstrainedTriangulation
from ._errors import InputError
from ._geometries import Degenerate, Lines, lines_of
from ._image import Image
from ._input import doubles_of, is_array_like, values_of
from ._lines import constrained_triangulation
from ._results import Floats, Ids

AreaFunction = Callable[[NDArray[np.float64]], ArrayLike]


class AreaLimits(NamedTuple):
    """What the engine compares areas with.

    Attributes
    ----------
    everywhere : float
        0: any
    of_points : ndarray or None
        for each point
    of_pixels : tuple or None
        rows of pixels; origin and spacing, by x and y
    at : callable or None
        of positions
    """

    everywhere: float
    of_points: Floats | None
    of_pixels: tuple[Floats, tuple[float, float, float, float]] | None
    at: Callable[[Floats], Floats] | None


class PolygonRegion(NamedTuple):
    """A region that is what a polygon has inside.

    Attributes
    ----------
    number : int
        its row in regions
    area : float
        the greatest of a triangle; 0: as everywhere
    lines : Lines
        its sides
    triangulation : ConstrainedTriangulation
        of its inside
    """

    number: int
    area: float
    lines: Lines
    triangulation: ConstrainedTriangulation

    def holds(self, positions: Floats) -> NDArray[np.bool_]:
        box = self.lines.points[:, :2]
        found: NDArray[np.bool_] = ((positions >= box.min(axis=0)) & (positions <= box.max(axis=0))).all(axis=1)
        found[found] = self.triangulation.locate(positions[found]) >= 0
        return found


class Regions(NamedTuple):
    """Regions and holes.

    Attributes
    ----------
    rows : ndarray of n by 4
        x and y of a point, an area, and whether it is a hole
    numbers : ndarray
        for each of these the row in regions, -1 of a hole
    polygons : list of PolygonRegion
    degenerate : int
        how many rings and geometries of too few points were left out
    """

    rows: Floats
    numbers: Ids
    polygons: list[PolygonRegion]
    degenerate: int

    def of_error(self, error: InputError) -> InputError:
        """The engine's error, which has the number of a row, by the caller's names; of other errors, itself."""
        sentence, _, row = str(error).partition(": at index ")
        if "region" not in sentence or not row:
            return error
        number = int(self.numbers[int(row)])
        hole = int(row) - int(np.count_nonzero(self.numbers >= 0))
        return InputError(f"{sentence}: " + (f"regions[{number}]" if number >= 0 else f"holes[{hole}]"), error.code)


def regions_of(regions: Any, holes: ArrayLike | None, degenerate: Degenerate = "error") -> Regions:
    points: list[Any] = []
    numbers: list[int] = []
    polygons, excluded = [], 0
    given = regions if is_array_like(regions) and _has_polygon(regions) else None
    if given is None:
        points = [*_rows_of("regions", regions, (2, 3))]
        numbers = [*range(len(points))]
    else:
        for number, item in enumerate(given):
            if _is_geometry(item) or _is_geometry(item[0]):
                polygon = _polygon_of(number, item, degenerate)
                excluded += polygon.lines.degenerate
                if polygon.lines.sides:
                    polygons.append(polygon)
            else:
                points.append(_rows_of("regions", [item], (2, 3))[0])
                numbers.append(number)
    outside = _rows_of("holes", holes, (2,))
    rows = np.zeros((len(points) + len(outside), 4))
    for row, point in zip(rows, points):
        row[: len(point)] = point
    rows[len(points) :, :2] = outside
    rows[len(points) :, 3] = 1
    return Regions(rows, np.array([*numbers, *[-1] * len(outside)], np.int64), polygons, excluded)


def limits_of(area: Any, polygons: list[PolygonRegion], count: int | None) -> AreaLimits:
    """count: of points; None: there are others, of lines"""
    everywhere, of_points, of_pixels, at = 0.0, None, None, None
    if callable(area):
        at = _checked(area)
    elif isinstance(area, Image):
        of_pixels = _pixels_of(area)
    elif area is not None and np.ndim(area) == 0:
        everywhere = _area_of("maximum_area", area)
    elif area is not None:
        if count is None:
            raise ValueError("with lines, maximum_area is no array: lines add points; a function of positions serves")
        of_points = np.ascontiguousarray(values_of(area, count))
        if of_points.ndim != 1:
            raise ValueError(f"maximum_area has one number a point, not an array of shape {of_points.shape}")
    limited = [polygon for polygon in polygons if polygon.area > 0]
    return AreaLimits(everywhere, of_points, of_pixels, _with_polygons(at, limited) if limited else at)


def with_sides(lines: Lines, polygons: list[PolygonRegion]) -> Lines:
    """Lines, and the sides of polygons as lines."""
    for polygon in polygons:
        other, split = polygon.lines, len(lines.ends) - lines.sides
        if lines.points.shape[1] != 2:
            raise ValueError("regions that are polygons go with lines of two coordinates")

        def joined(a: NDArray[Any], b: NDArray[Any], at: int = split) -> NDArray[Any]:
            return np.concatenate([a[:at], b, a[at:]])

        lines = lines._replace(
            points=np.concatenate([lines.points, other.points[:, :2]]),
            ends=joined(lines.ends, other.ends + len(lines.points)),
            geometry_of=joined(lines.geometry_of, other.geometry_of),
            names=lines.names + other.names,
            chain_of=joined(lines.chain_of, other.chain_of + len(lines.names)),
        )
    return lines


def _is_geometry(value: Any) -> bool:
    return isinstance(value, Mapping) or hasattr(value, "__geo_interface__")


def _has_polygon(regions: Any) -> bool:
    return not isinstance(regions, np.ndarray) and any(
        _is_geometry(item) or (isinstance(item, (list, tuple)) and len(item) > 0 and _is_geometry(item[0]))
        for item in regions
    )


def _polygon_of(number: int, item: Any, degenerate: Degenerate) -> PolygonRegion:
    name = f"regions[{number}]"
    polygon, area = (item, 0.0) if _is_geometry(item) else (item[0], item[1] if len(item) == 2 else None)
    if area is None:
        raise ValueError(f"{name} is a polygon and its greatest area")
    lines = lines_of(polygon, False, degenerate, name)
    if lines.sides == 0 and lines.degenerate == 0 or lines.sides < len(lines.ends):
        raise TypeError(f"{name} is no polygon")
    most = 0.0 if item is polygon else _area_of(f"the area of {name}", area)
    return PolygonRegion(number, most, lines, constrained_triangulation([], polygon, degenerate=degenerate))


def _rows_of(what: str, values: Any, columns: tuple[int, ...]) -> Floats:
    array = doubles_of([] if values is None else values, what)
    if array.size == 0:
        return np.empty((0, columns[0]))
    if array.ndim != 2 or array.shape[1] not in columns:
        wanted = " or ".join(map(str, columns))
        raise ValueError(f"{what} are rows of {wanted} numbers, not an array of shape {array.shape}")
    return array


def _area_of(name: str, area: Any) -> float:
    number = float_of(name, area)
    if not number > 0:
        raise ValueError(f"{name} is above 0, not {area!r}")
    return number


def _pixels_of(image: Image) -> tuple[Floats, tuple[float, float, float, float]]:
    pixels = np.ascontiguousarray(doubles_of(image.array, "maximum_area"))
    if pixels.ndim != 2:
        raise ValueError(f"an image of areas has rows and columns, not an array of shape {pixels.shape}")
    a, _, c, _, e, f = image.transform
    return pixels, (c + a / 2, f + e / 2, a, e)


def _checked(function: AreaFunction) -> Callable[[Floats], Floats]:
    """What it gives, as the engine reads it."""

    def at(positions: Floats) -> Floats:
        areas = doubles_of(function(positions), "what maximum_area gives")
        if areas.shape != (len(positions),):
            raise ValueError(f"maximum_area gives {len(positions)} numbers, not an array of shape {areas.shape}")
        wrong = np.flatnonzero(~(areas > 0))
        if len(wrong):
            where = tuple(positions[wrong[0]].tolist())
            sentence = f"maximum_area gives {areas[wrong[0]]} at {where}: areas are above 0, or infinite (any)"
            raise InputError(sentence, "bad_argument")
        return np.ascontiguousarray(areas)

    return at


def _with_polygons(
    function: Callable[[Floats], Floats] | None, polygons: list[PolygonRegion]
) -> Callable[[Floats], Floats]:
    def at(positions: Floats) -> Floats:
        areas = np.full(len(positions), np.inf) if function is None else function(positions).copy()
        for polygon in polygons:
            held = polygon.holds(positions)
            areas[held] = np.minimum(areas[held], polygon.area)
        return areas

    return at
