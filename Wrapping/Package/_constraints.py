# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Users' polylines and polygons as the engine's constraints: pairs of ids, those of polygons last."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Literal, NamedTuple, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import choice_of
from ._errors import InputError, warn_caller
from ._geometries import Degenerate, Degenerates
from ._input import ids_of, is_array_like, points_of, refuse_geometry
from ._results import Floats, Ids, NonFinite, Polygons, Progress, frozen, ignores, refrozen, run, settings


class SplitConstraints(NamedTuple):
    """Constraints in pieces that do not cross, for regular_triangulation(split.points, constraints=split).

    Attributes
    ----------
    points : ndarray of n by 2
        the caller's points, then the new ones, where constraints cross: each coordinate rounded to the nearest double
    new_points : int
        how many are new
    constraints : ndarray of m by 2
        the ids that each piece joins
    constraint_of : ndarray
        the row of the caller's constraints that each piece is of: of polylines, all pairs of consecutive ids, then the
        sides of polygons
    sides : int
        the last so many are sides of polygons
    polygon_of : ndarray
        the caller's polygon that each of these is of
    degenerate : int
        how many polylines and polygons of too few ids were left out
    """

    points: Floats
    new_points: int
    constraints: Ids
    constraint_of: Ids
    sides: int
    polygon_of: Ids
    degenerate: int = 0

    def __reduce__(self) -> tuple[Any, ...]:
        return refrozen, (type(self), *self)


PolygonRule = Literal["even-odd", "direction"]
Chains = ArrayLike | Sequence[ArrayLike] | Polygons


class Constraints:
    """Constraints, and where they come from.

    Attributes
    ----------
    ends : ndarray of m by 2
        the ids of the points that each joins
    sides : int
        the last so many are sides of polygons
    by_direction : bool
        whether polygons define what is inside by their direction, or by the even-odd rule
    points : ndarray, optional
        the coordinates that ids are said to have
    degenerate : int
        how many polylines and polygons of too few ids were left out
    """

    points: NDArray[Any] | None = None

    def __init__(
        self,
        polylines: Chains | SplitConstraints | None,
        polygons: Chains | None,
        rule: PolygonRule = "even-odd",
        degenerate: Degenerate | None = None,
    ) -> None:
        self.by_direction = choice_of("polygon_rule", rule, ("even-odd", "direction")) == "direction"
        degenerates = Degenerates(degenerate)
        if isinstance(polylines, SplitConstraints):
            if polygons is not None:
                raise ValueError("constraints that were split have their polygons: leave polygons out")
            self.ends, self.sides = polylines.constraints, polylines.sides
            self._lines, self._polygons = np.arange(len(self.ends) - self.sides), polylines.polygon_of
            self._are_pairs, self.degenerate = True, polylines.degenerate
            return
        lines, self._lines = joined("constraints", polylines, False, degenerates)
        sides, self._polygons = joined("polygons", polygons, True, degenerates)
        self.degenerate = degenerates.count
        self.ends = frozen(np.concatenate([lines, sides]))
        self.sides = len(sides)
        self._are_pairs = np.array_equal(self._lines, np.arange(len(lines)))

    def of_error(self, error: InputError) -> InputError:
        """The engine's error, which names rows of all constraints; and where these are in the caller's own lists."""
        if error.code == "polygons_disagree":
            wrong, right = map(self._name_of, (error.index, error.count))
            sentence = "the polygons disagree about what is inside: " + (
                f"the sides of {wrong} disagree with each other, as where a ring crosses itself: pass "
                if wrong == right
                else f"reverse {wrong}, which disagrees with {right}, or pass "
            )
            return InputError(sentence + "polygon_rule='even-odd'", error.code, error.index, error.count)
        rows = {"constraint_point": [error.index], "constraints_cross": [error.index, error.count]}.get(error.code, [])
        names = [f"constraint {row} is of {self._name_of(row)}" for row in rows if not self._is_pair(row)]
        return InputError("; ".join([str(error), *names]), error.code, error.index, error.count)

    def polygon_of(self, rows: Ids) -> Ids:
        """The caller's polygons that these sides are of."""
        return self._polygons[rows - len(self._lines)]

    def warn_if_none(self, core: Any) -> None:
        """A warning where there are cells, and none is inside the polygons."""
        if core.dropped == 0 or core.inside().cell_count > 0:
            return
        hint = ""
        if self.by_direction:
            hint = ": what is on the left of a side is inside; reverse the polygons, or pass polygon_rule='even-odd'"
        warn_caller("no cell is inside the polygons, so none is left" + hint)

    def _is_pair(self, row: int) -> bool:
        return self._are_pairs and row < len(self._lines)

    def _name_of(self, row: int) -> str:
        lines = len(self._lines)
        return f"constraints[{self._lines[row]}]" if row < lines else f"polygons[{self._polygons[row - lines]}]"


