# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lines and polygons of an algorithm's source, as constraints of its input's points, or of points of their own."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._errors import FlipFlopError, InputError
from ._filter_errors import ConstraintError
from ._input import points_of
from ._meshes import Cloud, block_of, corners_of
from ._results import Ids

# As vtkFFAlgorithm.SourcePointsType.
_AUTOMATIC, _OWN = 0, 2


class Advice(NamedTuple):
    """What errors say to do: where constraints cross, where a point is a ghost, where polygons disagree."""

    split: str = "turn on Split Crossing Constraints"
    ghosts: str = "Turn off Skip Ghost Points"
    rule: str = "set Polygon Rule to Even-Odd"


@dataclass
class SourceRule:
    """How a source is read.

    Attributes
    ----------
    points : int
        whose points its cells name
    dimensions : int
        how many coordinates are compared: 2, if z does not matter, or 3
    closed_as_borders : bool
        whether closed lines are polygons
    has_setting, can_split : bool
        whether the algorithm has settings for whose points these are, and for splits; errors name them then
    owner : str
        how errors name what has the cells
    advice : Advice
    """

    points: int
    dimensions: int
    closed_as_borders: bool
    has_setting: bool = True
    can_split: bool = True
    owner: str = "source"
    advice: Advice = Advice()


@dataclass
class _Chains:
    """Cells, by where the corners of each begin, to the end; the points that these are; and the cells' numbers."""

    offsets: Ids
    ids: Ids
    numbers: Ids

    @classmethod
    def of(cls, cells: Any, first: int, owner: str) -> _Chains:
        offsets, ids = corners_of(cells, f"the {owner}'s cells")
        return cls(offsets, ids, first + np.arange(len(offsets) - 1))

    @property
    def sizes(self) -> Ids:
        return np.diff(self.offsets)

    def where(self, chosen: NDArray[np.bool_]) -> _Chains:
        """Only those that are chosen."""
        sizes = self.sizes
        return _Chains(_offsets_of(sizes[chosen]), self.ids[np.repeat(chosen, sizes)], self.numbers[chosen])

    def pairs(self, are_rings: bool = False) -> tuple[Ids, Ids]:
        """The ends of each segment, and the cell that it is of."""
        ends, chain_of = _core.constraints_along(self.offsets, self.ids, are_rings)
        return ends, self.numbers[chain_of]


