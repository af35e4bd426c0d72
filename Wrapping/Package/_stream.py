# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Triangulations and hulls of more points than memory holds, in files."""

from __future__ import annotations

import errno
import json
import os
import re
import zipfile
from collections.abc import Mapping, Sequence
from contextlib import suppress
from operator import index
from pathlib import Path
from typing import Any, Literal, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arguments import choice_of
from ._errors import InputError, of_file
from ._results import Facets, NonFinite, Progress, ignores, report_of, settings
from ._stream_pieces import Form, Pieces

Kind = Literal["delaunay", "regular", "hull"]

# In the order of the engine's BlockShape.
_SHAPES = {"hull": 0, "delaunay": 1, "regular": 2}
_KINDS = ("delaunay", "regular", "hull")
_LEAST_MEMORY = 2**20
_FORM = "form.npz"  # the work folder's first file, and its last
_PART = "npz.part"  # a file that is being written


class LazyPieces(Protocol):
    """What gives pieces by their numbers."""

    def __len__(self) -> int: ...

    def __getitem__(self, number: int, /) -> Any: ...


class Streamed(NamedTuple):
    """What stream() has written."""

    files: tuple[Path, ...]
    """one a block, in order"""
    points: int
    """how many points all pieces have"""
    non_finite: int
    """how many of these were left out"""
    hidden: int
    """how many ids files have as hidden"""
    cells: int
    """how many cells all blocks have"""
    dimension: int
    """of what the points span: -1 (no point) to 3"""
    volume: float
    """of a hull; 0 below dimension 3"""
    area: float
    """of a hull's facets"""
    statistics: dict[str, float]
    """points_received: how many points blocks had from each other; bytes_written and bytes_read: of files of work, by
    this call"""


def stream(
    pieces: Sequence[Any] | LazyPieces,
    folder: str | os.PathLike[str],
    *,
    kind: Kind = "delaunay",
    memory: int = 2**30,
    block_points: int | None = None,
    facets: Facets = "triangles",
    threads: int = 0,
    non_finite: NonFinite = "error",
    progress: Progress = None,
) -> Streamed:
    """A triangulation or a hull of more points than memory holds, block by block into files.

    The cells of all files together are those of regular_triangulation() or convex_hull() of all points, bit for bit,
    however points come in pieces. Each cell is in one file. Power diagrams, alpha complexes and terrain meshes are not
    streamed.

    Parameters
    ----------
    pieces : sequence
        whatever has a length and gives piece i as pieces[i]: a list, or an object that reads them one by one. Each is
        read once; by a call that goes on, those alone that are not stored yet. A piece is an array of points, n by 2
        or 3; or a mapping (also what read_las() gives) that has "points", with kind "regular" also "weights", and any
        arrays of a value for each point, of any type of fixed size: attributes; or the name of a file of that, .npy,
        .npz or .las. All pieces that have points have the types and the attributes of the first. A point's id is its
        place in all pieces, one after another.
    folder : path
        where the files come to be, block-00000.npz and so on; see below. It is made if it is not there. While the run
        lasts, its folder work has 100 to 200 bytes a point, and the attributes.
    kind : {"delaunay", "regular", "hull"}
        what is built. Of triangulations, x and y count; a third coordinate is kept. A hull is of points n by 3.
    memory : int
        about how many bytes the run takes, beside a piece and a block's result; 2**20 or more. Points at one position
        are in one block.
    block_points : int, optional
        about how many points a block has; by default as many as memory lets each thread have
    facets : {"triangles", "polygons"}
        whether files have simplices, or true facets as offsets and connectivity
    threads, non_finite, progress
        see the module; each thread works on a block

    Raises
    ------
    InputError
        names the piece, and the point or attribute in it
    OSError
        of a file or folder, which it names; FileExistsError: the folder has files of another run
    Exception
        whatever pieces[i] raises, with a note that names the piece

    Notes
    -----
    numpy.load() reads a file, by name:

    - points, n by 2 or 3: the points of the block's cells, in the pieces' type; weights, if there are some; attributes
    - ids, n: of these points, ascending
    - blocks, n: the block that has the point as its own
    - simplices, m by 3 (by 2 or 1, if points span less): rows of points. Or, of polygons, offsets and connectivity, as
      Polygons has them
    - hidden: ids of the block's points that are in no cell; none of a hull of points that span less than space

    A file is whole or absent. After an error, an abort or the end of the process, the same call goes on where it was,
    and gives the same bits. Memory, threads and progress may be others then. Once it has ended, the folder takes no
    other run until its files are gone.
    """
    choice_of("kind", kind, _KINDS)
    ignore = ignores(non_finite)
    bytes_in_memory = _at_least("memory", memory, _LEAST_MEMORY)
    points_in_block = 0 if block_points is None else _at_least("block_points", block_points, 1)
    has_both = hasattr(pieces, "__len__") and hasattr(pieces, "__getitem__")
    if isinstance(pieces, (str, bytes, Mapping)) or not has_both:
        sentence = "pieces are a sequence, or an object with __len__ and __getitem__, not of type"
        raise TypeError(f"{sentence} {type(pieces).__name__}")
    count = len(pieces)
    with report_of(progress) as report:
        # What is not finite is sought as pieces are read; what is masked is left out in any case.
        chosen = settings(threads, facets, non_finite, "cpu", report, True)[0]
        files, source = _Files(Path(folder)), Pieces(kind, pieces, ignore)
        files.begin(json.dumps({"kind": kind, "facets": facets, "non_finite": non_finite, "pieces": count}), source)

        def write(number: int, block: dict[str, Any]) -> None:
            files.write(number, _arrays_of(source.form, facets == "polygons", **block))

        found = _core.stream(
            _SHAPES[kind],
            count,
            str(files.work),
            bytes_in_memory,
            points_in_block,
            source.form.record.itemsize,
            source,
            write,
            chosen,
        )
        made = files.end(found.pop("blocks"))
    names = ("points", "non_finite", "hidden", "cells", "dimension", "volume", "area")
    return Streamed(files=made, statistics=found, **{name: found.pop(name) for name in names})


