# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arguments in every layer: all numbers are taken as they are, and what cannot be taken is named."""

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

from layers import LAYERS, bits, corners, ids
from vtkflipflop.arrays import FlipFlopError, InputError

pytestmark = [
    pytest.mark.filterwarnings("error::RuntimeWarning"),
    pytest.mark.filterwarnings("ignore:the matrix subclass"),
]

POINTS = np.random.default_rng(11).random((60, 3))
WEIGHTS = np.random.default_rng(12).random(60) * 0.02
CORNERS = np.array([[x, y, z] for x in (3, 90) for y in (0, 7) for z in (1, 100)])
OF_POINTS = "convex_hull", "regular_triangulation", "power_diagram"


@pytest.fixture(params=LAYERS)
def layer(request):
    return LAYERS[request.param]


def read_only(array):
    array = array.copy()
    array.flags.writeable = False
    return array


class Gives:
    """What gives an array, as data frames and tensors do."""

    def __init__(self, array):
        self.array = array

    def __array__(self, dtype=None, copy=None):
        return self.array


class NAType:
    """As pandas.NA is, by its name."""

    def __eq__(self, other):
        return self

    def __bool__(self):
        raise TypeError("boolean value of NA is ambiguous")


# The same numbers in other clothes.
FORMS = {
    "big-endian": lambda array: array.astype(array.dtype.newbyteorder(">")),
    "lists": lambda array: array.tolist(),
    "tuples": lambda array: tuple(map(tuple, array.tolist())) if array.ndim > 1 else tuple(array.tolist()),
    "list of arrays": list,
    "objects": lambda array: array.astype(object),
    "fractions": lambda array: np.vectorize(Fraction, otypes=[object])(array),
    "decimals": lambda array: np.vectorize(Decimal, otypes=[object])(array.astype(object)),
    "longdouble": lambda array: array.astype(np.longdouble),
    "read-only": read_only,
    "strided": lambda array: np.repeat(array, 3, axis=0)[1::3],
    "backwards": lambda array: array[::-1].copy()[::-1],
    "by columns": np.asfortranarray,
    "unmasked": np.ma.asarray,
    "matrix": lambda array: np.asmatrix(array).reshape(len(array), -1),
    "gives": Gives,
}


@pytest.mark.parametrize("form", FORMS)
def test_the_same_numbers(layer, form):
    hull = layer.convex_hull(FORMS[form](POINTS))
    assert corners(hull).dtype == np.float64 and bits(hull) == bits(layer.convex_hull(POINTS))
    for name in ("regular_triangulation", "power_diagram"):
        function = getattr(layer, name)
        assert bits(function(FORMS[form](POINTS[:, :2]))) == bits(function(POINTS[:, :2]))
        assert bits(function(POINTS, FORMS[form](WEIGHTS))) == bits(function(POINTS, WEIGHTS))


@pytest.mark.parametrize("kind", "i1 u1 <i2 >i2 <i4 >i4 >u4 <i8 >i8 >u8 <f2 >f2 <f4 >f4 >f8 g".split())
def test_types(layer, kind):
    """None is rounded."""
    assert np.array_equal(corners(layer.convex_hull(CORNERS.astype(kind))), CORNERS)


def test_half_and_booleans_are_exact(layer):
    half = POINTS.astype(np.float16)
    assert bits(layer.convex_hull(half)) == bits(layer.convex_hull(half.astype(np.float32)))
    assert np.array_equal(corners(layer.convex_hull(CORNERS > [8, 0, 8])), CORNERS > [8, 0, 8])
    heavy = WEIGHTS > 0.01
    weighted = [layer.regular_triangulation(POINTS, weights) for weights in (heavy, heavy.astype(float))]
    assert bits(weighted[0]) == bits(weighted[1])


def test_none_and_one(layer):
    for nothing in ([], (), np.empty(0), np.empty((0, 3)), np.empty((0, 2), ">f4"), np.ma.empty((0, 3))):
        assert len(corners(layer.convex_hull(nothing))) == len(corners(layer.regular_triangulation(nothing, []))) == 0
    assert len(corners(layer.convex_hull([[1, 2, 3]]))) == 1
    for one in ([1, 2, 3], np.arange(3.0), (1, 2)):
        with pytest.raises(ValueError, match="points are an array of n by 3 or n by 2 coordinates, not of shape"):
            layer.convex_hull(one)


