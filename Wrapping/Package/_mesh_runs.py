# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the functions for PyVista do with a mesh once their arguments are read: the engine's runs, block by block."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pyvista as pv
from numpy.typing import NDArray

from . import _core
from ._arguments import Weights, choice_of, flag_of, threads_of
from ._constraints import Constraints, PolygonRule
from ._domain import Domain
from ._errors import AbortedError, FlipFlopError, InputError
from ._geometries import Lines
from ._lines import JoinedTriangulation, joined_triangulation
from ._mesh_constraints import CloudConstraints
from ._mesh_lines import mesh_of, points_of_mesh
from ._meshes import LEAVES, Block, Cloud, blocks_of, composite_of, is_tree, pass_field_data, set_cells
from ._projection import Projection
from ._results import ENGINES, QUIET, Ids, Progress, Report, report_of, stretch
from ._surfaces import by_cell, surface_of
from ._terrain import mesh_with_lines

Output = pv.PolyData | pv.MultiBlock | pv.PartitionedDataSet
# So many blocks at fault are named at most.
_MOST_NAMED = 8


class Run:
    """The choices of a call, and what it makes of one block."""

    def __init__(
        self, facets: str, threads: int, non_finite: str, engine: str, skip_ghosts: bool, pass_data: bool
    ) -> None:
        self._polygons = choice_of("facets", facets, ("triangles", "polygons")) == "polygons"
        self._ignore = choice_of("non_finite", non_finite, ("error", "ignore")) == "ignore"
        self._engine = ENGINES[choice_of("engine", engine, tuple(ENGINES))]
        self._threads = threads_of(threads)
        self._skip_ghosts = flag_of("skip_ghost_points", skip_ghosts)
        self._pass_data = flag_of("pass_point_data", pass_data)

    def hull(self, blocks: list[Block], report: Report, with_index: bool = False) -> pv.PolyData:
        """The hull of all these blocks; on request with the block of each of its points."""
        cloud = Cloud(blocks, self._skip_ghosts, self._ignore)
        core = cloud.engine(_core.convex_hull, cloud.array, self._settings(cloud, report))
        hull = self._cells_of(cloud, core)
        if with_index:
            hull.point_data.set_array(cloud.block_index(cloud.ids(core.vertices())), "BlockIndex")
        return hull

    def convexified(self, block: Block, kernel: tuple[float, ...] | None, report: Report) -> pv.PolyData:
        part = block.checked().part
        if part is not None and block.count and part.mesh.GetNumberOfCells() == 0:
            of = f" of {block.name}" if block.name else ""
            raise InputError(f"the surface{of} has no cells, but {block.count} point(s)", "bad_argument")
        cloud = Cloud([block], False, False)
        settings = self._settings(cloud, report)
        starts, corners, cell_of = surface_of(part, block.name)
        triangles = corners
        if cell_of is not None:
            cut = cloud.engine(by_cell(_core.triangulate_polygons, cell_of), cloud.array, starts, corners, settings)
            triangles, polygon_of = cut
            cell_of = cell_of[polygon_of]
        flip = by_cell(_core.convexify, cell_of)
        core = cloud.engine(flip, cloud.array, triangles.reshape(-1, 3), kernel, settings)
        return self._cells_of(cloud, core)

    def triangulation(
        self,
        block: Block,
        weights: Weights,
        constraints: Constraints | None,
        projection: Projection,
        alpha: float | None,
        limit: float | None,
        report: Report,
        hidden: bool,
    ) -> list[pv.PolyData]:
        cloud = Cloud([block], self._skip_ghosts, self._ignore)
        weight_array = cloud.weights(weights, self._ignore)
        settings = self._settings(cloud, report)
        positions = projection.to_plane(cloud.array, settings)
        if constraints is None:
            core = cloud.engine(_core.regular_triangulation, positions, weight_array, settings)
        else:
            given = CloudConstraints(constraints, cloud, projection.is_xy)
            core = self._constrained(cloud, positions, given, settings)
        within = None
        if alpha is not None:
            within = cloud.engine(_core.alpha_complex, positions, weight_array, core, alpha, QUIET)[0].view(np.bool_)
        if limit is not None:
            short = cloud.engine(_core.cells_within_edge_length, positions, core, limit, QUIET).view(np.bool_)
            within = short if within is None else within & short
        found = [self._cells_of(cloud, core, within)]
        if hidden:
            ids = cloud.ids(core.hidden())
            found.append(cloud.mesh(ids, self._pass_data))
            set_cells(found[1], 0, 1, None, np.arange(len(ids)))
        return found

    def _constrained(self, cloud: Cloud, positions: NDArray[Any], given: CloudConstraints, settings: Any) -> Any:
        if self._engine == ENGINES["cuda"]:
            raise ValueError("the CUDA engine was asked for, but constraints are the CPU's")
        arguments = positions, given.ends, given.sides, given.by_direction, None, settings
        found = cloud.engine(given.engine, _core.constrained_triangulation, *arguments)
        given.warn_if_none(found)
        return found.inside()

    def joined(
        self, block: Block, lines: Any, given: Lines, polygon_rule: PolygonRule, report: Report
    ) -> pv.PolyData:
        """With lines that have points of their own, by x and y."""
        cloud = Cloud([block], self._skip_ghosts, self._ignore)

        def part(begin: float, end: float) -> Any:
            return self._settings(cloud, stretch(report, begin, end))

        found = cloud.engine(joined_triangulation, cloud.array, given, polygon_rule, cloud.left_out, part)
        return mesh_of(cloud, found, lines, self._pass_data)

    def terrain(
        self,
        block: Block,
        heights: Weights,
        constraints: Constraints | None,
        lines: tuple[Any, Lines] | None,
        limits: tuple[float, int],
        report: Report,
        rest: bool,
    ) -> list[pv.PolyData]:
        cloud = Cloud([block], self._skip_ghosts, self._ignore)
        levels = cloud.weights(heights, self._ignore, "height")
        if levels is None and cloud.array.shape[1] == 2:
            raise ValueError("points of two coordinates take heights")
        joined: JoinedTriangulation | None = None
        if lines is None:
            given = CloudConstraints(constraints or Constraints(None, None), cloud, True)
            arguments = cloud.array, levels, given.ends, *limits, self._settings(cloud, report)
            found = cloud.engine(given.engine, _core.terrain_mesh, *arguments)
        else:

            def part(begin: float, end: float) -> Any:
                return self._settings(cloud, stretch(report, begin, end))

            mesh = cloud.engine(mesh_with_lines, cloud.array, levels, lines[1], limits, cloud.left_out, part)
            found, joined = vars(mesh), mesh.joined

        def points_of(rows: Ids) -> pv.PolyData:
            if joined is None or lines is None:
                return cloud.mesh(cloud.ids(rows), self._pass_data)
            return points_of_mesh(cloud, joined, rows, lines[0], self._pass_data)

        vertices, simplices = found["vertices"], found["simplices"]
        made = [points_of(vertices)]
        set_cells(made[0], found["dimension"], simplices.shape[1], None, np.searchsorted(vertices, simplices.ravel()))
        if rest:
            left = ~np.isnan(found["errors"])
            left[vertices] = False
            rows = np.flatnonzero(left)
            made.append(points_of(rows))
            set_cells(made[1], 0, 1, None, np.arange(len(rows)))
            made[1].point_data["TerrainError"] = found["errors"][rows]
        return made

    def diagram(
        self, block: Block, weights: Weights, projection: Projection, domain: Domain, report: Report
    ) -> pv.PolyData:
        cloud = Cloud([block], self._skip_ghosts, self._ignore)
        weight_array = cloud.weights(weights, self._ignore)
        first, second = split(report, 0.4)
        settings = self._settings(cloud, first)
        positions = projection.to_plane(cloud.array, settings)
        core = cloud.engine(_core.regular_triangulation, positions, weight_array, settings)
        within = None if core.dimension < 0 else domain.array
        arguments = positions, weight_array, core, within, self._settings(cloud, second)
        with domain.named():
            found = cloud.engine(_core.power_diagram, *arguments)
        projection.lie_beneath(cloud.array, core)
        made = pv.PolyData()
        made.SetPoints(pv.vtk_points(projection.to_space(found.vertices()), deep=False, force_float=False))
        set_cells(made, 2, 0, found.offsets(), found.connectivity())
        cloud.pass_data(cloud.ids(found.sites()), made, "cell", self._pass_data)
        return made

    def _settings(self, cloud: Cloud, report: Report) -> Any:
        return _core.Settings(self._threads, self._polygons, cloud.left_out, self._engine, report)

    def _cells_of(self, cloud: Cloud, core: Any, kept: NDArray[np.bool_] | None = None) -> pv.PolyData:
        """A mesh of the points and the cells, or of those cells that are kept."""
        made = cloud.mesh(cloud.ids(core.vertices()), self._pass_data)
        size = core.cell_size
        offsets, corners = None if size else core.offsets(), core.connectivity()
        if kept is not None:
            sizes = np.full(len(kept), size) if offsets is None else np.diff(offsets)
            corners = corners[np.repeat(kept, sizes)]
            offsets = None if offsets is None else np.concatenate([[0], np.cumsum(sizes[kept])])
        set_cells(made, core.dimension, size, offsets, corners)
        return made


