# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pieces of a stream: what a caller may give as one, what all have in common, and points with records, as the engine
stores them.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._errors import InputError, of_part
from ._input import array_of, points_and_weights_of, refuse_masked, refuse_non_finite
from ._las import LasPoints, read_las

# What block files have of their own.
RESERVED = ("points", "weights", "ids", "simplices", "offsets", "connectivity", "hidden", "blocks")


@dataclass
class Piece:
    """A piece whose points the engine can read: what is to be left out is NaN."""

    points: NDArray[Any]
    weights: NDArray[Any] | None
    attributes: dict[str, NDArray[Any]]
    types: dict[str, np.dtype[Any]] = field(default_factory=dict)
    """of points and weights as they were given, by name; none of objects"""


@dataclass
class Form:
    """What all pieces of a run have in common: the types, as arrays without a point."""

    kind: str
    points: NDArray[Any]
    weights: NDArray[Any] | None
    attributes: dict[str, NDArray[Any]]

    @classmethod
    def of(cls, kind: str, piece: Piece) -> Form:
        none = {name: values[:0].copy() for name, values in piece.attributes.items()}

        def typed(name: str, values: NDArray[Any]) -> NDArray[Any]:
            given = piece.types.get(name, values.dtype)
            return values[:0].astype(given if given.kind == "f" or _held(given, values, kind).all() else values.dtype)

        weights = None if piece.weights is None else typed("weights", piece.weights)
        return cls(kind, typed("points", piece.points), weights, none)

    @property
    def record(self) -> np.dtype[Any]:
        """What travels with a point: its third coordinate, if the engine does not read it, and the attributes."""
        carried = self.kind != "hull" and self.points.shape[1] == 3
        fields: list[Any] = [("z", self.points.dtype)] if carried else []
        fields += [(f"a{i}", one.dtype, one.shape[1:]) for i, one in enumerate(self.attributes.values())]
        return np.dtype(fields)

    def check(self, piece: Piece) -> None:
        """Whether a piece that has points is of this form."""
        for name, here, other in (("points", self.points, piece.points), ("weights", self.weights, piece.weights)):
            if here is not None and other is not None:
                self._check_numbers(name, here, other, piece.types.get(name))
        missing = [name for name in self.attributes if name not in piece.attributes]
        unknown = [name for name in piece.attributes if name not in self.attributes]
        if missing:
            raise _wrong(f"there is no attribute {missing[0]!r}, which the first piece has")
        if unknown:
            raise _wrong(f"there is an attribute {unknown[0]!r}, which the first piece has not")
        for name, one in self.attributes.items():
            _compare(f"attribute {name!r}", one, piece.attributes[name])

    def _check_numbers(
        self, name: str, first: NDArray[Any], values: NDArray[Any], given: np.dtype[Any] | None
    ) -> None:
        """Floats are of the first piece's type, or are converted to it; of other numbers, that type holds each."""
        if given is not None and given.kind == "f":
            _compare(name, first, values if first.dtype in (np.float32, np.float64) else values[:0].astype(given))
            return
        held = _held(first.dtype, values, self.kind)
        if not held.all():
            sentence = f"{name}: the type is {given or values.dtype}, and {first.dtype} in the first piece"
            raise _wrong(f"{sentence}, which does not hold {values[~held][0]}")
        _compare(name, first, values[:0].astype(first.dtype))

    def stored(self, piece: Piece) -> tuple[NDArray[np.float64], NDArray[np.uint8]]:
        """Three numbers a point, as the engine reads them, and the records' bytes."""
        points = piece.points
        positions = np.zeros((len(points), 3))
        columns = points.shape[1] if self.kind == "hull" else 2
        positions[:, :columns] = points[:, :columns]
        if piece.weights is not None:
            positions[:, 2] = piece.weights
        rows = np.zeros(len(points), self.record)
        for name in rows.dtype.names or ():
            if name != "z":
                rows[name] = list(piece.attributes.values())[int(name[1:])]
            else:  # no integer is NaN, as those left out are
                rows[name] = points[:, 2] if rows[name].dtype.kind == "f" else np.nan_to_num(points[:, 2])
        return positions, rows.view(np.uint8) if rows.itemsize else np.empty(0, np.uint8)

    def arrays(self, positions: NDArray[np.float64], records: NDArray[np.uint8]) -> dict[str, NDArray[Any]]:
        """Of the points of a block, by name: points, weights, attributes."""
        rows: NDArray[Any] = np.ndarray(len(positions), self.record, records)
        points = np.empty((len(positions), self.points.shape[1]), self.points.dtype)
        columns = points.shape[1] if self.kind == "hull" else 2
        points[:, :columns] = positions[:, :columns]
        if columns < points.shape[1]:
            points[:, 2] = rows["z"]
        found = {"points": points}
        if self.weights is not None:
            found["weights"] = positions[:, 2].astype(self.weights.dtype)
        for i, (name, one) in enumerate(self.attributes.items()):
            found[name] = np.zeros((len(rows), *one.shape[1:]), one.dtype)  # what aligned fields leave free is 0
            found[name][...] = rows[f"a{i}"]
        return found


