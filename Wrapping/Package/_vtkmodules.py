# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The VTK of this process, and NumPy's views of its arrays.

It is the one that PyVista runs on, if PyVista has been imported; otherwise vtkmodules. Nothing else of this package
imports VTK.
"""

from __future__ import annotations

import sys
from importlib import import_module
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray


def _package() -> str:
    pyvista = sys.modules.get("pyvista")
    if hasattr(pyvista, "PolyData"):
        return package_of(pyvista.PolyData)
    for name in ("vtkmodules", "cvista"):
        if find_spec(name):
            return name
    raise ImportError("VTK is missing: pip install vtk. Without it there is vtkflipflop.arrays", name="vtkmodules")


def package_of(kind: type) -> str:
    """The package that the VTK of a class is."""
    base = next(one for one in kind.__mro__ if one.__name__ == "vtkObjectBase")
    return base.__module__.split(".")[0]


PACKAGE = _package()


def module(name: str) -> Any:
    return import_module(f"{PACKAGE}.{name}")


_core, _model = module("vtkCommonCore"), module("vtkCommonDataModel")
vtkObjectBase, vtkPoints, vtkIdTypeArray = _core.vtkObjectBase, _core.vtkPoints, _core.vtkIdTypeArray
vtkPolyData, vtkCellArray, vtkImageData = _model.vtkPolyData, _model.vtkCellArray, _model.vtkImageData
vtkMatrix4x4 = module("vtkCommonMath").vtkMatrix4x4
_support = module("util.numpy_support")
# Whether the memory that an array has of NumPy lives as long as any array that shares it. Else it lives as long as the
# first of them alone, so arrays get copies.
_SHARES = hasattr(vtkIdTypeArray, "GetBuffer")


def values_of(array: Any) -> Any:
    """A VTK array's values: its own memory, or a copy of what is stored component by component, as bits or as texts."""
    if array.IsA("vtkStringArray"):
        return np.array([array.GetValue(i) for i in range(array.GetNumberOfValues())], object)
    if array.IsA("vtkBitArray"):
        numbers = _core.vtkUnsignedCharArray()
        numbers.DeepCopy(array)
        return np.asarray(_support.vtk_to_numpy(numbers)).reshape(-1, array.GetNumberOfComponents())
    if not array.HasStandardMemoryLayout() and hasattr(array, "ToAOSDataArray"):
        array = array.ToAOSDataArray()  # cvista 9.7 does not read the other one on every Python
    return np.asarray(_support.vtk_to_numpy(array))


def array_of(values: NDArray[Any], name: str = "", deep: bool = True) -> Any:
    """An array of VTK's, which may share the memory, unless it is to be a copy."""
    if values.dtype.kind == "O":
        array = _core.vtkStringArray()
        array.SetNumberOfValues(len(values))
        for i, text in enumerate(values.tolist()):
            array.SetValue(i, text)
    else:
        native = np.ascontiguousarray(values, values.dtype.newbyteorder("="))
        array = _support.numpy_to_vtk(native, deep or not _SHARES)
    if name:
        array.SetName(name)
    return array


def copy_as(kind: str, values: NDArray[Any], name: str) -> Any:
    """An array of that class, where NumPy's types do not tell it."""
    array = getattr(_core, kind)()
    array.SetName(name)
    array.SetNumberOfTuples(len(values))
    if len(values):
        values_of(array)[...] = values
    return array


def ids_of(values: NDArray[np.int64], name: str = "") -> Any:
    """A vtkIdTypeArray, which may share the memory."""
    array, native = vtkIdTypeArray(), np.ascontiguousarray(values, np.int64)
    if _SHARES:
        array.SetVoidArray(native, native.size, 1)
        array.GetBuffer()._numpy_reference = native
    else:
        array.SetNumberOfValues(native.size)
        values_of(array)[...] = native
    if name:
        array.SetName(name)
    return array


def points_of(rows: NDArray[Any], deep: bool = True) -> Any:
    """The vtkPoints of n rows of 3 coordinates, in their type."""
    points = vtkPoints()
    points.SetData(array_of(rows, deep=deep))
    return points


def cells_of(offsets: NDArray[np.int64], connectivity: NDArray[np.int64]) -> Any:
    """A vtkCellArray, which may share the memory."""
    cells = vtkCellArray()
    cells.SetData(ids_of(offsets), ids_of(connectivity))
    return cells


def id_list_of(ids: NDArray[np.int64]) -> Any:
    """A vtkIdList, which takes no array: by way of a cell."""
    found = _core.vtkIdList()
    if len(ids):
        cells_of(np.array([0, len(ids)]), ids).GetCellAtId(0, found)
    return found


def matrix_of(rows: NDArray[np.float64]) -> Any:
    """A vtkMatrix4x4."""
    matrix = vtkMatrix4x4()
    matrix.DeepCopy(rows.ravel().tolist())
    return matrix


def rows_of_matrix(matrix: Any) -> NDArray[np.float64]:
    return np.array([[matrix.GetElement(i, k) for k in range(4)] for i in range(4)])
