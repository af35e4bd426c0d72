# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cells whose sites are centroids, and cells of prescribed areas, of arrays."""

from __future__ import annotations

from functools import cached_property
from operator import index
from typing import Any, ClassVar, Self

from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import float_of
from ._domain import Domain, domain_of_call
from ._errors import InputError
from ._input import doubles_of, whole_points_of, whole_weights_of
from ._power_diagram import PowerDiagram
from ._results import Floats, Frozen, Progress, named, run, settings
from ._triangulation import regular_triangulation


class CentroidalCells(Frozen):
    """Sites after some steps of Lloyd's algorithm, and their cells.

    Attributes
    ----------
    sites : ndarray of n by 2
        where the sites are in the end
    diagram : PowerDiagram
        the cells of the sites there
    areas : ndarray of n
        of each site's cell; 0: it has none
    centroids : ndarray of n by 2
        of each site's cell; of a site without one, its position
    iterations : int
        how often the sites moved
    last_move : float
        how far a site moved at most in the last of these, a length
    converged : bool
        whether that was the tolerance at most
    without_cell : int
        how many sites have no cell in the domain in the end
    statistics : dict
        counts and seconds of all triangulations, and seconds_total of the whole call
    """

    sites: Floats
    diagram: PowerDiagram
    areas: Floats
    centroids: Floats
    iterations: int
    last_move: float
    converged: bool
    without_cell: int
    statistics: dict[str, float]
    _call: ClassVar[str] = "centroidal_cells(points)"

    @classmethod
    def _made(cls, core: Any) -> Self:
        return cls._of(
            sites=core.sites(),
            diagram=PowerDiagram._of(_core=core.cells()),
            areas=core.areas(),
            centroids=core.centroids(),
            iterations=core.iterations,
            last_move=core.last_move,
            converged=core.converged,
            without_cell=core.without_cell,
            statistics=named(core.statistics),
        )

    def __len__(self) -> int:
        return len(self.sites)

    def __repr__(self) -> str:
        state = "converged" if self.converged else "not converged"
        return f"<CentroidalCells of {len(self)} sites: {self.iterations} iterations, {state}>"


class PrescribedAreas(Frozen):
    """Weights that give power cells prescribed areas, and what they give.

    Attributes
    ----------
    points : ndarray
        the caller's sites, as the engine reads them
    weights : ndarray of n
        one for each site, the least of them 0, for regular_triangulation() and power_diagram()
    areas : ndarray of n
        of each site's cell with these weights
    centroids : ndarray of n by 2
        of each site's cell
    iterations : int
        steps of Newton's method
    error : float
        greatest abs(area - prescribed area) / prescribed area
    converged : bool
        whether that is within the tolerance
    statistics : dict
        counts and seconds of all triangulations; seconds_triangulating, seconds_measuring and seconds_solving; and
        seconds_total of the whole call
    """

    points: NDArray[Any]
    weights: Floats
    areas: Floats
    centroids: Floats
    iterations: int
    error: float
    converged: bool
    statistics: dict[str, float]
    _domain: Domain
    _call: ClassVar[str] = "prescribed_areas(points)"

    @classmethod
    def _made(cls, points: NDArray[Any], domain: Domain, core: Any) -> Self:
        return cls._of(
            points=points,
            weights=core.weights(),
            areas=core.areas(),
            centroids=core.centroids(),
            iterations=core.iterations,
            error=core.error,
            converged=core.converged,
            statistics=named(core.statistics),
            _domain=domain,
        )

    @cached_property
    def diagram(self) -> PowerDiagram:
        """The cells: those of the points with these weights, cut at the domain."""
        return regular_triangulation(self.points, self.weights, facets="polygons").power_diagram(self._domain.array)

    def __len__(self) -> int:
        return len(self.weights)

    def __repr__(self) -> str:
        state = "converged" if self.converged else "not converged"
        return f"<PrescribedAreas of {len(self)} sites: {self.iterations} iterations, error {self.error:.1e}, {state}>"


def centroidal_cells(
    points: ArrayLike,
    weights: ArrayLike | None = None,
    domain: Any = None,
    *,
    bounds: ArrayLike | None = None,
    iterations: int = 100,
    tolerance: float = 0.0,
    threads: int = 0,
    progress: Progress = None,
) -> CentroidalCells:
    """Centroidal power cells by Lloyd's algorithm: in each iteration, every site moves to the centroid of its cell.

    A site outside of the domain moves in if it has a cell there. A site without a cell stays where it is; it may get
    one when others move.

    Parameters
    ----------
    points : n by 2, or n by 3
        the sites at first, at any positions; x and y count
    weights : n numbers, optional
        as regular_triangulation() takes them; they stay. By default none: Voronoi cells.
    domain, bounds
        where cells end, as power_diagram() takes them. The area must be a normal double, 2.3e-308 to 1.7e308.
    iterations : int
        at most so many, 0 or more
    tolerance : float
        a length, 0 or more: it ends when no site moved further in an iteration
    threads, progress
        see the module
    """
    array = whole_points_of(points)
    weight_array = None if weights is None else whole_weights_of(weights)
    within = domain_of_call(domain, bounds)
    chosen = settings(threads, "triangles", "error", "cpu", progress, False)
    limits = _count(iterations), _tolerance(tolerance)
    with within.named():
        core = run(chosen, _core.centroidal_cells, array, weight_array, within.array, *limits)
    return CentroidalCells._made(core)


def prescribed_areas(
    points: ArrayLike,
    areas: ArrayLike | None = None,
    domain: Any = None,
    *,
    bounds: ArrayLike | None = None,
    tolerance: float = 1e-6,
    iterations: int = 100,
    threads: int = 0,
    progress: Progress = None,
) -> PrescribedAreas:
    """The weights with which each point's power cell in the domain has its prescribed area.

    The cells are the optimal transport of the domain to the points for the squared distance. The method is a damped
    Newton method (J. Kitagawa, Q. Merigot, B. Thibert, JEMS 2019).

    Parameters
    ----------
    points : n by 2, or n by 3
        the sites, at any positions, no two at the same; x and y count
    areas : n positive numbers, optional
        shares, which are scaled such that they sum to the domain's area. By default all are equal.
    domain, bounds
        as for centroidal_cells()
    tolerance : float
        0 or more: it ends when each area is met to that, relative to itself
    iterations : int
        at most so many, 0 or more
    threads, progress
        see the module
    """
    array = whole_points_of(points)
    shares = None
    if areas is not None:
        shares = doubles_of(areas, "areas")
        if shares.ndim != 1:
            raise ValueError(f"areas are n numbers, one for each point, not an array of shape {shares.shape}")
        if len(shares) != len(array):
            text = f"there are {len(shares)} areas for {len(array)} points"
            raise InputError(text, "weight_count", len(array), len(shares))
    within = domain_of_call(domain, bounds)
    chosen = settings(threads, "triangles", "error", "cpu", progress, False)
    limits = _tolerance(tolerance), _count(iterations)
    with within.named():
        core = run(chosen, _core.prescribed_areas, array, shares, within.array, *limits)
    return PrescribedAreas._made(array, within, core)


def _count(iterations: int) -> int:
    try:
        number = index(iterations)
    except TypeError:
        raise TypeError(f"iterations is an integer, not {iterations!r}") from None
    if not 0 <= number < 2**63:
        raise ValueError(f"iterations is 0 or more, not {iterations}")
    return number


def _tolerance(tolerance: float) -> float:
    number = float_of("tolerance", tolerance)
    if not number >= 0:
        raise ValueError(f"tolerance is 0 or more, not {tolerance!r}")
    return number
