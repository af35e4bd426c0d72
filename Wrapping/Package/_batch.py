# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Many small point sets in one call, on all threads."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any, ClassVar, Generic, Literal, Self, TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._errors import FlipFlopError, InputError, of_engine, of_part
from ._hull import ConvexHull
from ._input import ids_of, is_array_like, points_and_weights_of, refuse_non_finite
from ._results import Facets, Floats, Frozen, Ids, NonFinite, Progress, frozen, ignores, run, settings
from ._triangulation import RegularTriangulation

Errors = Literal["raise", "keep"]
Result = TypeVar("Result", ConvexHull, RegularTriangulation)


class _Batch(Frozen, Sequence[Result], Generic[Result]):
    """The results of many point sets: a sequence, result by result.

    Attributes
    ----------
    points : ndarray
        the points of all sets
    offsets : ndarray
        set i has the points from offsets[i] to offsets[i + 1]
    errors : dict
        of set to exception, for the sets at fault, whose result is that of no point. Empty unless errors="keep".
    """

    points: NDArray[Any]
    offsets: Ids
    errors: dict[int, FlipFlopError]
    _core: Any
    _ignores: bool

    @classmethod
    def _made(
        cls, core: Any, points: NDArray[Any], offsets: Ids, ignore: bool, errors: Errors, **fields: Any
    ) -> Self:
        found = {item[0]: _of_set(*item) for item in core.errors()}
        if found and errors == "raise":
            raise next(iter(found.values()))
        return cls._of(points=points, offsets=offsets, errors=found, _core=core, _ignores=ignore, **fields)

    def __len__(self) -> int:
        return len(self._core)

    @overload
    def __getitem__(self, index: int) -> Result: ...

    @overload
    def __getitem__(self, index: slice) -> list[Result]: ...

    def __getitem__(self, index: int | slice) -> Result | list[Result]:
        """The result of a set. Its ids count from 0 in the set, as its points do."""
        if isinstance(index, slice):
            return [self._result(i) for i in range(*index.indices(len(self)))]
        at = index + len(self) if index < 0 else index
        if not 0 <= at < len(self):
            raise IndexError(f"set {index} of {len(self)}")
        return self._result(at)

    def __repr__(self) -> str:
        return f"<{type(self).__name__} of {len(self)} sets>"

    def _result(self, index: int) -> Result:
        raise NotImplementedError

    def _stretch(self, index: int) -> slice:
        return slice(int(self.offsets[index]), int(self.offsets[index + 1]))


class HullBatch(_Batch[ConvexHull]):
    __doc__ = _Batch.__doc__

    _call: ClassVar[str] = "convex_hulls(points, offsets)"

    @cached_property
    def volumes(self) -> Floats:
        """The volume of each hull; of points in the plane, the area."""
        return self._core.areas() if self.points.shape[1] == 2 else self._core.volumes()

    @cached_property
    def areas(self) -> Floats:
        """The surface area of each hull; of points in the plane, the perimeter."""
        if self.points.shape[1] == 3:
            return self._core.areas()
        return frozen(np.array([hull.area for hull in self], np.float64))

    def _result(self, index: int) -> ConvexHull:
        return ConvexHull._made(self.points[self._stretch(index)], self._core[index], self._ignores)


class TriangulationBatch(_Batch[RegularTriangulation]):
    __doc__ = _Batch.__doc__

    weights: NDArray[Any] | None
    _call: ClassVar[str] = "regular_triangulations(points, offsets)"

    def _result(self, index: int) -> RegularTriangulation:
        part = self._stretch(index)
        weights = None if self.weights is None else self.weights[part]
        return RegularTriangulation._of(
            points=self.points[part], weights=weights, _core=self._core[index], _ignores=self._ignores
        )


def convex_hulls(
    points: ArrayLike | Sequence[ArrayLike],
    offsets: ArrayLike | None = None,
    *,
    errors: Errors = "raise",
    facets: Facets = "triangles",
    threads: int = 0,
    non_finite: NonFinite = "error",
    progress: Progress = None,
) -> HullBatch:
    """The convex hulls of many sets of points in one call, as convex_hull() gives them.

    Parameters
    ----------
    points : n by 3, or n by 2; or a sequence of such arrays
        the points of all sets, one set after another; or, without offsets, an array for each set, which are copied
    offsets : m + 1 integers, optional
        set i has the points from offsets[i] up to offsets[i + 1]; ascending from 0 to n, so each point is in a set
    errors : {"raise", "keep"}
        what a set at fault leads to: an exception that names it, or an entry in the result's `errors`
    facets, threads, non_finite, progress
        as for convex_hull()
    """
    _check_errors(errors)
    array, _, starts, left_out = _sets_of(points, None, offsets, ignores(non_finite), 3)
    chosen = settings(threads, facets, non_finite, "cpu", progress, left_out)
    core = run(chosen, _core.convex_hulls, array, starts)
    return HullBatch._made(core, array, starts, left_out, errors)


