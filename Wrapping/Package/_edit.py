# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Triangulations that are edited: points are inserted, moved and removed, and constraints."""

from __future__ import annotations

import threading
from collections.abc import Callable
from functools import wraps
from typing import Any, Concatenate, ParamSpec, Self, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._constrained import ConstrainedTriangulation
from ._constraints import Chains, Constraints
from ._errors import InputError
from ._input import array_of, ids_of, points_and_weights_of
from ._queries import Numbers
from ._results import Floats, Ids, NonFinite, Progress, frozen, ignores, run, settings
from ._triangulation import RegularTriangulation

P = ParamSpec("P")
R = TypeVar("R")


class _Guard:
    """Waits for other threads' calls. What an edit itself calls may not use the triangulation."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._holder: int | None = None

    def __enter__(self) -> None:
        here = threading.get_ident()
        if self._holder == here:
            raise RuntimeError("this triangulation is being edited: a progress callable must not use it")
        self._lock.acquire()
        self._holder = here

    def __exit__(self, *_: object) -> None:
        self._holder = None
        self._lock.release()


def _of_snapshot(
    query: Callable[Concatenate[RegularTriangulation, P], R],
) -> Callable[Concatenate[EditableTriangulation, P], R]:
    """A method that calls the snapshot's of the same name."""
    name = query.__name__

    @wraps(query)
    def method(self: EditableTriangulation, /, *args: P.args, **kwargs: P.kwargs) -> R:
        return getattr(self.snapshot(), name)(*args, **kwargs)  # a constrained triangulation may have its own

    return method


