# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The triangulation of an algorithm's input with the constraints of its source: with points that these add."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from . import _vtkmodules as vtk
from ._mesh_added import ids_of_points, pass_empty_data, shares_of, with_crossings, with_points
from ._mesh_cells import Plane, PlaneCells
from ._mesh_source import Source, rows_of_points
from ._meshes import Cloud, block_of, gathered, set_cells
from ._results import Floats, Ids

# Of a part of the run, by its begin and end from 0 to 1.
Part = Callable[[float, float], Any]


class JoinedPoints:
    """Points in a plane, which those of a source's lines may join; and points where lines cross.

    Attributes
    ----------
    positions : ndarray
        of all points in the plane, those that were added last, as rows of two or more
    added, crossings : int
        how many points the source added, and how many crossings did
    differing : int
        at how many points several heights were given that differ
    """

    added = crossings = differing = 0
    _is_joined = False
    _ranges: Floats | None = None
    _heights: Floats | None = None

    def __init__(self, positions: NDArray[Any], mesh: Any, source: Source) -> None:
        self.positions, self._mesh, self._source = positions, mesh, source
        self._given = len(positions)
        self._pieces, self._piece_of, self._sides = source.ends, np.arange(len(source.ends)), source.sides

    def add_marks(self, made: Any, rows: Ids) -> None:
        """Gives these points of the triangulation the arrays of where they are from, and of heights."""
        if not self._is_joined:
            return
        first = self._given + self.added
        origins = (rows >= self._given).astype(np.uint8) + (rows >= first).astype(np.uint8)
        made.GetPointData().AddArray(vtk.array_of(origins, "PointOrigin"))
        if self._ranges is not None:
            made.GetPointData().AddArray(vtk.array_of(self._ranges[rows], "HeightRange"))

    def _join(self, own: NDArray[Any], split: bool, settings: Any) -> None:
        """With the lines' points in the plane, or again the given ones, if lines name these."""
        source = self._source
        found = source.engine(_core.join_lines, self.positions, own, source.ends, source.sides, split, settings)
        self._pieces, self._piece_of, self._sides, positions, self._line_points, self._firsts, self._handle = found
        self._is_joined = True
        self.added, self.crossings = len(self._line_points), len(self._firsts)
        if len(positions):
            self.positions = np.concatenate([np.asarray(self.positions[:, :2], np.float64), positions])

    def _find_heights(self, given: NDArray[Any], lines: NDArray[Any], core: Any, settings: Any) -> None:
        """By x, y and height of the given points and of the lines'."""
        found = _core.line_heights(
            given, lines, self._source.ends, self._source.sides, self._handle, core, settings
        )
        self._heights, self._ranges, self.differing = found

    def _extended(self, cloud: Cloud, in_xy: bool, by_height: bool) -> Cloud:
        """The points in space, with data and ids. Crossings are where they are in the plane, and at that height."""
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
            at = self.positions[self._given + self.added :]
            ends = self._ends_of_crossings()
            shares = shares_of(at, *(np.asarray(self.positions[ids, :2], np.float64) for ids in ends.T))
            positions = _between(rows_of_points(whole)[ends].astype(np.float64), shares)
            if in_xy:
                positions[:, :2] = at
            if by_height and self._heights is not None:
                positions[:, 2] = self._heights[self.added :]
            whole = with_crossings(whole, positions, ends, shares)
        found = Cloud([block_of(whole, "")], False, True)
        found.names = ids_of_points(whole)
        return found

    def _ends_of_crossings(self) -> Ids:
        """Of each crossing, the ends of the first constraint there."""
        begins = np.searchsorted(self._piece_of, self._firsts)
        ends = np.searchsorted(self._piece_of, self._firsts, "right") - 1
        return np.column_stack([self._pieces[begins, 0], self._pieces[ends, 1]])


class Joined(JoinedPoints):
    """A constrained triangulation.

    Attributes
    ----------
    plane : Plane
        all points, those that were added, too
    core : object
        the engine's triangulation, with what is outside polygons
    """

    def __init__(self, plane: Plane, mesh: Any, source: Source, split: bool, by_direction: bool, part: Part) -> None:
        super().__init__(plane.positions, mesh, source)
        self.plane = plane
        own, heights_of = plane.positions, plane.cloud.array
        if source.is_own:
            heights_of = source.points
            own = plane.projection.as_others(heights_of, part(0.05, 0.05))
        if split or source.is_own:
            self._join(own, split, part(0.05, 0.2))
        plane.positions = self.positions
        arguments = self.positions, self._pieces, self._sides, by_direction, None, part(0.2, 1.0)
        self.core = source.engine(_core.constrained_triangulation, *arguments, piece_of=self._piece_of)
        is_xy = plane.projection.is_xy
        if self._is_joined and is_xy:
            self._find_heights(plane.cloud.array, heights_of, self.core, part(1.0, 1.0))
        if self.added or self.crossings:
            plane.cloud = self._extended(plane.cloud, is_xy, is_xy)

    def cells(self) -> PlaneCells:
        """What is inside the polygons."""
        return PlaneCells(self.plane, self.core.inside())

    def fixed_edges(self, made: Any, to: Any) -> None:
        """Gives a mesh the points of the triangulation's mesh, and a line for each edge that is fixed."""
        to.SetPoints(made.GetPoints())
        to.GetPointData().ShallowCopy(made.GetPointData())
        edges = self.core.fixed_edges()
        set_cells(to, 1, 2, None, np.searchsorted(self.core.inside().vertices(), edges.ravel()))
        cells = self._source.cell_of[self._piece_of[self.core.constraint_of()]]
        to.GetCellData().AddArray(vtk.ids_of(cells, "ConstraintCellIds"))


def _between(positions: Floats, shares: Floats) -> Floats:
    share = shares[:, None]
    found: Floats = (1.0 - share) * positions[:, 0] + share * positions[:, 1]
    return found
