# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.arrays: terrain meshes: their forms and errors. What a mesh promises, the engine's tests hold."""

import numpy as np
import pytest

from vtkflipflop.arrays import AbortedError, InputError, TerrainMesh, regular_triangulation, terrain_mesh

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
        (lambda: terrain_mesh(MANY, progress=lambda done: False), AbortedError, "abort"),
    ],
)
def test_errors(call, kind, text):
    with pytest.raises(kind, match=text):
        call()
