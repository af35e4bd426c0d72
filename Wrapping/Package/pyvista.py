# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Exact convex hulls, regular triangulations and power diagrams of PyVista's meshes.

    import pyvista as pv
    from vtkflipflop.pyvista import convex_hull

    hull = convex_hull(pv.examples.download_bunny())

PyVista 0.48 and later offer the same as methods of a mesh, without an import: mesh.flipflop.convex_hull().

A mesh is any data set or composite of PyVista's, a VTK object that pyvista.wrap takes, or an array or list of n by 3 or
n by 2 coordinates, as vtkflipflop.arrays takes them: no number is rounded, masked points are left out. The functions
run on whatever VTK PyVista runs on, and give what the VTK filters of this package give, bit for bit: points of the
input in their own type, its point data, and "vtkOriginalPointIds". A composite gives a composite of the same structure.

Of a composite's blocks, those at fault have no result, and the others have theirs: the error that is raised has these
as its attribute result, and the exceptions of the blocks, by flat index, as errors.

Errors are those of vtkflipflop.arrays: InputError and others. FilterError is another name of FlipFlopError, from which
all are derived. An argument of the wrong type is a TypeError; an unknown choice is a ValueError that lists the choices.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any, Concatenate, Literal, ParamSpec, TypeVar, overload

import pyvista as pv
from numpy.typing import ArrayLike

from ._alpha import alpha_of
from ._arguments import Weights, choice_of, flag_of, length_of, numbers_of, weights_of_call
from ._domain import domain_of_call
from ._errors import AbortedError, DeviceError, FlipFlopError, InputError, OutOfMemoryError
from ._constraints import PolygonRule
from ._geometries import Degenerate
from ._mesh_constrained import constrained_triangulation
from ._mesh_constraints import constraints_of_call, count_degenerate
from ._mesh_image import to_image
from ._mesh_lines import breaklines_of_call
from ._mesh_refinement import refined_mesh
from ._mesh_runs import Run
from ._mesh_transport import centroidal_cells, prescribed_areas
from ._meshes import Block, add_block_index, blocks_of, is_tree, pass_field_data
from ._projection import projection_of
from ._pyvista import Output, data_of, dressed, each_block
from ._results import Progress, Report, report_of
from ._terrain import limits_of

__all__ = [
    "AbortedError",
    "DeviceError",
    "FilterError",
    "FlipFlopError",
    "InputError",
    "OutOfMemoryError",
    "centroidal_cells",
    "constrained_triangulation",
    "convex_hull",
    "convexify",
    "power_diagram",
    "prescribed_areas",
    "refined_mesh",
    "regular_triangulation",
    "terrain_mesh",
    "to_image",
]

FilterError = FlipFlopError
"""Another name of FlipFlopError, the base of all errors that are not about an argument's type or choice."""

Facets = Literal["triangles", "polygons"]
CompositeMode = Literal["each_block", "all_blocks"]
NonFinite = Literal["error", "ignore"]
Engine = Literal["automatic", "cpu", "cuda"]
ProjectionPlaneMode = Literal["xy_plane", "best_fitting_plane", "transform"]
Mesh = pv.DataSet | pv.MultiBlock | pv.PartitionedDataSet | ArrayLike


def convex_hull(
    mesh: Mesh,
    *,
    facets: Facets = "triangles",
    composite_mode: CompositeMode = "each_block",
    threads: int = 0,
    non_finite: NonFinite = "error",
    engine: Engine = "automatic",
    skip_ghost_points: bool = True,
    pass_point_data: bool = True,
    progress: Progress = None,
) -> Output:
    """The exact convex hull of a mesh's points.

    Parameters
    ----------
    mesh : data set, composite, or n by 3 or n by 2 coordinates
        its cells do not matter
    composite_mode : {"each_block", "all_blocks"}
        of a composite, a hull of each block, or one hull of the points of all blocks. The latter's ids count the points
        of all blocks in order, and the point array "BlockIndex" has the flat index of each point's block.
    facets : {"triangles", "polygons"}
        a flat facet of more than three corners is a fan of triangles, or one polygon
    threads : int
        0: as many as the machine has. The result never depends on it.
    non_finite : {"error", "ignore"}
        what NaN and infinity lead to: an InputError, or that these points are left out
    engine : {"automatic", "cpu", "cuda"}
        who does the work. The result is the same.
    skip_ghost_points : bool
        leave out points that "vtkGhostType" marks as another piece's or as blanked
    pass_point_data : bool
        whether the input's point data is passed
    progress : callable, bool or None
        called with the fraction that is done, 0 to 1, now and then; if it returns False, the call ends with an
        AbortedError. True shows tqdm's bar.

    Returns
    -------
    pyvista.PolyData
        closed, with facets facing outwards; of points that span less than space, one polygon, line or vertex. Or a
        composite of these.

    Raises
    ------
    InputError
        names the first point at fault, its block, and how many there are
    """
    run = Run(facets, threads, non_finite, engine, skip_ghost_points, pass_point_data)
    together = choice_of("composite_mode", composite_mode, ("each_block", "all_blocks")) == "all_blocks"
    data = data_of(mesh)
    if not (together and is_tree(data)):
        return each_block(data, lambda block, report: [run.hull([block], report)], 1, progress)[0]
    with report_of(progress) as report:
        blocks = [block.checked() for block in blocks_of(data) if block is not None]
        hull = run.hull(blocks, report)
    add_block_index(hull, blocks)
    pass_field_data(data, hull)
    return dressed(hull, data)


