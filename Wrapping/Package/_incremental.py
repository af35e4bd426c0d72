# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Objects by scipy's names to which more can be added until they are closed."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Self

from ._fallback import WithFallback


class Incremental(WithFallback):
    """What is computed of the input is computed when it is first read."""

    def _open(self, incremental: bool) -> None:
        self._incremental, self._is_open = bool(incremental), True

    def _require_open(self) -> None:
        if not self._is_open:
            raise RuntimeError("this instance is closed")
        if not self._incremental:
            raise RuntimeError("incremental mode not enabled or already closed")

    def _forget(self) -> None:
        """What was computed of the input before."""
        for name in [name for name in self.__dict__ if isinstance(getattr(type(self), name, None), cached_property)]:
            del self.__dict__[name]

    def close(self) -> None:
        """No more is added."""
        self._is_open = self._incremental = False

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()
