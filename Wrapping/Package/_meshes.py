# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK's data sets as arrays that the engine reads, and its results as data sets."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _vtkmodules as vtk
from ._arguments import Weights
from ._errors import FlipFlopError, InputError, at_points
from ._input import column_of, either_excluded, points_of, rows_of, weights_of
from ._results import Ids
from ._vtkmodules import values_of

# What may be a leaf of a composite, and a mesh by itself.
LEAVES = ("vtkPointSet", "vtkImageData", "vtkRectilinearGrid")
_MOST_POINTS = 2**32 - 2


@dataclass
class Part:
    """The points of one data set, or of an array."""

    rows: NDArray[Any]  # n by 3 or n by 2, as they are stored
    source: Any = None  # VTK's array of them, if there is one
    mesh: Any = None  # the data set

    @property
    def data(self) -> Any:
        """VTK's point data; None of an array."""
        return None if self.mesh is None else self.mesh.GetPointData()


@dataclass
class Block:
    """What is one input of the engine: a data set, which may be a leaf of a composite."""

    part: Part | None
    name: str = ""  # in words: of a composite's block
    flat_index: int = 0
    fault: FlipFlopError | None = None  # why it has no part, though it has data
    count: int = field(init=False)

    def __post_init__(self) -> None:
        self.count = 0 if self.part is None else len(self.part.rows)

    def checked(self) -> Block:
        """The block; its fault is raised."""
        if self.fault is not None:
            raise self.fault
        return self


def is_tree(data: Any) -> bool:
    """Whether it is a composite."""
    return not isinstance(data, np.ndarray) and hasattr(data, "IsA") and bool(data.IsA("vtkDataObjectTree"))


def block_of(data: Any, name: str) -> Block:
    """The points of a data set, which errors call by that name."""
    return Block(_part_of(data, name, LEAVES), name)


def blocks_of(data: Any, leaves: Sequence[str] = LEAVES) -> list[Block | None]:
    """The leaves of a composite in the order of their flat indices, None where one is missing; or the one block."""
    if not is_tree(data):
        return [Block(_part_of(data, "", leaves))]
    found: list[Block | None] = []
    for nodes, leaf in _nodes(data):
        if leaf is None:
            found.append(None)
            continue
        name, index = _name_of_block(nodes, data), nodes.GetCurrentFlatIndex()
        try:
            found.append(Block(_part_of(leaf, name, leaves), name, index))
        except FlipFlopError as error:
            found.append(Block(None, name, index, error))
    return found


def composite_of(data: Any, meshes: Sequence[Any]) -> Any:
    """A composite of the same structure and names, with a mesh, or None, for each of blocks_of()."""
    made = data.NewInstance()
    made.CopyStructure(data)
    pass_field_data(data, made)
    for (nodes, _), mesh in zip(_nodes(data), meshes):
        if mesh is not None:
            made.SetDataSet(nodes, mesh)
    return made


def _nodes(tree: Any) -> Iterator[tuple[Any, Any]]:
    """VTK's iterator at each leaf, and what is there, in the order of flat indices."""
    nodes = tree.NewTreeIterator()
    nodes.SkipEmptyNodesOff()
    nodes.InitTraversal()
    while not nodes.IsDoneWithTraversal():
        yield nodes, nodes.GetCurrentDataObject()
        nodes.GoToNextItem()


def leaves_of(data: Any) -> list[Any]:
    """The leaves of a composite, None where one is missing; or the data set."""
    return [leaf for _, leaf in _nodes(data)] if is_tree(data) else [data]


def _name_of_block(nodes: Any, tree: Any) -> str:
    index = nodes.GetCurrentFlatIndex()
    name = nodes.GetCurrentMetaData().Get(tree.NAME()) if nodes.HasCurrentMetaData() else None
    return f'the block "{name}" (flat index {index})' if name else f"the block of flat index {index}"


