# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points of LAS files, the format of LiDAR surveys (ASPRS, "LAS Specification 1.4 - R15", 2019), uncompressed."""

from __future__ import annotations

import os
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._errors import InputError
from ._results import Floats

_HEADER = np.dtype({
    "names": ["signature", "minor", "size", "begin", "format", "length", "few", "scale", "offset"],
    "formats": ["S4", "u1", "<u2", "<u4", "u1", "<u2", "<u4", "<3f8", "<3f8"],
    "offsets": [0, 25, 94, 96, 104, 105, 107, 131, 155],
    "itemsize": 227,
})  # fmt: skip
_MANY_AT = 247  # of LAS 1.4: the number of points, in 8 bytes

_OLD = [("xyz", "<3i4"), ("intensity", "<u2"), ("returns", "u1"), ("classification", "u1"), ("scan_angle", "i1"),
        ("user_data", "u1"), ("point_source_id", "<u2")]  # fmt: skip
_NEW = [("xyz", "<3i4"), ("intensity", "<u2"), ("returns", "u1"), ("flags", "u1"), ("classification", "u1"),
        ("user_data", "u1"), ("scan_angle", "<i2"), ("point_source_id", "<u2"), ("gps_time", "<f8")]  # fmt: skip
_TIME, _COLORS, _INFRARED = [("gps_time", "<f8")], [("colors", "<3u2")], [("near_infrared", "<u2")]
_FIELDS = [
    _OLD, _OLD + _TIME, _OLD + _COLORS, _OLD + _TIME + _COLORS, _OLD + _TIME, _OLD + _TIME + _COLORS,
    _NEW, _NEW + _COLORS, _NEW + _COLORS + _INFRARED, _NEW, _NEW + _COLORS + _INFRARED,
]  # fmt: skip


class LasPoints(NamedTuple):
    """What a LAS file has."""

    points: Floats
    """x, y, z of n points: n by 3"""
    attributes: dict[str, NDArray[Any]]
    """intensity, return_number, classification (2: ground), scan_angle, user_data, point_source_id, and, if the file
    has them, gps_time, colors (n by 3) and near_infrared, of each point, as the file has them"""


def read_las(path: str | os.PathLike[str]) -> LasPoints:
    """The points of a LAS file of version 1.0 to 1.4, without compression: one of the suffix .laz has to be unpacked.

    Raises
    ------
    InputError
        is not such a file, or ends too soon: says where
    OSError
        it cannot be read
    """
    name = os.fspath(path)

    def wrong(what: str) -> InputError:
        return InputError(f"{name} {what}", "bad_argument")

    size = os.path.getsize(name)
    with open(name, "rb") as file:
        head = file.read(_MANY_AT + 8)
    if len(head) < _HEADER.itemsize or head[:4] != b"LASF":
        raise wrong("is no LAS file: it does not begin with LASF and a header of 227 bytes or more")
    header = np.frombuffer(head, _HEADER, 1)[0]
    kind, begin, length = int(header["format"]), int(header["begin"]), int(header["length"])
    if kind >= 64:
        raise wrong("is compressed (LAZ): unpack it first, for example with laspy or PDAL")
    if kind >= len(_FIELDS):
        raise wrong(f"has points of format {kind}; formats 0 to {len(_FIELDS) - 1} are known")
    is_long = int(header["minor"]) >= 4 and len(head) == _MANY_AT + 8
    count = int(np.frombuffer(head, "<u8", 1, _MANY_AT)[0]) if is_long else int(header["few"])
    fields = _FIELDS[kind]
    used = np.dtype(fields).itemsize
    if length < used:
        raise wrong(f"says that points of format {kind} have {length} bytes; they have {used} or more")
    of_header = max(int(header["size"]), _MANY_AT + 8 if is_long else _HEADER.itemsize)
    if count and begin < of_header:
        raise wrong(f"says that its points begin at byte {begin}, and its header has {of_header} bytes")
    if begin + count * length > size:
        raise wrong(f"ends at byte {size}; its {count} points of {length} bytes begin at byte {begin}")
    if not np.isfinite([header["scale"], header["offset"]]).all():
        raise wrong("has a scale or an offset that is not finite")
    records = np.fromfile(name, np.dtype([*fields, ("rest", f"V{length - used}")]), count, offset=begin)
    attributes = {field: np.ascontiguousarray(records[field]) for field, *_ in fields if field not in ("xyz", "flags")}
    numbers = attributes.pop("returns")
    attributes["return_number"] = numbers & (15 if kind >= 6 else 7)
    if kind < 6:
        attributes["classification"] &= 31  # the others are flags
    with np.errstate(over="ignore"):
        points = records["xyz"] * header["scale"] + header["offset"]
    if not np.isfinite(points).all():
        scale, offset = header["scale"].tolist(), header["offset"].tolist()
        raise wrong(f"has coordinates that no double holds: the scale is {scale}, the offset {offset}")
    return LasPoints(points, attributes)
