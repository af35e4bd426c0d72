# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arrays through vtkflipflop.pyvista: all numbers are taken as they are, and what cannot be taken is said."""

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import pyvista as pv

from vtkflipflop.pyvista import InputError, convex_hull, convexify, power_diagram, regular_triangulation

pytestmark = [
    pytest.mark.filterwarnings("error::RuntimeWarning"),
    pytest.mark.filterwarnings("ignore:the matrix subclass"),
]

POINTS = np.random.default_rng(11).random((60, 3))
WEIGHTS = np.random.default_rng(12).random(60) * 0.02
CORNERS = np.array([[x, y, z] for x in (3, 90) for y in (0, 7) for z in (1, 100)])


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


# The same numbers in other clothes.
FORMS = {
    "big-endian": lambda array: array.astype(array.dtype.newbyteorder(">")),
    "little-endian": lambda array: array.astype(array.dtype.newbyteorder("<")),
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
    "of PyVista": lambda array: pv.pyvista_ndarray(array.copy()),
}


@pytest.mark.parametrize("form", FORMS)
def test_the_same_points(form):
    expected, hull = convex_hull(POINTS), convex_hull(FORMS[form](POINTS))
    assert hull.points.dtype == np.float64
    assert hull.points.tobytes() == expected.points.tobytes()
    assert np.array_equal(hull.faces, expected.faces)
    flat, also_flat = regular_triangulation(POINTS[:, :2]), regular_triangulation(FORMS[form](POINTS[:, :2]))
    assert also_flat.points.tobytes() == flat.points.tobytes()


@pytest.mark.parametrize("form", FORMS)
def test_the_same_weights(form):
    expected, hidden = regular_triangulation(POINTS, WEIGHTS, return_hidden_points=True)
    assert hidden.n_points > 0
    triangulation = regular_triangulation(POINTS, FORMS[form](WEIGHTS))
    assert triangulation.points.tobytes() == expected.points.tobytes()
    assert np.array_equal(triangulation.faces, expected.faces)
    cells = power_diagram(POINTS, FORMS[form](WEIGHTS))
    assert cells.points.tobytes() == power_diagram(POINTS, WEIGHTS).points.tobytes()


@pytest.mark.parametrize(
    "kind", "i1 u1 <i2 >i2 <i4 >i4 >u4 <i8 >i8 >u8 <f2 >f2 <f4 >f4 >f8 g".split()
)
def test_types(kind):
    """None is rounded; VTK has all but half, longdouble and bool."""
    hull = convex_hull(CORNERS.astype(kind))
    stored = {"<f2": np.float32, ">f2": np.float32, "g": np.float64}.get(kind, np.dtype(kind).newbyteorder("="))
    assert hull.points.dtype == stored
    assert np.array_equal(hull.points, CORNERS)


def test_half_is_exact():
    points = POINTS.astype(np.float16)
    assert convex_hull(points).points.tobytes() == convex_hull(points.astype(np.float32)).points.tobytes()


def test_booleans_are_zero_and_one():
    corners = CORNERS > 8
    corners[:, 1] = CORNERS[:, 1] > 0
    assert np.array_equal(convex_hull(corners).points, corners.astype(int))
    shown = regular_triangulation(POINTS, WEIGHTS > 0.01)
    assert np.array_equal(shown.faces, regular_triangulation(POINTS, (WEIGHTS > 0.01).astype(float)).faces)


def test_none_and_one():
    for nothing in ([], (), np.empty(0), np.empty((0, 3)), np.empty((0, 2), ">f4"), np.ma.empty((0, 3))):
        assert convex_hull(nothing).n_points == 0
        assert regular_triangulation(nothing, []).n_points == 0
    assert convex_hull([[1, 2, 3]]).n_points == 1
    with pytest.raises(ValueError, match="n by 3 or n by 2 coordinates"):
        convex_hull([1, 2, 3])


