# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Voronoi diagrams on a sphere: the facets of the hull of directions are where cells meet (K. Q. Brown, 1979)."""

from __future__ import annotations

from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._hull import convex_hull
from ._input import doubles_of
from ._results import Polygons
from ._rings import lists_of, polygons_around, sides_of

Rows = NDArray[np.float64]


class SphericalVoronoi:
    """The Voronoi diagram of points on a sphere, as scipy.spatial.SphericalVoronoi.

    Which cells meet is that of the points as they are rounded, exactly; positions and areas are rounded.

    Parameters
    ----------
    points : n by 3
        at most threshold * radius off the sphere, and no two at one position
    radius : float
    center : 3 numbers, optional
        by default the origin
    threshold : float
    fallback : bool
        of points that are not n by 3, scipy's own object

    Attributes
    ----------
    points, radius, center
        as given
    vertices : ndarray of k by 3
        on the sphere, one for each triangle of the hull
    regions : list of lists
        of each cell the vertices, counter-clockwise from outside

    Raises
    ------
    ValueError
        as scipy's: generators that are duplicates, off the sphere, or all in one plane
    """

    def __new__(cls, points: ArrayLike, *arguments: Any, fallback: bool = False, **settings: Any) -> Any:
        """With fallback, scipy's own object of a circle, or of a sphere in more dimensions."""
        if np.ndim(points) == 2 and np.shape(points)[1] == 3:
            return super().__new__(cls)
        if not fallback:
            sentence = "points are n by 3 here: of others, take scipy.spatial.SphericalVoronoi, or pass fallback=True"
            raise NotImplementedError(sentence)
        return import_module("scipy.spatial").SphericalVoronoi(points, *arguments, **settings)

    def __init__(
        self,
        points: ArrayLike,
        radius: float = 1.0,
        center: ArrayLike | None = None,
        threshold: float = 1e-06,
        *,
        fallback: bool = False,
    ) -> None:
        if radius is None:
            raise ValueError("`radius` is `None`. Please provide a floating point number (i.e. `radius=1`).")
        self.points, self.radius = np.array(doubles_of(points, "points")), float(radius)
        self.center = np.zeros(3) if center is None else np.array(doubles_of(center, "center"))
        directions = self.points - self.center
        off = np.abs(np.linalg.norm(directions, axis=1) - self.radius)
        if off.max(initial=0.0) >= self.radius * threshold:
            raise ValueError("Radius inconsistent with generators.")
        hull = convex_hull(directions)
        if hull.dimension < 3:
            raise ValueError(f"Rank of input points must be at least 3: they span {hull.dimension}")
        if len(hull.vertices) < len(directions) or _least_distance(directions, hull.edges) < threshold * self.radius:
            raise ValueError("Duplicate generators present.")
        self._simplices = hull.simplices.astype(np.int64)
        self.vertices: Rows = self.radius * hull.equations[:, :3] + self.center
        triangles = Polygons(np.arange(0, self._simplices.size + 1, 3), self._simplices.ravel())
        self.regions = lists_of(polygons_around(sides_of(triangles), len(directions))[0])

    def sort_vertices_of_regions(self) -> None:
        """They are in order."""

    def calculate_areas(self) -> Rows:
        """The area of each cell; their sum is that of the sphere."""
        sizes = np.array([len(region) for region in self.regions])
        ids = np.concatenate([np.array(region, np.int64) for region in self.regions])
        begins = np.concatenate([[0], np.cumsum(sizes)])
        onward = np.arange(1, len(ids) + 1)
        onward[begins[1:] - 1] = begins[:-1]
        unit = (self.vertices - self.center) / self.radius
        site = np.repeat((self.points - self.center) / self.radius, sizes, axis=0)
        a, b = unit[ids], unit[ids[onward]]
        # The solid angle of a triangle (A. van Oosterom, J. Strackee, 1983).
        volume = (site * np.cross(a, b)).sum(axis=1)
        rest = 1 + (site * a).sum(axis=1) + (a * b).sum(axis=1) + (b * site).sum(axis=1)
        return self.radius**2 * np.add.reduceat(2 * np.arctan2(volume, rest), begins[:-1])


def _least_distance(points: Rows, edges: Any) -> float:
    """Of neighbours, among which the nearest of all are."""
    return float(np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1).min())

