# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Regular and constrained triangulations, and power diagrams, of arrays."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._alpha import AlphaComplex, alpha_of
from ._constraints import Chains, Constraints, PolygonRule, SplitConstraints
from ._device import memory_of
from ._errors import InputError
from ._input import points_of, weights_of
from ._results import (
    QUIET,
    Cells,
    Floats,
    Frozen,
    Ids,
    Polygons,
    Progress,
    Validation,
    answers,
    frozen,
    ignores,
    run,
    settings,
)

if TYPE_CHECKING:
    from ._constrained import ConstrainedTriangulation

# Ways to interpolate, and the core's names of them.
_METHODS = {"linear": "interpolate_linear", "natural": "interpolate_natural"}


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

    def __init__(self, points: NDArray[Any], weights: NDArray[Any] | None, core: Any, ignores: bool) -> None:
        super().__init__(points, core, ignores)
        self.__dict__["weights"] = weights

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
            # As triangles: the visible points have the same triangulation, and tell its facets.
            ids = core.vertices()
            weights = None if self.weights is None else self.weights[ids]
            core = _core.regular_triangulation(
                self.points[ids], weights, _core.Settings(0, True, False, 1, None)
            )
            corners = ids[core.corners()]
            corners.flags.writeable = False
            return Polygons(core.offsets(), corners)
        return Polygons(core.offsets(), core.corners())

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
        limit = float(limit)
        if not limit >= 0:
            raise ValueError(f"a limit of lengths is 0 or more, not {limit!r}")
        chosen = settings(threads, "triangles", "error", "cpu", None, False)
        found = run(chosen, _core.cells_within_edge_length, self.points, self._triangles, limit)
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

        Without weights, it is the radius of the circumcircle, rounded up.
        """
        return _core.cell_alphas(self.points, self.weights, self._triangles, QUIET)

    def alpha_complex(self, alpha: float, *, threads: int = 0, progress: Progress = None) -> AlphaComplex:
        """What is left where a circle of radius alpha takes away all it can reach without a point in it; exactly.

        Parameters
        ----------
        alpha : float
            a length: a circle as large as alpha is in. Infinity: all is in. With weights, squares of radii may be
            negative: a negative alpha stands for -alpha^2. With alpha 0 and the squares of disks' radii as weights, the
            complex is the nerve of their union.
        """
        chosen = settings(threads, "triangles", "error", "cpu", progress, False)
        cells = self._triangles
        found = run(chosen, _core.alpha_complex, self.points, self.weights, cells, alpha_of(alpha))
        return AlphaComplex(cells, self.simplices, *found)

    @cached_property
    def vertex_neighbor_vertices(self) -> tuple[Ids, Ids]:
        """Whom edges link: point i has the neighbours indices[indptr[i]:indptr[i + 1]], ascending; (indptr, indices)."""
        corners = self.simplices.shape[1]
        pairs = [self.simplices[:, [i, j]] for i in range(corners) for j in range(corners) if i != j]
        links = np.unique(np.vstack([np.empty((0, 2), np.int64), *pairs]), axis=0)
        counts = np.bincount(links[:, 0], minlength=self.npoints)
        return frozen(np.concatenate([[0], np.cumsum(counts)])), frozen(np.ascontiguousarray(links[:, 1]))

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
        self, points: ArrayLike, *, threads: int = 0, non_finite: str = "error", progress: Progress = None
    ) -> Any:
        """The simplex that holds each point, its border included; exactly. Of several, the lowest; -1 outside.

        Parameters
        ----------
        points : m by 2 (or 3: x and y count), or one point
            anything that regular_triangulation() takes

        Returns
        -------
        array of m rows of `simplices`, or one number
        """
        return answers(self._queries.locate, points, (2, 3), threads, non_finite, progress)

    find_simplex = locate

    def nearest(
        self, points: ArrayLike, *, threads: int = 0, non_finite: str = "error", progress: Progress = None
    ) -> Any:
        """The id of the visible point with the least power distance from each point; exactly. Of several, the lowest.

        Without weights, that is the nearest point. Parameters and the result's form are those of locate().
        """
        return answers(self._queries.nearest, points, (2, 3), threads, non_finite, progress)

    def interpolate(
        self,
        values: ArrayLike,
        points: ArrayLike,
        method: str = "linear",
        *,
        threads: int = 0,
        non_finite: str = "error",
        progress: Progress = None,
    ) -> Any:
        """Values between the points' values; NaN outside the convex hull.

        Which points count is decided exactly; their shares are rounded.

        Parameters
        ----------
        values : n numbers, or n by k
            one (or a row) for each of the triangulated points; those of hidden points are not used
        points
            as for locate()
        method : {"linear", "natural"}
            linear over each of `simplices`; or by natural neighbours (Sibson): each site counts by the area that the
            point's own power cell would take from the site's. With weights, the point's weight is linear over its
            triangle, so values still pass through the sites'.

        Returns
        -------
        array of m numbers, or m by k; for one point, its value
        """
        if method not in _METHODS:
            raise ValueError(f"method is one of {', '.join(map(repr, _METHODS))}, not {method!r}")
        given = np.asarray(values, np.float64)
        if given.ndim not in (1, 2) or len(given) != self.npoints:
            raise ValueError(f"values are {self.npoints} numbers or rows, not an array of shape {given.shape}")
        rows = np.ascontiguousarray(given.reshape(self.npoints, -1 if given.size else 1))
        ask = getattr(self._queries, _METHODS[method])
        found = answers(ask, points, (2, 3), threads, non_finite, progress, rows)
        return found[..., 0] if given.ndim == 1 else found

    def power_diagram(
        self, box: ArrayLike | None = None, *, threads: int = 0, progress: Progress = None
    ) -> PowerDiagram:
        """The power diagram of the points that appear; without weights, the Voronoi diagram.

        Parameters
        ----------
        box : 4 numbers, or m by 2, optional
            where cells are cut: x least, x greatest, y least, y greatest; or the corners of a convex polygon,
            counter-clockwise. By default the box of the points.
        """
        chosen = settings(threads, "polygons", "error", "cpu", progress, False)
        return PowerDiagram(
            run(chosen, _core.power_diagram, self.points, self.weights, self._core, domain_of(box))
        )

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
    def _queries(self) -> Any:
        return _core.triangulation_queries(self.points, self.weights, self._triangles, QUIET)

    @cached_property
    def _measures(self) -> tuple[Floats, Floats]:
        return _core.triangle_measures(self.points, self._triangles)


def domain_of(domain: ArrayLike | None) -> NDArray[np.float64] | None:
    """A box as 4 numbers, or a polygon's corners as rows of x and y."""
    if domain is None:
        return None
    array = np.ascontiguousarray(domain, np.float64)
    if array.size == 4:
        return array.reshape(-1)
    if array.ndim != 2 or array.shape[1] != 2 or len(array) < 3:
        raise ValueError(
            "a box is x least, x greatest, y least, y greatest; a polygon three rows or more of x and y; "
            f"not an array of shape {array.shape}"
        )
    return array


