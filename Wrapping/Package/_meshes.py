# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista's meshes as arrays that the engine reads, and its results as meshes.

No VTK is imported: what PyVista and the mesh itself offer is enough. So it is whatever VTK PyVista runs on.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pyvista as pv
from numpy.typing import NDArray

from ._arguments import Weights
from ._errors import FlipFlopError, InputError
from ._input import column_of, either_excluded, is_array_like, points_of, refuse_geometry, rows_of, weights_of
from ._results import Ids

_OBJECT = next(kind for kind in pv.PolyData.__mro__ if kind.__name__ == "vtkObjectBase")
_VTK = next(kind for kind in pv.PolyData.__mro__ if kind.__name__ == "vtkPolyData").__module__.split(".")[0]
# PyVista 0.48 and later look at all arrays' lengths; what counts is looked at here, too.
_UNCHECKED: dict[str, Any] = {"validate": False} if "validate" in inspect.signature(pv.wrap).parameters else {}
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


def values_of(array: Any) -> Any:
    """A VTK array's numbers: its own memory, or a copy of what is stored component by component."""
    if not array.HasStandardMemoryLayout() and hasattr(array, "ToAOSDataArray"):
        array = array.ToAOSDataArray()  # cvista 9.7 does not read the other one on every Python
    return np.asarray(pv.convert_array(array))


def data_of(mesh: Any) -> Any:
    """The mesh as a data object, PyVista's where it has a class for it; or numbers that are still to be looked at."""
    if isinstance(mesh, np.ndarray):
        return mesh
    if hasattr(mesh, "IsA"):
        if not isinstance(mesh, _OBJECT):
            raise TypeError(
                f"{type(mesh).__name__} is of another VTK, the module {type(mesh).__module__}, than PyVista "
                f"{pv.__version__}, which runs on {_VTK}: the one cannot use the other's data"
            )
        if mesh.IsA("vtkPoints"):
            mesh = mesh.GetData()
        if mesh.IsA("vtkDataArray"):
            return values_of(mesh)
    elif is_array_like(mesh):
        return mesh
    refuse_geometry(mesh, "points")
    try:
        data = pv.wrap(mesh, **_UNCHECKED)
    except (NotImplementedError, TypeError):
        data = mesh  # PyVista has no class for some composites
    if not hasattr(data, "IsA") or not any(map(data.IsA, (*LEAVES, "vtkDataObjectTree"))):
        raise TypeError(f"{type(mesh).__name__} has no points to take")
    return data


def is_tree(data: Any) -> bool:
    """Whether it is a composite."""
    return not isinstance(data, np.ndarray) and hasattr(data, "IsA") and bool(data.IsA("vtkDataObjectTree"))


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
    kind = type(data) if isinstance(data, pv.DataObject) else data.NewInstance
    made = kind()
    made.CopyStructure(data)
    pass_field_data(data, made)
    for (nodes, _), mesh in zip(_nodes(data), meshes):
        if mesh is not None:
            made.SetDataSet(nodes, mesh)
    if isinstance(made, pv.MultiBlock):
        made.wrap_nested()
    return made


def _nodes(tree: Any) -> Iterator[tuple[Any, Any]]:
    """VTK's iterator at each leaf, and what is there, in the order of flat indices."""
    nodes = tree.NewTreeIterator()
    nodes.SkipEmptyNodesOff()
    nodes.InitTraversal()
    while not nodes.IsDoneWithTraversal():
        yield nodes, nodes.GetCurrentDataObject()
        nodes.GoToNextItem()


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
        return Part(_grid_points(data), None, data)
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
    matrix = pv.array_from_vtkmatrix(image.GetIndexToPhysicalMatrix())
    points = np.empty((len(k), len(j), len(i), 3))
    for axis in range(3):
        x, y, z, origin = matrix[axis]
        points[..., axis] = x * i + (y * j)[:, None] + (z * k)[:, None, None] + origin
    return points.reshape(-1, 3)


