# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Images of values, north up, as rasterio places them."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from ._arguments import numbers_of
from ._domain import domain_of
from ._errors import InputError
from ._input import values_of
from ._results import refrozen

Method = Literal["linear", "natural", "clough-tocher", "laplace"]
METHODS: tuple[str, ...] = get_args(Method)
Transform = tuple[float, float, float, float, float, float]
Grid = tuple[tuple[int, int], Transform]


class Image(NamedTuple):
    """Values at the centers of pixels, the first row in the north.

    Attributes
    ----------
    array : ndarray of shape (rows, columns), or (rows, columns, ...) of values of several components
        rasterio wants components first: numpy.moveaxis(array, -1, 0)
    transform : 6 numbers (a, b, c, d, e, f)
        from columns and rows to x and y: x = a * column + c, y = e * row + f; b and d are 0, e is below 0. As in
        rasterio, whole numbers are the corners of pixels, (0, 0) the upper left one, and centers are half a pixel on:
        rasterio.Affine(*transform).
    """

    array: NDArray[Any]
    transform: Transform

    def __reduce__(self) -> tuple[Any, ...]:
        return refrozen, (type(self), *self)

    @property
    def x(self) -> NDArray[np.float64]:
        """The x of the pixels' centers, of each column: the very positions of the values."""
        a, _, c, _, _, _ = self.transform
        return c + a / 2 + np.arange(self.array.shape[1]) * a

    @property
    def y(self) -> NDArray[np.float64]:
        """The y of the pixels' centers, of each row, descending."""
        _, _, _, _, e, f = self.transform
        return f + e / 2 + np.arange(self.array.shape[0]) * e

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """The outer corners of the corner pixels: (left, bottom, right, top), in rasterio's order."""
        a, _, c, _, e, f = self.transform
        rows, columns = self.array.shape[:2]
        return c, f + e * rows, c + a * columns, f


def grid_of(
    points: NDArray[np.float64], spacing: Any, shape: Any, bounds: ArrayLike | None
) -> Grid:
    """Rows and columns, and the transform. points: what the image covers by default."""
    if (spacing is None) == (shape is None):
        raise TypeError("an image has a spacing or a shape: give one of them")
    if bounds is not None:
        box = domain_of("bounds", bounds).array
        if box is None or box.shape != (4,):
            raise ValueError("bounds are a box: (x0, x1, y0, y1) or two corners ((x0, y0), (x1, y1))")
        left, right, bottom, top = box.tolist()
    elif len(points):
        (left, bottom), (right, top) = points.min(axis=0).tolist(), points.max(axis=0).tolist()
    else:
        raise InputError("an image of no point: give bounds", "bad_argument")
    lengths = right - left, top - bottom
    if shape is not None:
        rows, columns = (_count_of(number) for number in _pair_of(shape))
        if not min(lengths) > 0:
            sentence = "the points are on a line along x or y, so their box has no inside: give bounds"
            raise InputError(sentence, "bad_argument")
        steps = lengths[0] / columns, lengths[1] / rows
        for length, step, count in zip(lengths, steps, (columns, rows)):
            if not 0 < step < math.inf:
                raise InputError(f"a length of {length} cannot be divided into {count} pixels", "bad_argument")
    else:
        steps = numbers_of("spacing", np.broadcast_to(spacing, 2) if np.ndim(spacing) == 0 else spacing, 2)
        if not min(steps) > 0:
            raise ValueError(f"spacing is above 0, not {spacing!r}")
        columns, rows = (_cover(length, step) for length, step in zip(lengths, steps))
    return (rows, columns), (steps[0], 0.0, left, 0.0, -steps[1], top)


def image_of(
    query: Callable[..., NDArray[Any]],
    values: ArrayLike,
    count: int,
    grid: Grid,
    fill: float,
    dtype: DTypeLike | None,
) -> Image:
    """What a query makes of the values of so many points."""
    given = values_of(values, count)
    kind = np.dtype(dtype or (np.float32 if getattr(values, "dtype", None) == np.float32 else np.float64))
    if kind not in (np.float32, np.float64):
        raise TypeError(f"dtype is float32 or float64, not {dtype!r}")
    size, transform = grid
    a, _, c, _, e, f = transform
    rows = np.ascontiguousarray(given.reshape(count, int(np.prod(given.shape[1:]))))
    if rows.shape[1]:
        found = query(rows, (c + a / 2, f + e / 2, a, e), *size, fill, kind == np.float32)
    else:
        found = np.empty((*size, 0), kind)
    return Image(found.reshape(size + given.shape[1:]), transform)


def _cover(length: float, step: float) -> int:
    """How many steps cover a length. Less than a millionth of a step is not covered: it comes of rounding."""
    count = length / step
    if not count < 2**52:
        raise ValueError(f"a spacing of {step} makes too many pixels of a length of {length}")
    return max(1, math.ceil(count - 1e-6))


def _pair_of(shape: Any) -> tuple[Any, Any]:
    try:
        rows, columns = shape
    except (TypeError, ValueError):
        raise TypeError(f"shape is two integers, rows and columns, not {shape!r}") from None
    return rows, columns


def _count_of(number: Any) -> int:
    try:
        count = int(number.__index__())
    except (AttributeError, TypeError):
        raise TypeError(f"shape is two integers, rows and columns; {number!r} is none") from None
    if not 1 <= count < 2**52:
        raise ValueError(f"shape is 1 or more rows and columns, not {number!r}")
    return count
