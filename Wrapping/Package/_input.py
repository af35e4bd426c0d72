# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Users' arrays as the engine reads them: points and weights in place, float32 or float64, none rounded.

Every array argument is read here, and its mask, if it has one: a masked point, or a point with a masked weight, is left
out; a masked value is NaN; anywhere else, a masked entry is an error.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ._device import HostCopy, host_copy, is_on_device
from ._errors import InputError, at_points

_FLOATS = (np.dtype(np.float32), np.dtype(np.float64))
_PLAIN = (np.ndarray, HostCopy)
_NON_FINITE = "a coordinate or weight is NaN or infinite"


def points_of(values: Any, ignore: bool) -> tuple[np.ndarray, bool]:
    """n rows of 2 or 3 coordinates that the engine can read, and whether points that are not finite are left out.

    An array is taken as it is if the engine reads its memory: float32 or float64 in this machine's byte order, a
    row's coordinates side by side. Otherwise it is copied, exactly. Masked points become NaN, which the engine then
    leaves out; other points must be finite all the same, unless these are ignored, too. Of an array on a device it is a
    HostCopy.
    """
    array = _of_host(values, "coordinates")
    if type(array) not in _PLAIN or array.ndim != 2 or array.shape[1] not in (2, 3) or array.dtype not in _FLOATS:
        array, masked = _exact(rows_of(array), "coordinate", ignore)
        return array, ignore or masked
    return _adjacent(array), ignore


def whole_points_of(values: Any) -> np.ndarray:
    """points_of(), where no point can be left out: a masked one is an error."""
    array, left_out = points_of(values, False)
    if left_out:
        refuse_masked(np.ma.masked_invalid(array), "points")
    return array


def rows_of(values: Any) -> np.ndarray:
    """n rows of 2 or 3 real numbers of any type, masked where the values are masked."""
    array = _as_array(values, "coordinates")
    if array.shape == (0,):
        array = array.reshape(0, 3)  # an empty list
    if array.ndim != 2 or array.shape[1] not in (2, 3):
        hint = ""
        if array.ndim == 2 and array.shape[0] in (2, 3):
            hint = ": if its rows are x and y, pass numpy.column_stack() of them"
        elif array.ndim == 3 and array.shape[2] in (2, 3):
            hint = f": pass reshape(-1, {array.shape[2]}) of it, and where sets begin to convex_hulls()"
        raise ValueError(f"points are an array of n by 3 or n by 2 coordinates, not of shape {array.shape}{hint}")
    return array


def weights_of(values: Any, ignore: bool) -> tuple[np.ndarray, bool]:
    """n weights, in the way of points_of()."""
    return column_of(values, "weight", ignore)


def points_and_weights_of(points: Any, weights: Any, ignore: bool) -> tuple[np.ndarray, np.ndarray | None, bool]:
    """points_of() and weights_of() of a triangulation, as many; and whether points that are not finite are left out."""
    array, left_out = points_of(points, ignore)
    if weights is None:
        return array, None, left_out
    weight_array, masked = weights_of(weights, ignore)
    if len(array) != len(weight_array):
        sentence = f"there are not as many weights as points: {len(array)} points, {len(weight_array)} weights"
        raise InputError(sentence, "weight_count", len(array), len(weight_array))
    return array, weight_array, either_excluded(array, left_out, weight_array, masked)


def either_excluded(array: np.ndarray, left_out: bool, column: np.ndarray, masked: bool) -> bool:
    """Whether points that are not finite are left out.

    An error if points or their column have masked entries, and the other is not finite: the engine excludes that, too.
    """
    if left_out != masked:
        refuse_non_finite(array[:, :2] if masked else column)
    return left_out or masked


def refuse_non_finite(array: np.ndarray, weights: np.ndarray | None = None, left_out: bool = False) -> None:
    """An error that names the first point that is not finite, or whose weight is not, unless these are left out."""
    if not left_out:
        wrong = ~np.isfinite(array)
        refuse(wrong if weights is None else wrong.any(axis=1) | ~np.isfinite(weights), _NON_FINITE, "non_finite")


def column_of(values: Any, what: str, ignore: bool) -> tuple[np.ndarray, bool]:
    """n weights or heights, in the way of points_of()."""
    array = _of_host(values, f"{what}s")
    if type(array) not in _PLAIN or array.ndim != 1 or array.dtype not in _FLOATS:
        array = _as_array(array, f"{what}s")
        if array.ndim == 2 and array.shape[1] == 1:
            array = array[:, 0]
        if array.ndim != 1:
            raise ValueError(f"{what}s are n numbers, one for each point, not an array of shape {array.shape}")
        array, masked = _exact(array, what, ignore)
        return array, ignore or masked
    step = array.strides[0]
    in_place = array.flags.aligned and step >= array.itemsize and step % array.itemsize == 0
    return (array if in_place else array.copy()), ignore


