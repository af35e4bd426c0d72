# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Regular and constrained triangulations of arrays, and power diagrams."""

from __future__ import annotations

from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, ClassVar, Literal, overload

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _core
from ._alpha import AlphaComplex, alpha_of
from ._arguments import choice_of, float_of, length_of
from ._constraints import Chains, Constraints, PolygonRule, SplitConstraints
from ._device import memory_of
from ._domain import domain_of_call
from ._errors import InputError
from ._geometries import Degenerate
from ._image import METHODS, Image, Method, grid_of, image_of
from ._input import points_and_weights_of, points_of, values_of
from ._power_diagram import PowerDiagram
from ._queries import Lengths, Numbers, changed, interpolation_of, results_of, unchanged, with_ones
from ._results import (
    QUIET,
    Cells,
    Engine,
    Facets,
    Floats,
    Ids,
    NonFinite,
    Polygons,
    Progress,
    Validation,
    frozen,
    ignores,
    run,
    settings,
)

if TYPE_CHECKING:
    from ._constrained import ConstrainedTriangulation


class RegularTriangulation(Cells):
    """The exact regular (weighted Delaunay) triangulation of points in the plane.

    Ids are rows of the caller's array. A point that does not appear is in `hidden`. The form is the same for any
    number of threads and either engine, bit for bit. Names are those of scipy.spatial.Delaunay.

    Attributes
    ----------
    weights : ndarray or None
        the caller's weights, as the engine reads them
    """

    weights: NDArray[Any] | None
    _call: ClassVar[str] = "regular_triangulation(points)"

    @cached_property
    def vertices(self) -> Ids:
        """Ids of the points that appear, ascending."""
        return self._core.vertices()

    @cached_property
    def hidden(self) -> Ids:
        """Ids of the points that do not appear, ascending: duplicates, and points whose cell is empty."""
        return self._core.hidden()

    @cached_property
    def polygons(self) -> Polygons:
        """Facets as ids: all points of one power circle are one polygon."""
        core = self._core
        if core.cell_size == 3:
            # As triangles: the visible points have the same triangulation, with its facets.
            ids = core.vertices()
            weights = None if self.weights is None else self.weights[ids]
            with unchanged():
                core = _core.regular_triangulation(
                    self.points[ids], weights, _core.Settings(0, True, False, 1, None)
                )
            if not np.array_equal(ids[core.triangles().corners()], self._triangles.corners()):
                raise changed()
            corners = ids[core.corners()]
            corners.flags.writeable = False
            return Polygons(core.offsets(), corners)
        return Polygons(core.offsets(), core.corners())

    @cached_property
    def certificate(self) -> Ids:
        """For each point the row of `simplices` that holds it, of several the lowest; it hides a point that is hidden.

        With it, a program that shares nothing with the engine checks the triangulation in linear time:
        Checker/check_result.py. -1: the point is not finite and ignored, or only cells that are left out hold it.
        """
        found = self.locate(self._sites, non_finite="ignore" if self._ignores else "error")
        return frozen(np.asarray(found))

    @property
    def areas(self) -> Floats:
        """The area of each of `simplices`, rounded."""
        return self._measures[0]

    @property
    def centroids(self) -> Floats:
        """The x and y of the centroid of each of `simplices`, rounded."""
        return self._measures[1]

    def within_edge_length(self, limit: float, *, threads: int = 0) -> NDArray[np.bool_]:
        """Which of `simplices` have no edge longer than the limit, exactly: `simplices[within_edge_length(0.1)]`.

        An edge as long as the limit is not longer. Edges are measured in the plane, by x and y.
        """
        limit = length_of("limit", limit)
        chosen = settings(threads, "triangles", "error", "cpu", None, False)
        with unchanged():
            found = run(chosen, _core.cells_within_edge_length, self._sites, self._triangles, limit)
        within: NDArray[np.bool_] = found.view(np.bool_)
        return within

    @cached_property
    def convex_hull(self) -> Ids:
        """The border's edges as rows of ids, counter-clockwise each; in the order of their triangles."""
        if self.dimension < 2:
            return frozen(np.empty((0, 2), np.int64))
        rows, across = np.nonzero(self.neighbors < 0)
        cells = self.simplices
        return frozen(np.column_stack([cells[rows, (across + 1) % 3], cells[rows, (across + 2) % 3]]))

    @cached_property
    def boundary(self) -> Polygons:
        """The border of `simplices` as rings of ids: counter-clockwise around cells, clockwise around holes.

        No ring has a point twice. Each starts at its lowest id. Below dimension 2 there is none.
        """
        return Polygons(*_core.cell_boundary(self._triangles, QUIET))

    @cached_property
    def alphas(self) -> Floats:
        """For each of `simplices` the least alpha, as a double, for which alpha_complex() has it; exactly.

        Without weights, it is the radius of the circumcircle, rounded up: a radius, as alpha is.
        """
        with unchanged():
            return _core.cell_alphas(self.points, self.weights, self._triangles, QUIET)

    def alpha_complex(self, alpha: float, *, threads: int = 0, progress: Progress = None) -> AlphaComplex:
        """What is left where a circle of radius alpha takes away all it can reach without a point in it; exactly.

        Parameters
        ----------
        alpha : float
            a radius, in the unit of the points: a circle as large as alpha is in. gudhi's filtration value is its
            square, and alphashape's alpha its inverse. Infinity: all is in. With weights, squares of radii may be
            negative: a negative alpha stands for -alpha^2. With alpha 0 and the squares of disks' radii as weights, the
            complex is the nerve of their union.
        """
        chosen = settings(threads, "triangles", "error", "cpu", progress, False)
        cells = self._triangles
        with unchanged():
            found = run(chosen, _core.alpha_complex, self.points, self.weights, cells, alpha_of(alpha))
        return AlphaComplex._made(cells, self.simplices, *found)

    @cached_property
    def vertex_neighbor_vertices(self) -> tuple[Ids, Ids]:
        """The points that edges link: point i has indices[indptr[i]:indptr[i + 1]], ascending; (indptr, indices)."""
        links = np.concatenate([self.edges[:, ::-1], self.edges])
        counts = np.bincount(links[:, 0], minlength=self.npoints)
        others = links[np.argsort(links[:, 0], kind="stable"), 1]
        return frozen(np.concatenate([[0], np.cumsum(counts)])), frozen(others)

    @cached_property
    def vertex_to_simplex(self) -> Ids:
        """For each point the lowest of the `simplices` that have it; -1 where none has it, as if it is hidden."""
        found = np.full(self.npoints, -1, np.int64)
        for corner in self.simplices.T:
            rows = np.arange(len(corner))[::-1]
            first = np.full(self.npoints, -1, np.int64)
            first[corner[::-1]] = rows
            found = np.where((found < 0) | ((first >= 0) & (first < found)), first, found)
        return frozen(found)

    def locate(
        self, points: ArrayLike, *, threads: int = 0, non_finite: NonFinite = "error", progress: Progress = None
    ) -> Numbers:
        """The simplex that holds each point, its border included; exactly. Of several, the lowest; -1 outside.

        Parameters
        ----------
        points : array of shape (..., 2), or (..., 3): x and y count
            of any type that regular_triangulation() takes. A tuple of 2 or 3 arrays is an error: it could be points or
            coordinates.

        Returns
        -------
        array of shape (...): rows of `simplices`; of one point, its number
        """
        found: Numbers = results_of(self._queries.locate, points, (2, 3), threads, non_finite, progress)
        return found

    def find_simplex(
        self,
        points: ArrayLike,
        bruteforce: None = None,
        tol: None = None,
        *,
        threads: int = 0,
        non_finite: NonFinite = "error",
        progress: Progress = None,
    ) -> Numbers:
        """locate(), by scipy's name. It is exact, so bruteforce and tol are a TypeError."""
        if bruteforce is not None or tol is not None:
            raise TypeError("find_simplex() takes no bruteforce and no tol: it is exact, and needs no tolerance")
        return self.locate(points, threads=threads, non_finite=non_finite, progress=progress)

    def nearest(
        self, points: ArrayLike, *, threads: int = 0, non_finite: NonFinite = "error", progress: Progress = None
    ) -> Numbers:
        """The id of the visible point with the least power distance from each point; exactly. Of several, the lowest.

        Without weights, that is the nearest point. Parameters and the result's form are those of locate().
        """
        found: Numbers = results_of(self._queries.nearest, points, (2, 3), threads, non_finite, progress)
        return found

    def interpolate(
        self,
        values: ArrayLike,
        points: ArrayLike,
        method: Method = "linear",
        *,
        fill_value: float = np.nan,
        threads: int = 0,
        non_finite: NonFinite = "error",
        progress: Progress = None,
    ) -> Lengths:
        """Values between the points' values.

        Which points count is decided exactly; their shares are rounded.

        Parameters
        ----------
        values : array of shape (n, ...)
            a number, or an array of numbers, for each of the triangulated points; those of hidden points are not used.
            A masked one is NaN.
        points : array of shape (..., 2)
            as for locate()
        method : {"linear", "natural", "clough-tocher", "laplace"}
            linear over each of `simplices`; by natural neighbours (Sibson): each site counts by the area that the
            point's own power cell would take from the site's; or by a surface of cubic pieces, whose gradients at
            points are estimated from those around: smooth, and exact for quadratic functions up to rounding. Its error
            is the least where values are smooth; where they jump, it swings beyond them. With weights, the point's
            weight in "natural" is linear over its triangle, so values still pass through the sites'. "laplace" has the
            same neighbours as "natural", each by the side that its cell and the point's have in common, over its
            distance.
        fill_value : float
            what there is where locate() is -1: by default NaN

        Returns
        -------
        array of the shapes of points and of values, less their last and first axes; of one point and numbers, a number
        """
        query = interpolation_of(self._queries, choice_of("method", method, METHODS))
        given = values_of(values, self.npoints)
        rows = given.reshape(self.npoints, int(np.prod(given.shape[1:])))
        filled = float_of("fill_value", fill_value)
        if filled == filled or rows.shape[1] == 0:
            rows = with_ones(rows)
        found = results_of(query, points, (2, 3), threads, non_finite, progress, np.ascontiguousarray(rows))
        if rows.shape[1] > np.prod(given.shape[1:]):
            found = np.where(np.isnan(found[..., -1:]), filled, found[..., :-1])
        shaped: Lengths = found.reshape(found.shape[:-1] + given.shape[1:])[()]
        return shaped

    def natural_neighbours(
        self,
        points: ArrayLike,
        method: Literal["natural", "laplace", "linear"] = "natural",
        *,
        threads: int = 0,
        non_finite: NonFinite = "error",
        progress: Progress = None,
    ) -> tuple[Ids, Ids, Floats]:
        """The natural neighbours of each point and their shares: (indptr, ids, shares).

        Point i has ids[indptr[i]:indptr[i + 1]], ascending, whose shares sum to 1, but for rounding; none outside. The
        value that interpolate() gives is the sum of the neighbours' values times their shares, but for rounding:
        scipy.sparse.csr_array((shares, ids, indptr)) @ values.

        Parameters
        ----------
        points : array of shape (m, 2), or (m, 3): x and y count
        method : {"natural", "laplace", "linear"}
            as for interpolate(); "linear" has the corners of the simplex
        """
        name = choice_of("method", method, ("natural", "laplace", "linear"))
        array, left_out = points_of(points, ignores(non_finite))
        chosen = settings(threads, "triangles", non_finite, "cpu", progress, left_out)
        found = run(chosen, self._queries.shares, name, array)
        return found[0], found[1], found[2]

    def to_image(
        self,
        values: ArrayLike,
        *,
        spacing: ArrayLike | None = None,
        shape: tuple[int, int] | None = None,
        bounds: ArrayLike | None = None,
        method: Method = "linear",
        fill_value: float = np.nan,
        dtype: DTypeLike | None = None,
        threads: int = 0,
        progress: Progress = None,
    ) -> Image:
        """An image (raster) of values between the points' values, north up, and where it is: an Image.

        The values are those of interpolate() at the pixels' centers, bit for bit, sooner. Give spacing or shape.

        Parameters
        ----------
        values : array of shape (n, ...)
            as for interpolate()
        spacing : number, or two
            the width and height of a pixel. Pixels begin at the left and at the top; as many as cover the bounds, but
            for a millionth of a pixel, as rounding leaves it.
        shape : two integers
            rows and columns, which divide the bounds
        bounds : 4 numbers, or 2 by 2
            the outer corners of the corner pixels, in VTK's order (x0, x1, y0, y1), or ((x0, y0), (x1, y1)); by default
            the box of the points that appear. Of shapely's order, as power_diagram(bounds=) takes it, pass
            numpy.reshape(bounds, (2, 2)).
        method, fill_value
            as for interpolate()
        dtype : float32 or float64
            of the array; by default float32 if values are of it, else float64
        threads, progress
            see the module
        """
        name = choice_of("method", method, METHODS)
        sites = np.asarray(self.points, float)[self.vertices, :2]
        grid = grid_of(sites, spacing, shape, bounds)
        chosen = settings(threads, "triangles", "error", "cpu", progress, False)
        query = partial(run, chosen, self._queries.image, name)
        return image_of(query, values, self.npoints, grid, float_of("fill_value", fill_value), dtype)

    def power_diagram(
        self,
        domain: Any = None,
        *,
        bounds: ArrayLike | None = None,
        box: ArrayLike | None = None,
        threads: int = 0,
        progress: Progress = None,
    ) -> PowerDiagram:
        """The power diagram of the points that appear; without weights, the Voronoi diagram.

        Parameters
        ----------
        domain, bounds, box
            as for the function power_diagram()
        threads, progress
            see the module

        Raises
        ------
        InputError
            the box has no inside, or the polygon is not convex; the error has the numbers
        """
        within = domain_of_call(domain, bounds, box)
        chosen = settings(threads, "polygons", "error", "cpu", progress, False)
        with within.named(), unchanged():
            core = run(chosen, _core.power_diagram, self.points, self.weights, self._core, within.array)
        return PowerDiagram._of(_core=core)

    def validate(self, *, threads: int = 0) -> Validation:
        """Decides exactly whether this is the regular triangulation of the points."""
        fault, text, index = _core.validate_triangulation(self.points, self.weights, self._core, threads)
        return Validation(fault == 0, text, index)

    def __repr__(self) -> str:
        return (
            f"<RegularTriangulation of {self.npoints} points: dimension {self.dimension}, {self._core.cell_count} "
            f"cells, {len(self.hidden)} hidden>"
        )

    @property
    def _sites(self) -> NDArray[Any]:
        """The points, as the engine was given them."""
        return self.points

    @cached_property
    def _queries(self) -> Any:
        with unchanged():
            return _core.triangulation_queries(self.points, self.weights, self._triangles, QUIET)

    @cached_property
    def _measures(self) -> tuple[Floats, Floats]:
        return _core.triangle_measures(self._sites, self._triangles)


