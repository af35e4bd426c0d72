# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Triangulations of PyVista's meshes and lines that have points of their own."""

from __future__ import annotations

from typing import Any

import pyvista as pv

from ._arguments import flag_of
from ._constraints import PolygonRule
from ._geometries import Degenerate
from ._mesh_constraints import count_degenerate
from ._mesh_lines import lines_of_call
from ._mesh_runs import Run
from ._meshes import Block, is_tree
from ._pyvista import data_of, each_block
from ._results import Facets, NonFinite, Progress, Report


def constrained_triangulation(
    mesh: Any,
    lines: Any,
    *,
    closed_lines_as_borders: bool = False,
    polygon_rule: PolygonRule = "even-odd",
    facets: Facets = "triangles",
    threads: int = 0,
    non_finite: NonFinite = "error",
    degenerate: Degenerate = "error",
    skip_ghost_points: bool = True,
    pass_point_data: bool = True,
    progress: Progress = None,
) -> pv.PolyData:
    """The exact constrained Delaunay triangulation, in x and y, of a mesh's points and lines with points of their own.

    vtkflipflop.arrays.constrained_triangulation() says which points are added, and which z counts where several are
    given.

    Parameters
    ----------
    mesh : data set, or n by 3 or n by 2 coordinates
        its cells do not matter
    lines : PolyData, or geometries
        lines and polygons with their points, of a PolyData; or what vtkflipflop.arrays.constrained_triangulation()
        takes. Polygons are borders: cells outside are left out.
    closed_lines_as_borders : bool
        whether lines that end where they begin are polygons, alone or joined end to end: where exactly two ends are.
        Only the first is, of rings that run along the same segments all the way, as a cell and its outline do.
    polygon_rule : {"even-odd", "direction"}
        what is inside polygons, as for regular_triangulation(); of several geometries, their union
    facets : {"triangles", "polygons"}
        all points of one circle are a fan of triangles, or one polygon
    threads : int
        0: as many as the machine has. The result never depends on it.
    non_finite : {"error", "ignore"}
        what NaN and infinity of the mesh lead to: an InputError, or that these points are left out. Lines have to be
        finite.
    degenerate : {"error", "ignore"}
        what lines of one point, rings of one or two, empty and missing geometries lead to: an error, or that they are
        left out; the field data "DegenerateLines" then counts them
    skip_ghost_points : bool
        leave out points that "vtkGhostType" marks as another piece's or as blanked
    pass_point_data : bool
        whether point data is passed. Of added points it is that of the lines' array of the same name; NaN, or 0 of
        other types, if there is none; where lines cross, linear along the first, or that of its nearer end.
    progress : callable, bool or None
        called with the fraction that is done, 0 to 1, now and then; if it returns False, the call ends with an
        AbortedError. True shows tqdm's bar.

    Returns
    -------
    pyvista.PolyData
        with the point arrays "PointOrigin", which is 0 for points of the mesh, 1 for those of lines, 2 where lines
        cross; and "HeightRange", the lowest and the highest z that is given for each point, if lines have heights. In
        "vtkOriginalPointIds", added points have -1.
    """
    run = Run(facets, threads, non_finite, "cpu", skip_ghost_points, pass_point_data)
    data = data_of(mesh)
    if is_tree(data):
        raise TypeError("lines are for one data set, and the mesh is a composite")
    given = lines_of_call(lines, flag_of("closed_lines_as_borders", closed_lines_as_borders), degenerate)

    def triangulated(block: Block, report: Report) -> list[Any]:
        return [run.joined(block, lines, given, polygon_rule, report)]

    found: pv.PolyData = each_block(data, triangulated, 1, progress)[0]
    count_degenerate(found, given, degenerate)
    return found