def _part_of(data: Any, name: str, leaves: Sequence[str]) -> Part:
    if not hasattr(data, "IsA") or isinstance(data, np.ndarray):
        return Part(rows_of(data))
    if not any(map(data.IsA, leaves)):
        what = "which has no points to take" if leaves is LEAVES else "which is no surface: a PolyData is wanted"
        raise InputError(f"{name} is of the type {type(data).__name__}, {what}", "bad_argument")
    if data.IsA("vtkImageData"):
        return Part(_image_points(data), None, data)
    if data.IsA("vtkRectilinearGrid"):
        return Part(_grid_points(data, name), None, data)
    points = data.GetPoints()
    if points is None:
        return Part(np.empty((0, 3), np.float32), None, data)
    source = points.GetData()
    size = source.GetNumberOfComponents()
    if size != 3:
        of = f" of {name}" if name else ""
        raise InputError(f"the points{of} have {size} coordinates each; a point has 3", "bad_argument")
    return Part(values_of(source).reshape(-1, 3), source, data)


def _check_count(dimensions: Sequence[int]) -> bool:
    """Whether a grid has points; an error if it has too many."""
    count = 1
    for size in dimensions:
        count *= max(0, int(size))
    if count > _MOST_POINTS:
        raise InputError(f"more points than 32-bit indices can name: {count} points", "too_many_points", -1, count)
    return count > 0


def _image_points(image: Any) -> NDArray[np.float64]:
    """The points of an image, x fastest, as VTK computes them."""
    if not _check_count(image.GetDimensions()):
        return np.empty((0, 3))
    low = image.GetExtent()[::2]
    i, j, k = (np.arange(first, first + size, dtype=float) for first, size in zip(low, image.GetDimensions()))
    matrix = vtk.rows_of_matrix(image.GetIndexToPhysicalMatrix())
    points = np.empty((len(k), len(j), len(i), 3))
    for axis in range(3):
        x, y, z, origin = matrix[axis]
        points[..., axis] = x * i + (y * j)[:, None] + (z * k)[:, None, None] + origin
    return points.reshape(-1, 3)


def _grid_points(grid: Any, name: str) -> NDArray[Any]:
    """The points of a rectilinear grid of that name, x fastest: floats if all coordinates are."""
    dimensions = grid.GetDimensions()
    if not _check_count(dimensions):
        return np.empty((0, 3), np.float32)
    of = f" of {name}" if name else ""
    axes, floats = [], True
    for axis, size in zip("xyz", dimensions):
        array = getattr(grid, f"Get{axis.upper()}Coordinates")()
        values = np.empty(0) if array is None else values_of(array)
        if values.ndim != 1 or len(values) < size:
            found = 0 if array is None else array.GetNumberOfTuples()
            components = 0 if array is None else array.GetNumberOfComponents()
            raise InputError(
                f"the vtkRectilinearGrid{of} has {found} {axis} coordinate(s) of {components} component(s) and needs "
                f"{size} of 1",
                "bad_argument",
            )
        floats = floats and values.dtype == np.float32
        try:
            axes.append(weights_of(values, True)[0][:size])  # exactly
        except InputError as error:
            raise InputError(
                f"the {axis} coordinate {error.index} of the vtkRectilinearGrid{of} is a 64-bit integer that no double "
                "holds. Subtract an offset from all: the result has the same shape",
                "bad_argument", error.index,
            ) from None
    x, y, z = axes
    points = np.empty((len(z), len(y), len(x), 3), np.float32 if floats else np.float64)
    points[..., 0], points[..., 1], points[..., 2] = x, y[:, None], z[:, None, None]
    return points.reshape(-1, 3)


