# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the results have in common: frozen, and worked out when asked for."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._input import points_of

Ids = NDArray[np.int64]
Floats = NDArray[np.float64]
Progress = Callable[[float], Any] | bool | None

ENGINES = {"automatic": 0, "cpu": 1, "cuda": 2}


# What work that nobody watches is done with.
QUIET = _core.Settings(0, False, False, 1, None)


class Polygons(NamedTuple):
    """Polygons of several sizes: polygon i has the corners connectivity[offsets[i]:offsets[i + 1]]."""

    offsets: Ids
    connectivity: Ids


class Validation(NamedTuple):
    """A judgement, true if all is right.

    Attributes
    ----------
    fault : str
        what is wrong, or "none"
    index : int
        the cell, the vertex or the point at fault; -1 if there is none
    """

    right: bool
    fault: str
    index: int

    def __bool__(self) -> bool:
        return self.right


class Frozen:
    """Attributes are set by the class alone."""

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"{type(self).__name__} is frozen: {name} cannot be set")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"{type(self).__name__} is frozen: {name} cannot be deleted")


class Cells(Frozen):
    """Cells over some of the caller's points.

    Attributes
    ----------
    points : ndarray
        the caller's points, as the engine reads them: not a copy, where that was not needed
    """

    points: NDArray[Any]
    _core: Any
    _ignores: bool

    def __init__(self, points: NDArray[Any], core: Any, ignores: bool) -> None:
        fields = self.__dict__
        fields["points"], fields["_core"], fields["_ignores"] = points, core, ignores

    @cached_property
    def simplices(self) -> Ids:
        """The cells as rows of ids; those of more than three corners as fans of triangles."""
        corners: Ids = self._triangles.corners()
        return corners.reshape(-1, min(self.dimension, 2) + 1) if self.dimension >= 0 else corners.reshape(0, 0)

    @cached_property
    def neighbors(self) -> Ids:
        """For each corner of each of `simplices` the simplex opposite to it, -1 where there is none."""
        across: Ids = self._triangles.neighbors().reshape(self.simplices.shape)
        # The engine tells, for each corner, who is across the edge to the next one; of segments, who is at it.
        return frozen(np.roll(across, 2 if self.simplices.shape[1] == 3 else 1, axis=1))

    @property
    def nsimplex(self) -> int:
        """How many `simplices` there are."""
        return len(self.simplices)

    @cached_property
    def _triangles(self) -> Any:
        return self._core.triangles()

    @property
    def ndim(self) -> int:
        """How many coordinates the points have."""
        return int(self.points.shape[1])

    @property
    def npoints(self) -> int:
        """How many points were given."""
        return len(self.points)

    @property
    def dimension(self) -> int:
        """Of what the points span: 0 a point, 1 a line, 2 a plane, 3 space; -1: there was no point."""
        return int(self._core.dimension)

    @cached_property
    def statistics(self) -> dict[str, float]:
        """Counts and seconds of the run, by the names that Documentation/Statistics.md explains."""
        return named(self._core.statistics)


def named(statistics: dict[str, float]) -> dict[str, float]:
    """The engine's figures by their names in Python."""
    return {re.sub(r"(?<=[a-z])(?=[A-Z0-9])", "_", name).lower(): value for name, value in statistics.items()}


def frozen(array: NDArray[Any]) -> NDArray[Any]:
    """The array, which nobody can change any more."""
    array.flags.writeable = False
    return array


def settings(
    threads: int, facets: str, non_finite: str, engine: str, progress: Progress, ignores: bool
) -> tuple[Any, Any]:
    """The engine's options; and a tqdm bar to close, or None."""
    bar = None
    if progress is True:
        bar = Bar()
        progress = bar
    elif progress is False:
        progress = None
    if progress is not None and not callable(progress):
        raise TypeError(f"progress is a callable, True or None, not {progress!r}")
    try:
        number = ENGINES[engine]
    except (KeyError, TypeError):
        raise ValueError(f"engine is one of {', '.join(map(repr, ENGINES))}, not {engine!r}") from None
    if facets != "triangles" and facets != "polygons":
        raise ValueError(f"facets is one of 'triangles', 'polygons', not {facets!r}")
    if threads.__class__ is not int:
        threads = _whole(threads)
    if threads < 0 or threads > 2**31 - 1:
        raise ValueError(f"threads is 0 (all) or more, not {threads}")
    return _core.Settings(threads, facets == "polygons", ignores, number, progress), bar


def ignores(non_finite: str) -> bool:
    """Whether points that are not finite are left out."""
    if non_finite == "error":
        return False
    if non_finite == "ignore":
        return True
    raise ValueError(f"non_finite is one of 'error', 'ignore', not {non_finite!r}")


def run(settings_and_bar: tuple[Any, Any], call: Any, *arguments: Any) -> Any:
    """The call's result; the bar, if there is one, is closed in any case."""
    chosen, bar = settings_and_bar
    if bar is None:
        return call(*arguments, chosen)
    with bar:
        return call(*arguments, chosen)


def answers(
    ask: Any,
    places: Any,
    columns: tuple[int, ...],
    threads: int,
    non_finite: str,
    progress: Progress,
    *before: Any,
) -> Any:
    """What ask() tells of each place; of one place, its answer alone.

    columns: how many coordinates places may have. before: arguments of ask() before the places
    """
    one = np.ndim(places) == 1 and len(places) > 0
    array, left_out = points_of([places] if one else places, ignores(non_finite))
    if len(array) and array.shape[1] not in columns:
        raise ValueError(f"places have {columns[0]} coordinates here, not {array.shape[1]}")
    chosen = settings(threads, "triangles", non_finite, "cpu", progress, left_out)
    found = run(chosen, ask, *before, array)
    return found[0] if one else found


def _whole(threads: Any) -> int:
    try:
        return int(threads.__index__())
    except AttributeError:
        raise TypeError(f"threads is an integer, not {threads!r}") from None


class Bar:
    """tqdm's bar, as a progress callable."""

    def __init__(self) -> None:
        from tqdm.auto import tqdm

        self._bar = tqdm(total=100, unit="%", bar_format="{l_bar}{bar}| {elapsed}")

    def __call__(self, fraction: float) -> None:
        self._bar.update(round(100 * fraction) - self._bar.n)

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: Any, *_: Any) -> None:
        if kind is None:
            self(1.0)
        self._bar.close()
