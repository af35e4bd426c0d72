# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Regular and constrained triangulations of arrays, and power diagrams."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar, Literal, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._alpha import AlphaComplex, alpha_of
from ._arguments import choice_of, flag_of
from ._constraints import Chains, Constraints, PolygonRule, SplitConstraints
from ._device import memory_of
from ._domain import domain_of_call
from ._errors import InputError
from ._geometries import Degenerate
from ._input import points_and_weights_of, points_of, values_of
from ._plane_cells import LocatedCells
from ._power_diagram import PowerDiagram
from ._queries import Numbers, changed, results_of, unchanged
from ._rescaled import RescaledTriangulation, scale_of, scaled_by
from ._results import (
    QUIET,
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
    from ._voronoi import VoronoiDiagram


class RegularTriangulation(LocatedCells):
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
    def hidden(self) -> Ids:
        """Ids of the points that do not appear, ascending: duplicates, and points whose cell is empty."""
        return self._core.hidden()

    @cached_property
    def polygons(self) -> Polygons:
        """Facets as ids: all points of one power circle are one polygon."""
        core, _, _, ids = self._facets
        corners = core.corners()
        return Polygons(core.offsets(), corners if ids is None else frozen(ids[corners]))

    @cached_property
    def certificate(self) -> Ids:
        """For each point the row of `simplices` that holds it, of several the lowest; it hides a point that is hidden.

        With it, a program that shares nothing with the engine checks the triangulation in linear time:
        Checker/check_result.py. -1: the point is not finite and ignored, or only cells that are left out hold it.
        """
        found = self.locate(self._sites, non_finite="ignore" if self._ignores else "error")
        return frozen(np.asarray(found))

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
        with unchanged():
            found = run(chosen, _core.alpha_complex, self.points, self.weights, self._triangles, alpha_of(alpha))
        return AlphaComplex._made(self, *found)

    def nearest(
        self, points: ArrayLike, *, threads: int = 0, non_finite: NonFinite = "error", progress: Progress = None
    ) -> Numbers:
        """The id of the visible point with the least power distance from each point; exactly. Of several, the lowest.

        Without weights, that is the nearest point. Parameters and the result's form are those of locate().
        """
        found: Numbers = results_of(self._queries.nearest, points, (2, 3), threads, non_finite, progress)
        return found

    def gradients(self, values: ArrayLike, *, threads: int = 0, progress: Progress = None) -> Floats:
        """The gradients of values (n, ...) at the points: an array (n, 2, ...), by x and by y.

        interpolate() with "clough-tocher" has them: those of quadratic functions that fit the values around. They are
        NaN of hidden points, and of all below dimension 2.
        """
        given = values_of(values, self.npoints)
        rows = given.reshape(self.npoints, int(np.prod(given.shape[1:])))
        chosen = settings(threads, "triangles", "error", "cpu", progress, False)
        found = run(chosen, self._queries.gradients, rows)
        return np.moveaxis(found.reshape(*given.shape, 2), -1, 1)

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

    def voronoi_diagram(self) -> VoronoiDiagram:
        """The unbounded Voronoi diagram of the points that appear; with weights, the power diagram."""
        from ._voronoi import VoronoiDiagram  # which needs this module

        return VoronoiDiagram._of(triangulation=self)

    def validate(self, *, threads: int = 0) -> Validation:
        """Decides exactly whether this is the regular triangulation of the points."""
        fault, text, index = _core.validate_triangulation(self.points, self.weights, self._core, threads)
        return Validation(fault == 0, text, index)

    def __repr__(self) -> str:
        return (
            f"<RegularTriangulation of {self.npoints} points: dimension {self.dimension}, {self._core.cell_count} "
            f"cells, {len(self.hidden)} hidden>"
        )

    @cached_property
    def _facets(self) -> tuple[Any, NDArray[Any], NDArray[Any] | None, Ids | None]:
        """The engine's polygons, the points and weights that these are of, and whose ids those are; None: their own."""
        if self._core.cell_size != 3:
            return self._core, self.points, self.weights, None
        # As triangles: the visible points have the same triangulation, with its facets.
        ids = self._core.vertices()
        points, weights = self.points[ids], None if self.weights is None else self.weights[ids]
        with unchanged():
            core = _core.regular_triangulation(points, weights, _core.Settings(0, True, False, 1, None))
        if not np.array_equal(ids[core.triangles().corners()], self._triangles.corners()):
            raise changed()
        return core, points, weights, ids

    def _queries_of(self, cells: Any) -> Any:
        with unchanged():
            return _core.triangulation_queries(self.points, self.weights, self._triangles, QUIET, cells)


@overload
def regular_triangulation(
    points: ArrayLike,
    weights: None = ...,
    *,
    constraints: None = ...,
    polygons: None = ...,
    polygon_rule: PolygonRule = ...,
    degenerate: Degenerate = ...,
    rescale: Literal[True],
    facets: Facets = ...,
    threads: int = ...,
    non_finite: NonFinite = ...,
    engine: Engine = ...,
    progress: Progress = ...,
) -> RescaledTriangulation: ...


@overload
def regular_triangulation(
    points: ArrayLike,
    weights: ArrayLike | None = ...,
    *,
    constraints: None = ...,
    polygons: None = ...,
    polygon_rule: PolygonRule = ...,
    degenerate: Degenerate = ...,
    rescale: Literal[False] = ...,
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
    rescale: Literal[False] = ...,
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
    rescale: Literal[False] = ...,
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
    rescale: bool = False,
    facets: Facets = "triangles",
    threads: int = 0,
    non_finite: NonFinite = "error",
    engine: Engine = "automatic",
    progress: Progress = None,
) -> RegularTriangulation | RescaledTriangulation:
    """The exact regular (weighted Delaunay) triangulation of points in the plane; or the constrained one.

    Parameters
    ----------
    points : n by 2, or n by 3
        x and y count, in a plane: longitudes and latitudes are to be projected first, as pyproj does
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
    rescale : bool
        whether x and y have different units, as days and metres: the one of the smaller range is scaled up, by a power
        of two, so without rounding. The result is a RescaledTriangulation, in the caller's unit. There are no weights
        and no constraints then.
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
    if flag_of("rescale", rescale):
        if weights is not None or constraints is not None or polygons is not None:
            raise InputError("rescale=True is for points without weights and constraints", "bad_argument")
        return _rescaled(points, facets, threads, non_finite, engine, progress)
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


def _rescaled(
    points: ArrayLike, facets: Facets, threads: int, non_finite: NonFinite, engine: Engine, progress: Progress
) -> RescaledTriangulation:
    array, left_out = points_of(points, ignores(non_finite))
    scale = scale_of(array)
    scaled = regular_triangulation(
        scaled_by(scale, array),
        facets=facets,
        threads=threads,
        non_finite="ignore" if left_out else non_finite,
        engine=engine,
        progress=progress,
    )
    return RescaledTriangulation._of(points=array, scale=scale, scaled=scaled, _core=scaled._core, _ignores=left_out)


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
