# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cells over points in the plane: their measures and borders; and queries at positions."""

from __future__ import annotations

from functools import cached_property, partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _core
from ._arguments import choice_of, float_of, length_of, mask_of
from ._geometries import multi_polygon
from ._image import METHODS, Grid, Image, Method, grid_of, image_of
from ._input import values_of
from ._queries import Lengths, Numbers, finite, interpolation_of, results_of, unchanged, with_ones
from ._results import QUIET, Cells, Floats, Ids, NonFinite, Polygons, Progress, frozen, run, settings

if TYPE_CHECKING:
    from ._selection import CellSelection


class PlanarCells(Cells):
    """Cells over points in the plane."""

    @cached_property
    def vertices(self) -> Ids:
        """Ids of the points that appear, ascending."""
        return self._core.vertices()

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

        An edge as long as the limit is not longer. Edges are measured in the plane, by x and y. To leave the others out
        of queries, images and the region, pass it to with_cells().
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

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        """The border of the cells as a MultiPolygon with holes: shapely.geometry.shape(triangulation) takes it.

        Each part of the cells that edges connect is a polygon; parts may touch at points. Below dimension 2 it is
        empty.
        """
        rings = [] if self.dimension < 2 else [*self.boundary]
        points = finite(self.points, self.simplices)
        return multi_polygon(points, self.simplices, self.neighbors, rings)

    @cached_property
    def boundary(self) -> Polygons:
        """The border of `simplices` as rings of ids: counter-clockwise around cells, clockwise around holes.

        No ring has a point twice. Each starts at its lowest id. Below dimension 2 there is none.
        """
        return Polygons(*_core.cell_boundary(self._triangles, QUIET))

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

    @property
    def _sites(self) -> NDArray[Any]:
        """The points, as the engine was given them."""
        return self.points

    @cached_property
    def _measures(self) -> tuple[Floats, Floats]:
        return _core.triangle_measures(self._sites, self._triangles)


class LocatedCells(PlanarCells):
    """Such cells with queries at positions."""

    def with_cells(self, within: ArrayLike) -> CellSelection:
        """Some of `simplices` alone: what only others hold is outside. ids stay.

        For example, `with_cells(within_edge_length(0.1)).interpolate(values, points)` has no value in triangles of
        longer edges, and `with_cells(alpha_complex(0.1).within)` none beyond the alpha shape.

        Parameters
        ----------
        within : array of bool
            for each of `simplices` whether it stays
        """
        from ._selection import CellSelection  # which needs this module

        return CellSelection._with(self, mask_of("within", within, self.nsimplex))

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
        return self._image_on(grid, values, name, float_of("fill_value", fill_value), dtype, threads, progress)

    def _image_on(
        self,
        grid: Grid,
        values: ArrayLike,
        method: str,
        fill: float,
        dtype: DTypeLike | None,
        threads: int,
        progress: Progress,
    ) -> Image:
        chosen = settings(threads, "triangles", "error", "cpu", progress, False)
        query = partial(run, chosen, self._queries.image, method)
        return image_of(query, values, self.npoints, grid, fill, dtype)

    @cached_property
    def _queries(self) -> Any:
        return self._queries_of(None)

    def _queries_of(self, cells: Any) -> Any:
        """The engine's: to some of `_triangles` in their order, or, of None, to all."""
        raise NotImplementedError