@overload
def regular_triangulation(
    points: ArrayLike,
    weights: ArrayLike | None = ...,
    *,
    constraints: None = ...,
    polygons: None = ...,
    polygon_rule: PolygonRule = ...,
    degenerate: Degenerate = ...,
    facets: Facets = ...,
    threads: int = ...,
    non_finite: NonFinite = ...,
    engine: Engine = ...,
    progress: Progress = ...,
) -> RegularTriangulation: ...


@overload
def regular_triangulation(
    points: ArrayLike,
    weights: None = ...,
    *,
    constraints: Chains | SplitConstraints,
    polygons: Chains | None = ...,
    polygon_rule: PolygonRule = ...,
    degenerate: Degenerate = ...,
    facets: Facets = ...,
    threads: int = ...,
    non_finite: NonFinite = ...,
    engine: Engine = ...,
    progress: Progress = ...,
) -> ConstrainedTriangulation: ...


@overload
def regular_triangulation(
    points: ArrayLike,
    weights: None = ...,
    *,
    constraints: None = ...,
    polygons: Chains,
    polygon_rule: PolygonRule = ...,
    degenerate: Degenerate = ...,
    facets: Facets = ...,
    threads: int = ...,
    non_finite: NonFinite = ...,
    engine: Engine = ...,
    progress: Progress = ...,
) -> ConstrainedTriangulation: ...