class EditableTriangulation:
    """A regular or constrained triangulation of points that come and go.

    At every moment it is the one that regular_triangulation() gives of the points that are there, bit for bit. A
    point's id is given once, in order from 0: a removed one is not given again, and a point that is moved keeps its
    id. So is a constraint's number.

    An edit of one point costs what it changes: about a microsecond near the last edit, a few elsewhere, and one or two
    of Python's; of many points at once, the engine's time alone. `snapshot()` costs all cells; it is kept until the
    next edit, and `simplices`, `locate()` and the other queries are those of the snapshot. Values at points are by id,
    of which those that no point has are not used.

    It can be pickled and copied. Calls from several threads wait for each other.

    Parameters
    ----------
    points : n by 2, or n by 3, or a RegularTriangulation, optional
        x and y count; by default there is no point. Of a triangulation, the points with their ids, the weights, and the
        constraints, sides of polygons among them, by their numbers.
    weights : n numbers, optional
        as for regular_triangulation(): with them, a point may be hidden until others are gone
    constraints : m by 2 ids, or a sequence of polylines, optional
        as for add_constraints()
    threads, non_finite, progress
        see the module; a point that is left out has the id of a removed one

    Attributes
    ----------
    divided_edges : int
        how many points of the last insertion or move are inside constraints: each divides a fixed edge; 0 while all
        points are on one line
    """

    def __init__(
        self,
        points: ArrayLike | RegularTriangulation | None = None,
        weights: ArrayLike | None = None,
        *,
        constraints: Chains | None = None,
        threads: int = 0,
        non_finite: NonFinite = "error",
        progress: Progress = None,
    ) -> None:
        if isinstance(points, RegularTriangulation):
            if weights is not None or constraints is not None:
                raise ValueError("a triangulation has its weights and constraints: leave them out")
            weights, constraints = points.weights, getattr(points, "constraints", None)
            non_finite = "ignore" if points._ignores else non_finite
            points = points._sites
        given = np.empty((0, 2)) if points is None else points
        array, weight_array, left_out = points_and_weights_of(given, weights, ignores(non_finite))
        chosen = settings(threads, "triangles", non_finite, "cpu", progress, left_out)
        self._core = run(chosen, _core.EditableTriangulation, array, weight_array)
        self._begin()
        if constraints is not None:
            self.add_constraints(constraints)

    def insert(
        self,
        points: ArrayLike,
        weights: ArrayLike | None = None,
        *,
        threads: int = 0,
        progress: Progress = None,
    ) -> Numbers:
        """Inserts points: an array of shape (n, 2), or one point. A point on a constraint divides an edge.

        Returns
        -------
        their ids; of one point, its id
        """
        one = _one_point(points, weights)
        if one is not None:
            with self._guard:
                first = self._core.insert_one(*one)
                self._snapshot = None
            return np.int64(first)
        array, weight_array, single = _points_of(points, weights)
        with self._guard:
            first = run(_chosen(threads, progress), self._core.insert, array, weight_array)
            self._snapshot = None
        ids = np.arange(first, first + len(array))
        return np.int64(first) if single else ids

    def remove(self, ids: ArrayLike, *, threads: int = 0, progress: Progress = None) -> None:
        """Removes points. One that a constraint ends at is an InputError: remove the constraint first."""
        if isinstance(ids, (int, np.integer)):
            with self._guard:
                self._core.remove_one(int(ids))
                self._snapshot = None
            return
        numbers = _ids_of(ids, "ids")
        with self._guard:
            run(_chosen(threads, progress), self._core.remove, numbers)
            self._snapshot = None

    def move(
        self,
        ids: ArrayLike,
        points: ArrayLike,
        weights: ArrayLike | None = None,
        *,
        threads: int = 0,
        progress: Progress = None,
    ) -> None:
        """Moves points, and constraints with their ends. Without weights, these stay."""
        numbers = _ids_of(ids, "ids")
        array, weight_array, _ = _points_of(points, weights)
        if len(numbers) != len(array):
            raise ValueError(f"there are not as many ids as points: {len(numbers)} ids, {len(array)} points")
        with self._guard:
            run(_chosen(threads, progress), self._core.move, numbers, array, weight_array)
            self._snapshot = None

    def add_constraints(self, constraints: Chains, *, progress: Progress = None) -> Ids:
        """Adds constraints: rows of two ids, or polylines, sequences of ids, of which consecutive ones are joined.

        There are constraints, or weights other than 0, not both.

        Returns
        -------
        a number for each pair
        """
        given = Constraints(constraints, None)
        with self._guard:
            try:
                first = run(_chosen(1, progress), self._core.insert_constraints, given.ends)
            except InputError as error:
                # Of two that cross, the other is there already, with its own number.
                raise error if error.code == "constraints_cross" else given.of_error(error) from None
            self._snapshot = None
        return np.arange(first, first + len(given.ends))

    def remove_constraints(self, numbers: ArrayLike, *, progress: Progress = None) -> None:
        """Removes constraints by their numbers."""
        chosen = _ids_of(numbers, "numbers")
        with self._guard:
            run(_chosen(1, progress), self._core.remove_constraints, chosen)
            self._snapshot = None

    def snapshot(self) -> RegularTriangulation:
        """The triangulation as it is now: a result that later edits do not change.

        Its `points` have a row for each id, NaN where there is no point. With constraints, it is a
        ConstrainedTriangulation, and `constraint_numbers` are the numbers of the rows of its `constraints`.
        """
        with self._guard:
            if self._snapshot is None:
                self._snapshot = self._made()
            return self._snapshot

    def copy(self) -> Self:
        """A triangulation of its own."""
        return self.__copy__()

    @property
    def points(self) -> Floats:
        """A row of x and y for each id; NaN where there is no point."""
        return self.snapshot().points

    @property
    def weights(self) -> Floats | None:
        """A number for each id; None if no weight was ever given."""
        return self.snapshot().weights

    @property
    def ids(self) -> Ids:
        """The ids of the points that are there, ascending."""
        return frozen(np.flatnonzero(~np.isnan(self.points[:, 0])))

    @property
    def constraints(self) -> Ids:
        """The ids that each constraint joins, by ascending numbers."""
        with self._guard:
            return self._core.constraints()[1]

    @property
    def constraint_numbers(self) -> Ids:
        """The numbers of the constraints, ascending."""
        with self._guard:
            return self._core.constraints()[0]

    @property
    def divided_edges(self) -> int:
        with self._guard:
            return int(self._core.divided_edges)

    @property
    def dimension(self) -> int:
        """Of what the points span: 0 a point, 1 a line, 2 a plane; -1: there is no point."""
        return self.snapshot().dimension

    @property
    def simplices(self) -> Ids:
        """As RegularTriangulation has them."""
        return self.snapshot().simplices

    @property
    def neighbors(self) -> Ids:
        """As RegularTriangulation has them."""
        return self.snapshot().neighbors

    @property
    def edges(self) -> Ids:
        """As RegularTriangulation has them."""
        return self.snapshot().edges

    @property
    def vertices(self) -> Ids:
        """Ids of the points that appear, ascending."""
        return self.snapshot().vertices

    @property
    def hidden(self) -> Ids:
        """Ids of the points that are there and do not appear, ascending."""
        return self.snapshot().hidden

    locate = _of_snapshot(RegularTriangulation.locate)
    nearest = _of_snapshot(RegularTriangulation.nearest)
    interpolate = _of_snapshot(RegularTriangulation.interpolate)
    natural_neighbours = _of_snapshot(RegularTriangulation.natural_neighbours)
    to_image = _of_snapshot(RegularTriangulation.to_image)

    def __len__(self) -> int:
        with self._guard:
            return int(self._core.point_count)

    def __contains__(self, point: object) -> bool:
        with self._guard:
            return isinstance(point, (int, np.integer)) and bool(self._core.contains(int(point)))

    def __copy__(self) -> Self:
        other = type(self).__new__(type(self))
        with self._guard:
            other._core = self._core.copy()
        other._begin()
        return other

    def __deepcopy__(self, _: Any) -> Self:
        return self.__copy__()

    def __getstate__(self) -> tuple[Any, ...]:
        with self._guard:
            weights = self._core.weights() if self._weighted() else None
            return (self._core.points(), weights, *self._core.constraints(), self._core.constraint_number_count)

    def __setstate__(self, state: tuple[Any, ...]) -> None:
        points, weights, numbers, ends, count = state
        self._core = run(
            settings(0, "triangles", "ignore", "cpu", None, True), _core.EditableTriangulation, points, weights
        )
        self._begin()
        self._core.restore_constraints(numbers, ends, count, _chosen(1, None)[0])

    def __repr__(self) -> str:
        with self._guard:
            points, constraints = self._core.point_count, self._core.constraint_count
        return f"<EditableTriangulation of {points} points, {constraints} constraints>"

    def _begin(self) -> None:
        self._guard = _Guard()
        self._snapshot: RegularTriangulation | None = None

    def _weighted(self) -> bool:
        return bool(np.any(np.nan_to_num(self._core.weights())))

    def _made(self) -> RegularTriangulation:
        made = run(_chosen(0, None), self._core.snapshot)
        points = self._core.points()
        gone = len(points) > self._core.point_count
        if self._core.constraint_count == 0:
            weights = self._core.weights() if self._weighted() else None
            return RegularTriangulation._of(points=points, weights=weights, _core=made, _ignores=gone)
        return ConstrainedTriangulation._of(
            points=points,
            weights=None,
            constraints=self._core.constraints()[1],
            dropped=0,
            _whole=made,
            _core=made.inside(),
            _sides=0,
            _by_direction=False,
            _ignores=gone,
        )


