# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A filter's properties as keyword arguments: snake_case for VTK's names, choices by name, nothing else accepted."""

import re

import numpy as np
from vtkmodules.vtkCommonExecutionModel import vtkPolyDataAlgorithm


def set_properties(algorithm, properties):
    """Sets number_of_threads=4 by SetNumberOfThreads(4), engine="cpu" by SetEngineToCPU().

    An unknown name is a TypeError that lists the known ones. A value that the filter does not accept is a ValueError.
    So is a value that the filter would silently replace by the nearest accepted one. The error lists the choices, or
    tells the replacement.
    """
    setters = [name for name in dir(algorithm) if name.startswith("Set") and not hasattr(vtkPolyDataAlgorithm, name)]
    choices = {}
    for setter in setters:
        owner, _, choice = setter.rpartition("To")
        if owner in setters:
            choices.setdefault(owner, {})[_snake_case(choice)] = setter
    of_choices = {setter for owner in choices.values() for setter in owner.values()}
    known = {_plain(setter[3:]): setter for setter in setters if setter not in of_choices}
    for name, value in properties.items():
        setter = known.get(_plain(name))
        if setter is None:
            names = ", ".join(_snake_case(setter[3:]) for setter in known.values())
            raise TypeError(f"{algorithm.GetClassName()} has no property {name}; it has {names}")
        if setter in choices:
            _choose(algorithm, name, value, setter, choices[setter])
        else:
            _set(algorithm, name, value, setter)


def flag(name, value):
    """The value of an argument that is True or False."""
    if not isinstance(value, (bool, np.bool_, int, np.integer)) or value not in (0, 1):
        raise ValueError(f"{name} is True or False, not {value!r}")
    return bool(value)


def _choose(algorithm, name, value, setter, choices):
    """Sets a choice by its name, or by VTK's number."""
    if isinstance(value, str):
        chosen = {_plain(choice): method for choice, method in choices.items()}.get(_plain(value))
        if chosen:
            getattr(algorithm, chosen)()
            return
    else:
        try:
            if _is_kept(algorithm, value, setter):
                return
        except (TypeError, ValueError, OverflowError):
            pass
    names = [f'"{choice}"' for choice in choices]
    raise ValueError(f"{name} is {', '.join(names[:-1])} or {names[-1]}, not {value!r}")


def _set(algorithm, name, value, setter):
    before = _value_of(algorithm, setter)
    if isinstance(before, bool):
        value = flag(name, value)
    try:
        if _is_kept(algorithm, value, setter):
            return
    except (TypeError, ValueError, OverflowError) as error:
        reason = str(error).split(": ", 1)[-1]
        raise ValueError(f"{name} cannot be {value!r}: {reason}") from None
    kept = _value_of(algorithm, setter)
    raise ValueError(f"{name} cannot be {value!r}; the filter would make it {kept!r}")


def _is_kept(algorithm, value, setter):
    """Sets the value, and tells whether the filter kept it, instead of replacing it by another."""
    getattr(algorithm, setter)(value)
    kept = _value_of(algorithm, setter)
    return kept is value or np.array_equal(kept, value)


def _value_of(algorithm, setter):
    return getattr(algorithm, "G" + setter[1:])()


def _plain(name):
    return name.replace("_", "").lower()


def _snake_case(name):
    """best_fitting_plane for BestFittingPlane, cpu for CPU, xy_plane for XYPlane."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()
