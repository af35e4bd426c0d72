# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.arrays: terrain meshes: their forms and errors, lines with points of their own. What else they promise,
the engine's tests hold.
"""

import copy
import pickle

import numpy as np
import pytest

from vtkflipflop.arrays import (
    AbortedError,
    InputError,
    TerrainMesh,
    constrained_triangulation,
    regular_triangulation,
    terrain_mesh,
)

GRID = np.stack(np.meshgrid(np.arange(40.0), np.arange(30.0), indexing="ij"), -1).reshape(-1, 2)
HEIGHTS = 3 * np.sin(GRID[:, 0] / 5) * np.cos(GRID[:, 1] / 7)
POINTS = np.column_stack([GRID, HEIGHTS])
MANY = np.random.default_rng(3).random((200_000, 3))
LINE = [0, 31, 62, 93, 94, 95]


def test_no_point_is_beyond_the_tolerance():
    mesh = terrain_mesh(POINTS, tolerance=0.2, constraints=[LINE])
    assert type(mesh) is TerrainMesh and 20 < len(mesh) < 400 and mesh.beyond == mesh.unreachable == 0
    assert abs(mesh.errors).max() == mesh.greatest_error <= 0.2 and (mesh.errors[mesh.vertices] == 0).all()
    of_kept = regular_triangulation(POINTS[mesh.vertices], constraints=[np.searchsorted(mesh.vertices, LINE)])
    assert np.array_equal(mesh.vertices[of_kept.simplices], mesh.simplices)
    assert np.array_equal(mesh.vertices[of_kept.fixed_edges], mesh.fixed_edges) and len(mesh.constraint_of) == 5
    surface = of_kept.interpolate(HEIGHTS[mesh.vertices], GRID)
    assert abs(HEIGHTS - surface - mesh.errors).max() < 1e-12
    assert repr(mesh).startswith(f"<TerrainMesh: {len(mesh)} of 1200 points, {len(mesh.simplices)} simplices, ")


def test_all_ways_are_one():
    mesh = terrain_mesh(POINTS, tolerance=0.1, threads=1)
    for other in (
        terrain_mesh(GRID, HEIGHTS, tolerance=0.1, threads=2),
        terrain_mesh(POINTS * [1, 1, 0], HEIGHTS.reshape(-1, 1), tolerance=0.1),
        terrain_mesh(POINTS.tolist(), tolerance=0.1),
        terrain_mesh(POINTS, tolerance=0.1, max_vertices=len(mesh)),
    ):
        for name in ("vertices", "simplices", "errors"):
            assert getattr(other, name).tobytes() == getattr(mesh, name).tobytes()
    fewer = terrain_mesh(POINTS, tolerance=0.1, max_vertices=len(mesh) - 1)
    assert len(fewer) == len(mesh) - 1 and fewer.beyond > 0 and set(fewer.vertices) < set(mesh.vertices)
    assert len(terrain_mesh(POINTS, tolerance=np.inf)) == 4


def test_every_dimension():
    assert terrain_mesh([]).simplices.shape == (0, 0) and terrain_mesh([]).dimension == -1
    assert terrain_mesh(POINTS[:1]).vertices.tolist() == [0]
    chain = terrain_mesh([[0, 0, 0], [4, 4, 0], [1, 1, 5], [2, 2, 0]], tolerance=3)
    assert chain.simplices.tolist() == [[0, 2], [1, 3], [2, 3]] and chain.dimension == 1


# They cross each other, at different heights, and end at points of their own, one of them over a point of the grid.
ROAD = np.array([[0.5, 3.5, 4.0], [12.5, 20.25, 6.0], [20.0, 15.0, 9.0], [38.5, 16.0, 2.0]])
DITCH = np.array([[4.5, 18.5, -2.0], [30.5, 2.5, -3.0]])


@pytest.mark.parametrize("seed", range(8))
def test_lines_with_points_of_their_own(seed):
    random = np.random.default_rng(seed)
    points = np.column_stack([GRID[random.permutation(1200)], random.random(1200)])[: random.integers(3, 1200)]
    points[:, 2] += np.sin(points[:, 0] / 4)
    lines = [ROAD[:, :] + [*random.random(2), 0], {"type": "LineString", "coordinates": DITCH.tolist()}]
    tolerance = 0.4 * random.random()
    mesh = terrain_mesh(points, tolerance=tolerance, lines=lines)
    whole = mesh.joined
    assert whole.points.tobytes() == constrained_triangulation(points, lines).points.tobytes()
    assert len(mesh.errors) == len(whole.points) and mesh.beyond == 0 and abs(mesh.errors).max() <= tolerance
    added = np.flatnonzero(whole.point_origin)
    assert {1, 2} == set(whole.point_origin[added]) and set(added) <= set(mesh.vertices)
    # The triangulation of what is kept, with the lines' pieces as edges.
    kept = whole.points[mesh.vertices]
    pieces = np.searchsorted(mesh.vertices, whole.constraints)
    of_kept = regular_triangulation(kept, constraints=pieces)
    assert np.array_equal(mesh.vertices[of_kept.simplices], mesh.simplices)
    assert np.array_equal(mesh.vertices[of_kept.fixed_edges], mesh.fixed_edges)
    assert set(whole.geometry_of[mesh.constraint_of]) == {0, 1}
    left = whole.points[:, 2] - of_kept.interpolate(kept[:, 2], whole.points[:, :2])
    assert abs(left - mesh.errors).max() < 1e-9, f"seed {seed}"


def test_lines_and_their_heights():
    mesh = terrain_mesh(POINTS, tolerance=0.2, lines=[ROAD, DITCH])
    assert terrain_mesh(POINTS, tolerance=0.2, constraints=[LINE]).joined is None
    over = np.flatnonzero((GRID == ROAD[2, :2]).all(axis=1))[0]
    assert mesh.joined.height_range[over].tolist() == sorted([HEIGHTS[over], 9.0]) and over in mesh.vertices
    other = terrain_mesh(GRID, HEIGHTS, tolerance=0.2, lines=[ROAD, DITCH], threads=2)
    assert other.simplices.tobytes() == mesh.simplices.tobytes() and other.errors.tobytes() == mesh.errors.tobytes()
    # Of polygons the sides alone: nothing is outside.
    square = {"type": "Polygon", "coordinates": [[(9.5, 9.5, 3), (19.5, 9.5, 3), (14.5, 19.5, 3), (9.5, 9.5, 3)]]}
    ring = terrain_mesh(POINTS, tolerance=0.2, lines=square)
    assert len(ring.fixed_edges) >= 3 and ring.joined.dropped == 0
    # A point without a height is left out, and no line ends there.
    bad = POINTS.copy()
    bad[over, 2] = np.nan
    with pytest.raises(InputError, match=f"first at point {over}"):
        terrain_mesh(bad, lines=ROAD)
    left = terrain_mesh(bad, lines=ROAD, non_finite="ignore")
    assert np.isnan(left.errors[over]) and 9.0 in left.joined.points[1200:, 2]
    joined = left.joined
    assert joined.points[:1200].tobytes() == bad.tobytes() and joined.validate() and len(joined.polygons)
    assert over not in joined.vertices and joined.certificate[over] == -1 and joined.areas.sum() > 0
    # Lines without heights take them from the points.
    flat = terrain_mesh(POINTS, tolerance=0.2, lines=DITCH[:, :2])
    assert np.isfinite(flat.joined.points).all() and flat.joined.height_range is None
    for again in (pickle.loads(pickle.dumps(mesh)), copy.deepcopy(mesh)):
        assert again.joined.points.tobytes() == mesh.joined.points.tobytes()
    done = []
    terrain_mesh(MANY, lines=[[0.1, 0.1, 0], [0.9, 0.9, 1]] * np.ones((2, 3)), tolerance=2, progress=done.append,
                 threads=1)
    assert done == sorted(done) and len(done) > 2


def test_points_that_are_left_out():
    bad = POINTS.copy()
    bad[77, 2] = np.nan
    with pytest.raises(InputError, match="first at point 77"):
        terrain_mesh(bad)
    left = terrain_mesh(bad, tolerance=0.1, non_finite="ignore")
    assert left.statistics["non_finite"] == 1 and np.flatnonzero(np.isnan(left.errors)).tolist() == [77]
    masked = np.ma.array(HEIGHTS, mask=np.arange(1200) == 77)
    assert terrain_mesh(GRID, masked, tolerance=0.1).simplices.tobytes() == left.simplices.tobytes()
    with pytest.raises(InputError, match="constraint 1"):
        terrain_mesh(bad, constraints=[[0, 1], [2, 77]], non_finite="ignore")


@pytest.mark.parametrize(
    "call, kind, text",
    [
        (lambda: terrain_mesh(POINTS, tolerance=-1), ValueError, "tolerance is 0 or more, not -1"),
        (lambda: terrain_mesh(POINTS, tolerance=np.nan), ValueError, "tolerance is 0 or more, not nan"),
        (lambda: terrain_mesh(POINTS, tolerance="1"), TypeError, "tolerance is a number"),
        (lambda: terrain_mesh(POINTS, max_vertices=0), ValueError, "max_vertices is 1 or more, or None, not 0"),
        (lambda: terrain_mesh(POINTS, max_vertices=2.5), TypeError, "max_vertices is an integer or None"),
        (lambda: terrain_mesh(GRID), ValueError, "points of two coordinates take heights"),
        (lambda: terrain_mesh(GRID, HEIGHTS[1:]), InputError, "there are 1199 heights for 1200 points"),
        (lambda: terrain_mesh(GRID, POINTS), ValueError, "heights are n numbers, one for each point"),
        (lambda: terrain_mesh(GRID, HEIGHTS * 1j), TypeError, "heights are real numbers"),
        (lambda: terrain_mesh(POINTS, constraints=[[0, 1200]]), InputError, "1200"),
        (lambda: terrain_mesh(POINTS, constraints=[[0, 31], [1, 30]]), InputError, "cross"),
        (lambda: terrain_mesh(POINTS, lines=ROAD, constraints=[LINE]), ValueError, "constraints or lines, not both"),
        (lambda: terrain_mesh(POINTS, lines=[]), InputError, "lines is empty"),
        (lambda: terrain_mesh(POINTS, lines=ROAD * [1, 1, np.inf]), InputError, "lines, vertex 0: .* NaN or infinite"),
        (lambda: terrain_mesh(POINTS, lines=ROAD[:, :2] + [0, 16]), InputError,
         r"leave the points' hull: first at \(12.5"),
        (lambda: terrain_mesh(MANY, progress=lambda done: False), AbortedError, "abort"),
    ],
)
def test_errors(call, kind, text):
    with pytest.raises(kind, match=text):
        call()
