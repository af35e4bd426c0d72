# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the results have in common: frozen, and computed when first used."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import cached_property
from typing import Any, ClassVar, Literal, NamedTuple, Self, overload

import numpy as np
from numpy.typing import NDArray

from . import _core

Ids = NDArray[np.int64]
Floats = NDArray[np.float64]
Progress = Callable[[float], Any] | bool | None
Report = Callable[[float], Any] | None
Facets = Literal["triangles", "polygons"]
NonFinite = Literal["error", "ignore"]
Engine = Literal["automatic", "cpu", "cuda"]

ENGINES = {"automatic": 0, "cpu": 1, "cuda": 2}


# What work that nobody watches is done with.
QUIET = _core.Settings(0, False, False, 1, None)


class Validation(NamedTuple):
    """A verdict, true if all is right.

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
    """Attributes are set by the class alone.

    Results compare by identity, as scipy's do. They can be pickled and copied; a copy has its own points, read-only.
    """

    _call: ClassVar[str] = ""  # the call that gives such a result

    def __init__(self, *_: Any, **__: Any) -> None:
        raise TypeError(f"{type(self).__name__} is the type of a result: call {self._call}")

    @classmethod
    def _of(cls, **fields: Any) -> Self:
        made = cls.__new__(cls)
        made.__dict__.update(fields)
        return made

    def __copy__(self) -> Self:
        return self

    def __getstate__(self) -> dict[str, Any]:
        """The fields, less what is computed when first used."""
        kind = type(self)
        return {
            name: np.array(value) if isinstance(value, np.ndarray) and type(value) is not np.ndarray else value
            for name, value in self.__dict__.items()
            if not isinstance(getattr(kind, name, None), cached_property)
        }

    def __setstate__(self, state: dict[str, Any]) -> None:
        for value in state.values():
            if isinstance(value, np.ndarray):
                frozen(value)
        self.__dict__.update(state)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"{type(self).__name__} is frozen: {name} cannot be set")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"{type(self).__name__} is frozen: {name} cannot be deleted")


class Polygons(Frozen, Sequence[Ids]):
    """Polygons of any sizes: a sequence of arrays, which have the ids of the corners of one polygon each.

    Attributes
    ----------
    offsets : ndarray
        polygon i has the corners connectivity[offsets[i]:offsets[i + 1]]
    connectivity : ndarray
        the corners of all polygons, one after another
    """

    offsets: Ids
    connectivity: Ids

    def __init__(self, offsets: Ids, connectivity: Ids) -> None:
        self.__dict__.update(offsets=np.asanyarray(offsets), connectivity=np.asanyarray(connectivity))

    def __len__(self) -> int:
        return max(0, len(self.offsets) - 1)

    @overload
    def __getitem__(self, index: int) -> Ids: ...

    @overload
    def __getitem__(self, index: slice) -> list[Ids]: ...

    def __getitem__(self, index: int | slice) -> Ids | list[Ids]:
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        at = index + len(self) if index < 0 else index
        if not 0 <= at < len(self):
            raise IndexError(f"polygon {index} of {len(self)}")
        return self.connectivity[self.offsets[at] : self.offsets[at + 1]]

    def __iter__(self) -> Iterator[Ids]:
        offsets = self.offsets.tolist()
        return (self.connectivity[begin:end] for begin, end in zip(offsets, offsets[1:]))

    def __repr__(self) -> str:
        return f"<Polygons: {len(self)}, of {len(self.connectivity)} corners>"


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

    @classmethod
    def _made(cls, points: NDArray[Any], core: Any, ignores: bool) -> Self:
        return cls._of(points=points, _core=core, _ignores=ignores)

    @cached_property
    def simplices(self) -> Ids:
        """The cells as rows of ids; those of more than three corners as fans of triangles."""
        corners: Ids = self._triangles.corners()
        return corners.reshape(-1, min(self.dimension, 2) + 1) if self.dimension >= 0 else corners.reshape(0, 0)

    @cached_property
    def neighbors(self) -> Ids:
        """For each corner of each of `simplices` the simplex opposite to it, -1 where there is none."""
        across: Ids = self._triangles.neighbors().reshape(self.simplices.shape)
        # The engine returns, for each corner, the cell across the edge to the next one; of segments, the cell at it.
        return frozen(np.roll(across, 2 if self.simplices.shape[1] == 3 else 1, axis=1))

    @cached_property
    def edges(self) -> Ids:
        """The edges of `simplices`, each once, as ids, the lower one first; in lexicographic order.

        These have the diagonals that divide facets of more corners.
        """
        return edges_of(self.simplices)

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


def refrozen(kind: type[Any], *fields: Any) -> Any:
    """A copy of a result that is a named tuple: its arrays are read-only, too."""
    for field in fields:
        if isinstance(field, np.ndarray):
            frozen(field)
    return kind(*fields)


def distinct(values: NDArray[Any]) -> NDArray[Any]:
    """Each value once, ascending. numpy.unique hashes integers from NumPy 2.3 on, and takes up to 100 times as long."""
    found = np.sort(values, axis=None)
    return found[np.append(True, found[1:] != found[:-1])[: len(found)]]


def edges_of(simplices: Ids) -> Ids:
    """Each edge of simplices once, as ids, the lower one first; in lexicographic order."""
    corners = simplices.shape[1]
    pairs = [simplices[:, [i, j]] for i in range(corners) for j in range(i + 1, corners)]
    ends = np.sort(np.concatenate([np.empty((0, 2), np.int64), *pairs]), axis=1).astype(np.uint64)
    most = np.uint64(1 + ends.max(initial=0))  # less than 2^32
    keys = distinct(ends[:, 0] * most + ends[:, 1])
    return frozen(np.column_stack([keys // most, keys % most]).astype(np.int64))


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


def _whole(threads: Any) -> int:
    try:
        return int(threads.__index__())
    except AttributeError:
        raise TypeError(f"threads is an integer, not {threads!r}") from None


class Bar:
    """tqdm's bar, as a progress callable."""

    def __init__(self) -> None:
        try:
            from tqdm.auto import tqdm
        except ImportError as error:
            raise ModuleNotFoundError(
                "progress=True shows tqdm's bar: pip install tqdm, or give a callable of the fraction that is done"
            ) from error

        self._bar = tqdm(total=100, unit="%", bar_format="{l_bar}{bar}| {elapsed}")

    def __call__(self, fraction: float) -> None:
        self._bar.update(round(100 * fraction) - self._bar.n)

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: Any, *_: Any) -> None:
        if kind is None:
            self(1.0)
        self._bar.close()


@contextmanager
def report_of(progress: Progress) -> Iterator[Report]:
    """What the engine reports progress to: the caller's, a bar, or nothing."""
    if progress is not True:
        if progress is not None and progress is not False and not callable(progress):
            raise TypeError(f"progress is a callable, True or None, not {progress!r}")
        yield progress or None
        return
    bar = Bar()
    with bar:
        yield bar


def stretch(report: Report, begin: float, end: float) -> Report:
    """Reports a part's progress as that of the whole."""
    if report is None:
        return None
    whole = report
    return lambda fraction: whole(begin + fraction * (end - begin))
