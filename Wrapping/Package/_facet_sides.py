# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""On which side of the planes of a hull's facets points are, exactly, in the plane and in space."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Rows = NDArray[np.float64]
Ints = NDArray[np.int32]
_BATCH = 1 << 18  # pairs of a point and a facet at once


def sides_of_facets(points: Rows, simplices: NDArray[Any], at: Rows) -> NDArray[np.int8]:
    """For each position and each facet 1 outside of the facet's plane, 0 on it, -1 inside.

    points : n by 2 or 3
    simplices : m by 2 or 3
        counter-clockwise, from outside
    at : k by 2 or 3

    Returns k by m.
    """
    with np.errstate(all="ignore"):
        arms = points[simplices] - at[:, None, None]
        values, sizes = _expanded(arms, -1), _expanded(np.abs(arms), 1)
        # More than twice the bound of J. R. Shewchuk (1997), and what underflows.
        bounds = 2.0**-49 * sizes + 2.0**-1060 * (1 + np.abs(arms).max(axis=(2, 3)))
        signs = np.where(np.abs(values) > bounds, np.sign(values), np.nan)
    unsure = np.nonzero(np.isnan(signs))
    if len(unsure[0]):
        whole = _integers(np.concatenate([points[simplices[unsure[1]]], at[unsure[0], None]], axis=1))
        signs[unsure] = np.sign(_expanded(whole[:, :-1] - whole[:, -1:], -1)).astype(np.int8)
    return np.asarray(-signs, np.int8)


def touched_facets(points: Rows, simplices: NDArray[Any], ids: NDArray[Any]) -> Ints:
    """For each of ids, of points on the surface, the id, a facet and a vertex, k by 3.

    The vertex is the nearest corner, by rounded distances, of the facets whose planes the point is on; of several, the
    lowest. The facet is the lowest of these that has it.
    """
    rows = []
    step = max(1, _BATCH // len(simplices))
    for begin in range(0, len(ids), step):
        some = ids[begin : begin + step]
        for i, is_on in zip(some.tolist(), sides_of_facets(points, simplices, points[some]) == 0):
            facets = np.flatnonzero(is_on)
            corners = np.unique(simplices[facets])
            nearest = corners[np.linalg.norm(points[corners] - points[i], axis=1).argmin()]
            rows.append((i, facets[(simplices[facets] == nearest).any(axis=1)][0], nearest))
    return np.array(rows, np.int32).reshape(-1, 3)


def _expanded(rows: NDArray[Any], minus: int) -> NDArray[Any]:
    """The determinant of the last two axes; with plus, and of absolute values, the sum of its terms."""
    a, b = rows[..., -2, :], rows[..., -1, :]
    if rows.shape[-1] == 2:
        return np.asarray(a[..., 0] * b[..., 1] + minus * (a[..., 1] * b[..., 0]))
    xy, xz, yz = (a[..., i] * b[..., j] + minus * (a[..., j] * b[..., i]) for i, j in ((0, 1), (0, 2), (1, 2)))
    first = rows[..., 0, :]
    return np.asarray(first[..., 0] * yz + minus * (first[..., 1] * xz) + first[..., 2] * xy)


def _integers(values: Rows) -> NDArray[Any]:
    """As integers of any size, all times one power of two."""
    fractions, exponents = np.frexp(values)
    whole = np.ldexp(fractions, 53).astype(np.int64).astype(object)
    return np.asarray(whole << (exponents - exponents.min()).astype(object))
