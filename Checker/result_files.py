# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The files that check_result.py reads: arrays of .npz and .vtp files, by Python alone; and whether they agree."""

import ast
import base64
import itertools
import math
import re
import struct
import xml.etree.ElementTree
import zipfile
import zlib


class Wrong(Exception):
    """The result is not right: what, and where."""


def require(holds, text):
    if not holds:
        raise Wrong(text)


rows_of = lambda flat, size: list(zip(*[iter(flat)] * size)) if size else []
NPY = {"f8": "d", "f4": "f", "f2": "e", "i8": "q", "i4": "i", "i2": "h", "i1": "b", "u8": "Q", "u4": "I", "u2": "H",
       "u1": "B", "b1": "?"}  # fmt: skip
VTK = {"Float64": "d", "Float32": "f", "Int64": "q", "Int32": "i", "Int16": "h", "Int8": "b",
       "UInt64": "Q", "UInt32": "I", "UInt16": "H", "UInt8": "B"}  # fmt: skip


def numbers(data, letter, order):
    """The bytes as numbers of that type."""
    size = struct.calcsize("<" + letter)
    return list(struct.unpack(f"{order}{len(data) // size}{letter}", data[: len(data) // size * size]))


def slices(flat, ends, what):
    """Rows of unlike sizes: from each end in flat to the next."""
    right = ends[:1] == [0] and ends[-1] == len(flat) and all(a <= b for a, b in zip(ends, ends[1:]))
    require(right, f"the offsets of {what} do not ascend from 0 to the number of corners, {len(flat)}")
    return [tuple(flat[a:b]) for a, b in zip(ends, ends[1:])]


def read_npz(path):
    """The arrays by name: numbers, or rows."""
    arrays = {}
    with zipfile.ZipFile(path) as archive:
        for name in archive.namelist():
            data, name = archive.read(name), name.removesuffix(".npy")
            begin = 10 if data[6] == 1 else 12
            end = begin + int.from_bytes(data[8:begin], "little")
            header = ast.literal_eval(data[begin:end].decode("latin1"))
            kind, shape = header["descr"], header["shape"]
            if str(kind)[1:] not in NPY:
                raise ValueError(f"array {name} has the type {kind}, not bool, integers or floats of up to 64 bits")
            flat = numbers(data[end:], NPY[kind[1:]], kind[0].replace("|", "="))
            if len(shape) > 2 or min((1, *shape)) < 0 or len(flat) != math.prod(shape) or (0 in shape[1:] and shape[0]):
                raise ValueError(f"array {name} has not the numbers of its shape {shape}, or is no rows")
            if len(shape) == 2:
                flat = list(zip(*rows_of(flat, shape[0]))) if header["fortran_order"] else rows_of(flat, shape[1])
            arrays[name] = flat if shape else flat[0]
    for name, flat, ends in (("cells", "connectivity", "offsets"), ("rings", "rings", "ring_offsets")):
        if ends in arrays:
            arrays[name] = slices(arrays[flat], arrays[ends], name)
    return arrays


class VtpReader:
    """The arrays of a .vtp file of one piece."""

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        # Raw appended data is no XML: it is cut out first.
        self.appended, self.raw = b"", False
        match = re.search(rb'<AppendedData\s+encoding="(\w+)"\s*>\s*_', data)
        if match:
            end = data.rindex(b"</AppendedData>")
            self.appended, self.raw = data[match.end() : end], match[1] == b"raw"
            data = data[: match.end()] + data[end:]
        root = xml.etree.ElementTree.fromstring(data)
        self.order = ">" if root.get("byte_order") == "BigEndian" else "<"
        self.header, self.compressor = VTK[root.get("header_type", "UInt32")], root.get("compressor")
        pieces = root.findall("./PolyData/Piece")
        if len(pieces) != 1 or self.compressor not in (None, "vtkZLibDataCompressor"):
            raise ValueError(f"{path} is no .vtp file of one piece, compressed by zlib or not at all")
        self.piece, self.field = pieces[0], root.find("./PolyData/FieldData")

    def bytes_at(self, data, at, encoded):
        """Those of the array that begins there, in base64 or not: a header, then the bytes or their blocks."""
        length = lambda size: (size + 2) // 3 * 4 if encoded else size
        decode = base64.b64decode if encoded else bytes
        take = lambda at, size: decode(data[at : at + length(size)])[:size]
        word = struct.calcsize(self.header)
        count = numbers(take(at, word), self.header, self.order)[0]
        if not self.compressor:  # the header and the bytes are one
            return take(at, word + count)[word:]
        sizes = numbers(take(at, (3 + count) * word), self.header, self.order)[3:]
        raw = take(at + length((3 + count) * word), sum(sizes))
        ends = list(itertools.accumulate(sizes, initial=0))
        return b"".join(zlib.decompress(raw[begin:end]) for begin, end in zip(ends, ends[1:]))

    def values(self, element):
        """A DataArray's numbers; rows, where it has components."""
        if element is None:
            return None
        kind, form, text = VTK[element.get("type")], element.get("format"), (element.text or "").split()
        if form == "ascii":
            found = numbers(struct.pack(f"={len(text)}{kind}", *map(float if kind in "df" else int, text)), kind, "=")
        else:
            data, at = ("".join(text).encode(), 0) if text else (self.appended, int(element.get("offset")))
            found = numbers(self.bytes_at(data, at, bool(text) or not self.raw), kind, self.order)
        size = int(element.get("NumberOfComponents") or 1)
        return rows_of(found, size) if size > 1 else found

    def named(self, group, name):
        parent = self.field if group == "FieldData" else self.piece.find(group)
        return self.values(None if parent is None else parent.find(f"DataArray[@Name='{name}']"))

    def cells(self):
        """The corners of all cells, as indices of points."""
        found = []
        for group in ("Verts", "Lines", "Polys"):
            corners, ends = self.named(group, "connectivity") or [], self.named(group, "offsets") or []
            found += slices(corners, [0, *ends], group)
        count = len(self.named("Points", "Points") or ())
        right = all(0 <= i < count for cell in found for i in cell)
        require(right, f"a cell has a corner that is none of {count} points")
        return found


def read_case(given):
    """All that is checked, as arrays by name."""
    if not given.result.endswith(".vtp"):
        return read_npz(given.result)
    if given.points is None or (given.kind == "diagram") != (given.triangulation is not None):
        raise ValueError("a .vtp file of a result needs that of the points; a diagram also that of its triangulation")
    points, shown = VtpReader(given.points), VtpReader(given.triangulation or given.result)
    case = {"points": points.named("Points", "Points") or [], "box": given.box}
    case["weights"] = points.named("PointData", given.weights)
    if given.weights and case["weights"] is None:
        raise ValueError(f"the points have no array {given.weights}")
    ids, places = shown.named("PointData", "vtkOriginalPointIds") or [], shown.named("Points", "Points") or []
    require(len(ids) == len(places), f"the result has {len(places)} points, and {len(ids)} vtkOriginalPointIds")
    case["cells"] = [tuple(ids[i] for i in cell) for cell in shown.cells()]
    seen = slice(3 if given.kind == "hull" else 2)
    for id, at in zip(ids, places):
        right = 0 <= id < len(case["points"]) and at[seen] == case["points"][id][seen]
        require(right, f"a point of the result, at {at}, is not where the input's point {id} is")
    for name in ("certificate", "apex"):
        case[name] = shown.named("FieldData", "FlipFlop" + name.capitalize())
    diagram = VtpReader(given.result)
    case["corners"], case["rings"] = [p[:2] for p in diagram.named("Points", "Points")], diagram.cells()
    return case | {"sites": diagram.named("CellData", "vtkOriginalPointIds")}
