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

Errors are those of vtkflipflop.arrays: InputError and others. FilterError is another name of FlipFlopError, from which
all are derived. An argument of the wrong type is a TypeError; an unknown choice is a ValueError that lists the choices.
"""

from __future__ import annotations

from typing import Any, Literal, overload

import pyvista as pv
from numpy.typing import ArrayLike

from ._arguments import choice_of, flag_of, length_of, numbers_of, weights_of_call
from ._errors import AbortedError, DeviceError, FlipFlopError, InputError, OutOfMemoryError
from ._constraints import PolygonRule
from ._mesh_constraints import constraints_of_call
from ._mesh_runs import Output, Report, Run, bar_of, each_block
from ._mesh_transport import centroidal_cells, prescribed_areas
from ._meshes import Block, blocks_of, data_of, is_partitioned, is_tree, pass_field_data
from ._projection import projection_of

__all__ = [
    "AbortedError",
    "DeviceError",
    "FilterError",
    "FlipFlopError",
    "InputError",
    "OutOfMemoryError",
    "centroidal_cells",
    "convex_hull",
    "convexify",
    "power_diagram",
    "prescribed_areas",
    "regular_triangulation",
]

FilterError = FlipFlopError
"""Another name of FlipFlopError, the base of all errors that are not about an argument's type or choice."""

FacetMode = Literal["triangles", "polygons"]
CompositeMode = Literal["each_block", "all_blocks"]
NonFinitePoints = Literal["error", "ignore"]
Engine = Literal["automatic", "cpu", "cuda"]
ProjectionPlaneMode = Literal["xy_plane", "best_fitting_plane", "transform"]
Mesh = pv.DataSet | pv.MultiBlock | pv.PartitionedDataSet | ArrayLike


