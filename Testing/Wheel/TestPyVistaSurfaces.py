# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.pyvista.convexify: surfaces, and what is none."""

import numpy as np
import pytest
import pyvista as pv

from pyvista_meshes import cloud, random_points, starlike
from vtkflipflop.pyvista import InputError, convex_hull, convexify


def test_convexify():
    surface = starlike()
    surface.point_data["heat"] = np.arange(surface.n_points)
    expected = convex_hull(surface)
    for kernel in (None, (0.01, 0, 0), [0, 0, 0], np.zeros(3)):
        hull = convexify(surface, kernel)
        assert np.array_equal(hull.points, expected.points)
        assert np.array_equal(hull.faces, expected.faces)
        assert np.array_equal(hull["heat"], hull["vtkOriginalPointIds"])
    assert convexify(pv.Cube().triangulate().clean(), facets="polygons").n_cells == 6
    assert convexify(pv.PolyData()).n_points == 0


CUBE = np.array([[x, y, z] for z in (0.0, 1) for y in (0.0, 1) for x in (0.0, 1)])
SQUARES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]


def squares(cells, points=CUBE):
    return pv.PolyData(points, faces=[number for cell in cells for number in (len(cell), *cell)])


def test_surfaces_of_polygons():
    expected = convex_hull(CUBE)
    strips = squares(SQUARES[:2])
    strips.strips = [10, 4, 0, 5, 1, 7, 3, 6, 2, 4, 0]
    for surface in (squares(SQUARES), squares([cell[::-1] for cell in SQUARES]), strips):
        for kernel in (None, (0.5, 0.25, 0.5)):
            hull = convexify(surface, kernel)
            assert np.array_equal(hull.points, expected.points) and np.array_equal(hull.faces, expected.faces)
    with pytest.raises(InputError, match=r"first at cell 1, 2 such triangle") as error:
        convexify(squares(SQUARES), (0.5, 0.5, 2))
    assert (error.value.code, error.value.index) == ("not_star_shaped", 1)
    with pytest.raises(InputError, match=r"first at cell 2, 2 such triangle") as error:
        convexify(strips, (0.5, -2, 0.5))
    # Concave ends: a box with a ditch along its top.
    profile = [[0, 0], [2, 0], [4, 0], [4, 3], [3, 3], [2, 2], [1, 3], [0, 3]]
    points = np.array([[x, y, z] for y in (0.0, 2) for x, z in profile])
    walls = [[i, i + 8, (i + 1) % 8 + 8, (i + 1) % 8] for i in range(8)]
    ditch = squares([list(range(8)), list(range(15, 7, -1)), *walls], points)
    assert np.array_equal(convexify(ditch).faces, convex_hull(points).faces)
    with pytest.raises(InputError, match='first at cell 0 of the block "open"'):
        convexify(pv.MultiBlock({"closed": ditch, "open": squares(SQUARES[:5])}))


def test_surfaces_that_are_none():
    closed = starlike()
    open_one = pv.PolyData(closed.points, closed.faces[: 4 * 50])
    points = pv.PolyData()
    points.SetPoints(pv.vtk_points(random_points(3)))
    with_vertex = starlike()
    with_vertex.verts = [1, 0]
    for words, surface in {
        "the surface has no polygons: its cells are vertices; convex_hull": cloud(5),
        "the surface has no polygons: its cells are lines": pv.Line(),
        "but cell 0 is a vertex cell": with_vertex,
        "cell 1 is a polygon of 2": pv.PolyData(CUBE, faces=[4, 0, 2, 3, 1, 2, 4, 5]),
        "the surface is not closed: first at cell 0, 4 edge": squares(SQUARES[:5]),
        "a polygon crosses or touches itself: first at cell 3, 1 such": squares([*SQUARES[:3], [2, 7, 6, 3]]),
        "corner is out of range or used twice: first at cell 4, 2 such": squares([*SQUARES[:4], [0, 1, 1, 2],
                                                                                  [0, 1, 9]]),
        "the surface has no cells, but 3 point": points,
        "the surface is not closed: first at triangle": open_one,
    }.items():
        with pytest.raises(InputError, match=words):
            convexify(surface)
