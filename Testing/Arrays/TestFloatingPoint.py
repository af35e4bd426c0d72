# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Results do not depend on the caller's floating-point environment, which stays as it is."""

import ctypes
import hashlib
import platform
import subprocess
import sys

import numpy as np
import pytest

from vtkflipflop.arrays import convex_hull, power_diagram, regular_triangulation

# As C's <fenv.h> numbers them on x86.
ROUNDING = {"up": 0x800, "down": 0x400, "zero": 0xC00}
MXCSR = 28  # where glibc's fenv_t has it

IS_X86 = sys.platform == "linux" and platform.machine() == "x86_64"
pytestmark = pytest.mark.skipif(not IS_X86, reason="the environment is set as glibc has it on x86")


def enter(environment):
    """Gives this thread an environment, by the C library."""
    libm = ctypes.CDLL("libm.so.6")
    if environment in ROUNDING:
        assert libm.fesetround(ROUNDING[environment]) == 0
    elif environment == "flush":
        state = (ctypes.c_uint8 * 32)()
        libm.fegetenv(state)
        control = ctypes.c_uint32.from_buffer(state, MXCSR)
        control.value |= 0x8040
        libm.fesetenv(state)


def inputs():
    """Sites on a decimal grid with such weights; points off a plane by subnormal numbers; and queries."""
    x, y = np.meshgrid(np.arange(40) / 10, np.arange(30) / 10)
    sites = np.column_stack([x.ravel(), y.ravel()])
    weights = (7 * np.arange(len(sites)) % 5) / 100
    heights = np.arange(len(sites)) % 9 * 5e-324
    points = np.column_stack([sites, heights])
    return sites, weights, points, points[:50] + 1, sites[:60] / 2


def calls(threads):
    """What a call returns, as arrays."""
    sites, weights, points, away, between = inputs()

    def digests():
        hull = convex_hull(points, threads=threads)
        triangulation = regular_triangulation(sites, weights, threads=threads)
        diagram = power_diagram(sites, weights, threads=threads)
        for name, array in (
            ("hull", hull.simplices),
            ("sides", hull.contains(points[:50])),
            ("distances", hull.distance(away)),
            ("triangulation", triangulation.simplices),
            ("hidden", triangulation.hidden),
            ("natural", triangulation.interpolate(weights, between, "natural")),
            ("diagram", diagram.vertices),
        ):
            yield name, hashlib.sha256(np.ascontiguousarray(array).tobytes()).hexdigest()

    return digests


def main(environment, threads):
    digests = calls(int(threads))
    enter(environment)
    third = np.float64(1) / np.float64(3)
    for line in digests():
        print(*line)
    assert np.float64(1) / np.float64(3) == third
    if environment == "flush":
        assert np.float64(5e-324) * 1 == 0
    try:
        convex_hull(np.full((4, 3), np.nan))
    except ValueError:
        pass
    assert np.float64(1) / np.float64(3) == third


def process(environment, threads):
    command = [sys.executable, __file__, environment, str(threads)]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()


@pytest.fixture(scope="module")
def wanted():
    lines = process("default", 1)
    assert len(lines) == 7
    return lines


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("environment", ["flush", *ROUNDING])
def test_environment(environment, threads, wanted):
    assert process(environment, threads) == wanted


if __name__ == "__main__":
    main(*sys.argv[1:])
