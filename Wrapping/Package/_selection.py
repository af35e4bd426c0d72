# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Some cells of a triangulation, with its points."""

from __future__ import annotations

from functools import cached_property
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._plane_cells import LocatedCells
from ._results import Ids, distinct, frozen


class CellSelection(LocatedCells):
    """Some of a triangulation's `simplices`, and queries of these alone. Ids stay those of its points.

    locate() has rows of these `simplices`; what none of them holds is outside. Where a cell that stays and one that
    does not have a border in common, that border is inside. Values are those of the triangulation, bit for bit:
    natural neighbours and gradients are found among all its points. There is no nearest(): take the triangulation's.

    Attributes
    ----------
    triangulation : RegularTriangulation, ConstrainedTriangulation or CellSelection
        that the cells are of
    within : ndarray of bool
        which of its `simplices` these are
    """

    triangulation: LocatedCells
    within: NDArray[np.bool_]
    _call: ClassVar[str] = "regular_triangulation(points).with_cells(within)"

    @classmethod
    def _with(cls, whole: LocatedCells, within: NDArray[np.bool_]) -> Self:
        return cls._of(
            points=whole.points,
            triangulation=whole,
            within=frozen(within),
            _core=_core.with_cells(whole._triangles, within.view(np.uint8)),
            _ignores=whole._ignores,
        )

    @cached_property
    def vertices(self) -> Ids:
        """Ids of the points that the cells have, ascending."""
        return frozen(distinct(self.simplices))

    def __repr__(self) -> str:
        return f"<CellSelection: {self.nsimplex} of {len(self.within)} simplices>"

    @property
    def _sites(self) -> NDArray[Any]:
        return self.triangulation._sites

    @cached_property
    def _queries(self) -> Any:
        return self.triangulation._queries if self.within.all() else self._queries_of(self._core)

    def _queries_of(self, cells: Any) -> Any:
        return self.triangulation._queries_of(cells)