class PowerDiagram(Frozen):
    """The cells of a power diagram, cut at a box or a convex polygon.

    There is one polygon, counter-clockwise, for each site that has a cell in it.
    Cells fill it without gap or overlap and share their corners. Only the corners' coordinates are rounded.

    Attributes
    ----------
    vertices : ndarray of k by 2
        the corners
    cells : Polygons
        of rows of vertices
    sites : ndarray
        id of each cell's point, ascending
    """

    vertices: Floats
    cells: Polygons
    sites: Ids
    _core: Any

    def __init__(self, core: Any) -> None:
        self.__dict__.update(
            vertices=core.vertices(),
            cells=Polygons(core.offsets(), core.connectivity()),
            sites=core.sites(),
            _core=core,
        )

    @property
    def areas(self) -> Floats:
        """The area of each cell, rounded."""
        return self._measures[0]

    @property
    def centroids(self) -> Floats:
        """The x and y of each cell's centroid, rounded."""
        return self._measures[1]

    @property
    def regions(self) -> list[Ids]:
        """The corners of each cell, as rows of vertices."""
        return np.split(self.cells.connectivity, self.cells.offsets[1:-1]) if len(self.sites) else []

    @cached_property
    def _measures(self) -> tuple[Floats, Floats]:
        return _core.power_cell_measures(self._core)

    def __len__(self) -> int:
        return len(self.sites)

    def __repr__(self) -> str:
        return f"<PowerDiagram: {len(self.sites)} cells, {len(self.vertices)} corners>"


