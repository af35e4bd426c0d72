# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is scipy.spatial's alone: an error that names it, or its own object in place of one of here."""

from __future__ import annotations

from importlib import import_module
from typing import Any


class WithFallback:
    """A class by a name of scipy.spatial. Subclasses elsewhere have arguments of their own, and no fallback."""

    def __new__(cls, *arguments: Any, fallback: bool = False, **settings: Any) -> Any:
        """With fallback, scipy's own object where this class has none. Copies are made without arguments."""
        if fallback and cls is _own(cls) and (arguments or settings) and cls._why_not(*arguments, **settings):
            return getattr(import_module("scipy.spatial"), cls.__name__)(*arguments, **settings)
        return super().__new__(cls)

    @classmethod
    def _why_not(cls, *arguments: Any, **settings: Any) -> str:
        """Why this class has no object of __init__'s arguments; empty: it has."""
        raise NotImplementedError

    def _check(self, *arguments: Any, **settings: Any) -> None:
        """Raises NotImplementedError if this class has no object of these arguments."""
        why_not, own = self._why_not(*arguments, **settings), _own(type(self))
        if why_not:
            advice = f"take scipy.spatial.{own.__name__}" + ", or pass fallback=True" * (type(self) is own)
            raise NotImplementedError(f"{why_not}: {advice}")


def _own(kind: type) -> type:
    """The class of this package that a class is, or is derived from."""
    return next(some for some in kind.__mro__ if some.__module__.partition(".")[0] == __package__)
