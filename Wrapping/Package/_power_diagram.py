# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Power diagrams, cut at a box or a convex polygon."""

from __future__ import annotations

from functools import cached_property
from typing import Any, ClassVar

import numpy as np

from . import _core
from ._results import Floats, Frozen, Ids, Polygons, distinct, frozen
from ._rings import Sides, sides_of


class PowerDiagram(Frozen):
    """The cells of a power diagram, cut at a box or a convex polygon.

    There is one polygon, counter-clockwise, for each site that has a cell in it.
    Cells fill it without gap or overlap and share their corners. Only the corners' coordinates are rounded.
    """

    _core: Any
    _call: ClassVar[str] = "power_diagram(points)"

    @cached_property
    def vertices(self) -> Floats:
        """The corners, as rows of x and y."""
        return self._core.vertices()

    @cached_property
    def cells(self) -> Polygons:
        """The corners of each cell, as rows of vertices."""
        return Polygons(self._core.offsets(), self._core.connectivity())

    @cached_property
    def sites(self) -> Ids:
        """The id of each cell's point, ascending."""
        return self._core.sites()

    @property
    def areas(self) -> Floats:
        """The area of each cell, rounded."""
        return self._measures[0]

    @property
    def centroids(self) -> Floats:
        """The x and y of each cell's centroid, rounded."""
        return self._measures[1]

    @property
    def ridge_points(self) -> Ids:
        """The two points between which each common side of two cells is, the lower id first; ascending by these.

        Rounding may have bent a side: then two cells have several in common, one after another.
        """
        return self._ridges[0]

    @property
    def ridge_vertices(self) -> Ids:
        """The two ends of each common side, as rows of `vertices`: right and left, seen from the first point."""
        return self._ridges[1]

    @cached_property
    def ridge_lengths(self) -> Floats:
        """The length of each common side, rounded."""
        return self._lengths(self.ridge_vertices)

    @property
    def border_points(self) -> Ids:
        """The point of each side of a cell that is on the border of the domain, ascending."""
        return self._border[0]

    @property
    def border_vertices(self) -> Ids:
        """The two ends of each side on the border, as rows of `vertices`, counter-clockwise."""
        return self._border[1]

    @cached_property
    def border_lengths(self) -> Floats:
        """The length of each side on the border, rounded."""
        return self._lengths(self.border_vertices)

    @cached_property
    def neighbors(self) -> tuple[Ids, Ids]:
        """The cells next to cell i are indices[indptr[i]:indptr[i + 1]], ascending rows of `cells`; (indptr, indices).

        They have a side in common within the domain.
        """
        count = len(self.sites)
        cells = np.searchsorted(self.sites, self.ridge_points)
        keys = distinct(np.concatenate([cells @ [count, 1], cells @ [1, count]]))
        rows, others = keys // max(count, 1), keys % max(count, 1)
        return frozen(np.concatenate([[0], np.cumsum(np.bincount(rows, minlength=count))])), frozen(others)

    @property
    def regions(self) -> list[Ids]:
        """`cells` as a list, by scipy's name."""
        return list(self.cells)

    @cached_property
    def _measures(self) -> tuple[Floats, Floats]:
        return _core.power_cell_measures(self._core)

    @cached_property
    def _sides(self) -> Sides:
        return sides_of(self.cells)

    @cached_property
    def _ridges(self) -> tuple[Ids, Ids]:
        tails, heads, cells, twins = self._sides
        others = cells[twins]
        chosen = np.flatnonzero((twins >= 0) & (cells < others))
        chosen = chosen[np.lexsort((others[chosen], cells[chosen]))]
        pairs = np.column_stack([cells[chosen], others[chosen]])
        return frozen(self.sites[pairs]), frozen(np.column_stack([tails[chosen], heads[chosen]]))

    @cached_property
    def _border(self) -> tuple[Ids, Ids]:
        tails, heads, cells, twins = self._sides
        chosen = twins < 0
        return frozen(self.sites[cells[chosen]]), frozen(np.column_stack([tails[chosen], heads[chosen]]))

    def _lengths(self, ends: Ids) -> Floats:
        steps = self.vertices[ends[:, 1]] - self.vertices[ends[:, 0]]
        return frozen(np.hypot(steps[:, 0], steps[:, 1]))

    def __len__(self) -> int:
        return len(self.sites)

    def __repr__(self) -> str:
        return f"<PowerDiagram: {len(self.sites)} cells, {len(self.vertices)} corners>"
