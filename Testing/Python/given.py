# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The points of the tests of bits, as arrays: made by integers alone, or read without VTK."""

import base64
import re
import struct
import zlib
from pathlib import Path

import numpy as np

TOP = Path(__file__).resolve().parents[2]
BASELINE = TOP / "Testing" / "Data" / "Baseline" / "outputs.sha256"


def numbers(count, seed):
    """Numbers in [0, 1) by integers alone: NumPy's generators may change with its version."""
    state, found = np.uint64(seed), np.empty(count)
    with np.errstate(over="ignore"):
        for i in range(count):
            state = state * np.uint64(6364136223846793005) + np.uint64(1442695040888963407)
            found[i] = float(state >> np.uint64(11)) / 2**53
    return found


def made():
    """Pairs of a name, points and weights."""
    uniform = numbers(9000, 1).reshape(-1, 3)
    yield "uniform", uniform, numbers(3000, 2) * 1e-3
    yield "uniform float", uniform.astype(np.float32), numbers(3000, 3) * 1e-3
    grid = np.stack(np.meshgrid(*3 * [np.arange(6.0)], indexing="ij"), -1).reshape(-1, 3)
    yield "grid", grid, np.arange(216) % 5 / 4
    yield "far", 1e15 + grid, np.zeros(216)


def weights_of(xyz):
    """Of real data: by the height."""
    height = xyz[:, 2].astype(np.float64)
    return (height - height.min()) ** 2


def read_points(name):
    """The points of one of the project's files, which are compressed and in base 64."""
    text = (TOP / "Data" / name).read_text()
    found = re.search(r'<Points>\s*<DataArray type="(Float\d\d)"[^>]*format="binary"[^>]*>\s*(\S+)', text)
    kind = {"Float32": np.float32, "Float64": np.float64}[found[1]]
    (blocks,) = struct.unpack("<I", base64.b64decode(found[2][:8])[:4])
    head = -(-4 * (3 + blocks) // 3) * 4  # in base 64
    sizes = struct.unpack(f"<{blocks}I", base64.b64decode(found[2][:head])[12 : 12 + 4 * blocks])
    data, at, plain = base64.b64decode(found[2][head:]), 0, b""
    for size in sizes:
        plain += zlib.decompress(data[at : at + size])
        at += size
    return np.frombuffer(plain, kind).reshape(-1, 3)