def regular_triangulation(
    points: ArrayLike,
    weights: ArrayLike | None = None,
    *,
    constraints: Chains | SplitConstraints | None = None,
    polygons: Chains | None = None,
    polygon_rule: PolygonRule = "even-odd",
    degenerate: Degenerate = "error",
    facets: Facets = "triangles",
    threads: int = 0,
    non_finite: NonFinite = "error",
    engine: Engine = "automatic",
    progress: Progress = None,
) -> RegularTriangulation:
    """The exact regular (weighted Delaunay) triangulation of points in the plane; or the constrained one.

    Parameters
    ----------
    points : n by 2, or n by 3
        x and y count
    weights : n numbers, optional
        squared lengths: the power distance of x from a point p is |x - p|^2 - w. By default none: Delaunay.
    constraints : m by 2 ids, or a sequence of polylines, optional
        what edges have to run along. A polyline is a sequence of ids: consecutive ones are joined. With constraints or
        polygons, the result is a ConstrainedTriangulation. There are no weights then, and the CPU does the work. Also
        what split_crossings() gives, with its points.
    polygons : a sequence of rings of ids, or Polygons, optional
        their sides are constraints, and cells outside are left out; if that is all, a warning says so. A ring is closed
        without its first id again at its end, or with it. All points stay, also those that no cell has any more.
    polygon_rule : {"even-odd", "direction"}
        what is inside polygons. By nesting: a ring keeps its inside, one in it is a hole, to any depth, whatever their
        directions; each side counts, so what two rings have in common is outside. Or by direction: what is on the left
        of a side; a clockwise ring is a hole.
    degenerate : {"error", "ignore"}
        what polylines of fewer than two ids and rings of fewer than three lead to: an error, or that they are left out
        and counted, as if they were not given
    facets : {"triangles", "polygons"}
        which form of the facets is made at once; the other is made when it is first used
    threads, non_finite, engine, progress
        see the module

    Raises
    ------
    InputError
        names the first point at fault and how many there are
    """
    ignore = ignores(non_finite)
    if constraints is not None or polygons is not None:
        if weights is not None:
            raise InputError("constraints take no weights: leave one of them out", "bad_argument")
        array, left_out = points_of(points, ignore)
        chosen = settings(threads, facets, non_finite, engine, progress, left_out)
        if engine == "cuda":
            raise InputError(
                "the CUDA engine was asked for, but constraints are the CPU's: leave engine out", "bad_argument"
            )
        given = Constraints(constraints, polygons, polygon_rule, degenerate)
        from ._constrained import constrained_triangulation  # which needs this module

        return constrained_triangulation(array, given, chosen, left_out)
    array, weight_array, left_out = points_and_weights_of(points, weights, ignore)
    chosen = settings(threads, facets, non_finite, engine, progress, left_out)
    chosen[0].points_memory, chosen[0].weights_memory = memory_of(array), memory_of(weight_array)
    core = run(chosen, _core.regular_triangulation, array, weight_array)
    return RegularTriangulation._of(points=array, weights=weight_array, _core=core, _ignores=left_out)


