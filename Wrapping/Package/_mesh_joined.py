# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The triangulation of an algorithm's input with the constraints of its source: with points that these add."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from . import _core
from . import _vtkmodules as vtk
from ._mesh_added import ids_of_points, pass_empty_data, shares_of, with_crossings, with_points
from ._mesh_cells import Plane, PlaneCells
from ._mesh_source import Source, rows_of_points
from ._meshes import Cloud, block_of, gathered, set_cells
from ._results import Floats, Ids

# Of a part of the run, by its begin and end from 0 to 1.
Part = Callable[[float, float], Any]


class Joined:
    """A constrained triangulation.

    Attributes
    ----------
    plane : Plane
        all points, those that were added, too
    core : object
        the engine's triangulation, with what is outside polygons
    added, crossings : int
        how many points the source added, and how many crossings did
    differing : int
        at how many points several heights were given that differ
    """

    added = crossings = differing = 0
    _ranges: Floats | None = None
    _heights: Floats | None = None

    def __init__(self, plane: Plane, mesh: Any, source: Source, split: bool, by_direction: bool, part: Part) -> None:
        self.plane, self._mesh, self._source = plane, mesh, source
        self._given = len(plane.cloud.array)
        self._pieces, self._piece_of = source.ends, np.arange(len(source.ends))
        self._is_joined = split or source.is_own
        own, heights_of = plane.positions, plane.cloud.array
        if self._is_joined:
            if source.is_own:
                heights_of = source.points
                own = plane.projection.as_others(heights_of, part(0.05, 0.05))
            lines = own, source.ends, source.sides
            found = source.engine(_core.join_lines, plane.positions, *lines, split, part(0.05, 0.2))
            self._pieces, self._piece_of, sides, positions, self._line_points, self._firsts, handle = found
            self.added, self.crossings = len(self._line_points), len(self._firsts)
            if len(positions):
                plane.positions = np.concatenate([np.asarray(plane.positions[:, :2], np.float64), positions])
        else:
            sides = source.sides
        arguments = plane.positions, self._pieces, sides, by_direction, None, part(0.2, 1.0)
        self.core = source.engine(_core.constrained_triangulation, *arguments, piece_of=self._piece_of)
        if self._is_joined and plane.projection.is_xy:
            lines = heights_of, source.ends, source.sides
            found = _core.line_heights(plane.cloud.array, *lines, handle, self.core, part(1.0, 1.0))
            self._heights, self._ranges, self.differing = found
        if self.added or self.crossings:
            plane.cloud = self._extended()

    def cells(self) -> PlaneCells:
        """What is inside the polygons."""
        return PlaneCells(self.plane.cloud, self.plane.positions, None, self.core.inside())

    def add_marks(self, made: Any, rows: Ids) -> None:
        """Gives these points of the triangulation the arrays of where they are from, and of heights."""
        if not self._is_joined:
            return
        first = self._given + self.added
        origins = (rows >= self._given).astype(np.uint8) + (rows >= first).astype(np.uint8)
        made.GetPointData().AddArray(vtk.array_of(origins, "PointOrigin"))
        if self._ranges is not None:
            made.GetPointData().AddArray(vtk.array_of(self._ranges[rows], "HeightRange"))

    def fixed_edges(self, made: Any, to: Any) -> None:
        """Gives a mesh the points of the triangulation's mesh, and a line for each edge that is fixed."""
        to.SetPoints(made.GetPoints())
        to.GetPointData().ShallowCopy(made.GetPointData())
        edges = self.core.fixed_edges()
        set_cells(to, 1, 2, None, np.searchsorted(self.core.inside().vertices(), edges.ravel()))
        cells = self._source.cell_of[self._piece_of[self.core.constraint_of()]]
        to.GetCellData().AddArray(vtk.ids_of(cells, "ConstraintCellIds"))

    def _extended(self) -> Cloud:
        """The points in space, with data and ids."""
        cloud, projection = self.plane.cloud, self.plane.projection
        # Of all points, so that arrays are there where all but the added ones are ghosts.
        base = Cloud(cloud.blocks, False, True)
        whole = base.mesh(cloud.ids(np.arange(self._given)), True)
        if not base.count:
            pass_empty_data(cloud.blocks[0].part.mesh, whole)  # type: ignore[union-attr]
        if self.added:
            points = vtk.vtkPoints()
            points.SetData(gathered([(self._mesh.GetPoints().GetData(), self._line_points)], self.added))
            whole = with_points(whole, points, self._mesh, self._line_points)
        if self.crossings:
            at = self.plane.positions[self._given + self.added :]
            ends = self._ends_of_crossings()
            shares = shares_of(at, *(np.asarray(self.plane.positions[ids, :2], np.float64) for ids in ends.T))
            positions = _between(rows_of_points(whole)[ends].astype(np.float64), shares)
            if projection.is_xy and self._heights is not None:
                positions[:, :2], positions[:, 2] = at, self._heights[self.added :]
            whole = with_crossings(whole, positions, ends, shares)
        found = Cloud([block_of(whole, "")], False, True)
        found.names = ids_of_points(whole)
        return found

    def _ends_of_crossings(self) -> Ids:
        """Of each crossing, the ends of the first constraint there."""
        begins = np.searchsorted(self._piece_of, self._firsts)
        ends = np.searchsorted(self._piece_of, self._firsts, "right") - 1
        return np.column_stack([self._pieces[begins, 0], self._pieces[ends, 1]])


def _between(positions: Floats, shares: Floats) -> Floats:
    share = shares[:, None]
    found: Floats = (1.0 - share) * positions[:, 0] + share * positions[:, 1]
    return found