def whole_weights_of(values: Any) -> np.ndarray:
    """weights_of(), where no point can be left out: a masked one is an error."""
    array, left_out = weights_of(values, False)
    if left_out:
        refuse_masked(np.ma.masked_invalid(array), "weights")
    return array


def values_of(values: Any, count: int) -> np.ndarray:
    """A number or an array of numbers for each of so many points, as doubles: rounded, NaN where they are masked."""
    array = _as_array(_of_host(values, "values"), "values")
    if array.ndim == 0 or len(array) != count:
        raise ValueError(f"values are {count} numbers or rows, not an array of shape {array.shape}")
    numbers = _rounded(array, "values")
    if np.ma.is_masked(array):
        numbers = numbers.copy()
        numbers[np.ma.getmaskarray(array)] = np.nan
    return numbers


def doubles_of(values: Any, what: str) -> np.ndarray:
    """Real numbers in an array of any shape, as doubles: rounded, and none masked."""
    array = _as_array(_of_host(values, what), what)
    refuse_masked(array, what)
    return _rounded(array, what)


def ids_of(values: Any, what: str) -> np.ndarray:
    """Contiguous int64 from any integers; other numbers are a TypeError."""
    array = _as_array(_of_host(values, what), what)
    refuse_masked(array, what)
    if array.size == 0 and array.dtype.kind == "f":  # an empty list
        array = array.astype(np.int64)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{what} are integers, not of type {array.dtype}")
    if array.dtype == np.uint64 and array.size and array.max() > np.iinfo(np.int64).max:
        raise InputError(f"{what}: {array.max()} is out of range", "bad_argument")
    return np.ascontiguousarray(array, np.int64)


def refuse_masked(values: Any, what: str) -> None:
    """An error that names the first masked entry, if there is one."""
    if not np.ma.is_masked(values):
        return
    rows = np.argwhere(np.ma.getmaskarray(values))
    sentence = f"{what}: entry {rows[0].tolist()} is masked, {len(rows)} in all, and none may be here"
    raise InputError(sentence, "masked", int(rows[0][0]) if rows[0].size else -1, len(rows))


def refuse_geometry(values: Any, what: str) -> None:
    """A TypeError that names the way out if the values are shapely's or GeoPandas's."""
    if hasattr(values, "get_coordinates"):  # GeoPandas's
        way_out = "pass .get_coordinates() of it"
    elif hasattr(values, "__geo_interface__"):
        way_out = "pass shapely.get_coordinates() of it"
    else:
        return
    raise TypeError(f"{what} are an array of numbers, not a {type(values).__name__}: {way_out}")


def array_of(values: Any, what: str) -> np.ndarray:
    """An array of real numbers of any type and shape, on the host, masked where the values are masked."""
    return _as_array(_of_host(values, what), what)


def is_array_like(values: Any) -> bool:
    """Whether values is an array of NumPy, an object that gives one, or a (nested) list."""
    nested = isinstance(values, Sequence) and not isinstance(values, (str, bytes))
    return nested or isinstance(values, np.ndarray) or hasattr(values, "__array__") or hasattr(values, "__dlpack__")


def _adjacent(array: np.ndarray) -> np.ndarray:
    """The array itself if a row's numbers lie side by side, and rows a whole number of them apart."""
    size = array.itemsize
    step, inner = array.strides
    if inner == size and step >= size * array.shape[1] and step % size == 0 and array.flags.aligned:
        return array
    return np.ascontiguousarray(array)


def _as_array(values: Any, what: str) -> np.ndarray:
    """The values as a NumPy array of numbers, masked where the values are masked.

    what: the numbers' name, in the plural
    """
    if type(values) is np.ndarray and values.dtype.kind in "biuf":
        return values
    refuse_geometry(values, what)
    if isinstance(values, memoryview):
        values = np.asarray(values)
    if isinstance(values, Sequence) and len(values):
        refuse_geometry(values[0], what)
    if not is_array_like(values):
        raise TypeError(f"{what} are an array or a list of numbers, not of type {type(values).__name__}")
    array = np.asanyarray(_by_dlpack(values)) if not isinstance(values, Sequence) else _of_lists(values, what)
    if not np.ma.isMaskedArray(array):
        array = np.asarray(array)  # of other subclasses, a matrix stays a matrix
    if array.dtype.kind not in "biufO":
        records = array.dtype.names is not None
        advice = "; numpy.lib.recfunctions.structured_to_unstructured() makes numbers of it" if records else ""
        raise TypeError(f"{what} are real numbers, not of type {array.dtype}{advice}")
    if array.dtype.kind == "O" and array.size:
        refuse_geometry(np.ma.getdata(array).flat[0], what)
    return array