def convexify(
    surface: Mesh,
    kernel: ArrayLike | None = None,
    *,
    facets: Facets = "triangles",
    threads: int = 0,
    pass_point_data: bool = True,
    progress: Progress = None,
) -> Output:
    """The convex hull of a closed star-shaped surface, reached by flips alone.

    Parameters
    ----------
    surface : PolyData, or composite of such
        triangles, polygons and strips that form a closed, consistently oriented manifold, outward or inward. Polygons
        are cut into triangles, exactly, concave ones too. Points that no cell uses are no part of it.
    kernel : 3 numbers, optional
        a point that strictly sees the inside of every triangle; by default it is sought
    facets : {"triangles", "polygons"}
        a flat facet of more than three corners is a fan of triangles, or one polygon
    threads : int
        0: as many as the machine has. The result never depends on it.
    pass_point_data : bool
        whether the input's point data is passed
    progress : callable, bool or None
        called with the fraction that is done, 0 to 1, now and then; if it returns False, the call ends with an
        AbortedError. True shows tqdm's bar.

    Returns
    -------
    pyvista.PolyData, or a composite of these

    Raises
    ------
    InputError
        the surface is open, not of polygons, not a manifold, not oriented or not star-shaped; names the first cell
    """
    run = Run(facets, threads, "error", "cpu", False, pass_point_data)
    point = None if kernel is None else numbers_of("kernel", kernel, 3)
    data = data_of(surface)
    if not hasattr(data, "IsA") or not (is_tree(data) or data.IsA("vtkPolyData")):
        raise TypeError(f"{type(surface).__name__} is no surface: a PolyData is wanted")

    def convexified(block: Block, report: Report) -> list[Any]:
        return [run.convexified(block, point, report)]

    return each_block(data, convexified, 1, progress, ("vtkPolyData",))[0]


@overload
def regular_triangulation(
    mesh: Mesh,
    weights: ArrayLike | str | None = ...,
    *,
    radii: ArrayLike | str | None = ...,
    weight_factor: float = ...,
    constraints: Any = ...,
    polygon_rule: PolygonRule = ...,
    degenerate: Degenerate = ...,
    alpha: float | None = ...,
    maximum_edge_length: float | None = ...,
    facets: Facets = ...,
    projection_plane_mode: ProjectionPlaneMode = ...,
    transform: Any = ...,
    return_hidden_points: Literal[False] = ...,
    threads: int = ...,
    non_finite: NonFinite = ...,
    engine: Engine = ...,
    skip_ghost_points: bool = ...,
    pass_point_data: bool = ...,
    progress: Progress = ...,
) -> Output: ...


@overload
def regular_triangulation(
    mesh: Mesh,
    weights: ArrayLike | str | None = ...,
    *,
    radii: ArrayLike | str | None = ...,
    weight_factor: float = ...,
    constraints: Any = ...,
    polygon_rule: PolygonRule = ...,
    degenerate: Degenerate = ...,
    alpha: float | None = ...,
    maximum_edge_length: float | None = ...,
    facets: Facets = ...,
    projection_plane_mode: ProjectionPlaneMode = ...,
    transform: Any = ...,
    return_hidden_points: Literal[True],
    threads: int = ...,
    non_finite: NonFinite = ...,
    engine: Engine = ...,
    skip_ghost_points: bool = ...,
    pass_point_data: bool = ...,
    progress: Progress = ...,
) -> tuple[Output, Output]: ...


