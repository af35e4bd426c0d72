# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arrays in the memory of a CUDA device: CuPy's, PyTorch's, JAX's, Numba's.

The engine reads some of its input on the host, whoever does the work. So a host copy is made, which remembers the
memory that it is of; the CUDA engine reads that in place.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _core

# The numbers of DLPack's DLDeviceType.
_CPU, _CUDA, _CUDA_HOST, _CUDA_MANAGED = 1, 2, 3, 13


class HostCopy(np.ndarray[Any, Any]):
    """A host copy of an array on a device.

    Attributes
    ----------
    memory : int
        the address of the array's first number on the device, which has the layout of this copy
    kept
        what owns that memory
    """

    memory: int
    kept: Any


def is_on_device(values: Any, what: str) -> bool:
    """Whether a CUDA device has the values, and the host has not.

    what: the argument's name, in the plural
    """
    if isinstance(values, np.ndarray):
        return False
    if hasattr(values, "__dlpack_device__"):
        kind = int(values.__dlpack_device__()[0])
        if kind in (_CPU, _CUDA_HOST):
            return False
        if kind not in (_CUDA, _CUDA_MANAGED):
            raise TypeError(f"{what} are on the host or on a CUDA device, not on a device of DLPack's type {kind}")
        return True
    return hasattr(values, "__cuda_array_interface__")


def host_copy(values: Any, what: str) -> HostCopy:
    """The values on the host, in the layout that they have on the device.

    Raises
    ------
    DeviceError
        this build has no CUDA engine, or this machine no device for it
    """
    if hasattr(values, "__cuda_array_interface__"):
        interface = values.__cuda_array_interface__
        if interface.get("mask") is not None:
            raise TypeError(f"{what} on a device must not be masked: copy them to the host")
        pointer, shape = int(interface["data"][0]), tuple(interface["shape"])
        kind, strides = np.dtype(interface["typestr"]), interface.get("strides")
        kept = values
    else:
        kept = _core.DeviceArray(values)
        pointer, shape, kind = kept.pointer, kept.shape, np.dtype(f"{kept.kind}{kept.size}")
        strides = tuple(step * kind.itemsize for step in kept.strides)
    if strides is None:
        strides = _row_by_row(shape, kind)
    if any(step < 0 for step in strides):
        raise TypeError(f"{what} on a device must not run backwards, in steps of {strides} bytes: copy them first")
    extent = 0 if 0 in shape else sum((n - 1) * step for n, step in zip(shape, strides)) + kind.itemsize
    memory = _core.copy_from_device(pointer, extent)
    copy = np.ndarray(shape, kind, memory, strides=strides).view(HostCopy)
    copy.memory, copy.kept = pointer, kept
    return copy


def memory_of(array: Any) -> int:
    """Where a device has an array's numbers, too; 0 if none has."""
    return array.memory if type(array) is HostCopy else 0


def _row_by_row(shape: tuple[int, ...], kind: np.dtype[Any]) -> tuple[int, ...]:
    steps = [kind.itemsize]
    for size in shape[:0:-1]:
        steps.insert(0, steps[0] * max(size, 1))
    return tuple(steps[: len(shape)])