def convex_hull(
    mesh: Mesh,
    *,
    facet_mode: FacetMode = "triangles",
    composite_mode: CompositeMode = "each_block",
    number_of_threads: int = 0,
    non_finite_points: NonFinitePoints = "error",
    engine: Engine = "automatic",
    skip_ghost_points: bool = True,
    pass_point_data: bool = True,
    progress_bar: bool = False,
) -> Output:
    """The exact convex hull of a mesh's points.

    Parameters
    ----------
    mesh : data set, composite, or n by 3 or n by 2 coordinates
        its cells do not matter
    composite_mode : {"each_block", "all_blocks"}
        of a composite, a hull of each block, or one hull of the points of all blocks. The latter's ids count the points
        of all blocks in order, and the point array "BlockIndex" has the flat index of each point's block.
    facet_mode : {"triangles", "polygons"}
        a flat facet of more than three corners is a fan of triangles, or one polygon
    number_of_threads : int
        0: as many as the machine has. The result never depends on it.
    non_finite_points : {"error", "ignore"}
        what NaN and infinity lead to: an InputError, or that these points are left out
    engine : {"automatic", "cpu", "cuda"}
        who does the work. The result is the same.
    skip_ghost_points : bool
        leave out points that "vtkGhostType" marks as another piece's or as blanked
    pass_point_data : bool
        whether the input's point data is passed
    progress_bar : bool
        show progress in the terminal; needs tqdm

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
    run = Run(facet_mode, number_of_threads, non_finite_points, engine, skip_ghost_points, pass_point_data)
    together = choice_of("composite_mode", composite_mode, ("each_block", "all_blocks")) == "all_blocks"
    data = data_of(mesh)
    if not (together and is_tree(data)):
        return each_block(data, lambda block, report: [run.hull([block], report)], 1, progress_bar)[0]
    with bar_of(progress_bar) as report:
        blocks = [block for block in blocks_of(data) if block is not None]
        hull = run.hull(blocks, report)
    if not is_partitioned(data):
        hull.point_data.set_array(run.block_index, "BlockIndex")
    pass_field_data(data, hull)
    return hull


def convexify(
    surface: Mesh,
    kernel_point: ArrayLike | None = None,
    *,
    facet_mode: FacetMode = "triangles",
    number_of_threads: int = 0,
    pass_point_data: bool = True,
    progress_bar: bool = False,
) -> Output:
    """The convex hull of a closed star-shaped surface, reached by flips alone.

    Parameters
    ----------
    surface : PolyData, or composite of such
        triangles, polygons and strips that form a closed, consistently oriented manifold, outward or inward. Polygons
        are cut into triangles, exactly, concave ones too. Points that no cell uses are no part of it.
    kernel_point : 3 numbers, optional
        a point that strictly sees the inside of every triangle; by default it is sought
    facet_mode : {"triangles", "polygons"}
        a flat facet of more than three corners is a fan of triangles, or one polygon
    number_of_threads : int
        0: as many as the machine has. The result never depends on it.
    pass_point_data : bool
        whether the input's point data is passed
    progress_bar : bool
        show progress in the terminal; needs tqdm

    Returns
    -------
    pyvista.PolyData, or a composite of these

    Raises
    ------
    InputError
        the surface is open, not of polygons, not a manifold, not oriented or not star-shaped; names the first cell
    """
    run = Run(facet_mode, number_of_threads, "error", "cpu", False, pass_point_data)
    kernel = None if kernel_point is None else numbers_of("kernel_point", kernel_point, 3)
    data = data_of(surface)
    if not hasattr(data, "IsA") or not (is_tree(data) or data.IsA("vtkPolyData")):
        raise TypeError(f"{type(surface).__name__} is no surface: a PolyData is wanted")

    def convexified(block: Block, report: Report) -> list[pv.PolyData]:
        return [run.convexified(block, kernel, report)]

    return each_block(data, convexified, 1, progress_bar, ("vtkPolyData",))[0]


@overload
def regular_triangulation(
    mesh: Mesh,
    weights: ArrayLike | str | None = ...,
    *,
    radii: ArrayLike | str | None = ...,
    weight_factor: float = ...,
    constraints: Any = ...,
    polygon_rule: PolygonRule = ...,
    alpha: float = ...,
    maximum_edge_length: float = ...,
    facet_mode: FacetMode = ...,
    projection_plane_mode: ProjectionPlaneMode = ...,
    transform: Any = ...,
    return_hidden_points: Literal[False] = ...,
    number_of_threads: int = ...,
    non_finite_points: NonFinitePoints = ...,
    engine: Engine = ...,
    skip_ghost_points: bool = ...,
    pass_point_data: bool = ...,
    progress_bar: bool = ...,
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
    alpha: float = ...,
    maximum_edge_length: float = ...,
    facet_mode: FacetMode = ...,
    projection_plane_mode: ProjectionPlaneMode = ...,
    transform: Any = ...,
    return_hidden_points: Literal[True],
    number_of_threads: int = ...,
    non_finite_points: NonFinitePoints = ...,
    engine: Engine = ...,
    skip_ghost_points: bool = ...,
    pass_point_data: bool = ...,
    progress_bar: bool = ...,
) -> tuple[Output, Output]: ...


def regular_triangulation(
    mesh: Mesh,
    weights: ArrayLike | str | None = None,
    *,
    radii: ArrayLike | str | None = None,
    weight_factor: float = 1.0,
    constraints: Any = None,
    polygon_rule: PolygonRule = "even-odd",
    alpha: float = 0.0,
    maximum_edge_length: float = 0.0,
    facet_mode: FacetMode = "triangles",
    projection_plane_mode: ProjectionPlaneMode = "xy_plane",
    transform: Any = None,
    return_hidden_points: bool = False,
    number_of_threads: int = 0,
    non_finite_points: NonFinitePoints = "error",
    engine: Engine = "automatic",
    skip_ghost_points: bool = True,
    pass_point_data: bool = True,
    progress_bar: bool = False,
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
        triangulation. If it has points, they are the mesh's at these ids (x and y alone in the xy plane). Or m by 2 ids,
        or polylines of ids. With constraints there are no weights, and the mesh is no composite.
    polygon_rule : {"even-odd", "direction"}
        what is inside the polygons of constraints; cells outside are left out, and a warning says so if that is all.
        By nesting: a polygon keeps its inside, one in it is a hole, whatever their directions. Or by direction, as VTK
        has it: what is on the left of a side; holes run clockwise.
    alpha : float
        leave out cells whose circumcircle has a larger radius, compared exactly; by default, 0, none. With weights, it
        is the circle of power distance 0 from the corners. All points stay.
    maximum_edge_length : float
        leave out cells with a longer edge, measured in the plane and compared exactly; by default, 0, none. All points
        stay. A polygon is judged by its border, a triangle of its fan by its own edges.
    projection_plane_mode : {"xy_plane", "best_fitting_plane", "transform"}
        where points are triangulated: by x and y as they are; in the plane with the least sum of squared distances; or
        by x and y after the transform. The result's points are where they were.
    transform : 4 by 4 numbers, or what has them as its attribute matrix
        takes the points to the xy plane; given, it is used
    return_hidden_points : bool
        also return the points that do not appear in the triangulation
    facet_mode : {"triangles", "polygons"}
        a flat facet of more than three corners is a fan of triangles, or one polygon
    number_of_threads : int
        0: as many as the machine has. The result never depends on it.
    non_finite_points : {"error", "ignore"}
        what NaN and infinity lead to: an InputError, or that these points are left out
    engine : {"automatic", "cpu", "cuda"}
        who does the work. The result is the same.
    skip_ghost_points : bool
        leave out points that "vtkGhostType" marks as another piece's or as blanked
    pass_point_data : bool
        whether the input's point data is passed
    progress_bar : bool
        show progress in the terminal; needs tqdm

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
    run = Run(facet_mode, number_of_threads, non_finite_points, engine, skip_ghost_points, pass_point_data)
    projection = projection_of(projection_plane_mode, transform)
    both = flag_of("return_hidden_points", return_hidden_points)
    limit = length_of("maximum_edge_length", maximum_edge_length)
    radius = length_of("alpha", alpha)
    data = data_of(mesh)
    heavy = weights_of_call(weights, radii, weight_factor, is_tree(data))
    given = constraints_of_call(constraints, polygon_rule, is_tree(data), heavy.values is not None)

    def triangulated(block: Block, report: Report) -> list[pv.PolyData]:
        return run.triangulation(block, heavy, given, projection, radius, limit, report, both)

    outputs = each_block(data, triangulated, 2 if both else 1, progress_bar)
    return (outputs[0], outputs[1]) if both else outputs[0]


def power_diagram(
    mesh: Mesh,
    weights: ArrayLike | str | None = None,
    *,
    radii: ArrayLike | str | None = None,
    weight_factor: float = 1.0,
    power_diagram_bounds: ArrayLike | None = None,
    projection_plane_mode: ProjectionPlaneMode = "xy_plane",
    transform: Any = None,
    number_of_threads: int = 0,
    non_finite_points: NonFinitePoints = "error",
    engine: Engine = "automatic",
    skip_ghost_points: bool = True,
    pass_point_data: bool = True,
    progress_bar: bool = False,
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
    power_diagram_bounds : 4 numbers, optional
        x least, x greatest, y least, y greatest in the plane: where cells are cut. By default the box of the points.
    projection_plane_mode : {"xy_plane", "best_fitting_plane", "transform"}
    transform : 4 by 4 numbers, or what has them as its attribute matrix
        as for regular_triangulation(). Corners lie at the lowest z of the points, in the fitted plane, or where the
        inverse transform takes z = 0.
    number_of_threads : int
        0: as many as the machine has. The result never depends on it.
    non_finite_points : {"error", "ignore"}
        what NaN and infinity lead to: an InputError, or that these points are left out
    engine : {"automatic", "cpu", "cuda"}
        who does the work. The result is the same.
    skip_ghost_points : bool
        leave out points that "vtkGhostType" marks as another piece's or as blanked
    pass_point_data : bool
        whether the input's point data is passed
    progress_bar : bool
        show progress in the terminal; needs tqdm

    Returns
    -------
    pyvista.PolyData
        with the points' data as cell data. Or a composite of these.
    """
    run = Run("polygons", number_of_threads, non_finite_points, engine, skip_ghost_points, pass_point_data)
    projection = projection_of(projection_plane_mode, transform)
    box = None if power_diagram_bounds is None else numbers_of("power_diagram_bounds", power_diagram_bounds, 4)
    if box is not None and not (box[0] < box[1] and box[2] < box[3]):
        raise ValueError(f"power_diagram_bounds have no inside: x least, x greatest, y least, y greatest is {box}")
    data = data_of(mesh)
    heavy = weights_of_call(weights, radii, weight_factor, is_tree(data))

    def divided(block: Block, report: Report) -> list[pv.PolyData]:
        return [run.diagram(block, heavy, projection, box, report)]

    return each_block(data, divided, 1, progress_bar)[0]