@pytest.mark.parametrize("function", [convex_hull, regular_triangulation, power_diagram])
def test_masked_points_are_left_out(function):
    masked = np.ma.array(POINTS, mask=np.zeros(POINTS.shape, bool))
    masked[7, 0] = masked[7, 1] = masked[20, 1] = np.ma.masked
    for case in (masked, masked[:, :2], list(masked), masked.astype(">f4"), (masked * 1000).astype(">i4")):
        plain = np.ma.getdata(case if isinstance(case, np.ndarray) else masked)
        kept = np.delete(plain, (7, 20), axis=0)
        assert np.array_equal(function(case).points, function(kept).points)


def test_ids_are_those_of_the_masked_array():
    masked = np.ma.array(POINTS, mask=np.zeros(POINTS.shape, bool))
    masked[7] = np.ma.masked
    ids = regular_triangulation(masked).point_data["vtkOriginalPointIds"]
    assert np.array_equal(ids, np.delete(np.arange(60), 7))


def test_masked_weights_leave_their_points_out():
    masked = np.ma.array(WEIGHTS, mask=np.arange(60) % 25 == 5)
    integers = np.ma.array(np.arange(60), mask=masked.mask)
    for case in (masked, list(masked), integers):
        values = np.ma.compressed(masked if case is not integers else integers)
        shown = regular_triangulation(POINTS, case)
        assert np.array_equal(shown.points, regular_triangulation(POINTS[~masked.mask], values).points)


def test_what_is_masked_may_be_anything():
    masked = np.ma.array([[np.nan, 2, 3], [4, np.inf, 6], [0, 0, 0]], mask=[[1, 0, 0], [0, 1, 0], [0, 0, 0]])
    assert convex_hull(masked).n_points == 1
    wide = np.ma.array([[2**53 + 1, 0, 0], [2**53, 0, 0]], mask=[[1, 0, 0], [0, 0, 0]])
    assert convex_hull(wide).points[0, 0] == 2**53
    with pytest.raises(InputError, match="NaN or infinite: first at point 1, 1 such"):
        convex_hull(np.ma.array([[0, 0, 0], [np.nan, 0, 0]], mask=[[1, 0, 0], [0, 0, 0]]))


@pytest.mark.parametrize(
    "wide",
    [
        [[0, 0, 0], [2**53 + 1, 0, 0.5]],  # NumPy makes floats of them, and rounds
        [[0, 0, 0], [2**70 + 1, 0, 0]],
        [[0, 0, 0], [10**400, 0, 0]],
        [[0, 0, 0], [Fraction(1, 3), 0, 0]],
        [[0, 0, 0], [Decimal("0.1"), 0, 0]],
        [[0, 0, 0], [None, 0, 0]],
        np.array([[0, 0, 0], ["1", 0, 0]], dtype=object),
        np.array([[0, 0, 0], [1 + np.finfo(np.longdouble).eps, 0, 0]], dtype=np.longdouble),
        np.array([[0, 0, 0], [np.finfo(np.longdouble).max, 0, 0]], dtype=np.longdouble),
        np.ma.array([[2**53 + 1, 0, 0], [2**53 + 1, 0, 0]], mask=[[1, 0, 0], [0, 0, 0]]),
    ],
    ids=range(10),
)
def test_a_number_that_no_double_holds_is_named(wide):
    message = r"^a coordinate is no number that a double holds, .+: first at point 1, 1 such point\(s\) in all$"
    with pytest.raises(InputError, match=message):
        convex_hull(wide, non_finite="ignore")
    with pytest.raises(InputError, match="^a weight is no number that a double holds"):
        column = wide[:, 0] if isinstance(wide, np.ndarray) else [row[0] for row in wide] + [0.5]
        regular_triangulation(np.zeros((len(column), 3)), column, non_finite="ignore")


def test_wide_integers_that_doubles_hold():
    for wide in ([[2**60, 0, 0.5]], [[2**70, 0, 0]], np.array([[2**63, 0, 0]], np.uint64)):
        assert convex_hull(wide).points[0, 0] == wide[0][0]
    with pytest.raises(InputError, match="no number that a double holds, 9007199254740993: first at point 0"):
        convex_hull(np.array([[2**53 + 1, 0, 0]]).astype(">i8"))


