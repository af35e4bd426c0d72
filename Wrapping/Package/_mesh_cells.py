# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The cells of a triangulation in the plane of which some are left out, and what they measure."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from . import _vtkmodules as vtk
from ._meshes import Cloud, set_cells
from ._projection import Projection
from ._results import Floats, Ids, distinct


@dataclass
class Plane:
    """Points of a run in the plane, as rows of two or more; their weights, and the settings of the run.

    then: the settings of what is done with the triangulation
    """

    cloud: Cloud
    positions: NDArray[Any]
    weights: NDArray[Any] | None
    projection: Projection
    settings: Any
    then: Any

    def triangulated(self) -> PlaneCells:
        core = self.cloud.engine(_core.regular_triangulation, self.positions, self.weights, self.settings)
        return PlaneCells(self, core)


class PlaneCells:
    """A triangulation, and of its alpha complex the edges and points of none of its cells: lines and vertices.

    Arrays of cells are in VTK's order: vertices, lines, polygons.

    Attributes
    ----------
    core : object
        the cells that are not left out
    """

    def __init__(self, plane: Plane, core: Any) -> None:
        self._cloud, self._positions, self._weights = plane.cloud, plane.positions, plane.weights
        self._settings, self.core = plane.then, core
        self._edges: Ids = np.empty((0, 2), np.int64)
        self._vertices: Ids = np.empty(0, np.int64)
        self._edge_alphas = self._vertex_alphas = np.empty(0)

    def drop(self, alpha: float | None, limit: float | None, lines: bool = False, vertices: bool = False) -> int:
        """Leaves out cells that are not in the alpha complex, or have a longer edge. Returns how many."""
        count = self.core.cell_count
        if alpha is not None and count:
            arguments = self._positions, self._weights, self.core, alpha, self._settings, lines or vertices
            within, edges, edge_alphas, points, point_alphas = self._cloud.engine(_core.alpha_complex, *arguments)
            self._keep(within)
            if lines:
                self._edges, self._edge_alphas = edges, edge_alphas
            if vertices:
                self._vertices, self._vertex_alphas = points, point_alphas
        if limit is not None:
            if self.core.cell_count:
                self._keep(self._short(self.core, limit))
            if len(self._edges):
                short = self._short(_core.edges_of(self._edges), limit).view(np.bool_)
                self._edges, self._edge_alphas = self._edges[short], self._edge_alphas[short]
        return int(count - self.core.cell_count)

    def alphas(self) -> Floats:
        """For each cell the least alpha at which it is in the complex."""
        found = [self._vertex_alphas, self._edge_alphas]
        if self.core.cell_count:
            found.append(_core.cell_alphas(self._positions, self._weights, self.core, self._settings))
        return np.concatenate(found)

    def measures(self) -> tuple[Floats, Floats]:
        """The cells' areas, and their centroids in the plane."""
        vertices = np.asarray(self._positions[self._vertices, :2], np.float64)
        areas, centroids = [np.zeros(len(vertices))], [vertices]
        for cells in (_core.edges_of(self._edges), self.core):
            if cells.cell_count:
                found = _core.triangle_measures(self._positions, cells)
                areas.append(found[0])
                centroids.append(found[1])
        return np.concatenate(areas), np.concatenate(centroids)

    def add_complex(self, made: Any) -> None:
        """Gives a mesh of the cells the lines and the vertices, too."""
        all_points = self.core.vertices()
        set_cells(made, 1, 2, None, np.searchsorted(all_points, self._edges.ravel()))
        set_cells(made, 0, 1, None, np.searchsorted(all_points, self._vertices))

    def boundary(self, pass_data: bool) -> Any:
        """The border of the cells: closed polylines of the points that are there."""
        offsets, ids = _core.cell_boundary(self.core, self._settings)
        rows = distinct(ids)
        made = self._cloud.mesh(self._cloud.ids(rows), pass_data)
        closed = np.insert(ids, offsets[1:], ids[offsets[:-1]])
        set_cells(made, 1, 0, offsets + np.arange(len(offsets)), np.searchsorted(rows, closed))
        return made

    def hidden(self, pass_data: bool) -> Any:
        """A vertex for each point that is hidden."""
        ids = self._cloud.ids(self.core.hidden())
        made = self._cloud.mesh(ids, pass_data)
        set_cells(made, 0, 1, None, np.arange(len(ids)))
        return made

    def _keep(self, kept: NDArray[np.uint8]) -> None:
        if not kept.all():
            self.core = _core.with_cells(self.core, kept)

    def _short(self, cells: Any, limit: float) -> NDArray[np.uint8]:
        found: NDArray[np.uint8] = self._cloud.engine(
            _core.cells_within_edge_length, self._positions, cells, limit, self._settings
        )
        return found


def add_measures(made: Any, measures: tuple[Floats, Floats], projection: Projection) -> None:
    """Gives cells the arrays of their areas, and of their centroids, which are in the plane, in space."""
    areas, centroids = measures
    in_space = projection.to_space(centroids, "the cells' centroids")
    for values, name in ((areas, "Area"), (in_space, "Centroid")):
        made.GetCellData().AddArray(vtk.array_of(values, name))


def is_vertical_plane(plane: Plane, core: Any) -> bool:
    """Whether points that the triangulation has on a line are not on a line in space."""
    points = plane.cloud.array
    if core.dimension != 1 or points.shape[1] != 3:
        return False
    rows = np.concatenate([core.vertices(), core.hidden()])
    return bool(_core.convex_hull(np.asarray(points[rows], np.float64), plane.then).dimension > 1)
