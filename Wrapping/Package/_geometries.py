# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Geometries as chains of points, and back, by the protocol __geo_interface__, which needs no other package."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arguments import choice_of
from ._errors import InputError
from ._input import is_array_like, points_of
from ._results import QUIET, Floats, Ids

Degenerate = Literal["error", "ignore"]

# Of each kind of geometry what has its parts, how these are named, and their kind; None: any.
_PARTS: dict[str, tuple[str, str, str | None]] = {
    "List": ("geometries", "[{}]", None),
    "FeatureCollection": ("features", ".features[{}]", None),
    "GeometryCollection": ("geometries", ".geometries[{}]", None),
    "MultiLineString": ("coordinates", ", part {}", "LineString"),
    "MultiPolygon": ("coordinates", ", part {}", "Polygon"),
    "Polygon": ("coordinates", ", ring {}", "Ring"),
}
_LINES = ("LineString", "LinearRing", "Ring", "Hole")
_KINDS = {*_PARTS, "LineString", "LinearRing", "Feature"} - {"List"}
_DEEPEST = 100


class Lines(NamedTuple):
    """Polylines and rings of polygons, these last.

    Attributes
    ----------
    points : ndarray of n by 2, or n by 3
        the points of all
    ends : ndarray of m by 2
        the points that each segment joins
    sides : int
        the last so many segments are sides of polygons
    features : ndarray, optional
        for each of these what it is of, if the union of several is inside
    geometry_of : ndarray
        for each segment the geometry that it is of
    names : list of str
        of each chain
    chain_of : ndarray
        for each segment its chain
    degenerate : int
        how many rings, lines and geometries were left out
    """

    points: Floats
    ends: Ids
    sides: int
    features: Ids | None
    geometry_of: Ids
    names: list[str]
    chain_of: Ids
    degenerate: int

    def features_of(self, sides: Ids) -> Ids | None:
        """Of so many segments, which are sides of polygons."""
        return None if self.features is None else self.features[sides - (len(self.ends) - self.sides)]


class Chain(NamedTuple):
    """A line, or a ring of a polygon without its first point again.

    Attributes
    ----------
    name : str
        as errors have it
    geometry : int
        the number of what it is of
    ids : ndarray
        of its points
    is_ring : bool
    """

    name: str
    geometry: int
    ids: Ids
    is_ring: bool


class Degenerates:
    """Whether what has too few points is left out, and how many such there were. None: there is no such choice."""

    def __init__(self, degenerate: Degenerate | None) -> None:
        self._ignores = choice_of("degenerate", degenerate or "error", ("error", "ignore")) == "ignore"
        self.advice = "" if degenerate is None else "; degenerate='ignore' leaves it out"
        self.count = 0

    def add(self, error: Exception, count: int = 1) -> None:
        """Counts it, or raises the error."""
        if not self._ignores:
            raise error
        self.count += count

    def excluded(self, name: str, number: int, points: NDArray[Any], is_ring: bool) -> bool:
        """Whether a line or a ring is left out. Of points at one position in a row, one counts."""
        if not len(points):
            self.empty(name, number)
            return True
        moves = (points[:, :2] != np.roll(points[:, :2], 1, axis=0)).any(axis=1)
        count = max(int(moves.sum()), 1) if is_ring else 1 + int(moves[1:].sum())
        if count >= (3 if is_ring else 2):
            return False
        what = "a ring takes 3 or more, besides the first again" if is_ring else "a line takes 2 or more"
        repeated = " without repeated ones" if count < len(points) else ""
        sentence = f"{name} has {count} point(s){repeated}: {what}{self.advice}"
        self.add(InputError(sentence, "bad_argument", number))
        return True

    def empty(self, name: str, number: int) -> None:
        sentence = f"{name} is empty: it has no point{self.advice}"
        self.add(InputError(sentence, "bad_argument", number))