def regular_triangulation(
    mesh: Mesh,
    weights: ArrayLike | str | None = None,
    *,
    radii: ArrayLike | str | None = None,
    weight_factor: float = 1.0,
    constraints: Any = None,
    polygon_rule: PolygonRule = "even-odd",
    degenerate: Degenerate = "error",
    alpha: float | None = None,
    maximum_edge_length: float | None = None,
    facets: Facets = "triangles",
    projection_plane_mode: ProjectionPlaneMode = "xy_plane",
    transform: Any = None,
    return_hidden_points: bool = False,
    threads: int = 0,
    non_finite: NonFinite = "error",
    engine: Engine = "automatic",
    skip_ghost_points: bool = True,
    pass_point_data: bool = True,
    progress: Progress = None,
) -> Output | tuple[Output, Output]:
    """The exact regular (weighted Delaunay) triangulation of a mesh's points in a plane.

    Parameters
    ----------
    mesh : data set, composite, or n by 3 or n by 2 coordinates
        its cells do not matter
    weights : str or n numbers, optional
        a point array's name, or numbers if mesh is no composite: squared lengths. By default none: Delaunay.
    radii : str or n numbers, optional
        the same for the radii of disks, instead of weights: a weight is the square of weight_factor * radius
    weight_factor : float
        by which weights, or radii, are multiplied. Products and squares are rounded to double; with 1, weights are not.
    constraints : PolyData, or sequences of ids, optional
        lines and polygons, by the ids of the mesh's points, that are to be edges: the constrained Delaunay
        triangulation. If it has points, they are the mesh's at these ids (x and y alone in the xy plane). Or m by 2
        ids, or polylines of ids. With constraints there are no weights, and the mesh is no composite.
    polygon_rule : {"even-odd", "direction"}
        what is inside the polygons of constraints; cells outside are left out, and a warning says so if that is all.
        By nesting: a polygon keeps its inside, one in it is a hole, whatever their directions. Or by direction, as VTK
        has it: what is on the left of a side; holes run clockwise.
    degenerate : {"error", "ignore"}
        what lines of fewer than two ids and polygons of fewer than three lead to: an error, or that they are left out;
        the field data "DegenerateLines" then counts them
    alpha : float, optional
        leave out cells whose circumcircle has a larger radius, compared exactly: the triangles of alpha_complex() of
        vtkflipflop.arrays, which explains alpha with weights. By default, and at 0, none. All points stay.
    maximum_edge_length : float, optional
        leave out cells with a longer edge, measured in the plane and compared exactly. By default, and at 0, none. All
        points stay. A polygon is judged by its border, a triangle of its fan by its own edges.
    projection_plane_mode : {"xy_plane", "best_fitting_plane", "transform"}
        where points are triangulated: by x and y as they are; in the plane with the least sum of squared distances; or
        by x and y after the transform. The result's points are where they were.
    transform : 4 by 4 numbers, or what has them as its attribute matrix
        takes the points to the xy plane; given, it is used
    return_hidden_points : bool
        also return the points that do not appear in the triangulation
    facets : {"triangles", "polygons"}
        a flat facet of more than three corners is a fan of triangles, or one polygon
    threads : int
        0: as many as the machine has. The result never depends on it.
    non_finite : {"error", "ignore"}
        what NaN and infinity lead to: an InputError, or that these points are left out
    engine : {"automatic", "cpu", "cuda"}
        who does the work. The result is the same.
    skip_ghost_points : bool
        leave out points that "vtkGhostType" marks as another piece's or as blanked
    pass_point_data : bool
        whether the input's point data is passed
    progress : callable, bool or None
        called with the fraction that is done, 0 to 1, now and then; if it returns False, the call ends with an
        AbortedError. True shows tqdm's bar.

    Returns
    -------
    pyvista.PolyData, or a pair of them
        the triangulation, and the hidden points as vertices. Or composites of these.

    Raises
    ------
    InputError
        names the first point at fault, its block, and how many there are; or the weights' array; or constraints that
        cross between points, or end at a point that is not there
    """
    run = Run(facets, threads, non_finite, engine, skip_ghost_points, pass_point_data)
    projection = projection_of(projection_plane_mode, transform)
    both = flag_of("return_hidden_points", return_hidden_points)
    limit = None if maximum_edge_length is None else length_of("maximum_edge_length", maximum_edge_length) or None
    radius = None if alpha is None else alpha_of(alpha) or None
    data = data_of(mesh)
    weighting = weights_of_call(weights, radii, weight_factor, is_tree(data))
    given = constraints_of_call(constraints, polygon_rule, is_tree(data), weighting.values is not None, degenerate)

    def triangulated(block: Block, report: Report) -> list[Any]:
        return run.triangulation(block, weighting, given, projection, radius, limit, report, both)

    outputs = each_block(data, triangulated, 2 if both else 1, progress)
    count_degenerate(outputs[0], given, degenerate)
    return (outputs[0], outputs[1]) if both else outputs[0]


