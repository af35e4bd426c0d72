# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Terrain meshes of a mesh's points: with the lines of a source, and what the engine found as meshes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from . import _vtkmodules as vtk
from ._mesh_joined import JoinedPoints, Part
from ._mesh_source import Source
from ._meshes import Cloud, set_cells
from ._results import Ids

Heights = NDArray[Any] | None  # None: they are z


def meshes_of_terrain(found: dict[str, Any], points_of: Callable[[Ids], Any], rest: bool) -> list[Any]:
    """The mesh; and of the points that were not kept, vertices with their errors. points_of: a mesh of some points."""
    vertices, simplices = found["vertices"], found["simplices"]
    made = [points_of(vertices)]
    set_cells(made[0], found["dimension"], simplices.shape[1], None, np.searchsorted(vertices, simplices.ravel()))
    if rest:
        left = ~np.isnan(found["errors"])
        left[vertices] = False
        rows = np.flatnonzero(left)
        made.append(points_of(rows))
        set_cells(made[1], 0, 1, None, np.arange(len(rows)))
        made[1].GetPointData().AddArray(vtk.array_of(found["errors"][rows], "TerrainError"))
    return made


class Survey(JoinedPoints):
    """Points with heights, and the lines of a source, which has heights of its own.

    Attributes
    ----------
    cloud : Cloud
        all points, those that were added, too
    """

    def __init__(
        self, cloud: Cloud, heights: Heights, mesh: Any, source: Source, own: Heights, split: bool, part: Part
    ) -> None:
        self._space = self._lines = _in_space(cloud.array, heights)
        super().__init__(_in_plane(self._space, part(0.0, 0.0)), mesh, source)
        self.cloud, self._rows, self._heights_of_rows = cloud, cloud.array, heights
        if split or source.is_own:
            if source.is_own:
                self._lines = _in_space(source.points, own)
            else:
                own = heights
            self._join(_in_plane(self._lines, part(0.0, 0.0)), split, part(0.0, 0.2))
            self._rows, self._heights_of_rows = self._all_rows(part(0.2, 0.2)), None
        if self.added or self.crossings:
            self.cloud = self._extended(cloud, True, heights is None and own is None)

    def mesh(self, limits: tuple[float, int, bool], settings: Any) -> dict[str, Any]:
        """The terrain mesh of all points."""
        tolerance, vertices, is_fraction = limits
        arguments = self._rows, self._heights_of_rows, self._pieces, tolerance, vertices, settings, is_fraction
        found, core = self._source.engine(_core.terrain_mesh, *arguments, piece_of=self._piece_of)
        if self._is_joined:
            self._find_heights(self._space, self._lines, core, settings)
        made: dict[str, Any] = found
        return made

    def _all_rows(self, settings: Any) -> NDArray[np.float64]:
        """x, y and height of all points; at a crossing that of the first line there."""
        rows = [self._space, self._lines[self._line_points]]
        if self.crossings:
            arguments = self.positions, self._pieces, 0, False, None, settings
            core = self._source.engine(_core.constrained_triangulation, *arguments, piece_of=self._piece_of)
            self._find_heights(self._space, self._lines, core, settings)
            assert self._heights is not None
            rows.append(np.column_stack([self.positions[-self.crossings :, :2], self._heights[self.added :]]))
        return np.concatenate([np.asarray(some, np.float64) for some in rows])


def _in_space(rows: NDArray[Any], heights: Heights) -> NDArray[Any]:
    """x, y and height of points."""
    return rows if heights is None else np.column_stack([rows[:, :2].astype(np.float64), heights.astype(np.float64)])


def _in_plane(space: NDArray[Any], settings: Any) -> NDArray[Any]:
    """x and y of points, which are finite if the height is, too."""
    positions: NDArray[Any] | None = _core.to_xy_plane(space, settings)
    return space if positions is None else positions