class Cloud:
    """The points of some blocks, one after another, as the engine reads them; and what belongs to them.

    Attributes
    ----------
    array : ndarray
        of n by 3, or n by 2, without ghosts
    left_out : bool
        whether the engine leaves out what is not finite
    names : ndarray, or None
        what meshes have for the points' ids, if these are not the ids
    """

    array: NDArray[Any]
    left_out: bool
    names: Ids | None = None

    def __init__(self, blocks: Sequence[Block], skip_ghost_points: bool, ignore: bool) -> None:
        self.blocks = blocks
        self._parts = [block.part for block in blocks if block.part is not None]
        self._starts = np.cumsum([0, *(len(part.rows) for part in self._parts)])
        self._kept = self._without_ghosts() if skip_ghost_points else None
        try:
            self._gather(ignore)
        except InputError as error:
            raise self._translated(error, self._kept) from None

    @property
    def count(self) -> int:
        """How many points the caller gave, ghosts included."""
        return int(self._starts[-1])

    def engine(self, call: Callable[..., Any], *arguments: Any) -> Any:
        """The engine's result; its errors tell the caller's points."""
        try:
            return call(*arguments)
        except FlipFlopError as error:
            raise self._translated(error, self._kept) from None

    def rows(self, ids: Ids) -> NDArray[Any]:
        """The coordinates of these of the caller's points."""
        rows = [part.rows for part in self._parts]
        return (rows[0] if len(rows) == 1 else np.concatenate(rows))[ids]

    def ids(self, found: Ids) -> Ids:
        """The ids of the caller's points."""
        return found if self._kept is None else self._kept[found]

    def weights(
        self, weights: Weights, ignore: bool, noun: str = "weight", are_kept: bool = False
    ) -> NDArray[Any] | None:
        """One weight for each point, or what else the noun says: of the point array of that name, or given.

        are_kept: numbers are of the points that the engine reads
        """
        values = weights.values
        if values is None or isinstance(values, str) and not self._starts[-1]:
            return None
        if isinstance(values, str):
            values = self._named(values, noun)
        if self._kept is not None and isinstance(values, np.ndarray) and len(values) == self._starts[-1] and not are_kept:
            values, are_kept = values[self._kept], True  # a ghost's may be anything
        before = self._kept if are_kept else None
        try:
            weight_array, masked = column_of(values, noun, ignore)
        except InputError as error:
            raise self._translated(error, before) from None
        if len(weight_array) != (len(self.array) if are_kept else self._starts[-1]):
            raise InputError(
                f"there are {len(weight_array)} {noun}s, which is not the number of points, {self._starts[-1]}",
                "weight_count", -1, len(weight_array),
            )
        kept = weight_array if self._kept is None or are_kept else weight_array[self._kept]
        if not len(kept):
            return None
        try:
            self.left_out = either_excluded(self.array, self.left_out, kept, masked)
            return weights.computed(kept)
        except InputError as error:
            raise self._translated(error, self._kept) from None

    def mesh(self, ids: Ids, pass_point_data: bool) -> Any:
        """A mesh of these of the caller's points, in their type, with their data; it has no cells yet."""
        made = vtk.vtkPolyData()
        made.SetPoints(self._points(ids))
        self.pass_data(ids, made, "point", pass_point_data)
        return made

    def source(self) -> Any:
        """A data set of the points that the engine reads, with their data: the caller's own, if it has just these."""
        filled = [part for part in self._parts if len(part.rows)]
        alone = self._parts if len(self._parts) == 1 else filled
        if self._kept is None and len(alone) == 1:
            return alone[0].mesh
        ids = self.ids(np.arange(len(self.array)))
        made = vtk.vtkPolyData()
        made.SetPoints(self._points(ids))
        shares = self._shares(ids) or [(part, ids[:0]) for part in self._parts[:1]]
        if shares:
            _copy_arrays(shares, len(ids), made.GetPointData())
        return made

    def heights(self) -> NDArray[Any] | None:
        """The z of the points that the engine reads: floats if they are stored so, else doubles; None: no points."""
        if len(self._parts) == 1 and self._parts[0].source is None and self._parts[0].mesh.IsA("vtkPointSet"):
            return None
        return self.array[:, 2].astype(np.float32 if self._stored.dtype == np.float32 else np.float64)

    def pass_data(self, ids: Ids, to: Any, association: str, all_arrays: bool) -> None:
        """Gives a mesh the point data and the ids of these points, as point or as cell data."""
        cells = association == "cell"
        attributes = to.GetCellData() if cells else to.GetPointData()
        shares = self._shares(ids)
        if all_arrays and shares and all(part.mesh is not None for part, _ in shares):
            _copy_arrays(shares, len(ids), attributes)
            if cells:
                _turn_marks(attributes)
        names = ids if self.names is None else self.names[ids]
        attributes.AddArray(vtk.ids_of(names, "vtkOriginalPointIds"))

    def _without_ghosts(self) -> Ids | None:
        """The ids of the points that are no ghosts; None: all."""
        marks_of = [_marks_of(part.data) for part in self._parts]
        if all(marks is None for marks in marks_of):
            return None
        kept = []
        names = [block.name for block in self.blocks if block.part is not None]
        for part, start, marks, name in zip(self._parts, self._starts, marks_of, names):
            count = len(part.rows)
            if marks is None or count == 0:
                kept.append(np.arange(start, start + count))
                continue
            values = values_of(marks).reshape(-1)
            if len(values) != count:
                of = f" of {name}" if name else ""
                sentence = f"the point array {marks.GetName()}{of} has {len(values)} value(s) for {count} point(s)"
                raise InputError(
                    f"{sentence}: mend or remove it, or have ghosts counted: skip_ghost_points=False", "bad_argument"
                ).for_filters(f"{sentence}. Mend or remove it, or turn off Skip Ghost Points.")
            ghost = part.data.DUPLICATEPOINT | part.data.HIDDENPOINT
            kept.append(start + np.flatnonzero((values & ghost) == 0))
        rows = np.concatenate([np.empty(0, np.int64), *kept])
        return rows if len(rows) < self._starts[-1] else None

    def _gather(self, ignore: bool) -> None:
        """All points in one array of one type."""
        if self._kept is None:
            shares = [(part, part.rows) for part in self._parts if len(part.rows)]
        else:
            shares = [(part, part.rows[ids]) for part, ids in self._shares(self._kept) if len(ids)]
        shares = shares or [(part, part.rows[:0]) for part in self._parts[-1:]]
        self._typed = shares[0][0] if len(shares) == 1 else None  # the one whose array tells the type
        if not shares:
            rows: Any = np.empty((0, 3), np.float32)
        elif len(shares) == 1:
            rows = shares[0][1]
        elif all(some.dtype == shares[0][1].dtype for _, some in shares):
            rows = np.concatenate([some for _, some in shares])
        else:
            rows = np.concatenate(_doubles_of([some for _, some in shares]))
        self.array, self.left_out = points_of(rows, ignore)
        # The output's points: integers stay integers.
        whole = rows.dtype.kind in "biu" and not np.ma.is_masked(rows)
        self._stored = np.asarray(rows) if whole else self.array

    def _points(self, ids: Ids) -> Any:
        """VTK's points, in their type and bits."""
        if self._typed is not None and self._typed.source is not None:
            points = self._typed.mesh.GetPoints().NewInstance()
            points.SetData(gathered([(self._typed.source, ids - self._start_of(self._typed))], len(ids)))
            return points
        rows = self._stored[ids if self._kept is None else np.searchsorted(self._kept, ids)]
        if rows.shape[1] == 2:
            rows = np.column_stack([rows, np.zeros(len(rows), rows.dtype)])
        if rows.dtype.kind == "b":
            rows = rows.view(np.uint8)
        return vtk.points_of(rows)

    def _start_of(self, part: Part) -> int:
        return int(self._starts[next(i for i, one in enumerate(self._parts) if one is part)])

    def _shares(self, ids: Ids) -> list[tuple[Part, Ids]]:
        """Of each part with points that are no ghosts, the ids of ascending ones, counted there."""
        if self._kept is None and len(self._parts) == 1:
            return [(self._parts[0], ids)] if self.count else []
        found = []
        for part, start in zip(self._parts, self._starts):
            span = start, start + len(part.rows)
            kept = span if self._kept is None else np.searchsorted(self._kept, span)
            if kept[0] < kept[1]:
                first, last = np.searchsorted(ids, span)
                found.append((part, ids[first:last] - start))
        return found

    def _named(self, name: str, noun: str) -> NDArray[Any]:
        """The numbers of a point array."""
        of = f" of {self.blocks[0].name}" if self.blocks[0].name else ""
        values = []
        for part in self._parts:
            if not len(part.rows):
                continue
            array = None if part.data is None else part.data.GetAbstractArray(name)
            wrong = misfit_of(array, len(part.rows), "its" if of else "the input's", noun)
            if wrong:
                raise InputError(f'the {noun}s\' array "{name}"{of} {wrong}', "bad_argument")
            values.append(values_of(array))
        return values[0] if len(values) == 1 else np.concatenate([weights_of(some, True)[0] for some in values])

    def _translated(self, error: FlipFlopError, kept: Ids | None) -> FlipFlopError:
        """The same error, in terms of the caller's points and blocks."""
        message, index = str(error), error.index
        composite = any(block.name for block in self.blocks)
        if error._of_filters:
            return error
        what = re.search(r"\bat (point|triangle|cell) (\d+)", message)
        if what is None or index < 0:
            if composite and len(self.blocks) == 1:
                message += f", in {self.blocks[0].name}"
            return type(error)(message, error.code, index, error.count)
        if what[1] == "point" and kept is not None:
            index = int(kept[index])
        block, own = self._block_at(index) if what[1] == "point" else (self.blocks[0], index)
        words = f"at {what[1]} {own}" + (f" of {block.name}" if block.name else "")
        message = message[: what.start()] + words + message[what.end() :]
        made = type(error)(message, error.code, index, error.count)
        made._where = words.removeprefix("at ")
        return made

    def _block_at(self, point: int) -> tuple[Block, int]:
        for block in self.blocks:
            if point < block.count:
                break
            point -= block.count
        return block, point


