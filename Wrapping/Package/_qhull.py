# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What programs that use Qhull by way of scipy.spatial know of it: its error, and options."""

from __future__ import annotations

from ._errors import warn_caller

_said: set[str] = set()


class QhullError(RuntimeError):
    """The points span less than their space, or half-spaces have no bounded intersection with the point inside."""

    __module__ = "vtkflipflop.spatial"  # where users import it from


def say_unused(qhull_options: str | None) -> None:
    """Says, once, that options have no meaning."""
    if qhull_options and qhull_options not in _said:
        _said.add(qhull_options)
        warn_caller(f"qhull_options {qhull_options!r} mean nothing here: all decisions are exact")