def lines_of(values: Any, closed_are_rings: bool, degenerate: Degenerate = "error", what: str = "lines") -> Lines:
    """The lines and polygons of geometries.

    closed_are_rings: whether lines that end where they begin, alone or end to end, are rings of polygons. what: the
    name of values
    """
    degenerates = Degenerates(degenerate)
    chains: list[Chain] = []
    tables: list[Floats] = []
    is_outer_excluded = False
    for name, number, kind, coordinates in _parts_of(what, values, degenerates):
        is_ring = kind in ("Ring", "Hole")
        points = _points_of_chain(name, number, coordinates, is_ring)
        if kind == "Hole" and is_outer_excluded:
            degenerates.count += 1  # with the polygon
            continue
        is_excluded = degenerates.excluded(name, number, points, is_ring)
        if kind == "Ring":
            is_outer_excluded = is_excluded
        if is_excluded:
            continue
        if tables and points.shape[1] != tables[0].shape[1]:
            counts = " and ".join(
                f"{one} has {table.shape[1]}" for one, table in ((chains[0].name, tables[0]), (name, points))
            )
            sentence = f"lines have 2 coordinates or 3, all the same, but {counts}"
            raise InputError(sentence, "bad_argument", number)
        begin = chains[-1].ids[-1] + 1 if chains else 0
        chains.append(Chain(name, number, np.arange(begin, begin + len(points)), is_ring))
        tables.append(points)
    points = np.concatenate(tables) if tables else np.empty((0, 2))
    return lines_from(points, chains, closed_are_rings, True, degenerates)


def lines_from(
    points: Floats, chains: list[Chain], closed_are_rings: bool, are_features: bool, degenerates: Degenerates
) -> Lines:
    """The lines and polygons of chains.

    are_features: whether what is inside is the union of geometries, and of all closed lines as one more
    """
    chains = sorted(chains, key=lambda chain: chain.is_ring)
    sizes = np.array([len(chain.ids) for chain in chains], np.int64)
    are_rings = np.array([chain.is_ring for chain in chains], bool)
    signs = are_rings.astype(np.int64)
    ids = np.concatenate([np.empty(0, np.int64), *(chain.ids for chain in chains)])
    offsets = np.concatenate([[0], np.cumsum(sizes)])
    if closed_are_rings:
        positions = np.ascontiguousarray(points[ids, :2], np.float64)
        signs[~are_rings] = _core.closed_lines(positions, offsets, int(are_rings.sum()), 2, QUIET)
    first = int((~are_rings).sum())
    lines, line_of = _core.constraints_along(offsets[: first + 1], ids, False)
    sides_of_rings, ring_of = _core.constraints_along(offsets[first:], ids, True)
    ends, chain_of = np.concatenate([lines, sides_of_rings]), np.concatenate([line_of, first + ring_of])
    ends[signs[chain_of] < 0] = ends[signs[chain_of] < 0, ::-1]
    geometries = np.array([chain.geometry for chain in chains], np.int64)
    of = geometries[chain_of] if are_features else chain_of
    order = np.lexsort((np.arange(len(ends)), of, signs[chain_of] != 0))
    ends, chain_of = ends[order], chain_of[order]
    sides = int((signs[chain_of] != 0).sum())
    features = np.where(are_rings, geometries, -1)[chain_of[len(ends) - sides :]]
    is_union = are_features and len(np.unique(features)) > 1
    return Lines(
        points,
        ends,
        sides,
        features if is_union else None,
        geometries[chain_of],
        [chain.name for chain in chains],
        chain_of,
        degenerates.count,
    )


def _parts_of(what: str, values: Any, degenerates: Degenerates) -> Iterator[tuple[str, int, str, Any]]:
    """The name, the geometry's number, the kind and the coordinates of each line and ring."""
    waiting: list[tuple[str, int, int, str | None, Any]] = [(what, 0, -1, None, values)]
    while waiting:
        name, depth, number, kind, value = waiting.pop()
        if depth > _DEEPEST:
            raise TypeError(f"lines are nested more than {_DEEPEST} levels deep")
        if kind is None:
            if value is None:
                degenerates.add(TypeError(f"{name} has no geometry: it is None{degenerates.advice}"))
                continue
            kind, value = _kind_of(name, value)
        if kind == "Feature":
            waiting.append((name, depth + 1, number, None, value.get("geometry")))
        elif kind in _LINES:
            yield name, max(number, 0), kind, value.get("coordinates") if isinstance(value, Mapping) else value
        else:
            key, form, of = _PARTS[kind]
            parts: Any = value.get(key) if isinstance(value, Mapping) else value
            if not is_array_like(parts):
                raise TypeError(f"{name} is a {kind} without a list of {key}")
            if not len(parts):
                degenerates.empty(name, max(number, 0))
            counts = number < 0 and of is None
            for i in reversed(range(len(parts))):
                part = "Hole" if of == "Ring" and i > 0 else of
                waiting.append((name + form.format(i), depth + 1, i if counts else number, part, parts[i]))