def joined(what: str, values: Chains | None, are_closed: bool, degenerates: Degenerates) -> tuple[Ids, Ids]:
    """The pairs of consecutive ids, of the last and the first, too, if closed; and the number of each pair's chain."""
    chains_of = _chains(what, [] if values is None else values)
    offsets, ids = chains_of.offsets, chains_of.connectivity
    sizes, least = np.diff(offsets), 2 + are_closed
    counts = sizes.copy()
    if are_closed:  # without the first again
        several = np.flatnonzero(sizes > 1)
        counts[several] -= ids[offsets[several]] == ids[offsets[several + 1] - 1]
    kept = counts >= least
    if not kept.all():
        first, excluded = int(kept.argmin()), int((~kept).sum())
        sentence = f"{what}[{first}] has {counts[first]} id(s); it takes {least} or more{degenerates.advice}"
        degenerates.add(InputError(sentence, "bad_argument", first, excluded), excluded)
        ids, offsets = ids[np.repeat(kept, sizes)], np.concatenate([[0], np.cumsum(sizes[kept])])
    ends, chain_of = _core.constraints_along(offsets, ids, are_closed)
    return ends, np.flatnonzero(kept)[chain_of]


def _chains(what: str, values: Chains) -> Polygons:
    """Sequences of ids, one after another."""
    if isinstance(values, Polygons):
        return _checked(what, _flat(what, values.offsets), _flat(what, values.connectivity))
    refuse_geometry(values, what)
    if not is_array_like(values):
        raise TypeError(f"{what} are sequences of ids, not of type {type(values).__name__}")
    try:
        masked_rows = isinstance(values, Sequence) and any(map(np.ma.isMaskedArray, values))
        table = values if np.ma.isMaskedArray(values) else np.asarray(values, object if masked_rows else None)
    except ValueError:  # of several lengths
        table = np.empty(0, object)
    if table.dtype == object:
        chains = [_flat(f"{what}[{i}]", chain) for i, chain in enumerate(cast(Iterable[ArrayLike], values))]
        return Polygons(np.cumsum([0, *map(len, chains)]), np.concatenate([np.empty(0, np.int64), *chains]))
    if table.size == 0 and table.ndim == 1:
        table = table.reshape(0, 2)
    if table.ndim != 2:
        raise ValueError(f"{what} are sequences of ids, one for each, not an array of shape {table.shape}")
    rows, size = table.shape
    return Polygons(size * np.arange(rows + 1), ids_of(table, f"the ids of {what}").reshape(-1))


def _flat(what: str, values: ArrayLike) -> Ids:
    ids = ids_of(values, f"the ids of {what}")
    if ids.ndim != 1:
        raise ValueError(f"the ids of {what} are an array of one dimension, not of shape {ids.shape}")
    return ids


def _checked(what: str, offsets: Ids, ids: Ids) -> Polygons:
    """From where the first begins to where the last ends."""
    least = np.concatenate([[0], offsets[:-1]])
    wrong = (offsets < least) | (offsets > len(ids))
    if wrong.any() or not len(offsets):
        first = int(wrong.argmax()) if len(offsets) else -1
        found = f"offset {first} is {offsets[first]}" if len(offsets) else "there are none"
        sentence = f"the offsets of {what} ascend from 0 to {len(ids)}, the number of their ids, but {found}"
        raise InputError(sentence, "bad_argument", first, int(wrong.sum()))
    return Polygons(offsets - offsets[0], ids[offsets[0] : offsets[-1]])


def split_crossings(
    points: ArrayLike,
    constraints: Chains | None = None,
    polygons: Chains | None = None,
    *,
    threads: int = 0,
    non_finite: NonFinite = "error",
    degenerate: Degenerate = "error",
    progress: Progress = None,
) -> SplitConstraints:
    """Splits constraints where they cross, at new points, which are rounded.

    Parameters
    ----------
    points, constraints, polygons, threads, non_finite, degenerate, progress
        as for regular_triangulation()

    Raises
    ------
    InputError
        names the first point at fault, or the constraint
    """
    array, left_out = points_of(points, ignores(non_finite))
    given = Constraints(constraints, polygons, degenerate=degenerate)
    chosen = settings(threads, "triangles", non_finite, "cpu", progress, left_out)
    try:
        pieces, constraint_of, sides, positions = run(chosen, _core.split_crossings, array, given.ends, given.sides)
    except InputError as error:
        raise given.of_error(error) from None
    whole = frozen(np.vstack([np.asarray(array)[:, :2].astype(np.float64), positions]))
    polygon_of = frozen(given.polygon_of(constraint_of[len(constraint_of) - sides :]))
    return SplitConstraints(whole, len(positions), pieces, constraint_of, sides, polygon_of, given.degenerate)
