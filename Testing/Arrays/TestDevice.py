# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arrays on a CUDA device. No device is needed: host memory stands for the device's, where a test says so."""

import ctypes

import numpy as np
import pytest

from vtkflipflop import _core
from vtkflipflop.arrays import DeviceError, convex_hull, regular_triangulation

RANDOM = np.random.default_rng(10)
POINTS, WEIGHTS = RANDOM.random((300, 3)), RANDOM.random(300) * 0.01


class OnDevice:
    """As Numba's arrays are: no more than the interface."""

    def __init__(self, array, **more):
        interface = dict(array.__array_interface__, **more)
        self.array = array
        self.__cuda_array_interface__ = {key: interface[key] for key in interface if key != "descr"} | {"version": 3}


class ByDlpack:
    """As JAX's arrays are; here the memory is the host's, and only the type of device is told wrongly."""

    def __init__(self, array, kind=2):
        self.array, self.kind = array, kind

    def __dlpack_device__(self):
        return self.kind, 0

    def __dlpack__(self, **options):
        return self.array.__dlpack__(**{key: options[key] for key in options if key == "max_version"})


@pytest.fixture
def device(monkeypatch):
    """A device whose memory is the host's. What it is asked for is told."""
    asked = []

    def copy(pointer, size):
        asked.append((pointer, size))
        return np.frombuffer(ctypes.string_at(pointer, size), np.uint8)

    monkeypatch.setattr(_core, "copy_from_device", copy)
    return asked


LAYOUTS = {
    "rows": lambda array: array,
    "columns": np.asfortranarray,
    "every third": lambda array: np.repeat(array, 3, axis=0)[::3],
    "float32": lambda array: array.astype(np.float32).astype(np.float64).astype(np.float32),
    "integers": lambda array: np.round(array * 100).astype(np.int32),
    "big-endian": lambda array: array.astype(">f8"),
    "empty": lambda array: array[:0],
}


@pytest.mark.parametrize("of", [OnDevice, ByDlpack])
@pytest.mark.parametrize("layout", LAYOUTS)
def test_points_on_a_device(device, layout, of):
    points = LAYOUTS[layout](POINTS)
    if of is ByDlpack and layout == "big-endian":
        pytest.skip("DLPack has this machine's byte order alone")
    expected = convex_hull(points)
    hull = convex_hull(of(points))
    assert hull.simplices.tobytes() == expected.simplices.tobytes()
    assert hull.volume == expected.volume
    if layout != "empty":
        # No more is copied than lies between the first number and the last.
        strides = zip(points.shape, points.strides)
        assert device == [(points.ctypes.data, sum((n - 1) * step for n, step in strides) + points.itemsize)]


def test_weights_on_a_device(device):
    expected = regular_triangulation(POINTS, WEIGHTS)
    for points, weights in ((OnDevice(POINTS), OnDevice(WEIGHTS)), (POINTS, ByDlpack(WEIGHTS))):
        found = regular_triangulation(points, weights)
        assert found.simplices.tobytes() == expected.simplices.tobytes()
        assert np.array_equal(found.hidden, expected.hidden)


def test_the_engine_is_told_where_the_device_has_them(device, monkeypatch):
    told = []
    settings = _core.Settings

    class Told:
        def __new__(cls, *arguments):
            told.append(settings(*arguments))
            return told[-1]

    monkeypatch.setattr(_core, "Settings", Told)
    convex_hull(OnDevice(POINTS))
    regular_triangulation(OnDevice(POINTS), OnDevice(WEIGHTS))
    convex_hull(OnDevice(np.asfortranarray(POINTS)))  # read in another layout
    convex_hull(OnDevice(POINTS.astype(np.float32).astype(int)))  # read as other numbers
    convex_hull(POINTS)
    here, weights = POINTS.ctypes.data, WEIGHTS.ctypes.data
    found = [(one.points_memory, one.weights_memory) for one in told]
    assert found == [(here, 0), (here, weights), (0, 0), (0, 0), (0, 0)]


def test_memory_that_the_host_can_read():
    expected = convex_hull(POINTS)
    for kind in (1, 3):  # the host's, and the host's as CUDA has pinned it
        assert convex_hull(ByDlpack(POINTS, kind)).volume == expected.volume


@pytest.mark.skipif(_core.cuda_status()[1], reason="there is a device")
def test_without_a_device():
    with pytest.raises(DeviceError, match="no device for the CUDA engine") as caught:
        convex_hull(OnDevice(POINTS))
    assert caught.value.code == "no_device"
    with pytest.raises(DeviceError, match="no device for the CUDA engine"):
        convex_hull(POINTS, engine="cuda")


def test_what_is_not_taken(device):
    with pytest.raises(TypeError, match="not on a device of DLPack's type 10"):
        convex_hull(ByDlpack(POINTS, 10))
    with pytest.raises(TypeError, match="masked"):
        convex_hull(OnDevice(POINTS, mask=OnDevice(POINTS > 2)))
    with pytest.raises(TypeError, match="backwards"):
        convex_hull(OnDevice(POINTS[::-1]))
    with pytest.raises(ValueError, match="not of shape"):
        convex_hull(OnDevice(WEIGHTS))
    with pytest.raises(TypeError, match="complex"):
        convex_hull(ByDlpack(POINTS.astype(complex)))