def misfit_of(array: Any, count: int, whose: str, noun: str) -> str:
    """Why a point array does not hold one number for each point; empty: it does."""
    if array is None:
        return f"is missing from {whose} point data"
    if not array.IsA("vtkDataArray"):
        return f"is a {array.GetClassName()}, which does not hold numbers"
    if array.GetNumberOfComponents() != 1:
        return f"has {array.GetNumberOfComponents()} components; a {noun} has 1"
    if array.GetNumberOfTuples() != count:
        return f"has {array.GetNumberOfTuples()} value(s) for {count} point(s)"
    return ""


def _doubles_of(parts: Sequence[NDArray[Any]]) -> list[NDArray[np.float64]]:
    """Points of several types; errors count those of all parts."""
    found, begin = [], 0
    for rows in parts:
        try:
            found.append(points_of(rows, True)[0].astype(np.float64))
        except InputError as error:
            raise at_points(str(error).split(": first at", 1)[0], error.code, begin + error.index, error.count) from None
        begin += len(rows)
    return found


def add_block_index(mesh: Any, blocks: Sequence[Block]) -> None:
    """Gives points that are of these blocks an array of the flat indices of these."""
    ids = values_of(mesh.GetPointData().GetAbstractArray("vtkOriginalPointIds"))
    flat = np.array([block.flat_index for block in blocks], np.uint32)
    ends = np.cumsum([block.count for block in blocks])
    index = flat[np.searchsorted(ends, ids, side="right")] if len(ids) else np.empty(0, np.uint32)
    mesh.GetPointData().AddArray(vtk.array_of(index, "BlockIndex"))