def regular_triangulations(
    points: ArrayLike | Sequence[ArrayLike],
    offsets: ArrayLike | None = None,
    weights: ArrayLike | Sequence[ArrayLike] | None = None,
    *,
    errors: Errors = "raise",
    facets: Facets = "triangles",
    threads: int = 0,
    non_finite: NonFinite = "error",
    progress: Progress = None,
) -> TriangulationBatch:
    """The regular triangulations of many sets of points in one call, as regular_triangulation() gives them.

    Parameters
    ----------
    weights : n numbers, optional
        one for each point; without offsets, an array for each set
    points, offsets, errors, facets, threads, non_finite, progress
        as for convex_hulls()
    """
    _check_errors(errors)
    array, weight_array, starts, left_out = _sets_of(points, weights, offsets, ignores(non_finite), 2)
    chosen = settings(threads, facets, non_finite, "cpu", progress, left_out)
    core = run(chosen, _core.regular_triangulations, array, starts, weight_array)
    return TriangulationBatch._made(core, array, starts, left_out, errors, weights=weight_array)


def _sets_of(
    points: Any, weights: Any, offsets: Any, ignore: bool, columns: int
) -> tuple[NDArray[Any], NDArray[Any] | None, Ids, bool]:
    """Points, weights and offsets of all sets, and whether points that are not finite are left out.

    columns: so many coordinates count
    """
    if offsets is not None:
        array, weight_array, left_out = points_and_weights_of(points, weights, ignore)
        return array, weight_array, _offsets_of(offsets, len(array)), left_out
    if not is_array_like(points) or getattr(points, "ndim", 3) in (0, 2):
        sentence = "points are a sequence of arrays, one for each set; those of all sets in one array take offsets"
        raise TypeError(sentence)
    if weights is not None and (not is_array_like(weights) or len(weights) != len(points)):
        raise ValueError(f"without offsets, weights are a sequence of arrays, one for each of {len(points)} sets")
    parts = []
    for i, both in enumerate(zip(points, [None] * len(points) if weights is None else weights)):
        with of_part(f"set {i}"):
            parts.append(points_and_weights_of(*both, ignore))
            if weights is not None and parts[-1][1] is None and len(parts[-1][0]):
                sentence = f"there are not as many weights as points: {len(parts[-1][0])} points, and weights are None"
                raise InputError(sentence, "weight_count", len(parts[-1][0]), 0)
    left_out = any(part[2] for part in parts)
    if left_out and not ignore:
        for i, (one, own, has_masked) in enumerate(parts):
            with of_part(f"set {i}"):
                refuse_non_finite(one[:, :columns], own, has_masked)
    filled = [(i, part[0]) for i, part in enumerate(parts) if len(part[0])]
    for i, one in filled:
        first, other = filled[0]
        if one.shape[1] != other.shape[1]:
            sentence = f"set {i}: points have {one.shape[1]} coordinates, and {other.shape[1]} in set {first}"
            raise InputError(sentence, "bad_argument", i)
    array = np.concatenate([one for _, one in filled] or [np.empty((0, 3))])
    weight_array = None
    if weights is not None:
        weight_array = np.concatenate([np.empty(0, np.float32), *(part[1] for part in parts if part[1] is not None)])
    return array, weight_array, frozen(np.cumsum([0, *(len(part[0]) for part in parts)])), left_out


def _offsets_of(values: ArrayLike, points: int) -> Ids:
    offsets = np.array(ids_of(values, "offsets"))
    if offsets.ndim != 1:
        raise ValueError(f"offsets are an array of one dimension, not of shape {offsets.shape}")
    begins, ends = offsets[:-1], offsets[1:]
    wrong = (begins < 0) | (ends < begins) | (ends > points)
    if wrong.any():
        first = int(wrong.argmax())
        found = f"set {first} is from {begins[first]} to {ends[first]}"
        sentence = f"offsets ascend from 0 to {points}, the number of points, but {found}"
        raise InputError(sentence, "bad_argument", first, int(wrong.sum()))
    first, last = (int(offsets[0]), int(offsets[-1])) if len(offsets) else (0, 0)
    if first > 0 or last < points:
        left_out = [f"the first {first}"] * (first > 0) + [f"the last {points - last}"] * (last < points)
        sentence = (
            f"offsets are from {first} to {last}, so {' and '.join(left_out)} of {points} points are in no set: give "
            f"points[{first}:{last}]" + f" and offsets - {first}" * (first > 0)
        )
        raise InputError(sentence, "bad_argument")
    return frozen(offsets)


def _check_errors(errors: Errors) -> None:
    if errors not in ("raise", "keep"):
        raise ValueError(f"errors is one of 'raise', 'keep', not {errors!r}")


def _of_set(number: int, code: int, text: str, index: int, count: int) -> FlipFlopError:
    return of_engine(code, f"set {number}: {text}", index, count)
