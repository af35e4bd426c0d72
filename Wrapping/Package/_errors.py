# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the engine throws, as Python's exceptions: its words, and the index."""

from __future__ import annotations

import errno
import os
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Self


class FlipFlopError(Exception):
    """An error of the engine.

    Attributes
    ----------
    code : str
        what went wrong, in snake_case: "non_finite"
    index : int
        the first point, triangle, constraint or set at fault; -1 if there is none. Of weight_count, how many points
        there are
    count : int
        how many are at fault, or the size asked for; 0 if that tells nothing. Of constraint_point, the point; of
        constraints_cross, the other constraint; of polygons_disagree, a side of the other polygon, where the index is
        one of that to be reversed; of duplicate_sites, the other site
    result : object
        of vtkflipflop.pyvista, after faults of some blocks of a composite: what the call would return, with None in the
        places of these blocks. Otherwise None.
    errors : dict
        of flat index to exception, for the blocks at fault
    """

    __module__ = "vtkflipflop.arrays"  # where users import it from
    code: str
    index: int
    count: int
    result: Any
    errors: dict[int, FlipFlopError]
    _where = ""  # the point in words, where it is not the index alone that tells it
    _of_filters = ""  # what an algorithm of VTK's says instead

    def __init__(self, message: str, code: str = "", index: int = -1, count: int = 0) -> None:
        super().__init__(message)
        self.code, self.index, self.count = code, index, count
        self.result, self.errors = None, {}

    def for_filters(self, sentence: str) -> Self:
        """The error, for which an algorithm of VTK's says that."""
        self._of_filters = sentence
        return self


class InputError(FlipFlopError, ValueError):
    """The input is at fault."""

    __module__ = "vtkflipflop.arrays"


class OutOfMemoryError(FlipFlopError, MemoryError):
    """There is not enough memory."""

    __module__ = "vtkflipflop.arrays"


class DeviceError(FlipFlopError, RuntimeError):
    """The CUDA engine was asked for and could not do it."""

    __module__ = "vtkflipflop.arrays"


class AbortedError(FlipFlopError, RuntimeError):
    """The callable given as progress returned False."""

    __module__ = "vtkflipflop.arrays"


# In the order of the engine's ErrorCode: the code's name, the exception, what the index counts, what the count counts.
_CODES = (
    ("non_finite", InputError, "first at point {}", "{} such point(s) in all"),
    ("too_many_points", InputError, "", "{} points"),
    ("out_of_memory", OutOfMemoryError, "", "{} bytes were asked for"),
    ("aborted", AbortedError, "", ""),
    ("bad_argument", InputError, "at index {}", ""),
    ("weight_count", InputError, "{} points", "{} weights"),
    ("bad_triangle", InputError, "first at triangle {}", "{} such triangle(s) in all"),
    ("not_simple", InputError, "first at cell {}", "{} such polygon(s) in all"),
    ("not_closed", InputError, "first at triangle {}", "{} edge(s) in all"),
    ("not_manifold", InputError, "first at triangle {}", "{} such edge(s) and vertices in all"),
    ("not_oriented", InputError, "first at triangle {}", ""),
    ("not_star_shaped", InputError, "first at triangle {}", "{} such triangle(s) in all"),
    ("no_kernel", InputError, "", ""),
    ("constraint_point", InputError, "constraint {}", "point {}"),
    ("constraints_cross", InputError, "constraint {}", "and constraint {}"),
    ("polygons_disagree", InputError, "reverse that of constraint {}", "which disagrees with that of constraint {}"),
    ("not_convex", InputError, "at corner {}", ""),
    ("duplicate_sites", InputError, "sites {}", "and {}"),
    ("bad_area", InputError, "first at site {}", "{} such site(s) in all"),
    ("no_device", DeviceError, "", ""),
    ("device_memory", DeviceError, "", "{} bytes were asked for"),
    ("device_failed", DeviceError, "error {} of the CUDA runtime", ""),
    ("internal", FlipFlopError, "", ""),
)
# Of these, the count is a number of its own kind, which may be 0.
_ANY_COUNT = {"weight_count", "constraint_point", "constraints_cross", "polygons_disagree", "duplicate_sites"}


def name_of_code(code: int) -> str:
    """The name of one of the engine's codes."""
    return _CODES[code][0]


def of_engine(code: int, text: str, index: int, count: int) -> FlipFlopError:
    """The exception for an error of the engine."""
    name, kind, template, number = _CODES[code]
    parts = [template.format(index)] if template and index >= 0 else []
    parts += [number.format(count)] if number and (count > 0 or name in _ANY_COUNT) else []
    return kind(text + (": " + ", ".join(parts) if parts else ""), name, index, count)


def at_points(text: str, code: str, first: int, count: int) -> InputError:
    """The exception for so many points at fault."""
    return InputError(f"{text}: first at point {first}, {count} such point(s) in all", code, first, count)


@contextmanager
def of_part(name: str) -> Iterator[None]:
    """Errors of what a part of the input has begin with its name."""
    try:
        yield
    except FlipFlopError as error:
        raise type(error)(f"{name}: {error}", error.code, error.index, error.count) from None
    except (TypeError, ValueError) as error:
        raise type(error)(f"{name}: {error}") from None


def of_file(number: int, path: os.PathLike[str]) -> OSError:
    """The exception for a file that the engine could not read or write."""
    advice = ": if it is damaged or missing, remove its folder" if number in (errno.EIO, errno.ENOENT) else ""
    return OSError(number, os.strerror(number) + advice, os.fspath(path))


def warn_caller(sentence: str) -> None:
    """A warning at the line outside of this package that called."""
    level, frame = 1, sys._getframe()
    here = Path(__file__).parent
    while frame.f_back is not None and Path(frame.f_code.co_filename).parent == here:
        level, frame = level + 1, frame.f_back
    warnings.warn(sentence, stacklevel=level)
