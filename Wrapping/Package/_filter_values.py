# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The point data of a source at other positions, by its triangulation: what algorithms that interpolate make."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _core
from . import _vtkmodules as vtk
from ._filter_settings import Choice, Flag, Setting, number, string
from ._image import METHODS
from ._input import refuse_non_finite
from ._queries import interpolation_of, with_ones
from ._results import Floats

# So many points are asked about at once, and of an image so many numbers: their values are twice in memory.
_POINTS_AT_ONCE, _NUMBERS_AT_ONCE = 1 << 18, 1 << 25
_MASK, _NULL_VALUE, _CLOSEST = range(3)

INTERPOLATION_MODE = Choice(
    "InterpolationMode", 0, Linear="LINEAR", NaturalNeighbor="NATURAL_NEIGHBOR", CloughTocher="CLOUGH_TOCHER"
)


def settings_of_values(null_value: float) -> tuple[Setting, ...]:
    """What all such algorithms can be told, less the mode."""
    return (
        Choice(
            "NullPointsStrategy", 0, "To", "Strategy", MaskPoints="MASK_POINTS", NullValue="NULL_VALUE",
            ClosestPoint="CLOSEST_POINT",
        ),
        Setting("NullValue", null_value, number),
        Setting("ValidPointsMaskArrayName", "vtkValidPointMask", string),
        Flag("InterpolateZ", True),
        Setting("ZArrayName", "Elevation", string),
    )


class Grid(NamedTuple):
    """The pixels of an image's slices: where pixel (0, 0) would be, the steps, how many, and the first one's index."""

    origin: tuple[float, float]
    spacing: tuple[float, float]
    size: tuple[int, int]
    first: tuple[int, int] = (0, 0)


@dataclass
class _Field:
    """An array that is interpolated, and which attribute it is; -1: none."""

    name: str
    attribute: int
    values: NDArray[Any]
    component_names: list[str | None]


