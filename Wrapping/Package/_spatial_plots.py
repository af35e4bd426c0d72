# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of hulls, triangulations and diagrams by matplotlib, by scipy.spatial's names. They return the figure."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray


def convex_hull_plot_2d(hull: Any, ax: Any = None) -> Any:
    """Draw a hull in the plane."""
    axes = _axes(ax, hull.points)
    axes.plot(hull.points[:, 0], hull.points[:, 1], "o")
    _draw_lines(axes, hull.points[hull.simplices], "solid", {})
    return axes.figure


def delaunay_plot_2d(tri: Any, ax: Any = None) -> Any:
    """Draw a triangulation."""
    axes = _axes(ax, tri.points)
    axes.plot(tri.points[:, 0], tri.points[:, 1], "o")
    _draw_lines(axes, tri.points[tri._found.edges], "solid", {})
    return axes.figure


def voronoi_plot_2d(
    vor: Any, ax: Any = None, *, show_points: bool = True, show_vertices: bool = True, **line: Any
) -> Any:
    """Draw a diagram: sides without an end are dashed, and leave the picture.

    line: line_colors, line_width, line_alpha, point_size, as scipy's
    """
    axes = _axes(ax, vor.points)
    if show_points:
        axes.plot(vor.points[:, 0], vor.points[:, 1], ".", markersize=line.get("point_size"))
    if show_vertices:
        axes.plot(vor.vertices[:, 0], vor.vertices[:, 1], "o")
    center, widths = vor.points.mean(axis=0), np.ptp(vor.points, axis=0)
    length = widths.max() ** 2 / widths.min()  # also where it is narrow
    ends = np.array(vor.ridge_vertices)
    is_open = ends[:, 0] < 0
    lines, pairs = vor.vertices[ends], vor.points[vor.ridge_points]
    steps = pairs[:, 1] - pairs[:, 0]
    normals = np.column_stack([-steps[:, 1], steps[:, 0]]) / np.linalg.norm(steps, axis=1)[:, None]
    normals *= np.sign(((pairs.mean(axis=1) - center) * normals).sum(axis=1))[:, None]
    lines[is_open, 0] = lines[is_open, 1]
    lines[is_open, 1] += (-length if vor.furthest_site else length) * normals[is_open]
    _draw_lines(axes, lines[~is_open], "solid", line)
    _draw_lines(axes, lines[is_open], "dashed", line)
    return axes.figure


def _axes(ax: Any, points: NDArray[Any]) -> Any:
    """The axes, with the points and a tenth of their width around."""
    from matplotlib import pyplot

    if points.shape[1] != 2:
        raise ValueError(f"pictures are of points in the plane, not of {points.shape[1]} coordinates")
    axes = pyplot.figure().gca() if ax is None else ax
    low, high = points.min(axis=0), points.max(axis=0)
    (left, bottom), (right, top) = low - 0.1 * (high - low), high + 0.1 * (high - low)
    axes.set_xlim(left, right)
    axes.set_ylim(bottom, top)
    return axes


def _draw_lines(axes: Any, lines: NDArray[Any], style: str, line: dict[str, Any]) -> None:
    from matplotlib.collections import LineCollection

    look = {"colors": line.get("line_colors", "k"), "lw": line.get("line_width"), "alpha": line.get("line_alpha")}
    axes.add_collection(LineCollection(list(lines), linestyles=style, **look))
