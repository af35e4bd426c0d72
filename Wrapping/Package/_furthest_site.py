# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Furthest-site triangulations of points in the plane, and their diagrams."""

from __future__ import annotations

from functools import cached_property
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._input import points_of
from ._plane_cells import PlanarCells
from ._queries import Numbers
from ._results import Ids, NonFinite, Polygons, Progress, frozen, ignores, run, settings
from ._triangulation import regular_triangulation
from ._voronoi import VoronoiDiagram


class FurthestSiteTriangulation(PlanarCells):
    """The exact furthest-site Delaunay triangulation of points in the plane: no point is outside a triangle's circle.

    It is the regular triangulation with weights of twice the squared norm, which are not rounded here: the lower hull
    of the points at the heights -x^2 - y^2. Its vertices are the corners of the convex hull.
    """

    weights = None
    _call: ClassVar[str] = "furthest_site_triangulation(points)"

    @cached_property
    def hidden(self) -> Ids:
        """Ids of the points that are no corners of the convex hull, ascending."""
        return self._core.hidden()

    @cached_property
    def polygons(self) -> Polygons:
        """Facets as ids: all corners of one circle are one polygon."""
        return Polygons(self._core.offsets(), self._core.corners())

    def voronoi_diagram(self) -> FurthestSiteDiagram:
        """The diagram whose cells have the positions from which their point is the furthest."""
        return FurthestSiteDiagram._of(triangulation=self)

    def locate(self, points: ArrayLike, *, threads: int = 0, non_finite: NonFinite = "error") -> Numbers:
        """The simplex that holds each point, as RegularTriangulation has it."""
        found: Numbers = self._located.locate(points, threads=threads, non_finite=non_finite)
        return found

    def __repr__(self) -> str:
        return f"<FurthestSiteTriangulation of {self.npoints} points: {len(self.vertices)} vertices>"

    @cached_property
    def _located(self) -> Any:
        """The same triangles as a constrained triangulation of the vertices."""
        edges = np.searchsorted(self.vertices, self.edges)
        return regular_triangulation(self.points[self.vertices], constraints=edges)

    @property
    def _facets(self) -> tuple[Any, NDArray[Any], None, None]:
        """As RegularTriangulation has it."""
        return self._core, self.points, None, None


class FurthestSiteDiagram(VoronoiDiagram):
    """The furthest-site Voronoi diagram of points in the plane, whose cells are all unbounded, as VoronoiDiagram.

    Only the corners of the convex hull have cells. Directions of rays point into the triangulation.

    Attributes
    ----------
    triangulation : FurthestSiteTriangulation
        whose dual this is
    """

    triangulation: Any
    _call: ClassVar[str] = "furthest_site_triangulation(points).voronoi_diagram()"

    @cached_property
    def cell_of(self) -> Ids:
        """For each point the row of its cell; -1: it has none."""
        found = np.full(self.triangulation.npoints, -1)
        found[self.sites] = np.arange(len(self.sites))
        return frozen(found)

    @property
    def ridge_vertices(self) -> Ids:
        """The two ends of each side, as VoronoiDiagram has them: of two, the right one first."""
        ends = super().ridge_vertices.copy()
        is_closed = ends[:, 0] >= 0
        ends[is_closed] = ends[is_closed, ::-1]
        return frozen(ends)

    def __repr__(self) -> str:
        return super().__repr__().replace("VoronoiDiagram", type(self).__name__)

    @property
    def _border(self) -> Ids:
        """Clockwise: rays run the other way."""
        return super()._border[:, ::-1]


def furthest_site_triangulation(
    points: ArrayLike, *, threads: int = 0, non_finite: NonFinite = "error", progress: Progress = None
) -> FurthestSiteTriangulation:
    """The exact furthest-site Delaunay triangulation of points in the plane.

    Parameters
    ----------
    points : n by 2, or n by 3: x and y count
    threads, non_finite, progress
        see the module
    """
    array, left_out = points_of(points, ignores(non_finite))
    chosen = settings(threads, "polygons", non_finite, "cpu", progress, left_out)
    core: Any = run(chosen, _core.furthest_site_triangulation, array)
    return FurthestSiteTriangulation._made(array, core, left_out)
