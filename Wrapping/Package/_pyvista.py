# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista's dress: what it takes for a mesh as VTK's data, and results as its classes, with its own marks."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any

import numpy as np
import pyvista as pv

from . import _mesh_runs
from . import _vtkmodules as vtk
from ._errors import FlipFlopError
from ._input import is_array_like, refuse_geometry
from ._meshes import LEAVES, Block, is_tree, leaves_of
from ._results import Progress, Report
from ._vtkmodules import values_of

if vtk.PACKAGE != vtk.package_of(pv.PolyData):
    raise ImportError(
        f"PyVista {pv.__version__} runs on {vtk.package_of(pv.PolyData)}, and vtkflipflop has begun to run on "
        f"{vtk.PACKAGE}: import pyvista first",
        name="pyvista",
    )

Output = pv.PolyData | pv.MultiBlock | pv.PartitionedDataSet
# PyVista 0.48 and later look at all arrays' lengths; what counts is looked at here, too.
_UNCHECKED: dict[str, Any] = {"validate": False} if "validate" in inspect.signature(pv.wrap).parameters else {}


def data_of(mesh: Any) -> Any:
    """The mesh as a data object, PyVista's where it has a class for it; or numbers that are still to be looked at."""
    if isinstance(mesh, np.ndarray):
        return mesh
    if hasattr(mesh, "IsA"):
        if not isinstance(mesh, vtk.vtkObjectBase):
            raise TypeError(
                f"{type(mesh).__name__} is of another VTK, the module {type(mesh).__module__}, than PyVista "
                f"{pv.__version__}, which runs on {vtk.PACKAGE}: the one cannot use the other's data"
            )
        if mesh.IsA("vtkPoints"):
            mesh = mesh.GetData()
        if mesh.IsA("vtkDataArray"):
            return values_of(mesh)
    elif is_array_like(mesh):
        return mesh
    refuse_geometry(mesh, "points")
    data = _wrapped(mesh)
    if not hasattr(data, "IsA") or not any(map(data.IsA, (*LEAVES, "vtkDataObjectTree"))):
        raise TypeError(f"{type(mesh).__name__} has no points to take")
    return data


def each_block(
    data: Any,
    make: Callable[[Block, Report], list[Any]],
    count: int,
    progress: Progress,
    leaves: tuple[str, ...] = LEAVES,
) -> list[Output]:
    """What is made of each block, so many objects of PyVista's; an error has what the others have."""
    try:
        return [dressed(made, data) for made in _mesh_runs.each_block(data, make, count, progress, leaves)]
    except FlipFlopError as error:
        if isinstance(error.result, tuple):
            error.result = tuple(dressed(made, data) for made in error.result)
        elif error.result is not None:
            error.result = dressed(error.result, data)
        raise


def dressed(made: Any, source: Any) -> Output:
    """PyVista's object of a result; its arrays that the source has as booleans or complex numbers are such."""
    found: Output = _wrapped(made)
    pairs = zip(leaves_of(found), leaves_of(source)) if is_tree(found) else [(found, _leader_of(source))]
    for leaf, mesh in pairs:
        if isinstance(mesh, pv.DataSet) and isinstance(leaf, pv.DataSet):
            _mark(leaf.point_data, mesh)
            _mark(leaf.cell_data, mesh)
    return found


def _wrapped(data: Any) -> Any:
    try:
        return pv.wrap(data, **_UNCHECKED)
    except (NotImplementedError, TypeError):
        return data  # PyVista has no class for some composites


def _leader_of(source: Any) -> Any:
    """The data set; of a composite the first one that has points."""
    if not is_tree(source):
        return source
    return next((leaf for leaf in leaves_of(source) if leaf is not None and leaf.GetNumberOfPoints()), None)


def _mark(attributes: pv.DataSetAttributes, mesh: pv.DataSet) -> None:
    """Marks the arrays that PyVista knows as booleans or complex numbers, which VTK does not have."""
    given = mesh.GetPointData()
    for i in range(attributes.GetNumberOfArrays()):
        array = attributes.GetAbstractArray(i)
        name, size = array.GetName(), array.GetNumberOfComponents()
        if not name or not (array.IsA("vtkUnsignedCharArray") or array.IsA("vtkDataArray") and size == 2):
            continue
        own = given.GetAbstractArray(name)
        if own is None or not own.HasStandardMemoryLayout():
            continue  # PyVista has not made it
        kind = mesh.point_data[name].dtype
        if kind.kind == "b" and array.IsA("vtkUnsignedCharArray"):
            attributes.set_array(values_of(array).view(kind), name)
        elif kind.kind == "c" and size == 2:
            values = values_of(array).view(kind)
            attributes.set_array(values.reshape(len(values), -1).squeeze(1), name)
