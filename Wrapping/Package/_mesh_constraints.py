# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Constraints of a mesh's points: the lines and polygons of another mesh, or sequences of ids."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._constraints import Constraints, PolygonRule
from ._errors import InputError
from ._geometries import Degenerate, Lines
from ._meshes import Cloud
from ._results import Polygons
from ._vtkmodules import values_of


def constraints_of_call(
    value: Any, rule: PolygonRule, composite: bool, weighted: bool, degenerate: Degenerate
) -> Constraints | None:
    """What the argument of this name tells; None: nothing."""
    if value is None:
        return None
    if composite:
        raise TypeError("constraints have the ids of one data set's points, and the mesh is a composite")
    if weighted:
        raise ValueError("constraints take no weights and no radii")
    if not hasattr(value, "IsA"):
        return Constraints(value, None, rule, degenerate)
    if not value.IsA("vtkPolyData"):
        raise TypeError(f"constraints are a PolyData, or sequences of ids, not a {value.GetClassName()}")
    given = Constraints(chains_of(value.GetLines()), chains_of(value.GetPolys()), rule, degenerate)
    if value.GetNumberOfPoints() > 0:
        given.points = values_of(value.GetPoints().GetData()).reshape(-1, 3)
    return given


def count_degenerate(made: Any, given: Constraints | Lines | None, degenerate: Degenerate) -> None:
    """Gives a mesh the count of what was left out, where that was asked for."""
    if given is not None and degenerate == "ignore":
        made.field_data["DegenerateLines"] = [given.degenerate]


class CloudConstraints:
    """Constraints of the points that the engine is given, some of the caller's.

    Attributes
    ----------
    ends : ndarray of m by 2
        rows of the cloud's array
    sides : int
        the last so many are sides of polygons
    """

    def __init__(self, given: Constraints, cloud: Cloud, flat: bool) -> None:
        self._given = given
        self._cloud = cloud
        self.ends = given.ends
        self.sides = given.sides
        self.by_direction = given.by_direction
        if given.points is not None:
            self._require_points(given.points, 2 if flat else 3)
        ids = cloud.ids(np.arange(len(cloud.array)))
        if len(ids) < cloud.count:
            rows = np.searchsorted(ids, self.ends)
            found = np.append(ids, -1)[rows] == self.ends
            if not found.all():
                row, end = np.argwhere(~found)[0]
                point = int(self.ends[row, end])
                sentence = f"constraint {row} ends at point {point}, which is not there or is left out"
                raise given.of_error(InputError(sentence, "constraint_point", int(row), point))
            self.ends = rows

    def _require_points(self, points: NDArray[Any], dimensions: int) -> None:
        """The constraints' own points are those of the mesh, at all ids."""
        ends = self.ends.reshape(-1)
        known = (ends >= 0) & (ends < self._cloud.count)  # of others, the engine tells
        ids = ends[known]
        there = ids < len(points)
        own = np.full((len(ids), dimensions), np.inf)
        own[there] = points[ids[there], :dimensions]
        given = self._cloud.rows(ids)[:, :dimensions]
        width = given.shape[1]
        differ = ~there | ~((own[:, :width] == given) | (np.isnan(own[:, :width]) & np.isnan(given))).all(axis=1)
        if not differ.any():
            return
        at = int(differ.argmax())
        point, row = int(ids[at]), int(np.flatnonzero(known)[at]) // 2
        where = f"at {tuple(points[point].tolist())}" if there[at] else "not there"
        sentence = (
            f"point {point} of constraints is {where}, and point {point} of the mesh is at "
            f"{tuple(self._cloud.rows(ids[at : at + 1])[0].tolist())}. The ids of constraints are those of the mesh's "
            f"points, so at these ids their {len(points)} points must be those of the mesh, of which there are "
            f"{self._cloud.count}; or pass constraints as sequences of ids. If their points are their own, call "
            "constrained_triangulation(), or terrain_mesh() with them as lines"
        )
        raise self._given.of_error(InputError(sentence, "constraint_point", row, point))

    def engine(self, call: Callable[..., Any], *arguments: Any) -> Any:
        """The engine's result; its errors about constraints tell the caller's points."""
        try:
            return call(*arguments)
        except InputError as error:
            raise self._translated(error) from None

    def warn_if_none(self, core: Any) -> None:
        self._given.warn_if_none(core)

    def _translated(self, error: InputError) -> InputError:
        message, index, count = str(error), error.index, error.count
        if error.code == "constraint_point" and count < len(self._cloud.array):
            (point,) = self._ids(count)
            message, count = message.replace(f"point {count}", f"point {point}"), point
        return self._given.of_error(InputError(message, error.code, index, count))

    def _ids(self, *rows: int) -> list[int]:
        return [int(point) for point in self._cloud.ids(np.array(rows))]


def chains_of(cells: Any) -> Polygons:
    """The points of cells, as ids."""
    return Polygons(
        values_of(cells.GetOffsetsArray()).astype(np.int64), values_of(cells.GetConnectivityArray()).astype(np.int64)
    )