def _chosen(threads: int, progress: Progress) -> tuple[Any, Any]:
    return settings(threads, "triangles", "error", "cpu", progress, False)


def _one_point(points: ArrayLike, weights: ArrayLike | None) -> tuple[float, float, float] | None:
    """The numbers of one point in a usual form, which are read in less time; else None."""
    if weights is not None and type(weights) is not float:
        return None
    if isinstance(points, np.ndarray):
        if points.shape != (2,) or points.dtype != np.float64 or type(points) is not np.ndarray:
            return None
    elif type(points) not in (list, tuple) or len(points) != 2 or not all(type(x) is float for x in points):
        return None
    return float(points[0]), float(points[1]), weights or 0.0


def _points_of(points: ArrayLike, weights: ArrayLike | None) -> tuple[NDArray[Any], NDArray[Any] | None, bool]:
    """Rows of points, their weights, and whether there is one point alone."""
    array = array_of(points, "coordinates")
    single = array.ndim == 1 and array.shape[0] in (2, 3)
    if single:
        array = array.reshape(1, -1)
        weights = None if weights is None else np.reshape(np.asarray(weights), (-1,))
    rows, weight_array, _ = points_and_weights_of(array, weights, False)
    return rows, weight_array, single


def _ids_of(values: ArrayLike, what: str) -> Ids:
    ids = ids_of([values] if isinstance(values, (int, np.integer)) else values, what)
    if ids.ndim > 1:
        raise ValueError(f"{what} are an integer, or an array of one dimension, not of shape {ids.shape}")
    return ids.reshape(-1)
