# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What functions and algorithms do with a mesh once their arguments are read: the engine's runs, block by block."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from . import _vtkmodules as vtk
from ._arguments import Weights, choice_of, flag_of, threads_of
from ._constraints import Constraints, PolygonRule
from ._domain import Domain
from ._errors import AbortedError, FlipFlopError, InputError
from ._geometries import Lines
from ._lines import JoinedTriangulation, joined_triangulation
from ._mesh_cells import Plane, PlaneCells
from ._mesh_constraints import CloudConstraints
from ._mesh_lines import mesh_of, points_of_mesh
from ._mesh_terrain import meshes_of_terrain
from ._meshes import LEAVES, Block, Cloud, blocks_of, composite_of, is_tree, pass_field_data, set_cells
from ._projection import Projection
from ._results import ENGINES, Ids, Progress, Report, report_of, stretch
from ._surfaces import HULL_OF_POINTS, by_cell, surface_of
from ._terrain import mesh_with_lines

Output = Any  # a vtkPolyData, or a composite of such
# Of a power diagram's progress, until the triangulation is there.
TRIANGULATED = 0.4
# So many blocks at fault are named at most.
_MOST_NAMED = 8


class Run:
    """The choices of a call, and what it makes of one block.

    Attributes
    ----------
    core : object
        the cells that the engine made last
    pass_data : bool
        whether points keep their data
    v_biased : bool
    cuda_from : int, or None
        what arrays and PyVista have no arguments for
    """

    core: Any = None
    _last: Any = None  # the settings of the engine's last run
    v_biased = True
    cuda_from: int | None = None

    def __init__(
        self, facets: str, threads: int, non_finite: str, engine: str, skip_ghosts: bool, pass_data: bool
    ) -> None:
        self._polygons = choice_of("facets", facets, ("triangles", "polygons")) == "polygons"
        self._ignore = choice_of("non_finite", non_finite, ("error", "ignore")) == "ignore"
        self._engine = ENGINES[choice_of("engine", engine, tuple(ENGINES))]
        self._threads = threads_of(threads)
        self._skip_ghosts = flag_of("skip_ghost_points", skip_ghosts)
        self.pass_data = flag_of("pass_point_data", pass_data)
        self._reason = ""

    @property
    def engine(self) -> tuple[int, str]:
        """The engine that was used last, and why."""
        if self._reason:
            return 1, "the CPU engine was asked for" if self._engine == ENGINES["cpu"] else self._reason
        return self._last.engine_used, self._last.engine_reason

    def use_cpu(self, reason: str) -> None:
        """The work is the CPU engine's, for this reason."""
        self._reason = reason

    def hull(self, blocks: list[Block], report: Report) -> Any:
        """The hull of all these blocks."""
        cloud = self.cloud(*blocks)
        core = cloud.engine(_core.convex_hull, cloud.array, self.settings(cloud, report))
        return self.cells_of(cloud, core)

    def convexified(self, block: Block, kernel: tuple[float, ...] | None, report: Report) -> Any:
        part = block.checked().part
        if part is not None and block.count and part.mesh.GetNumberOfCells() == 0:
            of = f" of {block.name}" if block.name else ""
            sentence = f"the surface{of} has no cells, but {block.count} point(s)"
            raise InputError(sentence, "bad_argument").for_filters(f"{sentence}. {HULL_OF_POINTS}")
        starts, corners, cell_of = surface_of(part, block.name)
        cloud = Cloud([block], False, False)
        settings = self.settings(cloud, report)
        triangles = corners
        if cell_of is not None:
            cut = cloud.engine(by_cell(_core.triangulate_polygons, cell_of), cloud.array, starts, corners, settings)
            triangles, polygon_of = cut
            cell_of = cell_of[polygon_of]
        flip = by_cell(_core.convexify, cell_of)
        core = cloud.engine(flip, cloud.array, triangles.reshape(-1, 3), kernel, settings)
        return self.cells_of(cloud, core)

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
    ) -> list[Any]:
        plane = self._plane_of(block, weights, projection, report)
        if constraints is None:
            cells = plane.triangulated()
        else:
            given = CloudConstraints(constraints, plane.cloud, projection.is_xy)
            core = self._constrained(plane.cloud, plane.positions, given, plane.settings)
            cells = PlaneCells(plane, core)
        cells.drop(alpha, limit)
        found = [self.cells_of(plane.cloud, cells.core)]
        if hidden:
            found.append(cells.hidden(self.pass_data))
        return found

    def cloud(self, *blocks: Block) -> Cloud:
        """The points of blocks, as one input."""
        return Cloud(blocks, self._skip_ghosts, self._ignore)

    def weights(self, cloud: Cloud, weights: Weights, noun: str = "weight") -> NDArray[Any] | None:
        """One for each point."""
        return cloud.weights(weights, self._ignore, noun)

    def plane(self, cloud: Cloud, weights: NDArray[Any] | None, projection: Projection, report: Report) -> Plane:
        """The points in the plane, with their weights."""
        settings = self.settings(cloud, report)
        then = self._settings(cloud, stretch(report, 1.0, 1.0), ENGINES["cpu"])
        return Plane(cloud, projection.to_plane(cloud.array, settings), weights, projection, settings, then)

    def _plane_of(self, block: Block, weights: Weights, projection: Projection, report: Report) -> Plane:
        cloud = self.cloud(block)
        return self.plane(cloud, self.weights(cloud, weights), projection, report)

    def _constrained(self, cloud: Cloud, positions: NDArray[Any], given: CloudConstraints, settings: Any) -> Any:
        if self._engine == ENGINES["cuda"]:
            raise ValueError("the CUDA engine was asked for, but constraints are the CPU's")
        arguments = positions, given.ends, given.sides, given.by_direction, None, settings
        found = cloud.engine(given.engine, _core.constrained_triangulation, *arguments)
        given.warn_if_none(found)
        return found.inside()

    def joined(
        self, block: Block, lines: Any, given: Lines, polygon_rule: PolygonRule, report: Report
    ) -> Any:
        """With lines that have points of their own, by x and y."""
        cloud = self.cloud(block)
        part = self.parts(cloud, report)
        found = cloud.engine(joined_triangulation, cloud.array, given, polygon_rule, cloud.left_out, part)
        return mesh_of(cloud, found, lines, self.pass_data)

    def terrain(
        self,
        block: Block,
        heights: Weights,
        constraints: Constraints | None,
        lines: tuple[Any, Lines] | None,
        limits: tuple[float, int],
        report: Report,
        rest: bool,
    ) -> list[Any]:
        cloud = self.cloud(block)
        levels = self.weights(cloud, heights, "height")
        if levels is None and cloud.array.shape[1] == 2:
            raise ValueError("points of two coordinates take heights")
        joined: JoinedTriangulation | None = None
        if lines is None:
            given = CloudConstraints(constraints or Constraints(None, None), cloud, True)
            arguments = cloud.array, levels, given.ends, *limits, self.settings(cloud, report)
            found, _ = cloud.engine(given.engine, _core.terrain_mesh, *arguments)
        else:
            part = self.parts(cloud, report)
            mesh = cloud.engine(mesh_with_lines, cloud.array, levels, lines[1], limits, cloud.left_out, part)
            found, joined = vars(mesh), mesh.joined

        def points_of(rows: Ids) -> Any:
            if joined is None or lines is None:
                return cloud.mesh(cloud.ids(rows), self.pass_data)
            return points_of_mesh(cloud, joined, rows, lines[0], self.pass_data)

        return meshes_of_terrain(found, points_of, rest)

    def diagram(
        self, block: Block, weights: Weights, projection: Projection, domain: Domain, report: Report
    ) -> Any:
        first, second = split(report, TRIANGULATED)
        plane = self._plane_of(block, weights, projection, first)
        return self.mesh_of_power_cells(plane, self.power_cells(plane, domain, second))

    def power_cells(self, plane: Plane, domain: Domain, report: Report) -> Any:
        cloud, core = plane.cloud, plane.triangulated().core
        self.core = core
        within = None if core.dimension < 0 else domain.array
        arguments = plane.positions, plane.weights, core, within, self._settings(cloud, report)
        with domain.named():
            found = cloud.engine(_core.power_diagram, *arguments)
        plane.projection.lie_beneath(cloud.array, core)
        return found

    def mesh_of_power_cells(self, plane: Plane, found: Any) -> Any:
        made = vtk.vtkPolyData()
        made.SetPoints(vtk.points_of(plane.projection.to_space(found.vertices()), False))
        set_cells(made, 2, 0, found.offsets(), found.connectivity())
        plane.cloud.pass_data(plane.cloud.ids(found.sites()), made, "cell", self.pass_data)
        return made

    def settings(self, cloud: Cloud, report: Report) -> Any:
        """Of a run that makes cells: it holds the engine that was used."""
        self._last = self._settings(cloud, report)
        return self._last

    def parts(self, cloud: Cloud, report: Report) -> Callable[[float, float], Any]:
        """The settings of a part of the run, by its begin and its end from 0 to 1."""
        return lambda begin, end: self.settings(cloud, stretch(report, begin, end))

    def _settings(self, cloud: Cloud, report: Report, engine: int | None = None) -> Any:
        chosen = self._engine if engine is None else engine
        made = _core.Settings(self._threads, self._polygons, cloud.left_out, chosen, report)
        made.v_biased = self.v_biased
        if self.cuda_from is not None:
            made.cuda_from = self.cuda_from
        return made

    def cells_of(self, cloud: Cloud, core: Any) -> Any:
        """A mesh of the points and the cells."""
        self.core = core
        made = cloud.mesh(cloud.ids(core.vertices()), self.pass_data)
        size = core.cell_size
        set_cells(made, core.dimension, size, None if size else core.offsets(), core.connectivity())
        return made


def each_block(
    data: Any,
    make: Callable[[Block, Report], list[Any]],
    count: int,
    progress: Progress,
    leaves: tuple[str, ...] = LEAVES,
) -> list[Output]:
    """What is made of each block: so many meshes, or composites of them.

    If some blocks are at fault, the error of the first one is raised in the end: see errors_of().
    """
    made: list[list[Any]] = []
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
