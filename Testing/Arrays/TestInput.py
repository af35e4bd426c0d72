# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every array argument: what a mask does, what a geometry is told, and that each error names argument and value."""

import itertools

import numpy as np
import pytest

from vtkflipflop.arrays import (
    InputError,
    alpha_complex,
    centroidal_cells,
    convex_hull,
    convex_hulls,
    convexify,
    power_diagram,
    prescribed_areas,
    regular_triangulation,
    regular_triangulations,
    split_crossings,
    validate,
)

CUBE = np.array(list(itertools.product((0.0, 2.0), repeat=3)))
SQUARE = CUBE[:4, 1:]
SURFACE = convex_hull(CUBE).simplices
FLAT = regular_triangulation(SQUARE)

# Each array argument that is no points: its name in messages, a call with it, and what may be given.
ARGUMENTS = {
    "the numbers of domain": (lambda given: power_diagram(SQUARE, domain=given), [0.0, 1, 0, 1]),
    "the numbers of box": (lambda given: power_diagram(SQUARE, box=given), [[0.0, 0], [1, 1]]),
    "the numbers of domain, a method's": (lambda given: FLAT.power_diagram(given), [[0.0, 0], [3, 0], [0, 3]]),
    "the numbers of domain, of centroidal cells": (lambda given: centroidal_cells(SQUARE, None, given), [0.0, 1, 0, 1]),
    "the numbers of domain, of prescribed areas": (lambda given: prescribed_areas(SQUARE, None, given), [0.0, 1, 0, 1]),
    "areas": (lambda given: prescribed_areas(SQUARE, given), [1.0, 1, 1, 1]),
    "the numbers of kernel": (lambda given: convexify(CUBE, SURFACE, given), [1.0, 1, 1]),
    "triangles": (lambda given: convexify(CUBE, given), SURFACE),
    "offsets": (lambda given: convex_hulls(CUBE, given), [0, 4, 8]),
    "offsets, of triangulations": (lambda given: regular_triangulations(SQUARE, given), [0, 4]),
    "the ids of constraints": (lambda given: regular_triangulation(SQUARE, constraints=given), [[0, 3], [0, 1]]),
    "the ids of polygons": (lambda given: regular_triangulation(SQUARE, polygons=given), [[0, 1, 3]]),
    "the ids of constraints, to split": (lambda given: split_crossings(SQUARE, given), [[0, 3], [1, 2]]),
    # Points that cannot be left out.
    "points": (lambda given: convexify(given, SURFACE), CUBE),
    "points, of centroidal cells": (lambda given: centroidal_cells(given), SQUARE),
    "points, of prescribed areas": (lambda given: prescribed_areas(given), SQUARE),
    "weights, of centroidal cells": (lambda given: centroidal_cells(SQUARE, given), [0.0, 0, 0, 0]),
}


@pytest.mark.parametrize("name", ARGUMENTS)
def test_a_masked_entry_is_named(name):
    call, given = ARGUMENTS[name]
    given = np.asarray(given)
    call(np.ma.array(given, mask=False))
    mask = np.zeros(given.shape, bool)
    place = tuple(size - 1 for size in given.shape)
    mask[place] = True
    with pytest.raises(InputError) as caught:
        call(np.ma.array(given, mask=mask))
    sentence = f"{name.split(',')[0]}: entry {list(place)} is masked, 1 in all, and none may be here"
    assert str(caught.value) == sentence
    assert (caught.value.code, caught.value.index, caught.value.count) == ("masked", place[0], 1)


@pytest.mark.parametrize("chains",
                         [[np.ma.array([0, 3], mask=[0, 1])], [np.ma.array([0, 3]), np.ma.array([0, 1], mask=[0, 1])]])
def test_masked_ids_in_lists(chains):
    with pytest.raises(InputError, match=rf"the ids of constraints\[{len(chains) - 1}\]: entry \[1\] is masked"):
        regular_triangulation(SQUARE, constraints=chains)


