# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Users' numbers as arrays that VTK accepts: of a type that VTK has, in this machine's byte order, none changed."""

from collections.abc import Sequence

import numpy as np


class FilterError(RuntimeError):
    """An error that a filter reported, or data that no filter accepts."""

    __module__ = "vtkflipflop.pyvista"  # where users import it from


def is_array_like(values):
    """Whether values is an array of NumPy, an object that gives one, or a (nested) list."""
    nested = isinstance(values, Sequence) and not isinstance(values, (str, bytes))
    return nested or isinstance(values, np.ndarray) or hasattr(values, "__array__")


def as_points(values, masked_as_nan):
    """n by 3 coordinates, from n by 3 or n by 2, or from 3 of one point.

    Masked coordinates are a FilterError, or become NaN. Types that VTK does not have are converted: float16 to
    float32, longdouble and Python's numbers to double, bool to uint8. A number that this would change is a
    FilterError, values that are not real numbers are a TypeError, another shape is a ValueError.
    """
    array = _as_array(values, "coordinate")
    if array.shape in ((0,), (3,)):
        array = array.reshape(-1, 3)  # an empty list; one point
    if array.ndim != 2 or array.shape[1] not in (2, 3):
        raise ValueError(f"points are an array of n by 3 or n by 2 coordinates, not of shape {array.shape}")
    array = _exact(array, "coordinate", masked_as_nan)
    if array.shape[1] == 2:
        return np.column_stack([array, np.zeros(len(array), array.dtype)])
    return array


def as_weights(values, masked_as_nan):
    """n weights; masked weights and types are handled as in as_points()."""
    array = _as_array(values, "weight")
    if array.ndim == 2 and array.shape[1] == 1:
        array = array[:, 0]
    if array.ndim != 1:
        raise ValueError(f"weights are n numbers, one for each point, not an array of shape {array.shape}")
    return _exact(array, "weight", masked_as_nan)


def _as_array(values, what):
    """The values as a NumPy array of numbers, masked where the values are masked."""
    if not is_array_like(values):
        raise TypeError(f"{what}s are an array or a list of numbers, not of type {type(values).__name__}")
    array = np.asanyarray(values) if not isinstance(values, Sequence) else _of_lists(values, what)
    if not np.ma.isMaskedArray(array):
        array = np.asarray(array)  # of other subclasses, a matrix stays a matrix
    if array.dtype.kind not in "biufO":
        records = array.dtype.names is not None
        advice = "; numpy.lib.recfunctions.structured_to_unstructured() makes numbers of it" if records else ""
        raise TypeError(f"{what}s are real numbers, not of type {array.dtype}{advice}")
    return array


def _of_lists(values, what):
    """Lists as an array; no number is rounded to the type of the others."""
    try:
        array = _as_masked(values) if any(map(np.ma.isMaskedArray, values)) else np.asarray(values)
        # Among floats, NumPy rounds integers.
        if array.dtype.kind == "f" and (abs(array) >= 2.0**53).any():
            rounded, array = array, np.asarray(values, dtype=object)
            array = np.ma.array(array, mask=np.ma.getmask(rounded))
    except ValueError as error:  # rows of several lengths
        raise ValueError(f"{what}s cannot be told from these lists: {error}") from None
    return array


def _as_masked(rows):
    """Lists of masked arrays, or of numbers and np.ma.masked."""
    masks = [np.ma.getmaskarray(row) if np.ma.isMaskedArray(row) else np.zeros(np.shape(row), bool) for row in rows]
    return np.ma.array([np.ma.filled(row, 0) if np.ma.isMaskedArray(row) else row for row in rows], mask=masks)


def _exact(array, what, masked_as_nan):
    """The same numbers in a type that VTK has, contiguous."""
    mask = np.ma.getmask(array)
    if not masked_as_nan:
        _refuse(mask, f"A {what} is masked", 'Remove them, or have them ignored: non_finite_points="ignore".')
    array = np.asarray(array)
    kind, size = array.dtype.kind, array.dtype.itemsize
    if kind == "b":
        array = array.view(np.uint8)
    elif kind == "f" and size == 2:
        array = array.astype(np.float32)
    elif kind == "O" or kind == "f" and size > 8 or mask.any() and kind in "iu":
        array = _as_doubles(array, mask, what)
    array = np.ascontiguousarray(array, array.dtype.newbyteorder("="))
    if mask.any():
        array = array.astype(np.result_type(array.dtype, np.float32))
        array[mask] = np.nan
    return array


def _as_doubles(array, mask, what):
    """The numbers as doubles; a FilterError if a double would not be the same number."""
    with np.errstate(over="ignore"):
        doubles = np.frompyfunc(_as_double, 1, 1)(np.where(mask, 0.0, array.astype(object)))
    changed = np.equal(doubles, None)
    if changed.any():
        value = str(array[tuple(np.argwhere(changed)[0])])
        _refuse(changed, f"A {what} is no number that a double holds, {value:.40}")
    return doubles.astype(np.float64)


def _as_double(value):
    """The double that is the same number, or None."""
    try:
        double = float(value)
        return double if double == value or value != value else None
    except (TypeError, ValueError, OverflowError):
        return None


def _refuse(wrong, sentence, advice=""):
    """Raise an error if any is wrong, in the words of the filters' error for points that are not finite."""
    if wrong.any():
        points = wrong.reshape(len(wrong), -1).any(axis=1)
        message = f"{sentence}: first at point {points.argmax()}, {points.sum()} such point(s) in all. {advice}"
        raise FilterError(message.rstrip())
