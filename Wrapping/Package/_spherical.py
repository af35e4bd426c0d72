# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Triangulations and Voronoi diagrams on a sphere: the hull's facets are where cells meet (K. Q. Brown, 1979)."""

from __future__ import annotations

from functools import cached_property
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import flag_of, number_of, numbers_of
from ._directions import arc_angles, directions_of, solid_angles
from ._errors import InputError
from ._hull import ConvexHull, convex_hull
from ._input import points_of, refuse
from ._queries import finite, unchanged
from ._results import QUIET, Engine, Floats, Frozen, Ids, NonFinite, Polygons, Progress, frozen, ignores
from ._rings import Sides, polygons_around, sides_of


class SphericalTriangulation(Frozen):
    """The Delaunay triangulation of points on a sphere.

    It is the hull of the points as they are given, exactly. Points on a sphere are rounded, so of several on one circle
    rounding decides which triangles they have.

    Attributes
    ----------
    points : ndarray of n by 3
        the caller's points, as the engine reads them; with lonlat, their positions
    center : ndarray of 3
    radius : float
    hull : ConvexHull
        of the points
    """

    points: NDArray[Any]
    center: Floats
    radius: float
    hull: ConvexHull
    _call: ClassVar[str] = "spherical_triangulation(points)"

    @property
    def simplices(self) -> Ids:
        """The triangles as rows of ids, counter-clockwise from outside; facets of more corners as fans."""
        return self.hull.simplices

    @property
    def neighbors(self) -> Ids:
        """For each corner of each of `simplices` the triangle opposite to it."""
        return self.hull.neighbors

    @property
    def vertices(self) -> Ids:
        """Ids of the points that appear, ascending."""
        return self.hull.vertices

    @cached_property
    def hidden(self) -> Ids:
        """Ids of the points that do not appear, ascending: duplicates, and what rounding puts beneath the hull."""
        are_hidden = np.isfinite(self.points).all(axis=1)
        are_hidden[self.vertices] = False
        return frozen(np.flatnonzero(are_hidden))

    @property
    def edges(self) -> Ids:
        """The edges of `simplices`, each once, as ids, the lower one first; in lexicographic order."""
        return self.hull.edges

    @cached_property
    def edge_lengths(self) -> Floats:
        """The length of the arc of each of `edges` on the sphere, rounded."""
        begins, ends = np.moveaxis(self._positions(self.edges), 1, 0)
        return frozen(self.radius * arc_angles((begins - self.center) / self.radius, (ends - begins) / self.radius))

    @cached_property
    def areas(self) -> Floats:
        """The area of each of `simplices` on the sphere, rounded.

        They sum to the area of the sphere if the hull has the center in it. If all points are in one half of the
        sphere, they sum to 0: triangles of the other half have their outside towards the center, and negative areas. An
        edge through the center is no arc: then the two triangles at it have equal areas.
        """
        angles = solid_angles(self._positions(self.simplices), self.center, self.radius)
        are_open = np.isnan(angles)
        angles[are_open] = (4 * np.pi - angles[~are_open].sum()) / 2
        return frozen(self.radius**2 * angles)

    def voronoi_diagram(self) -> SphericalDiagram:
        """The Voronoi diagram of the points that appear."""
        return SphericalDiagram._of(triangulation=self)

    def __repr__(self) -> str:
        return f"<SphericalTriangulation of {len(self.points)} points: {len(self.simplices)} triangles>"

    def _positions(self, ids: Ids) -> Floats:
        found: Floats = finite(self.points, ids)[ids].astype(np.float64)
        return found


