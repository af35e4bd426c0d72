# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The judge of Benchmarks/python_peers.py tells right from wrong."""

import sys
from pathlib import Path

import numpy as np
import pytest
import scipy.spatial

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "Benchmarks"))
import python_peers as peers  # noqa: E402

RANDOM = np.random.default_rng(8)


@pytest.mark.parametrize("family", ["uniform", "clusters", "grid"])
def test_triangulations(family):
    points = peers.SUBJECTS["triangulation"][0][family](RANDOM, 200)
    right = scipy.spatial.Delaunay(points).simplices
    assert peers.judge_triangulation(points, right, None)
    assert peers.judge_triangulation(points, right[:, ::-1], None)
    assert not peers.judge_triangulation(points, right[1:], None)
    assert not peers.judge_triangulation(points, np.vstack([right, right[:1]]), None)
    swapped = points.copy()
    swapped[[0, 150]] = points[[150, 0]]
    assert not peers.judge_triangulation(swapped, right, None)


def test_a_flipped_edge_is_noticed():
    points = np.array([[0, 0], [4, 0], [4, 3], [0, 4]]) / 1024
    assert peers.judge_triangulation(points, np.array([[0, 1, 2], [0, 2, 3]]), None)
    assert not peers.judge_triangulation(points, np.array([[0, 1, 3], [1, 2, 3]]), None)


def test_a_tie_may_go_either_way():
    points = np.array([[0, 0], [1, 0], [1, 1], [0, 1]]) / 1024
    for cells in ([[0, 1, 2], [0, 2, 3]], [[0, 1, 3], [1, 2, 3]]):
        assert peers.judge_triangulation(points, np.array(cells), None)


def test_hulls():
    points = peers.ball(RANDOM, 300)
    hull = scipy.spatial.ConvexHull(points)
    assert peers.judge_hull(points, hull.simplices, hull.vertices)
    assert peers.judge_hull(points, hull.simplices, points[hull.vertices])
    assert not peers.judge_hull(points, hull.simplices[hull.simplices[:, 0] != hull.simplices[0, 0]], points[:3])
    grid = peers.box_grid(RANDOM, 27)
    assert not peers.judge_hull(grid, np.arange(27).reshape(-1, 3), np.arange(27))