def _grid_points(grid: Any) -> NDArray[Any]:
    """The points of a rectilinear grid, x fastest: floats if all coordinates are."""
    dimensions = grid.GetDimensions()
    if not _check_count(dimensions):
        return np.empty((0, 3), np.float32)
    axes = []
    for name, size in zip("XYZ", dimensions):
        array = getattr(grid, f"Get{name}Coordinates")()
        values = np.empty(0) if array is None else values_of(array)
        if values.ndim != 1 or len(values) < size:
            raise InputError(f"a grid has {values.shape} {name.lower()} coordinates and needs {size}", "bad_argument")
        axes.append(values[:size])
    floats = all(values.dtype == np.float32 for values in axes)
    x, y, z = (weights_of(values, True)[0] for values in axes)  # exactly
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
    """

    array: NDArray[Any]
    left_out: bool

    def __init__(self, blocks: Sequence[Block], skip_ghost_points: bool, ignore: bool) -> None:
        self.blocks = blocks
        self._parts = [block.part for block in blocks if block.part is not None]
        self._starts = np.cumsum([0, *(len(part.rows) for part in self._parts)])
        self._kept = self._without_ghosts() if skip_ghost_points else None
        try:
            self._gather(ignore)
        except InputError as error:
            raise self._translated(error, None) from None

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

    def weights(self, weights: Weights, ignore: bool, noun: str = "weight") -> NDArray[Any] | None:
        """One weight for each point, or what else the noun says: of the point array of that name, or given."""
        values = weights.values
        if values is None or isinstance(values, str) and not self._starts[-1]:
            return None
        if isinstance(values, str):
            values = self._named(values, noun)
        try:
            weight_array, masked = column_of(values, noun, ignore)
        except InputError as error:
            raise self._translated(error, None) from None
        if len(weight_array) != self._starts[-1]:
            raise InputError(
                f"there are {len(weight_array)} {noun}s, which is not the number of points, {self._starts[-1]}",
                "weight_count", -1, len(weight_array),
            )
        kept = weight_array if self._kept is None else weight_array[self._kept]
        try:
            self.left_out = either_excluded(self.array, self.left_out, kept, masked)
            return weights.computed(kept)
        except InputError as error:
            raise self._translated(error, self._kept) from None

    def mesh(self, ids: Ids, pass_point_data: bool) -> pv.PolyData:
        """A mesh of these of the caller's points, in their type, with their data; it has no cells yet."""
        made = pv.PolyData()
        made.SetPoints(self._points(ids))
        self.pass_data(ids, made, "point", pass_point_data)
        return made

    def pass_data(self, ids: Ids, to: pv.PolyData, association: str, all_arrays: bool) -> None:
        """Gives a mesh the point data and the ids of these points, as point or as cell data."""
        cells = association == "cell"
        attributes = to.GetCellData() if cells else to.GetPointData()
        shares = self._shares(ids)
        if all_arrays and shares and all(part.mesh is not None for part, _ in shares):
            _copy_arrays(shares, len(ids), attributes)
            _mark_for_pyvista(shares[0][0].mesh, attributes, to.cell_data if cells else to.point_data)
            if cells:
                _turn_marks(attributes)
        numbers: Any = np.array(ids)
        array = pv.numpy_to_idarr(numbers, deep=True)
        array.SetName("vtkOriginalPointIds")
        attributes.AddArray(array)

    def block_index(self, ids: Ids) -> NDArray[np.uint32]:
        """The flat index of each point's block."""
        ends = np.cumsum([block.count for block in self.blocks])
        flat = np.array([block.flat_index for block in self.blocks], np.uint32)
        return flat[np.searchsorted(ends, ids, side="right")] if len(ids) else np.empty(0, np.uint32)

    def _without_ghosts(self) -> Ids | None:
        """The ids of the points that are no ghosts; None: all."""
        marks_of = [_marks_of(part.data) for part in self._parts]
        if all(marks is None for marks in marks_of):
            return None
        kept = []
        for part, start, marks in zip(self._parts, self._starts, marks_of):
            count = len(part.rows)
            if marks is None or count == 0:
                kept.append(np.arange(start, start + count))
                continue
            values = values_of(marks).reshape(-1)
            if len(values) != count:
                raise InputError(
                    f"the point array {marks.GetName()} has {len(values)} value(s) for {count} point(s): mend or "
                    "remove it, or have ghosts counted: skip_ghost_points=False",
                    "bad_argument",
                )
            ghost = part.data.DUPLICATEPOINT | part.data.HIDDENPOINT
            kept.append(start + np.flatnonzero((values & ghost) == 0))
        rows = np.concatenate([np.empty(0, np.int64), *kept])
        return rows if len(rows) < self._starts[-1] else None

    def _gather(self, ignore: bool) -> None:
        """All points in one array of one type."""
        parts = [part for part in self._parts if len(part.rows)] or self._parts[-1:]
        self._typed = parts[0] if len(parts) == 1 else None  # the one whose array tells the type
        if not parts:
            rows: Any = np.empty((0, 3), np.float32)
        elif len(parts) == 1:
            rows = parts[0].rows
        elif all(part.rows.dtype == parts[0].rows.dtype for part in parts):
            rows = np.concatenate([part.rows for part in parts])
        else:
            rows = np.concatenate([points_of(part.rows, True)[0].astype(np.float64) for part in parts])
        self.array, self.left_out = points_of(rows, ignore)
        # The output's points: integers stay integers.
        whole = rows.dtype.kind in "biu" and not np.ma.is_masked(rows)
        self._stored = np.asarray(rows) if whole else self.array
        if self._kept is not None:
            self.array = self.array[self._kept]

    def _points(self, ids: Ids) -> Any:
        """VTK's points, in their type and bits."""
        if self._typed is not None and self._typed.source is not None:
            points = self._typed.mesh.GetPoints().NewInstance()
            points.SetData(_gathered([(self._typed.source, ids - self._start_of(self._typed))], len(ids)))
            return points
        rows = self._stored[ids]
        if rows.shape[1] == 2:
            rows = np.column_stack([rows, np.zeros(len(rows), rows.dtype)])
        if rows.dtype.kind == "b":
            rows = rows.view(np.uint8)
        native = np.ascontiguousarray(rows, rows.dtype.newbyteorder("="))
        return pv.vtk_points(native, deep=True, force_float=False)

    def _start_of(self, part: Part) -> int:
        return int(self._starts[next(i for i, one in enumerate(self._parts) if one is part)])

    def _shares(self, ids: Ids) -> list[tuple[Part, Ids]]:
        """Of each part with points, the ids of ascending ones, counted there."""
        found = []
        for part, start in zip(self._parts, self._starts):
            if len(part.rows):
                first, last = np.searchsorted(ids, (start, start + len(part.rows)))
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
            wrong = ""
            if array is None:
                wrong = "is missing from the input's point data"
            elif not array.IsA("vtkDataArray"):
                wrong = f"is a {array.GetClassName()}, which does not hold numbers"
            elif array.GetNumberOfComponents() != 1:
                wrong = f"has {array.GetNumberOfComponents()} components; a {noun} has 1"
            elif array.GetNumberOfTuples() != len(part.rows):
                wrong = f"has {array.GetNumberOfTuples()} value(s) for {len(part.rows)} point(s)"
            if wrong:
                raise InputError(f'the {noun}s\' array "{name}"{of} {wrong}', "bad_argument")
            values.append(values_of(array))
        return values[0] if len(values) == 1 else np.concatenate([weights_of(some, True)[0] for some in values])

    def _translated(self, error: FlipFlopError, kept: Ids | None) -> FlipFlopError:
        """The same error, in terms of the caller's points and blocks."""
        message, index = str(error), error.index
        composite = any(block.name for block in self.blocks)
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
        return type(error)(message, error.code, index, error.count)

    def _block_at(self, point: int) -> tuple[Block, int]:
        for block in self.blocks:
            if point < block.count:
                break
            point -= block.count
        return block, point