def alpha_complex(
    points: ArrayLike,
    alpha: float,
    weights: ArrayLike | None = None,
    *,
    threads: int = 0,
    non_finite: NonFinite = "error",
    engine: Engine = "automatic",
    progress: Progress = None,
) -> AlphaComplex:
    """The alpha complex of points in the plane, also of weighted ones.

    For several alphas of the same points, call alpha_complex() of one RegularTriangulation.

    Parameters
    ----------
    points, weights, threads, non_finite, engine, progress
        as for regular_triangulation()
    alpha : float
        a radius, in the unit of the points: a circle as large as alpha is in. gudhi's filtration value is its square,
        and alphashape's alpha its inverse. Infinity: all is in. With weights, squares of radii may be negative: a
        negative alpha stands for -alpha^2. With alpha 0 and the squares of disks' radii as weights, the complex is the
        nerve of their union.
    """
    alpha = alpha_of(alpha)
    triangulation = regular_triangulation(
        points, weights, threads=threads, non_finite=non_finite, engine=engine, progress=progress
    )
    return triangulation.alpha_complex(alpha, threads=threads, progress=progress)


def power_diagram(
    points: ArrayLike,
    weights: ArrayLike | None = None,
    domain: Any = None,
    *,
    bounds: ArrayLike | None = None,
    box: ArrayLike | None = None,
    threads: int = 0,
    non_finite: NonFinite = "error",
    engine: Engine = "automatic",
    progress: Progress = None,
) -> PowerDiagram:
    """The power diagram of points in the plane, cut at a box or a polygon; without weights, the Voronoi diagram.

    Parameters
    ----------
    points, weights, threads, non_finite, engine, progress
        as for regular_triangulation()
    domain : 4 numbers, 2 by 2, m by 2, or a polygon, optional
        where cells are cut. Either a box: (x0, x1, y0, y1), in VTK's order, or two corners ((x0, y0), (x1, y1)). Or a
        convex polygon: its corners in either direction, also repeated ones, or shapely's. By default the points' box.
    bounds : 4 numbers, optional
        instead (x0, y0, x1, y1), as shapely's bounds and GeoPandas's total_bounds
    box
        domain by another name
    """
    domain_of_call(domain, bounds, box)  # what is wrong with it is said before the work
    triangulation = regular_triangulation(
        points, weights, facets="polygons", threads=threads, non_finite=non_finite, engine=engine, progress=progress
    )
    return triangulation.power_diagram(domain, bounds=bounds, box=box, threads=threads, progress=progress)