def power_diagram(
    mesh: Mesh,
    weights: ArrayLike | str | None = None,
    *,
    radii: ArrayLike | str | None = None,
    weight_factor: float = 1.0,
    box: ArrayLike | None = None,
    domain: Any = None,
    bounds: ArrayLike | None = None,
    projection_plane_mode: ProjectionPlaneMode = "xy_plane",
    transform: Any = None,
    threads: int = 0,
    non_finite: NonFinite = "error",
    engine: Engine = "automatic",
    skip_ghost_points: bool = True,
    pass_point_data: bool = True,
    progress: Progress = None,
) -> Output:
    """The power diagram of a mesh's points in a plane: a polygon for each cell; without weights, the Voronoi diagram.

    Parameters
    ----------
    mesh : data set, composite, or n by 3 or n by 2 coordinates
        its cells do not matter
    weights : str or n numbers, optional
        a point array's name, or numbers if mesh is no composite: squared lengths. By default none: Voronoi.
    radii : str or n numbers, optional
    weight_factor : float
        as for regular_triangulation()
    box : 2 corners, or 4 numbers, optional
        where cells are cut, in the plane: ((x0, y0), (x1, y1)), or in VTK's order (x0, x1, y0, y1). By default the box
        of the points.
    domain : m by 2, or a polygon, optional
        instead of a box the corners of a convex polygon, or shapely's
    bounds : 4 numbers, optional
        instead (x0, y0, x1, y1), as shapely's bounds and GeoPandas's total_bounds
    projection_plane_mode : {"xy_plane", "best_fitting_plane", "transform"}
    transform : 4 by 4 numbers, or what has them as its attribute matrix
        as for regular_triangulation(). Corners lie at the lowest z of the points, in the fitted plane, or where the
        inverse transform takes z = 0.
    threads : int
        0: as many as the machine has. The result never depends on it.
    non_finite : {"error", "ignore"}
        what NaN and infinity lead to: an InputError, or that these points are left out
    engine : {"automatic", "cpu", "cuda"}
        who does the work. The result is the same.
    skip_ghost_points : bool
        leave out points that "vtkGhostType" marks as another piece's or as blanked
    pass_point_data : bool
        whether the input's point data is passed
    progress : callable, bool or None
        called with the fraction that is done, 0 to 1, now and then; if it returns False, the call ends with an
        AbortedError. True shows tqdm's bar.

    Returns
    -------
    pyvista.PolyData
        with the points' data as cell data. Or a composite of these.
    """
    run = Run("polygons", threads, non_finite, engine, skip_ghost_points, pass_point_data)
    projection = projection_of(projection_plane_mode, transform)
    within = domain_of_call(domain, bounds, box)
    data = data_of(mesh)
    weighting = weights_of_call(weights, radii, weight_factor, is_tree(data))

    def divided(block: Block, report: Report) -> list[Any]:
        return [run.diagram(block, weighting, projection, within, report)]

    return each_block(data, divided, 1, progress)[0]


@overload
def terrain_mesh(
    mesh: Mesh,
    heights: ArrayLike | str | None = None,
    *,
    tolerance: float = 0.0,
    max_vertices: int | None = None,
    constraints: Any = None,
    lines: Any = None,
    return_hidden_points: Literal[False] = False,
    threads: int = 0,
    non_finite: NonFinite = "error",
    degenerate: Degenerate = "error",
    skip_ghost_points: bool = True,
    pass_point_data: bool = True,
    progress: Progress = None,
) -> Output: ...


@overload
def terrain_mesh(
    mesh: Mesh,
    heights: ArrayLike | str | None = None,
    *,
    tolerance: float = 0.0,
    max_vertices: int | None = None,
    constraints: Any = None,
    lines: Any = None,
    return_hidden_points: Literal[True],
    threads: int = 0,
    non_finite: NonFinite = "error",
    degenerate: Degenerate = "error",
    skip_ghost_points: bool = True,
    pass_point_data: bool = True,
    progress: Progress = None,
) -> tuple[Output, Output]: ...


