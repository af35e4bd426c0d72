# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arguments that are choices and numbers: of the wrong type they are a TypeError, otherwise wrong a ValueError."""

from __future__ import annotations

from dataclasses import dataclass
from operator import index
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._input import array_of, doubles_of, is_array_like, refuse_geometry, refuse_masked


@dataclass
class Weights:
    """What weights are made of: a point array's name, or numbers, or None; all times a factor, and radii squared."""

    values: Any
    are_radii: bool
    factor: float

    def computed(self, values: NDArray[Any]) -> NDArray[Any]:
        """The weights of exact numbers."""
        weights: NDArray[Any] | None = _core.compute_weights(values, self.are_radii, self.factor)
        return values if weights is None else weights


def choice_of(name: str, value: Any, choices: tuple[str, ...]) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{name} is one of {', '.join(map(repr, choices))}, not {value!r}")
    if value not in choices:
        raise ValueError(f"{name} is one of {', '.join(map(repr, choices))}, not {value!r}")
    return value


def flag_of(name: str, value: Any) -> bool:
    if not isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name} is True or False, not {value!r}")
    return bool(value)


def threads_of(value: Any) -> int:
    try:
        number = int(value.__index__())
    except (AttributeError, TypeError):
        raise TypeError(f"threads is an integer, not {value!r}") from None
    if not 0 <= number < 2**31:
        raise ValueError(f"threads is 0 (all) or more, not {value!r}")
    return number


def numbers_of(name: str, value: Any, count: int) -> tuple[float, ...]:
    """So many finite numbers."""
    refuse_geometry(value, name)
    if not is_array_like(value):
        raise TypeError(f"{name} is {count} numbers, not {value!r}")
    array = doubles_of(value, f"the numbers of {name}")
    if array.shape != (count,) or not np.isfinite(array).all():
        raise ValueError(f"{name} is {count} finite numbers, not {value!r}")
    return tuple(array.tolist())


def float_of(name: str, value: Any) -> float:
    if isinstance(value, (str, bytes)) or np.ndim(value) != 0:
        raise TypeError(f"{name} is a number, not {value!r}")
    try:
        return float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} is a number, not {value!r}") from None


def number_of(name: str, value: Any) -> float:
    number = float_of(name, value)
    if not np.isfinite(number):
        raise ValueError(f"{name} is a finite number, not {value!r}")
    return number


def mask_of(name: str, value: Any, count: int) -> NDArray[np.bool_]:
    """A copy of an array of so many truths."""
    array = array_of(value, name)
    refuse_masked(array, name)
    if array.dtype != bool and array.size:
        raise TypeError(f"{name} is an array of bool, not of type {array.dtype}")
    if array.shape != (count,):
        raise ValueError(f"{name} is an array of {count} truths, one for each cell, not of shape {array.shape}")
    return np.array(array, bool)


def most_of(name: str, value: Any) -> int:
    """A greatest number, 1 or more; 0 where there is none."""
    if value is None:
        return 0
    try:
        number = index(value)
    except TypeError:
        raise TypeError(f"{name} is an integer or None, not {value!r}") from None
    if not 0 < number < 2**63:
        raise ValueError(f"{name} is 1 or more, or None, not {value}")
    return number


def length_of(name: str, value: Any) -> float:
    """0 or more, also infinity."""
    number = float_of(name, value)
    if not number >= 0:
        raise ValueError(f"{name} is a length of 0 or more, not {value!r}")
    return number


def weights_of_call(weights: Any, radii: Any, factor: Any, composite: bool) -> Weights:
    """What the arguments of these names tell."""
    if weights is not None and radii is not None:
        raise ValueError("a point has a weight or a radius: give weights or radii, not both")
    values = weights if radii is None else radii
    if values is not None and not isinstance(values, str) and composite:
        what = "weights" if radii is None else "radii"
        raise TypeError(f"the {what} of a composite are the name of a point array")
    return Weights(values, radii is not None, number_of("weight_factor", factor))
