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
    batch = convex_hulls(POINTS[: OFFSETS[49], :2], OFFSETS[:50])
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
    for wrong, said in (
        ([0, 5, 3], "set 1 is from 5 to 3"),
        ([0, 10**6], "set 0 is from 0 to 1000000"),
        ([-1, 5], "set 0 is from -1 to 5"),
    ):
        for call in (convex_hulls, regular_triangulations):
            with pytest.raises(InputError, match=f"^offsets ascend from 0 to 20, the number of points, but {said}$"):
                call(POINTS[:20], wrong)
    with pytest.raises(TypeError, match="offsets are integers"):
        convex_hulls(POINTS[:20], [0.0, 5.0])
    with pytest.raises(ValueError, match="one dimension"):
        convex_hulls(POINTS[:20], [[0, 5]])
    with pytest.raises(ValueError, match="'raise', 'keep'"):
        convex_hulls(POINTS[:20], [0, 5], errors="ignore")


def test_an_array_for_each_set():
    begins = OFFSETS[:-1]
    sets, weights = [np.split(array, begins[1:]) for array in (POINTS, WEIGHTS)]
    sets[0], weights[0], sets[1] = sets[0].tolist(), weights[0].tolist(), np.asfortranarray(sets[1])
    for keywords in ({}, {"weights": WEIGHTS}):
        whole = regular_triangulations(POINTS, OFFSETS, **keywords)
        apart = regular_triangulations(sets, **{name: weights for name in keywords})
        assert np.array_equal(apart.points, POINTS) and np.array_equal(apart.offsets, OFFSETS)
        assert all(one.simplices.tobytes() == other.simplices.tobytes() for one, other in zip(whole, apart))
    hulls = convex_hulls(tuple(sets))
    assert np.array_equal(hulls.volumes, convex_hulls(POINTS, OFFSETS).volumes) and not hulls.offsets.flags.writeable
    cubes = RANDOM.random((5, 20, 3))
    assert np.array_equal(convex_hulls(cubes).volumes, [convex_hull(cube).volume for cube in cubes])
    assert np.array_equal(regular_triangulations(cubes, weights=cubes[:, :, 0])[4].points, cubes[4])
    flat = convex_hulls([[], [[0, 0], [4, 0], [0, 3.0]], np.float32([[1, 1]])])
    assert (flat.areas.tolist(), flat.points.dtype, flat.points.shape) == ([0, 12, 0], float, (4, 2))
    assert len(convex_hulls([])) == len(regular_triangulations([], weights=[])) == 0
    masked = np.ma.masked_less(cubes, 0.1)
    kept = [cube[~mask.any(axis=1)] for cube, mask in zip(cubes, masked.mask)]
    assert np.array_equal(convex_hulls(list(masked)).volumes, convex_hulls(kept).volumes)


@pytest.mark.parametrize(
    "error, words, sets, keywords",
    [
        (TypeError, "those of all sets in one array take offsets", POINTS, {}),
        (TypeError, "a sequence of arrays, one for each set", iter([POINTS]), {}),
        (ValueError, r"set 0: points are an array of n by 3 or n by 2 .* not of shape \(3,\)", [[1, 2, 3]], {}),
        (InputError, "set 2: points have 2 coordinates, and 3 in set 1", [[], POINTS, POINTS[:, :2]], {}),
        (InputError, "set 1: .* first at point 0, 9 such", 
         [np.ma.masked_less(POINTS[:9], 0.2), POINTS[:9] * np.nan], {}),
        (TypeError, "set 1: coordinates are real numbers", [POINTS, [["a", "b"]]], {}),
        (ValueError, "weights are a sequence of arrays, one for each of 2 sets", [POINTS[:5]] * 2,
         {"weights": WEIGHTS[:10]}),
        (InputError, "set 1: there are not as many weights as points: 5 points, 4", [POINTS[:5]] * 2,
         {"weights": [WEIGHTS[:5], WEIGHTS[:4]]}),
        (InputError, "set 1: .* points: 5 points, and weights are None", [POINTS[:5]] * 2,
         {"weights": [WEIGHTS[:5], None]}),
    ],
)  # fmt: skip
def test_sets_at_fault(error, words, sets, keywords):
    with pytest.raises(error, match=words):
        (regular_triangulations if keywords else convex_hulls)(sets, **keywords)


@pytest.mark.parametrize("offsets", [[], [0]])
def test_no_set(offsets):
    assert len(convex_hulls(POINTS[:0], offsets)) == 0
    assert len(regular_triangulations(POINTS[:0], offsets)) == 0


@pytest.mark.parametrize(
    "offsets, words",
    [
        ([2, 8], r"the first 2 and the last 12 of 20 points are in no set: give points\[2:8\] and offsets - 2$"),
        ([0, 8, 19], r"so the last 1 of 20 points are in no set: give points\[0:19\]$"),
        ([1, 20], r"so the first 1 of 20 points are in no set: give points\[1:20\] and offsets - 1$"),
        ([], "the last 20 of 20 points are in no set"),
        ([0], "the last 20 of 20 points are in no set"),
    ],
)
def test_offsets_that_leave_points_out(offsets, words):
    for call in (convex_hulls, regular_triangulations):
        with pytest.raises(InputError, match=words):
            call(POINTS[:20], offsets)