@pytest.mark.parametrize("method", ["linear", "natural"])
def test_a_masked_value_is_nan_where_it_enters(method):
    points = np.random.default_rng(1).random((200, 2))
    values = points @ [2.0, 3.0]
    masked = np.ma.array(np.where(np.arange(200) % 20 == 3, -9999, values), mask=np.arange(200) % 20 == 3)
    places = np.random.default_rng(2).uniform(0.2, 0.8, (500, 2))
    triangulation = regular_triangulation(points)
    shares = triangulation.interpolate(np.eye(200), places, method)
    enters = (shares[:, masked.mask] != 0).any(axis=1)
    assert 0 < enters.sum() < 500
    for case in (masked, list(masked.reshape(-1, 1)), np.ma.array(masked, dtype=object), masked.astype(np.float32)):
        found = triangulation.interpolate(case, places, method).reshape(-1)
        assert np.array_equal(np.isnan(found), enters)
        assert np.allclose(found[~enters], (places @ [2.0, 3.0])[~enters], rtol=1e-6)
    rows = np.ma.array(np.column_stack([values, masked]), mask=np.column_stack([~masked.mask & False, masked.mask]))
    found = triangulation.interpolate(rows, places, method)
    assert not np.isnan(found[:, 0]).any() and np.array_equal(np.isnan(found[:, 1]), enters)
    assert values[3] == (points @ [2.0, 3.0])[3] and masked.data[3] == -9999


def test_masked_points_and_queries_are_left_out():
    """As points that are not finite are, on request."""
    points = np.ma.array(np.vstack([SQUARE, [[-9999, 1]]]), mask=[[0, 0]] * 4 + [[1, 0]])
    queries = np.ma.array([[1.0, 0.5], [-9999, 1]], mask=[[0, 0], [1, 0]])
    assert convex_hull(points).volume == 4 and len(alpha_complex(points, 9.0).simplices) == 2
    assert convex_hulls(points, [0, 5]).volumes.tolist() == [4]
    assert power_diagram(points).sites.tolist() == [0, 1, 2, 3]
    assert len(regular_triangulation(np.vstack([SQUARE, [[1, 1]]]),
                                     np.ma.array(np.zeros(5), mask=[0, 0, 0, 0, 1])).vertices) == 4
    hull = convex_hull(SQUARE)
    assert (hull.contains(queries) > 0).tolist() == [True, False]
    assert np.isnan(hull.distance(queries)).tolist() == [False, True]
    assert hull.support(queries)[1] == FLAT.locate(queries)[1] == FLAT.nearest(queries)[1] == -1
    assert np.isnan(FLAT.interpolate([1.0, 2, 3, 4], queries)).tolist() == [False, True]


class Polygon:
    __geo_interface__ = {"type": "Polygon"}


class GeoSeries:
    """As GeoPandas's: it gives an array of objects."""

    def __array__(self, dtype=None, copy=None):
        return np.array([Polygon(), Polygon()], object)

    def __len__(self):
        return 2

    def get_coordinates(self):
        return SQUARE


ALL = {
    **ARGUMENTS,
    "coordinates": (convex_hull, None),
    "coordinates, of a triangulation": (regular_triangulation, None),
    "coordinates, of queries": (FLAT.locate, None),
    "weights": (lambda given: regular_triangulation(SQUARE, given), None),
    "values": (lambda given: FLAT.interpolate(given, SQUARE), None),
}


@pytest.mark.parametrize("name", ALL)
def test_geometries_are_told_the_way_out(name):
    for given, way_out in (
        (Polygon(), r"not a Polygon: pass shapely.get_coordinates\(\) of it"),
        ([Polygon(), Polygon()], r"shapely.get_coordinates\(\)"),
        (GeoSeries(), r"not a GeoSeries: pass .get_coordinates\(\) of it"),
    ):
        if type(given) is Polygon and ("domain" in name or "box" in name):
            way_out = "takes a polygon without holes, not a Polygon of 0 rings"
        with pytest.raises(TypeError, match=way_out):
            ALL[name][0](given)


@pytest.mark.parametrize("name", ALL)
@pytest.mark.parametrize("given", [3, "text", {"x": 1}, np.zeros((4, 2), complex), np.zeros((4, 2), "M8[s]")],
                         ids=range(5))
def test_what_is_no_array_of_numbers(name, given):
    argument = name.split(",")[0].split(" of ")[-1]
    argument = {"points": "coordinates"}.get(argument, argument)
    with pytest.raises(TypeError, match=f"{argument} (are|is) "):
        ALL[name][0](given)


# Domains ----------------------------------------------------------------------------------------------------------

RING = [(0, 0), (3, 0), (4, 2), (1, 4)]


