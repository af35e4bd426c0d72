# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Voronoi diagrams on a sphere, by the name and arguments of scipy.spatial.SphericalVoronoi."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import InputError
from ._fallback import WithFallback
from ._input import doubles_of
from ._rings import lists_of
from ._spherical import spherical_triangulation

Rows = NDArray[np.float64]


class SphericalVoronoi(WithFallback):
    """The Voronoi diagram of points on a sphere, as scipy.spatial.SphericalVoronoi.

    Which cells meet is that of the points as they are given, exactly; positions and areas are rounded.

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
        on the sphere, one for each facet of the hull
    regions : list of lists
        of each cell the vertices, counter-clockwise from outside

    Raises
    ------
    ValueError
        as scipy's: generators that are duplicates, off the sphere, or all in one plane
    """

    @classmethod
    def _why_not(cls, points: Any, *arguments: Any, **settings: Any) -> str:
        return "" if np.ndim(points) == 2 and np.shape(points)[1] == 3 else "points are n by 3 here"

    def __init__(
        self,
        points: ArrayLike,
        radius: float = 1.0,
        center: ArrayLike | None = None,
        threshold: float = 1e-06,
        *,
        fallback: bool = False,
    ) -> None:
        self._check(points)
        if radius is None:
            raise ValueError("`radius` is `None`. Please provide a floating point number (i.e. `radius=1`).")
        self.points, self.radius = np.array(doubles_of(points, "points")), float(radius)
        self.center = np.zeros(3) if center is None else np.array(doubles_of(center, "center"))
        try:
            found = spherical_triangulation(self.points, center=self.center, radius=self.radius, threshold=threshold)
        except InputError as error:
            if error.code == "off_sphere":
                raise ValueError("Radius inconsistent with generators.") from error
            if error.code == "flat":
                raise ValueError("Rank of input points must be at least 3.") from error
            raise
        if len(found.hidden) or _least_distance(self.points, found.edges) < threshold * self.radius:
            raise ValueError("Duplicate generators present.")
        self._diagram = found.voronoi_diagram()
        self._simplices = found.simplices.copy()  # scipy's name, which its tests read
        self.vertices: Rows = self._diagram.vertices.copy()
        self.regions = lists_of(self._diagram.cells)

    def sort_vertices_of_regions(self) -> None:
        """They are in order."""

    def calculate_areas(self) -> Rows:
        """The area of each cell; their sum is that of the sphere."""
        return self._diagram.areas.copy()


def _least_distance(points: Rows, edges: Any) -> float:
    """Of neighbours, among which the nearest of all are."""
    return float(np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1).min())
