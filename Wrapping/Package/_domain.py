# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where cells end: a box or a convex polygon, as users give it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import InputError
from ._input import doubles_of
from ._results import Ids

_BOX = "a box is (x0, x1, y0, y1) or two corners ((x0, y0), (x1, y1)), with x0 < x1 and y0 < y1"
_FORMS = f"{_BOX}; a polygon is three rows or more of x and y"
_BOUNDS = "bounds are (x0, y0, x1, y1), as shapely has them"


class Domain(NamedTuple):
    """A box or a polygon as the engine reads it, or None for the box of the points; and each corner's number."""

    array: NDArray[np.float64] | None
    numbers: Ids | None = None  # among the caller's corners

    @contextmanager
    def named(self) -> Iterator[None]:
        """An error about a corner, from in here, has its number in the caller's order, and where it is."""
        try:
            yield
        except InputError as error:
            if error.code != "not_convex" or self.array is None or self.numbers is None:
                raise
            corner, index = tuple(self.array[error.index].tolist()), int(self.numbers[error.index])
            sentence = f"the domain is no convex polygon with finite corners: at corner {index}, {corner}"
            raise InputError(sentence, error.code, index, error.count) from None


def domain_of(name: str, domain: Any) -> Domain:
    """A box as 4 numbers, or a polygon's corners as rows of x and y, counter-clockwise; of either, none masked.

    A polygon may run either way, and have corners several times in a row, also the first at its end. It may be a
    geometry.
    """
    if domain is None:
        return Domain(None)
    numbers = f"the numbers of {name}"
    sides = [getattr(domain, side, None) for side in ("left", "bottom", "right", "top")]
    if None not in sides:  # a rasterio BoundingBox
        return Domain(_box_of(name, doubles_of(sides, numbers).reshape(2, 2).T.reshape(-1)))
    array = doubles_of(_corners_of(name, domain), numbers)
    if array.shape == (4,):
        return Domain(_box_of(name, array))
    if array.shape == (2, 2):
        return Domain(_box_of(name, array.T.reshape(-1)))
    if array.ndim != 2 or array.shape[1] != 2 or len(array) < 3:
        raise ValueError(f"{name}: {_FORMS}; not an array of shape {array.shape}")
    kept = np.flatnonzero(np.append(True, (array[1:] != array[:-1]).any(axis=1)))
    if (array[kept[-1]] == array[0]).all():
        kept = kept[:-1]
    if len(kept) < 3:
        raise ValueError(f"{name}: {_FORMS}; not {len(array)} rows of which no three in turn differ")
    kept = kept[::-1] if _is_clockwise(array[kept]) else kept
    return Domain(np.ascontiguousarray(array[kept]), kept)


def _corners_of(name: str, domain: Any) -> Any:
    """The corners, x and y, of a polygon that is a geometry; anything else as it is."""
    geometry = getattr(domain, "__geo_interface__", domain)
    if not isinstance(geometry, Mapping) or "type" not in geometry:
        return domain
    rings = geometry.get("coordinates", ()) if geometry["type"] == "Polygon" else ()
    if len(rings) != 1:
        kind = f"Polygon of {len(rings)} rings" if geometry["type"] == "Polygon" else geometry["type"]
        raise TypeError(f"{name} takes a polygon without holes, not a {kind}")
    return [corner[:2] for corner in rings[0]]


def _box_of(name: str, box: NDArray[np.float64], form: str = _BOX) -> NDArray[np.float64]:
    """The box, if it has an inside."""
    x0, x1, y0, y1 = box.tolist()
    if not (np.isfinite(box).all() and x0 < x1 and y0 < y1):
        sentence = f"{name}: the box from x = {x0} to {x1} and y = {y0} to {y1} has no inside or is not finite"
        raise InputError(f"{sentence}; {form}", "bad_argument")
    return np.ascontiguousarray(box)


def _is_clockwise(corners: NDArray[np.float64]) -> bool:
    """Whether a convex polygon runs clockwise; exactly, by the turn at its lowest corner among those furthest left."""
    if not np.isfinite(corners).all():
        return False
    at = int(np.lexsort(corners.T[::-1])[0])
    before, here, after = (
        [Fraction(float(x)) for x in corners[i % len(corners)]] for i in (at - 1, at, at + 1)
    )
    turn = (here[0] - before[0]) * (after[1] - here[1]) - (here[1] - before[1]) * (after[0] - here[0])
    return turn < 0


def domain_of_call(domain: Any, bounds: ArrayLike | None, box: ArrayLike | None = None) -> Domain:
    """The domain that one of the arguments of these names describes; box is another name of domain."""
    if domain is not None and box is not None:
        raise TypeError("domain and box are two names of one argument: give domain alone")
    if bounds is None:
        return domain_of("domain", domain) if box is None else domain_of("box", box)
    if domain is not None or box is not None:
        raise TypeError("cells end at a domain or at bounds: give one of them")
    array = doubles_of(bounds, "the numbers of bounds")
    if array.shape != (4,):
        raise ValueError(f"{_BOUNDS}; not an array of shape {array.shape}")
    return Domain(_box_of("bounds", array[[0, 2, 1, 3]], _BOUNDS))