@pytest.fixture(params=["power_diagram", "method", "centroidal_cells", "prescribed_areas"])
def areas_in(request):
    """The areas of cells in a domain, by every function that takes one."""
    sites = SQUARE + [0.5, 0.25]
    triangulation = regular_triangulation(sites)
    return {
        "power_diagram": lambda domain: power_diagram(sites, domain=domain).areas,
        "method": lambda domain: triangulation.power_diagram(domain).areas,
        "centroidal_cells": lambda domain: centroidal_cells(sites, None, domain, iterations=1).areas,
        "prescribed_areas": lambda domain: prescribed_areas(sites, None, domain).areas,
    }[request.param]


class BoundingBox(tuple):
    """As rasterio's."""

    left, bottom, right, top = 0.0, -1.0, 3.0, 2.0


def test_forms_of_a_box(areas_in):
    expected = areas_in((0, 3, -1, 2))
    for form in ([0, 3, -1, 2], np.array([0, 3, -1, 2], np.float32), ((0, -1), (3, 2)), np.array([[0, -1], [3, 2]])):
        assert np.array_equal(areas_in(form), expected)
    assert np.array_equal(areas_in(BoundingBox((0.0, -1.0, 3.0, 2.0))), expected)


def test_forms_of_a_polygon(areas_in):
    expected = areas_in(RING)
    assert np.array_equal(areas_in([*RING, RING[0]]), expected)
    geometry = {"type": "Polygon", "coordinates": [[(x, y, 7) for x, y in RING]]}
    for form in ([RING[0], *RING, RING[3], RING[0]], geometry):
        assert np.array_equal(areas_in(form), expected)
    for turned in (RING[::-1], [*RING[::-1], RING[-1]], np.array(RING, ">i4")[::-1]):
        assert np.allclose(areas_in(turned), expected, rtol=1e-12)
    for kind, found in (("Polygon", "Polygon of 2 rings"), ("MultiPolygon", "MultiPolygon")):
        with pytest.raises(TypeError, match=f"^domain takes a polygon without holes, not a {found}$"):
            areas_in({"type": kind, "coordinates": [RING, RING]})
    with pytest.raises(ValueError, match="not 4 rows of which no three in turn differ"):
        areas_in([RING[0], RING[1], RING[1], RING[0]])


@pytest.mark.parametrize("size", [1e-300, 1e-160, 1.0, 1e150])
def test_a_clockwise_polygon_of_any_size(size):
    ring, sites = np.array(RING) * size, np.array([[1, 1], [2, 1]]) * size
    one, other = power_diagram(sites, domain=ring), power_diagram(sites, domain=ring[::-1])
    assert sorted(map(tuple, one.vertices)) == sorted(map(tuple, other.vertices))


@pytest.mark.parametrize(
    ("box", "said"),
    [
        ((1, 0, 0, 2), "from x = 1.0 to 0.0 and y = 0.0 to 2.0"),
        ((0, 0, 1, 1), "from x = 0.0 to 0.0 and y = 1.0 to 1.0"),
        (((1, 1), (0, 0)), "from x = 1.0 to 0.0 and y = 1.0 to 0.0"),
        ((0, np.nan, 0, 1), "from x = 0.0 to nan and y = 0.0 to 1.0"),
        ((0, np.inf, 0, 1), "from x = 0.0 to inf"),
    ],
)
def test_boxes_without_an_inside(areas_in, box, said):
    order = r"a box is \(x0, x1, y0, y1\) or two corners \(\(x0, y0\), \(x1, y1\)\), with x0 < x1 and y0 < y1$"
    with pytest.raises(InputError, match=f"^domain: the box {said}.*has no inside or is not finite; {order}") as caught:
        areas_in(box)
    assert caught.value.code == "bad_argument"


@pytest.mark.parametrize("shape", [(3,), (1, 2), (4, 1), (2, 3), (2, 2, 2), (0,)], ids=str)
def test_shapes_of_domains(areas_in, shape):
    with pytest.raises(ValueError, match=r"^domain: a box is .*; a polygon is three rows .*shape \("):
        areas_in(np.ones(shape))


def test_a_polygon_that_is_not_convex_names_the_caller_s_corner(areas_in):
    dented = [(0, 0), (4, 0), (4, 4), (1, 2.5), (0, 4)]
    for ring in (dented, dented[::-1], [*dented[::-1], dented[-1]], [dented[0], *dented]):
        with pytest.raises(InputError,
                           match=r"no convex polygon with finite corners: at corner \d, \(1.0, 2.5\)$") as caught:
            areas_in(ring)
        assert caught.value.code == "not_convex" and ring[caught.value.index] == (1, 2.5)
    with pytest.raises(InputError, match=r"at corner 1, \(nan, 0.0\)"):
        areas_in([(0, 0), (np.nan, 0), (4, 4)])