class Pieces:
    """The caller's pieces, one after another.

    ignore: whether points that are not finite are left out
    """

    form: Form

    def __init__(self, kind: str, pieces: Any, ignore: bool) -> None:
        self._kind, self._pieces, self._ignore = kind, pieces, ignore
        self._known: dict[int, Piece] = {}

    def find_form(self) -> Form:
        """That of the first piece that has points."""
        for number in range(len(self._pieces)):
            self._known[number] = piece = self._read(number)
            if len(piece.points):
                self.form = Form.of(self._kind, piece)
                return self.form
        first = self._known.get(0, Piece(np.empty((0, 3)), None, {}))
        if self._kind == "regular" and first.weights is None:
            first.weights = np.empty(0)
        self.form = Form.of(self._kind, first)
        return self.form

    def __call__(self, number: int) -> tuple[NDArray[np.float64], NDArray[np.uint8]]:
        """The piece, as the engine stores it."""
        piece = self._known.pop(number, None) or self._read(number)
        with of_part(f"piece {number}"):
            if len(piece.points) == 0:
                return np.empty((0, 3)), np.empty(0, np.uint8)
            self.form.check(piece)
        return self.form.stored(piece)

    def _read(self, number: int) -> Piece:
        given = None
        try:
            given = self._pieces[number]
            if isinstance(given, (str, os.PathLike)):
                given = _loaded(Path(given))
        except Exception as error:
            file = f", {given}" if isinstance(given, (str, os.PathLike)) else ""
            error.add_note(f"This is of piece {number} of {len(self._pieces)}{file}.")
            raise
        with of_part(f"piece {number}"):
            return self._piece_of(given)

    def _piece_of(self, given: Any) -> Piece:
        if isinstance(given, LasPoints):
            given = {"points": given.points, **given.attributes}
        fields = dict(given) if isinstance(given, Mapping) else {"points": given}
        if "points" not in fields:
            raise _wrong(f"there are no 'points' among {', '.join(map(repr, fields)) or 'no arrays'}")
        for name, what in (("points", "coordinates"), ("weights", "weights")):
            if name == "points" or (self._kind == "regular" and fields.get(name) is not None):
                fields[name] = array_of(fields[name], what)
        types = {name: fields[name].dtype.newbyteorder("=") for name in ("points", "weights")
                 if isinstance(fields.get(name), np.ndarray) and fields[name].dtype.kind in "biuf"}  # fmt: skip
        given_weights = fields.pop("weights", None) if self._kind == "regular" else None
        points, weights, left_out = points_and_weights_of(fields.pop("points"), given_weights, self._ignore)
        if self._kind == "hull" and points.shape[1] == 2 and len(points):
            raise _wrong("a hull of pieces is of points of three coordinates, not of two")
        if self._kind == "regular" and weights is None and len(points):
            raise _wrong("there are no 'weights', which kind='regular' needs; without them, take kind='delaunay'")
        if "weights" in fields:
            raise _wrong(f"there are 'weights', which kind={self._kind!r} does not know: take kind='regular'")
        refuse_non_finite(points if self._kind == "hull" else points[:, :2], weights, left_out)
        return Piece(points, weights, {name: _attribute(name, one, len(points)) for name, one in fields.items()}, types)


def _held(dtype: np.dtype[Any], values: NDArray[Any], kind: str) -> NDArray[np.bool_]:
    """Which of a piece's numbers a type holds. NaN counts as held by integers where the engine leaves the point out."""
    missing = np.isnan(values)
    if dtype.kind == "f":
        with np.errstate(over="ignore"):
            return missing | (values.astype(dtype).astype(values.dtype) == values)
    if values.ndim == 2 and kind != "hull":
        missing[:, 2:] &= missing[:, :2].any(axis=1)[:, None]
    low, end = (0, 2) if dtype.kind == "b" else (int(np.iinfo(dtype).min), int(np.iinfo(dtype).max) + 1)
    held: NDArray[np.bool_] = (values == np.floor(values)) & (values >= float(low)) & (values < float(end))
    return missing | held


def _attribute(name: Any, values: Any, count: int) -> NDArray[Any]:
    if not _is_entry(name) or name in RESERVED:
        own = ", ".join(RESERVED)
        raise _wrong(f"an attribute's name is text, and none of {own}, and has no .npy at its end; it is {name!r}")
    refuse_masked(values, f"attribute {name!r}")
    array = np.asarray(values)
    if array.dtype.hasobject:
        raise TypeError(f"attribute {name!r} has values of a fixed size, and not of type {array.dtype}")
    if array.ndim == 0 or len(array) != count:
        raise _wrong(f"attribute {name!r} has a value for each of {count} points, and not the shape {array.shape}")
    return array


def _is_entry(name: Any) -> bool:
    """Whether a file has an array by this name, and no other: numpy.load() takes a name with .npy for one without."""
    is_name = isinstance(name, str) and name != "" and "\0" not in name and not name.endswith(".npy")
    return is_name and name.encode(errors="ignore").decode() == name  # no half of a surrogate pair


def _loaded(path: Path) -> Any:
    suffix = path.suffix.lower()
    if suffix == ".npy":
        return np.load(path, allow_pickle=False)
    if suffix == ".npz":
        with np.load(path, allow_pickle=False) as file:
            return dict(file)
    if suffix in (".las", ".laz"):
        return read_las(path)
    raise InputError(f"a file of points is .npy, .npz or .las, not {path}", "bad_argument")


def _compare(name: str, first: NDArray[Any], other: NDArray[Any]) -> None:
    if other.dtype != first.dtype:
        raise _wrong(f"{name}: the type is {other.dtype}, and {first.dtype} in the first piece")
    if other.shape[1:] != first.shape[1:]:
        raise _wrong(f"{name}: a point has the shape {other.shape[1:]}, and {first.shape[1:]} in the first piece")


def _wrong(sentence: str) -> InputError:
    return InputError(sentence, "bad_argument")