def set_cells(mesh: pv.PolyData, dimension: int, size: int, offsets: Any, connectivity: Any) -> None:
    """Gives a mesh its cells: vertices, lines or polygons, all of one size or as the offsets tell."""
    if offsets is None:
        if not len(connectivity):
            return
        cells = pv.CellArray.from_regular_cells(connectivity.reshape(-1, size))
    else:
        if len(offsets) < 2:
            return
        cells = pv.CellArray.from_arrays(offsets, connectivity)
    (mesh.SetVerts, mesh.SetLines, mesh.SetPolys)[min(dimension, 2)](cells)


def pass_field_data(data: Any, to: Any) -> None:
    """The field data, without the figures of another run."""
    fields = to.GetFieldData()
    fields.PassData(data.GetFieldData())
    for name in [fields.GetArrayName(i) for i in range(fields.GetNumberOfArrays())]:
        if name and name.startswith("FlipFlop"):
            fields.RemoveArray(name)


def _gathered(arrays: Sequence[tuple[Any, Ids]], count: int) -> Any:
    """A new array of VTK's of some tuples of others, all of one type."""
    first = arrays[0][0]
    like = first.NewInstance() if first.HasStandardMemoryLayout() else first.CreateArray(first.GetDataType())
    like.SetName(first.GetName())
    like.SetNumberOfComponents(first.GetNumberOfComponents())
    like.CopyComponentNames(first)
    if first.HasInformation():
        like.CopyInformation(first.GetInformation())
    numbers = first.IsA("vtkDataArray")
    if numbers:
        like.SetLookupTable(first.GetLookupTable())
    like.SetNumberOfTuples(count)
    if numbers and not first.IsA("vtkBitArray"):
        values = [values_of(array)[ids] for array, ids in arrays]
        if count:
            np.concatenate(values, out=values_of(like))
        return like
    size, at = first.GetNumberOfComponents(), 0
    for array, ids in arrays:
        for i in ids.tolist():
            for k in range(size):
                like.SetVariantValue(at, array.GetVariantValue(i * size + k))
                at += 1
    return like


