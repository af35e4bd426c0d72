# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Centroidal cells and cells of prescribed areas of PyVista's meshes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _vtkmodules as vtk
from ._arguments import Weights, flag_of, threads_of
from ._meshes import Block, Cloud, is_tree, set_cells
from ._pyvista import Output, data_of, each_block
from ._results import Progress, Report
from ._transport import CentroidalCells, PrescribedAreas
from ._transport import centroidal_cells as cells_of_arrays
from ._transport import prescribed_areas as areas_of_arrays


def centroidal_cells(
    mesh: Any,
    weights: ArrayLike | str | None = None,
    *,
    domain: Any = None,
    bounds: ArrayLike | None = None,
    iterations: int = 100,
    tolerance: float = 0.0,
    threads: int = 0,
    skip_ghost_points: bool = True,
    pass_point_data: bool = True,
    progress: Progress = None,
) -> Output:
    """Centroidal power cells by Lloyd's algorithm: in each iteration, every point moves to the centroid of its cell.

    Parameters
    ----------
    mesh : data set, composite, or n by 3 or n by 2 coordinates
        its points are the sites at first, by x and y; its cells do not matter
    weights : str or n numbers, optional
        a point array's name, or numbers if mesh is no composite: squared lengths, which stay. By default none.
    domain, bounds
        where cells end, as power_diagram() takes them
    iterations : int
        at most so many, 0 or more
    tolerance : float
        a length, 0 or more: it ends when no site moved further in an iteration
    threads : int
        0: as many as the machine has. The result never depends on it.
    skip_ghost_points : bool
        leave out points that "vtkGhostType" marks as another piece's or as blanked
    pass_point_data : bool
        whether the points' data is passed, as cell data
    progress : callable, bool or None
        called with the fraction that is done, 0 to 1, now and then; if it returns False, the call ends with an
        AbortedError. True shows tqdm's bar.

    Returns
    -------
    pyvista.PolyData
        a polygon for each site that has a cell, at the lowest z of the points. Cell arrays: Area, Centroid, Site (where
        the site is in the end), vtkOriginalPointIds. Field data: Iterations, Converged. Or a composite of these.
    """
    sites = _Sites("weights", weights, skip_ghost_points, pass_point_data)
    settings = dict(
        domain=domain, bounds=bounds, iterations=iterations, tolerance=tolerance, threads=threads_of(threads)
    )

    def add_site(found: CentroidalCells, cells: Any, cloud: Cloud) -> None:
        _add(cells.GetCellData(), "Site", _in_space(cloud, found.sites[found.diagram.sites]))

    return sites.cells(mesh, cells_of_arrays, settings, add_site, progress)


def prescribed_areas(
    mesh: Any,
    areas: ArrayLike | str | None = None,
    *,
    domain: Any = None,
    bounds: ArrayLike | None = None,
    tolerance: float = 1e-6,
    iterations: int = 100,
    threads: int = 0,
    skip_ghost_points: bool = True,
    pass_point_data: bool = True,
    progress: Progress = None,
) -> Output:
    """The power cells with which each point has its prescribed area of the domain.

    The cells are the optimal transport of the domain to the points for the squared distance. The method is a damped
    Newton method (J. Kitagawa, Q. Merigot, B. Thibert, JEMS 2019).

    Parameters
    ----------
    mesh : data set, composite, or n by 3 or n by 2 coordinates
        its points are the sites, by x and y, no two at the same position; its cells do not matter
    areas : str or n positive numbers, optional
        a point array's name, or numbers if mesh is no composite: shares, which are scaled such that they sum to the
        domain's area. By default all are equal.
    tolerance : float
        0 or more: it ends when each area is met to that, relative to itself
    domain, bounds, iterations, threads, skip_ghost_points, pass_point_data, progress
        as for centroidal_cells()

    Returns
    -------
    pyvista.PolyData
        a polygon for each point, at the lowest z of the points. Cell arrays: Area, Centroid, Weight (with which the
        power diagram has these cells), vtkOriginalPointIds. Field data: Iterations, Converged. Or a composite of these.
    """
    sites = _Sites("areas", areas, skip_ghost_points, pass_point_data)
    settings = dict(
        domain=domain, bounds=bounds, iterations=iterations, tolerance=tolerance, threads=threads_of(threads)
    )

    def add_weight(found: PrescribedAreas, cells: Any, _: Cloud) -> None:
        _add(cells.GetCellData(), "Weight", found.weights[found.diagram.sites])

    return sites.cells(mesh, areas_of_arrays, settings, add_weight, progress)


class _Sites:
    """A mesh's points as sites, a number for each, and what is to become of both."""

    def __init__(self, name: str, numbers: Any, skip_ghosts: bool, pass_data: bool) -> None:
        self._name = name
        self._numbers = numbers
        self._skip_ghosts = flag_of("skip_ghost_points", skip_ghosts)
        self._pass_data = flag_of("pass_point_data", pass_data)

    def cells(
        self,
        mesh: Any,
        call: Callable[..., Any],
        settings: dict[str, Any],
        add: Callable[[Any, Any, Cloud], None],
        progress: Progress,
    ) -> Output:
        """The cells that call() of arrays finds for each block, with one more array that add() adds."""
        data = data_of(mesh)
        if self._numbers is not None and not isinstance(self._numbers, str) and is_tree(data):
            raise TypeError(f"the {self._name} of a composite are the name of a point array")

        def made(block: Block, report: Report) -> list[Any]:
            cloud = Cloud([block], self._skip_ghosts, False)
            numbers = cloud.weights(Weights(self._numbers, False, 1.0), False)
            found = cloud.engine(lambda: call(cloud.array, numbers, progress=report, **settings))
            cells = _cells_of(cloud, found, self._pass_data)
            add(found, cells, cloud)
            return [cells]

        return each_block(data, made, 1, progress)[0]


def _cells_of(cloud: Cloud, found: CentroidalCells | PrescribedAreas, pass_data: bool) -> Any:
    diagram = found.diagram
    made = vtk.vtkPolyData()
    made.SetPoints(vtk.points_of(_in_space(cloud, diagram.vertices), False))
    set_cells(made, 2, 0, np.array(diagram.cells.offsets), np.array(diagram.cells.connectivity))
    cloud.pass_data(cloud.ids(diagram.sites), made, "cell", pass_data)
    _add(made.GetCellData(), "Area", found.areas[diagram.sites])
    _add(made.GetCellData(), "Centroid", _in_space(cloud, found.centroids[diagram.sites]))
    _add(made.GetFieldData(), "Iterations", np.array([found.iterations]))
    _add(made.GetFieldData(), "Converged", np.array([found.converged], np.uint8))
    return made


def _in_space(cloud: Cloud, positions: NDArray[Any]) -> NDArray[np.float64]:
    """Places of the plane at the lowest z of the points."""
    height = cloud.array[:, 2].min() if cloud.array.shape[1] == 3 and len(cloud.array) else 0.0
    return np.column_stack([positions, np.full(len(positions), height, np.float64)])


def _add(attributes: Any, name: str, values: NDArray[Any]) -> None:
    attributes.AddArray(vtk.array_of(values, name))