def each_block(
    data: Any,
    make: Callable[[Block, Report], list[pv.PolyData]],
    count: int,
    progress: Progress,
    leaves: tuple[str, ...] = LEAVES,
) -> list[Output]:
    """What is made of each block: so many meshes, or composites of them.

    If some blocks are at fault, the error of the first one is raised in the end: see errors_of().
    """
    made: list[list[pv.PolyData | None]] = []
    errors: dict[int, FlipFlopError] = {}
    with report_of(progress) as report:
        blocks = blocks_of(data, leaves)
        total = 1 + sum(block.count for block in blocks if block is not None)
        done = 0
        for block in blocks:
            made.append([None] * count)
            if block is None:
                continue
            try:
                meshes = make(block.checked(), stretch(report, done / total, (done + block.count) / total))
            except AbortedError:
                raise
            except FlipFlopError as error:
                if not is_tree(data):
                    raise
                errors[block.flat_index] = error
                continue
            finally:
                done += block.count
            for mesh in meshes if block.part is not None and block.part.mesh is not None else ():
                pass_field_data(block.part.mesh, mesh)
            made[-1] = [*meshes]
    if not is_tree(data):
        return [mesh for mesh in made[0] if mesh is not None]
    composites = [composite_of(data, [meshes[i] for meshes in made]) for i in range(count)]
    if errors:
        raise error_of(errors, sum(block is not None for block in blocks), composites)
    return composites


def error_of(errors: dict[int, FlipFlopError], count: int, composites: list[Output]) -> FlipFlopError:
    """The error of a composite of so many blocks: the first block's, with what the others have as its result."""
    first = next(iter(errors.values()))
    if len(errors) == count:
        sentence = f"; none of the {count} blocks has a result" if count > 1 else ""
    else:
        named = ", ".join(map(str, list(errors)[:_MOST_NAMED]))
        more = f" and {len(errors) - _MOST_NAMED} more" if len(errors) > _MOST_NAMED else ""
        sentence = f"; no result: {len(errors)} of {count} blocks, of flat index {named}{more}"
        sentence += "; the others' are the error's attribute result"
    error = type(first)(str(first) + sentence, first.code, first.index, first.count)
    error.errors = errors
    if len(errors) < count:
        error.result = composites[0] if len(composites) == 1 else tuple(composites)
    return error


def split(report: Report, at: float) -> tuple[Report, Report]:
    """For what is done until a fraction of the whole, and for the rest."""
    return stretch(report, 0.0, at), stretch(report, at, 1.0)