def _copy_arrays(shares: Sequence[tuple[Part, Ids]], count: int, to: Any) -> None:
    """The arrays that all parts have, and what they are active as."""
    leader = shares[0][0].data
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
        index = to.AddArray(_gathered(found, count))
        for attribute in range(leader.NUM_ATTRIBUTES):
            if leader.GetAbstractAttribute(attribute) is array:
                to.SetActiveAttribute(index, attribute)
    # Points can go without the surface that these tell of: they would shade and draw another falsely.
    for attribute in (to.NORMALS, to.TANGENTS, to.EDGEFLAG, to.RATIONALWEIGHTS, to.HIGHERORDERDEGREES):
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


def _mark_for_pyvista(mesh: Any, attributes: Any, to: pv.DataSetAttributes) -> None:
    """Marks the arrays that PyVista knows as booleans or complex numbers, which VTK does not have."""
    if not isinstance(mesh, pv.DataSet):
        return
    for i in range(attributes.GetNumberOfArrays()):
        array = attributes.GetAbstractArray(i)
        name, size = array.GetName(), array.GetNumberOfComponents()
        if not name or not (array.IsA("vtkUnsignedCharArray") or array.IsA("vtkDataArray") and size == 2):
            continue
        if not mesh.GetPointData().GetAbstractArray(name).HasStandardMemoryLayout():
            continue  # PyVista has not made it
        kind = mesh.point_data[name].dtype
        if kind.kind in "bc":
            values = values_of(array)
            to.set_array(values.view(kind).reshape(len(values), -1).squeeze(1) if kind.kind == "c" else
                         values.view(kind), name)


def _turn_marks(attributes: Any) -> None:
    """In the array of ghosts, points' marks become cells'."""
    marks = _marks_of(attributes)
    if marks is None or not marks.GetNumberOfValues():
        return
    values = values_of(marks)
    duplicate = np.where(values & attributes.DUPLICATEPOINT, attributes.DUPLICATECELL, 0)
    hidden = np.where(values & attributes.HIDDENPOINT, attributes.HIDDENCELL, 0)
    values[...] = duplicate | hidden
