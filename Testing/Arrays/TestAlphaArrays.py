# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.arrays: alpha complexes: their forms and errors."""

import numpy as np
import pytest

from vtkflipflop.arrays import AlphaComplex, InputError, alpha_complex, regular_triangulation

GRID = np.stack(np.meshgrid(np.arange(5), np.arange(4), indexing="ij"), -1).reshape(-1, 2)


def test_disks_of_alpha_0_are_the_nerve_of_their_union():
    # Two disks touch; a third does not quite, and a fourth is far away.
    places = [[0, 0], [2, 0], [1, 1.75], [9, 9]]
    touching = alpha_complex(places, 0, [1, 1, 1, 1])
    assert touching.edges.tolist() == [[0, 1]] and touching.vertices.tolist() == [2, 3]
    apart = alpha_complex(places, 0, [0.5, 0.5, 0.5, 1])
    assert len(apart.edges) == 0 and apart.vertices.tolist() == [0, 1, 2, 3]
    assert apart.vertex_alphas[3] == -1 and alpha_complex(places, -0.9, [0.5, 0.5, 0.5, 1]).vertices.tolist() == [3]
    assert alpha_complex(places, 0, [4, 4, 4, 1]).within.sum() == 1


def test_points_that_are_left_out():
    masked = np.ma.array(GRID, mask=np.repeat(np.arange(20) == 9, 2))
    ours = alpha_complex(masked, 0.75)
    assert not ours.within.all() and 9 not in ours.simplices and 9 not in ours.vertices
    # The circle through the four points around the gap is too large; one of them is on the outer border.
    assert [len(ring) for ring in ours.boundary] == [14, 4]
    bad = np.where(np.arange(20)[:, None] == 9, np.nan, GRID)
    assert np.array_equal(alpha_complex(bad, 0.75, non_finite="ignore").within, ours.within)
    with pytest.raises(InputError, match="first at point 9"):
        alpha_complex(bad, 0.75)


def test_constrained_triangulations_have_them_too():
    ours = regular_triangulation(GRID, polygons=[[0, 16, 19, 3], [5, 6, 10, 9]])
    assert ours.dropped == 2 and (ours.alphas == np.sqrt(0.5)).all()
    complex_ = ours.alpha_complex(0.75)
    assert complex_.within.all() and len(complex_.boundary) == 2
    assert len(ours.alpha_complex(0.5).edges) == 31 and ours.alpha_complex(0.4).vertices.tolist() == list(range(20))


def test_every_dimension():
    line = np.array([[0, 0], [1, 0], [3, 0]])
    segments = regular_triangulation(line)
    assert segments.alphas.tolist() == [0.5, 1]
    for alpha, within, vertices in ((0.5, [True, False], [2]), (1, [True, True], []), (0.4, [False, False], [0, 1, 2])):
        ours = segments.alpha_complex(alpha)
        assert ours.within.tolist() == within and ours.vertices.tolist() == vertices
        assert ours.edges.shape == (0, 2) and ours.boundary.offsets.tolist() == [0]
    assert regular_triangulation(line[:1]).alpha_complex(0).within.tolist() == [True]
    assert regular_triangulation(line[:1]).alpha_complex(-1).within.tolist() == [False]
    none = alpha_complex(line[:0], 1)
    assert none.within.size == none.vertices.size == 0 and none.simplices.shape == (0, 0)


def test_all_ways_are_one():
    points = np.random.default_rng(22).random((600, 2))
    weights = np.arange(600) % 7 * 1e-5
    triangulation = regular_triangulation(points, weights, facets="polygons")
    for alpha in np.sort(triangulation.alphas)[[0, 200, -1]]:
        one, other = alpha_complex(points, alpha, weights, threads=1), triangulation.alpha_complex(alpha)
        assert np.array_equal(one.simplices, triangulation.simplices[triangulation.alphas <= alpha])
        for name in ("within", "simplices", "edges", "edge_alphas", "vertices", "vertex_alphas"):
            assert getattr(other, name).tobytes() == getattr(one, name).tobytes()
    assert np.array_equal(other.boundary.connectivity, triangulation.boundary.connectivity)


def test_errors_and_form():
    for call in (lambda: alpha_complex(GRID, np.nan), lambda: regular_triangulation(GRID).alpha_complex(float("nan"))):
        with pytest.raises(ValueError, match="alpha is a length"):
            call()
    with pytest.raises(InputError, match="not as many weights"):
        alpha_complex(GRID, 1, [1])
    ours = alpha_complex(GRID, 1)
    assert type(ours) is AlphaComplex and repr(ours) == "<AlphaComplex: 24 of 24 simplices, 0 edges, 0 points>"
    with pytest.raises(AttributeError, match="frozen"):
        ours.within = 1
    assert not any(array.flags.writeable for array in (ours.within, ours.simplices, ours.edges, *ours.boundary))
    triangulation = regular_triangulation(GRID)
    assert triangulation.alphas is triangulation.alphas and triangulation.boundary is triangulation.boundary
