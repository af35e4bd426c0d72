# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Alpha complexes of arrays: what of a triangulation is in them."""

from __future__ import annotations

from functools import cached_property
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arguments import float_of
from ._results import QUIET, Floats, Frozen, Ids, Polygons, frozen


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
    _cells: Any
    _all: Ids
    _call: ClassVar[str] = "alpha_complex(points, alpha)"

    @classmethod
    def _made(
        cls,
        cells: Any,
        simplices: Ids,
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
            _cells=cells,
            _all=simplices,
        )

    @cached_property
    def simplices(self) -> Ids:
        """The triangulation's `simplices` that are in the complex, as rows of ids."""
        return frozen(self._all[self.within])

    @cached_property
    def boundary(self) -> Polygons:
        """The border of these, as RegularTriangulation.boundary has it."""
        some = _core.with_cells(self._cells, self.within.view(np.uint8))
        return Polygons(*_core.cell_boundary(some, QUIET))

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
