# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cells of Voronoi diagrams, in the plane and on a sphere: the facets around each site, in order."""

from __future__ import annotations

from typing import Any

import numpy as np


def add_rounds(regions: list[list[int]], begin: Any, onward: Any, facet_of: Any) -> None:
    """Adds to each region the facets around its site, around all sites at once.

    begin: for each region a corner; onward: for each corner the next one at its site, -1 at the border; facet_of: of
    corners
    """
    at, rows = begin, np.arange(len(begin))
    while len(rows):
        for row, facet in zip(rows.tolist(), facet_of[at].tolist()):
            regions[row].append(facet)
        at = onward[at]
        goes_on = (at >= 0) & (at != begin[rows])
        rows, at = rows[goes_on], at[goes_on]


def first_indices(values: Any, count: int) -> Any:
    """For each number below count its first index among values; -1: it has none."""
    found = np.full(count, -1)
    found[values[::-1]] = np.arange(len(values))[::-1]
    return found
