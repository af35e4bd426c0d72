# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Settings of algorithms, as VTK's macros declare them: from a row of a table, all methods of its name.

A setter clamps what is out of range, and modifies the algorithm only if the value is another one.
"""

from __future__ import annotations

import operator
import re
from collections.abc import Callable
from enum import IntEnum
from typing import Any, TypeVar

VTK_INT_MAX = 2**31 - 1
VTK_ID_MAX = 2**63 - 1

Kind = TypeVar("Kind", bound=type)


class Setting:
    """A number or a text, with Set and Get; with a range, also the methods for its ends."""

    def __init__(self, name: str, default: Any, read: Callable[[Any], Any], *ends: Any) -> None:
        self.name, self.default, self.read, self.ends = name, default, read, ends

    def assign(self, algorithm: Any, *values: Any) -> None:
        value = self.read(values[0] if len(values) == 1 else values)
        if self.ends:
            value = min(max(value, self.ends[0]), self.ends[1])
        if algorithm._settings[self.name] != value:
            algorithm._settings[self.name] = value
            algorithm.Modified()

    def install(self, kind: type) -> None:
        name = self.name
        add_method(kind, f"Set{name}", lambda algorithm, *values: self.assign(algorithm, *values))
        add_method(kind, f"Get{name}", lambda algorithm: algorithm._settings[name])
        for suffix, end in zip(("MinValue", "MaxValue"), self.ends):
            add_method(kind, f"Get{name}{suffix}", lambda self, end=end: end)
        add_property(kind, name)

    def text(self, value: Any) -> str:
        """The value as PrintSelf() gives it."""
        return "(none)" if value is None else str(value)


class Flag(Setting):
    """True or false, with On and Off."""

    def __init__(self, name: str, default: bool) -> None:
        super().__init__(name, default, bool)

    def install(self, kind: type) -> None:
        super().install(kind)
        name = self.name
        add_method(kind, f"{name}On", lambda self: getattr(self, f"Set{name}")(True))
        add_method(kind, f"{name}Off", lambda self: getattr(self, f"Set{name}")(False))

    def text(self, value: Any) -> str:
        return "On" if value else "Off"


class Choice(Setting):
    """One of an enumeration, whose constants the class gets; Set...To by the words given for them.

    The enumeration has the name of the setting and "Type", unless it is given; one that exists is used again.
    """

    def __init__(
        self, name: str, default: int, to: str = "To", enumeration: str = "", /, **constants: str
    ) -> None:
        super().__init__(name, default, integer, 0, len(constants) - 1)
        self.constants, self.to, self.enumeration = constants, to, enumeration or f"{name}Type"

    def install(self, kind: type) -> None:
        super().install(kind)
        add_enumeration(kind, self.enumeration, {constant: i for i, constant in enumerate(self.constants.values())})
        name = self.name
        for i, word in enumerate(self.constants):
            add_method(kind, f"Set{name}{self.to}{word}", lambda self, i=i: getattr(self, f"Set{name}")(i))


def add_enumeration(kind: type, name: str, values: dict[str, int]) -> None:
    """A class of constants, which are attributes of the algorithm's class, too. One that is there already has more."""
    if hasattr(kind, name) and name not in vars(kind):
        return
    enumeration = vars(kind).get(name) or IntEnum(name, values)
    setattr(kind, name, enumeration)
    for constant in enumeration:
        setattr(kind, constant.name, constant)


def add_method(kind: type, name: str, method: Callable[..., Any]) -> None:
    """Gives a class a method, unless it has one of its own by that name."""
    if name in vars(kind):
        return
    method.__name__, method.__qualname__ = name, f"{kind.__name__}.{name}"
    setattr(kind, name, method)


def add_property(kind: type, name: str) -> None:
    """The setting as an attribute, in the way of VTK 9.4: facet_mode for FacetMode."""

    def getter(self: Any) -> Any:
        return getattr(self, f"Get{name}")()

    def setter(self: Any, value: Any) -> None:
        getattr(self, f"Set{name}")(value)

    setattr(kind, snake_case(name), property(getter, setter if hasattr(kind, f"Set{name}") else None))


def snake_case(name: str) -> str:
    """cuda_threshold for CUDAThreshold."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()


def integer(value: Any) -> int:
    """As C's int."""
    found = operator.index(value)
    if not -VTK_INT_MAX - 1 <= found <= VTK_INT_MAX:
        raise OverflowError(f"{found} is out of range for int")
    return found


def identifier(value: Any) -> int:
    """As vtkIdType."""
    found = operator.index(value)
    if not -VTK_ID_MAX - 1 <= found <= VTK_ID_MAX:
        raise OverflowError(f"{found} is out of range for vtkIdType")
    return found


def number(value: Any) -> float:
    if isinstance(value, (str, bytes)):
        raise TypeError(f"a number is required, not {value!r}")
    return float(value)


def string(value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError(f"a text is required, not {value!r}")
    return value


def numbers(count: int, read: Callable[[Any], Any] = number) -> Callable[[Any], tuple[Any, ...]]:
    """What reads so many numbers."""

    def reader(values: Any) -> tuple[Any, ...]:
        found = tuple(map(read, values))
        if len(found) != count:
            raise TypeError(f"{count} numbers are required, not {values!r}")
        return found

    return reader


def with_settings(*table: Setting) -> Callable[[Kind], Kind]:
    """Gives a class the methods of the settings in a table, beside those of its bases."""

    def installed(kind: Kind) -> Kind:
        kind._table = (*getattr(kind, "_table", ()), *table)
        for setting in table:
            setting.install(kind)
        return kind

    return installed


