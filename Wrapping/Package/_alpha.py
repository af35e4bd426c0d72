# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Alpha complexes of arrays: what of a triangulation is in them."""

from __future__ import annotations

from functools import cached_property
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from ._arguments import float_of
from ._plane_cells import LocatedCells
from ._results import Floats, Frozen, Ids, Polygons
from ._selection import CellSelection


class AlphaComplex(Frozen):
    """The alpha complex of points in the plane.

    The circle of a simplex is the least one of power distance 0 from its corners; without weights, the least through
    them. A simplex is in the complex if its circle is not larger than alpha, and no other corner is inside that circle;
    or if a larger simplex of the complex has it.

    Attributes
    ----------
    within : ndarray of bool
        which of the triangulation's `simplices` are in the complex
    edges : ndarray of k by 2
        the edges in it that are no side of such a simplex, as ids, the lower one first; in lexicographic order
    edge_alphas : ndarray
        for each of these the least alpha at which its own circle is in
    vertices : ndarray
        ids of the points in it that are at no such simplex or edge, ascending
    vertex_alphas : ndarray
        the same for each of these: without weights 0
    """

    within: NDArray[np.bool_]
    edges: Ids
    edge_alphas: Floats
    vertices: Ids
    vertex_alphas: Floats
    _of_all: LocatedCells
    _call: ClassVar[str] = "alpha_complex(points, alpha)"

    @classmethod
    def _made(
        cls,
        triangulation: LocatedCells,
        within: NDArray[np.uint8],
        edges: Ids,
        edge_alphas: Floats,
        vertices: Ids,
        vertex_alphas: Floats,
    ) -> Self:
        return cls._of(
            within=within.view(np.bool_),
            edges=edges,
            edge_alphas=edge_alphas,
            vertices=vertices,
            vertex_alphas=vertex_alphas,
            _of_all=triangulation,
        )

    @cached_property
    def cells(self) -> CellSelection:
        """The triangulation's `simplices` that are in the complex, with their areas, and queries of these alone."""
        return CellSelection._with(self._of_all, self.within)

    @property
    def simplices(self) -> Ids:
        """The same as rows of ids."""
        return self.cells.simplices

    @property
    def boundary(self) -> Polygons:
        """Their border, as RegularTriangulation.boundary has it."""
        return self.cells.boundary

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        """Their border as a MultiPolygon with holes: shapely.geometry.shape(complex) takes it.

        Edges and points of the complex that no triangle has are no part of it.
        """
        return self.cells.__geo_interface__

    def __repr__(self) -> str:
        return (
            f"<AlphaComplex: {int(self.within.sum())} of {len(self.within)} simplices, {len(self.edges)} edges, "
            f"{len(self.vertices)} points>"
        )


def alpha_of(alpha: float) -> float:
    """The number, which is not NaN."""
    number = float_of("alpha", alpha)
    if number != number:
        raise ValueError(f"alpha is a length, or a negative number with weights, not {alpha!r}")
    return number
