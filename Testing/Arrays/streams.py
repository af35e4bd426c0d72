# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Streams and what they are compared with: what the calls in memory give of all points at once."""

import hashlib

import numpy as np

from vtkflipflop.arrays import convex_hull, regular_triangulation, stream


def blocks_of(streamed):
    """The arrays of each file."""
    blocks = []
    for path in streamed.files:
        with np.load(path) as file:
            blocks.append(dict(file))
    return blocks


def digest(folder):
    """Of all that is in a folder."""
    whole = hashlib.sha256()
    for path in sorted(folder.rglob("*")):
        whole.update(str(path.relative_to(folder)).encode() + (path.read_bytes() if path.is_file() else b""))
    return whole.hexdigest()


def joined(parts):
    """The values of some pieces, which may be empty lists."""
    parts = [np.asarray(part) for part in parts if len(part)]
    return np.concatenate(parts) if parts else np.empty((0, 3))


def in_memory(kind, points, weights=None, facets="triangles"):
    """The result, and the ids of the points that are in no cell, as files have them."""
    if kind == "hull":
        whole = convex_hull(points, facets=facets, non_finite="ignore")
        kept = np.flatnonzero(np.isfinite(points).all(axis=1))
        return whole, np.setdiff1d(kept, whole.vertices if whole.dimension == 3 else kept)
    whole = regular_triangulation(points, weights, facets=facets, non_finite="ignore")
    return whole, whole.hidden


def cells_of(block, polygons):
    """Of a file, as tuples of ids."""
    ids = block["ids"]
    if polygons:
        bounds = block["offsets"].tolist()
        return [tuple(ids[block["connectivity"][begin:end]].tolist()) for begin, end in zip(bounds, bounds[1:])]
    return list(map(tuple, ids[block["simplices"]].tolist()))


def bits(array):
    if array.dtype.names:  # there may be bytes between fields
        return [bits(array[name]) for name in array.dtype.names]
    return array.dtype.str, array.shape, array.tobytes()


def check(streamed, kind, points, weights=None, attributes=None, facets="triangles"):
    """All files together are the result in memory, bit for bit, and each point's data are its own."""
    whole, whole_hidden = in_memory(kind, points, weights, facets)
    blocks = blocks_of(streamed)
    expected = whole.polygons if facets == "polygons" else whole.simplices
    cells = sorted(cell for block in blocks for cell in cells_of(block, facets == "polygons"))
    assert cells == [tuple(cell.tolist()) for cell in expected]
    vertices = np.unique(np.concatenate([block["ids"] for block in blocks]))
    assert np.array_equal(vertices, whole.vertices)
    hidden = np.sort(np.concatenate([block["hidden"] for block in blocks]))
    assert np.array_equal(hidden, whole_hidden)
    left_out = int((~np.isfinite(points[:, : 3 if kind == "hull" else 2]).all(axis=1)).sum())
    if weights is not None:
        left_out += int((~np.isfinite(weights)).sum())  # of other points
    assert streamed[1:5] == (len(points), left_out, len(hidden), len(cells))
    assert streamed.dimension == whole.dimension
    assert kind != "hull" or (streamed.volume, streamed.area) == (whole.volume, whole.area)
    for block in blocks:
        ids = block["ids"]
        assert (np.diff(ids) > 0).all() and (np.diff(block["hidden"]) > 0).all()
        assert bits(block["points"]) == bits(points[ids])
        assert block["blocks"].shape == ids.shape and (block["blocks"] < len(blocks)).all()
        assert weights is None or bits(block["weights"]) == bits(weights[ids])
        for name, values in (attributes or {}).items():
            assert bits(block[name]) == bits(values[ids]), name
    check_owners(blocks)


def check_owners(blocks):
    """All blocks say the same of a point's block, and that block does not hide it."""
    owners = {}
    for block in blocks:
        for one, owner in zip(block["ids"].tolist(), block["blocks"].tolist()):
            assert owners.setdefault(one, owner) == owner
    for number, block in enumerate(blocks):
        assert not set(block["hidden"].tolist()) & set(owners), number


def tried(tmp_path, kind, points, weights=None, attributes=None, pieces=5, facets="triangles", **keywords):
    """Streams in that many pieces, checked."""
    bounds = np.linspace(0, len(points), pieces + 1).astype(int)
    given = []
    for begin, end in zip(bounds, bounds[1:]):
        piece = {name: values[begin:end] for name, values in (attributes or {}).items()}
        piece["points"] = points[begin:end]
        if weights is not None:
            piece["weights"] = weights[begin:end]
        given.append(piece)
    streamed = stream(given, tmp_path, kind=kind, facets=facets, **keywords)
    check(streamed, kind, points, weights, attributes, facets)
    assert sorted(tmp_path.iterdir()) == list(streamed.files)
    return streamed