def _rounded(array: np.ndarray, what: str) -> np.ndarray:
    """The numbers of a real array as doubles, rounded. What is masked is any number."""
    plain = np.ma.filled(array, 0) if array.dtype.kind == "O" else np.asarray(array)
    try:
        return np.ascontiguousarray(plain, np.float64).reshape(array.shape)
    except (TypeError, ValueError, OverflowError) as error:
        raise TypeError(f"{what} are real numbers that a double holds: {error}") from None


def _of_host(values: Any, what: str) -> Any:
    """The values; a copy on the host, if a device has them."""
    return host_copy(values, what) if type(values) is not np.ndarray and is_on_device(values, what) else values


def _by_dlpack(values: Any) -> Any:
    return values if hasattr(values, "__array__") else np.from_dlpack(values)


def _of_lists(values: Any, what: str) -> np.ndarray:
    """Lists as an array; no number is rounded to the type of the others."""
    try:
        array = _as_masked(values) if any(map(np.ma.isMaskedArray, values)) else np.asarray(values)
        # Among floats, NumPy rounds integers.
        if array.dtype.kind == "f" and (abs(array) >= 2.0**53).any():
            rounded, array = array, np.asarray(values, dtype=object)
            array = np.ma.array(array, mask=np.ma.getmask(rounded))
    except ValueError as error:  # rows of several lengths
        raise ValueError(f"{what} cannot be read from these lists: {error}") from None
    return array


def _as_masked(rows: Any) -> np.ma.MaskedArray:
    """Lists of masked arrays, or of numbers and np.ma.masked."""
    masks = [np.ma.getmaskarray(row) if np.ma.isMaskedArray(row) else np.zeros(np.shape(row), bool) for row in rows]
    return np.ma.array([np.ma.filled(row, 0) if np.ma.isMaskedArray(row) else row for row in rows], mask=masks)


def _exact(array: np.ndarray, what: str, ignore: bool) -> tuple[np.ndarray, bool]:
    """The same numbers as float32 or float64, and whether some were masked: those are NaN."""
    mask = np.ma.getmask(array)
    masked = bool(mask.any())
    array = np.asarray(array)
    kind, size = array.dtype.kind, array.dtype.itemsize
    if kind == "O" or kind == "f" and size > 8 or kind in "iu" and size == 8:
        numbers = _as_doubles(array, mask, what)
    elif kind == "f" and size == 8 or kind in "iu" and size == 4:
        numbers = array.astype(np.float64)
    else:  # float32 has 24 bits
        numbers = array.astype(np.float32)
    numbers = np.ascontiguousarray(numbers)
    if masked:
        if not ignore:
            # The engine is about to ignore all, so what is not masked is looked at here.
            refuse(~np.isfinite(numbers) & ~mask, _NON_FINITE, "non_finite")
        numbers[mask] = np.nan
    return numbers, masked


def _as_doubles(array: np.ndarray, mask: Any, what: str) -> np.ndarray:
    """The numbers as doubles; an InputError if a double would not be the same number."""
    if array.dtype.kind in "iu":
        doubles = array.astype(np.float64)
        # 2^63 and 2^64 are doubles that the integers do not reach.
        small = np.abs(doubles) < 2.0**53
        changed = ~small & ~np.asarray(mask)
        if changed.any():
            rows = np.nonzero(changed)
            changed[rows] = [int(double) != int(one) for double, one in zip(doubles[rows], array[rows])]
    else:
        with np.errstate(over="ignore", invalid="ignore"):  # comparing with a NaN may be invalid
            boxed = np.frompyfunc(_as_double, 1, 1)(np.where(mask, 0.0, array.astype(object)))
        changed = np.equal(boxed, None)
        doubles = np.where(changed, np.nan, boxed).astype(np.float64)
    if changed.any():
        value = str(array[tuple(np.argwhere(changed)[0])])
        refuse(changed, f"a {what} is no number that a double holds, {value:.40}", "inexact")
    return doubles


def _as_double(value: Any) -> float | None:
    """The double that is the same number, NaN for a missing one, or None."""
    if value is None or type(value).__name__ == "NAType":  # pandas.NA
        return np.nan
    try:
        double = float(value)
        return double if double == value or value != value else None
    except (TypeError, ValueError, OverflowError):
        return None


def refuse(wrong: np.ndarray, sentence: str, code: str) -> None:
    """Raises an error if any is wrong, in the words of the engine's."""
    points = wrong.any(axis=1) if wrong.ndim > 1 else wrong
    if points.any():
        raise at_points(sentence, code, int(points.argmax()), int(points.sum()))
