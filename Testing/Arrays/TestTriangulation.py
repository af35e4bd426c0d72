# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.arrays.regular_triangulation and power_diagram: what they promise, beside scipy."""

import itertools

import numpy as np
import pytest
import scipy.spatial

from vtkflipflop.arrays import InputError, convex_hull, power_diagram, regular_triangulation, terrain_mesh, validate

RANDOM = np.random.default_rng(4)
GRID = np.stack(np.meshgrid(np.arange(5), np.arange(4), indexing="ij"), -1).reshape(-1, 2)


def areas_of(diagram):
    """By the shoelace formula."""
    found = []
    for corners in diagram.regions:
        x, y = diagram.vertices[corners].T
        found.append(0.5 * np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)))
    return np.array(found)


@pytest.mark.parametrize("count", [3, 4, 50, 5000])
@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_beside_scipy(count, kind):
    points = RANDOM.random((count, 2)).astype(kind)
    ours, other = regular_triangulation(points), scipy.spatial.Delaunay(points)
    assert {frozenset(row) for row in ours.simplices.tolist()} == {frozenset(row) for row in other.simplices.tolist()}
    assert ours.nsimplex == other.nsimplex and ours.npoints == count and ours.ndim == 2
    assert validate(ours)


def test_points_in_space_count_by_x_and_y():
    points = RANDOM.random((200, 3))
    assert np.array_equal(regular_triangulation(points).simplices, regular_triangulation(points[:, :2]).simplices)


def test_hidden_points():
    points, weights = RANDOM.random((500, 2)), RANDOM.random(500) * 0.02
    ours = regular_triangulation(points, weights)
    assert 0 < len(ours.hidden) < 500
    assert np.array_equal(np.sort(np.concatenate([ours.hidden, ours.vertices])), np.arange(500))
    assert np.array_equal(np.unique(ours.simplices), ours.vertices)
    assert validate(ours)


def test_both_forms_of_facets_are_the_same_either_way():
    weights = RANDOM.integers(0, 3, 20) / 8
    for given in ((GRID,), (GRID, weights), (RANDOM.random((100, 2)),), (GRID[:1],), (GRID[:4],), (GRID[:0],)):
        one, other = regular_triangulation(*given), regular_triangulation(*given, facets="polygons")
        assert np.array_equal(one.simplices, other.simplices)
        assert np.array_equal(one.hidden, other.hidden)
        for a, b in zip(one.polygons, other.polygons):
            assert np.array_equal(a, b)


def test_every_dimension():
    line = np.arange(5)[:, None] * [1, 2]
    for points, dimension, shape in ((GRID[:0], -1, (0, 0)), (GRID[:1], 0, (1, 1)), (line, 1, (4, 2)),
                                     (GRID, 2, (24, 3))):
        ours = regular_triangulation(points)
        assert (ours.dimension, ours.simplices.shape) == (dimension, shape)
        assert validate(ours)


@pytest.mark.parametrize("make", [
    lambda points: regular_triangulation(points, RANDOM.random(len(points)) / 9),
    lambda points: regular_triangulation(points, constraints=[[0, 3]] if len(points) > 3 else []),
    lambda points: terrain_mesh(points, RANDOM.random(len(points)), tolerance=0.3),
    convex_hull,
    lambda points: convex_hull(np.column_stack([points, (points**2).sum(axis=1)])),
])  # fmt: skip
def test_edges(make):
    for points in (GRID, RANDOM.random((300, 2)), GRID[:5], GRID[:1], GRID[:0]):
        ours = make(points)
        pairs = {tuple(sorted(pair)) for cell in ours.simplices.tolist() for pair in itertools.combinations(cell, 2)}
        assert ours.edges.shape == (len(pairs), 2) and ours.edges.dtype == np.int64 and not ours.edges.flags.writeable
        assert list(map(tuple, ours.edges.tolist())) == sorted(pairs)


def test_power_diagram():
    points, weights = RANDOM.random((300, 2)), RANDOM.random(300) * 0.01
    diagram, triangulation = power_diagram(points, weights, (0, 1, 0, 1)), regular_triangulation(points, weights)
    assert set(diagram.sites) <= set(triangulation.vertices)
    assert areas_of(diagram) == pytest.approx(diagram.areas, rel=1e-9)
    assert areas_of(diagram).sum() == pytest.approx(1, rel=1e-12)
    assert np.array_equal(triangulation.nearest(diagram.centroids), diagram.sites)


def test_power_diagram_s_box_is_that_of_the_points():
    points = RANDOM.random((50, 2)) * [4, 2] + 7
    diagram = power_diagram(points)
    assert np.array_equal(diagram.vertices.min(axis=0), points.min(axis=0))
    assert np.array_equal(diagram.vertices.max(axis=0), points.max(axis=0))
    assert len(diagram) == 50
    assert len(power_diagram(points[:0])) == 0 and power_diagram(points[:0]).regions == []


def test_weights_at_fault_are_named():
    weights = np.zeros(20)
    with pytest.raises(InputError, match="not as many weights as points: 20 points, 19 weights") as caught:
        regular_triangulation(GRID, weights[1:])
    assert caught.value.code == "weight_count"
    with pytest.raises(InputError, match="not as many weights"):
        regular_triangulation(GRID, [])
    weights[7] = np.inf
    with pytest.raises(InputError, match="first at point 7"):
        regular_triangulation(GRID, weights)
    ignoring = regular_triangulation(GRID, weights, non_finite="ignore")
    assert 7 not in ignoring.vertices and 7 not in ignoring.hidden


def test_long_edges():
    for points, limit, within in (
        ([[0, 0], [3, 0], [0, 4]], 5, [True]),
        ([[0, 0], [3, 0], [0, 4]], np.nextafter(5, 0), [False]),
        ([[0, 0], [3, 0], [4, 0]], 2, [False, True]),
        (GRID[:0], 1, []),
    ):
        for facets in ("triangles", "polygons"):
            found = regular_triangulation(points, facets=facets).within_edge_length(limit, threads=2)
            assert found.dtype == bool and found.tolist() == within


def test_results_are_frozen():
    diagram, triangulation = power_diagram(GRID), regular_triangulation(GRID)
    for result in (diagram, triangulation):
        with pytest.raises(AttributeError):
            result.vertices = 1
    arrays = (diagram.vertices, *diagram.cells, diagram.sites, triangulation.hidden, triangulation.simplices)
    assert not any(array.flags.writeable for array in arrays)