def terrain_mesh(
    mesh: Mesh,
    heights: ArrayLike | str | None = None,
    *,
    tolerance: float = 0.0,
    max_vertices: int | None = None,
    constraints: Any = None,
    lines: Any = None,
    return_hidden_points: bool = False,
    threads: int = 0,
    non_finite: NonFinite = "error",
    degenerate: Degenerate = "error",
    skip_ghost_points: bool = True,
    pass_point_data: bool = True,
    progress: Progress = None,
) -> Output | tuple[Output, Output]:
    """A mesh of some of a terrain's points, from which no other point is farther, vertically, than the tolerance.

    That is decided exactly. terrain_mesh() of vtkflipflop.arrays explains how points are chosen.

    Parameters
    ----------
    mesh : data set, composite, or n by 3 or n by 2 coordinates
        its cells do not matter; triangulated by x and y
    heights : str or n numbers, optional
        a point array's name, or numbers if mesh is no composite. By default z.
    tolerance : float
        the greatest vertical distance, 0 or more, in the unit of heights. By default 0, where that of
        vtkFFTerrainMeshFilter is a hundredth of the heights' range.
    max_vertices : int, optional
        no point is inserted once there are so many. By default there is no limit.
    constraints : PolyData, or sequences of ids, optional
        breaklines, as regular_triangulation() takes them: edges of the mesh. Of polygons, only the sides count.
    lines : PolyData, or geometries, optional
        instead, breaklines with points of their own, as constrained_triangulation() takes them; all heights are z then
    return_hidden_points : bool
        also return the points that are not in the mesh, with the point array "TerrainError": how far each is above it
    threads, non_finite, skip_ghost_points, pass_point_data, progress
        as for regular_triangulation(); a height that is not finite is like such a coordinate
    degenerate : {"error", "ignore"}
        as regular_triangulation() has it for constraints, and constrained_triangulation() for lines

    Returns
    -------
    pyvista.PolyData, or a pair of them
        the mesh, and the other points as vertices; with lines, both have the point arrays "PointOrigin" and
        "HeightRange" of constrained_triangulation(). Or composites of these.

    Raises
    ------
    InputError
        names the first point at fault, its block, and how many there are; or the heights' array; or constraints that
        cross between points, or end at a point that is not there
    """
    run = Run("triangles", threads, non_finite, "cpu", skip_ghost_points, pass_point_data)
    both = flag_of("return_hidden_points", return_hidden_points)
    limits = limits_of(tolerance, max_vertices)
    data = data_of(mesh)
    if heights is not None and not isinstance(heights, str) and is_tree(data):
        raise TypeError("the heights of a composite are the name of a point array")
    levels = Weights(heights, False, 1.0)
    given = constraints_of_call(constraints, "even-odd", is_tree(data), False, degenerate)
    own = breaklines_of_call(lines, constraints, heights, is_tree(data), degenerate)

    def meshed(block: Block, report: Report) -> list[Any]:
        return run.terrain(block, levels, given, own, limits, report, both)

    outputs = each_block(data, meshed, 2 if both else 1, progress)
    count_degenerate(outputs[0], given if own is None else own[1], degenerate)
    return (outputs[0], outputs[1]) if both else outputs[0]


P = ParamSpec("P")
R = TypeVar("R")


def _method(function: Callable[Concatenate[Any, P], R]) -> Callable[Concatenate[Accessor, P], R]:
    """The function as a method of what has the mesh."""

    @functools.wraps(function)
    def method(self: Accessor, /, *args: P.args, **kwargs: P.kwargs) -> R:
        return function(self._mesh, *args, **kwargs)

    return method


class Accessor:
    """The functions of vtkflipflop.pyvista as methods of a mesh: mesh.flipflop.convex_hull()."""

    def __init__(self, mesh: Any) -> None:
        self._mesh = mesh

    centroidal_cells = _method(centroidal_cells)
    constrained_triangulation = _method(constrained_triangulation)
    convex_hull = _method(convex_hull)
    convexify = _method(convexify)
    power_diagram = _method(power_diagram)
    prescribed_areas = _method(prescribed_areas)
    refined_mesh = _method(refined_mesh)
    regular_triangulation = _method(regular_triangulation)
    terrain_mesh = _method(terrain_mesh)
    to_image = _method(to_image)


if hasattr(pv, "register_dataset_accessor"):  # since 0.48
    pv.register_dataset_accessor("flipflop", pv.DataObject)(Accessor)