def test_box_is_another_name_of_domain():
    assert np.array_equal(power_diagram(SQUARE, box=RING).areas, power_diagram(SQUARE, None, RING).areas)
    assert np.array_equal(FLAT.power_diagram(box=RING).areas, FLAT.power_diagram(RING).areas)
    for call in (lambda **given: power_diagram(SQUARE, **given), FLAT.power_diagram):
        with pytest.raises(InputError, match="^box: the box from"):
            call(box=(0, 0, 1, 1))
        with pytest.raises(TypeError, match="domain and box"):
            call(domain=RING, box=RING)


def test_bounds_are_in_the_order_of_shapely():
    sites = SQUARE + [0.5, 0.25]
    for call in (power_diagram, centroidal_cells, prescribed_areas):
        expected = call(sites, None, (0, 3, -1, 2))
        assert np.array_equal(call(sites, bounds=(0, -1, 3, 2)).areas, expected.areas)
        with pytest.raises(TypeError, match="at a domain or at bounds: give one"):
            call(sites, domain=RING, bounds=(0, 0, 1, 1))
        with pytest.raises(InputError, match=r"^bounds: .* from x = 0.0 to -1.0 .*; bounds are \(x0, y0, x1, y1\)"):
            call(sites, bounds=(0, 3, -1, 2))
        with pytest.raises(ValueError, match=r"^bounds are \(x0, y0, x1, y1\), .* of shape \(2, 2\)"):
            call(sites, bounds=((0, 0), (1, 1)))


# Numbers ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("call", "kind", "said"),
    [
        (lambda: convexify(CUBE, SURFACE, (1, np.nan, 1)), ValueError,
         r"kernel is 3 finite numbers, not \(1, nan, 1\)"),
        (lambda: convexify(CUBE, SURFACE, (1, 1)), ValueError, r"kernel is 3 finite numbers, not \(1, 1\)"),
        (lambda: convexify(SQUARE, [[0, 1, 2]]), ValueError, r"points of a surface are n by 3 .* shape \(4, 2\)"),
        (lambda: FLAT.alpha_complex(np.nan), ValueError, "alpha is a length.*not nan"),
        (lambda: FLAT.alpha_complex("0.5"), TypeError, "alpha is a number, not '0.5'"),
        (lambda: alpha_complex(SQUARE, [0.5]), TypeError, r"alpha is a number, not \[0.5\]"),
        (lambda: FLAT.within_edge_length(np.nan), ValueError, "limit is a length of 0 or more, not nan"),
        (lambda: FLAT.within_edge_length("1"), TypeError, "limit is a number, not '1'"),
        (lambda: prescribed_areas(SQUARE, tolerance="1"), TypeError, "tolerance is a number, not '1'"),
        (lambda: prescribed_areas(SQUARE, tolerance=-1), ValueError, "tolerance is 0 or more, not -1"),
        (lambda: centroidal_cells(SQUARE, iterations=1.5), TypeError, "iterations is an integer, not 1.5"),
        (lambda: prescribed_areas(SQUARE, [1, 2, 3]), ValueError, "there are 3 areas for 4 points"),
        (lambda: prescribed_areas(SQUARE, np.ones((4, 2))), ValueError, r"areas are n numbers.*shape \(4, 2\)"),
        (lambda: validate(SQUARE), TypeError, r"result is what convex_hull\(\) or .* gives, not ndarray"),
        (lambda: regular_triangulation(SQUARE, []), ValueError, "not as many weights as points: .*0 weights"),
        (lambda: FLAT.interpolate([1, 2, 3, 4], SQUARE, []), TypeError,
         r"method is one of 'linear', 'natural', 'clough-tocher', 'laplace', not \[\]"),
        (lambda: FLAT.interpolate([1, 2, 3], SQUARE), ValueError, r"values are 4 numbers or rows.*shape \(3,\)"),
        (lambda: FLAT.interpolate([1, 2, 3, 10**400], SQUARE), TypeError,
         "values are real numbers that a double holds"),
    ],
    ids=range(18),
)
def test_numbers_at_fault(call, kind, said):
    with pytest.raises(kind, match=said):
        call()
