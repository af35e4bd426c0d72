# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Refined meshes of PyVista's polygons and lines."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._areas import AreaFunction, limits_of, regions_of
from ._arguments import Weights, choice_of, flag_of, float_of, most_of
from ._constraints import PolygonRule
from ._errors import InputError, warn_caller
from ._filter_errors import ConstraintError
from ._mesh_refined import Refined
from ._mesh_runs import Run
from ._mesh_source import Advice, Source, SourceRule
from ._meshes import Block
from ._pyvista import Output, data_of, each_block
from ._refine import warn_of_angle
from ._results import NonFinite, Progress, Report

_INPUT_POINTS = 1
_ADVICE = Advice("pass split_crossings=True", "Pass skip_ghost_points=False", "pass polygon_rule='even-odd'")


def refined_mesh(
    mesh: Any,
    *,
    minimum_angle: float = 25.0,
    maximum_area: float | str | AreaFunction | None = None,
    regions: ArrayLike | None = None,
    maximum_points: int | None = None,
    polygon_rule: PolygonRule = "even-odd",
    closed_lines_as_borders: bool = False,
    split_crossings: bool = False,
    threads: int = 0,
    non_finite: NonFinite = "error",
    skip_ghost_points: bool = True,
    pass_point_data: bool = True,
    progress: Progress = None,
) -> Output:
    """A mesh for finite elements, by x and y, of a PolyData's polygons, lines and points.

    It covers what is inside the polygons; without polygons, what lines enclose; where they enclose nothing, the convex
    hull. refined_mesh() of vtkflipflop.arrays explains how points are added. Heights and point data of added points are
    interpolated: along their line or side, or over a triangle of the given points.

    Parameters
    ----------
    mesh : PolyData, or a composite of these
    minimum_angle : float
        in degrees, from 0 to 34; above 30 there is a warning, as maximum_points may end the refinement
    maximum_area : number, str or function, optional
        of a triangle; a point array's name; or what a function gives of positions, k by 2: k areas
    regions : r by 2, or r by 3, optional
        a point in each region, and the greatest area there, 0 for maximum_area
    maximum_points : int, optional
        no more are added; by default ten million
    polygon_rule : {"even-odd", "direction"}
        what is inside polygons: as for regular_triangulation()
    closed_lines_as_borders : bool
        whether lines that end where they begin, alone or joined end to end, are polygons
    split_crossings : bool
        whether lines and sides that cross between points are split there; otherwise they are an error
    threads, non_finite, skip_ghost_points, pass_point_data, progress
        as for regular_triangulation()

    Returns
    -------
    pyvista.PolyData
        triangles and their points, with the cell arrays "Region" (the row in regions, or -1), "MinimumAngle", in
        degrees, and "Area"; added points have -1 in "vtkOriginalPointIds". Or a composite of these.

    Raises
    ------
    InputError
        names the cells that cross, the point or the region at fault
    """
    run = Run("triangles", threads, non_finite, "cpu", skip_ghost_points, pass_point_data)
    least, most_points = float_of("minimum_angle", minimum_angle), most_of("maximum_points", maximum_points)
    by_direction = choice_of("polygon_rule", polygon_rule, ("even-odd", "direction")) == "direction"
    closed = flag_of("closed_lines_as_borders", closed_lines_as_borders)
    split = flag_of("split_crossings", split_crossings)
    sizes = maximum_area if isinstance(maximum_area, str) else None
    wanted: Any = maximum_area
    if not callable(wanted) and np.ndim(wanted) != 0:
        raise TypeError(f"maximum_area is a number, a point array's name or a function, not {maximum_area!r}")
    areas = limits_of(None if sizes is not None else maximum_area, [], None)
    limits, rows = (least, areas.everywhere, most_points), regions_of(regions, None)
    if rows.polygons:
        raise TypeError("regions are rows of 2 or 3 numbers")
    warn_of_angle(least)
    data = data_of(mesh)

    def meshed(block: Block, report: Report) -> list[Any]:
        part, cloud = block.checked().part, run.cloud(block)
        if part is None or part.mesh is None:
            raise TypeError("points have no polygons and lines: a PolyData is wanted")
        pieces = run.parts(cloud, report)
        rule = SourceRule(_INPUT_POINTS, 2, closed, False, True, "mesh", _ADVICE)
        source = Source(part.mesh, cloud, rule, pieces(0.0, 0.05))
        try:
            refined = Refined(cloud, part.mesh, source, split, pieces)
            numbers = None if sizes is None else run.weights(refined.cloud, Weights(sizes, False, 1.0), "size")
            given = None if numbers is None else np.ascontiguousarray(numbers, np.float64)
            found = refined.found(limits, rows.rows, given, by_direction, pieces(0.1, 1.0), areas.at)
        except ConstraintError as error:
            raise InputError(str(error), "bad_argument") from None
        except InputError as error:
            raise rows.of_error(error) from None
        if not found["is_complete"]:
            warn_caller("maximum_points ended the refinement: some triangles are still thin, or too large")
        return refined.meshes(run.pass_data)[:1]

    return each_block(data, meshed, 1, progress, ("vtkPolyData",))[0]