class SphericalDiagram(Frozen):
    """The Voronoi diagram of points on a sphere. All sides are arcs of great circles.

    Which cells meet is that of the points as they are given, exactly; positions, lengths and areas are rounded. Names
    are those of scipy.spatial.Voronoi and SphericalVoronoi.

    Attributes
    ----------
    triangulation : SphericalTriangulation
        whose dual this is: with `points`, `center`, `radius` and `hidden`
    """

    triangulation: SphericalTriangulation
    _call: ClassVar[str] = "spherical_voronoi(points)"

    @cached_property
    def vertices(self) -> Floats:
        """Where three cells or more meet, as rows of x, y and z on the sphere: one for each facet of the hull."""
        return frozen(self.triangulation.center + self.triangulation.radius * self._normals)

    @cached_property
    def cells(self) -> Polygons:
        """The vertices of each cell, counter-clockwise from outside."""
        found, _ = polygons_around(self._sides, len(self.sites))
        frozen(found.offsets), frozen(found.connectivity)
        return found

    @property
    def regions(self) -> list[Ids]:
        """`cells` as a list, by scipy's name."""
        return list(self.cells)

    @property
    def sites(self) -> Ids:
        """The id of each cell's point, ascending."""
        return self.triangulation.vertices

    @cached_property
    def areas(self) -> Floats:
        """The area of each cell, rounded. They sum to that of the sphere."""
        points, (begins, ends) = self.triangulation._positions(self.ridge_points), self._angles
        center, radius = self.triangulation.center, self.triangulation.radius
        apart = arc_angles((points[:, 0] - center) / radius, (points[:, 1] - points[:, 0]) / radius)
        # Of the triangle of a site and a side, from the foot of the site to both ends: each has a right angle.
        height = np.tan(apart / 4)
        parts = 2 * np.arctan(height * np.tan(ends / 2)) - 2 * np.arctan(height * np.tan(begins / 2))
        parts[ends - begins < -np.pi] += 2 * np.pi
        pairs = np.searchsorted(self.sites, self.ridge_points)
        one, other = (np.bincount(column, parts, len(self.sites)) for column in pairs.T)
        return frozen(radius**2 * (one + other))

    @property
    def ridge_points(self) -> Ids:
        """The two points between which each side is, the lower id first."""
        return self._ridges[0]

    @property
    def ridge_vertices(self) -> Ids:
        """The two ends of each side, as rows of `vertices`: first that on the right, seen from the first point."""
        return self._ridges[1]

    @cached_property
    def ridge_lengths(self) -> Floats:
        """The length of each side, rounded."""
        begins, ends = self._angles
        angles = ends - begins
        angles[angles < -np.pi] += 2 * np.pi
        return frozen(self.triangulation.radius * np.abs(angles))

    @cached_property
    def cell_of(self) -> Ids:
        """For each point the row of its cell; of a hidden one, of the cell that its position is in, rounded.

        A point at the position of others has the cell of theirs. -1: the point is not finite and ignored.
        """
        given = self.triangulation
        found, hidden = np.full(len(given.points), -1), given.hidden
        found[self.sites] = np.arange(len(self.sites))
        if len(hidden):
            nearest = given.hull.support(given.points[hidden] - given.center)
            positions = np.concatenate([given.points[self.sites], given.points[hidden]])
            _, first, which = np.unique(positions + 0.0, axis=0, return_index=True, return_inverse=True)
            same = first[which.ravel()[len(self.sites) :]]
            is_site = same < len(self.sites)
            found[hidden] = np.where(is_site, same, found[np.asarray(nearest)])
        return frozen(found)

    def __len__(self) -> int:
        return len(self.sites)

    def __repr__(self) -> str:
        return f"<SphericalDiagram: {len(self)} cells, {len(self.vertices)} vertices>"

    @cached_property
    def _normals(self) -> Floats:
        hull = self.triangulation.hull
        with unchanged():
            planes: Floats = _core.facet_planes(hull.points, hull._core, QUIET)[:, :3]
        return planes

    @cached_property
    def _sides(self) -> Sides:
        """The sides of the hull's facets; ends are rows of `sites`."""
        core = self.triangulation.hull._core
        return sides_of(Polygons(core.offsets(), core.connectivity()))

    @cached_property
    def _ridges(self) -> tuple[Ids, Ids]:
        chosen = self._sides.tails < self._sides.heads
        tails, heads, facets, twins = (column[chosen] for column in self._sides)
        ends = np.column_stack([self._sides.polygons[twins], facets])
        return frozen(self.sites[np.column_stack([tails, heads])]), frozen(ends)

    @property
    def _angles(self) -> tuple[Floats, Floats]:
        """Of each side where it begins and ends on its great circle: from the middle of its two points to the left."""
        points = self.triangulation._positions(self.ridge_points)
        steps = points[:, 1] - points[:, 0]
        middle = (points[:, 0] - self.triangulation.center) + (points[:, 1] - self.triangulation.center)
        middle -= ((middle * steps).sum(axis=1) / (steps * steps).sum(axis=1))[:, None] * steps
        # Of points opposite to each other, any point of the circle.
        opposite = np.linalg.norm(middle, axis=1) < 1e-14 * self.triangulation.radius
        middle[opposite] = np.cross(steps[opposite], np.eye(3)[np.abs(steps[opposite]).argmin(axis=1)])
        left = np.cross(middle, steps)
        middle, left = (axis / np.linalg.norm(axis, axis=1)[:, None] for axis in (middle, left))
        ends = np.moveaxis(self._normals[self.ridge_vertices], 1, 0)
        begin, end = (np.arctan2((at * left).sum(axis=1), (at * middle).sum(axis=1)) for at in ends)
        return begin, end