def corners_of(cells: Any, what: str) -> tuple[Ids, Ids]:
    """Where cells begin among their corners, from 0 to the end, and the points that these are.

    what: errors call the cells so
    """
    if not cells.GetNumberOfCells():
        return np.zeros(1, np.int64), np.empty(0, np.int64)
    offsets = values_of(cells.GetOffsetsArray()).astype(np.int64)
    ids = cells.GetConnectivityArray()
    first, last, given = int(offsets[0]), int(offsets[-1]), ids.GetNumberOfTuples()
    if first < 0 or last > given or (np.diff(offsets) < 0).any():
        raise InputError(
            f"{what} are not valid: their offsets name corners {first} to {last - 1}, and the connectivity has {given}",
            "bad_argument",
        )
    return offsets - first, values_of(ids)[first:last].astype(np.int64)


def set_cells(mesh: Any, dimension: int, size: int, offsets: Any, connectivity: Any) -> None:
    """Gives a mesh its cells: vertices, lines or polygons, all of one size or as the offsets tell."""
    if offsets is None:
        offsets = np.arange(0, len(connectivity) + 1, size) if size else np.empty(0)
    if len(offsets) < 2:
        return
    cells = vtk.cells_of(offsets, connectivity)
    (mesh.SetVerts, mesh.SetLines, mesh.SetPolys)[min(dimension, 2)](cells)


