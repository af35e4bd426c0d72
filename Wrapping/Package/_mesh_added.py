# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points that lines add to a mesh, with point data: the lines' own points, and those where they cross."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _vtkmodules as vtk
from ._meshes import Cloud, block_of, gathered, like_of
from ._refine import sums_of
from ._results import Floats, Ids

_IDS = "vtkOriginalPointIds"
_vtkPointData = vtk.module("vtkCommonDataModel").vtkPointData
_vtkIdList = vtk.module("vtkCommonCore").vtkIdList
_FLOATS = ("float", "double")


def with_points(given: Any, points: Any, lines: Any, rows: Ids) -> Any:
    """The mesh with more points: these, of that data set of lines, if there is one.

    Their data is that of the lines' array of the same name; NaN, or 0 and empty texts, if none fits.
    """
    created = vtk.vtkPolyData()
    created.SetPoints(points)
    wanted = _vtkPointData()
    wanted.InterpolateAllocate(given.GetPointData(), len(rows))
    own = None if lines is None else lines.GetPointData()
    for i in range(wanted.GetNumberOfArrays()):
        array = wanted.GetAbstractArray(i)
        same = own.GetAbstractArray(array.GetName()) if own is not None and array.GetName() else None
        index = created.GetPointData().AddArray(_filled(array, same, rows))
        for attribute in range(wanted.NUM_ATTRIBUTES):
            if wanted.GetAbstractAttribute(attribute) is array:
                created.GetPointData().SetActiveAttribute(index, attribute)
    return _appended(given, created)


def with_crossings(given: Any, positions: Floats, ends: Ids, shares: Floats) -> Any:
    """The mesh with more points, at these shares of the ways between others: so is their data."""
    created = vtk.vtkPolyData()
    created.SetPoints(vtk.points_of(positions))
    data = created.GetPointData()
    data.InterpolateAllocate(given.GetPointData(), len(shares))
    for k, ((a, b), share) in enumerate(zip(ends.tolist(), shares.tolist())):
        data.InterpolateEdge(given.GetPointData(), k, a, b, share)
    return _appended(given, created)


def with_interpolated(given: Any, positions: Floats, offsets: Ids, ids: Ids, shares: Floats) -> Any:
    """The mesh with more points, each of shares of others: so is their data."""
    created = vtk.vtkPolyData()
    created.SetPoints(vtk.points_of(positions))
    own = _vtkPointData()
    own.ShallowCopy(given.GetPointData())
    own.RemoveArray(_IDS)
    data = created.GetPointData()
    data.InterpolateAllocate(own, len(positions))
    arrays = [data.GetAbstractArray(i) for i in range(data.GetNumberOfArrays())]
    row = _vtkIdList()
    for array in arrays:
        source = own.GetAbstractArray(array.GetName()) if array.GetName() else _unnamed_of(own)
        if array.GetDataTypeAsString() in _FLOATS:
            values = vtk.values_of(source)
            columns = values.reshape(len(values), -1)[ids].astype(np.float64) * shares[:, None]
            sums = sums_of(columns, offsets).astype(values.dtype)
            array.DeepCopy(vtk.array_of(sums.reshape(len(sums), *values.shape[1:]), array.GetName()))
            continue
        for i, (begin, end) in enumerate(zip(offsets[:-1].tolist(), offsets[1:].tolist())):
            row.Reset()
            for other in ids[begin:end].tolist():
                row.InsertNextId(other)
            array.InterpolateTuple(i, row, source, shares[begin:end].tolist())
    return _appended(given, created)


def shares_of(at: Floats, a: Floats, b: Floats) -> Floats:
    """How far positions in the plane are on the ways from others to others, from 0 to 1; rounded."""
    # By halves, which do not overflow; where they lose bits, so does the share.
    whole, part = 0.5 * b - 0.5 * a, 0.5 * at - 0.5 * a
    rows = np.arange(len(whole))
    axis = (np.abs(whole[:, 0]) < np.abs(whole[:, 1])).astype(int)
    length = whole[rows, axis]
    with np.errstate(all="ignore"):
        return np.where(length == 0.0, 0.5, np.clip(part[rows, axis] / length, 0.0, 1.0))


def pass_empty_data(given: Any, to: Any) -> None:
    """Of a mesh without points, the arrays, which added points are to have."""
    data = to.GetPointData()
    data.ShallowCopy(given.GetPointData())
    data.AddArray(vtk.ids_of(np.empty(0, np.int64), _IDS))


def ids_of_points(mesh: Any) -> NDArray[np.int64]:
    """The caller's ids; -1 of points that were added."""
    return np.asarray(vtk.values_of(mesh.GetPointData().GetAbstractArray(_IDS)), np.int64)


def _unnamed_of(data: Any) -> Any:
    """The array without a name: data has one such at most."""
    arrays = (data.GetAbstractArray(i) for i in range(data.GetNumberOfArrays()))
    return next(array for array in arrays if not array.GetName())


def _filled(array: Any, same: Any, rows: Ids) -> Any:
    """An array like one, by the values of another."""
    fits = same is not None and same.GetNumberOfComponents() == array.GetNumberOfComponents()
    if fits and same.GetDataType() == array.GetDataType():
        return gathered([(same, rows)], len(rows))
    like = like_of(array, len(rows))
    if not array.IsA("vtkDataArray"):
        return like
    if fits and same.IsA("vtkDataArray"):
        for k, row in enumerate(rows.tolist()):
            like.SetTuple(k, same.GetTuple(row))
    else:
        like.Fill(np.nan if array.GetDataTypeAsString() in _FLOATS else 0.0)
    return like


def _appended(given: Any, created: Any) -> Any:
    whole = Cloud([block_of(given, ""), block_of(created, "")], False, True)
    made = whole.mesh(np.arange(whole.count), True)
    ids = np.full(whole.count, -1)
    ids[: given.GetNumberOfPoints()] = ids_of_points(given)
    made.GetPointData().AddArray(vtk.ids_of(ids, _IDS))
    return made
