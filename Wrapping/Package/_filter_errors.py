# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Why a run of an algorithm gave no result: a sentence and a code, those of the compiled classes."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

from . import _core
from ._errors import FlipFlopError, OutOfMemoryError, name_of_code

# As vtkFFErrorCode.
NO_ERROR = 0
SETTING, INPUT, NON_FINITE, SURFACE, CONSTRAINT, MEMORY, DEVICE, PROCESS, INTERNAL = range(40001, 40010)
_NO_MEMORY = "There is not enough memory for this input."


class SettingError(ValueError):
    """Settings that do not go together."""


class ConstraintError(ValueError):
    """Constraints that do not go together, or not with the points."""


@dataclass
class Failure:
    """A sentence, the code, and of numbers that are not finite, how many points have some."""

    message: str
    code: int
    non_finite: int = 0

    @classmethod
    def of(cls, error: Exception, name: str, advice: str) -> Failure:
        """Of an exception in the work on a data set of that name.

        The advice is what to do where numbers are not finite.
        """
        if isinstance(error, SettingError):
            found = cls(str(error), SETTING)
        elif isinstance(error, ConstraintError):
            found = cls(str(error), CONSTRAINT)
        elif isinstance(error, OutOfMemoryError) and error.count > 0 or not isinstance(error, MemoryError):
            found = cls._of_engine(error, name, advice) if isinstance(error, FlipFlopError) else cls._of_other(error)
        else:
            found = cls(_NO_MEMORY, MEMORY)
        found.message = found.message[:1].upper() + found.message[1:]
        found.message += "" if found.message.endswith(".") else "."
        if name and name not in found.message:
            found.message = f"{name[0].upper()}{name[1:]}: {found.message}"
        return found

    @classmethod
    def _of_other(cls, error: Exception) -> Failure:
        """Of Python's: values are the caller's fault, all else is ours."""
        is_of_value = isinstance(error, ValueError) and not isinstance(error, UnicodeError)
        return cls(str(error) or type(error).__name__, INPUT if is_of_value else INTERNAL)

    @classmethod
    def _of_engine(cls, error: FlipFlopError, name: str, advice: str) -> Failure:
        of = f" of {name}" if name else ""
        if error._of_filters:
            return cls(error._of_filters, INPUT)
        if error.code == "non_finite" and error.index >= 0:
            sentence = (
                f"{getattr(error, 'what', 'A coordinate')} is NaN or infinite: first at "
                f"{error._where or f'point {error.index}{of}'}, {error.count} such point(s) in all. {advice}"
            )
            return cls(sentence, NON_FINITE, error.count)
        if error.code == "inexact":
            kind = str(error).split()[1]
            return cls(
                f"A {kind} is a 64-bit integer that no double holds: first at "
                f"{error._where or f'point {error.index}{of}'}. "
                # Other disks have other radii, but weights may be shifted.
                + ("Round the radii to doubles." if kind == "radius"
                   else f"Subtract an offset from every {kind}: the result has the same shape."),
                INPUT,
            )
        advice = next((advice for words, advice in _OF_WEIGHTS if words in str(error)), "")
        if advice:
            what = str(error).split(": first at")[0]
            return cls(f"{what}: first at {error._where or f'point {error.index}{of}'}. {advice}", INPUT)
        text, code = _TEXTS.get(error.code, ("", INPUT))
        if error.code in ("bad_argument", "weight_count") or not text:
            return cls(str(error), code)
        problem = _core.cuda_status()[3] if error.code == "no_device" else str(error)
        return cls(text.format(index=error.index, count=error.count, of=of, text=problem), code)


@contextmanager
def naming(what: str) -> Iterator[None]:
    """In an error about numbers that are not finite, what they are: "A coordinate or a weight"."""
    try:
        yield
    except FlipFlopError as error:
        error.what = what  # type: ignore[attr-defined]
        raise


# Of what the engine says of weights, and what to do then.
_OF_WEIGHTS = (
    (
        "radius is negative",
        "Radii are lengths. If the array has weights, which may be negative, set Weight Mode to Weights.",
    ),
    ("is more than a double holds", "Use another unit of length, or a smaller factor."),
)
# Of the engine's codes.
_TEXTS: dict[str, tuple[str, int]] = {
    name_of_code(code): (text, SETTING - 1 + kind) for code, text, kind in _core.filter_errors()
}
