# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""scipy.spatial's hulls, triangulations and Voronoi diagrams, exact, with its names, shapes and types; and what
scipy.interpolate makes of points in the plane.

    from vtkflipflop.spatial import ConvexHull, Delaunay, Voronoi

Ids are int32. Arrays may be written to; what is read later is computed of points as they are then. What differs from
scipy:

- Every decision is exact, so nothing is joggled or merged; a QhullError means that the points span less, exactly.
- Hulls are of points in the plane or in space, triangulations and diagrams of points in the plane. Others are a
  NotImplementedError, or scipy's own with fallback=True.
- qhull_options are accepted, and mean nothing: a warning says so once. Of hulls, "QGn", "QG-n" and "Qc" are heeded; of
  diagrams, whether "Qz" is among them; of triangulations and diagrams, "QG" is scipy's alone.
- Points on a facet or at another's position are no vertices.
- Objects can be pickled and copied, also those that points can be added to.
- Subclasses have no fallback.
"""

from __future__ import annotations

import re
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._edit import EditableTriangulation
from ._facet_sides import sides_of_facets, touched_facets
from ._furthest_site import FurthestSiteTriangulation, furthest_site_triangulation
from ._hull import convex_hull
from ._incremental import Incremental
from ._input import is_array_like
from ._interpolators import (
    CloughTocher2DInterpolator,
    LinearNDInterpolator,
    NearestNDInterpolator,
    estimate_gradients_2d_global,
    griddata,
)
from ._qhull import QhullError, say_unused
from ._results import Facets
from ._rings import lists_of
from ._spatial_half_spaces import HalfspaceIntersection
from ._spatial_plots import convex_hull_plot_2d, delaunay_plot_2d, voronoi_plot_2d
from ._sphere import SphericalVoronoi
from ._triangulation import RegularTriangulation, regular_triangulation
from ._voronoi import VoronoiDiagram

__all__ = [
    "CloughTocher2DInterpolator",
    "ConvexHull",
    "Delaunay",
    "HalfspaceIntersection",
    "LinearNDInterpolator",
    "NearestNDInterpolator",
    "QhullError",
    "SphericalVoronoi",
    "Voronoi",
    "convex_hull_plot_2d",
    "delaunay_plot_2d",
    "estimate_gradients_2d_global",
    "griddata",
    "tsearch",
    "voronoi_plot_2d",
]

Rows = NDArray[np.float64]
Ints = NDArray[np.int32]


class _OfPoints(Incremental):
    """Points to which others can be added, and what is made of them, when it is first used."""

    _dimensions: tuple[int, ...]
    # Patterns of options that mean something, and of those that are scipy's alone: none.
    _heeded, _refused = r"(?!)", r"(?!)"
    points: Rows

    @classmethod
    def _why_not(cls, points: Any, *arguments: Any, **settings: Any) -> str:
        options = str(settings.get("qhull_options") or next((a for a in arguments if isinstance(a, str)), ""))
        if re.search(cls._refused, options):
            return f"qhull_options {options!r} choose facets"
        columns = np.shape(points)[1] if np.ndim(points) == 2 else 0
        if columns > 1 and columns not in cls._dimensions:
            return f"points have {' or '.join(map(str, cls._dimensions))} coordinates here, not {columns}"
        return ""

    def __init__(
        self, points: ArrayLike, incremental: bool = False, qhull_options: str | None = None, *, fallback: bool = False
    ) -> None:
        rows = _rows_of(points)
        if not len(rows):
            raise ValueError("No points given")
        self._check(rows, qhull_options=qhull_options)
        say_unused(re.sub(self._heeded, "", qhull_options or "").strip())
        self._options = qhull_options
        self._open(incremental)
        self._take(rows)

    def _take(self, rows: Rows) -> None:
        raise NotImplementedError

    def add_points(self, points: ArrayLike, restart: bool = False) -> None:
        """Add points after the others; with restart, from nothing."""
        self._require_open()
        rows = _rows_of(points)
        if rows.shape[1] != self.ndim:
            raise ValueError(f"invalid size for new points array: {rows.shape}")
        if restart:
            self._take(np.concatenate([self.points, rows]))
        else:
            self._extend(rows)

    def _extend(self, rows: Rows) -> None:
        raise NotImplementedError

    @property
    def ndim(self) -> int:
        return int(self.points.shape[1])

    @property
    def npoints(self) -> int:
        return len(self.points)

    @cached_property
    def min_bound(self) -> Rows:
        return np.asarray(self.points.min(axis=0))

    @cached_property
    def max_bound(self) -> Rows:
        return np.asarray(self.points.max(axis=0))


class ConvexHull(_OfPoints):
    """The convex hull of points in the plane or in space, as scipy.spatial.ConvexHull.

    Attributes
    ----------
    points, ndim, npoints, min_bound, max_bound
        as given; bounds of all points
    vertices : ndarray of int
        in the plane counter-clockwise, in space ascending
    simplices, neighbors : ndarray of nsimplex by ndim
        facets, in space as triangles counter-clockwise from outside; for each corner the facet opposite to it
    equations : ndarray of nsimplex by ndim + 1
        outward unit normals and offsets
    coplanar : ndarray of k by 3
        with "Qc" in qhull_options, the points on the surface that are no vertices: its id, a facet whose plane it is
        on, and the nearest of the corners of all these facets
    good : ndarray of nsimplex bool, or None
        with "QGn" in qhull_options, whether point n is beyond the facet's plane, exactly; with "QG-n", whether it is
        not. Point n is left out of the hull.
    volume, area : float
        in the plane, area and perimeter
    """

    _dimensions = (2, 3)
    _heeded = r"\b(QG-?\d+|Qc)\b"

    def _take(self, rows: Rows, kept: NDArray[np.int64] | None = None) -> None:
        """kept: the hull is that of these rows"""
        if kept is None and self._viewpoint is not None:
            if abs(self._viewpoint) >= len(rows):
                raise QhullError(f"qhull_options {self._options!r} name a point that is not one of {len(rows)}")
            kept = np.delete(np.arange(len(rows)), abs(self._viewpoint))
        hull = convex_hull(rows if kept is None else rows[kept])
        if hull.dimension < rows.shape[1]:
            raise QhullError(_flat(hull.dimension, rows.shape[1], len(rows)))
        self._forget()
        self.points, self._hull, self._kept = rows, hull, kept

    def _extend(self, rows: Rows) -> None:
        """By the hull of the vertices and the new points."""
        whole = np.concatenate([self.points, rows])
        vertices = np.sort(self._own(self._hull.vertices))
        self._take(whole, np.concatenate([vertices, np.arange(self.npoints, len(whole))]))

    @property
    def _viewpoint(self) -> int | None:
        """The number after QG."""
        found = re.search(r"\bQG(-?\d+)", self._options or "")
        return int(found[1]) if found else None

    def _own(self, found: NDArray[Any]) -> Ints:
        return (found if self._kept is None else self._kept[found]).astype(np.int32)

    @cached_property
    def vertices(self) -> Ints:
        return self._own(self._hull.vertices)

    @cached_property
    def simplices(self) -> Ints:
        return self._own(self._hull.simplices)

    @cached_property
    def neighbors(self) -> Ints:
        return self._hull.neighbors.astype(np.int32)

    @cached_property
    def equations(self) -> Rows:
        return self._hull.equations.copy()

    @cached_property
    def good(self) -> NDArray[np.bool_] | None:
        if self._viewpoint is None:
            return None
        is_visible = sides_of_facets(self.points, self.simplices, self.points[[abs(self._viewpoint)]])[0] > 0
        return np.asarray(is_visible if self._viewpoint >= 0 else ~is_visible)

    @cached_property
    def coplanar(self) -> Ints:
        if not re.search(r"\bQc\b", self._options or ""):
            return np.empty((0, 3), np.int32)
        is_added = self._hull.side(self.points) == 0
        is_added[self.vertices] = False
        if self._viewpoint is not None:
            is_added[abs(self._viewpoint)] = False
        return touched_facets(self.points, self.simplices, np.flatnonzero(is_added))

    @property
    def nsimplex(self) -> int:
        return self._hull.nsimplex

    @property
    def volume(self) -> float:
        return self._hull.volume

    @property
    def area(self) -> float:
        return self._hull.area


class _OfPlane(_OfPoints):
    """What is made of a Delaunay triangulation."""

    _dimensions = (2,)
    _heeded, _refused = r"\bQz\b", r"\bQG"

    def __init__(
        self,
        points: ArrayLike,
        furthest_site: bool = False,
        incremental: bool = False,
        qhull_options: str | None = None,
        *,
        fallback: bool = False,
    ) -> None:
        self.furthest_site = bool(furthest_site)
        super().__init__(points, incremental, qhull_options, fallback=fallback)

    _facets: Facets = "triangles"
    _found: RegularTriangulation | FurthestSiteTriangulation

    def _take(self, rows: Rows) -> None:
        if self.furthest_site:
            self._show(rows, furthest_site_triangulation(rows))
        else:
            self._show(rows, regular_triangulation(rows, facets=self._facets))

    def _extend(self, rows: Rows) -> None:
        self._take(np.concatenate([self.points, rows]))

    def _show(self, rows: Rows, found: RegularTriangulation | FurthestSiteTriangulation) -> None:
        if found.dimension < 2:
            raise QhullError(_flat(found.dimension, 2, len(rows)))
        self._forget()
        self.points, self._found = rows, found


class Delaunay(_OfPlane):
    """The Delaunay triangulation of points in the plane, as scipy.spatial.Delaunay.

    Attributes
    ----------
    points, ndim, npoints, min_bound, max_bound
        as given; bounds of all points
    simplices, neighbors : ndarray of nsimplex by 3
        triangles, counter-clockwise; for each corner the triangle opposite to it, -1 where there is none
    equations : ndarray of nsimplex by 4
        of each triangle on the paraboloid, the downward unit normal and the offset; rounded
    coplanar : ndarray of k by 3
        the points that are at another's position, a triangle there, and the other
    convex_hull : ndarray of m by 2
    vertex_to_simplex : ndarray of npoints
    vertex_neighbor_vertices : (indptr, indices)
    transform : ndarray of nsimplex by 3 by 2
        from positions to barycentric coordinates; NaN of triangles that are too thin for doubles, as in scipy
    """

    paraboloid_scale, paraboloid_shift = 1.0, 0.0
    _edited: EditableTriangulation | None = None  # once points were added

    def __getstate__(self) -> dict[str, Any]:
        """Without what other copies must not share."""
        return {**self.__dict__, "_edited": None}

    def _take(self, rows: Rows) -> None:
        super()._take(rows)
        self._edited = None

    def _extend(self, rows: Rows) -> None:
        if not isinstance(self._found, RegularTriangulation):
            self._take(np.concatenate([self.points, rows]))
            return
        edited = EditableTriangulation(self._found) if self._edited is None else self._edited
        edited.insert(rows)
        self._show(np.concatenate([self.points, rows]), edited.snapshot())
        self._edited = edited

    @cached_property
    def simplices(self) -> Ints:
        return self._found.simplices.astype(np.int32)

    @cached_property
    def neighbors(self) -> Ints:
        return self._found.neighbors.astype(np.int32)

    @cached_property
    def convex_hull(self) -> Ints:
        return self._found.convex_hull.astype(np.int32)

    @cached_property
    def vertex_to_simplex(self) -> Ints:
        found = self._found.vertex_to_simplex.astype(np.int32)
        found[self.coplanar[:, 0]] = self.coplanar[:, 1]
        return found

    @cached_property
    def vertex_neighbor_vertices(self) -> tuple[Ints, Ints]:
        first, ids = self._found.vertex_neighbor_vertices
        return first.astype(np.int32), ids.astype(np.int32)

    @cached_property
    def coplanar(self) -> Ints:
        hidden = self._found.hidden
        if not len(hidden) or not isinstance(self._found, RegularTriangulation):
            return np.empty((0, 3), np.int32)
        positions = self.points[hidden]
        found = hidden, self._found.locate(positions), self._found.nearest(positions)
        return np.column_stack(found).astype(np.int32)

    @property
    def nsimplex(self) -> int:
        return self._found.nsimplex

    @cached_property
    def transform(self) -> NDArray[np.float64]:
        corners = self.points[self.simplices]
        last = corners[:, 2]
        sides = np.moveaxis(corners[:, :2] - last[:, None], 1, 2)
        made = np.empty((len(corners), 3, 2))
        with np.errstate(all="ignore"):
            determinant = sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0]
            made[:, 0, 0], made[:, 0, 1] = sides[:, 1, 1] / determinant, -sides[:, 0, 1] / determinant
            made[:, 1, 0], made[:, 1, 1] = -sides[:, 1, 0] / determinant, sides[:, 0, 0] / determinant
            sizes = [np.abs(some).sum(axis=1).max(axis=1) for some in (sides, made[:, :2])]
            is_bad = ~(sizes[0] * sizes[1] * (1000 * np.finfo(float).eps) < 1)
        made[:, 2] = last
        made[is_bad] = np.nan
        return made

    @cached_property
    def equations(self) -> Rows:
        a, b, c = np.moveaxis(self.lift_points(self.points[self.simplices]), 1, 0)
        normals = -np.cross(b - a, c - a)
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        return np.column_stack([normals, -(normals * a).sum(axis=1)])

    def find_simplex(self, xi: ArrayLike, bruteforce: bool = False, tol: float | None = None) -> Ints:
        """The triangle that holds each position, exactly, of several the lowest; -1 outside. tol does not matter."""
        positions = np.asarray(xi)
        if positions.ndim == 0:
            raise IndexError("a position has two coordinates")
        if positions.shape[-1] != 2:
            raise ValueError(f"positions have two coordinates, not {positions.shape[-1]}")
        found = self._found.locate(positions.astype(np.float64), non_finite="ignore")
        return np.asarray(found, np.int32)

    def lift_points(self, x: ArrayLike) -> NDArray[np.float64]:
        """Positions on the paraboloid."""
        rows = np.asarray(x, np.float64)
        return np.concatenate([rows, (rows * rows).sum(axis=-1, keepdims=True)], axis=-1)

    def plane_distance(self, xi: ArrayLike) -> NDArray[np.float64]:
        """The distance of each lifted position from the plane of each lifted triangle."""
        lifted = self.lift_points(xi)
        return np.asarray(lifted @ self.equations[:, :3].T + self.equations[:, 3])


class Voronoi(_OfPlane):
    """The Voronoi diagram of points in the plane, with unbounded cells, as scipy.spatial.Voronoi.

    Attributes
    ----------
    points, ndim, npoints, min_bound, max_bound
        as given; bounds of all points
    vertices : ndarray of k by 2
        where three cells or more meet, exactly; each coordinate rounded once
    ridge_points : ndarray of m by 2
        the points between which each side is, the lower id first
    ridge_vertices : list of m pairs
        its ends, -1 first where it has no end
    ridge_dict : dict
        of pairs of points, the lower id first, the ends of the side between them
    regions : list of lists
        first an empty one, as scipy has it unless qhull_options lack "Qz"; then of each cell the vertices,
        counter-clockwise, -1 where it is open
    point_region : ndarray of npoints
        the region of each point; of those at another's position, the other's
    """

    _facets = "polygons"

    @cached_property
    def vertices(self) -> Rows:
        return self._diagram.vertices.copy()

    @cached_property
    def ridge_points(self) -> Ints:
        return self._diagram.ridge_points.astype(np.int32)

    @cached_property
    def ridge_vertices(self) -> list[list[int]]:
        found: list[list[int]] = self._diagram.ridge_vertices.tolist()
        return found

    @cached_property
    def ridge_dict(self) -> dict[tuple[int, int], list[int]]:
        return dict(zip(map(tuple, self.ridge_points.tolist()), self.ridge_vertices))

    @cached_property
    def regions(self) -> list[list[int]]:
        opened = zip(lists_of(self._diagram.cells), self._diagram.is_open.tolist())
        return [[] for _ in range(self._extra)] + [[-1] * is_open + region for region, is_open in opened]

    @cached_property
    def point_region(self) -> Ints:
        return (self._diagram.cell_of + self._extra).astype(np.int32)

    @property
    def _extra(self) -> int:
        """How many regions are none: those of hidden points are that."""
        return int(self.furthest_site or "Qz" in (self._options or "Qz"))

    @cached_property
    def _diagram(self) -> VoronoiDiagram:
        return self._found.voronoi_diagram()


def tsearch(tri: Delaunay, xi: ArrayLike) -> Ints:
    """tri.find_simplex(xi)."""
    return tri.find_simplex(xi)


def _rows_of(points: Any) -> Rows:
    """As scipy takes them: doubles, a copy, finite."""
    if np.ma.isMaskedArray(points):
        raise ValueError("Input points cannot be a masked array")
    if not is_array_like(points):
        raise TypeError(f"points are an array of n by 2 or n by 3 numbers, not {points!r}")
    if np.iscomplexobj(points):
        raise TypeError("points are real numbers, not complex ones")
    rows = np.array(points, np.float64, order="C")
    if rows.ndim != 2:
        raise ValueError(f"points are rows of numbers: an array of 2 dimensions, not {rows.ndim}")
    if rows.shape[1] < 2:
        raise ValueError("Need at least 2-D data")
    if np.isnan(rows).any():
        raise ValueError("Points cannot contain NaN")
    if not np.isfinite(rows).all():
        raise ValueError("Points cannot contain infinity")
    return rows


def _flat(dimension: int, space: int, count: int) -> str:
    what = {-1: "there is no other point", 0: "all points are at one position", 1: "all points are on a line"}
    found = what.get(dimension, "all points are in one plane")
    in_qhulls_words = "QH6154 Qhull precision error: Initial simplex is flat"  # that programs look for
    return f"{found}: {count} points span less than {space} dimensions ({in_qhulls_words})"