class Accessor:
    """The functions of vtkflipflop.pyvista as methods of a mesh: mesh.flipflop.convex_hull()."""

    def __init__(self, mesh: Any) -> None:
        self._mesh = mesh

    def convex_hull(
        self,
        *,
        facet_mode: FacetMode = "triangles",
        composite_mode: CompositeMode = "each_block",
        number_of_threads: int = 0,
        non_finite_points: NonFinitePoints = "error",
        engine: Engine = "automatic",
        skip_ghost_points: bool = True,
        pass_point_data: bool = True,
        progress_bar: bool = False,
    ) -> Output:
        return convex_hull(
            self._mesh,
            facet_mode=facet_mode,
            composite_mode=composite_mode,
            number_of_threads=number_of_threads,
            non_finite_points=non_finite_points,
            engine=engine,
            skip_ghost_points=skip_ghost_points,
            pass_point_data=pass_point_data,
            progress_bar=progress_bar,
        )

    def convexify(
        self,
        kernel_point: ArrayLike | None = None,
        *,
        facet_mode: FacetMode = "triangles",
        number_of_threads: int = 0,
        pass_point_data: bool = True,
        progress_bar: bool = False,
    ) -> Output:
        return convexify(
            self._mesh,
            kernel_point,
            facet_mode=facet_mode,
            number_of_threads=number_of_threads,
            pass_point_data=pass_point_data,
            progress_bar=progress_bar,
        )

    def regular_triangulation(
        self,
        weights: ArrayLike | str | None = None,
        *,
        radii: ArrayLike | str | None = None,
        weight_factor: float = 1.0,
        constraints: Any = None,
        polygon_rule: PolygonRule = "even-odd",
        alpha: float = 0.0,
        maximum_edge_length: float = 0.0,
        facet_mode: FacetMode = "triangles",
        projection_plane_mode: ProjectionPlaneMode = "xy_plane",
        transform: Any = None,
        return_hidden_points: bool = False,
        number_of_threads: int = 0,
        non_finite_points: NonFinitePoints = "error",
        engine: Engine = "automatic",
        skip_ghost_points: bool = True,
        pass_point_data: bool = True,
        progress_bar: bool = False,
    ) -> Any:
        function: Any = regular_triangulation  # with a flag that may be either, none of its two forms
        return function(
            self._mesh,
            weights,
            radii=radii,
            weight_factor=weight_factor,
            constraints=constraints,
            polygon_rule=polygon_rule,
            alpha=alpha,
            maximum_edge_length=maximum_edge_length,
            facet_mode=facet_mode,
            projection_plane_mode=projection_plane_mode,
            transform=transform,
            return_hidden_points=return_hidden_points,
            number_of_threads=number_of_threads,
            non_finite_points=non_finite_points,
            engine=engine,
            skip_ghost_points=skip_ghost_points,
            pass_point_data=pass_point_data,
            progress_bar=progress_bar,
        )

    def power_diagram(
        self,
        weights: ArrayLike | str | None = None,
        *,
        radii: ArrayLike | str | None = None,
        weight_factor: float = 1.0,
        power_diagram_bounds: ArrayLike | None = None,
        projection_plane_mode: ProjectionPlaneMode = "xy_plane",
        transform: Any = None,
        number_of_threads: int = 0,
        non_finite_points: NonFinitePoints = "error",
        engine: Engine = "automatic",
        skip_ghost_points: bool = True,
        pass_point_data: bool = True,
        progress_bar: bool = False,
    ) -> Output:
        return power_diagram(
            self._mesh,
            weights,
            radii=radii,
            weight_factor=weight_factor,
            power_diagram_bounds=power_diagram_bounds,
            projection_plane_mode=projection_plane_mode,
            transform=transform,
            number_of_threads=number_of_threads,
            non_finite_points=non_finite_points,
            engine=engine,
            skip_ghost_points=skip_ghost_points,
            pass_point_data=pass_point_data,
            progress_bar=progress_bar,
        )


    def centroidal_cells(
        self,
        weights: ArrayLike | str | None = None,
        *,
        domain: ArrayLike | None = None,
        iterations: int = 100,
        tolerance: float = 0.0,
        number_of_threads: int = 0,
        skip_ghost_points: bool = True,
        pass_point_data: bool = True,
        progress_bar: bool = False,
    ) -> Output:
        return centroidal_cells(
            self._mesh,
            weights,
            domain=domain,
            iterations=iterations,
            tolerance=tolerance,
            number_of_threads=number_of_threads,
            skip_ghost_points=skip_ghost_points,
            pass_point_data=pass_point_data,
            progress_bar=progress_bar,
        )

    def prescribed_areas(
        self,
        areas: ArrayLike | str | None = None,
        *,
        domain: ArrayLike | None = None,
        tolerance: float = 1e-6,
        iterations: int = 100,
        number_of_threads: int = 0,
        skip_ghost_points: bool = True,
        pass_point_data: bool = True,
        progress_bar: bool = False,
    ) -> Output:
        return prescribed_areas(
            self._mesh,
            areas,
            domain=domain,
            tolerance=tolerance,
            iterations=iterations,
            number_of_threads=number_of_threads,
            skip_ghost_points=skip_ghost_points,
            pass_point_data=pass_point_data,
            progress_bar=progress_bar,
        )


for _function in (centroidal_cells, convex_hull, convexify, regular_triangulation, power_diagram, prescribed_areas):
    getattr(Accessor, _function.__name__).__doc__ = _function.__doc__

if hasattr(pv, "register_dataset_accessor"):  # since 0.48
    pv.register_dataset_accessor("flipflop", pv.DataObject)(Accessor)
