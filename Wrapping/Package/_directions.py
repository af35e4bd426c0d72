# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Directions from the center of a sphere: by longitude and latitude; the arcs and solid angles between them."""

from __future__ import annotations

import math
from decimal import Context, Decimal, localcontext
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._input import doubles_of, refuse
from ._results import Floats

# Where both terms of a solid angle are below that, rounding would decide it.
_UNCERTAIN = 1e-8


def directions_of(longitude: ArrayLike, latitude: ArrayLike) -> Floats:
    """Unit vectors of positions on a sphere: x at longitude 0 on the equator, z at the north pole.

    Equal positions have equal vectors, such as those of longitudes -180 and 180, and of all at a pole. Multiples of 90
    degrees have exact ones.

    Parameters
    ----------
    longitude, latitude : numbers or arrays, in degrees
        shapes are broadcast. A latitude is from -90 to 90; a longitude is any number.

    Returns
    -------
    array of shape (..., 3); NaN where a number is not finite

    Raises
    ------
    InputError
        names the first latitude beyond 90 degrees
    """
    lon, lat = np.broadcast_arrays(_degrees_of(longitude, "longitudes"), _degrees_of(latitude, "latitudes"))
    refuse((np.abs(lat) > 90).ravel() & np.isfinite(lat).ravel(), "a latitude is beyond 90 degrees", "latitude")
    (east, ahead), (up, flat) = _sine_and_cosine(lon), _sine_and_cosine(lat)
    return np.stack([ahead * flat, east * flat, up], axis=-1)


def lonlat_of(directions: ArrayLike) -> Floats:
    """The longitude, from -180 to 180, and the latitude of directions (..., 3) of any length, in degrees: (..., 2)."""
    rows = doubles_of(directions, "directions")
    if rows.shape[-1:] != (3,):
        raise ValueError(f"directions are rows of x, y and z, not an array of shape {rows.shape}")
    x, y, z = np.moveaxis(rows, -1, 0)
    return np.stack([np.degrees(np.arctan2(y, x)), np.degrees(np.arctan2(z, np.hypot(x, y)))], axis=-1)


def arc_angles(begins: Floats, steps: Floats) -> Floats:
    """The angles between vectors and those that end so many steps further."""
    across = np.linalg.norm(np.cross(begins, steps), axis=1)
    found: Floats = np.arctan2(across, (begins * (begins + steps)).sum(axis=1))
    return found


def solid_angles(corners: Floats, center: Floats, radius: float) -> Floats:
    """Of triangles (m, 3, 3) on a sphere, seen from its center: from -2 pi to 2 pi, positive if counter-clockwise.

    In a plane through the center, it is 2 pi if the triangle holds the center, else 0. NaN: a side holds it.
    """
    # A. van Oosterom, J. Strackee, 1983.
    a, to_b, to_c = (corners[:, 0] - center) / radius, *((corners[:, i] - corners[:, 0]) / radius for i in (1, 2))
    b, c = a + to_b, a + to_c
    of_a, of_b, of_c = (np.linalg.norm(corner, axis=1) for corner in (a, b, c))
    volume = (a * np.cross(to_b, to_c)).sum(axis=1) + 0.0
    rest = of_a * of_b * of_c
    rest += (a * b).sum(axis=1) * of_c + (b * c).sum(axis=1) * of_a + (c * a).sum(axis=1) * of_b
    found: Floats = 2 * np.arctan2(volume, rest)
    for row in np.flatnonzero((rest < _UNCERTAIN) & (np.abs(volume) < _UNCERTAIN)):
        found[row] = _solid_angle(corners[row], center)
    return found


def _solid_angle(corners: Floats, center: Floats) -> float:
    """The same of one triangle, of numbers with 200 digits."""
    with localcontext(Context(prec=200)):
        a, b, c = ([Decimal(x) - Decimal(y) for x, y in zip(row, center.tolist())] for row in corners.tolist())

        def dot(u: Any, v: Any) -> Any:
            return sum(x * y for x, y in zip(u, v))

        across = [b[i] * c[(i + 1) % 3] - b[(i + 1) % 3] * c[i] for i in (1, 2, 0)]
        of_a, of_b, of_c = (dot(u, u).sqrt() for u in (a, b, c))
        size = of_a * of_b * of_c
        volume = dot(a, across) / size
        rest = 1 + (dot(a, b) * of_c + dot(b, c) * of_a + dot(c, a) * of_b) / size
        if max(abs(volume), abs(rest)) < Decimal(10) ** -100:  # all digits cancel: the center is on a side
            return math.nan
        return 2 * math.atan2(float(volume) + 0.0, float(rest))


def _degrees_of(values: ArrayLike, what: str) -> Floats:
    found: Floats = doubles_of(values if np.ndim(values) else np.asarray(values), what)
    return found


def _sine_and_cosine(degrees: Floats) -> tuple[Floats, Floats]:
    with np.errstate(invalid="ignore"):
        within = np.fmod(degrees, 360)  # exact, as the next difference is
        quarter = np.rint(within / 90)
        angle = np.radians(within - 90 * quarter)
        sine, cosine = np.sin(angle), np.cos(angle)
        is_turned = quarter % 2 == 1
        sign = np.where(quarter % 4 >= 2, -1.0, 1.0)
    # A quarter turn makes (cosine, -sine) of (sine, cosine).
    return sign * np.where(is_turned, cosine, sine) + 0.0, sign * np.where(is_turned, -sine, cosine) + 0.0
