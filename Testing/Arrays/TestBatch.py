# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Many sets in one call give what a call for each gives."""

import numpy as np
import pytest

from vtkflipflop.arrays import InputError, convex_hull, convex_hulls, regular_triangulation, regular_triangulations

RANDOM = np.random.default_rng(5)
SIZES = [*RANDOM.integers(0, 60, 200), 20_000, 0, 1, 3]
OFFSETS = np.concatenate([[0], np.cumsum(SIZES)])
POINTS = RANDOM.random((OFFSETS[-1], 3))
WEIGHTS = RANDOM.random(OFFSETS[-1]) * 0.01


@pytest.mark.parametrize("threads", [1, 3])
def test_hulls(threads):
    batch = convex_hulls(POINTS, OFFSETS, threads=threads)
    assert len(batch) == len(SIZES) and batch.errors == {}
    for i, hull in enumerate(batch):
        alone = convex_hull(POINTS[OFFSETS[i] : OFFSETS[i + 1]])
        assert hull.simplices.tobytes() == alone.simplices.tobytes()
        assert np.array_equal(hull.vertices, alone.vertices)
        assert (hull.volume, hull.area) == (alone.volume, alone.area) == (batch.volumes[i], batch.areas[i])
        assert np.array_equal(hull.points, alone.points)


def test_hulls_in_the_plane():
    batch = convex_hulls(POINTS[:, :2], OFFSETS[:50])
    for i, hull in enumerate(batch):
        alone = convex_hull(POINTS[OFFSETS[i] : OFFSETS[i + 1], :2])
        assert np.array_equal(hull.vertices, alone.vertices)
        assert (alone.volume, alone.area) == (batch.volumes[i], batch.areas[i])


def test_triangulations():
    for weights in (None, WEIGHTS):
        batch = regular_triangulations(POINTS, OFFSETS, weights)
        for i, one in enumerate(batch):
            part = slice(OFFSETS[i], OFFSETS[i + 1])
            alone = regular_triangulation(POINTS[part], None if weights is None else weights[part])
            assert one.simplices.tobytes() == alone.simplices.tobytes()
            assert np.array_equal(one.hidden, alone.hidden)
            assert one.validate()


def test_a_batch_is_a_sequence():
    batch = convex_hulls(POINTS, OFFSETS)
    assert [hull.volume for hull in batch[3:6]] == list(batch.volumes[3:6])
    assert batch[-4].volume == batch.volumes[-4]
    for index in (len(batch), -len(batch) - 1):
        with pytest.raises(IndexError):
            batch[index]
    result = batch[200]
    del batch
    assert result.vertices.max() < 20_000


def test_a_set_at_fault():
    points = POINTS[:90].copy()
    points[35, 1] = points[36, 1] = np.nan
    offsets = np.arange(0, 91, 30)
    message = r"set 1: a coordinate or weight is NaN or infinite: first at point 5, 2 such point\(s\) in all"
    with pytest.raises(InputError, match=message):
        convex_hulls(points, offsets)
    batch = convex_hulls(points, offsets, errors="keep")
    assert list(batch.errors) == [1] and batch.errors[1].index == 5
    assert [hull.dimension for hull in batch] == [3, -1, 3]
    assert convex_hulls(points, offsets, non_finite="ignore").errors == {}


def test_offsets_at_fault():
    for wrong in ([0, 5, 3], [0, 10**6], [-1, 5]):
        with pytest.raises(InputError, match="at index [01]"):
            convex_hulls(POINTS[:20], wrong)
    with pytest.raises(TypeError, match="offsets are integers"):
        convex_hulls(POINTS[:20], [0.0, 5.0])
    with pytest.raises(ValueError, match="one dimension"):
        convex_hulls(POINTS[:20], [[0, 5]])
    with pytest.raises(ValueError, match="'raise', 'keep'"):
        convex_hulls(POINTS[:20], [0, 5], errors="ignore")


@pytest.mark.parametrize("offsets", [[], [0], [5]])
def test_no_set(offsets):
    assert len(convex_hulls(POINTS[:20], offsets)) == 0
    assert len(regular_triangulations(POINTS[:20], offsets)) == 0