def spherical_triangulation(
    points: ArrayLike,
    *,
    center: ArrayLike = (0.0, 0.0, 0.0),
    radius: float = 1.0,
    lonlat: bool = False,
    threshold: float = 1e-6,
    threads: int = 0,
    non_finite: NonFinite = "error",
    engine: Engine = "automatic",
    progress: Progress = None,
) -> SphericalTriangulation:
    """The Delaunay triangulation of points on a sphere.

    Parameters
    ----------
    points : n by 3, or n by 2 with lonlat
        four at least, not in one plane
    center : 3 numbers
    radius : float, more than 0
    lonlat : bool
        whether points are rows of longitude and latitude in degrees: they are put on the sphere by directions_of()
    threshold : float, from 0 on, less than 1
        how far off the sphere a point may be, as a share of the radius
    threads, non_finite, engine, progress
        see the module

    Raises
    ------
    InputError
        names the first point that is off the sphere, or not finite; or says that the points are in one plane
    """
    middle, size = numbers_of("center", center, 3), number_of("radius", radius)
    share = number_of("threshold", threshold)
    if size <= 0:
        raise ValueError(f"radius is more than 0, not {size!r}")
    if not 0 <= share < 1:
        raise ValueError(f"threshold is a share of the radius, from 0 on and less than 1, not {share!r}")
    array, left_out = points_of(points, ignores(non_finite))
    columns = 2 if flag_of("lonlat", lonlat) else 3
    if array.shape[1] != columns:
        advice = "with lonlat=True" if lonlat else "or n by 2 with lonlat=True"
        raise ValueError(f"points of a sphere are n by {columns} {advice}, not an array of shape {array.shape}")
    if lonlat:
        array = frozen(np.array(middle) + size * directions_of(array[:, 0], array[:, 1]))
    off = np.abs(np.linalg.norm(array.astype(np.float64) - middle, axis=1) - size)
    sentence = f"a point is farther off the sphere of radius {size!r} than by {share!r} of that"
    refuse(off > size * share, sentence, "off_sphere")
    hull = convex_hull(
        array,
        facets="polygons",
        threads=threads,
        non_finite="ignore" if left_out else "error",
        engine=engine,
        progress=progress,
    )
    if hull.dimension < 3:
        sentence = "points of a sphere are four at least that are not in one plane"
        raise InputError(f"{sentence}: these span {max(hull.dimension, 0)} dimensions", "flat")
    return SphericalTriangulation._of(points=array, center=frozen(np.array(middle)), radius=size, hull=hull)


def spherical_voronoi(
    points: ArrayLike,
    *,
    center: ArrayLike = (0.0, 0.0, 0.0),
    radius: float = 1.0,
    lonlat: bool = False,
    threshold: float = 1e-6,
    threads: int = 0,
    non_finite: NonFinite = "error",
    engine: Engine = "automatic",
    progress: Progress = None,
) -> SphericalDiagram:
    """The Voronoi diagram of points on a sphere; the arguments and errors are those of spherical_triangulation()."""
    return spherical_triangulation(
        points,
        center=center,
        radius=radius,
        lonlat=lonlat,
        threshold=threshold,
        threads=threads,
        non_finite=non_finite,
        engine=engine,
        progress=progress,
    ).voronoi_diagram()
