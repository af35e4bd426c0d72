# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The sides of polygons that meet edge to edge, and the polygons around each corner, in order: in the plane, and on a
sphere."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._results import Ids, Polygons


class Sides(NamedTuple):
    """The sides of polygons, one after another, each from one corner to the next.

    Attributes
    ----------
    tails, heads : ndarray
        the corners at both ends
    polygons : ndarray
        the polygon of each
    twins : ndarray
        the same side of another polygon, which runs the other way; -1: there is none
    """

    tails: Ids
    heads: Ids
    polygons: Ids
    twins: Ids


def sides_of(polygons: Polygons) -> Sides:
    """Of polygons, all counter-clockwise, of which at most two have a side in common."""
    offsets, tails = polygons.offsets, polygons.connectivity
    heads = np.roll(tails, -1)
    heads[offsets[1:] - 1] = tails[offsets[:-1]]
    ends = np.sort(np.column_stack([tails, heads]), axis=1).astype(np.uint64)
    keys = ends[:, 0] * np.uint64(1 + ends.max(initial=0)) + ends[:, 1]  # ids are less than 2^32
    order = np.argsort(keys)
    is_pair = keys[order[1:]] == keys[order[:-1]]
    one, other = order[:-1][is_pair], order[1:][is_pair]
    twins = np.full(len(tails), -1)
    twins[one], twins[other] = other, one
    return Sides(tails, heads, np.repeat(np.arange(len(polygons)), np.diff(offsets)), twins)


def polygons_around(sides: Sides, count: int) -> tuple[Polygons, NDArray[np.bool_]]:
    """The polygons around each of so many corners, counter-clockwise; and which corners are at the border.

    They begin at the lowest one; at the border, at the first counter-clockwise.
    """
    tails, _, polygons, twins = sides
    rows = np.arange(len(tails))
    sizes = np.bincount(tails, minlength=count)
    offsets = np.concatenate([[0], np.cumsum(sizes)])
    border = np.flatnonzero(twins < 0)
    first = np.full(count, -1)
    first[tails[::-1]] = rows[::-1]
    first[tails[border]] = border
    # From a corner on to the same one of the next polygon: across the side that ends at it.
    before, begins = rows - 1, np.flatnonzero(np.diff(polygons, prepend=-1))
    before[begins] = np.roll(begins, -1) - 1
    onward = twins[before]
    onward[onward == first[tails]] = -1
    # How many polygons come after each, by steps of doubled length.
    at, after = np.where(onward < 0, rows, onward), (onward >= 0).astype(np.int64)
    while (more := after[at]).any():
        after += more
        at = at[at]
    around = np.empty_like(rows)
    around[offsets[tails + 1] - 1 - after] = polygons
    is_open = np.zeros(count, bool)
    is_open[tails[border]] = True
    return Polygons(offsets, around), is_open


def lists_of(polygons: Polygons) -> list[list[int]]:
    """As lists, sooner than one by one."""
    ids, offsets = polygons.connectivity.tolist(), polygons.offsets.tolist()
    return [ids[begin:end] for begin, end in zip(offsets, offsets[1:])]