def _kind_of(name: str, value: Any) -> tuple[str, Any]:
    """What a value is: a mapping of the protocol, coordinates of one line, or a list of geometries."""
    if not isinstance(value, Mapping):
        value = getattr(value, "__geo_interface__", value)
    if isinstance(value, Mapping):
        kind = value.get("type")
        if kind in ("Point", "MultiPoint"):
            raise TypeError(f"{name} is a {kind}, and no line: pass it among the points")
        if kind in _KINDS:
            return str(kind), value
        raise TypeError(f"{name} is no geometry: its type is {kind!r}")
    if isinstance(value, np.ndarray) and value.dtype != object and value.ndim == 2:
        return "LineString", value
    if isinstance(value, (list, tuple)) or (isinstance(value, np.ndarray) and value.ndim == 1):
        return "List", value
    raise TypeError(
        f"{name} is no geometry: a geometry has __geo_interface__, or is such a mapping, or an array of n by 2 or n by "
        f"3 coordinates, not of type {type(value).__name__}"
    )


def _points_of_chain(name: str, number: int, coordinates: Any, is_ring: bool) -> Floats:
    """Of a ring without the first again."""
    if not is_array_like(coordinates):
        raise TypeError(f"{name} has no list of coordinates, but a {type(coordinates).__name__}")
    if not len(coordinates):
        return np.empty((0, 2))
    try:
        points, _ = points_of(coordinates if isinstance(coordinates, np.ndarray) else list(coordinates), True)
    except TypeError as error:
        raise TypeError(f"{name}: {error}") from None
    except ValueError as error:
        raise InputError(f"{name}: {error}", "bad_argument", number) from None
    points = np.asarray(points, np.float64)
    wrong = ~np.isfinite(points).all(axis=1)
    if wrong.any():
        vertex = int(wrong.argmax())
        where, count = tuple(points[vertex].tolist()), int(wrong.sum())
        sentence = f"{name}, vertex {vertex}: {where} has a coordinate that is NaN or infinite, {count} such in all"
        raise InputError(sentence, "non_finite", number, count)
    return points[:-1] if is_ring and len(points) > 1 and (points[0] == points[-1]).all() else points


def multi_polygon(points: NDArray[Any], simplices: Ids, neighbors: Ids, rings: Sequence[Ids]) -> dict[str, Any]:
    """The border of triangles as a mapping of the protocol: a polygon, with its holes, for each connected part.

    rings: simple ones, with the triangles on their left
    """
    part_of = _parts(neighbors)
    tails = simplices.reshape(-1)
    heads = np.roll(simplices, -1, axis=1).reshape(-1)
    keys = tails * len(points) + heads
    order = np.argsort(keys)
    polygons: dict[int, list[Any]] = {}
    for ring in rings:
        edge = order[np.searchsorted(keys, ring[0] * len(points) + ring[1], sorter=order)]
        polygon = polygons.setdefault(int(part_of[edge // 3]), [])
        corners = [*map(tuple, points[ring].tolist())]
        polygon.insert(0 if _is_outer(points[ring, :2]) else len(polygon), (*corners, corners[0]))
    return {"type": "MultiPolygon", "coordinates": [tuple(polygon) for polygon in polygons.values()]}


def multi_line(points: NDArray[Any], edges: Ids) -> dict[str, Any]:
    """Edges as a mapping of the protocol, a line for each."""
    return {"type": "MultiLineString", "coordinates": [tuple(map(tuple, edge)) for edge in points[edges].tolist()]}


def _is_outer(ring: NDArray[Any]) -> bool:
    """Whether a simple ring is counter-clockwise: it turns left where it is lowest."""
    at = int(np.lexsort(ring.T[::-1])[0])
    (ax, ay), (bx, by), (cx, cy) = (map(Fraction, ring[(at + i) % len(ring)].tolist()) for i in (-1, 0, 1))
    return (bx - ax) * (cy - by) > (by - ay) * (cx - bx)


def _parts(neighbors: Ids) -> Ids:
    """For each triangle the lowest one that is connected with it, by edges."""
    rows, columns = np.nonzero(neighbors >= 0)
    across = neighbors[rows, columns]
    part = np.arange(len(neighbors))
    while True:
        own, other = part[rows], part[across]
        differ = own > other
        if not differ.any():
            return part
        np.minimum.at(part, own[differ], other[differ])
        while (part[part] != part).any():
            part = part[part]
