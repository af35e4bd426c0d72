# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The array of an algorithm's input that SetInputArrayToProcess() names."""

from __future__ import annotations

import math
from typing import Any

from . import _vtkmodules as vtk
from ._errors import InputError
from ._filter_errors import SettingError
from ._meshes import misfit_of

_vtkAlgorithm = vtk.module("vtkCommonExecutionModel").vtkAlgorithm
_model = vtk.module("vtkCommonDataModel")
_vtkDataObject, _Attributes = _model.vtkDataObject, _model.vtkDataSetAttributes
_OF_POINTS = (_vtkDataObject.FIELD_ASSOCIATION_POINTS, _vtkDataObject.FIELD_ASSOCIATION_POINTS_THEN_CELLS)


def array_to_process(algorithm: Any, data: Any, of: str = "", owner: str = "input", noun: str = "weight") -> Any:
    """The point array of one number for each point; None if none was chosen, or there are no points.

    An empty name chooses none, and so does None if no array has that name. Errors say of which data set it is, whose
    input that is, and what the numbers are.
    """
    choice = _choice_of(algorithm)
    if choice is None or data.GetNumberOfPoints() == 0:
        return None
    points, name = data.GetPointData(), choice.Get(_vtkDataObject.FIELD_NAME())
    if name:
        if name == "None" and not points.HasArray(name):
            return None
        array, what = points.GetAbstractArray(name), f'The {noun}s\' array "{name}"{of}'
    elif not choice.Has(_vtkDataObject.FIELD_ATTRIBUTE_TYPE()):
        return None
    else:
        attribute = choice.Get(_vtkDataObject.FIELD_ATTRIBUTE_TYPE())
        label = _Attributes.GetAttributeTypeAsString(attribute)
        array = points.GetAbstractAttribute(attribute) if label else None
        named = f' "{array.GetName()}",' if array is not None and array.GetName() else ","
        what = f"The {noun}s' array{of}, the point data's active {label or 'array'}{named}"
    whose = "its" if of else f"the {owner}'s"
    fault = _fault_of(array, choice.Get(_vtkDataObject.FIELD_ASSOCIATION()), data.GetNumberOfPoints(), whose, noun)
    if fault:
        raise InputError(f"{what} {fault}.", "bad_argument")
    return array


def factor_of(factor: float, is_used: bool) -> float:
    """The factor of an array of weights; without one it does not matter."""
    if is_used and not math.isfinite(factor):
        raise SettingError(f"Weight Factor is {factor:g}; it must be finite.")
    return factor


def _choice_of(algorithm: Any) -> Any:
    chosen = algorithm.GetInformation().Get(_vtkAlgorithm.INPUT_ARRAYS_TO_PROCESS())
    return None if chosen is None else chosen.GetInformationObject(0)


def _fault_of(array: Any, association: int, count: int, whose: str, noun: str) -> str:
    if association not in _OF_POINTS:
        return f"was asked for as data that does not belong to the points; {noun}s must be point data"
    return misfit_of(array, count, whose, noun)
