# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.arrays.convex_hull and convexify: names and meanings are scipy's, results are frozen."""

import gc

import numpy as np
import pytest
import scipy.spatial

from vtkflipflop.arrays import InputError, convex_hull, convexify, validate

RANDOM = np.random.default_rng(3)
CUBE = np.array([[x, y, z] for x in (0, 2) for y in (0, 2) for z in (0, 2)], float)


def grid(size, ndim=3):
    return np.stack(np.meshgrid(*ndim * [np.arange(size)], indexing="ij"), -1).reshape(-1, ndim)


@pytest.mark.parametrize("count", [4, 5, 20, 1000])
@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_beside_scipy(count, kind):
    points = RANDOM.random((count, 3)).astype(kind)
    hull, other = convex_hull(points), scipy.spatial.ConvexHull(points)
    assert np.array_equal(hull.vertices, np.sort(other.vertices))
    assert {frozenset(row) for row in hull.simplices.tolist()} == {frozenset(row) for row in other.simplices.tolist()}
    assert hull.volume == pytest.approx(other.volume, rel=1e-12)
    assert hull.area == pytest.approx(other.area, rel=1e-12)
    assert (hull.nsimplex, hull.npoints, hull.ndim) == (other.nsimplex, other.npoints, other.ndim)
    assert np.array_equal(hull.min_bound, other.min_bound) and np.array_equal(hull.max_bound, other.max_bound)
    assert len(hull.edges) == 3 * len(hull.vertices) - 6
    assert validate(hull)


def test_in_the_plane_beside_scipy():
    points = RANDOM.random((500, 2))
    hull, other = convex_hull(points), scipy.spatial.ConvexHull(points)
    assert hull.ndim == 2 and hull.dimension == 2
    # Both are counter-clockwise; ours begins at the lowest id.
    turn = int(np.argmin(other.vertices))
    assert np.array_equal(hull.vertices, np.roll(other.vertices, -turn))
    assert {frozenset(row) for row in hull.simplices.tolist()} == {frozenset(row) for row in other.simplices.tolist()}
    assert hull.volume == pytest.approx(other.volume, rel=1e-12)
    assert hull.area == pytest.approx(other.area, rel=1e-12)
    assert validate(hull)


def test_both_forms_of_facets_are_the_same_either_way():
    for points in (grid(4), RANDOM.random((50, 3)), grid(5, 2), CUBE[:, [0, 1, 1]], CUBE[:1], np.empty((0, 3))):
        one, other = convex_hull(points), convex_hull(points, facets="polygons")
        assert np.array_equal(one.simplices, other.simplices)
        assert np.array_equal(one.vertices, other.vertices)
        assert len(one.polygons) == len(other.polygons)
        for a, b in zip(one.polygons, other.polygons):
            assert np.array_equal(a, b)


@pytest.mark.parametrize(
    ("points", "dimension", "vertices", "shape"),
    [
        (np.empty((0, 3)), -1, [], (0, 0)),
        ([[1, 2, 3]] * 4, 0, [0], (1, 1)),
        ([[0, 0, 0], [1, 1, 1], [3, 3, 3], [2, 2, 2]], 1, [0, 2], (1, 2)),
        ([[0, 0, 5], [4, 0, 5], [4, 4, 5], [0, 4, 5], [1, 1, 5]], 2, [0, 1, 2, 3], (2, 3)),
        (CUBE, 3, list(range(8)), (12, 3)),
    ],
)
def test_every_dimension(points, dimension, vertices, shape):
    hull = convex_hull(points)
    assert hull.dimension == dimension
    assert hull.vertices.tolist() == vertices
    assert hull.simplices.shape == shape
    assert hull.volume == (8 if dimension == 3 else 0)
    assert validate(hull)


def test_points_are_not_copied_where_that_is_not_needed():
    for points in (CUBE, CUBE.astype(np.float32), np.hstack([CUBE, CUBE])[:, :3], np.repeat(CUBE, 2, axis=0)[::2]):
        assert convex_hull(points).points is points or np.shares_memory(convex_hull(points).points, points)
    for points in (np.asfortranarray(CUBE), CUBE.astype(">f8"), CUBE.astype(int)):
        hull = convex_hull(points)
        assert not np.shares_memory(hull.points, points)
        assert hull.vertices.tolist() == list(range(8))


def test_results_are_frozen_and_own_their_memory():
    hull = convex_hull(grid(5))
    for name in ("vertices", "points", "volume", "new"):
        with pytest.raises(AttributeError):
            setattr(hull, name, 1)
    with pytest.raises(AttributeError):
        del hull.points
    arrays = [hull.vertices, hull.simplices, hull.polygons.offsets, hull.polygons.connectivity]
    assert not any(array.flags.writeable for array in arrays)
    copies = [array.copy() for array in arrays]
    del hull
    gc.collect()
    for _ in range(10):
        convex_hull(RANDOM.random((100, 3))).simplices.sum()
    assert all(np.array_equal(array, copy) for array, copy in zip(arrays, copies))


def test_convexify():
    sphere = RANDOM.standard_normal((300, 3))
    sphere /= np.linalg.norm(sphere, axis=1)[:, None]
    surface = convex_hull(sphere)
    dented = sphere * RANDOM.uniform(0.5, 1, 300)[:, None]
    hull = convexify(dented, surface.simplices)
    assert np.array_equal(hull.simplices, convex_hull(dented).simplices)
    assert np.array_equal(hull.simplices, convexify(dented, surface.simplices, (0, 0, 0)).simplices)
    assert np.array_equal(hull.simplices, convexify(dented, surface.simplices[:, ::-1].astype(np.int32)).simplices)


def test_surfaces_that_are_none():
    corners = convex_hull(CUBE).simplices
    for case, code in (
        (corners[1:], "not_closed"),
        (np.where(corners == 3, 99, corners), "bad_triangle"),
        (np.where(corners == 3, -1, corners), "bad_triangle"),
        (np.vstack([corners[:1, ::-1], corners[1:]]), "not_oriented"),
    ):
        with pytest.raises(InputError) as caught:
            convexify(CUBE, case)
        assert caught.value.code == code and caught.value.index >= 0, caught.value
    with pytest.raises(InputError) as caught:
        convexify(CUBE, corners, kernel=(5, 5, 5))
    assert caught.value.code == "not_star_shaped"
    for wrong in (corners.astype(float), "text"):
        with pytest.raises(TypeError):
            convexify(CUBE, wrong)
    for wrong in (corners.ravel(), corners[:, :2]):
        with pytest.raises(ValueError, match="m by 3"):
            convexify(CUBE, wrong)


def test_statistics():
    statistics = convex_hull(RANDOM.random((5000, 3)), threads=1).statistics
    assert statistics["points"] == 5000 and statistics["threads"] == 1
    assert statistics["insertions"] > 0 and statistics["seconds_total"] > 0