def test_not_finite_keeps_its_own_words():
    for case in ([[0, 0, 0], [float("nan"), 2.0**60, 0]], np.array([[0, 0, 0], [np.nan, 0, 0]], dtype="g")):
        with pytest.raises(InputError, match="NaN or infinite: first at point 1, 1 such"):
            convex_hull(case)


@pytest.mark.parametrize(
    "kind", [complex, "M8[s]", "m8[s]", "U3", "S3", [("x", "f8"), ("y", "f8"), ("z", "f8")], "V8"], ids=str
)
def test_what_is_no_real_number(kind):
    for function in (convex_hull, regular_triangulation):
        with pytest.raises(TypeError, match="^coordinates are real numbers, not of type"):
            function(np.zeros((4, 3), kind))
    with pytest.raises(TypeError, match="^weights are real numbers, not of type"):
        regular_triangulation(POINTS, np.zeros(60, kind))


def test_records_are_told_the_way_out():
    with pytest.raises(TypeError, match=r"structured_to_unstructured\(\)"):
        convex_hull(np.zeros(5, [("x", "f8"), ("y", "f8"), ("z", "f8")]))


@pytest.mark.parametrize("shape", [(), (1,), (2,), (4,), (5, 1), (5, 4), (0, 4), (3, 5, 3), (4, 4, 2)], ids=str)
def test_shapes_of_points(shape):
    with pytest.raises(ValueError, match="^points are an array of n by 3 or n by 2 coordinates, not of shape"):
        convex_hull(np.zeros(shape))


@pytest.mark.parametrize("shape", [(), (60, 3), (60, 0), (6, 10, 1)], ids=str)
def test_shapes_of_weights(shape):
    with pytest.raises(ValueError, match="^weights are n numbers, one for each point, not an array of shape"):
        regular_triangulation(POINTS, np.zeros(shape))


def test_other_things():
    with pytest.raises(ValueError, match="^coordinates cannot be told from these lists"):
        convex_hull([[1, 2, 3], [1, 2]])
    for thing in ("text", b"bytes", 3, {"x": 1}, (row for row in POINTS), object(), None):
        with pytest.raises(TypeError, match=f"^{type(thing).__name__} has no points to take"):
            convex_hull(thing)
    for thing in (b"bytes", 3.0, {"x": 1}, (weight for weight in WEIGHTS)):
        message = f"^weights are an array or a list of numbers, not of type {type(thing).__name__}"
        with pytest.raises(TypeError, match=message):
            regular_triangulation(POINTS, thing)
    with pytest.raises(TypeError, match="^ndarray is no surface"):
        convexify(POINTS)


def test_vtk_s_points_and_arrays():
    points = pv.PolyData(POINTS).GetPoints()
    for thing in (points, points.GetData()):
        assert convex_hull(thing).points.tobytes() == convex_hull(POINTS).points.tobytes()


def test_data_of_another_vtk():
    names = {"IsA": lambda self, name: True, "GetDataObjectType": lambda self: 0, "__module__": "fork.data"}
    with pytest.raises(TypeError, match="^PolyData is of another VTK, the module fork.data"):
        convex_hull(type("PolyData", (), names)())


def test_the_caller_s_arrays_are_left_alone():
    points, weights = np.ma.array(POINTS, mask=POINTS > 0.9), WEIGHTS.astype(">f8")
    before = points.data.tobytes(), points.mask.tobytes(), weights.tobytes()
    regular_triangulation(points, weights, non_finite="ignore")
    assert (points.data.tobytes(), points.mask.tobytes(), weights.tobytes()) == before


class Polygon:
    """As shapely's."""

    __geo_interface__ = {"type": "Polygon"}


def test_geometries_are_told_the_way_out():
    with pytest.raises(TypeError, match=r"points are an array of numbers, not a Polygon: pass shapely.get_coordinates\(\)"):
        convex_hull(Polygon())


def test_a_masked_transform():
    matrix = np.ma.array(np.eye(4), mask=np.eye(4))
    with pytest.raises(InputError, match=r"^transform: entry \[0, 0\] is masked"):
        regular_triangulation(POINTS, transform=matrix, projection_plane_mode="transform")
