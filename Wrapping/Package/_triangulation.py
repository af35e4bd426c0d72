# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Regular triangulations and power diagrams of arrays."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._input import points_of, weights_of
from ._results import Cells, Floats, Frozen, Ids, Polygons, Progress, Validation, cached, ignores, run, settings


class RegularTriangulation(Cells):
    """The exact regular (weighted Delaunay) triangulation of points in the plane.

    Ids are rows of the caller's array. A point that does not appear is in `hidden`. The form is the same for any
    number of threads and either engine, bit for bit. Names are those of scipy.spatial.Delaunay.

    Attributes
    ----------
    weights : ndarray or None
        the caller's weights, as the engine reads them
    """

    weights: NDArray[Any] | None

    def __init__(self, points: NDArray[Any], weights: NDArray[Any] | None, core: Any, ignores: bool) -> None:
        super().__init__(points, core, ignores)
        self.__dict__["weights"] = weights

    @cached
    def vertices(self) -> Ids:
        """Ids of the points that appear, ascending."""
        return self._core.vertices()

    @cached
    def hidden(self) -> Ids:
        """Ids of the points that do not appear, ascending: duplicates, and points whose cell is empty."""
        return self._core.hidden()

    @cached
    def simplices(self) -> Ids:
        """Triangles as rows of three ids, counter-clockwise; of collinear points segments, of one point a point."""
        return self._core.fans()

    @cached
    def polygons(self) -> Polygons:
        """Facets as ids: all points of one power circle are one polygon."""
        core = self._core
        if core.cell_size == 3:
            # As triangles: the visible points have the same triangulation, and tell its facets.
            ids = core.vertices()
            weights = None if self.weights is None else self.weights[ids]
            core = _core.regular_triangulation(
                self.points[ids], weights, _core.Settings(0, True, False, 1, None)
            )
            corners = ids[core.corners()]
            corners.flags.writeable = False
            return Polygons(core.offsets(), corners)
        return Polygons(core.offsets(), core.corners())

    @property
    def nsimplex(self) -> int:
        """How many cells there are in `simplices`."""
        return len(self.simplices)

    def power_diagram(
        self, box: ArrayLike | None = None, *, threads: int = 0, progress: Progress = None
    ) -> PowerDiagram:
        """The power diagram of the points that appear; without weights, the Voronoi diagram.

        Parameters
        ----------
        box : 4 numbers, optional
            x least, x greatest, y least, y greatest: where cells are cut. By default the box of the points.
        """
        sides = None if box is None else tuple(map(float, np.asarray(box).reshape(-1)))
        if sides is not None and len(sides) != 4:
            raise ValueError(f"a box is x least, x greatest, y least, y greatest, not {box!r}")
        chosen = settings(threads, "polygons", "error", "cpu", progress, False)
        return PowerDiagram(
            run(chosen, _core.power_diagram, self.points, self.weights, self._core, sides)
        )

    def validate(self, *, threads: int = 0) -> Validation:
        """Decides exactly whether this is the regular triangulation of the points."""
        fault, text, index = _core.validate_triangulation(self.points, self.weights, self._core, threads)
        return Validation(fault == 0, text, index)

    def __repr__(self) -> str:
        return (
            f"<RegularTriangulation of {self.npoints} points: dimension {self.dimension}, {self._core.cell_count} "
            f"cells, {len(self.hidden)} hidden>"
        )


class PowerDiagram(Frozen):
    """The cells of a power diagram, cut at a box: one polygon, counter-clockwise, for each site that has a cell in it.

    Cells fill the box without gap or overlap and share their corners. Only the corners' coordinates are rounded.

    Attributes
    ----------
    vertices : ndarray of k by 2
        the corners
    cells : Polygons
        of rows of vertices
    sites : ndarray
        id of each cell's point, ascending
    """

    vertices: Floats
    cells: Polygons
    sites: Ids

    def __init__(self, arrays: tuple[Floats, Ids, Ids, Ids]) -> None:
        fields = self.__dict__
        fields["vertices"], connectivity, offsets, fields["sites"] = arrays
        fields["cells"] = Polygons(offsets, connectivity)

    @property
    def regions(self) -> list[Ids]:
        """The corners of each cell, as rows of vertices."""
        return np.split(self.cells.connectivity, self.cells.offsets[1:-1]) if len(self.sites) else []

    def __len__(self) -> int:
        return len(self.sites)

    def __repr__(self) -> str:
        return f"<PowerDiagram: {len(self.sites)} cells, {len(self.vertices)} corners>"


def regular_triangulation(
    points: ArrayLike,
    weights: ArrayLike | None = None,
    *,
    facets: str = "triangles",
    threads: int = 0,
    non_finite: str = "error",
    engine: str = "automatic",
    progress: Progress = None,
) -> RegularTriangulation:
    """The exact regular (weighted Delaunay) triangulation of points in the plane.

    Parameters
    ----------
    points : n by 2, or n by 3
        x and y count
    weights : n numbers, optional
        squared lengths: the power distance of x from a point p is |x - p|^2 - w. By default none: Delaunay.
    facets : {"triangles", "polygons"}
        which form of the facets is made at once; the other is made when it is asked for
    threads, non_finite, engine, progress
        see the module

    Raises
    ------
    InputError
        names the first point at fault and how many there are
    """
    ignore = ignores(non_finite)
    array, left_out = points_of(points, ignore)
    heavy = None
    if weights is not None:
        heavy, masked = weights_of(weights, ignore)
        left_out = left_out or masked
    chosen = settings(threads, facets, non_finite, engine, progress, left_out)
    core = run(chosen, _core.regular_triangulation, array, heavy)
    return RegularTriangulation(array, heavy, core, left_out)


def power_diagram(
    points: ArrayLike,
    weights: ArrayLike | None = None,
    box: ArrayLike | None = None,
    *,
    threads: int = 0,
    non_finite: str = "error",
    engine: str = "automatic",
    progress: Progress = None,
) -> PowerDiagram:
    """The power diagram of points in the plane, cut at a box; without weights, the Voronoi diagram.

    Parameters
    ----------
    points, weights, threads, non_finite, engine, progress
        as for regular_triangulation()
    box
        as for RegularTriangulation.power_diagram()
    """
    triangulation = regular_triangulation(
        points, weights, facets="polygons", threads=threads, non_finite=non_finite, engine=engine, progress=progress
    )
    return triangulation.power_diagram(box, threads=threads, progress=progress)