def pass_field_data(data: Any, to: Any) -> None:
    """The field data, without the figures of another run."""
    to.GetFieldData().PassData(data.GetFieldData())
    drop_report(to.GetFieldData())


def drop_report(field_data: Any) -> None:
    """Removes the figures of another run."""
    for name in [field_data.GetArrayName(i) for i in range(field_data.GetNumberOfArrays())]:
        if name and name.startswith("FlipFlop"):
            field_data.RemoveArray(name)


def like_of(array: Any, count: int) -> Any:
    """A new array of VTK's, of so many tuples, that is like another one but for its values."""
    like = array.NewInstance() if array.HasStandardMemoryLayout() else array.CreateArray(array.GetDataType())
    like.SetName(array.GetName())
    like.SetNumberOfComponents(array.GetNumberOfComponents())
    like.CopyComponentNames(array)
    if array.HasInformation():
        like.CopyInformation(array.GetInformation())
    if array.IsA("vtkDataArray"):
        like.SetLookupTable(array.GetLookupTable())
    like.SetNumberOfTuples(count)
    return like


def gathered(arrays: Sequence[tuple[Any, Ids]], count: int) -> Any:
    """A new array of VTK's of some tuples of others, all of one type."""
    first = arrays[0][0]
    like = like_of(first, count)
    if first.IsA("vtkDataArray") and not first.IsA("vtkBitArray"):
        at, values = 0, values_of(like) if count else None
        for array, ids in arrays if count else ():
            np.take(values_of(array), ids, 0, values[at : at + len(ids)], "clip")
            at += len(ids)
        return like
    at = 0
    for array, ids in arrays:
        like.InsertTuples(vtk.id_list_of(at + np.arange(len(ids))), vtk.id_list_of(ids), array)
        at += len(ids)
    return like


def _copy_arrays(shares: Sequence[tuple[Part, Ids]], count: int, to: Any) -> None:
    """The arrays that all parts have, and what they are active as."""
    leader = shares[0][0].data
    if not leader.GetNumberOfArrays():
        return
    for i in range(leader.GetNumberOfArrays()):
        array = leader.GetAbstractArray(i)
        found = []
        for part, ids in shares:
            other = array if part is shares[0][0] else _alike(part.data, array)
            if other is None or other.GetNumberOfTuples() < len(part.rows):
                break
            found.append((other, ids))
        if len(found) < len(shares):
            continue
        index = to.AddArray(gathered(found, count))
        for attribute in range(leader.NUM_ATTRIBUTES):
            if leader.GetAbstractAttribute(attribute) is array:
                to.SetActiveAttribute(index, attribute)
    # Points can go without the surface that these tell of: they would shade and draw another falsely.
    for attribute in (to.NORMALS, to.TANGENTS, to.EDGEFLAG, to.RATIONALWEIGHTS, to.HIGHERORDERDEGREES):
        if to.GetAbstractAttribute(attribute) is not None:
            to.SetActiveAttribute(-1, attribute)


def _marks_of(data: Any) -> Any:
    """The array of ghosts among point data; None: there is none."""
    marks = None if data is None else data.GetAbstractArray(data.GhostArrayName())
    return marks if marks is not None and marks.IsA("vtkUnsignedCharArray") else None


def _alike(data: Any, array: Any) -> Any:
    other = data.GetAbstractArray(array.GetName()) if array.GetName() else None
    same = (
        other is not None
        and other.GetDataType() == array.GetDataType()
        and other.GetNumberOfComponents() == array.GetNumberOfComponents()
    )
    return other if same else None


def _turn_marks(attributes: Any) -> None:
    """In the array of ghosts, points' marks become cells'."""
    marks = _marks_of(attributes)
    if marks is None or not marks.GetNumberOfValues():
        return
    values = values_of(marks)
    duplicate = np.where(values & attributes.DUPLICATEPOINT, attributes.DUPLICATECELL, 0)
    hidden = np.where(values & attributes.HIDDENPOINT, attributes.HIDDENCELL, 0)
    values[...] = duplicate | hidden
