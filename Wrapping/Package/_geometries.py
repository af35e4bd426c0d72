# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Geometries as chains of points, and back, by the protocol __geo_interface__, which needs no other package."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._errors import InputError
from ._input import is_array_like, points_of
from ._results import Floats, Ids

# Of each kind of geometry what has its parts, how these are named, and their kind; None: any.
_PARTS: dict[str, tuple[str, str, str | None]] = {
    "List": ("geometries", "[{}]", None),
    "FeatureCollection": ("features", ".features[{}]", None),
    "GeometryCollection": ("geometries", ".geometries[{}]", None),
    "MultiLineString": ("coordinates", ", part {}", "LineString"),
    "MultiPolygon": ("coordinates", ", part {}", "Polygon"),
    "Polygon": ("coordinates", ", ring {}", "Ring"),
}
_LINES = ("LineString", "LinearRing", "Ring")
_KINDS = {*_PARTS, "LineString", "LinearRing", "Feature"} - {"List"}
_DEEPEST = 100


class Lines(NamedTuple):
    """Polylines and rings of polygons, these last.

    Attributes
    ----------
    points : ndarray of n by 2, or n by 3
        the points of all, one after another
    ends : ndarray of m by 2
        the points that each segment joins
    sides : int
        the last so many segments are sides of polygons
    geometry_of : ndarray
        for each segment the geometry that it is of
    names : list of str
        of each chain
    chain_of : ndarray
        for each segment its chain
    """

    points: Floats
    ends: Ids
    sides: int
    geometry_of: Ids
    names: list[str]
    chain_of: Ids


class _Chain(NamedTuple):
    name: str
    geometry: int
    points: Floats
    is_ring: bool


def lines_of(values: Any, closed_are_rings: bool) -> Lines:
    """The lines and polygons of geometries.

    closed_are_rings: whether lines that end where they begin are rings of polygons
    """
    chains = [_chain(*part, closed_are_rings) for part in _parts_of(values)]
    for chain in chains:
        if chain.points.shape[1] != chains[0].points.shape[1]:
            counts = " and ".join(f"{one.name} has {one.points.shape[1]}" for one in (chains[0], chain))
            sentence = f"lines have 2 coordinates or 3, all the same, but {counts}"
            raise InputError(sentence, "bad_argument", chain.geometry)
    chains.sort(key=lambda chain: chain.is_ring)
    sizes = np.array([len(chain.points) for chain in chains])
    rings = np.array([chain.is_ring for chain in chains])
    begins = np.cumsum(sizes) - sizes
    ids = np.arange(sizes.sum())
    to = ids + 1
    to[(begins + sizes - 1)[rings]] = begins[rings]
    is_end = np.zeros(len(ids), bool)
    is_end[(begins + sizes - 1)[~rings]] = True
    chain_of = np.repeat(np.arange(len(chains)), sizes)[~is_end]
    return Lines(
        np.concatenate([chain.points for chain in chains]),
        np.column_stack([ids, to])[~is_end],
        int(sizes[rings].sum()),
        np.array([chain.geometry for chain in chains])[chain_of],
        [chain.name for chain in chains],
        chain_of,
    )


def _parts_of(values: Any) -> Iterator[tuple[str, int, str, Any]]:
    """The name, the geometry's number, the kind and the coordinates of each line and ring."""
    waiting: list[tuple[str, int, int, str | None, Any]] = [("lines", 0, -1, None, values)]
    while waiting:
        name, depth, number, kind, value = waiting.pop()
        if depth > _DEEPEST:
            raise TypeError(f"lines are nested more than {_DEEPEST} levels deep")
        if kind is None:
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
                raise InputError(f"{name} is empty: it has no point", "bad_argument", max(number, 0))
            counts = number < 0 and of is None
            waiting += [
                (name + form.format(i), depth + 1, i if counts else number, of, parts[i])
                for i in reversed(range(len(parts)))
            ]


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
    if value is None:
        raise TypeError(f"{name} has no geometry: it is None")
    if isinstance(value, np.ndarray) and value.dtype != object and value.ndim == 2:
        return "LineString", value
    if isinstance(value, (list, tuple)) or (isinstance(value, np.ndarray) and value.ndim == 1):
        return "List", value
    raise TypeError(
        f"{name} is no geometry: a geometry has __geo_interface__, or is such a mapping, or an array of n by 2 or n by "
        f"3 coordinates, not of type {type(value).__name__}"
    )


def _chain(name: str, number: int, kind: str, coordinates: Any, closed_are_rings: bool) -> _Chain:
    if not is_array_like(coordinates):
        raise TypeError(f"{name} has no list of coordinates, but a {type(coordinates).__name__}")
    if not len(coordinates):
        raise InputError(f"{name} is empty: it has no point", "bad_argument", number)
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
    is_closed = len(points) > 3 and bool((points[0, :2] == points[-1, :2]).all())
    is_ring = kind == "Ring" or (closed_are_rings and is_closed)
    if is_ring and len(points) > 1 and (points[0] == points[-1]).all():
        points = points[:-1]
    least = 3 if is_ring else 2
    if len(points) < least:
        what = "a ring takes 3 or more, besides the first again" if is_ring else "a line takes 2 or more"
        raise InputError(f"{name} has {len(points)} point(s): {what}", "bad_argument", number)
    return _Chain(name, number, points, is_ring)


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