@overload
def regular_triangulation(
    points: ArrayLike,
    weights: ArrayLike | None = ...,
    *,
    constraints: None = ...,
    polygons: None = ...,
    polygon_rule: PolygonRule = ...,
    facets: str = ...,
    threads: int = ...,
    non_finite: str = ...,
    engine: str = ...,
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
    facets: str = ...,
    threads: int = ...,
    non_finite: str = ...,
    engine: str = ...,
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
    facets: str = ...,
    threads: int = ...,
    non_finite: str = ...,
    engine: str = ...,
    progress: Progress = ...,
) -> ConstrainedTriangulation: ...


def regular_triangulation(
    points: ArrayLike,
    weights: ArrayLike | None = None,
    *,
    constraints: Chains | SplitConstraints | None = None,
    polygons: Chains | None = None,
    polygon_rule: PolygonRule = "even-odd",
    facets: str = "triangles",
    threads: int = 0,
    non_finite: str = "error",
    engine: str = "automatic",
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
    facets : {"triangles", "polygons"}
        which form of the facets is made at once; the other is made when it is asked for
    threads, non_finite, engine, progress
        see the module

    Raises
    ------
    InputError
        names the first point at fault and how many there are
    """
    ignore = ignores(non_finite)
    array, left_out = points_of(points, ignore)
    heavy = None
    if constraints is not None or polygons is not None:
        if weights is not None:
            raise InputError("constraints take no weights: leave one of them out", "bad_argument")
        chosen = settings(threads, facets, non_finite, engine, progress, left_out)
        if engine == "cuda":
            raise InputError(
                "the CUDA engine was asked for, but constraints are the CPU's: leave engine out", "bad_argument"
            )
        given = Constraints(constraints, polygons, polygon_rule)
        from ._constrained import constrained_triangulation  # which needs this module

        return constrained_triangulation(array, given, chosen, left_out)
    if weights is not None:
        heavy, masked = weights_of(weights, ignore)
        left_out = left_out or masked
    chosen = settings(threads, facets, non_finite, engine, progress, left_out)
    chosen[0].points_memory, chosen[0].weights_memory = memory_of(array), memory_of(heavy)
    core = run(chosen, _core.regular_triangulation, array, heavy)
    return RegularTriangulation(array, heavy, core, left_out)


def alpha_complex(
    points: ArrayLike,
    alpha: float,
    weights: ArrayLike | None = None,
    *,
    threads: int = 0,
    non_finite: str = "error",
    engine: str = "automatic",
    progress: Progress = None,
) -> AlphaComplex:
    """The alpha complex of points in the plane, also of weighted ones.

    For several alphas of the same points, ask one RegularTriangulation for its alpha_complex().

    Parameters
    ----------
    points, weights, threads, non_finite, engine, progress
        as for regular_triangulation()
    alpha
        as for RegularTriangulation.alpha_complex()
    """
    alpha = alpha_of(alpha)
    triangulation = regular_triangulation(
        points, weights, threads=threads, non_finite=non_finite, engine=engine, progress=progress
    )
    return triangulation.alpha_complex(alpha, threads=threads, progress=progress)


def power_diagram(
    points: ArrayLike,
    weights: ArrayLike | None = None,
    box: ArrayLike | None = None,
    *,
    threads: int = 0,
    non_finite: str = "error",
    engine: str = "automatic",
    progress: Progress = None,
) -> PowerDiagram:
    """The power diagram of points in the plane, cut at a box; without weights, the Voronoi diagram.

    Parameters
    ----------
    points, weights, threads, non_finite, engine, progress
        as for regular_triangulation()
    box
        as for RegularTriangulation.power_diagram()
    """
    triangulation = regular_triangulation(
        points, weights, facets="polygons", threads=threads, non_finite=non_finite, engine=engine, progress=progress
    )
    return triangulation.power_diagram(box, threads=threads, progress=progress)
