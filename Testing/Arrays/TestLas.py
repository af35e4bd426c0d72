# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""LAS files, written here field by field as the specification has them, are read; what is none is refused."""

import struct

import numpy as np
import pytest

from vtkflipflop.arrays import InputError, read_las

POINTS = [(1, -2, 3), (40, 50, -60), (2**31 - 1, -(2**31), 0)]
SCALE, OFFSET = (0.01, 0.5, 0.001), (500_000.0, -3.0, 0.25)
# Of each format the bytes of a point.
LENGTHS = [20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67]


def record(kind, i, x, y, z):
    """A point: return 2 of 3, class 2 with its synthetic flag, time i + 0.5, colors i, 7, 9, near infrared 11."""
    if kind < 6:
        fields = struct.pack("<iiiHBBbBH", x, y, z, 100 + i, 2 | 3 << 3, 2 | 1 << 5, -5, 8, 77)
        fields += struct.pack("<d", i + 0.5) if kind in (1, 3, 4, 5) else b""
    else:
        fields = struct.pack("<iiiHBBBBhHd", x, y, z, 100 + i, 2 | 3 << 4, 1, 2, 8, -5, 77, i + 0.5)
    fields += struct.pack("<HHH", i, 7, 9) if kind in (2, 3, 5, 7, 8, 10) else b""
    fields += struct.pack("<H", 11) if kind in (8, 10) else b""
    return fields.ljust(LENGTHS[kind] + 2, b"\xff")  # a wave packet, and two bytes that the file adds


def las(kind, count=len(POINTS), begin=400):
    minor = 4 if kind >= 6 else 2
    head = bytearray(begin)
    head[:4], head[24:26] = b"LASF", bytes([1, minor])
    struct.pack_into("<HII", head, 94, 375 if minor == 4 else 227, begin, 0)
    struct.pack_into("<BHI", head, 104, kind, LENGTHS[kind] + 2, count if minor < 4 else 0)
    struct.pack_into("<6d", head, 131, *SCALE, *OFFSET)
    if minor == 4:
        struct.pack_into("<Q", head, 247, count)
    return bytes(head) + b"".join(record(kind, i, *p) for i, p in enumerate(POINTS))


@pytest.mark.parametrize("kind", range(11))
def test_read(tmp_path, kind):
    (tmp_path / "a.las").write_bytes(las(kind))
    points, attributes = read_las(tmp_path / "a.las")
    assert points.tolist() == [[q * s + o for q, s, o in zip(p, SCALE, OFFSET)] for p in POINTS]
    expected = {"intensity": [100, 101, 102], "return_number": [2] * 3, "classification": [2] * 3,
                "scan_angle": [-5] * 3,
                "user_data": [8] * 3, "point_source_id": [77] * 3}  # fmt: skip
    if kind not in (0, 2):
        expected["gps_time"] = [0.5, 1.5, 2.5]
    if kind in (2, 3, 5, 7, 8, 10):
        expected["colors"] = [[0, 7, 9], [1, 7, 9], [2, 7, 9]]
    if kind in (8, 10):
        expected["near_infrared"] = [11] * 3
    assert {name: values.tolist() for name, values in attributes.items()} == expected


def test_of_no_point(tmp_path):
    (tmp_path / "a.las").write_bytes(las(1, count=0)[:400])
    points, attributes = read_las(str(tmp_path / "a.las"))
    assert points.shape == (0, 3) and len(attributes["gps_time"]) == 0


def changed(at, values):
    whole = bytearray(las(1))
    whole[at : at + len(values)] = values
    return bytes(whole)


@pytest.mark.parametrize(
    "data, words",
    [
        (b"", "is no LAS file"),
        (b"LASF", "is no LAS file"),
        (changed(0, b"ZZZZ"), "is no LAS file"),
        (changed(104, bytes([129])), "is compressed"),
        (changed(104, bytes([11])), "has points of format 11"),
        (changed(105, bytes([27, 0])), "have 27 bytes; they have 28 or more"),
        (las(1)[:-1], "ends at byte 489; its 3 points of 30 bytes begin at byte 400"),
        (changed(107, b"\xff" * 4), "its 4294967295 points"),
        (changed(131, struct.pack("<d", np.nan)), "is not finite"),
        (changed(96, struct.pack("<I", 226)), "says that its points begin at byte 226, and its header has 227 bytes"),
        (las(6, begin=374).ljust(500), "says that its points begin at byte 374, and its header has 375 bytes"),
        (changed(131, struct.pack("<d", 1e300)),
         r"no double holds: the scale is \[1e\+300, 0.5, 0.001\], the offset \[500000.0"),
    ],
)
def test_errors(tmp_path, data, words):
    (tmp_path / "bad.las").write_bytes(data)
    with pytest.raises(InputError, match=words) as error:
        read_las(tmp_path / "bad.las")
    assert str(tmp_path / "bad.las") in str(error.value)
    with pytest.raises(OSError):
        read_las(tmp_path / "absent.las")