class Source:
    """The constraints of a source.

    Attributes
    ----------
    is_own : bool
        whether they name points of the source, and not of the input
    ends : ndarray of m by 2
        rows of the source's points, or of the cloud's
    cell_of : ndarray
        the source's cell that each is of
    sides : int
        the last so many are sides of polygons
    """

    def __init__(self, mesh: Any, cloud: Cloud, rule: SourceRule, settings: Any) -> None:
        self._cloud, self._rule = cloud, rule
        self._own = rows_of_points(mesh, f"the {rule.owner}")
        self._kept = cloud.ids(np.arange(len(cloud.array)))
        first = mesh.GetNumberOfVerts()
        lines = _Chains.of(mesh.GetLines(), first, rule.owner)
        polygons = _Chains.of(mesh.GetPolys(), first + len(lines.numbers), rule.owner)
        corners = np.concatenate([lines.ids, polygons.ids])
        self.is_own = rule.points == _OWN or rule.points == _AUTOMATIC and self._are_own(corners)
        signs = np.zeros(len(lines.numbers), np.int8)
        if rule.closed_as_borders:
            signs = self._closed(lines, polygons, corners, settings)
        parts = lines.where(signs == 0).pairs(), lines.where(signs != 0).pairs(), polygons.pairs(True)
        ends, self.cell_of = (np.concatenate(some) for some in zip(*parts))
        self.sides = len(parts[1][0]) + len(parts[2][0])
        against = np.append(signs, np.zeros(len(polygons.numbers), np.int8))[self.cell_of - first] < 0
        ends[against] = ends[against][:, ::-1]
        self._require(ends.ravel(), np.repeat(self.cell_of, 2))
        self.ends = ends if self.is_own else np.searchsorted(self._kept, ends)

    @cached_property
    def points(self) -> NDArray[Any]:
        """The source's own points, as the engine reads them."""
        with of_source():
            return points_of(self._own, True)[0]

    def engine(self, call: Callable[..., Any], *arguments: Any, piece_of: Ids | None = None) -> Any:
        """The engine's result; its errors about constraints, or pieces of them, name cells."""
        try:
            return self._cloud.engine(call, *arguments)
        except FlipFlopError as error:
            sentence = self._sentence_of(error, piece_of)
            if not sentence:
                raise
            raise ConstraintError(sentence) from None

    def _are_own(self, corners: Ids) -> bool:
        """Whether some corners are no points of the input, or points at other places."""
        corners = corners[(corners >= 0) & (corners < len(self._own))]
        if (corners >= self._cloud.count).any():
            return True
        return not bool(self._are_same(corners, 3).all())

    def _are_same(self, ids: Ids, dimensions: int) -> NDArray[np.bool_]:
        own = self._own[ids, :dimensions].astype(np.float64)
        given = self._cloud.rows(ids)[:, :dimensions].astype(np.float64)
        same: NDArray[np.bool_] = ((own == given) | (np.isnan(own) & np.isnan(given))).all(axis=1)
        return same

    def _closed(self, lines: _Chains, polygons: _Chains, corners: Ids, settings: Any) -> NDArray[np.int8]:
        """For each line 1 if it is of a ring, -1 if it also runs against that, else 0."""
        sizes = np.concatenate([lines.sizes, polygons.sizes])
        self._require(corners, np.repeat(np.concatenate([lines.numbers, polygons.numbers]), sizes))
        positions = (self._own[corners] if self.is_own else self._cloud.rows(corners)).astype(np.float64)
        found: NDArray[np.int8] = _core.closed_lines(
            positions.reshape(-1, 3), _offsets_of(sizes), len(polygons.numbers), self._rule.dimensions, settings
        )
        return found[: len(lines.numbers)]

    def _require(self, ids: Ids, cells: Ids) -> None:
        """All points that cells name are there."""
        own, count = len(self._own), self._cloud.count
        if self.is_own:
            fault = (ids < 0) | (ids >= own)
        else:
            fault = (ids < 0) | (ids >= count)
            if own:
                both = ~fault & (ids < own)
                differ = ~both
                differ[both] = ~self._are_same(ids[both], self._rule.dimensions)
                fault |= differ
            if len(self._kept) < count:
                fault |= ~np.isin(ids, self._kept)
        if fault.any():
            first = int(fault.argmax())
            raise InputError(self._fault_of(int(ids[first]), self._name_of(int(cells[first]))), "bad_argument")

    def _fault_of(self, point: int, cell: str) -> str:
        own, count = len(self._own), self._cloud.count
        if not self.is_own and not 0 <= point < count:
            return (
                f"Point {point} of {cell} is not there: its ids are those of the input's points, of which there are "
                f"{count}."
            )
        if (self.is_own or own) and not 0 <= point < own:
            return f"Point {point} of {cell} is not there: the source has {own} point(s)."
        if own and not self._are_same(np.array([point]), self._rule.dimensions)[0]:
            advice = " If they are its own, set Source Points to Own Points." if self._rule.has_setting else ""
            return (
                f"Point {point} of {cell} is at {_words_of(self._own[point])}, and point {point} of the input is at "
                f"{_words_of(self._cloud.rows(np.array([point]))[0])}. The source's cells name points of the input by "
                f"id, so at these ids its {own} points must be those of the input, of which there are {count}; or it "
                f"has no points.{advice}"
            )
        return (
            f"Point {point} of {cell} is a ghost point, which is left out. {self._rule.advice.ghosts}, or take the cell "
            "away."
        )

    def _name_of(self, cell: int) -> str:
        return f"cell {cell} of the {self._rule.owner}"

    def _sentence_of(self, error: FlipFlopError, piece_of: Ids | None) -> str:
        def cell(row: int) -> str:
            return self._name_of(int(self.cell_of[row if piece_of is None else piece_of[row]]))

        if error.code == "constraint_point":
            point = error.count if self.is_own else int(self._kept[error.count])
            return f"Point {point} of {cell(error.index)} is left out: it has a coordinate that is NaN or infinite."
        if error.code == "constraints_cross":
            given = "input" if self._rule.owner == "source" else self._rule.owner
            both = "both" if self.is_own else f"the {given} and to both"
            advice = f", or {self._rule.advice.split}." if self._rule.can_split else "."
            return (
                f"An edge of {cell(error.index)} crosses one of {cell(error.count)}, and there is no point where they "
                f"do. Add one to {both}{advice}"
            )
        if error.code != "polygons_disagree":
            return ""
        wrong, right = cell(error.index), cell(error.count)
        if wrong == right:
            rule = self._rule.advice.rule
            end = f"The sides of {wrong} disagree with each other, as where a polygon crosses itself. {rule[0].upper()}"
            end += rule[1:]
        else:
            end = f"Reverse {wrong}, which disagrees with {right}, or {self._rule.advice.rule}"
        return (
            "The polygons disagree about what is inside: what is on the left of a side is inside, and holes run "
            f"clockwise. {end}."
        )


def rows_of_points(mesh: Any, name: str = "") -> NDArray[Any]:
    """The coordinates of a mesh's points, which errors call so."""
    return np.asarray(block_of(mesh, name).part.rows)  # type: ignore[union-attr]


@contextmanager
def of_source() -> Iterator[None]:
    """Errors about points, in here, are about the source's."""
    try:
        yield
    except InputError as error:
        error._where = f"point {error.index} of the source"
        raise


def _offsets_of(sizes: Ids) -> Ids:
    return np.concatenate([np.zeros(1, np.int64), np.cumsum(sizes)])


def _words_of(point: NDArray[Any]) -> str:
    return f"({', '.join(_text_of(float(x)) for x in point)})"


def _text_of(number: float) -> str:
    """With as few digits as tell it."""
    texts = (f"{number:.{digits}g}" for digits in range(6, 18))
    return next((text for text in texts if float(text) == number), f"{number:.17g}")
