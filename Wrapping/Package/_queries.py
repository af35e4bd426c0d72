# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Queries at positions: the forms that these may have, and the form of the results."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._errors import InputError
from ._input import array_of, points_of
from ._results import Floats, Ids, NonFinite, Progress, ignores, run, settings

# Of one position a number, of several an array.
Truths = np.bool_ | NDArray[np.bool_]
Sides = np.int8 | NDArray[np.int8]
Lengths = np.float64 | Floats
Numbers = np.int64 | Ids

# How the engine begins its sentences about a result that is not of these points, or that are not finite. (A user's own
# box was checked before.)
_MISFITS = (
    "an argument is invalid",
    "the triangulation must be one of these points",
    "the hull must be one",
    "a hull's points must be finite",
    "the box's bounds must be finite",
)


def results_of(
    query: Any,
    positions: Any,
    columns: tuple[int, ...],
    threads: int,
    non_finite: NonFinite,
    progress: Progress,
    *before: Any,
    what: str = "points",
) -> Any:
    """What query() returns for each position: of shape (..., ndim) an array of shape (...), of one position a number.

    columns: how many coordinates positions may have. before: arguments of query() before these. what: their name
    """
    ignore = ignores(non_finite)
    rows, shape = _rows_of(positions, columns, what)
    array, left_out = points_of(rows, ignore)
    chosen = settings(threads, "triangles", non_finite, "cpu", progress, left_out)
    found = run(chosen, query, *before, array)
    return found.reshape(shape + found.shape[1:])[()]


def interpolation_of(queries: Any, method: str) -> Any:
    """The query that interpolates by a method."""
    return getattr(queries, f"interpolate_{method.replace('-', '_')}")


def with_ones(rows: Floats) -> Floats:
    """The values, and after them what is 1 everywhere: interpolated, it is NaN outside alone, also without values."""
    return np.column_stack([rows, np.ones(len(rows))])


def _rows_of(positions: Any, columns: tuple[int, ...], what: str) -> tuple[Any, tuple[int, ...]]:
    """The positions as rows of coordinates, and the shape that the positions have."""
    if isinstance(positions, tuple) and len(positions) in columns and any(map(_has_many, positions)):
        raise ValueError(
            f"{what} are an array of shape (..., {columns[0]}); a tuple of {len(positions)} arrays could be {what} or "
            f"coordinates: write numpy.stack(arrays) of {what}, numpy.stack(arrays, axis=-1) of x and y"
            f"{' and z' if columns[0] == 3 else ''}"
        )
    array = array_of(positions, "coordinates")
    if array.shape == (0,):  # an empty list
        return array.reshape(0, columns[0]), (0,)
    if array.ndim == 0 or array.shape[-1] not in columns:
        raise ValueError(
            f"{what} are an array of shape (..., {columns[0]}) here, as the result is of points with {columns[0]} "
            f"coordinates; not of shape {array.shape}"
        )
    return (array if array.ndim == 2 else array.reshape(-1, array.shape[-1])), array.shape[:-1]


def _has_many(item: Any) -> bool:
    return bool(getattr(item, "ndim", 1 if isinstance(item, Sequence) else 0))


@contextmanager
def unchanged() -> Iterator[None]:
    """A result's own points and cells go in: where these do not fit any more, the points have changed."""
    try:
        yield
    except InputError as error:
        if error.code != "non_finite" and not str(error).startswith(_MISFITS):
            raise
        raise changed(error.index) from None


def finite(points: NDArray[Any], ids: Ids) -> NDArray[Any]:
    """A result's own points, of which these are finite in x and y: else they have changed."""
    wrong = ~np.isfinite(points[ids.reshape(-1), :2]).all(axis=1)
    if wrong.any():
        raise changed(int(ids.flat[int(wrong.argmax())]))
    return points


def changed(index: int = -1) -> InputError:
    sentence = (
        "the points have changed since they were given, and this result is not of them any more: it keeps the caller's "
        "array, so give a copy of an array that will change"
    )
    return InputError(sentence, "points_changed", index)
