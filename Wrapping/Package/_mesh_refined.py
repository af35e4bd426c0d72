# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Refined meshes of a mesh's polygons and lines."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _core
from . import _vtkmodules as vtk
from ._mesh_added import ids_of_points, with_interpolated
from ._mesh_joined import JoinedPoints, Part
from ._mesh_source import Source, rows_of_points
from ._meshes import Cloud, block_of, set_cells
from ._refine import sums_of
from ._results import Floats, Ids, distinct

ANYWHERE = (0.0, 0.0, 1.0, 1.0)  # where pixels are, of which there are none


class Refined(JoinedPoints):
    """A refined mesh of points and constraints.

    Attributes
    ----------
    cloud : Cloud
        the points, those where constraints cross, too
    """

    def __init__(self, cloud: Cloud, mesh: Any, source: Source, split: bool, part: Part) -> None:
        super().__init__(cloud.array, mesh, source)
        self.cloud = cloud
        if split:
            self._join(self.positions, True, part(0.05, 0.1))
            if self.crossings:
                self.cloud = self._extended(cloud, True, False)

    def found(
        self,
        limits: tuple[float, float, int],
        regions: Floats,
        areas: Floats | None,
        by_direction: bool,
        settings: Any,
        area_at: Any = None,
    ) -> dict[str, Any]:
        """What the engine finds."""
        arguments = self._sides, by_direction, None, limits, regions, areas, None, ANYWHERE, area_at, settings
        pieces = np.ascontiguousarray(self._pieces)
        found: dict[str, Any] = self._source.engine(
            _core.refined_mesh, self.positions, pieces, *arguments, piece_of=self._piece_of
        )
        self._found = found
        return found

    def meshes(self, pass_point_data: bool) -> list[Any]:
        """The triangles, and the edges of these that constraints run along."""
        found, cloud = self._found, self._with_new_points()
        triangles, regions = found["simplices"], found["region_of"]
        rows = distinct(triangles)
        made = cloud.mesh(cloud.ids(rows), pass_point_data)
        set_cells(made, 2, 3, None, np.searchsorted(rows, triangles.ravel()))
        data = made.GetCellData()
        data.AddArray(vtk.ids_of(regions - 1, "Region"))
        data.AddArray(vtk.array_of(found["angles"], "MinimumAngle"))
        data.AddArray(vtk.array_of(found["areas"], "Area"))

        edges = found["segments"]
        is_there = np.isin(_keys_of(edges), _keys_of(np.sort(_sides_of(triangles), axis=1)))
        lines = vtk.vtkPolyData()
        lines.SetPoints(made.GetPoints())
        lines.GetPointData().ShallowCopy(made.GetPointData())
        set_cells(lines, 1, 2, None, np.searchsorted(rows, edges[is_there].ravel()))
        cells = np.append(self._source.cell_of[self._piece_of], -1)[found["constraint_of"][is_there]]
        lines.GetCellData().AddArray(vtk.ids_of(cells, "ConstraintCellIds"))
        return [made, lines]

    def _with_new_points(self) -> Cloud:
        """The points in space with those of the refinement, and data."""
        count = len(self.positions)
        positions = self._found["points"][count:]
        if not len(positions):
            return self.cloud
        whole = Cloud(self.cloud.blocks, False, True)
        whole.names = self.cloud.names
        given = whole.mesh(self.cloud.ids(np.arange(count)), True)
        offsets, ids, shares = self._found["_shares"]
        heights = rows_of_points(given)[ids, 2].astype(np.float64) * shares
        space = np.column_stack([positions, sums_of(heights, offsets)])
        found = Cloud([block_of(with_interpolated(given, space, offsets, ids, shares), "")], False, True)
        found.names = ids_of_points(found.blocks[0].part.mesh)  # type: ignore[union-attr]
        return found


def _sides_of(triangles: Ids) -> Ids:
    return np.concatenate([triangles[:, [i, (i + 1) % 3]] for i in range(3)])


def _keys_of(edges: Ids) -> Ids:
    """One number for each edge, whose lower id comes first."""
    return edges[:, 0] << np.int64(32) | edges[:, 1]