def _arrays_of(
    form: Form,
    are_polygons: bool,
    *,
    dimension: int,
    positions: NDArray[np.float64],
    records: NDArray[np.uint8],
    **cells: NDArray[Any],
) -> dict[str, NDArray[Any]]:
    """What a block's file has."""
    found = form.arrays(positions, records)
    for name in ("ids", "blocks", "hidden"):
        found[name] = cells[name]
    if are_polygons:
        found.update(offsets=cells["offsets"], connectivity=cells["connectivity"])
    else:
        corners = min(dimension, 2) + 1
        rows = len(cells["connectivity"]) // corners if corners else 0
        found["simplices"] = cells["connectivity"].reshape(rows, corners)
    return found


class _Files:
    """The folder of a run: files of blocks, and a folder of work, which has the pieces' form as long as it is there."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self.work = folder / "work"

    def begin(self, arguments: str, pieces: Pieces) -> None:
        """Go on with the run of these arguments, whose form is then the pieces'; or begin it."""
        path = self.work / _FORM
        if path.exists():
            before, pieces.form = _stored(path)
            if before != arguments:
                sentence = f"{self._folder} has a run that has not ended, of other arguments: {before}, not {arguments}"
                raise InputError(f"{sentence}. Give those, or another folder", "bad_argument")
            return
        for one in self._blocks() + [one for one in self.work.glob("*") if one.name != _PART]:
            sentence = "this is there already, of no run to go on with: take it away, or choose another folder"
            raise FileExistsError(errno.EEXIST, sentence, str(one))
        form = pieces.find_form()
        self.work.mkdir(parents=True, exist_ok=True)
        names = np.array(list(form.attributes), str)
        arrays = {"points": form.points, "arguments": np.array(arguments), "names": names}
        arrays.update((f"a{i}", one) for i, one in enumerate(form.attributes.values()))
        if form.weights is not None:
            arrays["weights"] = form.weights
        self._write(path, arrays)

    def write(self, number: int, arrays: dict[str, NDArray[Any]]) -> None:
        """A block's file."""
        self._write(self._path(number), arrays)

    def end(self, blocks: int) -> tuple[Path, ...]:
        """All blocks' files. No other remains: a run that began again may have fewer than before.

        The run has ended once the form is gone. The folder of work remains where something of others' is in it.
        """
        made = tuple(map(self._path, range(blocks)))
        for one in set(self._blocks()) - set(made):
            one.unlink()
        (self.work / _FORM).unlink()
        with suppress(OSError):
            self.work.rmdir()
        return made

    def _path(self, number: int) -> Path:
        return self._folder / f"block-{number:05d}.npz"

    def _blocks(self) -> list[Path]:
        return sorted(one for one in self._folder.glob("block-*.npz") if re.fullmatch(r"block-\d{5,}", one.stem))

    def _write(self, path: Path, arrays: dict[str, NDArray[Any]]) -> None:
        """All or nothing. What a killed process leaves is replaced by the next file."""
        part = self.work / _PART
        try:
            write_arrays(part, arrays)
            os.replace(part, path)
        except BaseException as error:
            part.unlink(missing_ok=True)
            if isinstance(error, OSError) and error.filename is None:
                error.filename = str(path)
            raise


def _stored(path: Path) -> tuple[str, Form]:
    """The arguments and the form of a run that has not ended."""
    try:
        with np.load(path, allow_pickle=False) as file:
            stored = dict(file)
        arguments = str(stored["arguments"])
        none = {name: stored[f"a{i}"] for i, name in enumerate(stored["names"].tolist())}
        return arguments, Form(json.loads(arguments)["kind"], stored["points"], stored.get("weights"), none)
    except Exception as error:  # zipfile's, NumPy's or json's
        if isinstance(error, MemoryError) or (isinstance(error, OSError) and error.filename is not None):
            raise
        raise of_file(errno.EIO, path) from error


def write_arrays(path: Path, arrays: dict[str, NDArray[Any]]) -> None:
    """As numpy.savez() does, whose own arguments are names that arrays cannot have."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_STORED, allowZip64=True) as whole:
        for name, array in arrays.items():
            with whole.open(f"{name}.npy", "w", force_zip64=True) as file:
                np.lib.format.write_array(file, array, allow_pickle=False)


def _at_least(name: str, value: Any, least: int) -> int:
    try:
        number = index(value)
    except TypeError:
        raise TypeError(f"{name} is an integer, not {value!r}") from None
    if not least <= number < 2**63:
        raise ValueError(f"{name} is {least} or more, not {value!r}")
    return number