@pytest.mark.parametrize("name", OF_POINTS)
def test_masked_points_are_left_out(layer, name):
    function = getattr(layer, name)
    masked = np.ma.array(POINTS, mask=np.zeros(POINTS.shape, bool))
    masked[7, 0] = masked[7, 1] = masked[20, 1] = np.ma.masked
    for case in (masked, masked[:, :2], list(masked), masked.astype(">f4"), (masked * 1000).astype(">i4")):
        plain = np.ma.getdata(case if isinstance(case, np.ndarray) else masked)
        kept = np.delete(plain, (7, 20), axis=0)
        assert np.array_equal(corners(function(case)), corners(function(kept)))
    if name != "power_diagram":
        assert set(ids(function(masked))) <= set(np.delete(np.arange(60), (7, 20)))
    if name != "convex_hull":
        absent = np.arange(60) % 25 == 5
        for case in (np.ma.array(WEIGHTS, mask=absent), list(np.ma.array(WEIGHTS, mask=absent))):
            assert np.array_equal(corners(function(POINTS, case)), corners(function(POINTS[~absent], WEIGHTS[~absent])))


def test_what_is_masked_excuses_nothing_else(layer):
    points = np.array([[0, 0], [4, 0], [0, 4], [np.nan, 1]])
    masked = np.ma.array(np.ones(4), mask=[1, 0, 0, 0])
    for given in ((points, masked), (np.ma.array(np.eye(4, 2), mask=np.eye(4, 2)), [0, 0, 0, np.nan])):
        with pytest.raises(InputError, match=r"NaN or infinite: first at point 3, 1 such"):
            layer.regular_triangulation(*given)
        with pytest.raises(InputError, match=r"NaN or infinite: first at point 3, 1 such"):
            layer.terrain_mesh(*given, tolerance=1)


def test_what_is_masked_may_be_anything(layer):
    masked = np.ma.array([[np.nan, 2, 3], [4, np.inf, 6], [0, 0, 0]], mask=[[1, 0, 0], [0, 1, 0], [0, 0, 0]])
    assert ids(layer.convex_hull(masked)).tolist() == [2]
    wide = np.ma.array([[2**53 + 1, 0, 0], [2**53, 0, 0]], mask=[[1, 0, 0], [0, 0, 0]])
    assert corners(layer.convex_hull(wide))[0, 0] == 2**53


@pytest.mark.parametrize(
    "given",
    [
        [[0, 0, 0], [float("nan"), 2.0**60, 0]],
        np.array([[0, 0, 0], [np.nan, 0, 0]], dtype="g"),
        np.ma.array([[0, 0, 0], [np.nan, 0, 0]], mask=[[1, 0, 0], [0, 0, 0]]),
        np.array([[1, 2, 3], [np.inf, 0, 0]], np.float32),
        [[0, 0, 0], [0, None, 0]],
        np.array([[0, 0, 0], [0, NAType(), 0]], object),
    ],
    ids=range(6),
)
def test_what_is_not_finite_is_named(layer, given):
    with pytest.raises(InputError, match=r"NaN or infinite: first at point 1, 1 such point\(s\) in all") as caught:
        layer.convex_hull(given)
    assert (caught.value.code, caught.value.index, caught.value.count) == ("non_finite", 1, 1)
    assert isinstance(caught.value, FlipFlopError) and isinstance(caught.value, ValueError)
    kept = 0 if isinstance(given, np.ma.MaskedArray) else 1
    assert len(corners(layer.convex_hull(given, non_finite="ignore"))) == kept


@pytest.mark.parametrize(
    "wide",
    [
        [[0, 0, 0], [2**53 + 1, 0, 0.5]],  # NumPy makes floats of them, and rounds
        [[0, 0, 0], [2**70 + 1, 0, 0]],
        [[0, 0, 0], [10**400, 0, 0]],
        [[0, 0, 0], [Fraction(1, 3), 0, 0]],
        [[0, 0, 0], [Decimal("0.1"), 0, 0]],
        np.array([[0, 0, 0], ["1", 0, 0]], dtype=object),
        np.array([[0, 0, 0], [1 + np.finfo(np.longdouble).eps, 0, 0]], dtype=np.longdouble),
        np.array([[0, 0, 0], [np.finfo(np.longdouble).max, 0, 0]], dtype=np.longdouble),
        np.ma.array([[2**53 + 1, 0, 0], [2**53 + 1, 0, 0]], mask=[[1, 0, 0], [0, 0, 0]]),
        np.array([[0, 0, 0], [2**53 + 1, 0, 0]]).astype(">i8"),
    ],
    ids=range(10),
)
def test_a_number_that_no_double_holds_is_named(layer, wide):
    message = r"^a coordinate is no number that a double holds, .+: first at point 1, 1 such point\(s\) in all$"
    with pytest.raises(InputError, match=message):
        layer.convex_hull(wide, non_finite="ignore")
    with pytest.raises(InputError, match="^a weight is no number that a double holds"):
        column = wide[:, 0] if isinstance(wide, np.ndarray) else [row[0] for row in wide] + [0.5]
        layer.regular_triangulation(np.zeros((len(column), 3)), column, non_finite="ignore")