class InterpolatedData:
    """A triangulation that is ready for queries, and the values of its points, which are copied.

    chosen: an algorithm's settings. heights: the points' z; None: there are none. data: their point data; None: none of
    it is interpolated. excluded: names of arrays that are not
    """

    def __init__(
        self, chosen: dict[str, Any], queries: Any, count: int, heights: NDArray[Any] | None, data: Any,
        excluded: Collection[str] = (),
    ) -> None:
        self._chosen, self._queries = chosen, queries
        self._fields = [] if data is None else list(_fields_of(data, count, excluded))
        name = chosen["ZArrayName"]
        if chosen["InterpolateZ"] and heights is not None and not (data is not None and data.HasArray(name)):
            self._fields.append(_Field(name, -1, heights.reshape(-1, 1), []))
        columns = [field.values.astype(np.float64) for field in self._fields]
        self._rows = with_ones(np.column_stack([np.empty((count, 0)), *columns]))
        for field in self._fields:
            field.values = field.values[:0]  # the source's own may go

    def at_points(
        self, points: NDArray[Any], ignore: bool, part: Callable[[float, float], Any], output: Any
    ) -> None:
        """Adds the arrays of these points to point data, with the settings of each part of the run."""
        if not ignore:
            refuse_non_finite(points[:, :2])
        query = interpolation_of(self._queries, METHODS[self._chosen["InterpolationMode"]])
        made = self._arrays(len(points))
        for begin, end in _parts(len(points), _POINTS_AT_ONCE):
            some, settings = points[begin:end], part(begin / len(points), end / len(points))
            self._write(query(self._rows, some, settings), lambda null, some=some: some[null], settings, made, begin)
        self._add(made, output)

    def at_grid(self, grid: Grid, slices: int, part: Callable[[float, float], Any], output: Any) -> None:
        """The same of an image of so many equal slices: with the bits of the points, much sooner."""
        columns, rows = grid.size
        method = METHODS[self._chosen["InterpolationMode"]]
        made = self._arrays(columns * rows * slices)
        at_once = max(1, _NUMBERS_AT_ONCE // (columns * self._rows.shape[1]))
        for begin, end in _parts(rows, at_once):
            settings, first = part(begin / rows, end / rows), (grid.first[0], grid.first[1] + begin)
            arguments = self._rows, (*grid.origin, *grid.spacing), end - begin, columns, np.nan, False
            found = self._queries.image(method, *arguments, settings, first)

            def positions(null: NDArray[Any], first: tuple[int, int] = first) -> Floats:
                j, i = np.divmod(null, columns)
                axes = zip(grid.origin, grid.spacing, (first[0] + i, first[1] + j))
                return np.column_stack([origin + index.astype(float) * step for origin, step, index in axes])

            self._write(found.reshape(-1, found.shape[2]), positions, settings, made, begin * columns)
        count = columns * rows
        for values in made:
            for slice_ in range(1, slices):
                values[slice_ * count : (slice_ + 1) * count] = values[:count]
        self._add(made, output)

    def _arrays(self, count: int) -> list[NDArray[Any]]:
        """For the values of each field, and for the mask."""
        types = [(field.values.shape[1], np.dtype(_type_of(field.values))) for field in self._fields]
        _core.require_memory(min(count * (1 + sum(size * kind.itemsize for size, kind in types)), 2**63 - 1))
        return [*(np.empty((count, size), kind) for size, kind in types), np.empty(count, np.int8)]

    def _write(
        self, found: Floats, positions: Callable[[NDArray[Any]], NDArray[Any]], settings: Any,
        made: list[NDArray[Any]], begin: int,
    ) -> None:
        """What was found becomes values from a row on; what is NaN in the last column is null."""
        null = np.isnan(found[:, -1])
        if null.any():
            found = self._without_nulls(found, null, positions, settings)
        column, end = 0, begin + len(found)
        with np.errstate(over="ignore"):
            for values in made[:-1]:
                values[begin:end] = found[:, column : column + values.shape[1]]
                column += values.shape[1]
        made[-1][begin:end] = ~np.isnan(found[:, -1])

    def _without_nulls(
        self, found: Floats, null: NDArray[np.bool_], positions: Callable[[NDArray[Any]], NDArray[Any]], settings: Any
    ) -> Floats:
        """A copy with values at null points; the last column tells which still are."""
        found = found.copy()
        if self._chosen["NullPointsStrategy"] == _CLOSEST:
            rows = np.flatnonzero(null)
            closest = self._queries.nearest(np.ascontiguousarray(positions(rows)), settings)
            is_there = closest >= 0
            found[rows[is_there]] = self._rows[closest[is_there]]
            null = np.isnan(found[:, -1])
        found[null, :-1] = self._chosen["NullValue"]
        return found

    def _add(self, made: list[NDArray[Any]], output: Any) -> None:
        for field, values in zip(self._fields, made):
            array = vtk.array_of(values, field.name)
            for i, name in enumerate(field.component_names):
                if name is not None:
                    array.SetComponentName(i, name)
            index = output.AddArray(array)
            if field.attribute >= 0:
                output.SetActiveAttribute(index, field.attribute)
        if self._chosen["NullPointsStrategy"] == _MASK:
            mask = vtk.copy_as("vtkCharArray", made[-1], self._chosen["ValidPointsMaskArrayName"])
            output.AddArray(mask)


def _fields_of(data: Any, count: int, excluded: Collection[str]) -> Iterator[_Field]:
    # Of the attributes, these stay what they are between the points.
    kept = data.SCALARS, data.VECTORS, data.TENSORS, data.TCOORDS
    for i in range(data.GetNumberOfArrays()):
        array, attribute = data.GetArray(i), data.IsArrayAnAttribute(i)
        if array is None or array.GetNumberOfTuples() < count or attribute in (data.GLOBALIDS, data.PEDIGREEIDS):
            continue
        name = array.GetName() or ""
        if name == data.GhostArrayName() or name in excluded:
            continue
        size = array.GetNumberOfComponents()
        values = vtk.values_of(array).reshape(-1, size)[:count]
        names = [array.GetComponentName(k) for k in range(size)] if array.HasAComponentName() else []
        yield _Field(name, attribute if attribute in kept else -1, values, names)


def _type_of(values: NDArray[Any]) -> Any:
    return np.float32 if values.dtype == np.float32 else np.float64


def _parts(count: int, size: int) -> Iterator[tuple[int, int]]:
    return ((begin, min(begin + size, count)) for begin in range(0, count, size))
