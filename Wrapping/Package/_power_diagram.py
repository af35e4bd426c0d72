# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Power diagrams, cut at a box or a convex polygon."""

from __future__ import annotations

from functools import cached_property
from typing import Any

from . import _core
from ._results import Floats, Frozen, Ids, Polygons


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
    def regions(self) -> list[Ids]:
        """`cells` as a list, by scipy's name."""
        return list(self.cells)

    @cached_property
    def _measures(self) -> tuple[Floats, Floats]:
        return _core.power_cell_measures(self._core)

    def __len__(self) -> int:
        return len(self.sites)

    def __repr__(self) -> str:
        return f"<PowerDiagram: {len(self.sites)} cells, {len(self.vertices)} corners>"