def test_wide_integers_that_doubles_hold(layer):
    for wide in ([[2**60, 0, 0.5]], [[2**70, 0, 0]], np.array([[2**63, 0, 0]], np.uint64)):
        assert corners(layer.convex_hull(wide))[0, 0] == wide[0][0]


RECORD = [("x", "f8"), ("y", "f8"), ("z", "f8")]


@pytest.mark.parametrize("kind", [complex, "M8[s]", "m8[s]", "U3", "S3", RECORD, "V8"], ids=str)
def test_what_is_no_real_number(layer, kind):
    with pytest.raises(TypeError, match="^coordinates are real numbers, not of type"):
        layer.regular_triangulation(np.zeros((4, 3), kind))
    with pytest.raises(TypeError, match="^weights are real numbers, not of type"):
        layer.regular_triangulation(POINTS, np.zeros(60, kind))
    if kind == RECORD:
        with pytest.raises(TypeError, match=r"structured_to_unstructured\(\)"):
            layer.convex_hull(np.zeros(5, kind))


@pytest.mark.parametrize("shape", [(), (1,), (4,), (5, 1), (5, 4), (0, 4), (3, 5, 3)], ids=str)
def test_shapes_of_points(layer, shape):
    hint = {(3, 5, 3): r": pass reshape\(-1, 3\) of it, and where sets begin"}.get(shape, "$")
    said = r"^points are an array of n by 3 or n by 2 coordinates, not of shape \(.*\)" + hint
    with pytest.raises(ValueError, match=said):
        layer.convex_hull(np.zeros(shape))
    with pytest.raises(ValueError, match=r"\(2, 5\): if its rows are x and y, pass numpy.column_stack\(\) of them$"):
        layer.regular_triangulation((np.arange(5), np.arange(5.0)))


@pytest.mark.parametrize("shape", [(), (60, 3), (60, 0), (6, 10, 1)], ids=str)
def test_shapes_of_weights(layer, shape):
    with pytest.raises(ValueError, match="^weights are n numbers, one for each point, not an array of shape"):
        layer.regular_triangulation(POINTS, np.zeros(shape))


def test_the_caller_s_arrays_are_left_alone(layer):
    points, weights = np.ma.array(POINTS, mask=POINTS > 0.9), WEIGHTS.astype(">f8")
    before = points.data.tobytes(), points.mask.tobytes(), weights.tobytes()
    layer.regular_triangulation(points, weights, non_finite="ignore")
    assert (points.data.tobytes(), points.mask.tobytes(), weights.tobytes()) == before


CHOICES = {
    "engine": "'automatic', 'cpu', 'cuda'",
    "facets": "'triangles', 'polygons'",
    "non_finite": "'error', 'ignore'",
    "composite_mode": "'each_block', 'all_blocks'",
    "projection_plane_mode": "'xy_plane', 'best_fitting_plane', 'transform'",
}


@pytest.mark.parametrize("name", CHOICES)
def test_an_unknown_choice_lists_the_choices(layer, name):
    is_arrays = layer is LAYERS["arrays"]
    if "_mode" in name and is_arrays:
        pytest.skip("arrays have no such choice")
    function = layer.regular_triangulation if name.startswith("p") else layer.convex_hull
    other = ValueError if is_arrays else TypeError
    for kind, values in ((ValueError, ("poly", "", "Polygons")), (other, (-1, 0, 0.5, None, [0], True))):
        for value in values:
            with pytest.raises(kind, match=f"^{name} is one of {CHOICES[name]}, not ") as raised:
                function(POINTS, **{name: value})
            assert str(raised.value).endswith(repr(value))


@pytest.mark.parametrize("name", [*OF_POINTS, "prescribed_areas", "centroidal_cells"])
def test_threads_and_progress(layer, name):
    function = getattr(layer, name)
    for value in (-1, -(2**31), 2**31, 2**70):
        with pytest.raises(ValueError, match="^threads is 0 .all. or more, not"):
            function(POINTS, threads=value)
    for value in (1.5, "four", None, [1]):
        with pytest.raises(TypeError, match="^threads is an integer, not"):
            function(POINTS, threads=value)
    assert function(POINTS, threads=np.int8(2)) is not None
    for value in ("yes", 2, []):
        with pytest.raises(TypeError, match="^progress is a callable, True or None, not"):
            function(POINTS, progress=value)
    with pytest.raises(TypeError, match="unexpected keyword argument 'facet_mode'"):
        function(POINTS, facet_mode="triangles")
