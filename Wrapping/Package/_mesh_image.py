# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Images of values between the points of PyVista's meshes."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
import pyvista as pv
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import choice_of, flag_of, float_of, threads_of
from ._errors import InputError
from ._image import METHODS, Method, grid_of, image_of
from ._input import values_of as numbers_of
from ._mesh_runs import split
from ._meshes import Cloud, Part, blocks_of, is_tree
from ._pyvista import data_of
from ._results import QUIET, NonFinite, Progress, ignores, report_of
from ._vtkmodules import values_of


def to_image(
    mesh: Any,
    values: ArrayLike | str | None = None,
    *,
    spacing: ArrayLike | None = None,
    shape: tuple[int, int] | None = None,
    bounds: ArrayLike | None = None,
    method: Method = "linear",
    fill_value: float = np.nan,
    threads: int = 0,
    non_finite: NonFinite = "error",
    skip_ghost_points: bool = True,
    progress: Progress = None,
) -> pv.ImageData:
    """An image (raster) of values between a mesh's points, over their Delaunay triangulation by x and y.

    Give spacing or shape. The values are those of RegularTriangulation.to_image() of vtkflipflop.arrays.

    Parameters
    ----------
    mesh : data set, or n by 3 or n by 2 coordinates
        its cells do not matter
    values : str or n numbers or rows, optional
        a point array's name, or numbers; by default the heights z, as "Elevation"
    spacing : number, or two
        from a point of the image to the next one. The image's points are the centers of pixels, which begin at the left
        and at the top of the bounds; as many as cover these, but for a millionth of a pixel.
    shape : two integers
        rows and columns of pixels, which divide the bounds
    bounds : 2 corners, or 4 numbers, optional
        ((x0, y0), (x1, y1)), or in VTK's order (x0, x1, y0, y1). By default the box of the points. Of shapely's order,
        as power_diagram(bounds=) takes it, pass numpy.reshape(bounds, (2, 2)).
    method : {"linear", "natural", "clough-tocher", "laplace"}
        as for RegularTriangulation.interpolate(): that of "clough-tocher" has the least error where values are smooth
    fill_value : float
        what there is outside the convex hull of the points
    threads : int
        0: as many as the machine has. The result never depends on it.
    non_finite : {"error", "ignore"}
        what NaN and infinity in coordinates lead to: an InputError, or that these points are left out
    skip_ghost_points : bool
        leave out points that "vtkGhostType" marks as another piece's or as blanked
    progress : callable, bool or None
        called with the fraction that is done, 0 to 1, now and then; if it returns False, the call ends with an
        AbortedError. True shows tqdm's bar.

    Returns
    -------
    pyvista.ImageData
        of one layer, at z = 0, with the values as a point array of the same name ("values" of numbers)
    """
    name = choice_of("method", method, METHODS)
    count = threads_of(threads)
    fill = float_of("fill_value", fill_value)
    data = data_of(mesh)
    if is_tree(data):
        raise TypeError("an image is made of one data set: combine the blocks of a composite first")
    block = blocks_of(data)[0]
    assert block is not None
    part = block.checked().part
    cloud = Cloud([block], flag_of("skip_ghost_points", skip_ghost_points), ignores(non_finite))
    label, given = _values_of(part, cloud, values)
    with report_of(progress) as report:
        first, second = split(report, 0.4)
        settings = partial(_core.Settings, count, False, cloud.left_out, 1)
        core = cloud.engine(_core.regular_triangulation, cloud.array, None, settings(first))
        queries = _core.triangulation_queries(cloud.array, None, core, QUIET)
        sites = np.asarray(cloud.array[core.vertices(), :2], float)
        image = image_of(
            lambda *arguments: queries.image(name, *arguments, settings(second)),
            given, len(cloud.array), grid_of(sites, spacing, shape, bounds), fill, None,
        )
    made = pv.ImageData(
        dimensions=(len(image.x), len(image.y), 1),
        spacing=(image.transform[0], -image.transform[4], 1.0),
        origin=(image.x[0], image.y[-1], 0.0),
    )
    size = (made.n_points, *image.array.shape[2:])
    made.point_data[label] = np.ascontiguousarray(image.array[::-1]).reshape(size)  # from the south on
    return made


def _values_of(part: Part | None, cloud: Cloud, values: Any) -> tuple[str, NDArray[Any]]:
    """The array's name, and its values at the points that the engine reads."""
    if values is None:
        if cloud.array.shape[1] < 3:
            raise InputError("points of two coordinates have no heights: give values", "bad_argument")
        return "Elevation", cloud.array[:, 2]
    ids = cloud.ids(np.arange(len(cloud.array)))
    if not isinstance(values, str):
        return "values", numbers_of(values, cloud.count)[ids]
    array = None if part is None or part.data is None else part.data.GetArray(values)
    if array is None:
        raise InputError(f'the point array "{values}" is missing, or holds no numbers', "bad_argument")
    return values, values_of(array)[ids]
